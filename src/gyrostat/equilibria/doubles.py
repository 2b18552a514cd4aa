"""Rounds the numbers of a relative equilibrium to doubles, from enclosures: none is written out for that."""
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import overload

from flint import arb
from sympy import Expr, Float, Rational, log

from ..algebra.enclosures.balls import FARTHEST, ball, ends, fraction_of
from ..algebra.enclosures.precision import doubled, own_precision
from ..algebra.solving.real_fields import FieldNumbers
from ..stability.form import PRECISION, Form


@overload
def nearest(numbers: Sequence[Expr]) -> tuple[float, ...]: ...


@overload
def nearest(numbers: Sequence[Expr | None]) -> tuple[float | None, ...]: ...


def nearest(numbers: Sequence[Expr | None]) -> tuple[float | None, ...]:
    """Return the double next to each exact number; None for one that takes every value.

    Examples
    --------
    >>> from sympy import Rational, sqrt
    >>> nearest([sqrt(2), Rational(1, 3), None])
    (1.4142135623730951, 0.3333333333333333, None)
    """
    if isinstance(numbers, FieldNumbers):
        return rounded(numbers.balls)
    return tuple(None if x is None else _nearest(x) for x in numbers)


def _nearest(number: Expr) -> float:
    if isinstance(number, Float):
        return float(number)
    return rounded(lambda precision: [ball(number, precision)])[0]


def _exact(number: Expr) -> Expr:
    """Take the digits of a Float for exact."""
    return Rational(number) if isinstance(number, Float) else number


@dataclass(frozen=True)
class Doubles:
    """Place and rates of a relative equilibrium, each the double next to the exact number.

    A number in the field of a root of high degree has an exact form of many thousand characters, which is
    not needed here: enclosures are made narrower until both ends round to one double. If 8192 bits do not
    decide between two doubles, the middle is rounded; a number of which there is no enclosure is NaN.
    Frequencies that are known to 30 digits are rounded from those.

    Parameters
    ----------
    form : Form
        of the relative equilibrium
    """

    form: Form

    @property
    def place(self) -> dict[str, float | None]:
        """What tells it from others of its scene, by the names of RelativeEquilibrium.place."""
        return {name: x for names, numbers in self.form.placed for name, x in zip(names, nearest(numbers))}

    @property
    def rates(self) -> dict[str, float]:
        """The rates of the rotation, by name [1/T]."""
        return {name: nearest([x])[0] for name, x in self.form.rates.items()}

    @property
    def frequencies(self) -> tuple[float, ...]:
        """The frequencies of the small motions, in increasing order [1/T]."""
        return nearest(self.form.frequencies)

    @property
    def growth_rate(self) -> float | None:
        """The largest real part of an eigenvalue [1/T]; None if none is positive."""
        rate = self.form.growth_rate
        return None if rate is None else nearest([rate])[0]

    @property
    def doubling_time(self) -> float | None:
        """The time log 2/growth_rate in which a small deviation doubles [T]; None if none grows."""
        rate = self.form.growth_rate
        return None if rate is None else nearest([log(2) / _exact(rate)])[0]

    @property
    def frequencies_per_orbit(self) -> tuple[float, ...] | None:
        """The frequencies over omega0: how often a satellite librates in one orbit; None if it is in none."""
        rate = self.form.rates.get("omega0")
        return None if rate is None else nearest([_exact(x) / rate for x in self.form.frequencies])


def rounded(enclosed: Callable[[int], Sequence[arb]]) -> tuple[float, ...]:
    """Return the double next to each number; they are enclosed together with any number of bits."""
    for precision in doubled(PRECISION, FARTHEST):
        with own_precision(precision):
            found = enclosed(precision)
        if all(map(_decides, found)):
            break
    return tuple(_double(fraction_of(x.mid())) if x.is_finite() else math.nan for x in found)


def _decides(enclosure: arb) -> bool:
    """Whether both ends of a ball round to one double."""
    return enclosure.is_finite() and len(set(map(_double, ends(enclosure)))) == 1


def _double(fraction: Fraction) -> float:
    """Round to the nearest double; beyond the greatest to infinity."""
    try:
        return float(fraction) + 0.0                       # no −0
    except OverflowError:
        return math.inf if fraction > 0 else -math.inf
