"""Wells by floods on grids: of functions on the sphere and on the attitudes, without any critical point."""
import heapq

import numpy as np
from scipy import ndimage


def sphere(V, n=180):
    """The values of V on a grid of the sphere, rows between the poles; V takes an array (..., 3)."""
    t, p = (np.arange(n) + 0.5) * np.pi / n, (np.arange(2 * n) + 0.5) * np.pi / n
    T, P = np.meshgrid(t, p, indexing="ij")
    return V(np.stack([np.sin(T) * np.cos(P), np.sin(T) * np.sin(P), np.cos(T)], axis=-1))


def cell_of(k, n=180):
    """The cell of a direction on that grid."""
    row = int(np.arccos(np.clip(k[2], -1, 1)) * n / np.pi)
    return min(row, n - 1), int(np.arctan2(k[1], k[0]) % (2 * np.pi) * n / np.pi) % (2 * n)


def parts(mask):
    """The connected parts of a set on that grid; around a pole its cells touch one another."""
    label, _ = ndimage.label(mask)
    pairs = [*zip(label[:, 0], label[:, -1])]
    for row in (label[0], label[-1]):
        here = row[row > 0]
        pairs += [*zip(here, here[1:])]
    names = np.arange(label.max() + 1)
    for a, b in pairs:
        if a and b:
            names[names == names[a]] = names[b]
    return names[label]


def shape(values, level):
    """Of the part below a level that has the least value: its cells, how many parts the rest has."""
    label = parts(values < level)
    inside = label == label.flat[values.argmin()]
    rest = parts(~inside)
    return inside, len(np.unique(rest[rest > 0]))


def frames(n):
    """The directions n, r of a grid of the attitudes, shapes (n, 2n, 2n, 3)."""
    t, p = (np.arange(n) + 0.5) * np.pi / n, (np.arange(2 * n) + 0.5) * np.pi / n
    T, P, S = np.meshgrid(t, p, p, indexing="ij")
    normal = np.stack([np.sin(T) * np.cos(P), np.sin(T) * np.sin(P), np.cos(T)], axis=-1)
    south = np.stack([np.cos(T) * np.cos(P), np.cos(T) * np.sin(P), -np.sin(T)], axis=-1)
    east = np.stack([-np.sin(P), np.cos(P), 0 * P], axis=-1)
    return normal, np.cos(S)[..., None] * south + np.sin(S)[..., None] * east


def neighbours(cell, shape):
    """The six cells beside one of that grid; over a pole the other two angles turn by half a turn."""
    a, b, c = cell
    n, m, p = shape
    yield a, (b + 1) % m, c
    yield a, (b - 1) % m, c
    yield a, b, (c + 1) % p
    yield a, b, (c - 1) % p
    for row in (a - 1, a + 1):
        inside = 0 <= row < n
        yield (row, b, c) if inside else (a, (b + m // 2) % m, (c + p // 2) % p)


def escape(values, start, goals):
    """The least height over which the water from a cell reaches one of others: of all ways the lowest top."""
    waiting, seen, top = [(values[start], start)], {start}, -np.inf
    while waiting:
        height, cell = heapq.heappop(waiting)
        top = max(top, height)
        if cell in goals:
            return top
        for there in neighbours(cell, values.shape):
            if there not in seen:
                seen.add(there)
                heapq.heappush(waiting, (values[there], there))
    return np.inf
