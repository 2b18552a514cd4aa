"""Is a store that was damaged, or whose process was killed, the undisturbed one after the same call, byte for
byte?

    python benchmarks/damage_stores.py            200 mutilations, 20 kills, 20 power cuts, 6 pairs of writers
    python benchmarks/damage_stores.py --quick    a seeded part, for breakage; exit status 1 if a store is
        silently wrong

A mutilation: one to three files of any kind (chunks, marks, descriptions of the group and of its arrays,
coordinates, boundary) missing, cut off, emptied, zeroed, with a bit flipped, exchanged with another, or their
folder missing. A kill: SIGKILL at a random moment of the call, the making of the store included, until a call
ends by itself. A power cut: the same, and every file that was not flushed to the disk is missing, emptied,
cut off or zeroed. Each is followed by the call. It ends in the undisturbed store (the bytes of every file),
in a StoreError, or it is silently wrong.
"""
import argparse
import os
import platform
import random
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from datetime import date
from pathlib import Path

import dask.array
import numpy as np
import xarray
import zarr.codecs

import gyrostat as gs
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.stores import chart_stores
from gyrostat.errors import StoreError

TOP = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))


def flipped(data, rng):
    """With one bit altered."""
    if not data:
        return b"\1"
    place = rng.randrange(len(data))
    return data[:place] + bytes([data[place] ^ 1 << rng.randrange(8)]) + data[place + 1:]


CHARTS = [{"x": ("pi3_0", np.linspace(-4, 4, 90)), "y": ("l", np.linspace(-2, 2, 68)),
           "fixed": {"I1": "1/3", "dU": 1}},
          {"x": ("pi3_0", np.linspace(-4, 4, 30)), "y": ("l", np.linspace(-2, 2, 21)),
           "axes": {"dU": [0.5, 1.0, 2.0]},
           "fixed": {"I1": "1/3"}, "margins": True}]
# what is loaded and derived is so once, before there are processes
for ready in CHARTS:
    stability_chart(TOP, **ready)
# of a block, so that there are about ten; the last one is not a full one
POINTS = {False: 630, True: 8 * 210}
KINDS = {"missing": lambda data, rng: None, "cut off": lambda data, rng: data[:rng.randrange(len(data) + 1)],
         "emptied": lambda data, rng: b"", "zeroed": lambda data, rng: bytes(len(data)),
         "bit flipped": flipped}


def contents(path):
    """The bytes of every file, but for those that a killed process had not moved into place."""
    return {str(p.relative_to(path)): p.read_bytes()
            for p in path.rglob("*") if p.is_file() and p.suffix != ".partial"}


def kind_of(name):
    """What a file of a store is."""
    first, *rest = name.split("/")
    if not rest:
        return "group"
    whose = (
        "mark"
        if first == "complete"
        else "data"
        if first == "verdict" or first.startswith("margin")
        else "coordinate or curve"
    )
    return f"{whose}: {'description' if rest == ['zarr.json'] else 'bytes'}"


def called(chart, path, flushed=None):
    """The call, in a process of its own; its number. Files that it flushes are entered in a file."""
    if child := os.fork():
        return child
    status = 3
    try:
        if flushed:
            fsync = os.fsync

            def noted(descriptor):
                fsync(descriptor)
                with open(flushed, "a") as file:
                    file.write(os.readlink(f"/proc/self/fd/{descriptor}") + "\n")
            os.fsync = noted
        chart_stores.POINTS = POINTS[chart.get("margins", False)]
        try:
            stability_chart(TOP, **chart, store=path, progress=False, threads=2)
            status = 0
        except StoreError:
            status = 2
        except Exception as error:                     # noqa: BLE001
            print(f"{path}: {type(error).__name__}: {error}", file=sys.stderr)
    finally:
        os._exit(status)


def ended(child):
    """How a call ended."""
    return {0: "done", 2: "StoreError",
            3: "another exception"}.get(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), "killed")


def outcome(chart, path, truth):
    """How the call ends on what is there."""
    said = ended(called(chart, path))
    if said != "done":
        return said
    return "bit-identical" if contents(path) == truth else "silently wrong"


