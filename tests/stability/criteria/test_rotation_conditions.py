"""The conditions for a permanent rotation off the axes, against the matrix of the second variation."""
import random
from fractions import Fraction

import pytest
from heavy_scenes import drawn, k1, k2, k3
from slow import sampled
from sympy import Matrix, Rational, symbols

import gyrostat as gs
from gyrostat.algebra.reals.exact import Point
from gyrostat.stability.criteria.energy_casimir import secular_variation
from gyrostat.stability.criteria.three_criteria import formal_criterion, secular_criterion
from gyrostat.stability.criteria.truth import holds

TURN = Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
w, s = symbols("w s", real=True)


def rotation(rng, turned=False):
    """A rotation in a direction off every axis, of a body in a quadratic field, or of a full tensor."""
    inertia, rotor, _, Q, omega = drawn(rng, True)
    a, b = (Fraction(rng.choice([-5, -3, -1, 2, 4]), rng.randint(1, 4)) for _ in range(2))
    k = Matrix([2 * a, 2 * b, a * a + b * b - 1]) / (1 + a * a + b * b)
    sigma = Fraction(rng.randint(-40, 9), 2)
    body, rotor, Q = Matrix.diag(*inertia), Matrix(rotor), Matrix(Q)
    if turned:
        body, rotor, Q = TURN * body * TURN.T, TURN * rotor, TURN * Q * TURN.T
    c = omega**2 * body * k + omega * rotor + sigma * k - Q * k
    tensor = gs.Gyrostat(body.tolist(), tuple(rotor)) if turned else gs.Gyrostat(inertia, tuple(rotor))
    U = sum((x + y / 2) * z for x, y, z in zip(c, Q * Matrix([k1, k2, k3]), (k1, k2, k3)))
    return gs.equilibrium(gs.assemble(tensor, gs.general_potential(U)), (*(omega * body * k), *k))


@pytest.mark.slow
@pytest.mark.parametrize("turned", [False, True])
def test_positive_definite_where_the_matrix_is(turned, full):
    rng = random.Random(f"conditions {turned}")
    seen = set()
    for _ in range(sampled(300, full, 12)):
        eq = rotation(rng, turned)
        matrix = gs.derivation.second_variation(eq).matrix
        wanted = all(matrix[:n, :n].det() > 0 for n in range(1, 5))
        assert holds(formal_criterion(gs.derivation.second_variation(eq)), Point({}), {}) is wanted
        assert holds(secular_criterion(secular_variation(eq)), Point({}), {}) is wanted
        seen.add(wanted)
    assert seen == {True, False}


def conditions(k, moments=(3, 5, 4)):
    """Of U = c·k with c = w² Ik + s k, in w and s."""
    body = Matrix.diag(*moments)
    c = w**2 * body * Matrix(k) + s * Matrix(k)
    U = sum(x * y for x, y in zip(c, (k1, k2, k3)))
    scene = gs.assemble(gs.Gyrostat(moments, (0, 0, 0)), gs.general_potential(U))
    report = gs.analyze(gs.equilibrium(scene, (*(w * body * Matrix(k)), *k)))
    return [report.sufficient, report.damped]


def test_off_every_plane_trace_and_determinant_are_the_conditions():
    """At w = −1, s = −3 the values are known: t = −61/33, s = 8/33, a maximum."""
    for criterion in conditions([Rational(x, 3) for x in (2, 1, 2)]):
        (alternative,) = criterion.alternatives
        assert [c.source for c in alternative] == ["t", "s"]
        assert [c.margin.xreplace({w: -1, s: -3}) for c in alternative] == [-61, 8]


def test_where_the_matrix_splits_its_minors_are_the_conditions():
    """In a plane of symmetry, and along an axis."""
    for k in [(Rational(3, 5), 0, Rational(4, 5)), (0, 0, 1)]:
        for criterion in conditions(k):
            (alternative,) = criterion.alternatives
            assert all("minor" in c.source for c in alternative)
            assert -s - 5 * w**2 in [c.margin for c in alternative]


def test_that_k_dot_ik_is_positive_is_no_condition():
    """In the plane of symmetry the second variation splits, and a minor is I1 u² + I3 v²."""
    u = gs.symbol("u")
    U = gs.general_potential(lambda k1, k2, k3: gs.symbol("m") * k1 + gs.symbol("n") * k3)
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)), U)
    direction = (1 - u**2) / (1 + u**2), 0, 2 * u / (1 + u**2)
    ((one, other),) = gs.analyze(gs.permanent_rotation(scene, direction)).sufficient.alternatives
    assert all(gs.symbol("sigma") in c.margin.free_symbols for c in (one, other))
