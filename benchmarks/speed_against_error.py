"""How fast is each route to a verdict, and how often is it wrong where it is hard?

    python benchmarks/speed_against_error.py            all of it; prints a section of RESULTS.md, draws
        speed_against_error.png
    python benchmarks/speed_against_error.py --quick    few points, for breakage; exit status 1 if an exact or
        certified route fails

Every input is a float64 and the truth is that of these floats as rationals (exact_truth.py). All work is
timed in turn in one process, on one core; matrices are assembled before the clock starts, results are written
into arrays that exist.
"""
# ruff: noqa: E402
import os

for library in ("OPENBLAS", "OMP", "MKL", "NUMBA"):
    os.environ[f"{library}_NUM_THREADS"] = "2" if library == "NUMBA" else "1"

import argparse
import statistics
import time
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

import numpy as np
import sympy
import verdict_routes as routes
from hard_cases import EXPONENTS, FAMILIES, KINDS, Batch, cases, on_boundary, ordinary
from measured import cpu, here_and_now, ratios
from scene_matrices import euler_poisson, matrices, restricted

from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.charts.signs.verdict_arrays import verdicts
from gyrostat.stability.criteria.linearization import linearize

FIXED = {"E1": {"I1": 1.25, "dU": 1.5}, "E3": {"I1": 1.25, "I3": 0.75, "l": 0.5, "d2U": -2.0}}
# a certified verdict may need them on the boundary
JET = {"E1": {"d2U": 0.5, "d3U": 0.25}, "E3": {"d3U": 0.25, "d4U": 0.5}}
GROUPS = {"E1": "E1, E2", "E2": "E1, E2", "E3": "E3"}
COLUMNS = {"near": "(a) near", "on": "(a) on it", **{x: f"({x}) {FAMILIES[x]}" for x in "bcdef"}}
ROUNDS = {True: 2, False: 7}
TARGETS = (("compiled64 numba", "E1", 10_000), ("certified numba", "E1", 5_000),
           ("certified numba", "E3", 3_000), ("certified numba, list", "E1", 800),
           ("certified numba, list", "E3", 800),
           ("compiled64 numpy", "E1", 800), ("compiled64 numpy", "E3", 300), ("certified numpy", "E1", 250))


def check_matrices():
    """The matrices of the eigenvalue routes have the characteristic polynomials of gyrostat's, at random
    rational points.
    """
    rng = np.random.default_rng(7)
    for kind in KINDS:
        for _ in range(3):
            v = {name: Fraction(float(x[0])).limit_denominator(20)
                 for name, x in ordinary(kind, 1, rng).items()}
            across = Fraction(0)
            if kind == "E3":
                t = Fraction(int(rng.integers(2, 9)), 10)
                v["k3"], across = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
            linear = linearize(routes.report_of(kind, "unspecified").equilibrium)
            values = {s: sympy.Rational(v[s.name].numerator, v[s.name].denominator)
                      for s in linear.matrix.free_symbols}
            theirs = linear.matrix.subs(values, simultaneous=True).charpoly().all_coeffs()
            for rows in (restricted(kind, "unspecified", v, across),
                         euler_poisson(kind, "unspecified", v, across)[0]):
                ours = sympy.Matrix([[sympy.Rational(str(x)) for x in row]
                                     for row in rows]).charpoly().all_coeffs()
                if ours[:5] != theirs or any(ours[5:]):
                    raise SystemExit(f"the matrix of {kind} is not that of gyrostat: {ours} and {theirs}")


def errors(n, few):
    """Points, wrong stable, wrong unstable and undecided by route, group and column.

    The same by route, group and distance.
    """
    by_family, by_distance, distances = (
        defaultdict(lambda: np.zeros(4, int)),
        defaultdict(lambda: np.zeros(4, int)),
        defaultdict(list),
    )
    for batch in cases(n):
        if batch.family == "a":
            distances[batch.label] += list(batch.distance)
        for route in routes.ROUTES:
            part = batch.first(max(int(route.most * few), 2))
            verdict = route.verdicts(part)
            if verdict is None:
                continue
            counts = np.array([len(verdict), np.sum((verdict == 1) & (part.truth < 0)),
                               np.sum((verdict == -1) & (part.truth > 0)),
                               np.sum(verdict == 0)])
            column = batch.family if batch.family != "a" else "on" if batch.label == "boundary" else "near"
            by_family[route.name, GROUPS[batch.kind], column] += counts
            if batch.family == "a":
                by_distance[route.name, GROUPS[batch.kind], batch.label] += counts
    return by_family, by_distance, {label: statistics.median(x) for label, x in distances.items()}