def mutilated(path, rng):
    """Damage a store in one to three places; the kinds of what was damaged."""
    seen = []
    for _ in range(rng.randint(1, 3)):
        names = sorted(contents(path))
        if not names:
            break
        wanted = rng.choice(sorted({kind_of(name) for name in names}))
        name = rng.choice([name for name in names if kind_of(name) == wanted])
        how = rng.choice([*KINDS, "exchanged", "folder missing"])
        seen.append((wanted, how))
        file = path / name
        if how == "folder missing":
            shutil.rmtree(file.parent)
        elif how == "exchanged":
            other = path / rng.choice([name for name in names if kind_of(name) == wanted])
            mine, theirs = file.read_bytes(), other.read_bytes()
            file.write_bytes(theirs), other.write_bytes(mine)
        elif (data := KINDS[how](file.read_bytes(), rng)) is None:
            file.unlink()
        else:
            file.write_bytes(data)
    return seen


def place(path, name):
    """Where a file lies after it was moved into place, from where it was flushed.

    Beside it, or in a store that was being made.
    """
    if ".new/" in name:
        return str(path / name.split(".new/", 1)[1])
    return name.removesuffix(".partial").rsplit(".", 1)[0] if name.endswith(".partial") else name


def cut(path, flushed, rng):
    """What a power cut leaves: of files that were not flushed anything."""
    names = flushed.read_text().splitlines() if flushed.exists() else []
    kept = {place(path, name) for name in names}
    for file in [p for p in sorted(path.rglob("*")) if p.is_file()]:
        if str(file) not in kept:
            data = rng.choice([*KINDS.values()])(file.read_bytes(), rng)
            file.unlink() if data is None else file.write_bytes(data)


def stopped(chart, folder, truth, rng, power, longest):
    """Kill calls at random moments until one ends; what is left then, and how often it was killed."""
    path, kills = folder / "chart.zarr", 0
    flushed = folder / "flushed" if power else None
    while True:
        child = called(chart, path, flushed)
        time.sleep(rng.uniform(0, longest))
        os.kill(child, signal.SIGKILL)
        if (said := ended(child)) != "killed":
            break
        kills += 1
        if power and path.exists():
            cut(path, flushed, rng)
    return (said if said != "done" else "bit-identical" if contents(path) == truth
            else "silently wrong"), kills


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--seed", type=int, default=7)
    given = parser.parse_args()
    rng, begin = random.Random(given.seed), time.perf_counter()
    mutilations, kills, writers = (24, 4, 1) if given.quick else (200, 20, 6)
    counts, damage = Counter(), Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        truths, seconds = [], 0.0
        for n, chart in enumerate(CHARTS):
            start = time.perf_counter()
            ended(called(chart, folder / f"{n}.zarr"))
            seconds = max(seconds, time.perf_counter() - start)
            truths.append(contents(folder / f"{n}.zarr"))
        for n in range(mutilations):
            which = n % len(CHARTS)
            path = folder / "damaged.zarr"
            shutil.copytree(folder / f"{which}.zarr", path)
            seen = mutilated(path, rng)
            damage.update(kind for kind, _ in seen)
            result = outcome(CHARTS[which], path, truths[which])
            counts["mutilations", result] += 1
            if result not in ("bit-identical", "StoreError"):
                print(f"{result}: {seen}")
            shutil.rmtree(path)
        for power, name in ((False, "kills"), (True, "power cuts")):
            done = 0
            while done < kills:
                which = rng.randrange(len(CHARTS))
                with tempfile.TemporaryDirectory(dir=folder) as own:
                    result, killed = stopped(CHARTS[which], Path(own), truths[which], rng, power,
                                             1.2 * seconds)
                done += killed
                counts[name, "killed"] += killed
                counts[name, result] += 1
        for _ in range(writers):
            which = rng.randrange(len(CHARTS))
            with tempfile.TemporaryDirectory(dir=folder) as own:
                pair = [called(CHARTS[which], Path(own) / "chart.zarr") for _ in range(2)]
                results = {ended(child) for child in pair}
                same = contents(Path(own) / "chart.zarr") == truths[which]
                counts["two writers", "bit-identical" if results == {"done"} and same
                       else "silently wrong"] += 1
    print(f"{date.today()}, {platform.machine()} ({os.cpu_count()} cores, shared), Python "
          f"{platform.python_version()}, seed {given.seed}, "
          f"zarr {zarr.__version__}, xarray {xarray.__version__}, dask {dask.__version__}, "
          f"{time.perf_counter() - begin:.0f} s")
    for (what, result), count in sorted(counts.items()):
        print(f"{what}: {result}: {count}")
    print("damaged: " + ", ".join(f"{kind}: {count}" for kind, count in sorted(damage.items())))
    return 1 if any(result in ("silently wrong", "another exception") for _, result in counts) else 0


if __name__ == "__main__":
    raise SystemExit(main())
