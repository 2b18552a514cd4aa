"""Permanent rotations in the plane of omega and sigma, read back and computed again in doubles."""
import heavy
import numpy as np
import pytest
from matplotlib.figure import Figure
from slow import slow
from sympy import Rational

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.plotting import draw_staude_plane
from gyrostat.plotting.looks import LINES
from gyrostat.plotting.staude_cone import CHANGE, FOLD, REST

BODIES = {"general": ((1, 2, 3), (1, 1, 1), (0, 0, 0)), "a plane": ((3, 5, 4), (0, 2, 2), (0, 0, 0)),
          "on one axis": ((1, 2, "13/5"), (0, 0, 3), (0, 0, "3/2")),
          "two moments": ((2, 2, "13/5"), (1, 1, 3), (1, 0, "3/2"))}


def picture(inertia, c, rotor, **given):
    U = gs.general_potential(lambda *k: sum(Rational(x) * y for x, y in zip(c, k)))
    return draw_staude_plane(gs.assemble(gs.Gyrostat(inertia, rotor), U), ax=Figure().subplots(), **given)


@pytest.fixture(scope="module", params=["general", *slow(("two moments",), ("a plane",), ("on one axis",))])
def drawn(request):
    inertia, c, rotor = (np.array([float(Rational(x)) for x in v]) for v in BODIES[request.param])
    return picture(*BODIES[request.param]), inertia, c, rotor


def curves(ax, verdict):
    return [np.array(line.get_xydata()) for line in ax.lines
            if line.get_color() == LINES[verdict][0] and line.get_marker() == "None"]


def marked(ax, style):
    found = [line.get_xydata() for line in ax.lines if line.get_marker() == style["marker"]]
    return np.concatenate(found) if found else np.zeros((0, 2))


def inside(ax, points):
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    x, y = points.T
    return points[(x > left) & (x < right) & (y > low) & (y < high)]


def directions(inertia, c, rotor, omega, height):
    """k of (omega² I + sigma) k = c − omega l, of both signs where a component is free; None on a pole."""
    d, b = height + omega**2 * (inertia - np.median(inertia)), c - omega * rotor
    free = np.abs(d) < 1e-9 * (1 + omega**2)
    if not free.any():
        return [b / d]
    if not np.allclose(b[free], 0, atol=1e-9) or free.sum() > 1:
        return None
    k = np.divide(b, d, out=np.zeros(3), where=~free)
    part = np.sqrt(max(1 - k @ k, 0.0))
    return [np.where(free, side * part, k) for side in (1, -1)]


@pytest.mark.slow
def test_every_vertex_is_a_rotation_of_that_verdict(drawn):
    ax, inertia, c, rotor = drawn
    checked, changes = 0, marked(ax, CHANGE)
    for verdict in LINES:
        for omega, height in (point for curve in curves(ax, verdict) for point in inside(ax, curve)[::4]):
            k = (directions(inertia, c, rotor, omega, height) or [None])[0]
            if k is None or np.abs(changes - (omega, height)).max(1).min(initial=1) < 1e-6:
                continue
            assert abs(k @ k - 1) < 1e-6, (omega, height)
            found = heavy.verdict(np.diag(inertia), rotor, c, np.zeros((3, 3)), omega, k / np.linalg.norm(k))
            if found == "UNDECIDED":
                found = "STABLE"                           # by D4
            assert found in (None, verdict.upper()), (omega, height)
            checked += found is not None
    assert checked > 60


@pytest.mark.slow
def test_a_line_across_meets_every_rotation(drawn):
    """Those that Newton's method finds at a rate."""
    ax, inertia, c, rotor = drawn
    low, high = ax.get_ylim()
    for omega in np.linspace(*ax.get_xlim(), 7)[1:-1] + 0.013:
        data = np.diag(inertia), rotor, c, np.zeros((3, 3)), omega
        wanted = [k @ (c - omega * rotor) - omega**2 * k @ ((inertia - np.median(inertia)) * k)
                  for k in heavy.directions(*data, starts=60)]
        met = []
        for curve in (curve for verdict in LINES for curve in curves(ax, verdict)):
            x, y = curve.T
            for n in np.flatnonzero((x[1:] - omega) * (x[:-1] - omega) < 0):
                met.append(y[n] + (omega - x[n]) / (x[n + 1] - x[n]) * (y[n + 1] - y[n]))
        met = np.array([y for y in met if low < y < high])
        assert all(np.abs(met - y).min() < 0.02 * (high - low) for y in wanted), omega
        assert all(np.abs(np.array(wanted) - y).min() < 0.02 * (high - low) for y in met), omega


@pytest.mark.slow
def test_marks(drawn):
    """At rest k is ±c; at a fold two rotations of one side are gone on the other."""
    ax, inertia, c, rotor = drawn
    size = np.linalg.norm(c)
    assert np.allclose(sorted(marked(ax, REST).tolist()), [[0, -size], [0, size]])
    folds = marked(ax, FOLD)
    for omega, _ in folds[np.abs(np.diff(folds[:, 0], prepend=np.inf)) > 1e-9]:
        beside = [len(heavy.directions(np.diag(inertia), rotor, c, np.zeros((3, 3)), omega + side))
                  for side in (-1e-4, 1e-4)]
        assert abs(beside[0] - beside[1]) in (2, 4), omega


@pytest.mark.slow
def test_the_range_of_rates():
    ax = picture(*BODIES["general"], omega=("1/2", 3))
    assert ax.get_xlim() == (0.5, 3.0) and ax.get_ylabel().startswith(r"$\sigma + 2\,\omega^2$")
    assert len(marked(ax, FOLD)) == 4
    with pytest.raises(ValuesError, match="omega goes from 3 to 1: give the lower one first"):
        picture(*BODIES["general"], omega=(3, 1))
