"""gyrostat chart: pictures and data, axes, errors."""
import sys

import pytest
from commands import run
from slow import slow

SPINS = ["--potential", "m0*k3", "--equilibrium", "E1", "--x", "pi3_0=-4:4:40", "--y", "l=-2:2:30", "--set",
         "I1=1", "--set", "m0=1/3"]


def chart(capsys, *arguments):
    return run(capsys, *arguments, verb="chart")


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "start"), [("png", b"\x89PNG"), *slow(("pdf", b"%PDF"), ("svg", b"<?xml"))])
def test_a_chart_as_a_picture(capsys, tmp_path, kind, start):
    """The kind is that of the name; a file that is there is written again."""
    path = tmp_path / f"chart.{kind}"
    path.write_text("old")
    assert chart(capsys, *SPINS, "--output", str(path)) == (0, "", "")
    assert path.read_bytes().startswith(start) and path.stat().st_size > 5000


@pytest.mark.slow
def test_a_chart_as_data(capsys, tmp_path):
    """netCDF and Zarr hold the chart of the library at the numbers of the command line.

    A netCDF file is written again, a Zarr store is continued.
    """
    import numpy as np
    import xarray as xr

    import gyrostat as gs
    from gyrostat.charts.chart import stability_chart
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    wanted = stability_chart(top, x=("pi3_0", np.linspace(-4, 4, 40)), y=("l", np.linspace(-2, 2, 30)),
                             fixed={"I1": "1", "m0": "1/3"})
    for kind in ("nc", "nc", "zarr", "zarr"):
        path = str(tmp_path / f"chart.{kind}")
        assert chart(capsys, *SPINS, "--output", path) == (0, "", "")
        with xr.open_dataset(path) if kind == "nc" else xr.open_zarr(path, consolidated=False) as found:
            xr.testing.assert_identical(found.drop_vars("complete", errors="ignore").compute(), wanted)
    status, out, err = chart(capsys, *SPINS, "--axis", "I3=1:2:3", "--output", path)
    assert status == 2 and out == "" and "is the store of another chart" in err


@pytest.mark.parametrize(("arguments", "dims"), [
    (["--potential", "none", "--x", "omega3_0=0:1:3", "--y", "l=0:1:4", "--set", "I1=1", "--set", "I2=2",
      "--set", "I3=3"],
     ("l", "omega3_0")),
    (["--potential", "m0*k3", "--equilibrium", "E2", "--x", "omega3_0=0:1:3", "--y", "l=0:1:4", "--axis",
      "m0=-1:sqrt(2):2", "--axis",
      "I1=1:2:2", "--set", "I3=1"], ("m0", "I1", "l", "omega3_0")),
    (["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3", "--x", "l=0:1:3", "--y",
      "omega=1:2:4", "--set", "I1=2",
      "--set", "I3=1", "--set", "m0=1", "--set", "m1=1/4"], ("omega", "l"))])
def test_axes_of_a_chart(capsys, tmp_path, arguments, dims):
    """A free body; the other name of the spin, and further axes.

    E3 with its tilt eliminated, because l is an axis.
    """
    import xarray as xr
    assert chart(capsys, *arguments, "--output", str(tmp_path / "chart.nc")) == (0, "", "")
    with xr.open_dataset(tmp_path / "chart.nc") as found:
        assert found.verdict.dims == dims
        if "m0" in dims:
            assert found.m0.values.tolist() == [-1.0, 2**0.5]


@pytest.mark.parametrize(("arguments", "why"), [
    ([], "--output is missing, and a chart is written to a file: name a picture, chart.png, .pdf or .svg; "
         "data, chart.nc or chart.zarr"),
    (["--output", "chart.txt"], "has none of the suffixes"),
    (["--output", "missing/chart.png"], "cannot write"),
    (["--output", "missing/chart.zarr"], "cannot write"), (["--output", "missing/chart.nc"], "No such file"),
    (["--axis", "I3=1:2:3", "--output", "chart.png"], "a picture has two: write data instead"),
    (["--axis", "I3=1:2:1000000", "--output", "chart.nc"], "1200000000 points, and at most"),
    (["--x", "l=1:2:3", *["--output", "c.nc"]],
     "l is an axis twice"), (["--x", "pi3_0=1:2", "--output", "c.nc"], "NAME=LOW:HIGH:COUNT"),
    (["--x", "pi3_0=1:1:9", "--output", "c.nc"],
     "not strictly monotonic"), (["--x", "pi3_0=1:2:1", "--output", "c.nc"], "COUNT 1"),
    (["--x", "pi3_0=0:1:x", "--output", "c.nc"], "COUNT x"),
    (["--x", "pi3_0=0:__import__('os'):9", "--output", "c.nc"], "cannot read"),
    (["--set", "l=1", "--output", "c.nc"], "l is given twice"),
    (["--set", "mass=1", "--output", "c.nc"], "no parameter mass"),
    (["--set", "omega3_0=1", "--output", "c.nc"], "both"),
    (["--potential", "m0*k3**2 + m1*k3", "--output", "c.nc"], "E1 needs m1"),
    (["--potential", "none", "--output", "c.nc"], "is one in a field"),
    (["--backend", "numba", "--set", "I1=-1", "--output", "c.nc"], "I1 is given twice")])
