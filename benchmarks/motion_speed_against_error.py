"""How long does a state of a motion take, how large is its error, and what do h and the Casimirs lose on the
way?

    python benchmarks/motion_speed_against_error.py              all of it; prints MOTION.md, draws
        the figure
    python benchmarks/motion_speed_against_error.py --quick      small, for breakage; exit status 1 if an
        error or a drift is too large
    python benchmarks/motion_speed_against_error.py --save FILE  what is printed, into a file too; --limit S
        for the longest run

Every number is a float64 and means the rational that it is. The reference is a Taylor series in whole numbers
with 40 digits (motion_reference.py), and for long times motion(…, precision=40), which is compared with that
series in the same run.
"""
# ruff: noqa: E402
import os

for library in ("OPENBLAS", "OMP", "MKL", "NUMBA"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

import argparse
import statistics
import time
from pathlib import Path

from measured import here_and_now
from motion_figure import OURS, Row, draw, line, short_table, spread, table
from motion_integrators import TooLong, forget, heyoka, heyoka_run, methods
from motion_reference import cases, error, nutation_period, taylor
from mpmath import mpf, nstr, workdps
from sympy import Rational

import gyrostat as gs
from gyrostat.trajectories import motion

ROUNDS, SHORT, DIGITS = 5, 0.5, 40                         # runs of less than SHORT seconds are repeated
QUICK = ("1e-06", "2e-16", "100 steps a turn", "30 steps a turn", "8 steps a turn")
TAYLOR_TURNS = 5000                                        # up to here the reference is the series


def scene_of(case):
    """The scene and the values of its symbols, for motion(scene, state, values)."""
    if case.revolution:
        values = dict(zip(("I1", "I3", "l", "m0"), (*case.inertia[1:], case.rotor[2], case.slope[2])))
        return gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), values
    body = gs.Gyrostat(case.inertia, case.rotor)
    slope = [*map(Rational, case.slope)]
    return gs.assemble(body, None if case.free
                       else gs.general_potential(lambda *k: sum(g * c for g, c in zip(slope, k)))), None


def ours(case):
    """Our route, like those of motion_integrators.methods; the run knows its name."""
    scene, values = scene_of(case)
    def prepare(case, t, limit):
        solved = motion(scene, case.state, values)
        def run():
            return solved(t)
        run.route = solved.route
        return run
    return {(OURS, ""): prepare}


def reference(case, t):
    """The state with 40 digits, and where it is from."""
    if t / case.turn < TAYLOR_TURNS:
        return taylor(case, t, DIGITS), "Taylor series"
    scene, values = scene_of(case)
    return [*motion(scene, case.state, values, precision=DIGITS)(t)], "motion(…, precision=40)"


def measured(case, t, chosen, truth, limit, known, rounds):
    """A row for each method; known holds the seconds per time of earlier, shorter runs."""
    rows, again = [], []
    forget()
    for key, prepare in chosen.items():
        rows.append(row := Row(*key, expected=expected
                               if (expected := known.get((case.name, key), 0) * t) > limit else None))
        if row.expected:
            continue
        begin = time.perf_counter()
        run = prepare(case, t, limit)
        ready = time.perf_counter()
        row.setting = getattr(run, "route", row.setting)
        try:
            x = run()
        except TooLong as stopped:
            row.expected = limit / stopped.args[0]
        else:
            row.setup, row.run, row.error, row.drifts = (
                [ready - begin],
                [time.perf_counter() - ready],
                error(x, truth),
                case.drifts(x),
            )
            if row.run[0] + row.setup[0] < SHORT:
                again.append((row, prepare, run))
        known[case.name, key] = (row.expected or row.run[0]) / t if key[0] != OURS else 0
    for _ in range(rounds):
        for row, prepare, run in again:
            begin = time.perf_counter()
            fresh = prepare(case, t, limit)
            ready = time.perf_counter()
            # ours may keep what it found; heyoka's first run is slower
            (fresh if row.family == OURS else run)()
            row.run.append(time.perf_counter() - ready)
            row.setup.append(ready - begin)
    for row, _, _ in again:
        del row.run[0]                                     # the first run warms up
    return rows


