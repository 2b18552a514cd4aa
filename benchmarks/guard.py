"""Has one of the library's speeds been lost?

    python benchmarks/guard.py           measures the ratios, compares them with those stored in RESULTS.md
    python benchmarks/guard.py --write   stores what it measures; prints the section

Each speed is a ratio to a baseline in the same process (flagship_rows.py, baselines.py): the median of 9
pairs in turn, of CPU time. Exit status 1 if one is more than 30 % worse than stored, and is so again when it
is measured at once for a second time.
"""
import argparse
import re
import statistics
import sys

import measured
import sections
from flagship_rows import Row, rows

ROUNDS, LOST = 9, 1.3
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


def write() -> None:
    """Measure every row, and print and store the section."""
    lines = [
        f"{measured.here_and_now(*PACKAGES)}; medians (min–max) of {ROUNDS} pairs in turn, CPU time.", "",
        "| what | compared with | ratio of the times |", "|---|---|---|",
    ]
    for row in rows():
        lines.append(f"| {row.name} | {row.baseline} | {measured.spread(measure(row))} |")
        print(lines[-1], file=sys.stderr, flush=True)
    text = "\n".join(lines) + "\n"
    sections.write("guard", text)
    print(text, end="")


def compare() -> int:
    """Measure every row, and again what seems lost; the number of rows that are lost, or not stored."""
    known, losses, unknown = stored(), [], 0
    for row in rows():
        if (before := known.pop((row.name, row.baseline), None)) is None:
            unknown += 1
            print(f"{row.name} / {row.baseline}: not stored, run guard.py --write")
        elif not kept(row, before):
            losses.append((row, before))
    for name, baseline in known:
        print(f"{name} / {baseline}: stored, and not measured: run guard.py --write")
    return unknown + len(known) + sum(not kept(row, before) for row, before in losses)


def kept(row: Row, before: float) -> bool:
    """Measure a row, and say how it compares."""
    now = statistics.median(measure(row))
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
