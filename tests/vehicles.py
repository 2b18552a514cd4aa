"""Random vehicles that translate, in fractions; the scene of a vehicle of the oracle."""
from fractions import Fraction

from kirchhoff import SPHERE, Vehicle
from satellites import exact
from two_directions import cross, dot
from two_directions import random_fraction as some

import gyrostat as gs

ZERO = Fraction(0)
d = gs.symbol("d")
SHIFTED = [[0, -d, 0], [d, 0, 0], [0, 0, 0]]               # m hat(c), c on axis 3


def margins(criterion):
    """Of a criterion of one alternative."""
    (conditions,) = criterion.alternatives
    return {c.margin.expand() for c in conditions}


def unit(rng):
    """A rational unit vector."""
    a, b = rng.randint(-3, 3), rng.randint(-3, 3)
    s = 1 + a * a + b * b
    return [Fraction(2 * a, s), Fraction(2 * b, s), Fraction(s - 2, s)]


def positive(rng):
    """A random positive matrix."""
    G = [[some(rng, 2) + 2 * (i == j) for j in range(3)] for i in range(3)]
    return [[dot(a, b) + (i == j) for j, b in enumerate(G)] for i, a in enumerate(G)]


def translating(rng, parallel=False):
    """A vehicle that translates with the impulse p, down γ, both anywhere, p × v = γ × w; p; velocities."""
    down, p, share = unit(rng), [some(rng, 3) for _ in range(3)], some(rng, 2)
    v, pull = [x + share * y for x, y in zip(p, down)], [-share * x for x in p]
    if parallel:
        ratio = 3 * rng.choice((-1, 1))
        p = [ratio * x for x in down]
        v = [x + some(rng, 1) for x in p]
        pull = [ratio * x for x in v]
    if dot(v, p) <= 0 or not parallel and not any(cross(p, down)):
        return translating(rng, parallel)
    S, hat = positive(rng), [[ZERO, -v[2], v[1]], [v[2], ZERO, -v[0]], [-v[1], v[0], ZERO]]
    half = [[dot(row, column) for column in zip(*hat)] for row in S]
    turned = [[dot(column, other) for other in zip(*half)] for column in zip(*hat)]
    M = [[p[i] * p[j] / dot(v, p) + turned[i][j] for j in range(3)] for i in range(3)]
    D = [[some(rng, 2) for _ in range(3)] for _ in range(3)]
    still = Vehicle(M, [[ZERO] * 3] * 3, positive(rng), [], [])
    columns = [still.accelerations([Fraction(i == n) for i in range(9)])[:3] for n in range(3)]
    moved = [[sum(D[i][a] * columns[b][a] * D[j][b] for a in range(3) for b in range(3)) for j in range(3)]
             for i in range(3)]
    J = [[x + y + SPHERE * (i == j) for j, (x, y) in enumerate(zip(*rows))]
         for i, rows in enumerate(zip(moved, positive(rng)))]
    heavy = some(rng)
    weight = [x + heavy * y for x, y in zip(pull, down)]
    return Vehicle(J, D, M, weight, [some(rng) for _ in range(3)]), p, [ZERO] * 3 + v + down


def scene_of(vehicle, weight=True):
    """The scene of a vehicle of the oracle."""
    return gs.underwater_vehicle(
        *([exact(row) for row in rows] for rows in (vehicle.J, vehicle.M, vehicle.D)),
        weight=exact(vehicle.weight) if weight else None, gyrostatic_momentum=exact(vehicle.rotor))
