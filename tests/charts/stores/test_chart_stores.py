"""Charts in a store: the same as in memory; pickled reports."""
import json
import os
import pickle
import subprocess
import sys
from io import StringIO
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from charts.stored_charts import GRID, contents
from sympy import exp

import gyrostat as gs
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.stores import chart_stores, store_frame
from gyrostat.errors import MissingExtraError, StoreError


@pytest.mark.slow
@pytest.mark.parametrize("margins", [False, True])
def test_a_store_is_the_chart_in_memory(e1, monkeypatch, tmp_path, margins):
    """Values, coordinates, attributes, boundary; lazily, for whoever opens it; every block is counted."""
    monkeypatch.setattr(chart_stores, "POINTS", 7 * 90 * (8 if margins else 1))
    seen = []
    memory = stability_chart(e1, **GRID, margins=margins)
    chart = stability_chart(e1, **GRID, margins=margins, store=tmp_path / "chart.zarr", threads=2,
                            progress=lambda *n: seen.append(n))
    assert chart.verdict.chunks is not None and chart.verdict.dtype == np.int8
    xr.testing.assert_identical(chart.compute(), memory)
    xr.testing.assert_identical(xr.open_zarr(tmp_path / "chart.zarr",
                                             consolidated=False).drop_vars("complete").compute(), memory)
    assert seen == [(n, 10) for n in range(1, 11)]
    chart.drop_encoding().to_netcdf(tmp_path / "chart.nc", engine="netcdf4")
    with xr.open_dataset(tmp_path / "chart.nc") as back:
        xr.testing.assert_identical(back.compute(), memory)


@pytest.mark.slow
def test_further_axes_and_a_chart_without_a_boundary(e1, ten_blocks, tmp_path):
    """Three axes, blocks of one plane or several; and a curve without a point."""
    grid = {**GRID, "fixed": {"I1": 1}, "axes": {"dU": [-1.0, 0.5, 1.0]}}
    xr.testing.assert_identical(stability_chart(e1, **grid, store=tmp_path / "three.zarr").compute(),
                                stability_chart(e1, **grid))
    grid = {**GRID, "fixed": {"I1": 1, "dU": -1}}
    xr.testing.assert_identical(stability_chart(e1, **grid, store=tmp_path / "none.zarr").compute(),
                                stability_chart(e1, **grid))


@pytest.mark.parametrize(("shape", "points", "block"), [
    ((70, 90), 630, (7, 90)), ((70, 90), 10**6, (70, 90)), ((70, 90), 40, (1, 40)),
    ((5, 70, 90), 70 * 90 * 2 + 5, (2, 70, 90)),
    ((5, 70, 90), 100, (1, 1, 90)), ((31623, 31623), 2**22, (132, 31623))])
def test_blocks_are_whole_rows(shape, points, block):
    """As many whole rows as there are points for, then whole planes."""
    assert store_frame.Frame(Path(), None, tuple(map(np.empty, shape)), points).block == block


@pytest.mark.slow
def test_another_chart_is_refused(e1, e2, store, tmp_path, monkeypatch):
    """Another report, axes, number, request, size of block or format; nothing of the store changes."""
    before = contents(store)
    xs = GRID["x"][1]
    for changed, why in (({"fixed": {"I1": "0.333", "dU": 1}}, "value of I1"),
                         ({"margins": True}, "margins, block"),
                         ({"x": ("pi3_0", np.nextafter(xs, 9))}, "values of pi3_0"),
                         ({"x": ("pi3_0", xs[::-1])}, "values of pi3_0"),
                         ({"x": GRID["y"], "y": GRID["x"]}, "axes")):
        with pytest.raises(StoreError,
                           match=f"is the store of another chart, they differ in {why}.*: give another "
                                 "path, or remove it"):
            stability_chart(e1, **{**GRID, **changed}, store=store)
    with pytest.raises(StoreError, match="differ in equilibrium"):
        stability_chart(e2, **GRID, store=store)
    grid = {**GRID, "fixed": {"I1": 1, "m0": 1}}
    fields = [gs.axial_potential(lambda k3, n=n: gs.symbol("m0") * k3**n) for n in (1, 3)]
    one, other = (gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), field))) for field in fields)
    stability_chart(one, **grid, store=tmp_path / "field.zarr")
    with pytest.raises(StoreError, match="differ in equilibrium:"):
        stability_chart(other, **grid, store=tmp_path / "field.zarr")
    monkeypatch.setattr(chart_stores, "POINTS", 9 * 90)
    with pytest.raises(StoreError, match="differ in block"):
        stability_chart(e1, **GRID, store=store)
    monkeypatch.setattr(chart_stores, "POINTS", 7 * 90)
    monkeypatch.setattr(store_frame, "STORE_FORMAT", 3)
    with pytest.raises(StoreError, match="differ in format"):
        stability_chart(e1, **GRID, store=store)
    assert contents(store) == before


