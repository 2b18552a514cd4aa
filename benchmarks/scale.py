"""How do time and memory grow with the points, the axes and the degree of U; and are 10⁹ verdicts all right?

    python benchmarks/scale.py            all of it; prints a section of RESULTS.md
    python benchmarks/scale.py --quick    small, for breakage; exit status 1 if a verdict is wrong or
        undecided

Each measurement has a process of its own. The peak is the largest resident memory less that after the
imports, the input and a small first call; the result is a new array. The truth at 10⁹ points: where a margin
in float64 is further from 0 than a bound of its error, its sign; everywhere else, at both points beside each
change of the verdict along a row, and at a random 10⁶, whole numbers (exact_truth.py).
"""
# ruff: noqa: E402
import os

for library in ("OPENBLAS", "OMP", "MKL"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

import argparse
import json
import resource
import subprocess
import sys
import time

import numpy as np
from exact_truth import truth
from measured import here_and_now

import gyrostat as gs
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.charts.signs.verdict_arrays import verdicts

TILT = {"I1": 1.25, "I3": 0.75, "l": 0.5, "d2U": -2.0, "d3U": 0.25, "d4U": 0.5}
# its boundary |π3 + l| = 3 runs through points of the grid
TOP = {"I1": 1.5, "m0": 1.5}
# axes in the order in which they are added
RANGES = {"omega": 3.0, "k3": 0.99, "l": 2.0, "d2U": -4.0, "I3": 0.5}


def tilted(degree=None):
    """E3 in an unspecified field, or in one of some degree."""
    k3 = gs.symbol("k3")
    field = () if degree is None else (sum(gs.symbol(f"a{n}") * k3**n for n in range(1, degree + 1)),)
    return gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(*field))))


def top():
    return gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


def arrangement(points, axes, degree):
    """Arguments at E3: a grid along some axes, or a list of points where axes is 0."""
    if axes == 0:
        rng = np.random.default_rng(3)
        moving = {name: rng.uniform(-RANGES[name], RANGES[name], points) for name in ("omega", "k3")}
    else:
        n, names = round(points ** (1 / axes)), list(RANGES)[:axes]
        moving = {}
        for place, name in enumerate(names):
            low, high = (
                (0.25, 1.25)
                if name == "I3"
                else (-4.0, 2.0)
                if name == "d2U"
                else (-RANGES[name], RANGES[name])
            )
            moving[name] = np.linspace(low, high, n).reshape((n,) + (1,) * (axes - 1 - place))
    if degree is None:
        return {**TILT, "k3": 0.5, **moving}
    fixed = {"I1": 1.25, "I3": 0.75, **{f"a{n}": (-1) ** n / n**2 for n in range(1, degree + 1)}}
    return {**fixed, **moving}


def measured(what, backend, points, axes, degree):
    """Seconds of a first, small call and of the whole, and bytes at the peak and of the result."""
    report, small = tilted(degree), arrangement(min(points, 1024), axes, degree)
    arguments = arrangement(points, axes, degree)
    if what == "verdicts":
        def call(given):
            return verdicts(report, given, backend=backend)
    else:
        f = compile_margin(report.sufficient, backend=backend)
        def call(given):
            return f(**{name: given[name] for name in f.names})
    begin = time.perf_counter()
    call(small)
    compiled, before = time.perf_counter(), peak()
    result = call(arguments)
    seconds = time.perf_counter() - compiled
    undecided = int(np.count_nonzero(result.reshape(-1)[:10**6] == 0)) if what == "verdicts" else 0
    return {"first call": compiled - begin, "seconds": seconds, "peak": peak() - before,
            "result": result.nbytes, "points": result.size,
            "undecided": undecided}


def peak():
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def in_a_process(**order):
    """One measurement in a fresh process."""
    done = subprocess.run([sys.executable, __file__, "--one", json.dumps(order)], capture_output=True,
                          text=True)
    if done.returncode:
        raise SystemExit(f"{order}: {done.stderr[-2000:]}")
    return json.loads(done.stdout.splitlines()[-1])


