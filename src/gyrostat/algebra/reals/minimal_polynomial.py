"""Describes a real algebraic number by its minimal polynomial over ℤ and an interval with no other root."""
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq_mat, fmpq_poly, fmpz_poly
from sympy import Add, CRootOf, Expr, Mul, Poly, Pow, Rational, S, Symbol, minimal_polynomial

from ..enclosures.algebraic import is_algebraic, over_integers
from ..enclosures.balls import FARTHEST, ball, ends, fraction_of
from ..enclosures.precision import doubled, own_precision
from ..enclosures.rationals import to_flint
from ..enclosures.real_roots import isolated_roots
from .number_fields import divided

PRECISION = 128
PLACES = 18                                            # decimals of the ends, if they tell the roots apart
X = Symbol("x")


class AlgebraicNumber(NamedTuple):
    """The irreducible primitive polynomial of a number, and two ends between which it is the one root."""

    polynomial: fmpz_poly
    low: Fraction
    high: Fraction


def algebraic_number(number: Expr) -> AlgebraicNumber | None:
    """Return the minimal polynomial of a real number and an interval that isolates it; None if it has none.

    The ends of the interval are decimals, for a fraction the fraction itself. Numbers in the field of one
    root, as those of finders, are found by linear algebra in it; others by SymPy.

    Parameters
    ----------
    number : Expr
        a real constant

    Examples
    --------
    >>> from sympy import CRootOf, Symbol, pi, sqrt
    >>> x = Symbol("x")
    >>> algebraic_number(1 - CRootOf(x**3 - x - 1, 0)**2).polynomial
    x^3 + (-1)*x^2 + 1
    >>> algebraic_number(sqrt(2) / 2).polynomial, algebraic_number(pi)
    (2*x^2 + (-1), None)
    """
    if isinstance(number, Rational):
        value = Fraction(number.p, number.q)
        return AlgebraicNumber(fmpz_poly([-number.p, number.q]), value, value)
    if not is_algebraic(number):
        return None
    polynomial = _polynomial(number)
    return AlgebraicNumber(polynomial, *_interval(number, polynomial))


def _polynomial(number: Expr) -> fmpz_poly:
    roots = sorted(number.atoms(CRootOf), key=str)
    radical, rest = _square_root(number)
    if len(roots) != 1 or any(not p.exp.is_Integer for p in rest.atoms(Pow)):
        return over_integers(Poly(minimal_polynomial(number, X), X))
    polynomial = _of_conjugates(rest.xreplace({roots[0]: X}), radical, roots[0].poly)
    if radical == 1:
        return polynomial
    whole = polynomial(fmpz_poly([0, 0, 1]))               # of the number and of its opposite
    return _vanishing(number, [factor for factor, _ in whole.factor()[1]])


@lru_cache(maxsize=64)
def _of_conjugates(value: Expr, factor: Rational, polynomial: Poly) -> fmpz_poly:
    """Return the polynomial of a value at every root of another; with a factor, of its square times that."""
    modulus = fmpq_poly(over_integers(polynomial))
    element = _in_field(value, modulus)
    return _of_element(element if factor == 1 else element**2 * to_flint(factor), modulus)


def _square_root(number: Expr) -> tuple[Rational, Expr]:
    """Split a product into the square of a root of a rational number, 1 if there is none, and the rest."""
    roots = [p for p in Mul.make_args(number) if isinstance(p, Pow) and p.exp == S.Half
             and isinstance(p.base, Rational)]
    return (roots[0].base, number / roots[0]) if roots else (S.One, number)


def _in_field(node: Expr, modulus: fmpq_poly) -> fmpq_poly:
    """Return a rational expression in x as a polynomial in a root of the modulus."""
    if node == X:
        return fmpq_poly([0, 1]) % modulus
    if isinstance(node, Rational):
        return fmpq_poly([to_flint(node)])
    if isinstance(node, Pow):
        base, n = _in_field(node.base, modulus), int(node.exp)
        base = base if n > 0 else divided([fmpq_poly([1])], base, modulus)[0]
        power = fmpq_poly([1])
        for _ in range(abs(n)):
            power = power * base % modulus
        return power
    parts = [_in_field(part, modulus) for part in node.args]
    found = parts[0]
    for part in parts[1:]:
        found = found + part if isinstance(node, Add) else found * part % modulus
    return found


def _of_element(element: fmpq_poly, modulus: fmpq_poly) -> fmpz_poly:
    """Return the minimal polynomial of an element of the field, by the multiplication with it."""
    size, rows = modulus.degree(), []
    power = element % modulus
    for _ in range(size):
        coefficients = power.coeffs()
        rows.append(coefficients + [0] * (size - len(coefficients)))
        power = power * fmpq_poly([0, 1]) % modulus
    found = fmpq_mat(rows).charpoly().numer()              # a power of the minimal polynomial
    found //= found.gcd(found.derivative())
    return found if found.leading_coefficient() > 0 else -found


def _vanishing(number: Expr, factors: list[fmpz_poly]) -> fmpz_poly:
    """Return the one of several coprime polynomials of which a number is a root."""
    for precision in doubled(PRECISION, FARTHEST):
        with own_precision(precision):
            at = ball(number, precision)
            factors = [f for f in factors if _value(f, at).contains(0)]
        if len(factors) == 1:
            break
    return factors[0]


def _value(polynomial: fmpz_poly, at: arb) -> arb:
    value = arb(0)
    for coefficient in reversed(polynomial.coeffs()):
        value = value * at + arb(coefficient)
    return value


def _interval(number: Expr, polynomial: fmpz_poly) -> tuple[Fraction, Fraction]:
    """Return decimals around a number between which the polynomial has no other root."""
    for places in doubled(PLACES, FARTHEST // 4):
        precision = 4 * places + PRECISION
        with own_precision(precision):
            near = ball(number, precision)
            others = [ends(x) for x in isolated_roots(polynomial) if not x.overlaps(near)]
        scale = 10**places
        low = Fraction(int(fraction_of(near.mid()) * scale // 1), scale)
        high = low + Fraction(1, scale)
        first, last = ends(near)
        if low <= first and last <= high and not any(a <= high and low <= b for a, b in others):
            break
    return low, high
