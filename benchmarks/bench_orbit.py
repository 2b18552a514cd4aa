"""How long do satellites take: all equilibria, the Smelt plane, a verdict, the conditions; and what is wrong?

    python benchmarks/bench_orbit.py            all of it; prints a section of RESULTS.md
    python benchmarks/bench_orbit.py --quick    few satellites, for breakage

Random rational moments, rotors and rates; the time is that of `relative_equilibria` with every decision, the
damped one too, warm. Each list is compared with Newton's method in doubles from many random starts
(tests/oracles/orbital_search.py): what that finds and the list has not is missing. By Morse's theory the
numbers of equilibria with an even and an odd index are the same. Points of the Smelt plane are compared with
the inequalities of DeBra and Delp in fractions; the conditions of Lagrange's configuration are derived in
turn with those of E1, E2 and E3.
"""
import argparse
import random
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
from measured import cpu, here_and_now, ratios, spread

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
    begin = cpu()
    found = gs.relative_equilibria(scene, {})
    for e in found:
        e.decision, e.damped  # noqa: B018
    return cpu() - begin, found


def missing(found, moments, rotor, rate, seed, starts):
    """How many that the search ends at are not in the list, and whether the indices are not balanced."""
    here = np.array([[float(x) for v in e.directions for x in v] for e in found])
    apart = [np.abs(here - place).max(1).min() for place in search(moments, rotor, rate, starts, seed)]
    odd = sum(1 if e.form.signs[-1] > 0 else -1 for e in found)  # the sign of det K
    return sum(x > 1e-8 for x in apart), odd != 0


def smelt(size, checked):
    """The verdicts over the plane, one thread: seconds, points that stay open, and how many are wrong."""
    roll, yaw = gs.symbol("k_R"), gs.symbol("k_Y")
    body = gs.Gyrostat((1 - yaw, 1 - roll * yaw, 1 - roll), (0, 0, 0))
    report = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit(1))))
    axis = (2 * np.arange(size) + 1) / size - 1
    times = []
    for _ in range(10):
        begin = cpu()
        found = gs.charts.verdicts(report, {"k_R": axis[None, :], "k_Y": axis[:, None]})
        times.append(cpu() - begin)
    draw = random.Random(5)
    places = [(draw.randrange(size), draw.randrange(size)) for _ in range(checked)]
    wrong = sum(found[i, j] != debra_delp(Fraction(axis[j]), Fraction(axis[i])) for i, j in places)
    return times[1:], int((found == 0).sum()), wrong


def debra_delp(roll, yaw):
    """1 stable, 0 held by gyroscopic forces, −1 unstable, without a rotor; on a boundary 0."""
    if roll > yaw > 0:
        return 1
    trace, product = 1 + 3 * roll + roll * yaw, roll * yaw
    return 0 if roll >= yaw and product >= 0 and trace >= 0 and trace**2 >= 16 * product else -1


def verdicts_at_numbers(count):
    """Seconds of a verdict of a pitch rotor at numbers, the names derived before."""
    body = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
    report = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit())))
    draw, times = random.Random(7), []
    for _ in range(count):
        values = {name: Fraction(draw.randint(5, 40), 10) for name in ("I1", "I2", "I3", "omega0", "l")}
        begin = cpu()
        report.verdict(values)
        times.append(cpu() - begin)
    return times[1:]


def conditions():
    """Seconds of Lagrange's configuration with a rotor, and of E1, E2 and E3 of any field, in turn."""
    pairs = []
    for _ in range(10):
        begin = cpu()
        body = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
        report = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit())))
        report.necessary, report.sufficient, report.damped  # noqa: B018
        middle = cpu()
        scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        for family in (gs.upright, gs.hanging, gs.inclined):
            report = gs.analyze(family(scene))
            report.necessary, report.sufficient, report.damped  # noqa: B018
        pairs.append((middle - begin, cpu() - middle))
    return pairs[1:]


def shown(seconds):
    return spread(seconds, scale=1e3)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    quick = parser.parse_args().quick
    scenes, starts = (2, 100) if quick else (30, 400)
    draw, failed = random.Random(20261123), 0
    print(f"{here_and_now('sympy', 'python-flint', 'numpy')}; {scenes} random rational satellites each, "
          "every equilibrium in a circular orbit with its verdict and that under damping, warm; CPU time. "
          f"Missing: Newton's method in doubles from {starts} random starts ends at one that is not in the "
          "list. Not balanced: minima − saddles + … of the amended potential on SO(3), by the sign of det K, "
          "is not 0.\n")
    print("| all equilibria, the rotor | median (min–max), ms | found | missing | indices not balanced |")
    print("|---|---|---|---|---|")
    for name, zeros in ZEROS.items():
        listed(*drawn(draw, zeros))                        # warm
        times, count, absent, unbalanced = [], 0, 0, 0
        for seed in range(scenes):
            given = drawn(draw, zeros)
            seconds, found = listed(*given)
            times.append(seconds)
            count += len(found)
            lost, odd = missing(found, *given, seed, starts)
            absent, unbalanced = absent + lost, unbalanced + odd
        failed += absent + unbalanced
        print(f"| {name} | {shown(times)} | {count} | {absent} | {unbalanced} |")
    size = 100 if quick else 1000
    times, still_open, wrong = smelt(size, 2000 if quick else 20_000)
    print("\n| what | median (min–max), ms | error |\n|---|---|---|")
    print(f"| Smelt plane, {size} × {size} verdicts, {still_open} between the criteria | {shown(times)} | "
          f"{wrong} wrong |")
    print(f"| a verdict at numbers | {shown(verdicts_at_numbers(20 if quick else 1000))} | exact |")
    ours, vertical = zip(*conditions())
    print(f"| Lagrange's conditions with a rotor | {shown(ours)} | exact; "
          f"{spread(ratios(ours, vertical))} × E1, E2 and E3 in the same run |")
    return 1 if failed + wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
