"""Resonance 1:3 with |D4| = R ≠ 0, at rational points: terms of U are solved for so that both are equal."""
import random
from fractions import Fraction as F

import pytest
from exceptional_rotations import QUARTICS, in_resonance, plain_fraction, terms, with_form
from flint import fmpq, fmpq_mat, fmpz
from normal_form import energy, on_the_torus, resonant
from sympy import symbols
from sympy.solvers.diophantine.diophantine import diop_ternary_quadratic_normal

import gyrostat as gs
from gyrostat.algebra.reals.eigenvalues import in_ratio
from gyrostat.stability.normal_forms.birkhoff import (
    W1,
    W2,
    Z1,
    Z2,
    linear_motion,
    modes,
    normalised,
    real,
    twist,
)
from gyrostat.stability.normal_forms.local_motion import fraction, local_motion


def on_torus(rotation):
    """D4, x and y with R² = a (x² + s y²), then a and s: D4, x and y are affine in the terms of degree 4."""
    motion = local_motion(rotation.equilibrium(), {}, 4)
    parts, values = motion.energy(4, fraction), in_ratio(-fraction(motion.p) / 10, 3)
    found = modes(linear_motion(parts[2]), fraction(motion.p), values)
    kept = Z1 + 3 * W2, W1 + 3 * Z2
    quartic = normalised(parts, found, kept)[4]
    r, slow_one = quartic[kept[0]], values[1]
    s = -real(slow_one * slow_one)
    x, y = real(r + r.conjugate()) / 2, real((r - r.conjugate()) * slow_one) / (-2 * s)
    actions = real(slow_one / found.norms[0]), real(values[0] / found.norms[1])
    return [real(twist(quartic, found)), x, y], 4 * abs(actions[0] * actions[1]**3), s


def square_free(x):
    """Without the squares of a positive fraction, and the root of what is taken out."""
    free = 1
    for prime, power in fmpz(int(x.p) * int(x.q)).factor():
        free *= int(prime) if power % 2 else 1
    root = (x / free).sqrt()
    return free, root


def with_equality(seed):
    """A rotation, R, and the rotations with a little more and a little less of one term."""
    rng = random.Random(seed)
    given, K = in_resonance(rng, 1, 3)
    cubic = [term for term in terms(rng) if len(term[0]) == 3]
    start, a, s = on_torus(with_form(*given, K, *cubic))
    columns = [[x - y for x, y in zip(on_torus(with_form(*given, K, *cubic, (q, F(1))))[0], start)]
               for q in QUARTICS[:3]]
    (a0, a1), (s0, s1) = square_free(a), square_free(s)
    X, Y, T = diop_ternary_quadratic_normal(sum(c * x**2 for c, x in zip((1, s0, -a0), symbols("x y z"))))
    R = fmpq(1, 100)                                       # = a0 a1 T c, x = X c, y = Y c/s1
    c = R / (a0 * a1 * int(T))
    target = [R, int(X) * c, int(Y) * c / s1]
    solved = fmpq_mat([list(row) for row in zip(*columns)]).solve(
        fmpq_mat([[x - y] for x, y in zip(target, start)]))
    quartic = [(q, plain_fraction(solved[n, 0])) for n, q in enumerate(QUARTICS[:3])]
    return R, [with_form(*given, K, *cubic, *quartic, (QUARTICS[0], F(step, 10**6))) for step in (0, 1, -1)]


@pytest.mark.slow
@pytest.mark.parametrize("seed", [11, 16, 34])
def test_equality_is_undecided_and_next_to_it_all_is_decided(seed):
    """By D4 and R of the oracle, in doubles, too."""
    R, (there, *near) = with_equality(seed)
    parts = energy(*there.parts, 4)
    D4, amplitude = on_the_torus(parts, resonant(parts)[4])
    assert [abs(D4), amplitude] == pytest.approx([float(R), float(R)], rel=1e-6)
    decision = gs.analyze(there.equilibrium()).verdict({})
    assert decision.verdict.name == "UNDECIDED"
    assert decision.reason.endswith("resonance 1:3 with |D4| = R: terms of higher degree decide")
    assert {gs.analyze(r.equilibrium()).verdict({}).verdict.name for r in near} == {"STABLE", "UNSTABLE"}
