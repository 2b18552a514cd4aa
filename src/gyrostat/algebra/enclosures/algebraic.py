"""Separation bounds of algebraic numbers, and their real roots to any precision by Newton's method.

A separation bound says how near to 0 an algebraic number can be that is not 0. An enclosure that lies nearer
to 0 than that proves that the number is 0.
"""
import math
from collections.abc import Iterable
from functools import lru_cache

from flint import arb, fmpz_poly
from sympy import Add, CRootOf, Expr, Integer, Mul, Pow, Rational, cos, cot, csc, pi, sec, sin, tan, totient
from sympy.polys import Poly

from ..._lazy import loaded
from .precision import own_precision

TURNS = (sin, cos, tan, cot, sec, csc)
ISOLATED = 256                                         # bits of isolated roots: fewer take as long


def is_algebraic(constant: Expr) -> bool:
    """Tell whether a constant is algebraic by the way it is written.

    It is if it consists of rationals, + − × ÷, roots, roots of polynomials, and sines, cosines, … of rational
    multiples of π. SymPy's own is_algebraic does not recognise all of these.

    Examples
    --------
    >>> from sympy import sqrt
    >>> [is_algebraic(x) for x in (sqrt(2 + cos(pi/32)), pi, cos(1))]
    [True, False, False]
    """
    return _conjugates(constant) is not None


