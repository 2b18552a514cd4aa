"""D4 without eigenvalues, against its derivation and against another chart and another algorithm."""
import random
from collections import Counter
from itertools import islice, product

import pytest
from normal_form import energy, rational, twists
from slow import sampled
from sympy import Poly, expand, rem, symbols
from window_scenes import windows

import gyrostat as gs
from gyrostat.stability.normal_forms.d4_by_averages import _weights, averages
from gyrostat.stability.normal_forms.local_motion import fraction, local_motion

KINDS = {"uniform, at rest in the body": (False, True, False), "uniform, with a rotor": (False,),
         "quadratic": (True,), "quadratic, a tensor": (True, False)}
p, q, a, m = symbols("p q a m")                            # a = ω1², m = ω1 ω2


def check(rotation):
    """Of the energy in the chart of the library, and in that of the oracle."""
    D4 = twists(energy(*rotation.parts, 4))[0]
    found = averages(local_motion(rotation.equilibrium(), {}, 4).energy(4, fraction))
    assert found.top / found.bottom == D4
    assert [found.p, found.q] == [rational(x) for x in
                                  gs.analyze(rotation.equilibrium()).linearization.frequency_coefficients]


@pytest.mark.few(2)
@pytest.mark.parametrize("kind", KINDS)
def test_a_window(kind):
    check(next(windows(random.Random(f"{kind} 3"), *KINDS[kind])))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_many_windows(kind, full):
    for rotation in islice(windows(random.Random(f"{kind} 4"), *KINDS[kind]), sampled(150, full, 8)):
        check(rotation)


def reduced(expression):
    """In 1, a, m and a m."""
    in_a = rem(expand(expression), a**2 - p * a + q, a)
    return expand(rem(expand(in_a), m**2 - q, m))


@pytest.mark.slow
def test_the_weights_are_the_sum_of_the_forced_motions():
    """Frequencies 2ω1, 2ω2, ω1 ± ω2: each an answer times covariances, over q² (p² − 4q)(25q − 4p²)."""
    found = Counter()

    def add(factor, *forms):
        for chosen in product(*(form.items() for form in forms)):
            order = tuple(sorted(n for n, _ in chosen))
            found[order] += factor * chosen[0][1] * chosen[1][1] * chosen[2][1]

    def mode(other):
        """A³𝕁 + other A𝕁 and A²𝕁 + other 𝕁: covariance, and its change, less their factors."""
        return {3: 1, 1: other}, {2: 1, 0: other}

    for own, other in ((a, p - a), (p - a, a)):
        # over 4 ω1² (4 ω1² − ω2²)
        (even, odd), factor = mode(other), other**3 * (4 * other - own) / 48
        answer, turning = {3: 1, 1: p - 4 * own}, {2: 1, 0: p - 4 * own}
        add(factor, even, even, answer)
        add(-factor * own, odd, odd, answer)
        add(factor * 4 * own, even, odd, turning)
    for both in (m, -m):
        # over m (5m + 2p)
        (first, first_odd), (second, second_odd) = mode(p - a), mode(a)
        factor = (5 * q - 2 * p * both) * q / 4
        answer, turning = {3: 1, 1: -2 * both}, {2: 1, 0: -2 * both}
        add(factor, first, second, answer)
        add(-factor * both, first_odd, second_odd, answer)
        add(factor * (a + both), first_odd, second, turning)
        add(factor * (p - a + both), first, second_odd, turning)
    weights = {tuple(sorted(orders)): c for orders, c in _weights(p, q).items()}
    assert weights.keys() == {orders for orders, c in found.items() if reduced(c) != 0}
    for orders, c in weights.items():
        assert Poly(reduced(48 * found[orders]) - c, p, q, a, m).is_zero
