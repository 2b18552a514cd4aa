"""A full inertia tensor: the same verdicts in any axes, equal as exact numbers."""
import random

import pytest
from slow import sampled, slow
from sympy import Matrix, Rational, diag
from turns import of_quaternion

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign_of_constant


def rotation(draw):
    """A rational rotation, of a quaternion of small whole numbers."""
    while not any(q := [draw.randint(-3, 3) for _ in range(4)]):
        pass
    return of_quaternion(*q)


def positive(draw):
    return Rational(draw.randint(2, 24), draw.choice([4, 5, 6]))


def number(draw):
    return Rational(draw.randint(-24, 24), draw.choice([3, 4, 6, 12]))


def turned(R, inertia, rotor):
    """The body in axes x' = R x."""
    return gs.Gyrostat((R * diag(*inertia) * R.T).tolist(), list(R * Matrix(rotor)))


def told(rotation):
    """What does not depend on the axes; where it lies is compared apart."""
    return (rotation.decision.verdict, rotation.decision.notion, rotation.decision.reason,
            bool(rotation.locus), anywhere(rotation))


def anywhere(rotation):
    """Whether every momentum of that length is an equilibrium."""
    return rotation.locus == "the whole sphere"


def equal(a, b):
    """As exact numbers; of large degree they are the same root of the same polynomial, or are not."""
    return a == b or sign_of_constant(a - b) == 0


def off(rotation, momentum, R):
    """How far R M is from another momentum, or from its circle, in doubles."""
    here, there = R * Matrix(rotation.momentum), Matrix(momentum)
    if rotation.locus and not anywhere(rotation):
        axis = R * Matrix(rotation.form.circle)
        here, there = (Matrix([v.dot(axis)]) / axis.norm() for v in (here, there))
    return 0 if anywhere(rotation) else max(abs(float(x)) for x in (here - there).evalf(30))


@pytest.mark.slow
@pytest.mark.parametrize(("seed", "count"), [(1, 3), *slow((2, 1000))])
def test_a_free_gyrostat_in_any_axes(seed, count, full):
    """Its permanent rotations are the same, those that are degenerate too."""
    draw = random.Random(seed)
    for _ in range(sampled(count, full, 10)):
        inertia = [positive(draw) for _ in range(3)]
        if draw.random() < 0.3:
            inertia[draw.randrange(3)] = inertia[0]
        rotor = [number(draw) if draw.random() < 0.6 else Rational(0) for _ in range(3)]
        R, level = rotation(draw), {"M": positive(draw)}
        one = gs.relative_equilibria(gs.assemble(gs.Gyrostat(inertia, rotor)), level)
        left = gs.relative_equilibria(gs.assemble(turned(R, inertia, rotor)), level)
        for here in one:
            there = next(p for p in left if told(p) == told(here) and off(here, p.momentum, R) < 1e-12)
            assert equal(there.form.nu, here.form.nu)
            left.remove(there)
        assert not left


def in_a_field(draw, revolution):
    """Moments, rotor, π, k and U(x) of a body with an equilibrium at (π, k)."""
    inertia, w = [positive(draw) for _ in range(3)], draw.choice([number(draw), Rational(0)])
    if revolution:                                         # U = a k3 + b k3² + c k3³, at a pole or at a tilt
        inertia[1], l = inertia[0], number(draw)
        k = draw.choice([(0, 0, 1), (Rational(3, 5), 0, Rational(4, 5))])
        b, c = (draw.choice([number(draw), Rational(0)]) for _ in range(2))
        if k[2] == 1:
            momentum = (0, 0, number(draw))
            fastest = (momentum[2] + l) ** 2 / (4 * inertia[0]) - 2 * b - 3 * c
            a = draw.choice([number(draw), fastest])
        else:
            momentum = [w * i * x for i, x in zip(inertia, k)]
            a = w * l - w**2 * k[2] * (inertia[0] - inertia[2]) - 2 * b * k[2] - 3 * c * k[2] ** 2
        return inertia, (0, 0, l), momentum, k, lambda x, y, z: a * z + b * z**2 + c * z**3
    k, rotor, slope = tuple(rotation(draw).row(2)), [number(draw) for _ in range(3)], number(draw)
    bend = Matrix(3, 3, lambda i, j: number(draw))
    momentum = [w * i * x for i, x in zip(inertia, k)]
    g = [w * (p + l) + slope * x for p, l, x in zip(momentum, rotor, k)]

    def field(*x):
        away = Matrix([a - b for a, b in zip(x, k)])
        return sum(a * b for a, b in zip(g, away)) + (away.T * (bend + bend.T) * away)[0] / 4

    return inertia, rotor, momentum, k, field


@pytest.mark.slow
@pytest.mark.parametrize("revolution", [True, False])
@pytest.mark.parametrize(("seed", "count"), [(3, 1), *slow((4, 500))])
def test_a_body_in_a_field_in_any_axes(revolution, seed, count, full):
    """The same verdicts, with and without damping, and the same spectrum; bodies of revolution recognised."""
    draw = random.Random(seed)
    for _ in range(sampled(count, full, 10)):
        inertia, rotor, momentum, k, field = in_a_field(draw, revolution)
        R = rotation(draw)
        point = [*(R * Matrix(momentum)), *(R * Matrix(k))]
        one = gs.analyze(gs.equilibrium(gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(field)),
                                        (*momentum, *k)))
        other = gs.analyze(gs.equilibrium(gs.assemble(
            turned(R, inertia, rotor),
            gs.general_potential(lambda *x: field(*(R.T * Matrix(x))))), point))  # noqa: B023 (called here)
        assert one.linearization.coefficients == other.linearization.coefficients
        for damped in (False, True):
            here, there = (report.verdict({}, damped=damped) for report in (one, other))
            assert (here.verdict, here.growing) == (there.verdict, there.growing)
