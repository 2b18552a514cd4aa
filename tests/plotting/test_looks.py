"""The one look of verdicts, the sphere seen from one side, and axes."""
import sys

import numpy as np
import pytest
from matplotlib.figure import Figure

from gyrostat.errors import ArgumentError, MissingExtraError
from gyrostat.plotting import globe, looks
from gyrostat.plotting.looks import axes_of
from gyrostat.stability.decision import Verdict


def space(elevation=22, azimuth=40):
    return Figure(figsize=(4, 4)).add_subplot(projection="3d", elev=elevation, azim=azimuth)


def test_no_verdict_is_told_by_colour_alone():
    """Lines differ in their dashes, markers in their filling, areas in hatch or lightness."""
    assert len({str(looks.line(v)["linestyle"]) for v in Verdict}) == 3
    ax = Figure().subplots()
    drawn = {v.name: ax.plot([0], [0], **looks.marker(v))[0] for v in Verdict}
    assert drawn["STABLE"].get_markerfacecolor() == looks.BLUE
    assert drawn["UNSTABLE"].get_markerfacecolor() == "white"
    assert drawn["UNDECIDED"].get_fillstyle() == "left"
    assert drawn["UNDECIDED"].get_markerfacecoloralt() == "white"
    assert {name for name, (_, hatch) in looks.LOOKS.items() if hatch} == {"undecided", "no_equilibrium"}


@pytest.mark.parametrize("view", [(22, 40), (-35, 200), (90, 0), (-90, 0), (0, 0), (0, 180), (5, -60)])
def test_what_is_in_front_is_nearer_to_the_eye(view):
    """The direction towards the eye is that in which Matplotlib projects nothing aside, and depth decreases.
    """
    ax = space(*view)
    eye = globe.stage(ax, 2.0, ("a", "b", "c"))
    ax.figure.canvas.draw()
    from mpl_toolkits.mplot3d.proj3d import proj_transform
    near, centre, far = (np.array(proj_transform(*(s * eye), ax.get_proj())) for s in (2.0, 0.0, -2.0))
    np.testing.assert_allclose(near[:2], centre[:2], atol=1e-12)       # round-off of a projection
    assert near[2] != far[2] and ax.get_box_aspect() is not None and np.ptp(ax._box_aspect) == 0
    rim = globe.circle(eye, 2.0)
    seen = np.array(proj_transform(*rim.T, ax.get_proj()))[:2] - centre[:2, None]
    np.testing.assert_allclose(np.hypot(*seen), np.hypot(*seen)[0], rtol=1e-9)        # a sphere is round


def test_a_curve_is_parted_at_the_limb():
    """Both parts together are the curve.

    They share the point at which it goes out of sight, on the sphere, where the depth is 0.
    """
    eye = np.array([0.6, 0.0, 0.8])
    curve = np.concatenate([globe.circle(np.array([0.0, 0.6, 0.8]), 3.0, n=12), [[np.nan] * 3],
                            globe.circle(eye, 2.0, np.sqrt(5.0), n=5)])
    front, back = globe.parted(curve, eye)
    shared = np.isfinite(front[:, 0]) & np.isfinite(back[:, 0])
    assert shared.sum() == 2 and (front[shared] == back[shared]).all()
    np.testing.assert_allclose(front[shared] @ eye, 0, atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(front[shared], axis=1), 3, rtol=1e-15)
    kept = np.where(np.isfinite(front), front, back)[~shared]
    np.testing.assert_array_equal(kept, curve)
    assert np.nanmin(front @ eye) > -1e-15 and np.nanmax(back @ eye) < 1e-15
    assert np.isfinite(front[-5:]).all() and np.isnan(back[-5:]).all()


def test_hidden_is_faded_and_behind():
    """The hidden part has its own line, faint and below."""
    ax = space()
    globe.curve_on(ax, globe.circle(np.array([0.0, 0, 1]), 1.0), globe.towards(ax), color="red")
    back, front = ax.lines
    assert back.get_alpha() == globe.FADED
    assert front.get_alpha() is None
    assert back.get_zorder() < front.get_zorder()


@pytest.mark.slow
def test_axes_are_those_given_or_new():
    """Flat axes cannot hold a view of space; without Matplotlib the message has the pip command."""
    ax = space()
    assert axes_of(ax, three=True) is ax
    with pytest.raises(ArgumentError, match='the axes are rectilinear, .*make them with projection="3d"'):
        axes_of(Figure().subplots(), three=True)


def test_a_missing_extra_is_named(monkeypatch):
    """The message has the pip command."""
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingExtraError, match=r'pip install "gyrostat\[plot\]"'):
        axes_of(None)