def grid(kind, n, single):
    """Arguments of a square grid in (l, π3) or (ω, k3)."""
    a, b = (("l", 4.0), ("pi3_0", 4.0)) if kind == "E1" else (("omega", 3.0), ("k3", 0.99))
    number = np.float32 if single else np.float64
    axes = {a[0]: np.linspace(-a[1], a[1], n, dtype=number)[:, None],
            b[0]: np.linspace(-b[1], b[1], n, dtype=number)}
    return {**{name: number(x) for name, x in FIXED[kind].items()}, **axes}


def work(kind, quick):
    """What is timed: name -> (a call, its number of points, the arrangement)."""
    rng, jobs = np.random.default_rng(11), {}
    report, few = routes.report_of(kind, "unspecified"), 0.05 if quick else 1

    def some(n, drawn=ordinary):
        n = max(int(n * few), 2)
        nothing = np.zeros(n)
        return Batch("", "", kind, "unspecified", drawn(kind, n, rng), nothing, nothing)

    many = some(20_000)
    for size in (4, 6):
        A = matrices(many, size)
        limit = 1e-10 * abs(A).sum(2).max(1)
        jobs[f"eigvals {size}×{size}"] = (
            lambda A=A, limit=limit: np.linalg.eigvals(A).real.max(1) <= limit,
            len(A),
            "points",
        )
    A = matrices(many, 4)
    jobs["traces"] = lambda: routes.traces(many, A), len(A), "points"
    slow = {"SciPy loop": (routes.scipy_loop, 1000), "mpmath": (routes.mpmath_eig, 40),
            "expanded": (routes.expanded, 10**6),
            **{f"acb {b}": (routes.balls(b), 400) for b in routes.BALLS},
            "Report.verdict": (routes.one_by_one, 1000),
            "fmpq": (routes.rationals(routes.as_fmpq), 5000), "Fraction": (routes.rationals(Fraction), 2000)}
    for name, (route, n) in slow.items():
        batch = some(n)
        if name == "SciPy loop":
            matrices(batch, 4)
        jobs[name] = lambda route=route, batch=batch: route(batch), len(batch.truth), "points"
    listed, boundary = some(10**6), some(10**6, on_boundary)
    for backend in ("numpy", "numba"):
        n = (512 if quick else 16384) if backend == "numba" else (256 if quick else 4096)
        for bits in (32, 64):
            arguments = grid(kind, n, bits == 32)
            f, out = compile_margin(report.sufficient, backend=backend), np.empty((n, n), bool)
            jobs[f"compiled{bits} {backend}"] = (
                lambda f=f, a=arguments, out=out: f(**a, out=out),
                n * n,
                f"{n}²",
            )
            columns = {name: listed.values[name].astype(np.float32 if bits == 32 else np.float64)
                       for name in f.names}
            one = np.empty(len(listed.truth), bool)
            jobs[f"compiled{bits} {backend}, list"] = (
                lambda f=f, c=columns, out=one: f(**c, out=out),
                len(one),
                "points",
            )
        proved, given = np.empty((n, n), np.int8), {**arguments, **JET[kind]}
        call = {"backend": backend, "out": proved}
        jobs[f"certified {backend}"] = (
            lambda a=given, call=call: verdicts(report, **a, **call),
            n * n,
            f"{n}²",
        )
        columns = routes.asked(listed)[1] | {"backend": backend, "out": np.empty(len(listed.truth), np.int8)}
        jobs[f"certified {backend}, list"] = (
            lambda c=columns: verdicts(report, **c),
            len(listed.truth),
            "points",
        )
        call = {"backend": backend, "out": np.empty(len(boundary.truth), np.int8)}
        columns = routes.asked(boundary)[1] | call
        jobs[f"certified {backend}, boundary"] = (
            lambda c=columns: verdicts(report, **c),
            len(boundary.truth),
            "points",
        )
    # long enough that two threads have something to share
    n = 512 if quick else 32768
    large, proved = grid(kind, n, False), np.empty((n, n), np.int8)
    for threads in (1, 2):
        jobs[f"compiled64 numba, {threads} of 2"] = (
            lambda t=threads: f(**large, out=proved.view(bool), threads=t),
            n * n,
            f"{n}²",
        )
        call = {"backend": "numba", "out": proved, "threads": threads}
        jobs[f"certified numba, {threads} of 2"] = (
            lambda call=call: verdicts(report, **large, **JET[kind], **call),
            n * n,
            f"{n}²",
        )
    return jobs


