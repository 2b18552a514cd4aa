"""Tells how large a constant is before it is computed, by balls of 512 bits.

No number can keep these operations busy.
"""
import operator
from collections.abc import Callable
from functools import partial
from math import prod
from typing import Any

from flint import arb
from sympy import Rational

from ..enclosures.balls import FUNCTIONS
from ..enclosures.precision import own_precision

# bits; what two enclosures of it do not tell apart is not told apart
PRECISION = 512


def enclosed(operation: Callable[..., arb], *enclosures: arb | None) -> arb | None:
    """Apply an operation to enclosures; the result is not finite if it may be undefined.

    None if one of them is not known.
    """
    if any(x is None for x in enclosures):
        return None
    with own_precision(PRECISION):
        return operation(*enclosures)


added = partial(enclosed, operator.add)                    # x + y
multiplied = partial(enclosed, operator.mul)               # x y
negated = partial(enclosed, operator.neg)                  # −x


def applied(name: str, x: arb | None) -> arb | None:
    """Enclose an elementary function."""
    return enclosed(FUNCTIONS[name], x)


def raised(x: arb | None, exponent: Rational) -> arb | None:
    """Enclose a small rational power of x."""
    top, root = int(exponent.p), int(exponent.q)

    def power(base: arb) -> arb:
        if root > 1:
            base = arb("nan") if base < 0 else base.root(root)
        return prod([base] * top, start=arb(1)) if top >= 0 else 1 / prod([base] * -top, start=arb(1))

    return enclosed(power, x)


def extent(x: arb) -> tuple[int, int | None]:
    """Return powers of 2 between which a finite enclosure lies in size; the lower is None if it may be 0."""
    with own_precision(PRECISION):
        ends: list[Any] = [x.abs_upper(), x.abs_lower()]
        high, low = (_exponent(end) for end in ends)
    return 0 if high is None else high, None if low is None else low - 1


def _exponent(end: arb) -> int | None:
    """Return n with the positive number at most 2ⁿ and more than 2ⁿ⁻²; None for 0."""
    mantissa, exponent = map(int, end.man_exp())
    return None if mantissa == 0 else abs(mantissa).bit_length() + exponent
