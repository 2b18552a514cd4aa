"""How long does one verdict at a rational point take, and how often is it wrong?

    python benchmarks/bench_verdict.py            all of it; prints a section of RESULTS.md
    python benchmarks/bench_verdict.py --quick    few points, for breakage

A verdict reads the numbers, checks them (positive, on the family, U real there), decides, on the boundary by
the reduced motion, and says why. The baseline is SymPy's subs on the same margin, alone: no check, no
boundary. Both are timed in turn at the same random rational points, a third of them exactly on the boundary,
and compared with the margin in fractions.

Then all permanent rotations of random bodies, rotors and fields, at a rate and on a level, with their
decisions: each is put into Euler's equations in doubles, and maxima − saddles + minima is counted.
"""
import argparse
import random
import statistics
from fractions import Fraction

import numpy as np
import sympy
from measured import cpu, here_and_now, ratios, spread

import gyrostat as gs

DEGREE, BLOCK = 6, 100


def number(draw, low=-40):
    return Fraction(draw.randint(low, 40), draw.randint(1, 12))


def vertical(s, coefficients):
    """A point of E1 or E2, its slope U', and the margin P² − 4 s I1 U'."""
    def point(draw, on):
        values = {"I1": number(draw, 1), "l": number(draw), "pi3_0": number(draw)}
        P = values["l"] + values["pi3_0"]
        if not coefficients:
            values |= {"dU": s * P**2 / (4 * values["I1"]) if on else number(draw), "d2U": number(draw)}
            return values, P**2 - 4 * s * values["I1"] * values["dU"]
        a = [number(draw) for _ in range(DEGREE)]
        slope = sum(n * c * s ** (n - 1) for n, c in enumerate(a, 1))
        if on:
            a[0] += s * P**2 / (4 * values["I1"]) - slope
            slope = s * P**2 / (4 * values["I1"])
        return values | {f"a{n}": c for n, c in enumerate(a, 1)}, P**2 - 4 * s * values["I1"] * slope
    return point


def inclined(coefficients):
    """A point of E3 and (P − 2 I1 ω k3)² + I1 (1 − k3²) (I1 ω² + U'')."""
    def point(draw, on):
        values = {"I1": number(draw, 1), "I3": number(draw, 1), "omega": number(draw) or Fraction(1)}
        values |= {"k3": Fraction(draw.randint(-49, 49), 50)}
        I1, I3, w, z = values.values()
        a = [number(draw) for _ in range(DEGREE)]
        slope = sum(n * c * z ** (n - 1) for n, c in enumerate(a, 1))
        bend = sum(n * (n - 1) * c * z ** (n - 2) for n, c in enumerate(a, 1) if n > 1)
        l = slope / w + w * z * (I1 - I3)
        # U'' is corrected with U' kept: a2 (z² − 2 z·z) has the slope 0
        if on:
            wanted = -(I3 * w * z + l - 2 * I1 * w * z) ** 2 / (I1 * (1 - z * z)) - I1 * w * w
            a[1], a[0], bend = a[1] + (wanted - bend) / 2, a[0] - (wanted - bend) * z, wanted
        margin = (I3 * w * z + l - 2 * I1 * w * z) ** 2 + I1 * (1 - z * z) * (I1 * w * w + bend)
        if coefficients:
            return values | {f"a{n}": c for n, c in enumerate(a, 1)}, margin
        return values | {"l": l, "d2U": bend}, margin
    return point


def cases():
    body, k3 = gs.symmetric_gyrostat(), gs.symbol("k3")
    polynomial = gs.axial_potential(sum(gs.symbol(f"a{n}") * k3**n for n in range(1, DEGREE + 1)))
    for field, name in ((gs.axial_potential(), "U unspecified"),
                        (polynomial, f"U of degree {DEGREE}, its coefficients too")):
        scene, given = gs.assemble(body, field), name != "U unspecified"
        yield f"E1, {name}", gs.analyze(gs.upright(scene)), vertical(1, given)
        yield f"E2, {name}", gs.analyze(gs.hanging(scene)), vertical(-1, given)
        yield f"E3, {name}", gs.analyze(gs.inclined(scene)), inclined(given)


