"""Charts in a store after a kill, a full disk or damage: what is missing is computed, the rest is kept."""
import errno
import json
import os
import signal

import pytest
import xarray as xr
from charts.stored_charts import GRID, contents, python

from gyrostat.charts.chart import stability_chart
from gyrostat.charts.stores import chart_stores, power_cuts
from gyrostat.errors import StoreError


@pytest.mark.slow
def test_the_blocks_that_are_missing_are_computed(e1, store, written, memory):
    """A block without its mark is written again, whatever its chunk holds; the others are left.

    A whole store is opened at once.
    """
    before = contents(store)
    for number in (3, 8):
        (store / "complete" / "c" / str(number)).unlink()
    (store / "verdict" / "c" / "3" / "0").unlink()
    (store / "verdict" / "c" / "8" / "0").write_bytes(b"half a ch")
    written.clear()
    seen = []
    chart = stability_chart(e1, **GRID, store=store, progress=lambda *n: seen.append(n))
    assert sorted(written) == [3, 8] and seen == [(9, 10), (10, 10)] and contents(store) == before
    xr.testing.assert_identical(chart.compute(), memory)
    written.clear()
    stability_chart(e1, **GRID, store=store)
    assert written == []


def damage(path, how):
    """A file missing, cut off, emptied, zeroed, or with a bit flipped."""
    data = path.read_bytes()
    left = {"cut off": data[:-1], "emptied": b"", "zeroed": bytes(len(data)),
            "flipped": data[:-1] + bytes([data[-1] ^ 4])}
    path.unlink() if how == "missing" else path.write_bytes(left[how])


def test_a_mark_that_does_not_fit_its_chunks_is_none(e1, store, written):
    """Marks and chunks missing, cut off, emptied, zeroed, altered or exchanged.

    These blocks are computed again, no other.
    """
    before = contents(store)
    for number, (name, how) in enumerate((name, how) for how in ("missing", "cut off", "emptied", "zeroed")
                                         for name in ("mark", "chunk")):
        damage(store / "complete" / "c" / str(number) if name == "mark"
               else store / "verdict" / "c" / str(number) / "0", how)
    damage(store / "verdict" / "c" / "8" / "0", "flipped")
    written.clear()
    stability_chart(e1, **GRID, store=store)
    assert sorted(written) == list(range(9)) and contents(store) == before
    for name in ("complete/c/{}", "verdict/c/{}/0"):
        one, other = (store / name.format(n) for n in (0, 9))
        data = one.read_bytes(), other.read_bytes()
        one.write_bytes(data[1]), other.write_bytes(data[0])
    written.clear()
    stability_chart(e1, **GRID, store=store)
    assert sorted(written) == [0, 9] and contents(store) == before


def test_a_chunk_of_another_variable_is_none(tmp_path):
    """Zarr writes no chunk of nothing but the fill value: that there is none is part of the mark."""
    block = power_cuts.Marks(tmp_path, ("verdict", "margin_0"), (2, 1), b"key")
    first, second = block.chunks(1)
    for chunk in (first, second):
        chunk.parent.mkdir(parents=True)
    first.write_bytes(b"values")
    block.write(1)
    assert block.fits(1) and not block.fits(0)
    first.rename(second)
    assert not block.fits(1)


@pytest.mark.slow
def test_descriptions_and_coordinates_are_made_again(e1, store, written, memory):
    """Of the group, of each array, of the store itself.

    Axes, fixed numbers, curves: as they were, and no block is computed.
    """
    before = contents(store)
    assert power_cuts.unharmed(store)
    written.clear()
    for harm in ({"zarr.json": "missing", "l/c/0": "flipped", "boundary_x/c/0": "cut off"},
                 {"complete/zarr.json": "cut off"},
                 {"verdict/zarr.json": "emptied", "I1/zarr.json": "flipped", "complete/zarr.json": "zeroed",
                  "pi3_0/c/0": "missing"}):
        for name, how in harm.items():
            damage(store / name, how)
        assert not power_cuts.unharmed(store)
        xr.testing.assert_identical(stability_chart(e1, **GRID, store=store).compute(), memory)
        assert contents(store) == before and written == []


def test_a_damaged_description_whose_chart_no_block_proves_is_refused(e1, store, tmp_path):
    """Whose it is cannot be known: nothing of it changes."""
    damage(store / "complete" / "zarr.json", "flipped")
    before = contents(tmp_path)
    with pytest.raises(StoreError,
                       match="complete/zarr.json is damaged and of which no block is one of this chart: "
                             "give another path, or"):
        stability_chart(e1, **{**GRID, "fixed": {"I1": "1/4", "dU": 1}}, store=store)
    assert contents(tmp_path) == before


