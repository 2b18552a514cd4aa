"""Charts in a store: the same as in memory, continued after a kill, on a cluster, in little memory.

Pickled reports.
"""
import errno
import json
import os
import pickle
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from sympy import exp

import gyrostat as gs
from gyrostat.charts import frame, marks, stores
from gyrostat.charts.chart import stability_chart
from gyrostat.errors import MissingExtraError, StoreError

GRID = {"x": ("pi3_0", np.linspace(-4, 4, 90)), "y": ("l", np.linspace(-2, 2, 70)),
        "fixed": {"I1": "1/3", "dU": 1}}
SCRIPT = """
import os, signal, sys
import numpy as np
import gyrostat as gs
from gyrostat.charts import stores
from gyrostat.charts.chart import stability_chart
report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
grid = {"x": ("pi3_0", np.linspace(-4, 4, 90)), "y": ("l", np.linspace(-2, 2, 70)),
        "fixed": {"I1": "1/3", "dU": 1}}
"""


@pytest.fixture
def small(monkeypatch):
    """Blocks of seven rows: ten of them."""
    monkeypatch.setattr(stores, "POINTS", 7 * 90)


@pytest.fixture
def written(monkeypatch):
    """The numbers of the blocks that are computed in this process."""
    numbers, write = [], stores.write_block
    monkeypatch.setattr(stores, "write_block", lambda marks, chart, arrays, n: numbers.append(n)
                        or write(marks, chart, arrays, n))
    return numbers


@pytest.fixture(scope="module")
def memory(e1):
    """The chart in memory."""
    return stability_chart(e1, **GRID)


@pytest.fixture(scope="module")
def finished(e1, tmp_path_factory):
    """A store of ten blocks, written once."""
    path = tmp_path_factory.mktemp("finished") / "chart.zarr"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(stores, "POINTS", 7 * 90)
        stability_chart(e1, **GRID, store=path)
    return path


@pytest.fixture
def path(small, finished, tmp_path):
    """A copy of it, to be damaged."""
    return Path(shutil.copytree(finished, tmp_path / "chart.zarr"))


def contents(path):
    return {p.relative_to(path): p.read_bytes() for p in sorted(Path(path).rglob("*")) if p.is_file()}


@pytest.mark.parametrize("margins", [False, True])
def test_a_store_is_the_chart_in_memory(e1, monkeypatch, tmp_path, margins):
    """Values, coordinates, attributes, boundary; lazily, for whoever opens it; every block is counted."""
    monkeypatch.setattr(stores, "POINTS", 7 * 90 * (8 if margins else 1))
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


def test_further_axes_and_a_chart_without_a_boundary(e1, small, tmp_path):
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
    assert frame.Frame(Path(), None, tuple(map(np.empty, shape)), points).block == block


def test_another_chart_is_refused(e1, e2, path, tmp_path, monkeypatch):
    """Another report, axes, number, request, size of block or format; nothing of the store changes."""
    before = contents(path)
    xs = GRID["x"][1]
    for changed, why in (({"fixed": {"I1": "0.333", "dU": 1}}, "value of I1"),
                         ({"margins": True}, "margins, block"),
                         ({"x": ("pi3_0", np.nextafter(xs, 9))}, "values of pi3_0"),
                         ({"x": ("pi3_0", xs[::-1])}, "values of pi3_0"),
                         ({"x": GRID["y"], "y": GRID["x"]}, "axes")):
        with pytest.raises(StoreError,
                           match=f"is the store of another chart, they differ in {why}.*: give another "
                                 "path, or remove it"):
            stability_chart(e1, **{**GRID, **changed}, store=path)
    with pytest.raises(StoreError, match="differ in equilibrium"):
        stability_chart(e2, **GRID, store=path)
    grid = {**GRID, "fixed": {"I1": 1, "m0": 1}}
    fields = [gs.axial_potential(lambda k3, n=n: gs.symbol("m0") * k3**n) for n in (1, 3)]
    one, other = (gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), field))) for field in fields)
    stability_chart(one, **grid, store=tmp_path / "field.zarr")
    with pytest.raises(StoreError, match="differ in equilibrium:"):
        stability_chart(other, **grid, store=tmp_path / "field.zarr")
    monkeypatch.setattr(stores, "POINTS", 9 * 90)
    with pytest.raises(StoreError, match="differ in block"):
        stability_chart(e1, **GRID, store=path)
    monkeypatch.setattr(stores, "POINTS", 7 * 90)
    monkeypatch.setattr(frame, "STORE_FORMAT", 3)
    with pytest.raises(StoreError, match="differ in format"):
        stability_chart(e1, **GRID, store=path)
    assert contents(path) == before


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


