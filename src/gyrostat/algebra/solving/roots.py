"""All real roots of a polynomial in an interval, exact: by factors over ℚ, formulas, norms and balls.

They are rational numbers, quadratic surds, or roots of a named polynomial.
"""
import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cmp_to_key

from flint import arb, fmpq_mpoly, fmpq_poly
from sympy import Add, Expr, Mul, Poly, Pow, Rational, S, Symbol, floor, minimal_polynomial, oo, sqrt

from ...errors import ScopeError, brief
from ..enclosures.algebraic import is_algebraic
from ..enclosures.balls import ball, ends, finite_ball
from ..enclosures.rationals import to_sympy
from ..reals.exact import proved_sign
from ..reals.number_fields import in_one
from ..rings.enclosed_roots import roots_by_enclosures
from ..rings.polynomials import Ring, by_degree
from .root_numbers import roots_of

FEW = 3                                                # numbers of which a norm is soon taken


def real_roots(expression: Expr, x: Symbol, low: Expr | None = None,
               high: Expr | None = None) -> list[Expr] | None:
    """Return the distinct real roots of a rational function of x between low and high, in order.

    They lie strictly between these, and the list is complete: the numerator is factored over ℚ and the real
    roots of each factor are counted. Algebraic coefficients are eliminated by resultants with their minimal
    polynomials, and of the roots of that norm those of the polynomial are kept. With transcendental
    coefficients, or algebraic ones that depend on each other, factors of degree 1 and 2 are solved by
    formula, and the roots of the others are isolated by balls.

    Parameters
    ----------
    expression : Expr
        rational in x, with coefficients that are exact numbers
    x : Symbol
    low, high : Expr or None
        exact numbers; default: unbounded

    Returns
    -------
    list of Expr
        exact numbers; None if the expression vanishes identically

    Raises
    ------
    ScopeError
        the expression is not rational in x, has a coefficient that is not real, or its roots are not told
        apart

    Examples
    --------
    >>> import gyrostat as gs
    >>> x = gs.symbol("x")
    >>> real_roots((x**2 - 2) * (3*x - 1) / (x + 5), x)
    [-sqrt(2), 1/3, sqrt(2)]
    >>> real_roots(x**3 - x - 1, x)
    [CRootOf(x**3 - x - 1, 0)]
    >>> real_roots(x**2 - sqrt(2), x, low=Rational(0))
    [CRootOf(x**4 - 2, 1)]
    """
    ring = Ring([expression, x])
    constants = [g for g in ring.generators if g != x]
    if any(g.free_symbols or g.is_real is False for g in constants):
        raise ScopeError(f"{brief(expression)} is not a fraction of polynomials in {x} with real numbers for "
                         "coefficients: its roots are not found; give numbers for its parameters, and a "
                         "field that is polynomial in k3")
    top, bottom = ring.fraction(expression)
    top, place = ring.reduce(top), ring.generators.index(x)
    parts = by_degree(top, place, top.degrees()[place])
    top = sum((c * ring.gens[x] ** n for n, c in enumerate(parts) if c
               and (c.is_constant() or proved_sign(ring.expression(c)))), ring.zero)
    if not top:
        return None
    ways = (_by_norm, _by_formulas) if len(constants) <= FEW else (_by_formulas, _by_norm)
    found = next((roots for way in ways if (roots := way(ring, top, x)) is not None), None)
    if found is None and all(map(is_algebraic, constants)):
        raise ScopeError(f"the algebraic numbers of {brief(expression)} depend on each other, so that its "
                         "roots are not found: write them in one root")
    if found is None:
        found = _by_enclosures(ring, top, x)
    found = [r for r in found if bottom.is_one() or proved_sign(inserted(ring, bottom, {x: r})) != 0]
    return [r for r in found if (low is None or proved_sign(r - low) == 1)
            and (high is None or proved_sign(high - r) == 1)]


def _by_norm(ring: Ring, polynomial: fmpq_mpoly, x: Symbol) -> list[Expr] | None:
    """Return the real roots in order, from the norm: the product of the conjugates.

    None if that is 0, or a coefficient is not algebraic.
    """
    if not all(g == x or is_algebraic(g) for g in ring.generators):
        return None
    norm = polynomial
    for n, g in enumerate(ring.generators):                # each root before those inside it
        if g != x and norm.degrees()[n]:
            norm = norm.resultant(_relation(ring, g, x), str(norm.context().names()[n]))
    if not norm:
        return None
    found = in_order(roots_of_polynomial(in_one(norm, ring.generators.index(x))))
    return found if norm is polynomial else _kept(ring, polynomial, x, found)


def _by_formulas(ring: Ring, polynomial: fmpq_mpoly, x: Symbol) -> list[Expr] | None:
    """Return the real roots in order; None if a factor is of a degree above 2."""
    factors = _factors(ring, polynomial, x)
    return None if any(len(c) > 3 for c in factors) else _apart(r for c in factors for r in _solved(c))


def _by_enclosures(ring: Ring, polynomial: fmpq_mpoly, x: Symbol) -> list[Expr]:
    """Return the real roots in order; those of factors of higher degree are isolated by balls."""
    found: list[Expr] = []
    for c in _factors(ring, polynomial, x):
        if (roots := _solved(c) if len(c) < 4 else roots_by_enclosures(c)) is None:
            raise ScopeError(f"the roots {x} of {brief(ring.expression(polynomial))} are not told apart: "
                             "round its numbers to decimals")
        found += roots
    return _apart(found)


