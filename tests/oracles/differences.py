"""Vectors of mpmath, and rates by differences."""
import mpmath as mp


def cross(a, b):
    return mp.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def rate(f, at=0):
    """df/ds at a number, of a number or a matrix."""
    shape = f(mp.mpf(at))
    if not isinstance(shape, mp.matrix):
        return mp.diff(f, at)
    found = mp.matrix(shape.rows, shape.cols)
    for i in range(shape.rows):
        for j in range(shape.cols):
            found[i, j] = mp.diff(lambda s, i=i, j=j: f(s)[i, j], at)
    return found
