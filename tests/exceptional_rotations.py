"""Rotations in resonance, with an eigenvalue 0 or with D4 = 0, at rational points: U is chosen for it.

With J/det I = r², a square, the matrices K = [[a, b], [b, d]] on the tangent plane with q = ρ² p² are a
quadric with the rational point a = b = 0, B² + A22 d = 0.
"""
from fractions import Fraction as F

from flint import fmpq, fmpq_mat
from normal_form import RING, bracket, energy, monomials, twists, valley
from window_scenes import Rotation, amended, applied, dot, field_about, frame, gyroscopic, number, unit

CUBICS = [(0, 0, 0), (0, 0, 1), (0, 1, 1), (1, 1, 1)]      # products of the two tangent forms
QUARTICS = [(0, 0, 0, 0), (0, 0, 0, 1), (0, 0, 1, 1), (0, 1, 1, 1), (1, 1, 1, 1)]


def body(rng, square=False):
    """A direction, the tensor, the rotor, omega and sigma; and r, where J/det I is to be r²."""
    while True:
        r = F(rng.randint(3, 12), rng.randint(3, 8))
        k, I1, I2 = unit(rng), F(rng.randint(4, 30), 10), F(rng.randint(4, 30), 10)
        I3 = F(rng.randint(4, 30), 10)
        if square:
            below = r**2 * I1 * I2 - k[2]**2
            I3 = (k[0]**2 * I1 + k[1]**2 * I2) / below if below else F(0)
        if F(1, 5) < I3 < 5:
            tensor = [[I * (i == j) for j in range(3)] for i, I in enumerate((I1, I2, I3))]
            return (k, tensor, [number(rng) / 5 for _ in range(3)], number(rng) / 2, number(rng)), r


def with_form(k, tensor, l, omega, sigma, K, *above):
    """The rotation with K on the tangent plane, and terms of U of degree 3 and 4 by their tangent forms."""
    axes = frame(k)[:2]
    given = amended(tensor, l, k, omega, sigma)
    H = [[K[i][j] - dot(axes[i], applied(given, axes[j])) for j in range(2)] for i in range(2)]
    g = [omega**2 * a + omega * b + sigma * c for a, b, c in zip(applied(tensor, k), l, k)]
    forms = [(F(1), g), *((H[i][j] / 2, axes[i], axes[j]) for i in range(2) for j in range(2)),
             *((c, *(axes[n] for n in places)) for places, c in above)]
    return Rotation(tensor, l, k, omega, field_about(k, *forms))


def tangent(k, tensor, l, omega):
    """J/det I, A on the tangent plane, B."""
    share, A, B = gyroscopic(tensor, l, k, omega)
    axes = frame(k)[:2]
    return share, [[dot(x, applied(A, y)) for y in axes] for x in axes], B


def in_resonance(rng, m, n):
    """A body and K with the frequencies as m to n, a maximum of the amended potential."""
    rho = F(m * n, m**2 + n**2)
    while True:
        given, r = body(rng, square=True)
        k, tensor, l, omega, _ = given
        _, A, B = tangent(k, tensor, l, omega)
        da, db, ds = F(-rng.randint(1, 6)), number(rng, 6, 3), number(rng, 6, 3)
        dd = (ds / (rho * r) - A[0][0] * da - 2 * A[0][1] * db) / A[1][1]
        start, size = -B**2 / A[1][1], db**2 + ds**2 - da * dd
        if not (size and B):
            continue
        t = da * start / size
        a, b, d, p = t * da, t * db, start + t * dd, r * t * ds / rho
        if -20 < min(a, d) < max(a, d) < 0 and F(1, 50) < p < 20:
            return given, [[a, b], [b, d]]


def terms(rng):
    """Of degree 3 and 4; those of degree 3 are often small, so that both signs of D4 are met."""
    scale = rng.choice([1, 10, 100])
    return [*((places, number(rng) / scale) for places in CUBICS),
            *((places, number(rng)) for places in QUARTICS)]


