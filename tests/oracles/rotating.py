"""Permanent rotations in a field at numbers: the cone of directions, the form that decides, the verdict.

By triple products and by differences along great circles, at 40 digits. Imports nothing of gyrostat.
"""
import mpmath as mp
from differences import cross, dot

TINY = mp.mpf(10) ** -18


def cone(world, x):
    """[k, ∇U, Ik], with a rotor [k, Ik, ∇U]² − [k, Ik, l] [k, ∇U, l]; and omega², with a rotor omega."""
    k = mp.matrix(x[3:])
    g = mp.matrix([world.slope(k, i) for i in range(3)])
    along = mp.matrix([m * y for m, y in zip(world.inertia, k)])
    if not world.turned:
        lever, load = cross(along, k), cross(g, k)
        return dot(k, cross(g, along)), dot(load, lever) / dot(lever, lever)
    a, b, d = (dot(k, cross(*pair)) for pair in ((along, g), (along, world.rotor), (g, world.rotor)))
    return a**2 - b * d, a / b


def form(world, x):
    """Trace and determinant of the second derivatives of U + (C1 − l·k)²/(2 k·Ik) along great circles."""
    k, M = mp.matrix(x[3:]), mp.matrix(x[:3]) + world.rotor
    level, least = dot(M, k), min(range(3), key=lambda i: abs(k[i]))
    first = cross(k, mp.matrix([int(i == least) for i in range(3)]))
    first /= mp.sqrt(dot(first, first))
    second = cross(k, first)

    def bend(way):
        def height(s):
            y = mp.cos(s) * k + mp.sin(s) * way
            across = level - dot(world.rotor, y)
            return world.U(y) + across**2 / (2 * sum(m * z**2 for m, z in zip(world.inertia, y)))
        return mp.diff(height, 0, 2)

    a, b, between = bend(first), bend(second), bend((first + second) / mp.sqrt(2))
    mixed = between - (a + b) / 2
    return a + b, a * b - mixed**2


def definite(world):
    """1 if the form is definite, positive because the momenta are; -1 if a square is negative; 0 at neither.
    """
    trace, determinant = form(world, world.start)
    if determinant < -TINY or trace < -TINY:
        return -1
    return int(determinant > TINY)


def stability(world):
    """1 proved stable, -1 an eigenvalue grows, 0 neither."""
    c = world.characteristic(world.start)
    p, q = c[2], c[4]
    if min(p, q, p**2 - 4 * q) < -TINY:
        return -1
    return max(definite(world), 0)
