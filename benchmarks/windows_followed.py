"""Do rotations in windows and at resonances move as their verdicts say?

    python benchmarks/windows_followed.py            windows for 10⁵ periods, most resonances for 10⁴
    python benchmarks/windows_followed.py --quick    one case of each kind

Exit status 1 on a contradiction.

The rotations are those of the tests, at rational points. The Euler-Poisson equations of the whole system, by
heyoka's Taylor method to 10⁻¹⁶; the start is off by ε, on the level of C1 where a resonance is followed. A
deviation is that of the worst coordinate. STABLE in a window: deviation/ε is the same for two ε. STABLE at a
resonance: small, and no greater in the second half of the time than in the first, but for a quarter; at 1:1
and at q = 0 it goes as a root of ε. UNSTABLE: some start comes to twenty times the deviation of its first
period.
"""
import argparse
import random
import sys
import time
from collections import Counter
from itertools import islice, product
from pathlib import Path

import heyoka
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "tests"), str(HERE.parent / "tests" / "oracles")]
from exceptional_rotations import (  # noqa: E402
    degenerate,
    in_a_window,
    in_resonance,
    terms,
    with_form,
    without_the_cubic_term,
    without_twist,
)
from normal_form import energy, field_of  # noqa: E402
from window_scenes import windows  # noqa: E402

import gyrostat as gs  # noqa: E402

ORDERS = [e for e in product(range(5), repeat=3) if 0 < sum(e) <= 4]
POINTS = 3                                                 # of a period
SMALL, TINY, STARTS = (1e-5, 1e-6), 1e-8, 8
SLOW = 1e-6                                                # ε beside an eigenvalue 0


def integrator():
    """π' = M × ω + k × ∇U, k' = k × ω; the body, the rotor and the terms of U are parameters."""
    x = heyoka.make_vars("p1", "p2", "p3", "k1", "k2", "k3")
    p, k, par = x[:3], x[3:], heyoka.par

    def power(y, n):
        return heyoka.expression(1.0) if n == 0 else y if n == 1 else y ** float(n)

    def slope(i):
        found = []
        for m, orders in enumerate(ORDERS):
            if orders[i]:
                a, b, c = (n - (j == i) for j, n in enumerate(orders))
                factors = power(k[0], a) * power(k[1], b) * power(k[2], c)
                found.append(par[12 + m] * float(orders[i]) * factors)
        return heyoka.sum(found)

    def cross(a, b):
        return [a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3] for i in range(3)]

    rate = [heyoka.sum([par[3 * i + j] * p[j] for j in range(3)]) for i in range(3)]
    turning = cross([y + par[9 + i] for i, y in enumerate(p)], rate)
    right = [a + b for a, b in zip(turning, cross(k, [slope(i) for i in range(3)]))] + cross(k, rate)
    return heyoka.taylor_adaptive(list(zip(x, right)), [0.0] * 6, tol=1e-16)


def deviations(taylor, rotation, rng, size, periods, on_level):
    """How far the motion is from the rotation, at every third of a period."""
    doubles = [float(c) for row in rotation.inverse for c in row] + [float(c) for c in rotation.rotor]
    taylor.pars[:] = doubles + [float(rotation.field.get(e, 0)) for e in ORDERS]
    l, k = np.array(rotation.rotor, float), np.array(rotation.k, float)
    M = np.array(rotation.momentum, float)
    direction = rng.normal(size=6)
    direction *= size / np.linalg.norm(direction)
    place = k + direction[3:]
    place /= np.linalg.norm(place)
    start = M + direction[:3] * np.abs(M).max()
    if on_level:
        start += (M @ k - start @ place) * place
    taylor.time = 0.0
    taylor.state[:] = [*(start - l), *place]
    step = period(rotation) / POINTS
    # a state that is not finite has left
    found = taylor.propagate_grid(np.arange(periods * POINTS) * step)[-1]
    return np.abs(found - np.array([*(M - l), *k])).max(axis=1)


