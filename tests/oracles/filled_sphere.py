"""The lowest way from a minimum to another rest, on S² or SO(3), by filling from below.

Points are joined to their neighbours, the edges are taken from the lowest upwards, and where two places are
joined at last the points are made denser. A rotation is ±q on S³. No gyrostat here, and no list of rests.
"""
import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order, minimum_spanning_tree
from scipy.spatial import cKDTree


def frames(q):
    """n and r of rotations q, shape (…, 4): the second and the third column."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    n = np.stack([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)], -1)
    r = np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], -1)
    return n, r


def satellite(I, l, rate):
    """V of attitudes at rest in a circular orbit: gravity gradient, centrifugal energy, rotor."""
    I, l = np.array(I, float), np.array(l, float)

    def V(q):
        n, r = frames(q / np.linalg.norm(q, axis=-1, keepdims=True))
        return 1.5 * rate**2 * (r * r) @ I - 0.5 * rate**2 * (n * n) @ I - rate * n @ l
    return V


def free(I, l, M):
    """h of a free gyrostat on the sphere of its angular momentum."""
    I, l = np.array(I, float), np.array(l, float)

    def V(x):
        m = M * x / np.linalg.norm(x, axis=-1, keepdims=True) - l
        return 0.5 * (m * m) @ (1 / I)
    return V


def rests(V, dimension, rng, starts):
    """Places at which the force vanishes, from starts at random; by differences."""
    steps, found = 1e-6 * np.eye(dimension), []

    def force(x):
        return np.append((V(x + steps) - V(x - steps)) / 2e-6, x @ x - 1)
    for start in rng.normal(size=(starts, dimension)):
        x = least_squares(force, start / np.linalg.norm(start), xtol=1e-14, ftol=1e-14).x
        if np.linalg.norm(force(x)) < 1e-7:
            found.append(x)
    return np.array(found)


def lowest_way(V, x0, rng, double, count, rounds=5, starts=60):
    """The least height over which x0 is joined to another rest, and the rests; double: x and −x are one."""
    x0 = np.array(x0, float)
    found = rests(V, len(x0), rng, starts)
    apart = np.linalg.norm(found - x0, axis=1)
    if double:
        apart = np.minimum(apart, np.linalg.norm(found + x0, axis=1))
    others = found[apart > 1e-3]
    points = rng.normal(size=(count, len(x0)))
    points = np.concatenate([x0[None], others, points / np.linalg.norm(points, axis=1, keepdims=True)])
    radius = 2.5 * count ** (-1 / (len(x0) - 1))
    for _ in range(rounds):
        height, place = _filled(V, points, len(others), double)
        more = place + radius * rng.normal(size=(count // 4, len(x0)))
        points = np.concatenate([points, more / np.linalg.norm(more, axis=1, keepdims=True)])
        radius /= 3
    return height, others


def _filled(V, points, others, double):
    tree = np.concatenate([points, -points]) if double else points
    distance, near = cKDTree(tree).query(points, 13)
    start, end = np.repeat(np.arange(len(points)), 12), near[:, 1:].ravel()
    a, b = points[start], tree[end]
    middle = np.stack([V(a + t * (b - a)) for t in (0.25, 0.5, 0.75)]).max(axis=0)
    height = np.maximum(middle, np.maximum(V(a), V(b)))
    low = height.min() - 1                                 # a weight 0 is no edge
    keep = distance[:, 1:].ravel() < 1
    graph = coo_matrix(((height - low)[keep], (start[keep], (end % len(points))[keep])),
                       shape=(len(points),) * 2).tocsr()
    spanning = minimum_spanning_tree(graph)
    spanning = spanning + spanning.T
    order, before = breadth_first_order(spanning, 0, directed=False)
    top, at = np.full(len(points), np.inf), np.zeros(len(points), int)
    top[0] = -np.inf
    for n in order[1:]:
        step = spanning[n, before[n]] + low
        top[n], at[n] = max((top[before[n]], at[before[n]]), (step, n))
    best = 1 + int(np.argmin(top[1:1 + others]))
    return top[best], points[at[best]]
