"""Writes numbers in a column of a text: those in the field of a root by enclosures, not written out."""
from collections.abc import Sequence
from decimal import ROUND_HALF_EVEN

from sympy import Expr, Rational

from ..algebra.solving.real_fields import FieldNumbers
from .formats.unicode import unicode
from .numbers import ACCURATE, BESIDE, long_decimal, middle, with_digits

CELL = 6                                               # characters of a rational number in a column


def in_a_cell(value: Expr | None) -> str:
    """Write a number in a column of a text: a short fraction as it is, of any other number four digits.

    None stands for every number.

    Examples
    --------
    >>> from sympy import sqrt
    >>> in_a_cell(Rational(-5, 12)), in_a_cell(sqrt(2) / 2)
    ('−5/12', '0.7071')
    """
    if value is None:
        return "any"
    if isinstance(value, Rational) and len(exact := unicode(value)) <= CELL:
        return exact
    return with_digits(long_decimal(value), BESIDE, ROUND_HALF_EVEN).text


def in_cells(values: Sequence[Expr | None]) -> list[str]:
    """Write several numbers so, the same for numbers in a field, of which only fractions are written out."""
    if not isinstance(values, FieldNumbers):
        return [in_a_cell(x) for x in values]
    return [in_a_cell(values[n]) if values.is_fraction(n) or x.rel_accuracy_bits() < ACCURATE
            else with_digits(middle(x), BESIDE, ROUND_HALF_EVEN).text
            for n, x in enumerate(values.balls(2 * ACCURATE))]