def test_the_blocks_that_are_missing_are_computed(e1, path, written, memory):
    """A block without its mark is written again, whatever its chunk holds; the others are left.

    A whole store is opened at once.
    """
    before = contents(path)
    for number in (3, 8):
        (path / "complete" / "c" / str(number)).unlink()
    (path / "verdict" / "c" / "3" / "0").unlink()
    (path / "verdict" / "c" / "8" / "0").write_bytes(b"half a ch")
    written.clear()
    seen = []
    chart = stability_chart(e1, **GRID, store=path, progress=lambda *n: seen.append(n))
    assert sorted(written) == [3, 8] and seen == [(9, 10), (10, 10)] and contents(path) == before
    xr.testing.assert_identical(chart.compute(), memory)
    written.clear()
    stability_chart(e1, **GRID, store=path)
    assert written == []


def damage(path, how):
    """A file missing, cut off, emptied, zeroed, or with a bit flipped."""
    data = path.read_bytes()
    left = {"cut off": data[:-1], "emptied": b"", "zeroed": bytes(len(data)),
            "flipped": data[:-1] + bytes([data[-1] ^ 4])}
    path.unlink() if how == "missing" else path.write_bytes(left[how])


def test_a_mark_that_does_not_fit_its_chunks_is_none(e1, path, written):
    """Marks and chunks missing, cut off, emptied, zeroed, altered or exchanged.

    These blocks are computed again, no other.
    """
    before = contents(path)
    for number, (name, how) in enumerate((name, how) for how in ("missing", "cut off", "emptied", "zeroed")
                                         for name in ("mark", "chunk")):
        damage(path / "complete" / "c" / str(number) if name == "mark"
               else path / "verdict" / "c" / str(number) / "0", how)
    damage(path / "verdict" / "c" / "8" / "0", "flipped")
    written.clear()
    stability_chart(e1, **GRID, store=path)
    assert sorted(written) == list(range(9)) and contents(path) == before
    for name in ("complete/c/{}", "verdict/c/{}/0"):
        one, other = (path / name.format(n) for n in (0, 9))
        data = one.read_bytes(), other.read_bytes()
        one.write_bytes(data[1]), other.write_bytes(data[0])
    written.clear()
    stability_chart(e1, **GRID, store=path)
    assert sorted(written) == [0, 9] and contents(path) == before


def test_descriptions_and_coordinates_are_made_again(e1, path, written, memory):
    """Of the group, of each array, of the store itself.

    Axes, fixed numbers, curves: as they were, and no block is computed.
    """
    before = contents(path)
    assert marks.unharmed(path)
    written.clear()
    for harm in ({"zarr.json": "missing", "l/c/0": "flipped", "boundary_x/c/0": "cut off"},
                 {"complete/zarr.json": "cut off"},
                 {"verdict/zarr.json": "emptied", "I1/zarr.json": "flipped", "complete/zarr.json": "zeroed",
                  "pi3_0/c/0": "missing"}):
        for name, how in harm.items():
            damage(path / name, how)
        xr.testing.assert_identical(stability_chart(e1, **GRID, store=path).compute(), memory)
        assert contents(path) == before and written == []


