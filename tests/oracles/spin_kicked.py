"""Whether a kicked free gyrostat stays about its axis: saddles of its sphere, descents; no gyrostat."""
import numpy as np


def pass_height(I, l, m, sign):
    """The lowest saddle of sign · energy on the sphere of radius m, l along axis n; its maximum if none."""
    n = int(np.argmax(np.abs(l)))
    points = [m * s * np.eye(3)[n] for s in (1, -1)]
    for k in set(range(3)) - {n}:
        M = np.zeros(3)
        M[n] = l[n] / (1 - I[n] / I[k])
        if abs(M[n]) < m:
            M[k] = np.sqrt(m**2 - M[n]**2)
            points.append(M)
    found = []
    for M in points:
        gradient = sign * (M - l) / I
        across = np.linalg.svd(M[None])[2][1:]
        bend = across @ (sign * np.diag(1 / I) - gradient @ M / m**2 * np.eye(3)) @ across.T
        found.append((np.linalg.det(bend) < 0, energy(I, l, M, sign)))
    saddles = [h for saddle, h in found if saddle]
    return min(saddles) if saddles else max(h for _, h in found)


def energy(I, l, M, sign):
    return sign * ((M - l)**2 / I).sum(-1) / 2


def stays(I, l, M, axis, sign):
    """Of momenta, shape (n, 3): whether each is below the pass of its sphere, and runs down to an axis."""
    radius = np.linalg.norm(M, axis=1)
    low = np.array([h < pass_height(I, l, m, sign) for h, m in zip(energy(I, l, M, sign), radius)])
    for _ in range(160):                                   # of 1/30 rad, even where it is nearly flat
        slope = sign * (M - l) / I
        slope -= M * (slope * M).sum(1, keepdims=True) / radius[:, None]**2
        M = M - radius[:, None] / 30 * slope / (np.linalg.norm(slope, axis=1, keepdims=True) + 1e-300)
        M *= radius[:, None] / np.linalg.norm(M, axis=1, keepdims=True)
    return low & (M @ axis > 0.5 * radius)


def least_kick(I, l, start, u, sign):
    """Along each direction, shape (n, 3), how strong a kick is that leads out first, up to 4 abs(start)."""
    m = np.linalg.norm(start)
    steps = np.linspace(0, 4 * m, 81)[1:]
    inside = np.array([stays(I, l, start + t * u, start / m, sign) for t in steps])
    first = np.where(inside.all(0), len(steps), inside.argmin(0))
    high = steps[np.minimum(first, len(steps) - 1)]
    low = np.where(first > 0, steps[first - 1], 0)
    for _ in range(24):
        middle = (low + high) / 2
        fine = stays(I, l, start + middle[:, None] * u, start / m, sign)
        low, high = np.where(fine, middle, low), np.where(fine, high, middle)
    return np.where(first == len(steps), np.inf, low)