@pytest.mark.slow
def test_what_is_no_store_is_left_alone(e1, tmp_path):
    """A file, a folder of something else, a store of something else; a folder that does not exist."""
    (tmp_path / "file.zarr").write_text("mine")
    (tmp_path / "folder.zarr").mkdir()
    xr.Dataset({"complete": ("n", [1, 2])}).to_zarr(tmp_path / "other.zarr", zarr_format=3,
                                                    consolidated=False)
    before = contents(tmp_path)
    for name in ("file.zarr", "folder.zarr", "other.zarr"):
        with pytest.raises(StoreError, match=f"{name} exists and is no store of a chart"):
            stability_chart(e1, **GRID, store=tmp_path / name)
    with pytest.raises(StoreError, match="there is no folder .*missing for the store: make it"):
        stability_chart(e1, **GRID, store=tmp_path / "missing" / "chart.zarr")
    assert contents(tmp_path) == before and not (tmp_path / "missing").exists()


@pytest.mark.slow
def test_a_store_is_moved_into_place_whole(e1, ten_blocks, memory, tmp_path, monkeypatch):
    """What interrupts its making leaves nothing.

    Where another process was first, its store is the one that is filled.
    """
    path = tmp_path / "chart.zarr"

    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(store_frame.os, "rename", interrupted)
        with pytest.raises(KeyboardInterrupt):
            stability_chart(e1, **GRID, store=path)
    assert list(tmp_path.iterdir()) == []
    rename = os.rename

    def second(new, place):
        if not place.exists():
            stability_chart(e1, **GRID, store=tmp_path / "first.zarr")
            rename(tmp_path / "first.zarr", place)
        rename(new, place)

    monkeypatch.setattr(store_frame.os, "rename",
                        lambda new, place: (second if place == path else rename)(new, place))
    xr.testing.assert_identical(stability_chart(e1, **GRID, store=path).compute(), memory)
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.slow
def test_progress_on_a_terminal(e1, ten_blocks, tmp_path, capsys, monkeypatch):
    """A bar on standard error, wiped at the end; none where it is not wanted, or there is no terminal."""
    stability_chart(e1, **GRID, store=tmp_path / "quiet.zarr")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    stability_chart(e1, **GRID, store=tmp_path / "silent.zarr", progress=False)
    assert capsys.readouterr() == ("", "")
    stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    out, err = capsys.readouterr()
    assert out == "" and "] 10/10" in err and err.endswith(" \r")


def test_progress_waits_some_seconds(e1, ten_blocks, tmp_path, capsys, monkeypatch):
    """What is done sooner says nothing."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 1e6)
    stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert capsys.readouterr() == ("", "")


def test_progress_in_a_notebook(e1, capsys, monkeypatch):
    """Below the cell, of a chart in memory."""
    class OutStream(StringIO):
        __module__ = "ipykernel.iostream"

    monkeypatch.setattr(sys, "stderr", cell := OutStream())
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    stability_chart(e1, **GRID)
    assert "verdicts     [" in cell.getvalue() and cell.getvalue().endswith(" \r")


@pytest.mark.parametrize("missing", ["zarr", "dask"])
def test_a_missing_extra_is_named(e1, tmp_path, monkeypatch, missing):
    """Before anything is written."""
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(MissingExtraError, match=rf"{missing} cannot be imported.*gyrostat\[charts\]"):
        stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert list(tmp_path.iterdir()) == []


def test_a_store_says_what_it_is_of(store):
    """What is compared is in the attributes of complete, and does not depend on the process."""
    own = json.loads(xr.open_zarr(store, consolidated=False).complete.attrs["chart"])
    assert own["axes"] == ["l", "pi3_0"]
    assert own["value of I1"] == "1/3"
    assert own["format"] == store_frame.STORE_FORMAT
    assert own["block"] == [7, 90]


FIELDS = [gs.axial_potential(), gs.uniform_field(), gs.axial_potential(lambda k3: gs.symbol("a") * exp(k3)),
          gs.newtonian_field(3),
          gs.general_potential(), None]


@pytest.mark.slow
def test_a_report_is_pickled_with_what_its_verdicts_need():
    """In this process and in another, before and after it was used; the conditions are the same."""
    used, texts = [], []
    for field in FIELDS:
        body = (
            gs.symmetric_gyrostat()
            if field is None or field.axial
            else gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l")))
        )
        scene = gs.assemble(body, field)
        eq = (gs.principal_rotation(scene, 3) if field is None else gs.upright(scene) if field.axial
              else gs.equilibrium(
            scene, (0, 0, gs.symbol("pi3_0"), 0, 0, 1),
            relations=((gs.symbol("dU_1"), 0), (gs.symbol("dU_2"), 0))))
        report = gs.analyze(eq)
        fresh = pickle.dumps(report)
        wanted = report.necessary, report.sufficient, report.boundary, report.required, report.parameters
        used.append(pickle.dumps(report))
        texts.append(f"{report.necessary.alternatives} {report.required}")
        for data in (fresh, used[-1]):
            again = pickle.loads(data)
            assert again == report
            assert (
                again.necessary,
                again.sufficient,
                again.boundary,
                again.required,
                again.parameters,
            ) == wanted
    code = """import pickle, sys
for text in sys.argv[1:]:
    report = pickle.loads(bytes.fromhex(text))
    print(report.necessary.alternatives, report.required)"""
    run = subprocess.run([sys.executable, "-c", code, *(data.hex() for data in used)], capture_output=True,
                         text=True, check=True)
    assert run.stdout.splitlines() == texts