def test_a_damaged_description_whose_chart_no_block_proves_is_refused(e1, path, tmp_path):
    """Whose it is cannot be known: nothing of it changes."""
    damage(path / "complete" / "zarr.json", "flipped")
    before = contents(tmp_path)
    with pytest.raises(StoreError,
                       match="complete/zarr.json is damaged and of which no block is one of this chart: "
                             "give another path, or"):
        stability_chart(e1, **{**GRID, "fixed": {"I1": "1/4", "dU": 1}}, store=path)
    assert contents(tmp_path) == before


def test_a_store_without_checksums_is_refused(e1, path):
    """Of the format before: the message says how to convert it; nothing of it changes."""
    description = json.loads((path / "complete" / "zarr.json").read_text())
    own = json.loads(description["attributes"]["chart"])
    description["attributes"] = {"long_name": "whether a block is written",
                                 "chart": json.dumps({**own, "format": 1})}
    (path / "complete" / "zarr.json").write_text(json.dumps(description))
    before = contents(path)
    with pytest.raises(StoreError,
                       match="format 1, of a gyrostat that wrote no checksums.*to convert it to this "
                             "format, move it away and"):
        stability_chart(e1, **GRID, store=path)
    assert contents(path) == before


def test_chunks_are_on_the_disk_before_their_mark(e1, small, tmp_path, monkeypatch):
    """Every file is flushed under its name or before it is moved.

    A mark after the chunk of its block and the folders above it.
    """
    flushed, fsync = [], os.fsync
    monkeypatch.setattr(os, "fsync", lambda file: flushed.append(os.readlink(f"/proc/self/fd/{file}"))
                        or fsync(file))
    path = (tmp_path / "chart.zarr").resolve()
    stability_chart(e1, **GRID, store=path)
    made = [name.split(".new", 1)[1] for name in flushed if ".new" in name]
    assert set(made) >= {f"/{name}" for name in contents(path)
                         if not str(name).startswith(("verdict/c", "complete/c"))}
    for number in range(10):
        (mark,) = (n for n, name in enumerate(flushed) if name.startswith(f"{path}/complete/c/{number}."))
        assert {f"{path}/verdict/c/{number}/0", f"{path}/verdict/c/{number}", f"{path}/verdict/c"} <= set(
            flushed[:mark]
        )
        assert f"{path}/complete/c" in flushed[mark:]


def test_a_full_disk(e1, small, written, memory, tmp_path, monkeypatch):
    """One sentence; what was written is kept, and the call goes on from there."""
    write = marks.Marks.write

    def full(self, number):
        if number == 4:
            raise OSError(errno.ENOSPC, "No space left on device")
        write(self, number)

    monkeypatch.setattr(stores, "WAVE", 1)
    with monkeypatch.context() as patched:
        patched.setattr(marks.Marks, "write", full)
        with pytest.raises(StoreError,
                           match="cannot be written: No space left on device; the blocks that are done are "
                                 "kept: make room"):
            stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    written.clear()
    chart = stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert written == list(range(4, 10))
    xr.testing.assert_identical(chart.compute(), memory)


def test_whoever_reads_is_told_of_a_damaged_chunk(e1, path):
    """A flipped bit is an error of reading, not another verdict."""
    chart = stability_chart(e1, **GRID, store=path)
    damage(path / "verdict" / "c" / "3" / "0", "flipped")
    with pytest.raises(ValueError, match="checksum"):
        chart.verdict.compute()


def test_what_killed_processes_left_is_removed(e1, path, tmp_path):
    """Beside the store and in it, after an hour.

    What is younger may be in use, and what has another name is someone's.
    """
    left = [tmp_path / "chart.zarr.ab.new", path / "verdict" / "c" / "0.ab.partial",
            tmp_path / "chart.zarr.cd.new", tmp_path / "my.new"]
    for place in left:
        place.write_text("") if place.suffix == ".partial" else place.mkdir()
    for place in (left[0], left[1], left[3]):
        os.utime(place, (1, 1))
    stability_chart(e1, **GRID, store=path)
    assert [place.exists() for place in left] == [False, False, True, True]


