"""Charts and arrays of verdicts under internal damping: at every point what Report.verdict says."""
import random

import numpy as np
import pytest
import xarray as xr
from commands import run
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.charts import stability_chart, verdicts
from gyrostat.charts.codes import CODE_OF, INVALID, STABLE, UNDECIDED, UNSTABLE
from gyrostat.errors import GyrostatError, ValuesError
from gyrostat.stability.damping.secular import secular_of

a, l, w, m0, I1, I3, k3 = map(gs.symbol, ("a", "l", "w", "m0", "I1", "I3", "k3"))
TOP, ROTOR = gs.symmetric_gyrostat(), gs.Gyrostat(gyrostatic_momentum=(0, 0, l))
LYING = gs.assemble(gs.Gyrostat((I3, I1, I1), (l, 0, 0)), gs.general_potential(lambda k1, k2, k3: m0 * k1))
GENERAL = gs.assemble(ROTOR, gs.general_potential(lambda k1, k2, k3: a * k1 * k2 + k3))
SCENES = {
    "E1": gs.upright(gs.assemble(TOP, gs.axial_potential())),
    "E3": gs.inclined(gs.assemble(TOP, gs.axial_potential())),
    "E2, heavy": gs.hanging(gs.assemble(TOP, gs.uniform_field())),
    "E3, heavy": gs.inclined(gs.assemble(TOP, gs.uniform_field())),
    "E1, three moments": gs.upright(gs.assemble(ROTOR, gs.axial_potential())),
    "free": gs.principal_rotation(gs.assemble(ROTOR), 3),
    "claimed": gs.equilibrium(GENERAL, (0, 0, I3 * w, 0, 0, 1)),
    "axis 1": gs.equilibrium(LYING, (I3 * w, 0, 0, 1, 0, 0))}
SPIN = gs.analyze(gs.upright(gs.assemble(TOP, gs.uniform_field()), spin="omega3_0"))
HEAVY = {"I1": 1, "I3": "8/5", "m0": 1}


def drawn(rnd, name, size):
    """Few numbers, so that margins vanish, and the damping fails to reach every motion, at some points."""
    few = {"I": [0.5, 1, 1.5, 2], "k": [-0.75, 0, 0.5]}.get(name[0], [-2, -1, 0, 0.5, 1, 3])
    return np.array([rnd.choice(few) for _ in range(size)])


@pytest.mark.few(1)
@pytest.mark.parametrize("name", SCENES)
def test_arrays_are_what_verdicts_say(name):
    """Stable, unstable, undecided and where nothing is."""
    report, rnd = gs.analyze(SCENES[name]), random.Random(name)
    names = secular_of(report.equilibrium).required
    values = {n: drawn(rnd, n, 60) for n in names}
    found = verdicts(report, values, damped=True, invalid="mark")
    for point, code in zip(zip(*values.values()), found):
        try:
            wanted = CODE_OF[report.verdict(dict(zip(names, point)), damped=True).verdict]
        except GyrostatError:
            wanted = INVALID
        assert code == wanted, point
    assert {STABLE, UNSTABLE} <= set(found)


def test_undecided_where_the_damping_does_not_reach_every_motion():
    """U has no slope: P ω < 0 is stable for a free body, and not a minimum in a field."""
    found = verdicts(gs.analyze(SCENES["E1"]), I1=1.0, I3=2.0, dU=np.array([0.0, 1.0]), l=-3.0, pi3_0=2.0,
                     damped=True)
    assert list(found) == [UNDECIDED, UNSTABLE]


def test_names_that_tell_whether_damping_reaches_every_motion_may_be_left_out():
    """A vehicle on its side: m0 alone is required, and p0 tells where the energy is not least."""
    vehicle = gs.underwater_vehicle((1, 1, 1), (1, "3/2", 1), weight=(0, 0, m0))
    level = gs.analyze(gs.steady_motion(vehicle, (0, gs.symbol("p0"), 0), (0, 0, 1)))
    weights = np.array([1.0, 2.0, -1.0])
    assert level.secular.compared == ("m0",)
    assert list(verdicts(level, damped=True, m0=weights)) == [STABLE, STABLE, UNDECIDED]
    assert list(verdicts(level, damped=True, m0=weights, p0=1)) == [
        CODE_OF[level.verdict({"m0": weight, "p0": 1}, damped=True).verdict] for weight in weights]


@pytest.mark.slow
def test_a_chart_has_both(tmp_path):
    """The sleeping top is stable from 5/4 on, and under damping from 1/√0.6 on; a store has the same."""
    axes = {"x": ("omega3_0", np.linspace(1, 1.5, 41)), "y": ("l", np.array([0.0, 0.5]))}
    chart = stability_chart(SPIN, **axes, fixed=HEAVY, damped=True)
    spins = chart.omega3_0.values
    assert (chart.verdict.sel(l=0) == np.where(spins >= 1.25, STABLE, UNSTABLE)).all()
    assert (chart.damped.sel(l=0) == np.where(spins > 0.6**-0.5, STABLE, UNSTABLE)).all()
    assert chart.damped.attrs["long_name"] == "stability of E1 under internal damping"
    assert chart.damped.attrs["notion"] == "secular"
    stored = stability_chart(SPIN, **axes, fixed=HEAVY, damped=True, store=tmp_path / "chart.zarr")
    assert stored.damped.dtype == np.int8 and stored.damped.equals(chart.damped)
    assert "damped" not in stability_chart(SPIN, **axes, fixed=HEAVY)


@pytest.mark.slow
def test_the_picture_shows_what_damping_destroys(capsys, tmp_path):
    """An area of its own, with its name; the same from the command line, and as data."""
    axes = {"x": ("omega3_0", np.linspace(1, 1.5, 41)), "y": ("l", np.array([-0.1, 0.0, 0.1]))}
    plain, both = (gs.plotting.draw_chart(stability_chart(SPIN, **axes, fixed=HEAVY, damped=damped),
                                          Figure().subplots()) for damped in (False, True))
    assert said(both) == ["stable", "unstable", "destroyed by internal damping", "boundary"]
    assert said(plain) == ["stable", "unstable", "boundary"]
    (area,) = both.collections
    inside = [any(path.contains_point((spin, 0)) for path in area.get_paths()) for spin in (1.2, 1.27, 1.35)]
    assert inside == [False, True, False] and not plain.collections
    path = tmp_path / "chart.nc"
    command = ["--potential", "m0*k3", "--equilibrium", "E1", "--x", "omega3_0=1:3/2:41", "--y", "l=0:1/2:2",
               "--set", "I1=1", "I3=1.6", "m0=1", "--damped", "--output"]
    assert run(capsys, *command, str(path), verb="chart") == (0, "", "")
    with xr.open_dataset(path) as found:
        assert (found.damped.sel(l=0) == np.where(found.omega3_0 > 0.6**-0.5, STABLE, UNSTABLE)).all()


def said(axes):
    return [text.get_text() for text in axes.get_legend().get_texts()]


def test_the_names_are_those_of_both():
    """I3 is none of the verdict of E1 in pi3_0."""
    with pytest.raises(ValuesError, match="needs I3"):
        stability_chart(gs.analyze(SCENES["E1"]), x=("pi3_0", [1, 2]), y=("l", [0, 1]),
                        fixed={"I1": 1, "dU": 1}, damped=True)
