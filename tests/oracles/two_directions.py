"""A gyrostat in two directions, in fractions: nothing of gyrostat is imported.

h = ½ π·Aπ + π·(B₁a + B₂b) + ½ x·Sx + s·x, x = (a, b), in the bracket π̇ = M × ω + Σ a × ∂h/∂a, ȧ = a × ω.
The linearised field is differenced, exactly for a polynomial, on all nine coordinates; the second variation
is the Hessian with multipliers, restricted to the tangent space of the orbit by a null space of its own.
"""
from fractions import Fraction
from random import Random

Vector = list[Fraction]


def cross(a, b):
    """a × b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    """a·b."""
    return sum((x * y for x, y in zip(a, b)), Fraction(0))


class Scene:
    """By A, the rotor l, β's matrix (3 × 6), and the quadratic and linear part of U in (a, b)."""

    def __init__(self, A, rotor, B, S, s):
        self.A, self.rotor, self.B, self.S, self.s = A, rotor, B, S, s

    def gradient(self, z):
        """∂h/∂π, then ∂h/∂a, ∂h/∂b."""
        pi, x = z[:3], z[3:]
        rate = [dot(row, pi) + dot(b, x) for row, b in zip(self.A, self.B)]
        along = [dot(row, x) + c + sum(self.B[i][j] * pi[i] for i in range(3))
                 for j, (row, c) in enumerate(zip(self.S, self.s))]
        return rate, along

    def field(self, z):
        """ż."""
        rate, along = self.gradient(z)
        M = [p + l for p, l in zip(z[:3], self.rotor)]
        a, b = z[3:6], z[6:]
        turning = [x + y + w for x, y, w in zip(cross(M, rate), cross(a, along[:3]), cross(b, along[3:]))]
        return [*turning, *cross(a, rate), *cross(b, rate)]

    def jacobian(self, z):
        """Central differences of a field of degree two: exact."""
        columns = []
        for n in range(9):
            ahead, behind = ([x + (step if i == n else 0) for i, x in enumerate(z)] for step in (1, -1))
            columns.append([(p - q) / 2 for p, q in zip(self.field(ahead), self.field(behind))])
        return [list(row) for row in zip(*columns)]

    def hessian(self):
        """Of h, constant."""
        return [*([*self.A[i], *self.B[i]] for i in range(3)),
                *([*(self.B[i][j] for i in range(3)), *self.S[j]] for j in range(6))]


def characteristic(rows):
    """1, c1, …, cn of det(λ − J) (Faddeev and Leverrier)."""
    n = len(rows)
    found, power = [Fraction(1)], [[Fraction(0)] * n for _ in range(n)]
    for k in range(1, n + 1):
        power = [[sum(rows[i][m] * power[m][j] for m in range(n)) + (found[-1] * rows[i][j])
                  for j in range(n)] for i in range(n)]
        found.append(-sum(power[i][i] for i in range(n)) / k)
    return found


def sextic(scene, z):
    """c2, c1, c0 of λ⁶ + c2 λ⁴ + c1 λ² + c0: the nine eigenvalues have three zeros beside."""
    found = characteristic(scene.jacobian(z))
    assert not any(found[1::2]) and not any(found[7:])
    return found[2], found[4], found[6]


def signature(rows):
    """Numbers of positive, negative and vanishing squares, by symmetric elimination."""
    rows, counts = [list(row) for row in rows], [0, 0, 0]
    while rows:
        n = len(rows)
        at = next((i for i in range(n) if rows[i][i]), None)
        if at is None:
            pair = next(((i, j) for i in range(n) for j in range(i) if rows[i][j]), None)
            if pair is None:
                counts[2] += n
                break
            i, j = pair
            rows[i] = [x + y for x, y in zip(rows[i], rows[j])]
            for row in rows:
                row[i] += row[j]
            continue
        pivot = rows[at]
        counts[0 if pivot[at] > 0 else 1] += 1
        rows = [[x - row[at] * pivot[m] / pivot[at] for m, x in enumerate(row) if m != at]
                for i, row in enumerate(rows) if i != at]
    return tuple(counts)


def second_variation(scene, z):
    """Its signature on the tangent space of the orbit, δa = θ × a for a turn, δπ free."""
    a, b = z[3:6], z[6:]
    turns = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]
    basis = [[*e, *[Fraction(0)] * 6] for e in turns] + [
        [Fraction(0)] * 3 + cross(e, a) + cross(e, b) for e in turns]
    _, along = scene.gradient(z)
    mu = multipliers(a, b, along)
    form = scene.hessian()
    for i in range(3):
        form[3 + i][3 + i] += 2 * mu[0]
        form[3 + i][6 + i] += mu[1]
        form[6 + i][3 + i] += mu[1]
        form[6 + i][6 + i] += 2 * mu[2]
    return signature([[dot(u, [dot(row, v) for row in form]) for v in basis] for u in basis])


def multipliers(a, b, along):
    """μ with ∂h + μ1 ∂(a·a) + μ2 ∂(a·b) + μ3 ∂(b·b) = 0, the directions independent."""
    aa, ab, bb = dot(a, a), dot(a, b), dot(b, b)
    whole = aa * bb - ab * ab

    def parts(v):
        return ((dot(v, a) * bb - dot(v, b) * ab) / whole, (dot(v, b) * aa - dot(v, a) * ab) / whole)

    (first, mixed), (again, last) = parts(along[:3]), parts(along[3:])
    assert mixed == again
    return -first / 2, -mixed, -last / 2


def random_fraction(rng: Random, size: int = 6) -> Fraction:
    """A small fraction."""
    return Fraction(rng.randint(-size, size), rng.randint(1, 4))


def stable_spectrum(c2, c1, c0) -> bool:
    """Whether all roots of x³ + c2 x² + c1 x + c0 are real and not positive, by Sturm's sequence."""
    if min(c2, c1, c0) < 0:
        return False
    polynomial, count = [Fraction(1), c2, c1, c0], 3
    chain = [polynomial, [3 * polynomial[0], 2 * polynomial[1], polynomial[2]]]
    while True:
        rest = _remainder(chain[-2], chain[-1])
        if not rest:
            break
        chain.append([-x for x in rest])
    distinct = _changes([p[0] * (-1) ** (len(p) - 1) for p in chain]) - _changes([p[0] for p in chain])
    return distinct == count - (len(chain[-1]) - 1)


def _remainder(p, q):
    p = list(p)
    while len(p) >= len(q):
        factor = p[0] / q[0]
        p = [x - factor * y for x, y in zip(p, [*q, *[Fraction(0)] * (len(p) - len(q))])][1:]
    while p and not p[0]:
        p = p[1:]
    return p


def _changes(values):
    signs = [v > 0 for v in values if v]
    return sum(x != y for x, y in zip(signs, signs[1:]))
