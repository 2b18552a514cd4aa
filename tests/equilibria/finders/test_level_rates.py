"""Rotations over a factor of the resultant, and rates without one, by Newton's method and in fractions."""
import random
from fractions import Fraction as F

import mpmath as mp
import pytest
from flint import fmpq, fmpq_poly
from sympy import Matrix, Rational

from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.solving.real_fields import FieldNumbers
from gyrostat.equilibria.finders.heavy_levels import rates_on_level
from gyrostat.equilibria.finders.level_rates import Field, LevelZeros, nothing_at


def exact(rows):
    """A matrix, or a column, of fractions."""
    return Matrix([[Rational(x.numerator, x.denominator) for x in row] for row in rows])


def drawn(seed):
    """A body in U = c·k and a level, in tenths."""
    rng = random.Random(seed)
    inertia, rotor, c = ([F(rng.randint(*ends), 10) for _ in range(3)]
                         for ends in ((10, 19), (-9, 9), (-9, 9)))
    return inertia, rotor, c, F(rng.randint(5, 25), 10)


def found_on_level(inertia, rotor, c, level):
    rows = [[inertia[i] * (i == j) for j in range(3)] for i in range(3)]
    return list(rates_on_level(exact(rows), Matrix.zeros(3), exact([[x] for x in c]),
                               exact([[x] for x in rotor]), Rational(level.numerator, level.denominator)))


def polished(data, k, omega):
    """Newton's method for c = ω l + ω² Ik + μ k, |k| = 1, C1 = ω k·Ik + l·k, at 60 digits."""
    inertia, rotor, c, (level,) = ([mp.mpf(x.numerator) / x.denominator for x in v]
                                   for v in (*data[:3], data[3:]))

    def equations(x, y, z, w, m):
        k = (x, y, z)
        return [*(c[n] - w * rotor[n] - w**2 * inertia[n] * k[n] - m * k[n] for n in range(3)),
                x * x + y * y + z * z - 1,
                sum(k[n] * (w * inertia[n] * k[n] + rotor[n]) for n in range(3)) - level]

    mu = sum(k[n] * (c[n] - omega * rotor[n] - omega**2 * inertia[n] * k[n]) for n in range(3))
    return [x[0] for x in mp.findroot(equations, (*k, omega, mu), tol=1e-50).tolist()]


def digits(enclosure):
    return mp.mpf(enclosure.mid().str(58, radius=False))


@pytest.mark.parametrize("seed", [3, 4, 8])
def test_enclosures_solve_the_equations_of_a_rotation(seed):
    """k and ω over a factor agree with Newton's method to 50 digits, ω in increasing order."""
    data = drawn(seed)
    lists = [(omega, k) for omega, k, _ in found_on_level(*data) if isinstance(k, FieldNumbers)]
    assert len(lists) >= 2 and all(isinstance(k.conjugates, LevelZeros) for _, k in lists)
    with mp.workdps(60):
        rates = [digits(ball(omega, 256)) for omega, _ in lists]
        assert rates == sorted(rates)
        for omega, (_, numbers) in zip(rates, lists):
            k = [digits(x) for x in numbers.balls(256)]
            wanted = polished(data, k, omega)
            assert max(abs(x - y) for x, y in zip((*k, omega), wanted)) < mp.mpf(10) ** -50


def test_expressions_are_in_the_enclosures_and_are_no_fractions(monkeypatch):
    """By the sizes of conjugate components, and without them."""
    lists = [k for _, k, _ in found_on_level(*drawn(3)) if isinstance(k, FieldNumbers)]
    k = lists[0]
    assert all(ball(k[n], 256).overlaps(x) for n, x in enumerate(k.balls(192)))
    assert not any(k.is_fraction(n) for n in range(3))
    monkeypatch.setattr(LevelZeros, "varies", lambda *_: False)
    assert not any(k.is_fraction(n) for n in range(3))


def test_enclosures_have_as_many_bits_as_tell_the_rotations():
    """With 128 bits one of these two rotations was not told, and they were sorted the wrong way round."""
    data = [F(17, 10), F(26, 10), F(27, 10)], [F(-1), F(-1, 2), F(-3, 5)], [F(3, 2), F(-2, 5), F(1, 2)], F(1)
    for _, k, _ in found_on_level(*data):
        assert all(x.rad() < 2**-60 for x in k.balls(64))


def level_of(k, inertia, rotor, omega):
    return sum(x * (omega * m * x + l) for x, m, l in zip(k, inertia, rotor))


def orthonormal(a, b, c, d):
    """Three vectors, by a quaternion."""
    size = a * a + b * b + c * c + d * d
    rows = ((a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
            (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
            (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d))
    return [[F(x, size) for x in row] for row in rows]


@pytest.mark.parametrize("seed", range(12))
def test_a_rate_is_kept_if_and_only_if_a_point_along_the_kernel_is_on_the_level(seed):
    """N = κ u uᵀ + λ v vᵀ and b = N a with a = 3u/5: all k are 3u/5 ± 4e/5, on two levels."""
    rng = random.Random(seed)

    def number():
        return F(rng.randint(1, 9) * rng.choice([-1, 1]), rng.randint(1, 4))

    u, v, e = orthonormal(*(rng.randint(-5, 5) or 1 for _ in range(4)))
    inertia, rotor = [F(rng.randint(10, 19), 10) for _ in range(3)], [number() for _ in range(3)]
    omega, sigma, across, along = (number() for _ in range(4))
    N = [[across * u[i] * u[j] + along * v[i] * v[j] for j in range(3)] for i in range(3)]
    Q = [[(omega**2 * inertia[i] + sigma) * (i == j) - N[i][j] for j in range(3)] for i in range(3)]
    c = [F(3, 5) * across * x + omega * l for x, l in zip(u, rotor)]
    rows = [[inertia[i] * (i == j) for j in range(3)] for i in range(3)]
    line = fmpq_poly([fmpq(-sigma.numerator, sigma.denominator), 1])

    def kept(level):
        field = Field(exact(rows), exact(Q), exact([[x] for x in c]), exact([[x] for x in rotor]),
                      Rational(level.numerator, level.denominator))
        return not nothing_at(field, fmpq(omega.numerator, omega.denominator), line, line)

    levels = [level_of([F(3, 5) * x + side * F(4, 5) * y for x, y in zip(u, e)], inertia, rotor, omega)
              for side in (1, -1)]
    assert all(map(kept, levels))
    assert not any(kept(level + F(side, 10**20)) for level in levels for side in (1, -1))
    assert not kept(sum(levels) / 2) or levels[0] == levels[1]


def test_a_rate_is_kept_whose_rotations_are_on_the_level():
    """I = (1, 2, 3), k = (3/5, 0, ±4/5): the kernel is along axis 3, and C1 = omega k·Ik has one value."""
    field = Field(Matrix.diag(1, 2, 3), Matrix.zeros(3), Matrix([Rational(-6, 5), 0, 0]), Matrix.zeros(3, 1),
                  Rational(57, 25))
    line = fmpq_poly([3, 1])                               # N = diag(1, 2, 3) − 3
    assert not nothing_at(field, fmpq(1), line, line)
    assert nothing_at(field._replace(level=Rational(2)), fmpq(1), line, line)