def test_a_mark_comes_after_its_chunks(e1, small, memory, tmp_path, monkeypatch):
    """Where the computation of a block fails, its mark is not there, and what went before is kept."""
    from gyrostat.charts.request import Request
    compute = Request.variables

    def failing(self, arrays, threads=1):
        if len(arrays[0]) == 7 and arrays[0][0] == GRID["y"][1][28]:
            raise MemoryError
        return compute(self, arrays, threads)

    monkeypatch.setattr(stores, "WAVE", 1)             # one after the other
    monkeypatch.setattr(Request, "variables", failing)
    with pytest.raises(MemoryError):
        stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert sorted(int(p.name) for p in (tmp_path / "chart.zarr" / "complete" / "c").iterdir()) == [0, 1, 2, 3]
    monkeypatch.setattr(Request, "variables", compute)
    xr.testing.assert_identical(stability_chart(e1, **GRID, store=tmp_path / "chart.zarr").compute(), memory)


def python(code, **environment):
    return subprocess.run([sys.executable, "-W", "error", "-c", SCRIPT + code],
                          env={**os.environ, **environment}, capture_output=True,
                          text=True, timeout=300)


@pytest.mark.slow
def test_a_killed_run_is_continued(e1, small, written, memory, tmp_path):
    """kill -9 in the middle, between the chunk of a block and its mark.

    The same call in another process computes what has no mark, and
    the result is the one of memory.
    """
    path = tmp_path / "chart.zarr"
    run = python(f"""
from gyrostat.charts.marks import Marks
stores.POINTS, write = 7 * 90, Marks.write
done = []
def killing(self, number):
    if len(done) == 4:
        os.kill(os.getpid(), signal.SIGKILL)
    done.append(number)
    write(self, number)
Marks.write = killing
stability_chart(report, **grid, store={str(path)!r})
""", PYTHONHASHSEED="1")
    assert run.returncode == -signal.SIGKILL, run.stderr
    marked, chunks = ({int(p.name) for p in (path / name / "c").iterdir()}
                      for name in ("complete", "verdict"))
    assert len(marked) == 4 and len(chunks - marked) == 1
    chart = stability_chart(e1, **GRID, store=path)
    assert sorted(written) == sorted(set(range(10)) - marked)
    xr.testing.assert_identical(chart.compute(), memory)


def test_a_store_is_moved_into_place_whole(e1, small, memory, tmp_path, monkeypatch):
    """What interrupts its making leaves nothing.

    Where another process was first, its store is the one that is filled.
    """
    path = tmp_path / "chart.zarr"

    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(frame.os, "rename", interrupted)
        with pytest.raises(KeyboardInterrupt):
            stability_chart(e1, **GRID, store=path)
    assert list(tmp_path.iterdir()) == []
    rename = os.rename

    def second(new, place):
        if not place.exists():
            stability_chart(e1, **GRID, store=tmp_path / "first.zarr")
            rename(tmp_path / "first.zarr", place)
        rename(new, place)

    monkeypatch.setattr(frame.os, "rename",
                        lambda new, place: (second if place == path else rename)(new, place))
    xr.testing.assert_identical(stability_chart(e1, **GRID, store=path).compute(), memory)
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.slow
def test_a_cluster_that_loses_a_worker(e1, small, written, tmp_path, monkeypatch):
    """With a client the blocks go to its workers; one of two is killed in the run.

    The result is the one of memory.
    """
    import distributed

    monkeypatch.setattr(stores, "WAVE", 6)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                                  dashboard_address=None) as cluster, \
            distributed.Client(cluster) as client:
        workers = list(client.run(os.getpid).values())
        seen = []

        def tick(done, total):
            seen.append(done)
            if done == 2:
                os.kill(workers[0], signal.SIGKILL)

        chart = stability_chart(e1, **{**GRID, "y": ("l", np.linspace(-2, 2, 280))},
                                store=tmp_path / "chart.zarr", progress=tick)
        assert written == [] and seen == list(range(1, 41))
        deadline = time.monotonic() + 20
        while set(client.run(os.getpid).values()) == set(workers) and time.monotonic() < deadline:
            time.sleep(0.1)
        assert workers[0] not in client.run(os.getpid).values()
    xr.testing.assert_identical(chart.compute(),
                                stability_chart(e1, **{**GRID, "y": ("l", np.linspace(-2, 2, 280))}))