def period(rotation):
    """Of the faster oscillation."""
    _, p, q = field_of(energy(*rotation.parts, 2)[2])
    p, q = (int(x.p) / int(x.q) for x in (p, q))
    return 2 * np.pi / np.sqrt((p + np.sqrt(max(p * p - 4 * q, 0))) / 2)


def proportional(taylor, rotation, seed, periods):
    """deviation/ε at two ε."""
    ratios = [deviations(taylor, rotation, np.random.default_rng(seed), size, periods, False).max() / size
              for size in SMALL]
    return abs(ratios[0] / ratios[1] - 1) < 0.1, f"deviation/ε {ratios[0]:.4g}, {ratios[1]:.4g}"


def bounded(taylor, rotation, seed, periods, size=TINY):
    """Whether the deviation is small, and the second half of the time brings nothing new."""
    found = deviations(taylor, rotation, np.random.default_rng(seed), size, periods, True)
    first, second = (half.max() for half in np.array_split(found, 2))
    return second < 1.25 * first < 1e-2, f"deviation {first:.4g}, then {second:.4g}"


def leaves(taylor, rotation, seed, periods):
    """Whether some start leaves: the shortest motions and the greatest ε first."""
    best = 0
    for length, size in product((100, 1000, periods), (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)):
        rng = np.random.default_rng(seed)
        for _ in range(STARTS):
            found = deviations(taylor, rotation, rng, size, length, True)
            best = max(best, np.nanmax(found) / found[:POINTS].max())
            if best > 20:
                return True, f"{best:.3g} times the first period at ε = {size:g}"
    return False, f"{best:.3g} times the first period"


def resonance(m, n):
    def made(rng):
        given, K = in_resonance(rng, m, n)
        return with_form(*given, K, *terms(rng))
    return made


def without_b(rng):
    given, K = in_resonance(rng, 1, 2)
    return with_form(*given, K, *without_the_cubic_term(rng, given, K))


def eigenvalue_0(rng):
    given, K, above = degenerate(rng, rng.choice([3, 4]))
    return with_form(*given, K, *above)


def equal_frequencies(wanted):
    def made(rng):
        while True:
            rotation = resonance(1, 1)(rng)
            if gs.analyze(rotation.equilibrium()).verdict({}).verdict is wanted:
                return rotation
    return made


def without_D4(rng):
    given, K = in_a_window(rng)
    return with_form(*given, K, *without_twist(rng, given, K))


KINDS = {"1:1, stable": equal_frequencies(gs.Verdict.STABLE),
         "1:1, unstable": equal_frequencies(gs.Verdict.UNSTABLE), "window, D4 = 0": without_D4,
         "1:2": resonance(1, 2), "1:2, b = 0": without_b, "1:3": resonance(1, 3),
         "q = 0": eigenvalue_0}


def cases(count):
    """A kind, a rotation and its verdict."""
    for kind, drawn in (("window, uniform", (False,)), ("window, quadratic", (True,))):
        for rotation in islice(windows(random.Random(kind), *drawn), count):
            yield kind, rotation
    for kind, made in KINDS.items():
        rng = random.Random(kind)
        for _ in range(count):
            yield kind, made(rng)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true")
    quick = parser.parse_args().quick
    count, periods, taylor, wrong = 1 if quick else 12, 100_000, integrator(), 0
    total = Counter()
    for seed, (kind, rotation) in enumerate(cases(count)):
        begun, decision = time.perf_counter(), gs.analyze(rotation.equilibrium()).verdict({})
        if "window" in kind:
            good, said = proportional(taylor, rotation, seed, periods)
        elif decision.verdict is gs.Verdict.UNSTABLE:
            good, said = leaves(taylor, rotation, seed, periods // 10)
        elif kind == "q = 0":
            good, said = bounded(taylor, rotation, seed, periods, SLOW)
        else:
            good, said = bounded(taylor, rotation, seed, periods // 10)
        total[kind, decision.verdict.name, "as said" if good else "NOT AS SAID"] += 1
        wrong += not good
        print(f"{kind:18} {decision.verdict.name:9} {'' if good else 'NOT AS SAID '}{said} "
              f"({time.perf_counter() - begun:.1f} s)", flush=True)
    for key, number in total.items():
        print(*key, number)
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