def timed(report, point, blocks, draw):
    """Seconds of a verdict and of a subs, block by block in turn, and the numbers of wrong signs."""
    ours, theirs, wrong, wrong_subs = [], [], 0, 0
    (condition,), = report.sufficient.alternatives
    report.verdict(point(draw, False)[0])
    for _ in range(blocks):
        points = [point(draw, n % 3 == 0) for n in range(BLOCK)]
        rationals = [{gs.symbol(name): sympy.Rational(v.numerator, v.denominator)
                      for name, v in values.items()} for values, _ in points]
        begin = cpu()
        decisions = [report.verdict(values) for values, _ in points]
        middle = cpu()
        inserted = [condition.margin.subs(numbers) for numbers in rationals]
        theirs.append((cpu() - middle) / BLOCK)
        ours.append((middle - begin) / BLOCK)
        for (_, margin), decision, value in zip(points, decisions, inserted):
            # positive factors are taken out of ours: the same sign
            exact = (margin > 0) - (margin < 0)
            wrong += sympy.sign(decision.margins[0][1]) != exact
            wrong += exact != 0 and decision.verdict.name != ("STABLE" if exact > 0 else "UNSTABLE")
            wrong_subs += sympy.sign(value) != exact
    return ours, theirs, wrong, wrong_subs


def drawn(draw, quadratic):
    """A body, a rotor, c and Q of U = c·k + k·Qk/2, and the scene."""
    inertia = [Fraction(draw.randint(4, 30), 10) for _ in range(3)]
    rotor, c = ([number(draw) / 5 for _ in range(3)] for _ in range(2))
    half = [[number(draw) / 5 if quadratic else Fraction(0) for _ in range(3)] for _ in range(3)]
    Q, k = sympy.Matrix(half) + sympy.Matrix(half).T, sympy.Matrix([gs.symbol(f"k{n}") for n in (1, 2, 3)])
    U = gs.general_potential((sympy.Matrix(c).T * k + k.T * Q * k / 2)[0].expand())
    doubles = np.diag(inertia), rotor, c, Q.tolist()
    return [np.array(x, float) for x in doubles], gs.assemble(gs.Gyrostat(tuple(inertia), tuple(rotor)), U)


def counted(data, rotations, on_level):
    """Maxima − saddles + minima of what is critical at the rotations; None where one is no rotation."""
    inertia, rotor, c, Q = data
    count = 0
    for found in rotations:
        k, omega = np.array(found.directions[0], float), float(found.rates["omega"])
        gradient = c + Q @ k - omega * rotor - omega**2 * inertia @ k
        if np.abs(np.cross(gradient, k)).max() > 1e-9 * (1 + np.abs(gradient).max()):
            return None
        v, along = 2 * omega * inertia @ k + rotor, k @ inertia @ k
        hessian = Q - omega**2 * inertia - gradient @ k * np.eye(3) + on_level * np.outer(v, v) / along
        across = np.linalg.svd(k[None])[2][1:]
        count += np.sign(np.linalg.det(across @ hessian @ across.T))
    return count


def all_rotations(draw, asked, quadratic, scenes):
    """Seconds of all rotations of a scene, how many there are, and how many counts are wrong."""
    times, found, wrong = [], 0, 0
    for _ in range(scenes):
        data, scene = drawn(draw, quadratic)
        begin = cpu()
        rotations = gs.relative_equilibria(scene, {asked: number(draw) / 3})
        for rotation in rotations:
            rotation.decision  # noqa: B018
        times.append(cpu() - begin)
        found, wrong = found + len(rotations), wrong + (counted(data, rotations, asked == "C1") != 2)
    return times, found, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    blocks = 1 if parser.parse_args().quick else 9
    draw, failed = random.Random(20261121), 0
    print(f"{here_and_now('sympy', 'python-flint')}; medians (min–max) of {blocks} blocks of {BLOCK} random "
          "rational points, a third of them exactly on the boundary, in turn; CPU time.\n")
    print("| one verdict | `Report.verdict`, µs | `margin.subs`, µs | ratio | wrong verdicts | wrong signs "
          "of subs |")
    print("|---|---|---|---|---|---|")
    for name, report, point in cases():
        ours, theirs, wrong, wrong_subs = timed(report, point, blocks, draw)
        failed += wrong
        ratio = statistics.median(ratios(theirs, ours))
        times = f"{spread(ours, '.0f', 1e6)} | {spread(theirs, '.0f', 1e6)}"
        print(f"| {name} | {times} | {ratio:.0f} | {wrong} | {wrong_subs} |")
    scenes = 3 if blocks == 1 else 60
    print(f"\n| all permanent rotations, {scenes} scenes | median (min–max), ms | found | wrong counts |")
    print("|---|---|---|---|")
    for asked in ("omega", "C1"):
        for name in ("linear", "quadratic"):
            times, found, wrong = all_rotations(draw, asked, name == "quadratic", scenes)
            failed += wrong
            print(f"| at given {asked}, U {name} | {spread(times, '.0f', 1e3)} | {found} | {wrong} |")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