MEMORY = """
import resource
stores.POINTS = 2**20
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
plane = np.linspace(-4, 4, 1000)
fixed = {{"I1": "1/3"}}
first = stability_chart(report, x=("pi3_0", plane[:9]), y=("l", plane), axes={{"dU": [1.0]}}, fixed=fixed,
                        margins=True, store={path!r} + "1.zarr")
before = peak()
chart = stability_chart(report, x=("pi3_0", plane), y=("l", plane), axes={{"dU": np.linspace(0, 1, {n})}},
                        fixed=fixed, margins=True, store={path!r} + ".zarr")
assert int((chart.verdict[:, 0] == -128).sum()) == 0
print(before, peak(), chart.nbytes / 2**20)
"""


@pytest.mark.parametrize("n", [pytest.param(n, marks=pytest.mark.slow) for n in (12, 120)])
def test_memory_does_not_grow_with_the_chart(full, tmp_path, n):
    """A process that writes a chart of 103 MiB grows by less than it, and by no more for one of 1 GiB.

    The larger one is written with --full.
    """
    if n > 12 and not full:
        pytest.skip("some minutes: --full")
    run = python(MEMORY.format(n=n, path=str(tmp_path / "chart")))
    assert run.returncode == 0, run.stderr
    before, peak, size = map(float, run.stdout.split())
    assert size > 100 and peak - before < 100, (before, peak, size)


def test_progress_on_a_terminal(e1, small, tmp_path, capsys, monkeypatch):
    """A bar on standard error, wiped at the end; none where it is not wanted, or there is no terminal."""
    stability_chart(e1, **GRID, store=tmp_path / "quiet.zarr")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    stability_chart(e1, **GRID, store=tmp_path / "silent.zarr", progress=False)
    assert capsys.readouterr() == ("", "")
    stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    out, err = capsys.readouterr()
    assert out == "" and "] 10/10" in err and err.endswith(" \r")


@pytest.mark.parametrize("missing", ["zarr", "dask"])
def test_a_missing_extra_is_named(e1, tmp_path, monkeypatch, missing):
    """Before anything is written."""
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(MissingExtraError, match=rf"{missing} cannot be imported.*gyrostat\[charts\]"):
        stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert list(tmp_path.iterdir()) == []


def test_a_store_says_what_it_is_of(path):
    """What is compared is in the attributes of complete, and does not depend on the process."""
    own = json.loads(xr.open_zarr(path, consolidated=False).complete.attrs["chart"])
    assert own["axes"] == ["l", "pi3_0"]
    assert own["value of I1"] == "1/3"
    assert own["format"] == frame.STORE_FORMAT
    assert own["block"] == [7, 90]


FIELDS = [gs.axial_potential(), gs.uniform_field(), gs.axial_potential(lambda k3: gs.symbol("a") * exp(k3)),
          gs.newtonian_field(3),
          gs.general_potential(), None]


@pytest.mark.slow
def test_a_report_is_pickled_without_what_was_derived():
    """In this process and in another, before and after it was used; what is derived again is the same."""
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
        assert len(used[-1]) == len(fresh)
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