def without_the_cubic_term(rng, given, K):
    """Terms of degree 3 for which b of the resonance 1:2 is 0: two linear conditions among the four."""
    base = [(places, number(rng)) for places in CUBICS[2:]]
    plain = energy(*with_form(*given, K, *base).parts, 3)
    basis = monomials(3)
    vectors = kernel(fmpq_mat([[c.get(e, fmpq(0)) for e in basis] for c in (
        bracket(plain[2], RING.from_dict({e: fmpq(1)})).to_dict() for e in basis)]))
    values = [[sum(v[n] * h.to_dict().get(e, fmpq(0)) for n, e in enumerate(basis)) for v in vectors]
              for h in (plain[3], *(energy(*with_form(*given, K, *base, (places, F(1))).parts, 3)[3]
                                    - plain[3] for places in CUBICS[:2]))]
    (r0, r1), (x0, x1), (y0, y1) = values
    size = x0 * y1 - x1 * y0
    first, second = (r1 * y0 - r0 * y1) / size, (r0 * x1 - r1 * x0) / size
    return [*base, (CUBICS[0], plain_fraction(first)), (CUBICS[1], plain_fraction(second))]


def kernel(matrix):
    """A basis of the vectors that a matrix takes to 0."""
    solved, rank = matrix.rref()
    size = matrix.ncols()
    pivots = [next(n for n in range(size) if solved[row, n] != 0) for row in range(rank)]
    found = []
    for free in (n for n in range(size) if n not in pivots):
        vector = [fmpq(int(n == free)) for n in range(size)]
        for row, m in enumerate(pivots):
            vector[m] = -solved[row, free]
        found.append(vector)
    return found


def plain_fraction(x):
    return F(int(x.p), int(x.q))


def without_twist(rng, given, K):
    """Terms of degree 3 and 4 for which D4 is 0, which is affine in those of degree 4."""
    rest = [term for term in terms(rng) if term[0] != QUARTICS[0]]
    (start,), (end,) = (twists(energy(*with_form(*given, K, *rest, *more).parts, 4))
                        for more in ((), ((QUARTICS[0], F(1)),)))
    return [*rest, (QUARTICS[0], plain_fraction(start / (start - end)))]


def in_a_window(rng):
    """A body and K where gyroscopic forces hold a maximum."""
    while True:
        given, _ = body(rng)
        k, tensor, l, omega, _ = given
        share, A, B = tangent(k, tensor, l, omega)
        a, d = (-F(rng.randint(1, 12), rng.randint(1, 6)) for _ in range(2))
        b = number(rng, 4, 6)
        p, q = share * (B**2 + A[0][0] * a + 2 * A[0][1] * b + A[1][1] * d), share * (a * d - b * b)
        if p > 0 and q > 0 and p * p > 4 * q:
            return given, [[a, b], [b, d]]


def degenerate(rng, degree):
    """A body and K of rank 1 with p > 0, and terms that begin with one of that degree along the valley."""
    while True:
        given, _ = body(rng)
        k, tensor, l, omega, _ = given
        share, A, B = tangent(k, tensor, l, omega)
        e, u, v = number(rng), number(rng, 4, 3), number(rng, 4, 3)
        K = [[e * u * u, e * u * v], [e * u * v, e * v * v]]
        if e and v and B**2 + sum(A[i][j] * K[i][j] for i in range(2) for j in range(2)) > 0:
            break
    chosen = terms(rng)
    if degree == 4:
        rest = [term for term in chosen if term[0] != CUBICS[0]]
        start, end = (along_the_valley(with_form(*given, K, *rest, *more))[1]
                      for more in ((), ((CUBICS[0], F(1)),)))
        chosen = [*rest, (CUBICS[0], plain_fraction(start / (start - end)))]
    return given, K, chosen


def along_the_valley(rotation):
    """Of its amended potential, as the oracle finds it."""
    level = dot(rotation.momentum, rotation.k)
    return valley(rotation.tensor, rotation.rotor, rotation.k, level, rotation.field)
