"""Charts of what a stable point survives: against wells that are found by paths, and the picture itself."""
import math
from fractions import Fraction

import numpy as np
import pytest
import xarray as xr
from commands import run
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.charts import stability_chart, with_barriers
from gyrostat.charts.codes import STABLE
from gyrostat.errors import ScopeError, ValuesError

WHEEL = gs.Gyrostat(("I1", "I2", "I3"), (0, "l", 0))
SATELLITE = gs.analyze(gs.earth_pointing(gs.assemble(WHEEL, gs.circular_orbit())))
ROTOR = gs.assemble(gs.Gyrostat(("I1", "I2", "I3"), (0, 0, "l")))
FREE = gs.analyze(gs.principal_rotation(ROTOR, 3))
ORBITS = ["--orbit", "omega0", "--inertia", "60,70,35", "--gyrostatic-momentum=0,l,0", "--equilibrium",
          "earth-pointing", "--x", "l=-20:80:20", "--y", "omega0=1/10:2:15", "--well"]


def layered(report, x, y, fixed):
    return with_barriers(stability_chart(report, x=x, y=y, fixed=fixed), report)


def by_paths(scene, values, place):
    """The well of the equilibrium at a place of all that a scene has, found without a closed form."""
    found = gs.relative_equilibria(scene, values)
    [e] = [e for e in found if all(abs(e.doubles.place[n] - x) < 1e-12 for n, x in place.items())]
    return e.well


@pytest.mark.few(2)
@pytest.mark.parametrize("moments", [(60, 70, 35), (70, 60, 35), (5, 4, 2), (35, 70, 60), (35, 60, 70)])
def test_satellites(moments):
    """The barrier and the kick of the attitude in the list of all; NaN where no minimum holds it."""
    l, rate = [-30, -10, -2, 0, 7, 20, 100], [0.5, 1]
    chart = layered(SATELLITE, ("l", l), ("omega0", rate), dict(zip(("I1", "I2", "I3"), moments)))
    for n, w in enumerate(rate):
        for m, rotor in enumerate(l):
            scene = gs.assemble(gs.Gyrostat(moments, (0, rotor, 0)), gs.circular_orbit(w))
            place = {"n1": 0, "n2": 1, "n3": 0, "r1": 0, "r2": 0, "r3": 1}
            well = by_paths(scene, {}, place)
            barrier, kick = float(chart.barrier[n, m]), float(chart.kick[n, m])
            if well.bound is not None:                     # the pass itself is degenerate
                assert barrier == pytest.approx(well.bound, rel=1e-14)
            elif well.barrier_double is None:
                assert math.isnan(barrier) and math.isnan(kick)
            elif not math.isnan(barrier) or well.rotation.form.index == 0 and moments[2] < min(moments[:2]):
                assert barrier == pytest.approx(well.barrier_double, rel=1e-14)
                assert kick == pytest.approx(well.kick(), rel=1e-14)
    stable = chart.verdict == STABLE
    assert not np.isfinite(chart.barrier.values[~stable.values]).any()
    assert np.isfinite(chart.barrier.values).any() == (moments[2] < min(moments[:2]))


@pytest.mark.few(1)
@pytest.mark.parametrize("moments", [(1, 2, 3), (3, 2, 1), (1, 3, 2), (2, 3, "5/2")])
def test_free_gyrostats(moments):
    """Rotations about the axis of the rotor, least and greatest energies: barriers of the list of all."""
    rates, rotors = [-2.0, 0.5, 1.0], [-1.5, 0.25, 0.75]
    fixed = dict(zip(("I1", "I2", "I3"), moments))
    chart = layered(FREE, ("omega3_0", rates), ("l", rotors), fixed)
    compared = 0
    for n, l in enumerate(rotors):
        for m, rate in enumerate(rates):
            spin = Fraction(moments[2]) * Fraction(rate)
            barrier, M = float(chart.barrier[n, m]), spin + Fraction(l)
            if M:
                scene = gs.assemble(gs.Gyrostat(moments, (0, 0, l)))
                well = by_paths(scene, {"M": abs(M)}, {"pi1": 0, "pi2": 0, "pi3": float(spin)})
                assert math.isnan(barrier) == (well.barrier_double is None)
                if not math.isnan(barrier):
                    assert barrier == pytest.approx(well.barrier_double, rel=1e-13)
                    compared += 1
    assert compared or moments == (1, 3, 2)
    assert chart.barrier.attrs["units"] == "kg m2 s-2" and chart.kick.attrs["units"] == "kg m2 s-1"


def test_contours_of_the_kick():
    """On each contour the kick is its number, by the formula of the theory, written out here."""
    chart = layered(SATELLITE, ("l", np.linspace(-20, 80, 201)), ("omega0", np.linspace(0.1, 2, 201)),
                    {"I1": 60, "I2": 70, "I3": 35})
    ax = gs.plotting.draw_chart(chart, Figure().subplots(), si=True)
    [lines] = [c for c in ax.collections if hasattr(c, "levels") and len(c.levels) > 3]
    seen = 0
    for level, path in zip(lines.levels, lines.get_paths()):
        l, w = path.vertices.T
        yaw = np.where(np.abs(l) < 10 * w, (10 * w + l)**2 / 20, 2 * w * l)
        kick = np.sqrt(70 * np.minimum(yaw, 1.5 * w**2 * 25))
        seen += len(l)
        assert np.allclose(kick, level, rtol=0.01)
    assert seen > 100
    assert "safe kick [N m s]" in [t.get_text() for t in ax.get_legend().get_texts()]
    plain = gs.plotting.draw_chart(chart.drop_vars("kick"), Figure().subplots())
    assert any(t.get_text().startswith("safe barrier $[") for t in plain.get_legend().get_texts())


def test_what_has_no_such_layer():
    """A top, whose formula has a root in it; a chart of another equilibrium; no chart."""
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    chart = stability_chart(top, x=("pi3_0", [0, 3]), y=("l", [0, 1]), fixed={"I1": 1, "m0": 1})
    with pytest.raises(ScopeError, match="root"):
        with_barriers(chart, top)
    with pytest.raises(ValuesError, match="Earth-pointing"):
        with_barriers(chart, SATELLITE)


@pytest.mark.slow
def test_on_the_command_line(capsys, tmp_path):
    """Data and a picture; not a store, which is written block by block."""
    data, picture = tmp_path / "chart.nc", tmp_path / "chart.png"
    assert run(capsys, *ORBITS, "--output", str(data), verb="chart")[0] == 0
    with xr.open_dataset(data) as chart:
        assert float(chart.barrier.max()) == pytest.approx(150) and chart.kick.dims == ("omega0", "l")
    assert run(capsys, *ORBITS, "--output", str(picture), verb="chart") == (0, "", "")
    assert picture.stat().st_size > 5000
    status, _, err = run(capsys, *ORBITS, "--output", str(tmp_path / "chart.zarr"), verb="chart")
    assert status == 2 and "block by block" in err
