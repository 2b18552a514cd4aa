"""The route that each motion takes, what is integrated, and what is refused."""
import numpy as np
import pytest
from sympy import Rational, atan, exp, pi
from trajectories.heavy_top import NUMBERS, STATE, TOP

import gyrostat as gs
from gyrostat.errors import ArgumentError, GyrostatError, ScopeError, ValuesError
from gyrostat.trajectories import motion


def of_revolution(U):
    """I = (1, 1, 2), no rotor."""
    return gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 0)), gs.axial_potential(U))


@pytest.mark.few(1)
@pytest.mark.parametrize(("scene", "state", "values", "route"), [
    (TOP, STATE, NUMBERS, "elliptic"), (TOP, (0, 0, 1, 0, 0, 1), NUMBERS, "equilibrium"),
    (of_revolution(exp), STATE, None, "quadrature"),
    (of_revolution(lambda z: 5 * z), ("1", "1", "3", "3/5", "0", "4/5"), None, "separatrix"),
    (gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0))), (1, 2, 3), None, "free body"),
    (gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 1))), (1, 2, 3), None, "free gyrostat")])
def test_routes(scene, state, values, route):
    """Each motion takes the smallest model that has it, and says which.

    Each has its integrals and its digits.
    """
    found = motion(scene, state, values)
    assert found.route == route and max(found.drift(np.linspace(-1e6, 1e6, 20)).values()) < 1e-13
    precise = motion(scene, state, values, precision=25)([2, -3])
    np.testing.assert_allclose(found([2.0, -3.0]), precise.astype(float), rtol=0, atol=1e-14)
    assert (found.limits is None) == (len(found.state) == 3)
    assert (found.spin_rate is None) == (len(found.state) == 3)
    assert (found.spin is None) == (len(found.state) == 3 or found.period is None)


@pytest.mark.slow
def test_what_is_integrated():
    """Three moments in a field, an asymmetric field, k = 0: integrated, in doubles.

    The tolerance is that of the integrator.
    """
    three = gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0)), gs.axial_potential(lambda z: z))
    for scene, state in ((three, STATE), (of_revolution(lambda z: z), (1, 0, 1, 0, 0, 0))):
        found = motion(scene, state)
        assert found.route in ("heyoka", "DOP853")
        assert found.period is None
        assert found.limits is None
        assert found.spin is None
        assert found.precession_rate is found.spin_rate is None
        assert max(found.drift([1.0, -1.0]).values()) < 1e-10 and found.frequencies == {}
        with pytest.raises(ScopeError, match="30 digits"):
            motion(scene, state, precision=30)
    assert motion(three, STATE, tolerance=1e-3)._route.tolerance == 1e-3


@pytest.mark.parametrize(("kind", "message", "arguments", "options"), [
    (ScopeError, "unspecified", (gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()), STATE,
                                 {"I1": 1, "I3": 1, "l": 0}), {}),
    (ValuesError, "m0", (TOP, STATE, {"I1": 1, "I3": 1, "l": 0}), {}), (ValuesError, "I1", (TOP, STATE), {}),
    (ValuesError, "mass", (TOP, STATE, NUMBERS | {"mass": 1}), {}),
    (ValuesError, "m0", (TOP, STATE, NUMBERS | {"m0": "x"}), {}),
    (ValuesError, "5 numbers, the scene 6 coordinates: give pi1, pi2, pi3, k1, k2, k3",
     (TOP, STATE[:5], NUMBERS), {}),
    (ValuesError, "3 coordinates", (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), STATE), {}),
    (ValuesError, "k3", (TOP, (*STATE[:5], "z"), NUMBERS), {}),
    (ValuesError, "pi1", (TOP, (float("nan"), *STATE[1:]), NUMBERS), {}),
    (ValuesError, "precision = 0: give", (TOP, STATE, NUMBERS), {"precision": 0}),
    (ValuesError, "precision = -3", (TOP, STATE, NUMBERS), {"precision": -3}),
    (ArgumentError, "precision = 2.5", (TOP, STATE, NUMBERS), {"precision": 2.5}),
    (ArgumentError, "scene", (gs.symmetric_gyrostat(), STATE, NUMBERS), {})])
def test_what_is_refused(kind, message, arguments, options):
    """A message names what is wrong."""
    with pytest.raises(kind, match=message) as caught:
        motion(*arguments, **options)
    assert isinstance(caught.value, GyrostatError)


def test_undecided_numbers_are_refused():
    """A transcendental number that is 0 without a proof decides which motion it is."""
    hidden = 4 * atan(Rational(1, 5)) - atan(Rational(1, 239)) - pi / 4          # 0, by Machin
    with pytest.raises(ValuesError, match="is 0 is not proved"):
        motion(TOP, ("1/2", hidden, 1, "3/5", 0, "4/5"), NUMBERS)
