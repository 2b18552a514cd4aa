"""Whether the energy of a free gyrostat has a strict extremum at a point of its momentum sphere.

Uses nothing of gyrostat. To 60 digits, the least and the greatest energy on a circle of radius 1e-7 around
the point, by golden section from every dip among 72 places.
"""
import mpmath as mp

RADIUS, PLACES = "1e-7", 72


def is_extremum(moments, rotor, momentum):
    """Of fractions."""
    with mp.workdps(60):
        I, l, M = ([mp.mpf(x.numerator) / x.denominator for x in vector]
                   for vector in (moments, rotor, momentum))
        size = mp.sqrt(mp.fsum(x * x for x in M))
        u = [x / size for x in M]
        least = min(range(3), key=lambda n: abs(u[n]))
        a = [(n == least) - u[least] * x for n, x in enumerate(u)]
        length = mp.sqrt(mp.fsum(x * x for x in a))
        a = [x / length for x in a]
        b = [u[n - 2] * a[n - 1] - u[n - 1] * a[n - 2] for n in range(3)]

        def energy(m):
            return mp.fsum((x - y)**2 / (2 * i) for x, y, i in zip(m, l, I))

        def change(angle):
            c, s, e = mp.cos(angle), mp.sin(angle), mp.mpf(RADIUS)
            return energy([size * (mp.cos(e) * x + mp.sin(e) * (c * y + s * z))
                           for x, y, z in zip(u, a, b)]) - energy(M)

        return _lowest(change) > 0 or _lowest(lambda angle: -change(angle)) > 0


def _lowest(f):
    step = 2 * mp.pi / PLACES
    values = [f(n * step) for n in range(PLACES)]
    dips = [n for n in range(PLACES) if values[n - 1] >= values[n] <= values[(n + 1) % PLACES]]
    return min(_golden(f, (n - 1) * step, (n + 1) * step) for n in dips)


def _golden(f, low, high):
    part = (mp.sqrt(5) - 1) / 2
    for _ in range(90):
        x, y = high - part * (high - low), low + part * (high - low)
        low, high = (low, y) if f(x) < f(y) else (x, high)
    return f((low + high) / 2)
