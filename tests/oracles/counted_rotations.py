"""The permanent rotations of a free gyrostat: counted, found and decided, with nothing of gyrostat.

Counted by Sturm's theorem in fractions; found by Newton's method from 120 starts; decided by the spectrum of
the linearised field at 50 digits.
"""
from fractions import Fraction as F

import mpmath as mp
import numpy as np
import oracle

DIGITS = 50


def count(moments, rotor, size):
    """Points, and circles of points; all fractions, size not 0, not every moment equal with l = 0.

    Axes of one moment count as one, which carries l if one of them does: Σ l²/(1 − ν I)² = size² has a point
    at each root; one that carries none has two points off the plane of the others, if there is one axis, else
    a circle.
    """
    squares = {i: sum(l * l for l, other in zip(rotor, moments) if other == i) for i in moments}
    carried = {i: square for i, square in squares.items() if square}
    whole = [F(-size * size)]
    for i in carried:
        whole = oracle.product(whole, [F(1), -2 * i, i * i])
    for i, square in carried.items():
        part = [square]
        for other in carried:
            if other != i:
                part = oracle.product(part, [F(1), -2 * other, other * other])
        whole = [c + (part[n] if n < len(part) else 0) for n, c in enumerate(whole)]
    points, circles = oracle.count_roots(whole) if carried else 0, 0
    for i in squares.keys() - carried:
        if size**2 > sum(square / (1 - other / i)**2 for other, square in carried.items()):
            alone = list(moments).count(i) == 1
            points, circles = points + 2 * alone, circles + (not alone)
    return points, circles


def directions(starts, rnd):
    """Evenly over the sphere, turned by chance."""
    n = np.arange(starts) + 0.5
    height, angle = 1 - 2 * n / starts, np.pi * (1 + 5**0.5) * n + rnd.uniform(0, 6)
    across = np.sqrt(1 - height**2)
    points = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=1)
    turn, _ = np.linalg.qr(np.random.default_rng(rnd.randrange(2**32)).normal(size=(3, 3)))
    return points @ turn


def newton(moments, rotor, size, rnd, starts=120):
    """M of every rotation that Newton's method finds in (M, ν), (1 − ν I) M = l and abs(M) = size."""
    I, l, R = np.array([float(x) for x in moments]), np.array([float(x) for x in rotor]), float(size)
    M = R * directions(starts, rnd)
    nu = ((M - l) / I * M).sum(axis=1) / R**2
    with np.errstate(all="ignore"):
        for _ in range(60):
            A = np.zeros((starts, 4, 4))
            A[:, range(3), range(3)] = 1 - nu[:, None] * I
            A[:, :3, 3] = -I * M
            A[:, 3, :3] = 2 * M
            residual = np.concatenate([(1 - nu[:, None] * I) * M - l,
                                       (M**2).sum(axis=1, keepdims=True) - R**2], axis=1)
            step = np.linalg.solve(A, residual[..., None])[..., 0]
            M, nu = M - step[:, :3], nu - step[:, 3]
    found = []
    for m, residue in zip(M, np.abs(residual).max(axis=1)):
        if residue < 1e-9 * max(1.0, R) and all(np.abs(m - other).max() > 1e-6 * R for other in found):
            found.append(m)
    return found


def growth(moments, rotor, momentum):
    """The largest real part of the spectrum of Ṁ = M × ω at M, numbers of mpmath, at 50 digits.

    Trace and determinant are 0: it is 0 and the roots of λ² + the sum of the principal minors.
    """
    with mp.workdps(DIGITS):
        I, l = ([mp.mpf(x.numerator) / x.denominator for x in vector] for vector in (moments, rotor))
        rate = [(m - a) / i for m, a, i in zip(momentum, l, I)]
        # δṀ = δM × ω + M × I⁻¹ δM
        J = -hat(rate) + hat(momentum) * mp.diag([1 / i for i in I])
        cube = J * J * J                                   # 3 det, where the trace is 0
        tiny = mp.mpf(10)**-40 * (1 + mp.mnorm(J))**3
        assert all(abs(sum(X[i, i] for i in range(3))) < tiny for X in (J, cube))
        minors = sum(J[i, i] * J[j, j] - J[i, j] * J[j, i] for i, j in ((0, 1), (1, 2), (2, 0)))
        return mp.sqrt(max(-minors, 0))


def hat(v):
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