def test_a_store_without_checksums_is_refused(e1, store):
    """Of the format before: the message says how to convert it; nothing of it changes."""
    description = json.loads((store / "complete" / "zarr.json").read_text())
    own = json.loads(description["attributes"]["chart"])
    description["attributes"] = {"long_name": "whether a block is written",
                                 "chart": json.dumps({**own, "format": 1})}
    (store / "complete" / "zarr.json").write_text(json.dumps(description))
    before = contents(store)
    with pytest.raises(StoreError,
                       match="format 1, of a gyrostat that wrote no checksums.*to convert it to this "
                             "format, move it away and"):
        stability_chart(e1, **GRID, store=store)
    assert contents(store) == before


@pytest.mark.slow
def test_chunks_are_on_the_disk_before_their_mark(e1, ten_blocks, tmp_path, monkeypatch):
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


@pytest.mark.slow
def test_a_full_disk(e1, ten_blocks, written, memory, tmp_path, monkeypatch):
    """One sentence; what was written is kept, and the call goes on from there."""
    write = power_cuts.Marks.write

    def full(self, number):
        if number == 4:
            raise OSError(errno.ENOSPC, "No space left on device")
        write(self, number)

    monkeypatch.setattr(chart_stores, "WAVE", 1)
    with monkeypatch.context() as patched:
        patched.setattr(power_cuts.Marks, "write", full)
        with pytest.raises(StoreError,
                           match="cannot be written: No space left on device; the blocks that are done are "
                                 "kept: make room"):
            stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    written.clear()
    chart = stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert written == list(range(4, 10))
    xr.testing.assert_identical(chart.compute(), memory)


def test_whoever_reads_is_told_of_a_damaged_chunk(e1, store):
    """A flipped bit is an error of reading, not another verdict."""
    chart = stability_chart(e1, **GRID, store=store)
    damage(store / "verdict" / "c" / "3" / "0", "flipped")
    with pytest.raises(ValueError, match="checksum"):
        chart.verdict.compute()


def test_what_killed_processes_left_is_removed(e1, store, tmp_path):
    """Beside the store and in it, after an hour.

    What is younger may be in use, and what has another name is someone's.
    """
    left = [tmp_path / "chart.zarr.ab.new", store / "verdict" / "c" / "0.ab.partial",
            tmp_path / "chart.zarr.cd.new", tmp_path / "my.new"]
    for place in left:
        place.write_text("") if place.suffix == ".partial" else place.mkdir()
    for place in (left[0], left[1], left[3]):
        os.utime(place, (1, 1))
    stability_chart(e1, **GRID, store=store)
    assert [place.exists() for place in left] == [False, False, True, True]


@pytest.mark.slow
def test_a_mark_comes_after_its_chunks(e1, ten_blocks, memory, tmp_path, monkeypatch):
    """Where the computation of a block fails, its mark is not there, and what went before is kept."""
    from gyrostat.charts.request import Request
    compute = Request.variables

    def failing(self, arrays, threads=1):
        if len(arrays[0]) == 7 and arrays[0][0] == GRID["y"][1][28]:
            raise MemoryError
        return compute(self, arrays, threads)

    monkeypatch.setattr(chart_stores, "WAVE", 1)             # one after the other
    monkeypatch.setattr(Request, "variables", failing)
    with pytest.raises(MemoryError):
        stability_chart(e1, **GRID, store=tmp_path / "chart.zarr")
    assert sorted(int(p.name) for p in (tmp_path / "chart.zarr" / "complete" / "c").iterdir()) == [0, 1, 2, 3]
    monkeypatch.setattr(Request, "variables", compute)
    xr.testing.assert_identical(stability_chart(e1, **GRID, store=tmp_path / "chart.zarr").compute(), memory)


@pytest.mark.slow
def test_a_killed_run_is_continued(e1, ten_blocks, written, memory, tmp_path):
    """kill -9 in the middle, between the chunk of a block and its mark.

    The same call in another process computes what has no mark, and
    the result is the one of memory.
    """
    path = tmp_path / "chart.zarr"
    run = python(f"""
from gyrostat.charts.stores.power_cuts import Marks
chart_stores.POINTS, write = 7 * 90, Marks.write
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
