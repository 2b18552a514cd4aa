"""The ladder as a list: the first rung that applies decides, and no other theorem is asked."""
import pytest
from scene_kinds import CASES
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import Point
from gyrostat.stability.ladder import RUNGS
from gyrostat.stability.standing import Standing


def case(name, **more):
    """The report of a case, and its numbers."""
    values = CASES[name].numbers | {gs.symbol(n): x for n, x in more.items()}
    return CASES[name].report, Point(values)


def turned_fold():
    """A fold about axis 3 of the body 1, 2, 3, seen in axes turned by 45 degrees about axis 1."""
    half, along = Rational(1, 2), 1 / sqrt(2)
    body = gs.Gyrostat([[1, 0, 0], [0, 5 * half, half], [0, half, 5 * half]],
                       (0, half * along, half * along))
    pi = -Rational(3, 4) * along
    return gs.analyze(gs.equilibrium(gs.assemble(body), (0, pi, pi))), Point({})


def at_rest_without_torque():
    """A gyrostat at rest, k across its rotor."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential("k1^2 + k2^2 + k3^2"))
    return gs.analyze(gs.equilibrium(scene, (0, 0, 0, 1, 0, 0))), Point({})


STANDS_ON = {
    "second variation": lambda: case("E1, fast"),
    "spectrum": lambda: case("E1, slow"),
    "another scene": lambda: case("of revolution at numbers", omega=2 * sqrt(2) / 3),
    "reduced motion, momentum sphere": lambda: case("E1, critical"),
    "missing names": lambda: (CASES["a degenerate minimum"].report,
                              Point({gs.symbol("a"): Rational(0), gs.symbol("b"): Rational(1)})),
    "two directions": lambda: case("in orbit, open"),
    "fourth order": turned_fold,
    "normal forms": lambda: case("upright, a window"),
    "no torque": at_rest_without_torque,
    "leading form": lambda: case("a degenerate minimum"),
}


@pytest.mark.parametrize("name", STANDS_ON)
def test_where_it_stands(name):
    """By name."""
    report, numbers = STANDS_ON[name]()
    standing = Standing(report, numbers, {})
    assert next(step.name for step in RUNGS if step.applies(standing)) == name


def test_each_rung_has_a_name_and_a_source():
    """Names are different, and the last rung always applies."""
    assert len({step.name for step in RUNGS}) == len(RUNGS)
    assert all(step.source for step in RUNGS) and RUNGS[-1].applies(None)