def test_bad_charts_exit_2(capsys, tmp_path, monkeypatch, arguments, why):
    """A clear error on stderr, nothing on stdout, nothing written."""
    monkeypatch.chdir(tmp_path)
    status, out, err = chart(capsys, *SPINS, *arguments)
    assert status == 2
    assert out == ""
    assert err.startswith("gyrostat: ")
    assert why in err
    assert len(err.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_a_chart_names_its_equilibrium(capsys):
    """Without --equilibrium there is no chart of a body in a field."""
    status, _, err = chart(capsys, *SPINS[:2], *SPINS[4:], "--output", "chart.png")
    assert status == 2 and "no equilibrium is named" in err


@pytest.mark.parametrize(("missing", "kind", "extra"),
                         [("matplotlib", "png", "plot"), ("netCDF4", "nc", "charts"),
                                                        ("xarray", "zarr", "charts"),
                          ("zarr", "zarr", "charts")])
def test_missing_extras_are_named(capsys, tmp_path, monkeypatch, missing, kind, extra):
    """The pip command, exit status 2."""
    monkeypatch.setitem(sys.modules, missing, None)
    status, out, err = chart(capsys, *SPINS, "--output", str(tmp_path / f"chart.{kind}"))
    assert status == 2
    assert out == ""
    assert f'pip install "gyrostat[{extra}]"' in err
    assert list(tmp_path.iterdir()) == []


def test_all_that_a_picture_needs_is_named_at_once(capsys, tmp_path, monkeypatch):
    """Of both extras, with one command."""
    for missing in ("matplotlib", "xarray"):
        monkeypatch.setitem(sys.modules, missing, None)
    status, out, err = chart(capsys, *SPINS, "--output", str(tmp_path / "chart.png"))
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert "xarray" in err and "matplotlib" in err and 'pip install "gyrostat[charts,plot]"' in err


@pytest.mark.slow
def test_progress_of_a_picture(capsys, tmp_path, monkeypatch):
    """Of a chart in memory too, block by block, wiped at the end."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.signs.verdict_arrays.NUMPY_BLOCK", 3 * 40)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    status, out, err = chart(capsys, *SPINS, "--output", str(tmp_path / "chart.png"))
    assert status == 0 and out == "" and "verdicts     [" in err and err.endswith(" \r")
    shown = [line for line in err.split("\r") if "[" in line]
    assert len(shown) > 2 and "[" + "#" * 30 + "]" in shown[-1]


def test_progress_of_a_chart(capsys, tmp_path, monkeypatch):
    """A bar on a terminal, of the blocks of a store, wiped at the end."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.stores.chart_stores.POINTS", 3 * 40)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    status, out, err = chart(capsys, *SPINS, "--output", str(tmp_path / "chart.zarr"))
    assert status == 0 and out == "" and "chart        [" in err and "] 10/10" in err and err.endswith(" \r")


def test_e3_determines_what_is_neither_set_nor_an_axis(capsys, tmp_path):
    """With l and k3 given, the parameter of U that is open; a U with several tilts at one l is refused."""
    import numpy as np
    import xarray as xr

    import gyrostat as gs
    from gyrostat.charts.chart import stability_chart
    given = ["--potential", "m0*k3^4 - k3^2/2", "--equilibrium", "E3", "--x", "l=-2:2:9", "--y",
             "omega=-2:2:8", "--set", "I1=2", "I3=1"]
    assert chart(capsys, *given, "k3=1/2", "--output", str(tmp_path / "chart.nc")) == (0, "", "")
    scene = gs.assemble(gs.symmetric_gyrostat(),
                        gs.axial_potential(lambda k3: gs.symbol("m0") * k3**4 - k3**2 / 2))
    wanted = stability_chart(gs.analyze(gs.inclined(scene, eliminate="m0")), x=("l", np.linspace(-2, 2, 9)),
                             y=("omega", np.linspace(-2, 2, 8)), fixed={"I1": 2, "I3": 1, "k3": "1/2"})
    with xr.open_dataset(tmp_path / "chart.nc") as found:
        assert found.attrs["eliminated"] == "m0"
        np.testing.assert_array_equal(found.verdict, wanted.verdict)
        assert len(np.unique(found.verdict)) > 1
    status, out, err = chart(capsys, *given, "m0=1", "--output", str(tmp_path / "several.png"))
    assert (status, out) == (2, "") and not (tmp_path / "several.png").exists()
    assert "E3 may have several tilts k3 at one l and omega" in err and "give k3 instead of l = (" in err
