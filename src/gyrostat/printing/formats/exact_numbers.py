"""Exact numbers in Unicode: in a line with a decimal beside them, in a cell of a table short."""
from sympy import Expr, Float, Rational

from ...algebra.enclosures.balls import accurate
from ...algebra.text.numbers import double, shown
from ..results.interval_ends import has_no_closed_form, number
from .unicode import unicode

LONG, DIGITS = 48, 10                                  # characters of an exact number; digits of its decimal
SHORT, FEW = 6, 4                                      # the same in a cell of a table


def valued(value: Expr) -> str:
    """A number exactly, and then as a decimal unless the exact form is as clear: √2/2 ≈ 0.7071067812.

    If it has no closed form, or a long one, its first digits are given alone.

    Examples
    --------
    >>> from sympy import sqrt
    >>> valued(sqrt(3)/4), valued(Rational(5, 12)), valued(Rational(1, 2))
    ('√3/4 ≈ 0.4330127019', '5/12 ≈ 0.4166666667', '1/2')
    """
    if has_no_closed_form(value):
        return str(number(value).text)
    exact = unicode(value)
    if isinstance(value, Rational) and (double(value) or _terminates(value)):
        return shown(value).replace("-", "−")
    near = _decimal(value, DIGITS)
    return f"{near}…" if len(exact) > LONG else f"{exact} ≈ {near}"


def in_a_cell(value: Expr | None) -> str:
    """A number in a table: an integer or a fraction if it is short, else a decimal, rounded.

    Examples
    --------
    >>> from sympy import sqrt
    >>> in_a_cell(Rational(-5, 12)), in_a_cell(sqrt(2)/2), in_a_cell(None)
    ('−5/12', '0.7071', 'any')
    """
    if value is None:
        return "any"
    if isinstance(value, Rational) and len(exact := unicode(value)) <= SHORT:
        return exact
    return _decimal(value, FEW, "#")


def _terminates(value: Rational) -> bool:
    """Whether it is a decimal of a few digits."""
    return bool(10**DIGITS % value.q == 0 and abs(value.p) < 10**DIGITS)


def _decimal(value: Expr, digits: int, zeros: str = "") -> str:
    """The nearest decimal of so many digits; with "#" as zeros those at its end, too."""
    near = value if value.is_Float else Float(accurate(value, 110).mid().str(30, radius=False), 30)
    text = f"{float(near):{zeros}.{digits}g}" if 1e-300 < abs(near) < 1e300 else str(near.n(digits))
    return text.replace("-", "−").rstrip(".")
