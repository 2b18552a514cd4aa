"""Families of permanent rotations, and random points of them, exact."""
from fractions import Fraction

from heavy_scenes import k1, k2, k3
from sympy import Matrix, Rational, S

import gyrostat as gs

ROTOR = tuple(gs.symbol(f"l{n}") for n in (1, 2, 3))
NAMES = ["I1", "I2", "I3", "l1", "l2", "l3", "k1", "k2", "k3", "omega", "sigma"]
JETS = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]
LINEAR = sum(gs.symbol(f"c{n}") * k for n, k in enumerate((k1, k2, k3), 1))
K = k1, k2, k3
QUADRATIC = LINEAR + sum(gs.symbol(f"b{i + 1}{j + 1}") * K[i] * K[j] / (2 if i == j else 1) for i, j in JETS)


def family(U=None, **body):
    body = {"gyrostatic_momentum": ROTOR} | body
    return gs.analyze(gs.permanent_rotation(gs.assemble(gs.Gyrostat(**body), gs.general_potential(U))))


def drawn(rng, curved):
    """Numbers of a rotation in a Pythagorean direction, and D²U."""
    def number(low=-12):
        return Fraction(rng.randint(low, 12), rng.randint(1, 6))
    a, b, n = rng.randint(-4, 4), rng.randint(-4, 4), rng.randint(1, 3)
    square = a * a + b * b + n * n
    k = [Fraction(x, square) for x in (2 * a * n, 2 * b * n, square - 2 * n * n)]
    rng.shuffle(k)
    moments, rotor = [number(1) for _ in range(3)], [number() / 2 for _ in range(3)]
    numbers = dict(zip(NAMES, [*moments, *rotor, *k, number(), number() * 3]))
    Q = S.Zero * Matrix.zeros(3)
    for i, j in JETS if curved else ():
        Q[i, j] = Q[j, i] = Rational(rng.randint(-8, 8), rng.randint(1, 3))
    return numbers, Q


def parts(numbers, Q):
    """I, l, c of U = c·k + k·Qk/2, k and omega, exact."""
    inertia, rotor, k = (Matrix([Rational(numbers[f"{x}{n}"]) for n in (1, 2, 3)]) for x in ("I", "l", "k"))
    omega, sigma = Rational(numbers["omega"]), Rational(numbers["sigma"])
    inertia = Matrix.diag(*inertia)
    return inertia, rotor, omega**2 * inertia * k + omega * rotor + sigma * k - Q * k, k, omega


def claimed(numbers, Q):
    """The same rotation as a point that is claimed, of a scene in numbers."""
    inertia, rotor, c, k, omega = parts(numbers, Q)
    U = sum((x + y / 2) * z for x, y, z in zip(c, Q * Matrix([k1, k2, k3]), (k1, k2, k3)))
    body = gs.Gyrostat(tuple(inertia.diagonal()), tuple(rotor))
    return gs.equilibrium(gs.assemble(body, gs.general_potential(U)), (*(omega * inertia * k), *k))


def asked(numbers, kind, Q):
    letters = {"linear": "", "quadratic": "b{}{}", "unspecified": "d2U_{}{}"}[kind]
    return numbers | ({letters.format(i + 1, j + 1): Q[i, j] for i, j in JETS} if letters else {})
