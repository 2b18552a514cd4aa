"""Scenes in polynomial fields to integrate, and the methods there are."""
from fractions import Fraction
from importlib.util import find_spec

import pytest
from sympy import Rational

import gyrostat as gs

KINDS = ["DOP853", pytest.param("heyoka",
                                marks=pytest.mark.skipif(find_spec("heyoka") is None,
                                                         reason="heyoka is not installed"))]
INERTIA, ROTOR, STATE = (1, 2, 3), ("0.3", "-0.2", "0.5"), ("0.5", "0.3", "1.2", "0.6", "0", "0.8")
FIELD = [("0.2", (1, 0, 0)), ("0.4", (0, 1, 0)), (1, (0, 0, 1))]


def exact(values):
    return tuple(Rational(Fraction(v)) for v in values)


def scene(inertia, rotor, terms=None):
    """The scene of the terms of a polynomial U, as the oracle takes them."""
    def U(*k):
        return sum(Rational(Fraction(c)) * k[0] ** a * k[1] ** b * k[2] ** d for c, (a, b, d) in terms)

    return gs.assemble(gs.Gyrostat(exact(inertia), exact(rotor)), gs.general_potential(U) if terms else None)
