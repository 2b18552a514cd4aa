"""All real roots of a polynomial in an interval, exact: rational, quadratic surds, or roots of a named polynomial."""
from collections.abc import Mapping, Sequence
from functools import cmp_to_key

from flint import fmpq, fmpq_mpoly, fmpq_poly
from sympy import Add, CRootOf, Expr, Mul, Poly, Pow, Rational, S, Symbol, floor, minimal_polynomial, oo, sqrt

from .algebra import Ring, by_degree
from .algebraic import is_algebraic
from .errors import ScopeError
from .exact import ball, sign_of_constant
from .precision import own_precision


def real_roots(expression: Expr, x: Symbol, low: Expr | None = None, high: Expr | None = None) -> list[Expr] | None:
    """The distinct real roots of the numerator of a rational function of x, in increasing order, strictly between low and high.

    Complete: the polynomial is factored over ℚ and the real roots of each factor are counted. Algebraic coefficients are eliminated
    by resultants with their minimal polynomials, and of the roots of that norm those of the polynomial are kept.

    Parameters
    ----------
    expression : Expr          rational in x, with rational or algebraic coefficients
    x : Symbol
    low, high : Expr or None   exact numbers; None: unbounded

    Returns
    -------
    list of Expr               exact numbers; None if the expression vanishes identically

    Raises
    ------
    ScopeError                 the expression is not rational in x, or has a coefficient that is not algebraic and real

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> x = symbol("x")
    >>> real_roots((x**2 - 2) * (3*x - 1) / (x + 5), x), real_roots(x**3 - x - 1, x), real_roots(x**2 - sqrt(2), x, low=Rational(0))
    ([-sqrt(2), 1/3, sqrt(2)], [CRootOf(x**3 - x - 1, 0)], [CRootOf(x**4 - 2, 1)])
    """
    ring = Ring([expression, x])
    if any(g != x and (g.free_symbols or not is_algebraic(g) or g.is_real is False) for g in ring.generators):
        raise ScopeError(f"{expression} is not a polynomial in {x} with algebraic coefficients: its roots are not found; give numbers for "
                         "its parameters, and a field that is polynomial in k3")
    top, bottom = ring.fraction(expression)
    top, place = ring.reduce(top), ring.generators.index(x)
    parts = by_degree(top, place, top.degrees()[place])
    top = sum((c * ring.gens[x] ** n for n, c in enumerate(parts) if c and (c.is_constant() or proved_sign(ring.expression(c)))), ring.zero)
    if not top:
        return None
    norm = top
    for n, g in enumerate(ring.generators):                # each root before those inside it
        if g != x and norm.degrees()[n]:
            norm = norm.resultant(_relation(ring, g, x), str(norm.context().names()[n]))
    if not norm:
        raise ScopeError(f"the algebraic numbers of {expression} depend on each other: write them in one root")
    nothing = (0,) * len(ring.generators)
    coefficients = [c.to_dict().get(nothing, fmpq(0)) for c in by_degree(norm, place, norm.degrees()[place])]
    found = in_order([r for factor, _ in fmpq_poly(coefficients).factor()[1] for r in _roots_of_factor(factor)])
    if norm is not top:
        found = _kept(ring, top, x, found)
    found = [r for r in found if bottom.is_one() or proved_sign(inserted(ring, bottom, {x: r})) != 0]
    return [r for r in found if (low is None or proved_sign(r - low) == 1) and (high is None or proved_sign(high - r) == 1)]


def _relation(ring: Ring, g: Expr, x: Symbol) -> fmpq_mpoly:
    """The polynomial that a generator satisfies, over the generators inside it."""
    if g in ring.squares:
        return ring.gens[g] ** 2 - ring.squares[g]
    coefficients = Poly(minimal_polynomial(g, x), x).all_coeffs()
    return sum((ring.one * int(c) * ring.gens[g] ** n for n, c in enumerate(reversed(coefficients))), ring.zero)


def _kept(ring: Ring, polynomial: fmpq_mpoly, x: Symbol, numbers: list[Expr]) -> list[Expr]:
    """Of numbers in order, all roots of a polynomial and others: the roots. A change of sign around a number proves that it is one."""
    midway = [between(a, b) for a, b in zip([-oo, *numbers], [*numbers, oo])]
    signs = [proved_sign(inserted(ring, polynomial, {x: q})) for q in midway]
    return [r for r, a, b in zip(numbers, signs, signs[1:]) if a * b < 0 or proved_sign(inserted(ring, polynomial, {x: r})) == 0]


def in_order(numbers: Sequence[Expr]) -> list[Expr]:
    """Distinct exact numbers in increasing order."""
    def compared(a: Expr, b: Expr) -> int:
        return proved_sign(a - b)

    return sorted(numbers, key=cmp_to_key(compared))


def between(a: Expr, b: Expr) -> Rational:
    """A rational number between two exact ones, a short one."""
    if a == -oo and b == oo:
        return S.Zero
    if a == -oo or b == oo:
        edge = ball(b, 64).lower().floor() - 1 if a == -oo else ball(a, 64).upper().ceil() + 1
        return Rational(int(edge.unique_fmpz()))
    precision = 64
    while not (low := _side(a, precision, 1)) < _side(b, precision, -1):
        precision *= 2
    bits = 0
    while True:                                            # the first dyadic number that lies between
        bits += 1
        candidate = Rational(floor(low * 2**bits) + 1, 2**bits)
        if sign_of_constant(candidate - a) == 1 and sign_of_constant(b - candidate) == 1:
            return candidate


def _side(number: Expr, precision: int, side: int) -> Rational:
    """The upper or lower end of an enclosure, exact: the ends of balls are rounded to the precision of the context."""
    with own_precision(precision):
        enclosure = ball(number, precision)
        mantissa, exponent = (enclosure.upper() if side > 0 else enclosure.lower()).man_exp()
        return Rational(int(mantissa)) * Rational(2) ** int(exponent)


def inserted(ring: Ring, polynomial: fmpq_mpoly, numbers: Mapping[Expr, Expr]) -> Expr:
    """The polynomial with numbers for generators; never inside a number, where a CRootOf has a variable of its own."""
    meaning = [numbers.get(g, ring.expression(ring.gens[g])) for g in ring.generators]
    return Add(*(Mul(Rational(int(c.p), int(c.q)), *(Pow(g, e) for g, e in zip(meaning, exponents) if e))
                 for exponents, c in polynomial.to_dict().items()))


def proved_sign(constant: Expr) -> int:
    """The sign, which nothing may go without here: a root that is left out would be lost."""
    if (sign := sign_of_constant(constant)) is None:
        raise ScopeError(f"the sign of {constant} is not proved: write its algebraic numbers in one root")
    return sign


def _roots_of_factor(factor: fmpq_poly) -> list[Expr]:
    """The real roots of an irreducible polynomial."""
    c = [Rational(int(a.p), int(a.q)) for a in factor.coeffs()]
    if len(c) == 2:
        return [-c[0] / c[1]]
    if len(c) == 3:
        discriminant = c[1] ** 2 - 4 * c[0] * c[2]
        return [(-c[1] + s * sqrt(discriminant)) / (2 * c[2]) for s in (-1, 1)] if discriminant > 0 else []
    real = sum(root.imag == 0 for root, _ in factor.numer().complex_roots())
    return [CRootOf(Poly(c[::-1], Symbol("x")), n) for n in range(real)]
