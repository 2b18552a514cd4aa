"""How long does a state take among many in a row, and how large is its error?

    python benchmarks/motion_rows.py            prints a section of MOTION.md
    python benchmarks/motion_rows.py --quick    small, for breakage

Equidistant times of every motion in closed form, against heyoka's dense output in turn. Errors are those of
20 states of a row, against 40 digits.
"""
# ruff: noqa: E402
import os

for library in ("OPENBLAS", "OMP", "MKL", "NUMBA"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

import statistics
import sys
import time
from functools import partial

import numpy as np
from measured import here_and_now
from motion_figure import line
from motion_integrators import heyoka, heyoka_grid
from motion_reference import cases, error
from motion_speed_against_error import DIGITS, scene_of

from gyrostat.trajectories import motion

TIMES, ROUNDS, DENSITIES = 10**5, 9, (100, 1000, 10000)


def table(some, n, rounds):
    """n times in a row, 10², 10³ and 10⁴ in a period: ours, and heyoka's grid of dense output, in turn."""
    yield from (line("case", "in a period", "ours, ns a state", "error", "heyoka 2e-16, propagate_grid",
                     "error", "heyoka / ours"), "|---" * 7 + "|")
    for case in some:
        scene, values = scene_of(case)
        solved, sharp = motion(scene, case.state, values), motion(scene, case.state, values, precision=DIGITS)
        for density in DENSITIES:
            times = np.linspace(0, n / density * float(solved.period), n)
            places = np.linspace(n // 7, n - 1, 20).astype(int)
            truth = [sharp(float(u)) for u in times[places]]
            routes = [partial(solved, times)] + ([heyoka_grid(case, times)] if heyoka else [])
            seconds, worst = [[] for _ in routes], []
            for route in routes:                           # the first run warms up
                x = route()
                worst.append(max(error(x[i], r) for i, r in zip(places, truth)))
            for _ in range(rounds):
                for list_, route in zip(seconds, routes):
                    begin = time.process_time()
                    route()
                    list_.append(time.process_time() - begin)
            cells = [cell for list_, off in zip(seconds, worst)
                     for cell in (f"{1e9 * statistics.median(list_) / n:.0f}", f"{off:.1e}")]
            ratio = [f"{statistics.median(b / a for a, b in zip(*seconds)):.2f}"] if heyoka else ["—"] * 3
            yield line(case.name, density, *cells, *ratio)


def main(quick):
    n, rounds = (2 * 10**4, 1) if quick else (TIMES, ROUNDS)
    print(f"{here_and_now('numpy', 'heyoka', 'python-flint')}; one core; {n} equidistant times, medians of "
          f"{rounds} rounds in turn, CPU time.\n")
    for text in table([case for case in cases(quick) if case.free or case.revolution], n, rounds):
        print(text, flush=True)


if __name__ == "__main__":
    main("--quick" in sys.argv)
