"""Charts: what every point says, names, units, attributes; what is refused."""
import sys
from fractions import Fraction

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import exp

import gyrostat as gs
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.codes import FLAGS
from gyrostat.charts.datasets import coordinate_attributes
from gyrostat.errors import ArgumentError, MissingExtraError, ValuesError

BODY = {"I1": 2, "I3": "1/3"}


def report(family, field, **options):
    return gs.analyze(family(gs.assemble(gs.symmetric_gyrostat(), field), **options))


@pytest.fixture(scope="module")
def scenes(e1, e3, upright_asymmetric, free):
    """Reports with two names to vary and the numbers of the others."""
    newton = report(gs.inclined, gs.newtonian_field(2), eliminate="k3")
    exponential = report(gs.inclined, gs.axial_potential(lambda k3: gs.symbol("a") * exp(k3)))
    return [
        (e1, ("pi3_0", "l"), {"I1": "1/3", "dU": Fraction(3, 4)}),
        (e1, ("dU", "I1"), {"pi3_0": 1, "l": 0.5, "d2U": -1}),
        (report(gs.hanging, gs.uniform_field(), spin="omega3_0"), ("m0", "omega3_0"), {**BODY, "l": 1}),
        (e3, ("k3", "d2U"), {**BODY, "l": "0.25", "omega": 1}),
        (newton, ("l", "omega"), {"I1": 2, "I3": 1, "m0": 1, "m1": "1/3"}),
        (exponential, ("k3", "a"), {**BODY, "omega": 1}),
        (upright_asymmetric, ("m0", "l"), {"I1": 2, "I2": "3/2", "I3": 1, "m1": "1/4", "pi3_0": 1}),
        (gs.analyze(gs.principal_rotation(free, 3)), ("omega3_0", "l"), {"I1": 1, "I2": 2, "I3": 3})]


axis = st.lists(st.integers(-16, 16), min_size=2, max_size=6,
                unique=True).map(lambda numbers: np.sort(np.array(numbers)) / 8)


def said(report, numbers):
    """What a verdict says there, in the code of a chart."""
    try:
        return FLAGS[report.verdict(numbers).verdict.name.lower()]
    except ValuesError:
        return FLAGS["no_equilibrium"]


@pytest.mark.slow
@pytest.mark.parametrize("case", range(8))
@given(xs=axis, ys=axis, offset=st.sampled_from([0, 0.1]), flip=st.booleans())
@settings(max_examples=5)
def test_every_point_is_the_verdict_there(scenes, case, xs, ys, offset, flip):
    """The chart is Report.verdict at the exact numbers of its coordinates.

    On boundaries, off the family, on axes of either direction.
    """
    report, (x, y), fixed = scenes[case]
    if "l" in report.required and "l" not in (x, y, *fixed):
        fixed = {**fixed, "l": 1}
    xs, ys = (np.unique(abs(v) + 1 / 8) if gs.symbol(n).is_positive else v
              for n, v in ((x, xs + offset), (y, ys)))
    xs = xs[::-1] if flip else xs
    chart = stability_chart(report, x=(x, xs), y=(y, ys),
                            fixed={n: v for n, v in fixed.items() if n in report.parameters or n == "d2U"})
    assert chart.verdict.dtype == np.int8 and chart.verdict.dims == (y, x)
    for i, j in np.ndindex(chart.verdict.shape):
        point = {n: c.attrs["exact"] for n, c in chart.coords.items()
                 if c.ndim == 0} | {x: Fraction(xs[j]), y: Fraction(ys[i])}
        assert int(chart.verdict[i, j]) == said(report, point), point


@pytest.mark.slow
def test_the_examples_reach_every_answer(scenes):
    """All four codes occur in these scenes."""
    found = set()
    for report, (x, y), fixed in scenes:
        grids = {n: np.linspace(1 / 8 if gs.symbol(n).is_positive else -2, 2, 9) for n in (x, y)}
        fixed = {n: v for n, v in fixed.items() if n in report.parameters or n == "d2U"}
        found |= set(np.unique(stability_chart(report, x=(x, grids[x]), y=(y, grids[y]),
                                               fixed=fixed).verdict))
    assert found == set(FLAGS.values())


def test_coordinates_are_exact_and_explained(e1):
    """Axes keep every bit; a fixed number is a scalar with the text it was given as.

    Meaning, units and LaTeX from the notation.
    """
    xs = np.array([0.1, 0.1 + 2**-56, 1 / 3])
    chart = stability_chart(e1, x=("pi3_0", xs), y=("l", [3, 2, -1]), fixed={"I1": "1/3", "dU": 0.1})
    assert chart.pi3_0.values.tobytes() == xs.tobytes() and chart.l.values.tolist() == [3, 2, -1]
    assert chart.I1.item() == 1 / 3 and chart.I1.attrs["exact"] == "1/3"
    assert Fraction(chart.dU.attrs["exact"]) == Fraction(0.1) and chart.dU.item() == 0.1
    assert chart.pi3_0.attrs == {"long_name": "π3 at the equilibrium", "latex": r"\pi_3^0",
                                 "units": "kg m2 s-1"}
    assert chart.attrs == {"Conventions": "CF-1.11", "title": "Stability of E1", "equilibrium": "E1",
                           "potential": "U(k3)",
                           "gyrostat_version": gs.__version__}
    flags = dict(zip(chart.verdict.attrs["flag_meanings"].split(),
                     chart.verdict.attrs["flag_values"].tolist()))
    assert flags == {"unstable": -1, "undecided": 0, "stable": 1, "no_equilibrium": -2}
    assert chart.verdict.attrs["flag_values"].dtype == np.int8
    assert chart.verdict.attrs["notion"].startswith("Lyapunov where stable")
    assert "modulo" not in chart.verdict.attrs


