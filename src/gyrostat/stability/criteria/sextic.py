"""The spectral criterion for a polynomial in λ² of degree up to three, factor by factor over the rationals.

All λ are imaginary if all roots x = λ² of every factor are real and at most 0: Descartes' rule of signs with
the discriminant.
"""
from collections.abc import Sequence
from typing import Any

from flint import fmpq_mpoly
from sympy import Expr

from ...algebra.rings.polynomials import Ring, by_degree
from ...algebra.solving.margins import Signs
from ...notation import symbol
from .implication import Item

SQUARE = symbol("lamda")                                   # stands for λ², in a ring of its own
Fraction = tuple[fmpq_mpoly, fmpq_mpoly]


def factors_in_squares(coefficients: Sequence[Expr]) -> list[tuple[Expr, ...]]:
    """Return the factors of x³ + c2 x² + c1 x + c0 over the rationals, each as often as it occurs.

    A factor is given by its coefficients, that of the highest power first.
    """
    size = len(coefficients)
    whole = SQUARE**size + sum(c * SQUARE ** (size - n) for n, c in enumerate(coefficients, 1))
    ring = Ring([whole])
    index = ring.generators.index(SQUARE)
    _, found = ring.fraction(whole)[0].factor()
    split = [(by_degree(factor, index, degree), times) for factor, times in found
             if (degree := factor.degrees()[index])]
    # a factor is known up to its sign: the leading coefficient is made positive, as denominators are
    return [tuple(ring.expression(c * (1 if parts[-1].leading_coefficient() > 0 else -1))
                  for c in reversed(parts)) for parts, times in split for _ in range(times)]


def items_of_factors(factors: Sequence[tuple[Expr, ...]], signs: Signs) -> list[Item]:
    """Return what has to be ≥ 0 for all roots x of every factor to be real and ≤ 0."""
    items: list[Item] = []
    for first, *others in dict.fromkeys(factors):
        bottom = signs.ring.numerator(first)
        items += items_of_monic([(signs.ring.numerator(c), bottom) for c in others], signs)
    return items


def items_of_monic(monic: list[Fraction], signs: Signs) -> list[Item]:
    """Return what has to be ≥ 0 for all roots of a monic polynomial to be real and ≤ 0.

    It is x + q, x² + p x + q, or x³ + a x² + b x + c over one denominator: real roots are ≤ 0 iff no
    coefficient is negative, and the three roots of a cubic are real iff its discriminant Δ ≥ 0 (see
    docs/explanation/derivations/satellite.md, section 4).
    """
    names = {1: "q", 2: "pq", 3: "abc"}[len(monic)]
    items = [Item(*signs.split(*c), False, name) for c, name in zip(monic, names)]
    if len(monic) == 2:
        (p, a), (q, b) = monic
        factors = items[0].margin, *items[0].degenerate
        # if q = 0, the discriminant is p², and needs no factoring
        square = signs.ring.one, tuple(e for e in factors if not e.is_constant())
        discriminant = signs.split(p**2 * b - 4 * q * a**2, a**2 * b) if items[1].margin else square
        items.append(Item(*discriminant, False, "p² − 4q"))
    if len(monic) == 3:
        (a, d), (b, _), (c, _) = monic
        items.append(Item(*signs.split(cubic_discriminant(a, b, c, d), d**4), False, "Δ"))
    return items


def cubic_discriminant(a: Any, b: Any, c: Any, d: Any = 1) -> Any:
    """Return Δ d⁴ of x³ + (a x² + b x + c)/d, in any arithmetic."""
    return a**2 * b**2 - 4 * b**3 * d - 4 * a**3 * c + 18 * a * b * c * d - 27 * c**2 * d**2
