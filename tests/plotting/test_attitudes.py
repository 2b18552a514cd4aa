"""The attitudes of a satellite as they are drawn, against equations of motion in floats."""
from fractions import Fraction

import numpy as np
import pytest
from matplotlib.colors import same_color
from matplotlib.figure import Figure
from orbital_search import torques

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.plotting import draw_attitudes
from gyrostat.plotting.looks import MARKERS

MOMENTS = (1, "5/4", "8/5")


def spots(ax, marker):
    """Every marker of a kind: where it is, and its colour."""
    return [(p, line.get_color()) for line in ax.lines if line.get_marker() == marker
            for p in np.array(line.get_data_3d()).T]


def stiffness(n, r, moments, rotor):
    """K of theory A2, at the rate 1."""
    t, I = np.cross(n, r), np.diag(moments)
    tt, nn, rr, tn, nr, held = t @ I @ t, n @ I @ n, r @ I @ r, t @ I @ n, n @ I @ r, rotor @ n
    return np.array([[4 * (nn - rr) + held, -3 * tn, 0], [-3 * tn, 3 * (tt - rr), 3 * nr],
                     [0, 3 * nr, nn - tt + held]])


@pytest.mark.few(1)
@pytest.mark.parametrize(("l", "count", "stable"), [
    ((0, 0, 0), 24, 4), (("3/10", "1/5", "1/10"), 16, 2), (("1/50", "3/100", "1/25"), 24, 4),
    pytest.param((2, 2, 2), 8, 2, marks=pytest.mark.slow)])
def test_each_marker_is_an_attitude(l, count, stable):
    """As many as there are, each a solution; the stable look where K is positive, there alone."""
    scene = gs.assemble(gs.Gyrostat(MOMENTS, l), gs.circular_orbit(1))
    ax = draw_attitudes(scene, ax=Figure().add_subplot(projection="3d"))
    moments, rotor = (np.array([float(Fraction(x)) for x in v]) for v in (MOMENTS, l))
    tips, places = spots(ax, "o"), [p for p, _ in spots(ax, ".")]
    assert len(tips) == len(places) == count
    looks = 0
    for tip, color in tips:
        matching = [(r, (tip - r) / 0.22) for r in places if abs(tip @ r - 1) < 1e-9
                    and abs(np.linalg.norm(tip - r) - 0.22) < 1e-9]
        good = [(n, r) for r, n in matching
                if abs(torques(np.array([[np.cross(n, r), n, r]]), moments, rotor, 1.0)).max() < 1e-9]
        assert good
        positive = min(np.linalg.eigvalsh(stiffness(*good[0], moments, rotor))) > 0
        assert positive == same_color(color, MARKERS["stable"]["color"])
        looks += positive
    assert looks == stable


def test_of_no_satellite_it_is_refused():
    """A free body has no orbit."""
    with pytest.raises(ScopeError, match="in orbit"):
        draw_attitudes(gs.assemble(gs.Gyrostat((1, 2, 2), (0, 0, 0))))
