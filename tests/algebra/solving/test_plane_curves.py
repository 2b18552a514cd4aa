"""Plane curves F(x, t) = 0 over −1 < x < 1: their branches at a t."""
from fractions import Fraction

import pytest
from sympy import Integer, Rational, sqrt

from gyrostat.algebra.solving.plane_curves import PlaneCurve
from gyrostat.algebra.solving.stations import critical_points, stations
from gyrostat.notation import symbol

x, t = symbol("x"), symbol("t")


@pytest.mark.parametrize("power", [3, 29, 61, 300])
def test_a_branch_near_an_end_is_not_lost(power):
    """x = t at t = 1 − 10⁻ⁿ is inside, and at 1 + 10⁻ⁿ it is not."""
    curve, near = PlaneCurve(x - t, x, t), Fraction(1, 10**power)
    assert [len(curve.roots(s * (1 - near))) for s in (1, -1)] == [1, 1]
    assert curve.roots(1 + near) == curve.roots(-1 - near) == []


@pytest.mark.parametrize("power", [0, 60, -60, 300])
def test_stations_do_not_depend_on_the_unit_of_t(power):
    """x² = t and x = t − 1/2: two branches begin at t = 0, two cross once, each leaves at an end.

    So in any other unit of t.
    """
    unit = Integer(10) ** power
    curve = PlaneCurve((x**2 - t * unit) * (x - t * unit + Rational(1, 2)), x, t)
    found = stations(curve, critical_points(curve))
    assert [(s.t * unit, [(p.x, len(p.left), len(p.right)) for p in s.places]) for s in found] == [
        (Rational(-1, 2), [(-1, 0, 1)]), (0, [(0, 0, 2)]),
        (1 - sqrt(3) / 2, [(Rational(1, 2) - sqrt(3) / 2, 2, 2)]), (1, [(-1, 1, 0), (1, 1, 0)]),
        (Rational(3, 2), [(1, 1, 0)])]
