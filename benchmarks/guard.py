"""Has one of the library's speeds been lost?

    python benchmarks/guard.py           measures the ratios, compares them with those stored in RESULTS.md
    python benchmarks/guard.py --write   stores what it measures; prints the section

Each speed is a ratio to a baseline in the same process (flagship_rows.py, baselines.py): the median of 9
pairs in turn, of CPU time. A speed is lost if it is more than 30 % worse than stored, and is so again when it
is measured for a second time. Exit status 1 if one is lost, or if the stored rows are not those that are
measured. A loss is told but does not fail on another processor than that of the stored ratios, if this
process had less than half a core while it was measured, and of a row that says why.

Beside many processes caches are emptied again and again, and what runs through much code loses most by it:
with a tenth of a core the verdict on E1 took 1.7 times its stored ratio.
"""
import argparse
import re
import statistics
import sys
import time

import measured
import sections
from flagship_rows import Row, rows

ROUNDS, LOST, CORE = 9, 1.3, 0.5
PROCESSOR = re.compile(r"^Processor: (.+)\.$", re.MULTILINE)
CELLS = re.compile(r"^\| (.+?) \| (.+?) \| ([\d.e+-]+) \(.*\|$", re.MULTILINE)
PACKAGES = ("sympy", "python-flint", "numpy", "numba", "scipy", "matplotlib")


def measure(row: Row) -> list[float]:
    """The ratio in each round."""
    share = row.pieces[1] / row.pieces[0]
    return [share * r for r in measured.ratios(*measured.in_turn((row.ours, row.theirs), ROUNDS))]


def stored() -> dict[tuple[str, str], float]:
    """The ratios in RESULTS.md, by row and baseline."""
    return {(name, baseline): float(ratio)
            for name, baseline, ratio in CELLS.findall(sections.stored("guard"))}


def watched(row: Row) -> tuple[float, float]:
    """The median of the ratios, and the share of a core that this process and its children had meanwhile."""
    wall, cpu = time.perf_counter(), measured.cpu()
    ratio = statistics.median(measure(row))
    return ratio, (measured.cpu() - cpu) / (time.perf_counter() - wall)


def why_not(row: Row, share: float) -> str:
    """Why a loss of this row does not fail here; "" where it does."""
    there = PROCESSOR.search(sections.stored("guard"))
    if there is None or there[1] != measured.processor():
        return f"the stored ratios are of another processor ({there[1] if there else 'not named'})"
    return f"this process had {share:.0%} of a core" if share < CORE else row.noisy


def write() -> None:
    """Measure every row, and print and store the section."""
    lines = [
        f"{measured.here_and_now(*PACKAGES)}; medians (min–max) of {ROUNDS} pairs in turn, CPU time.", "",
        f"Processor: {measured.processor()}.", "",
        "| what | compared with | ratio of the times |", "|---|---|---|",
    ]
    for row in rows():
        lines.append(f"| {row.name} | {row.baseline} | {measured.spread(measure(row))} |")
        print(lines[-1], file=sys.stderr, flush=True)
    text = "\n".join(lines) + "\n"
    sections.write("guard", text)
    print(text, end="")


def compare() -> int:
    """Measure every row, and again what seems lost; the number of rows that fail."""
    known, losses, failed = stored(), [], 0
    for row in rows():
        if (before := known.pop((row.name, row.baseline), None)) is None:
            failed += 1
            print(f"{row.name} / {row.baseline}: not stored, run guard.py --write")
        elif not kept(row, before, watched(row)[0]):
            losses.append((row, before))
    for name, baseline in known:
        failed += 1
        print(f"{name} / {baseline}: stored, and not measured: run guard.py --write")
    for row, before in losses:
        now, share = watched(row)
        if not kept(row, before, now):
            failed += not (why := why_not(row, share))
            said = f"lost twice, which is not counted: {why}" if why else "lost twice"
            print(f"{row.name} / {row.baseline}: {said}")
    return failed


def kept(row: Row, before: float, now: float) -> bool:
    """Say how a ratio compares with the stored one, and whether it is not lost."""
    said = "LOST" if now > LOST * before else "gained" if now * LOST < before else ""
    print(f"{row.name} / {row.baseline}: {now:.3g}, stored {before:.3g} {said}", flush=True)
    return said != "LOST"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    if parser.parse_args().write:
        write()
    else:
        sys.exit(1 if compare() else 0)
