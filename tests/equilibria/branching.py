"""Scenes in given fields, and branches to many digits."""
from fractions import Fraction
from functools import cache

import mpmath

import gyrostat as gs

k3, a1, a2 = gs.symbol("k3"), gs.symbol("a1"), gs.symbol("a2")
FIELD = sum(gs.symbol(f"a{n}") * k3**n for n in range(1, 7))


@cache
def in_field(expression):
    """A scene in a given U."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(expression))


def named(potential):
    """The coefficients of U by name."""
    return {f"a{n}": a for n, a in enumerate(potential, 1)}


def digits(number):
    """A number to 60 digits."""
    return mpmath.mpf(str(number.evalf(60)))


def fraction(number):
    """A rational of SymPy as a Fraction."""
    return Fraction(int(number.p), int(number.q))


def real(a):
    """A fraction as a number of mpmath."""
    return mpmath.mpf(a.numerator) / a.denominator


def signs(branches):
    """1 for stable, −1 for unstable; undecided is not expected."""
    return [{"STABLE": 1, "UNSTABLE": -1}[b.decision.verdict.name] for b in branches]


def tilted(branches):
    """Those between the poles."""
    return [b for b in branches if b.label not in ("E1", "E2")]
