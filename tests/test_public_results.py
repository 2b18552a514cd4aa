"""What every public result can be asked, whatever it is: equality, hash, texts, copies and pickles."""
import copy
import pickle
from contextlib import suppress

import numpy as np
import pytest
from public_results import results

import gyrostat as gs
from gyrostat.errors import GyrostatError

TOP = {"I1": 1, "I3": "0.6", "l": "0.4", "m0": 1}
START = ("0.3", "-0.2", "1.5", "0.6", 0, "0.8")


def asked(result):
    """The result, after all that it derives was asked for."""
    for name in sorted(dir(type(result))):
        if not name.startswith("_") and not callable(getattr(type(result), name)):
            with suppress(GyrostatError):                  # it has no such thing
                getattr(result, name)
    return result


def some():
    """Results that hold arrays, lists and mappings."""
    numbers = {"I1": 2, "I3": 1, "l": 0, "m0": 1}
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    return (gs.continuation(top, "omega", (1, 3), numbers), gs.continuation(free, "l", (0, 1), {"M": 1}),
            gs.spectrum(gs.hanging(top), "pi3_0", (0, 1), numbers), gs.published.load("AR"))


def every():
    """One of each kind."""
    return results().values()


@pytest.mark.parametrize("made", [some, pytest.param(every, marks=pytest.mark.slow)])
def test_results_are_compared_and_kept_in_sets(made):
    """Equal to themselves and to nothing else, with a hash; arrays in them raise nothing."""
    for result in made():
        again = pickle.loads(pickle.dumps(result))
        assert result == result and result != 3 and len({result, result}) == 1
        assert again != result or hash(again) == hash(result)


@pytest.mark.slow
def test_results_are_copied_and_pickled_after_they_were_asked():
    """What was derived does not stand in the way, and the copy reads the same."""
    for result in map(asked, every()):
        for again in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result), copy.copy(result)):
            assert type(again) is type(result)
            if type(result).__repr__ is not object.__repr__:
                assert repr(again) == repr(result) and str(again) == str(result)


@pytest.mark.few(6)
@pytest.mark.parametrize("body, field, values, start, route", [
    ((), gs.uniform_field(), TOP, START, "elliptic"),
    ((), gs.uniform_field(), TOP, (0, 0, 1, 0, 0, 1), "equilibrium"),
    ((), gs.axial_potential("k3^3"), {"I1": 1, "I3": 1, "l": 0}, START, "quadrature"),
    (((1, 2, 2), (0, 0, 0)), gs.general_potential("k1"), {}, START, "elliptic"),
    pytest.param(((1, 2, 3), (0, 0, 0)), gs.general_potential("k1 + k2"), {}, START, "heyoka",
                 marks=pytest.mark.slow),
    (((1, 2, 3), (0, 0, 0)), None, {}, START[:3], "free body"),
    (((1, 2, 3), (0, 0, 1)), None, {}, START[:3], "free gyrostat"),
    (([[3, 1, 0], [1, 3, 0], [0, 0, 5]], (0, 0, 0)), None, {}, START[:3], "free body")])
@pytest.mark.parametrize("precision", [None, 30])
def test_a_motion_of_every_route_is_pickled(body, field, values, start, route, precision):
    """In doubles and in digits, before and after it was asked; its states are the same."""
    scene = gs.assemble(gs.Gyrostat(*body) if body else gs.symmetric_gyrostat(), field)
    if precision and route == "heyoka":
        pytest.skip("integrated in doubles")
    motion, times = gs.trajectories.motion(scene, start, values, precision=precision), [0, 1, 7]
    fresh = pickle.loads(pickle.dumps(motion))
    states = motion(times)
    assert asked(motion).route in (route, "DOP853")
    for again in (fresh, pickle.loads(pickle.dumps(motion)), copy.deepcopy(motion)):
        assert np.array_equal(again(times), states)
        assert repr(again) == repr(motion) and again.period == motion.period
        assert np.array_equal(again.attitude(times), motion.attitude(times))