def test_the_family_is_explained(scenes):
    """The relation, what it eliminates, and modulo what the verdict is."""
    chart = stability_chart(scenes[3][0], x=("k3", [0, 0.5]), y=("d2U", [0, 1]), fixed=scenes[3][2])
    assert chart.attrs["eliminated"] == "dU" and chart.attrs["relations"].startswith("dU = ")
    assert chart.verdict.attrs["modulo"] == "the flow of pi3" and chart.d2U.attrs["latex"] == "U''(k_3)"
    assert (
        stability_chart(scenes[7][0], x=("l", [0, 1]), y=("omega3_0", [0, 1]), fixed=scenes[7][2]).attrs[
            "potential"
        ]
        == "none"
    )


@pytest.mark.parametrize(("name", "units"), [
    ("I1", "kg m2"), ("l", "kg m2 s-1"), ("m0", "kg m2 s-2"), ("m1", "s-2"), ("omega", "s-1"), ("k3", "1"),
    ("r", "m"), ("J4", "kg m4"),
    ("p0", "kg m s-1"), ("mass1", "kg"), ("d2U", "kg m2 s-2"), ("d7U", "kg m2 s-2"), ("height", None)])
def test_units(e1, name, units):
    """[M L²]ᵃ [T]⁻ᵇ [L]ᶜ in SI; a parameter of one's own has none that is known."""
    assert coordinate_attributes(name, e1.equilibrium).get("units") == units


def test_further_axes(e1):
    """A chart of four axes is one chart of two for each pair of the others; it has no boundary."""
    xs, ys, I1, dU = np.linspace(-3, 3, 7), np.linspace(-2, 2, 5), [0.5, 1.0], [2.0, 1.0, -1.0]
    chart = stability_chart(e1, x=("pi3_0", xs), y=("l", ys), axes={"I1": I1, "dU": dU})
    assert chart.verdict.dims == ("I1", "dU", "l", "pi3_0") and "boundary_x" not in chart
    for i, inertia in enumerate(I1):
        for j, slope in enumerate(dU):
            one = stability_chart(e1, x=("pi3_0", xs), y=("l", ys), fixed={"I1": inertia, "dU": slope})
            assert (one.verdict.values == chart.verdict.values[i, j]).all() and "boundary_x" in one


def test_one_value_makes_an_axis(e1):
    """An axis of one value has no boundary across it."""
    chart = stability_chart(e1, x=("pi3_0", [1.0]), y=("l", np.linspace(-3, 3, 9)), fixed={"I1": 1, "dU": 1})
    assert chart.verdict.shape == (9, 1) and "boundary_x" not in chart


def test_margins_on_request(upright_asymmetric):
    """Each distinct margin once, its values, its formula."""
    report = upright_asymmetric
    fixed = {"I1": 2, "I2": "3/2", "I3": 1, "m1": "1/4", "pi3_0": 1}
    chart = stability_chart(report, x=("m0", [-1.0, 0.5]), y=("l", [0.25, 2.0, 3.0]), fixed=fixed,
                            margins=True)
    names = [name for name in chart if name.startswith("margin_")]
    assert (
        len(names)
        == len({c.margin for k in (report.necessary, report.sufficient) for a in k.alternatives for c in a})
        > 1
    )
    decision = report.verdict({**fixed, "m0": 0.5, "l": 3})
    for margin, value in decision.margins:
        (name,) = (n for n in names if chart[n].attrs["long_name"] == str(margin))
        assert chart[name].sel(m0=0.5, l=3).item() == pytest.approx(float(value), rel=1e-12)
        assert chart[name].dims == ("l", "m0")
        assert "I_1" in chart[name].attrs["latex"] or "I_2" in chart[name].attrs["latex"]


GOOD = {"x": ("pi3_0", [0, 1]), "y": ("l", [0, 1]), "fixed": {"I1": 1, "dU": 1}}