def speeds(kind, quick):
    """Points per second of every round, by name of the work; the arrangements; seconds of the first calls."""
    jobs, found, first = work(kind, quick), defaultdict(list), {}
    for name, (call, _, _) in jobs.items():
        begin = cpu()
        call()
        first[name] = cpu() - begin
    for _ in range(ROUNDS[quick]):
        for name, (call, points, _) in jobs.items():
            clock = time.perf_counter if name.endswith(" of 2") else cpu       # of threads beside one another
            begin = clock()
            call()
            found[name].append(points / (clock() - begin))
    return found, {name: arrangement for name, (_, _, arrangement) in jobs.items()}, first


def share(counts):
    """Wrong stable / wrong unstable / undecided in per cent of the points."""
    def per_cent(k):
        return (
            "0"
            if k == 0
            else f"{100 * k / counts[0]:.2g}"
            if 100 * k < 10 * counts[0]
            else f"{100 * k / counts[0]:.0f}"
        )
    return " / ".join(map(per_cent, counts[1:])) if counts[0] else "—"


def spread(values):
    return f"{statistics.median(values):.3g} ({min(values):.2g}–{max(values):.2g})"


def ratio(one, other):
    return statistics.median(ratios(one, other))


def table(by_family, rates, arrangements):
    heads = ["equilibria", "route", "points", "points/s, list", "points/s, grid",
             "× eigvals 4×4, list / grid", *COLUMNS.values()]
    print(line(heads), "|---" * len(heads) + "|", sep="\n")
    for group, rate in (("E1, E2", rates["E1"]), ("E3", rates["E3"])):
        base = rate["eigvals 4×4"]
        for route in routes.ROUTES:
            cells = [by_family[route.name, group, column] for column in COLUMNS]
            name, gridded = route.timed, f"{route.timed}, list" in rate
            listed = rate[f"{name}, list" if gridded else name]
            grids = f"{spread(rate[name])} on {arrangements[name]}" if gridded else "—"
            times = f"{ratio(listed, base):.2g}" + (f" / {ratio(rate[name], base):.3g}" if gridded else "")
            print(line([group, route.name, sum(c[0] for c in cells), spread(listed), grids, times,
                        *map(share, cells)]))


def distance_table(by_distance, medians):
    labels = [f"1e-{e:02}" for e in EXPONENTS] + ["next float", "boundary"]
    print("\nFamily (a) by the distance asked for; first the median of the distances after rounding.\n")
    print(line(["equilibria", "routes", *labels]), "|---" * (2 + len(labels)) + "|", sep="\n")
    print(line(["", "realised", *(f"{medians[label]:.2g}" for label in labels)]))
    for group in ("E1, E2", "E3"):
        alike = defaultdict(list)
        for route in routes.ROUTES:
            alike[tuple(share(by_distance[route.name, group, label]) for label in labels)].append(route.name)
        for cells, names in alike.items():
            print(line([group, "; ".join(names), *cells]))


def line(cells):
    return f"| {' | '.join(str(cell).replace('|k3|', '∣k3∣') for cell in cells)} |"


def first_calls(firsts):
    print("\n| first call, s: compiling, or reading what was compiled before, included | E1 | E3 "
          "|\n|---|---|---|")
    for name in ("compiled64 numpy", "certified numpy", "compiled64 numba", "certified numba"):
        print(line([name, *(f"{firsts[kind][name]:.2f}" for kind in firsts)]))


