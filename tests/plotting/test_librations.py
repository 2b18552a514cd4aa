"""Roll, pitch and yaw as they are drawn."""
import numpy as np
import pytest
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.plotting import draw_librations
from gyrostat.trajectories import motion, roll_pitch_yaw


def test_the_curves_are_the_angles():
    """In degrees over orbits, of the axes asked for; what jumps is broken there."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit("1/2"))
    n, r = (0, 1, 0), (0, 0, 1)                            # it tumbles in pitch
    moving = motion(scene, (0, 200, 0, *n, *r))
    times = np.linspace(0, 20, 400)
    ax = draw_librations(moving, times, Figure().subplots(), pointing=(3, 2, 1))
    angles = np.degrees(roll_pitch_yaw(moving.attitude(times), (3, 2, 1))).T
    for line, wanted in zip(ax.lines, angles, strict=True):
        x, y = line.get_data()
        kept = ~np.isnan(y)
        assert np.allclose(y[kept], wanted) and np.allclose(x[kept], times / (4 * np.pi))
        assert (abs(np.diff(y))[~np.isnan(np.diff(y))] <= 120).all()
    assert any(np.isnan(line.get_ydata()).any() for line in ax.lines)
    assert "$n(0) = (0, 1, 0)$" in ax.get_title()


def test_of_no_satellite_it_is_refused():
    """A top has no orbit."""
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    moving = motion(top, (0, 0, 3, "3/5", 0, "4/5"), {"I1": 1, "I3": 1, "l": 0, "m0": 1})
    with pytest.raises(ScopeError, match="in orbit"):
        draw_librations(moving, [0, 1], Figure().subplots())