def _factors(ring: Ring, polynomial: fmpq_mpoly, x: Symbol) -> list[list[Expr]]:
    """Return the coefficients of each factor in which x occurs."""
    place = ring.generators.index(x)
    return [[ring.expression(c) for c in by_degree(factor, place, degree)]
            for factor, _ in polynomial.factor()[1] if (degree := factor.degrees()[place])]


def _apart(numbers: Iterable[Expr]) -> list[Expr]:
    """Return the numbers in increasing order, each once."""
    ordered = in_order(list(numbers))
    return [r for n, r in enumerate(ordered) if not n or proved_sign(r - ordered[n - 1])]


def _solved(c: Sequence[Expr]) -> list[Expr]:
    """Return the real roots of a polynomial of degree 1 or 2, where c[0] is its constant term."""
    if len(c) == 2:
        return [-c[0] / c[1]]
    sign = proved_sign(discriminant := c[1] ** 2 - 4 * c[0] * c[2])
    if sign == 0:
        return [-c[1] / (2 * c[2])]
    return [(-c[1] + s * sqrt(discriminant)) / (2 * c[2]) for s in (-1, 1)] if sign > 0 else []


def _relation(ring: Ring, g: Expr, x: Symbol) -> fmpq_mpoly:
    """Return the polynomial that a generator satisfies, over the generators inside it."""
    if g in ring.squares:
        return ring.gens[g] ** 2 - ring.squares[g]
    coefficients = Poly(minimal_polynomial(g, x), x).all_coeffs()
    return sum((ring.one * int(c) * ring.gens[g] ** n for n, c in enumerate(reversed(coefficients))),
               ring.zero)


def _kept(ring: Ring, polynomial: fmpq_mpoly, x: Symbol, numbers: list[Expr]) -> list[Expr]:
    """Pick the roots out of sorted candidates.

    A change of sign of the polynomial around a candidate proves it; without one, its value has to be 0.
    """
    midway = [between(a, b) for a, b in zip([-oo, *numbers], [*numbers, oo])]
    signs = [proved_sign(inserted(ring, polynomial, {x: q})) for q in midway]
    return [r for r, a, b in zip(numbers, signs, signs[1:]) if a * b < 0
            or proved_sign(inserted(ring, polynomial, {x: r})) == 0]


def in_order(numbers: Sequence[Expr]) -> list[Expr]:
    """Return distinct exact numbers in increasing order."""
    def compared(a: Expr, b: Expr) -> int:
        return proved_sign(a - b)

    return sorted(numbers, key=cmp_to_key(compared))


def between(a: Expr, b: Expr) -> Rational:
    """Return a short rational number between two exact ones."""
    if a == -oo and b == oo:
        return S.Zero
    if a == -oo:
        return S(floor(_side(b, 64, -1)) - 1)
    if b == oo:
        return S(floor(_side(a, 64, 1)) + 1)
    precision = 64
    while not (low := _side(a, precision, 1)) < (high := _side(b, precision, -1)):
        precision *= 2
    bits = 1
    while not (candidate := Rational(floor(low * 2**bits) + 1, 2**bits)) < high:
        bits += 1                                          # the first dyadic number that lies between
    return candidate


def inside(values: Iterable[Expr], low: Expr, high: Expr) -> list[Expr]:
    """Return those of some exact numbers that lie between two, which may be infinite."""
    return [x for x in values if (low == -oo or proved_sign(x - low) == 1)
            and (high == oo or proved_sign(high - x) == 1)]


def _side(number: Expr, precision: int, side: int) -> Rational:
    """Return the upper or lower end of an enclosure, exactly."""
    return to_sympy(ends(finite_ball(number, precision))[side > 0])


def nearest(value: Expr, known: list[Expr], power: int = 1) -> Expr:
    """Return the one of some distinct numbers that is a power of a value."""
    precision = 64
    while True:
        here = math.prod([ball(value, precision)] * power, start=arb(1))
        left = known
        if here.is_finite():
            left = [number for number in known if here.overlaps(ball(number, precision))]
        if len(left) == 1:
            return left[0]
        precision *= 2


def inserted(ring: Ring, polynomial: fmpq_mpoly, numbers: Mapping[Expr, Expr]) -> Expr:
    """Insert numbers for the generators of a polynomial.

    Nothing is inserted inside a number, where a CRootOf has a variable of its own.
    """
    meaning = [numbers.get(g, ring.expression(ring.gens[g])) for g in ring.generators]
    return Add(*(Mul(to_sympy(c), *(Pow(g, int(e)) for g, e in zip(meaning, exponents) if e))
                 for exponents, c in polynomial.to_dict().items()))


def roots_of_polynomial(polynomial: fmpq_poly) -> list[Expr]:
    """Return the distinct real roots of a polynomial, factor by factor; none for the polynomial 0."""
    factors = polynomial.factor()[1] if polynomial else ()
    return [root for factor, _ in factors for root in roots_of_factor(factor)]


def roots_of_factor(factor: fmpq_poly) -> list[Expr]:
    """Return the real roots of an irreducible polynomial, in increasing order."""
    c = list(map(to_sympy, factor.coeffs()))
    if len(c) > 3:
        return roots_of(c)
    return _solved(c)[::1 if c[-1] > 0 else -1]
