"""How long do all equilibria of a gyrostat satellite take, and is one missing?

    python benchmarks/bench_orbit.py            all of it; prints the rows of RESULTS.md
    python benchmarks/bench_orbit.py --quick    few satellites, for breakage

Random rational moments, rotors and rates; the time is that of `relative_equilibria` with every decision, the
damped one too, warm. Each list is compared with Newton's method in doubles from many random starts
(tests/oracles/orbital_search.py): what that finds and the list has not is missing. By Morse's theory the
numbers of equilibria with an even and an odd index are the same.
"""
import argparse
import platform
import random
import statistics
import sys
import time
from fractions import Fraction
from pathlib import Path

import numpy as np
import sympy

import gyrostat as gs

sys.path.append(str(Path(__file__).parents[1] / "tests/oracles"))
from orbital_search import search  # noqa: E402

ZEROS = {"in general": 0, "in a principal plane": 1, "along a principal axis": 2}


def drawn(draw, zeros):
    """Moments, l and the rate."""
    moments = [Fraction(n, 20) for n in draw.sample(range(8, 40), 3)]
    rotor = [Fraction(draw.randint(1, 40) * draw.choice((-1, 1)), draw.choice((20, 40, 400)))
             for _ in range(3)]
    for axis in draw.sample(range(3), zeros):
        rotor[axis] = Fraction(0)
    return moments, rotor, Fraction(draw.randint(1, 9), 4)


def listed(moments, rotor, rate):
    """All equilibria, and the seconds that they and their decisions took."""
    scene = gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(rate))
    begin = time.perf_counter()
    found = gs.relative_equilibria(scene, {})
    for e in found:
        e.decision, e.damped  # noqa: B018
    return time.perf_counter() - begin, found


def missing(found, moments, rotor, rate, seed, starts):
    """How many that the search ends at are not in the list, and whether the indices are not balanced."""
    here = np.array([[float(x) for x in (*e.n, *e.r)] for e in found])
    apart = [np.abs(here - place).max(1).min() for place in search(moments, rotor, rate, starts, seed)]
    odd = sum(1 if e.signs[2] > 0 else -1 for e in found)  # the sign of det K
    return sum(x > 1e-8 for x in apart), odd != 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    quick = parser.parse_args().quick
    scenes, starts = (2, 100) if quick else (30, 400)
    draw, failed = random.Random(20261123), 0
    print(f"{platform.machine()}, Python {platform.python_version()}, sympy {sympy.__version__}; "
          f"{scenes} satellites each\n")
    print("| all equilibria, the rotor | median (min–max), ms | found | missing | indices not balanced |")
    print("|---|---|---|---|---|")
    for name, zeros in ZEROS.items():
        listed(*drawn(draw, zeros))                        # warm
        times, count, absent, unbalanced = [], 0, 0, 0
        for seed in range(scenes):
            given = drawn(draw, zeros)
            seconds, found = listed(*given)
            times.append(1e3 * seconds)
            count += len(found)
            lost, odd = missing(found, *given, seed, starts)
            absent, unbalanced = absent + lost, unbalanced + odd
        failed += absent + unbalanced
        print(f"| {name} | {statistics.median(times):.0f} ({min(times):.0f}–{max(times):.0f}) | {count} "
              f"| {absent} | {unbalanced} |")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
