"""Many times in a row: values at equidistant ones, interpolated, are those of each time alone."""
import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.trajectories import equidistant, motion
from gyrostat.trajectories.equidistant import MANY, filled

TOP = gs.assemble(gs.Gyrostat((1, 1, "3/5"), (0, 0, "2/5")), gs.axial_potential(lambda z: z))
CUBIC = gs.axial_potential(lambda z: z + z**3)
SCENES = {
    "top": (TOP, ("3/10", "-1/5", "3/2", "3/5", 0, "4/5")),
    "top of tiny nutation": (TOP, (0, 0, "5/2", "3/5000000000", 0, "1")),
    "cubic field": (gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, "2/5")), CUBIC),
                    ("3/10", "-1/5", "3/2", "3/5", 0, "4/5")),
    "near a separatrix": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), ("1/20000000", 2, "1/5000000")),
    "free gyrostat": (gs.assemble(gs.Gyrostat((3, 5, 9), ("1/10", "-1/5", "3/10"))), (0, 2, "1/100")),
    "uniform": (gs.assemble(gs.Gyrostat((3, 3, 9), (0, 0, "3/10"))), ("1/10", 2, "1/100")),
    "turned": (gs.assemble(gs.Gyrostat((2, 1, 1), ("3/10", 0, 0)), gs.general_potential(lambda a, b, c: a)),
               ("3/10", "-1/5", "3/2", "3/5", 0, "4/5")),
}


def directly(monkeypatch, values, times):
    """The values at times of which none is interpolated."""
    with monkeypatch.context() as patched:
        patched.setattr(equidistant, "MANY", np.inf)
        return values(times)


def rows(step):
    """Equidistant times: from 0 on, back, late, around 0, where a power of 2 is crossed."""
    n = MANY + 137
    return {"on": np.arange(n) * step, "back": np.linspace(0, -n * step, n),
            "late": np.linspace(3e6, 3e6 + n * step, n), "around 0": np.linspace(-0.3, 0.7, n) * n * step,
            "across": 65536 + (np.arange(n) - n // 2) * step}


@pytest.mark.few(1)
@pytest.mark.parametrize("name", SCENES)
def test_a_row_is_its_times(monkeypatch, name):
    """States and attitudes, within some roundings; in the tiny motion relative to its size."""
    scene, state = SCENES[name]
    found = motion(scene, state)
    for times in rows(0.003).values():
        for values in (found, found.attitude):
            expected = directly(monkeypatch, values, times)
            size = np.abs(expected).max(axis=0)
            assert (np.abs(values(times) - expected) <= 2e-14 * size + 2e-16).all()


@pytest.mark.parametrize("name", ["top", "near a separatrix"])
@pytest.mark.parametrize("step", [0.003, 0.0003])
def test_a_row_agrees_with_40_digits(name, step):
    """The error of interpolated states is that of any others."""
    scene, state = SCENES[name]
    found, sharp = motion(scene, state), motion(scene, state, precision=40)
    for times in rows(step).values():
        states = found(times)
        for i in range(0, len(times), 2011):
            with mpmath.workdps(40):
                off = max(abs(mpmath.mpf(float(x)) - y) for x, y in zip(states[i], sharp(float(times[i]))))
            assert off < 1.2e-14


def calls(function):
    """The function, and the list of how many values each call asked for."""
    asked = []

    def counted(x, t):
        asked.append(np.size(t))
        function(x, t)
    return counted, asked


def waves(x, t):
    """Three waves."""
    x[..., 0], x[..., 1], x[..., 2] = np.cos(3 * t), 1e-9 * np.sin(t), 5.0


def test_a_dense_row_asks_for_few_values():
    """Equidistant times ask for less than a fifth of the values, others for all of them."""
    n = 2 * MANY
    function, asked = calls(waves)
    found = filled(function, np.linspace(0, 20, n), (3,))
    assert sum(asked) < n / 5 and (found[:, 2] == 5.0).all()
    asked.clear()
    filled(function, np.sort(np.random.default_rng(0).uniform(0, 20, n)), (3,))
    assert sum(asked) >= n
    asked.clear()
    filled(function, np.zeros(n), (3,))
    assert sum(asked) == n


def test_where_a_function_is_rough_it_is_asked():
    """A corner, and a wave that is too fast in a part of the row, are not interpolated."""
    t = np.linspace(-1, 1, 4 * MANY)
    for rough in (lambda t: np.abs(t - 0.1234), lambda t: np.sin(t + np.exp(12 * (t - 0.2)))):
        def values(x, t, rough=rough):
            x[..., 0], x[..., 1] = rough(t), np.cos(t)
        assert np.abs(filled(values, t, (2,))[:, 0] - rough(t)).max() < 1e-14


@settings(max_examples=25, deadline=None)
@given(start=st.floats(-1e6, 1e6), step=st.floats(1e-4, 2e-2), sign=st.sampled_from((1, -1)),
       jitter=st.sampled_from((0.0, 1e-9, 1e-7, 1e-3)))
def test_times_that_are_not_quite_equidistant(start, step, sign, jitter):
    """Rounded, and off by parts of a step: each value is that of its own time."""
    t = start + sign * step * (np.arange(MANY) + jitter * np.random.default_rng(1).uniform(-1, 1, MANY))
    expected = np.empty((MANY, 3))
    waves(expected, t)
    assert (np.abs(filled(waves, t, (3,)) - expected) <= 4e-15 * np.array([1, 1e-9, 1])).all()


def test_shapes():
    """Rows of rows, none, and one time."""
    t = np.linspace(0, 9, 2 * MANY)
    again = filled(waves, t.reshape(2, -1), (3,)).reshape(-1, 3)
    np.testing.assert_array_equal(again, filled(waves, t, (3,)))
    assert filled(waves, t[:0], (3,)).shape == (0, 3) and filled(waves, t[0], (3,)).shape == (3,)