def targets(rates, arrangements):
    print("\n| target, ratio in the same round | target | reached |\n|---|---|---|")
    for name, kind, wanted in TARGETS:
        print(f"| {name}, {kind}, × eigvals 4×4 | {wanted} | "
              f"{ratio(rates[kind][name], rates[kind]['eigvals 4×4']):.0f} |")
    for name in ("compiled64 numba", "certified numba"):
        for kind in rates:
            two = ratio(rates[kind][f"{name}, 2 of 2"], rates[kind][f"{name}, 1 of 2"])
            print(f"| {name}, {kind}, two threads × one, on {arrangements['certified numba, 2 of 2']} | "
                  f"1.7 | {two:.2f} |")


def boundary_table(by_family, rates):
    """Seconds for a million points with a margin of exactly 0, beside the errors in family (a) on it."""
    print("\n| on the boundary | s for 10⁶ points, E1 | E3 | errors, E1, E2 | E3 |\n|---|---|---|---|---|")
    for route in (r for r in routes.ROUTES if f"{r.timed}, boundary" in rates["E1"]):
        seconds = [spread([1e6 / x for x in rates[kind][f"{route.timed}, boundary"]]) for kind in rates]
        print(line([route.name, *seconds, *(share(by_family[route.name, group, "on"])
                                            for group in ("E1, E2", "E3"))]))


def short_table(by_family, rates):
    """The rows of the page on benchmarks."""
    chosen = ("eigvals 4×4, Re ≤ 1e-12‖A‖", "eigvals 4×4, Re ≤ 1e-08‖A‖", "mpmath eig, 50 digits, 1e-20‖A‖",
              "flint acb_mat eig, 256 bits",
              "p, q, p² − 4q from traces", "compiled margin, float64, numba", "certified arrays, numpy",
              "certified arrays, numba")
    print("\n### In short\n")
    print("| route to a verdict | points/s E1 / E3 | × eigvals E1 / E3 | wrong E1, E2 / E3 | undecided "
          "|\n|---|---|---|---|---|")
    for route in (r for r in routes.ROUTES if r.name in chosen):
        counts = [sum((by_family[route.name, group, column] for column in COLUMNS), np.zeros(4, int))
                  for group in ("E1, E2", "E3")]
        wrong, undecided = ([100 * part / c[0] for part, c in zip(parts, counts)] for parts in (
            [c[1] + c[2] for c in counts], [c[3] for c in counts]))
        rate = [rates[kind][route.timed] for kind in ("E1", "E3")]
        print(line([route.name, " / ".join(f"{statistics.median(r):.1e}" for r in rate),
                    " / ".join(f"{ratio(r, rates[kind]['eigvals 4×4']):.2g}"
                               if ratio(r, rates[kind]["eigvals 4×4"]) < 100 else
                               f"{ratio(r, rates[kind]['eigvals 4×4']):.0f}"
                               for r, kind in zip(rate, ("E1", "E3"))),
                    *(" / ".join(f"{x:.3g} %" if x >= 99.5 else f"{x:.2g} %" if x else "0" for x in part)
                      for part in (wrong, undecided))]))


def failures(by_family):
    """Wrong and undecided points of the routes that claim to have none."""
    certain = {route.name for route in routes.ROUTES if route.certain}
    return {key: counts for key, counts in by_family.items() if key[0] in certain and counts[1:].any()}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    quick = parser.parse_args().quick
    packages = here_and_now("numpy", "scipy", "numba", "python-flint", "mpmath", "sympy")
    print(f"{packages}; medians (min–max) of {ROUNDS[quick]} rounds in turn, CPU time. Errors: called stable "
          "but unstable / called unstable but stable / undecided, in % of the points.\n")
    check_matrices()
    by_family, by_distance, medians = errors(12 if quick else 1000, 0.05 if quick else 1)
    rates, firsts = {}, {}
    for kind in ("E1", "E3"):
        rates[kind], arrangements, firsts[kind] = speeds(kind, quick)
    table(by_family, rates, arrangements)
    distance_table(by_distance, medians)
    first_calls(firsts)
    targets(rates, arrangements)
    boundary_table(by_family, rates)
    short_table(by_family, rates)
    if not quick:
        from speed_figure import draw
        draw(routes.ROUTES, by_family, by_distance, medians, rates, Path(__file__).with_suffix(".png"))
    for key, counts in (failed := failures(by_family)).items():
        print(f"{', '.join(key)}: {counts[1]} wrong stable, {counts[2]} wrong unstable, {counts[3]} "
              f"undecided of {counts[0]}")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