def sweep(quick):
    """The table: seconds of the second call, points per second, and the peak next to the size of the result.
    """
    sizes = (10**5,) if quick else (10**4, 10**5, 10**6, 10**7, 10**8, 10**9)
    many = 10**5 if quick else 10**8
    orders = [(n, 2, None) for n in sizes] + [(n, 0, None) for n in sizes[:-1]]
    orders += [(many, axes, None) for axes in ((3,) if quick else (1, 3, 4, 5))]
    orders += [(many if axes else many // 10, axes, d) for axes in (2, 0)
               for d in ((6,) if quick else (1, 2, 5, 10, 20, 40))]
    orders = [orders[0], orders[-1]] if quick else orders
    routes = [(what, backend) for what in ("verdicts", "compile_margin") for backend in ("numba", "numpy")]
    first, worst = {route: [] for route in routes}, dict.fromkeys(routes, 0.0)
    print("| points | arrangement | degree of U |", *(f" {what}, {backend} |" for what, backend in routes),
          sep="")
    print("|---" * (3 + len(routes)) + "|")
    for points, axes, degree in orders:
        cells = []
        for what, backend in routes:
            if degree == 1 and what == "compile_margin":       # the criterion always holds
                cells.append("—")
                continue
            r = in_a_process(what=what, backend=backend, points=points, axes=axes, degree=degree)
            first[what, backend].append(r["first call"])
            if points >= 10**7:
                worst[what, backend] = max(worst[what, backend], r["peak"] / r["result"])
            cells.append(f"{r['seconds']:.2g} s, {r['points'] / r['seconds']:.2g}/s, {r['peak'] / 1e6:.3g} "
                         f"of {r['result'] / 1e6:.3g} MB")
        print(f"| {r['points']:.3g} | {f'grid, {axes} axes' if axes else 'list'} | {degree or 'any U'} | "
              f"{' | '.join(cells)} |", flush=True)
    print("| | first calls, s |", *(f" | {min(first[route]):.2f}–{max(first[route]):.2f}"
                                    for route in routes), " |", sep="")
    if not quick:
        print("| | largest peak / result from 10⁷ points on |",
              *(f" | {worst[route]:.2f}" for route in routes), " |", sep="")


def filtered(kind, a, b):
    """Signs of a margin in float64 in a block of rows, 0 where it is not further from 0 than 8 and 64 times
    its rounding errors.
    """
    if kind == "E1":
        # five roundings, each of at most 2⁻⁵³ of a + b or of a term
        momenta = a[:, None] + b
        square, rest = momenta * momenta, 4 * TOP["I1"] * TOP["m0"]
        value, bound = square - rest, 2.0**-50 * (square + rest)
    # (l + (I3 − 2 I1) ω k3)² + I1 (1 − k3²) (I1 ω² + U''): 13 roundings
    else:
        I1, I3, l, bend = (TILT[name] for name in ("I1", "I3", "l", "d2U"))
        product, push = a[:, None] * b * (I3 - 2 * I1), (I1 * a * a + bend)[:, None] * I1
        value = (l + product) ** 2 + push * (1 - b * b)
        bound = 2.0**-46 * ((abs(l) + abs(product)) ** 2 + (I1 * (I1 * a * a + abs(bend)))[:, None]
                            * (1 + b * b))
    return np.where(abs(value) > bound, np.sign(value), 0).astype(np.int8)


def exact(kind, a, b):
    """Truth at lists of points, in whole numbers, 10⁵ at a time."""
    fixed = {"I1": TOP["I1"], "a1": TOP["m0"]} if kind == "E1" else TILT
    names, scene = (("l", "pi3_0"), "polynomial") if kind == "E1" else (("omega", "k3"), "unspecified")
    found = [truth(kind, scene, {**fixed, names[0]: a[i:i + 10**5], names[1]: b[i:i + 10**5]})[0]
             for i in range(0, len(a), 10**5)]
    return np.concatenate(found) if found else np.empty(0, np.int8)


def billion(kind, n, backend="numba"):
    """Counts of the check of an n × n grid, with a tenth of its points at random, 10⁶ at most."""
    # steps of a power of two: sums are exact, some of them ±3
    if kind == "E1":
        first = second = (np.arange(n) - n // 2) * 2.0 ** (3 - int(np.log2(n)))
    else:
        first, second = np.linspace(-3, 3, n), np.linspace(-0.99, 0.99, n)
    report, fixed, names = (top(), TOP, ("l", "pi3_0")) if kind == "E1" else (tilted(), TILT, ("omega", "k3"))
    begin = time.perf_counter()
    result = verdicts(report, {**fixed, names[0]: first[:, None], names[1]: second}, backend=backend)
    counts = {"seconds": time.perf_counter() - begin, "points": result.size, "undecided": 0,
              "wrong by the filter": 0, "wrong exactly": 0,
              "left by the filter": 0, "beside a change": 0, "random": min(10**6, result.size // 10)}
    step = max(1, 2**21 // n)
    for low in range(0, n, step):
        block = result[low:low + step]
        signs = filtered(kind, first[low:low + step], second)
        counts["undecided"] += int(np.count_nonzero((block != 1) & (block != -1)))
        counts["wrong by the filter"] += int(np.count_nonzero((signs != block) & (signs != 0)))
        changes = block[:, 1:] != block[:, :-1]
        beside = np.zeros(block.shape, bool)
        beside[:, 1:] |= changes
        beside[:, :-1] |= changes
        for name, some in (("left by the filter", signs == 0), ("beside a change", beside)):
            i, j = np.nonzero(some)
            counts[name] += len(i)
            counts["wrong exactly"] += int(np.count_nonzero(exact(kind, first[low + i], second[j])
                                                            != block[i, j]))
    i, j = np.random.default_rng(5).integers(0, n, (2, counts["random"]))
    counts["wrong exactly"] += int(np.count_nonzero(exact(kind, first[i], second[j]) != result[i, j]))
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        order = json.loads(given.one)
        print(json.dumps(billion(**order) if "kind" in order else measured(**order)))
        return 0
    print(f"{here_and_now('numpy', 'numba')}; E3 unless said, each measurement in a process of its own.\n")
    n, failed = 400 if given.quick else 31623, 0
    rows = {kind: in_a_process(kind=kind, n=n) for kind in ("E1", "E3")}
    print("| every verdict of a grid | E1, (l, π3) | E3, (ω, k3) |\n|---|---|---|")
    for name in rows["E1"]:
        print(f"| {name} | {rows['E1'][name]:.6g} | {rows['E3'][name]:.6g} |" if name == "seconds" else
              f"| {name} | {rows['E1'][name]} | {rows['E3'][name]} |")
    print()
    failed = sum(row[name] for row in rows.values()
                 for name in ("undecided", "wrong by the filter", "wrong exactly"))
    sweep(given.quick)
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