def separation(constant: Expr) -> int | None:
    """Return n such that the constant, if it is not 0, is at least 2⁻ⁿ in size.

    None if it is not known to be algebraic. An expression in rationals, + − × ÷ and roots satisfies abs(E) ≥
    1/(u^(D−1) l), where u and l bound the conjugates of its numerator and denominator and D is the degree of
    a field that holds its roots: the product of their degrees, and φ(n)/2 for all the cosines of multiples of
    2π/n together.

    References
    ----------
    Burnikel, Fleischer, Mehlhorn & Schirra, Algorithmica 27 (2000) 87-99.
    """
    if (bounds := _conjugates(constant)) is None:
        return None
    degree = _degree_of_roots(constant) * math.prod(r.poly.degree() for r in constant.atoms(CRootOf))
    order = math.lcm(*(4 * int(part.q) for f in constant.atoms(*TURNS) if (part := turn(f)) is not None))
    degree *= max(1, (int(totient(order)) if order < 10**12 else order) // 2)
    return math.ceil(((degree - 1) * bounds[0] + bounds[1] + math.log2(bounds[2])) * (1 + 1e-9)) + 2


def _degree_of_roots(constant: Expr) -> int:
    """Return a bound on the degree of a field that contains all radicals of a constant.

    Each base counts once, by the least common multiple of the orders of its roots. The roots of integers are
    those of their coprime factors, if that gives a smaller degree.
    """
    orders: dict[Expr, int] = {}
    for p in constant.atoms(Pow):
        if isinstance(p.exp, Rational):
            orders[p.base] = math.lcm(orders.get(p.base, 1), int(p.exp.q))
    whole = {int(base): n for base, n in orders.items() if isinstance(base, Integer) and base > 1}
    shared = math.prod(math.lcm(*(n for base, n in whole.items() if math.gcd(base, b) > 1))
                       for b in coprime(whole))
    others = math.prod(n for base, n in orders.items() if base not in whole)
    return others * min(shared, math.prod(whole.values()))


def coprime(integers: Iterable[int]) -> list[int]:
    """Return pairwise coprime integers of whose powers all the given ones are products.

    The logarithms of coprime integers are linearly independent over ℚ.
    """
    base: list[int] = []
    left = [n for n in integers if n > 1]
    while left:
        n = left.pop()
        common = next((b for b in base if math.gcd(n, b) > 1), None)
        if n > 1 and common is None:
            base.append(n)
        elif common is not None:
            base.remove(common)
            left += [n // (shared := math.gcd(n, common)), common // shared, shared]
    return base


def turn(function: Expr) -> Rational | None:
    """Return r for a sine, cosine, … of r π with a rational r, and None for any other argument."""
    coefficient, rest = function.args[0].as_coeff_Mul()
    return coefficient if rest is pi and isinstance(coefficient, Rational) else None


def _conjugates(node: Expr) -> tuple[float, float, int] | None:
    """Return log₂ u, log₂ v and w: the expression is U/(V w), and u, v ≥ 1 bound U and V.

    U and V are algebraic integers, all of whose conjugates are at most u and v in size; w is a positive
    integer. None if the expression is not of that form.
    """
    if isinstance(node, Rational):
        return math.log2(abs(int(node.p)) or 1), 0.0, int(node.q)
    if isinstance(node, CRootOf):
        coefficients = [abs(int(c)) for c in over_integers(node.poly).coeffs()]
        # lead·root is an algebraic integer; its conjugates obey Cauchy's bound
        return math.log2(coefficients[-1] + max(coefficients)), 0.0, coefficients[-1]
    if isinstance(node, TURNS) and turn(node) is None:
        return None
    # 2 sin rπ and 2 cos rπ are algebraic integers whose conjugates are at most 2
    if isinstance(node, TURNS):
        return (1.0, 0.0, 2) if isinstance(node, (sin, cos)) else (1.0, 1.0, 1)
    parts = [_conjugates(part) for part in (node.args if isinstance(node, (Add, Mul)) else node.args[:1])]
    if not parts or None in parts:
        return None
    given = [part for part in parts if part]
    if isinstance(node, Mul):
        return sum(u for u, _, _ in given), sum(v for _, v, _ in given), math.prod(w for _, _, w in given)
    if isinstance(node, Add):
        below, whole = sum(v for _, v, _ in given), math.lcm(*(w for _, _, w in given))
        above = max(u + below - v + math.log2(whole // w) for u, v, w in given)
        return above + math.log2(len(given)), below, whole
    if not isinstance(node, Pow) or not isinstance(node.exp, Rational):
        return None
    (u, v, w), n, k = given[0], abs(int(node.exp.p)), int(node.exp.q)
    low = v + math.log2(w)
    # (U/V)^(1/k) = (U V^(k−1))^(1/k)/V = U/(U^(k−1) V)^(1/k): a root of an algebraic integer is one
    if k > 1 and u < low:
        u, v, w = u, ((k - 1) * u + low) / k, 1
    elif k > 1:
        u = (u + (k - 1) * low) / k
    return (n * u, n * v, w**n) if node.exp > 0 else (n * (v + math.log2(w)), n * u, 1)


@lru_cache(maxsize=256)
def real_root(root: CRootOf, precision: int) -> arb:
    """Enclose a real root of a polynomial by the interval Newton method.

    It starts from an enclosure with half as many bits; up to 256 bits it is the one by which the root is
    isolated. The enclosure is not finite if that root is not real.
    """
    if precision <= ISOLATED:
        return _isolated(root, ISOLATED)
    near = real_root(root, precision // 2)
    polynomial, slope = over_integers(root.poly), over_integers(root.poly).derivative()
    with own_precision(precision + 32):
        while near.rad():
            middle = arb(near.mid())
            better = middle - _at(polynomial, middle) / _at(slope, near)
            if not better.is_finite():
                return _isolated(root, precision)
            if not 2 * better.rad() < near.rad():
                break                                      # rounding: no more digits at this precision
            near = better
    return near


def _isolated(root: CRootOf, precision: int) -> arb:
    real = real_roots_of(root.poly, precision)
    # the real ones come first, in order
    return real[root.index] if root.index < len(real) else arb("nan")


@lru_cache(maxsize=64)
def real_roots_of(polynomial: Poly, precision: int = ISOLATED) -> list[arb]:
    """Enclose all real roots of a polynomial, in increasing order.

    To isolate one takes nearly as long as to isolate all.
    """
    with own_precision(precision):
        return loaded("algebra.enclosures.real_roots:isolated_roots")(over_integers(polynomial))


def _at(polynomial: fmpz_poly, x: arb) -> arb:
    """Return the value of a polynomial at x, by Horner's rule."""
    value = arb(0)
    for coefficient in reversed(polynomial.coeffs()):
        value = value * x + arb(coefficient)
    return value


@lru_cache(maxsize=256)
def over_integers(polynomial: Poly) -> fmpz_poly:
    """Return a polynomial over ℚ times its common denominator, as one over ℤ."""
    return fmpz_poly([int(c) for c in reversed(polynomial.clear_denoms(convert=True)[1].all_coeffs())])