def checks(some, wrong):
    """motion(…, precision=40) against the series, and its period against the roots of the cubic.

    What is wrong is added to a list.
    """
    yield from (line("case", "time", "motion(…, precision=40) − Taylor series", "period − 4 K/√…"),
                "|---" * 4 + "|")
    for case in some:
        scene, values = scene_of(case)
        solved, (label, t) = motion(scene, case.state, values), [*case.times.items()][0]
        if solved.route in ("heyoka", "DOP853"):
            continue
        exact, series = motion(scene, case.state, values, precision=DIGITS)(t), taylor(case, t, DIGITS)
        gap = "—"
        with workdps(DIGITS + 10):
            if case.revolution:
                gap = nstr(abs(mpf(solved.period)
                               - nutation_period(case.inertia, case.rotor[2], case.slope[2], case.state)), 2)
            apart = max(abs(a - b) for a, b in zip(exact, series))
            yield line(case.name, label, nstr(apart, 2), gap)
        if apart > 1e-35:
            wrong.append(f"{case.name}: motion(…, precision={DIGITS}) and the series differ by "
                         f"{nstr(apart, 2)}")


def one_state(case, t, rounds):
    """One state after a long time, ours from the assembled scene on, against heyoka at its tightest
    tolerance, in turn.
    """
    scene, values = scene_of(case)
    names = ("ours, with set-up", "heyoka 2e-16, run alone", "with set-up from its cache", "with compilation")
    seconds = {name: [] for name in names}
    for _ in range(rounds):
        begin = time.perf_counter()
        motion(scene, case.state, values)(t)
        seconds[names[0]].append(time.perf_counter() - begin)
        forget()
        setup = []
        for _ in range(2):
            begin = time.perf_counter()
            run = heyoka_run(0.0)(case, t, None)
            setup.append(time.perf_counter() - begin)
        begin = time.perf_counter()
        run()
        running = time.perf_counter() - begin
        for name, more in zip(names[1:], (0, setup[1], setup[0])):
            seconds[name].append(running + more)
    yield from (line(f"one state of the {case.name} at t = {t:.4g}", "ms", "× ours"), "|---" * 3 + "|")
    for name, list_ in seconds.items():
        yield line(name, spread(list_),
                   f"{statistics.median(b / a for a, b in zip(seconds[names[0]], list_)):.3g}")


def bound(row):
    """What an error may be in the quick run."""
    if row.family == OURS:
        return 1e-12
    if "order" in row.family:
        return 100 / int(row.setting.split()[0]) ** int(row.family[-1]) + 1e-13
    return 1e-14 if row.setting == "80 bits" else 100 * float(row.setting)


def failures(case, rows):
    """What is wrong in the quick run: an error, a drift, a Casimir of a splitting."""
    for row in rows:
        bad = (
            row.expected
            or max(row.error, *row.drifts) > bound(row)
            or "order" in row.family
            and max(row.drifts[1:]) > 1e-13
        )
        if bad:
            yield f"{case.name}, {row.family}, {row.setting}: error {row.error}, drifts {row.drifts}"


def first_calls():
    """Seconds of the first, short runs: compiling, or reading what was compiled before."""
    for case in cases(True):
        for key in (("Strang, order 2", "20 steps a turn"), ("SciPy RK45", "1e-03")):
            begin = time.perf_counter()
            methods()[key](case, 1.0, 60)()
            yield f"{case.name}, {key[0]}: {time.perf_counter() - begin:.2f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--save", type=Path)
    parser.add_argument("--limit", type=float, default=60.0)
    given = parser.parse_args()
    said, rounds = [], 1 if given.quick else ROUNDS

    def say(*lines):
        for text in lines:
            print(text, flush=True)
            said.append(text)
    say(f"{here_and_now('numpy', 'scipy', 'numba', 'heyoka', 'python-flint', 'mpmath')}; one core; medians "
        f"(min–max) of {rounds} rounds in turn, one run where it takes more than {SHORT} s. Errors: largest "
        "deviation of a coordinate.", "",
        f"First calls: {'; '.join(first_calls())}.", "")
    panels, known, wrong = [], {}, []
    for case in cases(given.quick):
        for label, t in case.times.items():
            truth, source = reference(case, t)
            others = {key: method for key, method in methods().items() if not given.quick or key[1] in QUICK
                      and not panels}
            rows = measured(case, t, ours(case) | others, truth, given.limit, known, rounds)
            panels.append((case, label, rows))
            say(f"## {case.name}, {label}", "", f"Reference: {source}.", "",
                *table(case, rows, given.limit), "")
            wrong += failures(case, rows) if given.quick else []
    some = list({case.name: case for case, _, _ in panels}.values())
    say("### In short", "", *short_table(panels), "",
        "### To 40 digits, and late", "", *checks(some, wrong), "")
    long = next(case for case in cases(given.quick) if case.revolution and case.slope[2] == 1)
    times = [*long.times.values()]
    if heyoka:
        say(*one_state(long, times[-1], rounds))
    if not given.quick:
        draw(panels, given.limit, Path(__file__).with_suffix(".png"))
    if given.save:
        given.save.write_text("\n".join(said) + "\n", encoding="utf-8")
    for text in wrong:
        print(text)
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