@pytest.mark.parametrize(("changed", "why"), [
    ({"x": ("pi3_0", [0, 1, 1, 2])}, "1.0 is followed by 1.0 at index 2"),
    ({"x": ("pi3_0", [0, 2, 1])}, "2.0 is followed by 1.0 at index 2"),
    ({"x": ("pi3_0", [3, 2, 2.5])}, "at index 2"), ({"x": ("pi3_0", [1, 1, 2])}, "at index 1"),
    ({"x": ("pi3_0", [0, float("nan")])}, "value 1 of pi3_0 is nan"),
    ({"x": ("pi3_0", [float("inf"), 1])}, "value 0 of pi3_0 is inf"),
    ({"x": ("pi3_0", [[0, 1]])}, r"shape \(1, 2\)"), ({"x": ("pi3_0", [])}, r"shape \(0,\)"),
    ({"x": ("pi3_0", 1.0)}, r"shape \(\)"),
    ({"x": ("pi3_0", ["0", "1"])}, "not real numbers"), ({"x": ("pi3_0", [0, 1j])}, "not real numbers"),
    ({"x": ("pi3_0", [0, object()])}, "not real numbers"),
    ({"x": ("pi3_0", [True, False])}, "not real numbers"),
    ({"x": ("pi3", [0, 1])}, "no parameter pi3: did you mean pi3_0"),
    ({"x": ("l", [0, 1])}, "l is given twice"),
    ({"fixed": {"I1": 1, "dU": 1, "l": 1}}, "l is given twice"), ({"fixed": {"I1": 1}}, "E1 needs dU"),
    ({"axes": {"I1": [1, 2]}}, "I1 is given twice"),
    ({"fixed": {"I1": 0, "dU": 1}}, "I1 = 0, but it must be positive"),
    ({"x": ("I1", np.linspace(-2, 2, 4)), "fixed": {"pi3_0": 1, "dU": 1}},
     "value 0 of I1 is -2.0, but I1 must be positive: give an axis"),
    ({"axes": {"I1": [1, 0]}, "fixed": {"dU": 1}}, "value 1 of I1 is 0.0, but I1 must be positive"),
    ({"x": ("pi3_0", np.ma.array([0, 1], mask=[0, 1]))}, r"pi3_0\[1\] is masked"),
    ({"fixed": {"I1": "x", "dU": 1}}, "I1"), ({"store": "chart.nc"}, "call it chart.zarr")])
def test_what_is_refused(e1, changed, why):
    """What was given, why that is impossible, what to do."""
    with pytest.raises(ValuesError, match=why):
        stability_chart(e1, **{**GOOD, **changed})


def test_names_that_cannot_be_axes(e3):
    """The eliminated name, and a parameter that has the name of a variable of the dataset."""
    with pytest.raises(ValuesError, match="dU follows from the other names on E3, dU = .*: omit it"):
        stability_chart(e3, x=("dU", [0, 1]), y=("k3", [0, 0.5]),
                        fixed={"I1": 1, "I3": 1, "l": 1, "omega": 1, "d2U": 1})
    own = report(gs.upright, gs.axial_potential(lambda k3: gs.symbol("vertex") * k3))
    with pytest.raises(ValuesError, match="vertex is a name of the dataset itself"):
        stability_chart(own, x=("vertex", [0, 1]), y=("l", [0, 1]), fixed={"I1": 1, "pi3_0": 1})


def test_arguments_of_another_kind(e1):
    """A pair is a tuple of a name and values; the report comes first; a backend is one that there is."""
    for changed in ({"x": ["pi3_0", [0, 1]]}, {"x": ("pi3_0",)}, {"x": (gs.symbol("l"), [0, 1])},
                    {"backend": "fortran"}):
        with pytest.raises(ArgumentError):
            stability_chart(e1, **{**GOOD, **changed})
    with pytest.raises(ArgumentError, match="the report is an Equilibrium"):
        stability_chart(e1.equilibrium, **GOOD)


def test_a_missing_extra_is_named(e1, monkeypatch):
    """The message has the pip command, and is an ImportError too."""
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(MissingExtraError,
                       match=r"xarray cannot be imported.*pip install \"gyrostat\[charts\]\"") as error:
        stability_chart(e1, x=("pi3_0", [0, 5]), y=("l", [0, 1]), fixed={"I1": 1, "dU": 1})
    assert isinstance(error.value, ImportError)


@pytest.mark.parametrize("slope", [1, -1])
def test_netcdf_keeps_everything(e1, tmp_path, slope):
    """Values, coordinates, attributes, and a boundary without a point."""
    chart = stability_chart(e1, x=("pi3_0", np.linspace(-3, 3, 31)), y=("l", np.linspace(2, -2, 21)),
                            fixed={"I1": "1/3", "dU": slope},
                            margins=True)
    assert (chart.vertex.size == 0) == (slope < 0)
    chart.to_netcdf(tmp_path / "chart.nc", engine="netcdf4")
    with xr.open_dataset(tmp_path / "chart.nc") as back:
        xr.testing.assert_identical(back.load(), chart)
        assert back.verdict.dtype == np.int8 and back.verdict.attrs["flag_values"].dtype == np.int8
        assert back.pi3_0.values.tobytes() == chart.pi3_0.values.tobytes()


def test_threads_make_no_difference(e1):
    """The same chart from several threads."""
    grid = {"x": ("pi3_0", np.linspace(-3, 3, 700)), "y": ("l", np.linspace(-2, 2, 500)),
            "fixed": {"I1": 1, "dU": 1}, "margins": True}
    xr.testing.assert_identical(stability_chart(e1, **grid), stability_chart(e1, **grid, threads=3))
