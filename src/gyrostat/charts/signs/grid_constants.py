"""Inserts the numbers that are the same at all points of a grid into long margins."""
from math import lcm

from flint import fmpq
from sympy import Expr, Rational, Symbol

from ...algebra.enclosures.rationals import to_flint
from ...algebra.reals.exact import compiled
from ...algebra.rings.polynomials import Ring
from ..grids import Grid

LONG = 40                                              # terms up to which a margin is fast as it is
BITS = 512                                             # of whole coefficients: half of what doubles can hold


def with_constants(margin: Expr, grid: Grid) -> Expr:
    """Return a polynomial of the same sign in the names that vary, if the margin is long; else the margin.

    Its coefficients are whole numbers; if they are too long for doubles, the margin is left as it is.
    """
    fraction = compiled(margin)
    if fraction is None or fraction[2] is not None or len(fraction[1]) <= LONG:
        return margin
    symbols, polynomial, _ = fraction
    numbers = {i: number for i, s in enumerate(symbols) if (number := _constant(grid, s)) is not None}
    if not numbers:
        return margin
    ring = Ring([margin])
    polynomial = polynomial.subs(numbers)
    coefficients = polynomial.coeffs()
    scale = lcm(1, *(int(c.q) for c in coefficients))
    if any(abs(int((c * scale).p)).bit_length() > BITS for c in coefficients):
        return margin
    return ring.expression(polynomial * scale)


def _constant(grid: Grid, name: Symbol) -> fmpq | None:
    """Return the rational number of a name, None if it varies or is not rational."""
    if name not in grid.values or grid.values[name].size != 1 or name in grid.strange:
        return None
    number = grid.exact[name].item() if name in grid.exact else grid.values[name].item()
    return to_flint(number) if isinstance(number, float | Rational) else None
