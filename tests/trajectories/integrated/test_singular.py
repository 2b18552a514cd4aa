"""Integrated motions where U or the vertical is not there: an error, no made-up motion."""
from fractions import Fraction

import numpy as np
import pytest
from sympy import Rational, log, sqrt
from trajectories.integrations import FIELD, INERTIA, KINDS, ROTOR, exact, scene

import gyrostat as gs
from gyrostat.errors import AccuracyError, ValuesError
from gyrostat.trajectories.integrated.integrated_motion import Integration


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("U", [lambda a, b, c: 2 * log(c), lambda a, b, c: -1 / c**2,
                               lambda a, b, c: sqrt(c)], ids=["log", "pole", "root"])
def test_a_singular_field_is_an_error(kind, U, monkeypatch):
    """A motion that runs into k3 = 0, where U is not smooth, is not made up."""
    moving = Integration(gs.assemble(gs.Gyrostat((1, 2, Rational(3, 2)), (0, 0, 0)), gs.general_potential(U)),
                         exact((Fraction(1, 2), 0, Fraction(1, 3), Fraction(3, 5), 0, Fraction(4, 5))),
                         method=kind)
    with pytest.raises(AccuracyError, match="singular"):
        moving.state(5.0)
    assert moving.state(0.1)[5] > 0.5


def test_a_state_outside_the_domain_is_an_error(monkeypatch):
    """A step over k3 = 0, beyond which log k3 is not real and its slope is: no energy, no state."""
    built = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(lambda a, b, c: log(c)))
    moving = Integration(built, exact((0, 0, 0, Fraction(3, 5), 0, Fraction(4, 5))), method="DOP853")
    monkeypatch.setattr(moving, "_followed", lambda run, times: np.tile(-run.start, (len(times), 1)))
    with pytest.raises(AccuracyError, match=r"beyond t = 1\.0: U or its gradient is singular"):
        moving.state([1.0])


def test_no_direction_no_attitude():
    """With k = 0, or M = 0 on so(3)*, there is no vertical, but there is a motion."""
    still = Integration(scene(INERTIA, (1, 0, 0)), exact((-1, 0, 0)), method="DOP853")
    with pytest.raises(ValuesError, match="M, which is 0"):
        still.attitude(1.0)
    np.testing.assert_allclose(still.state(1.0), [-1, 0, 0])
    with pytest.raises(ValuesError, match="k, which is 0"):
        Integration(scene(INERTIA, ROTOR, FIELD), exact((1, 0, 0, 0, 0, 0)), method="DOP853").attitude(1.0)
