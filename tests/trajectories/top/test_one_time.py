"""A motion at one time and at many: the same to the last bit."""
import numpy as np
import pytest
from slow import slow
from trajectories.tops import BODY, MOTIONS, SEPARATRICES, moving

from gyrostat.algebra.text.numbers import exact_number

FEW = ["degree 1", "exp", "no field", "pendulum between its poles"]
MORE = ["degree 4", "over the top", "from the lower pole, pair", "near the upper pole",
        "at the upper turning point",
        *(name for name in SEPARATRICES if name not in FEW)]


@pytest.mark.parametrize("name", [*FEW, *slow(*((name,) for name in MORE))])
def test_a_time_alone_and_among_others(name):
    """State and attitude of a time are the same to the last bit, alone and in a row, and in its shape."""
    if name in MOTIONS:
        inertia, l, U, state = MOTIONS[name][:4]
        found = moving(inertia, l, U, state)
    else:
        U, state, _ = SEPARATRICES[name]
        found = moving(BODY, "2/5", U, [exact_number(x) for x in state])
    t = np.random.default_rng(1).uniform(-40, 40, 300)
    states, turns = found(t), found.attitude(t)
    np.testing.assert_array_equal([found(float(x)) for x in t], states)
    np.testing.assert_array_equal([found.attitude(x) for x in t], turns)
    np.testing.assert_array_equal(found(t.reshape(2, 150)), states.reshape(2, 150, 6))
    assert found(t[:0]).shape == (0, 6) and found.attitude(t[:0]).shape == (0, 3, 3)
