"""Independent oracle: the Euler-Poisson equations, differenced. Imports nothing of gyrostat.

On object arrays of Fractions everything is exact: a field of degree two has exact central differences,
whatever the step. A potential enters through its derivatives at the equilibrium, U'(k3) = u1 + u2 (k3 - z).
"""
from fractions import Fraction

import numpy as np

from .polynomials import polynomial


def exact(values):
    return np.array([Fraction(v) for v in values], dtype=object)


def cross(a, b):
    """a × b of objects; np.cross of NumPy 2.0 takes them for doubles."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def field(x, inertia, rotor, slope):
    """π' = (π + l) × ω + k × ∇U, k' = k × ω; slope(k) = ∇U."""
    pi, k = x[:3], x[3:]
    omega = pi / inertia
    return np.concatenate([cross(pi + rotor, omega) + cross(k, slope(k)), cross(k, omega)])


def free_field(pi, inertia, rotor):
    """π' = (π + l) × ω."""
    return cross(pi + rotor, pi / inertia)


def jacobian(f, x, step=Fraction(1)):
    """Central differences, exact for fields of degree at most two."""
    columns = []
    for i in range(len(x)):
        e = np.array([step if j == i else 0 * step for j in range(len(x))], dtype=object)
        columns.append((f(x + e) - f(x - e)) / (2 * step))
    return np.array(columns, dtype=object).T


def characteristic(matrix):
    """Coefficients c0 = 1, c1, …, cn of det(λ - A), by Newton's identities on traces."""
    n = len(matrix)
    traces, power = [], np.array([[Fraction(int(i == j)) for j in range(n)] for i in range(n)], dtype=object)
    for _ in range(n):
        power = power.dot(matrix)
        traces.append(sum(power[i, i] for i in range(n)))
    c = [Fraction(1)]
    for k in range(1, n + 1):
        c.append(-sum(c[k - i] * traces[i - 1] for i in range(1, k + 1)) / k)
    return c


def axial_slope(u1, u2, z):
    """∇U for U'(k3) = u1 + u2 (k3 - z)."""
    return lambda k: np.array([0 * u1, 0 * u1, u1 + u2 * (k[2] - z)], dtype=object)


def vertical(I1, I3, l, pi3, s, u1, u2):
    """Point and field of E1 (s = 1) and E2 (s = -1)."""
    slope = axial_slope(u1, u2, s)
    inertia, rotor = exact([I1, I1, I3]), exact([0, 0, l])
    return exact([0, 0, pi3, 0, 0, s]), lambda x: field(x, inertia, rotor, slope)


def inclined(I1, I3, l, omega, k, u2):
    """Point and field of E3 at the rational unit vector k; U' is what the balance asks for."""
    inertia, rotor, k = exact([I1, I1, I3]), exact([0, 0, l]), exact(k)
    u1 = omega * l - omega**2 * k[2] * (I1 - I3)
    return np.concatenate([inertia * k * omega,
                           k]), lambda x: field(x, inertia, rotor, axial_slope(u1, u2, k[2]))


def growth(f, x):
    """Whether the linearised field has an eigenvalue with positive real part, exactly.

    The 6×6 polynomial is λ² (λ⁴ + p λ² + q): the two Casimirs give λ².
    """
    c = characteristic(jacobian(f, x))
    assert c[1] == c[3] == c[5] == c[6] == 0
    p, q = c[2], c[4]
    return p < 0 or q < 0 or p * p < 4 * q


def reduced(I1, l, pi3, v, e, u0, u1, u2, z):
    """Taylor coefficients at z of g = 2 I1 (e - U)(1 - k3²) - (v - P k3)², to order two; I1² k3'² = g."""
    P = pi3 + l
    potential = [e - u0, -u1, -u2 / 2]                 # e - U in powers of k3 - z
    sphere = [1 - z * z, -2 * z, -1]
    drift = [v - P * z, -P]
    product = [sum(potential[i] * sphere[n - i] for i in range(n + 1)) for n in range(3)]
    square = [drift[0] ** 2, 2 * drift[0] * drift[1], drift[1] ** 2]
    return [2 * I1 * a - b for a, b in zip(product, square)]


def verdict_vertical(I1, l, pi3, s, u1):
    """1 stable, -1 unstable, 0 on the boundary.

    Sign of -g'' of the reduced motion at the pole (double root there).
    """
    P = pi3 + l
    g = reduced(I1, l, pi3, s * P, Fraction(0), Fraction(0), u1, Fraction(0), Fraction(s))
    assert g[0] == g[1] == 0
    return (g[2] < 0) - (g[2] > 0)


def verdict_inclined(I1, I3, l, omega, z, u2):
    """The same at an inclined double root."""
    margin = verdict_inclined_margin(I1, I3, l, omega, z, u2)
    return (margin > 0) - (margin < 0)


def verdict_inclined_margin(I1, I3, l, omega, z, u2):
    """-g''(z)/2 at the inclined double root, energy and momentum being those of the equilibrium."""
    u1 = omega * l - omega**2 * z * (I1 - I3)
    pi3 = I3 * omega * z
    v = I1 * omega * (1 - z * z) + (pi3 + l) * z
    e = I1 * omega**2 * (1 - z * z) / 2                # h - π3²/(2 I3), with U = 0 at the equilibrium
    g = reduced(I1, l, pi3, v, e, Fraction(0), u1, u2, z)
    assert g[0] == g[1] == 0
    return -g[2]


def axial_integrals(x, I1, l, potential):
    """e = h − π3²/(2 I3), v = (π + l)·k, P = π3 + l for U(k3) = a0 + a1 k3 + …"""
    pi, k = x[:3], x[3:]
    P = pi[2] + l
    return (
        (pi[0] ** 2 + pi[1] ** 2) / (2 * I1) + polynomial(potential, k[2]),
        pi[0] * k[0] + pi[1] * k[1] + P * k[2],
        P,
    )


def axial_field(x, I1, I3, l, slope):
    """The field above, written out for I1 = I2, l = (0, 0, l), U = U(k3): numbers, not arrays.

    The argument slope is U', by its coefficients.
    """
    p1, p2, p3, k1, k2, k3 = x
    w1, w2, w3, u = p1 / I1, p2 / I1, p3 / I3, polynomial(slope, k3)
    return [p2 * w3 - (p3 + l) * w2 + k2 * u, (p3 + l) * w1 - p1 * w3 - k1 * u, p1 * w2 - p2 * w1,
            k2 * w3 - k3 * w2, k3 * w1 - k1 * w3, k1 * w2 - k2 * w1]


def rank(rows):
    """Rank of a matrix of Fractions."""
    rows, found = [list(row) for row in rows], 0
    for column in range(len(rows[0])):
        pivot = next((i for i in range(found, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[found], rows[pivot] = rows[pivot], rows[found]
        for i in range(found + 1, len(rows)):
            factor = rows[i][column] / rows[found][column]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[found])]
        found += 1
    return found


def orbit_basis(x, rotor):
    """Basis of the tangent space {δπ·k + M·δk = 0, k·δk = 0} of the coadjoint orbit, as columns, shape (6,
    4); k1 ≠ 0.
    """
    M, k, columns = x[:3] + rotor, x[3:], []
    for free in (1, 2, 4, 5):                          # δπ2, δπ3, δk2, δk3; δk1 and δπ1 follow
        d = exact([int(i == free) for i in range(6)])
        d[3] = -(k[1] * d[4] + k[2] * d[5]) / k[0]
        d[0] = -(k[1] * d[1] + k[2] * d[2] + M.dot(d[3:])) / k[0]
        columns.append(d)
    return np.array(columns, dtype=object).T
