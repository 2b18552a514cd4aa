"""Independent oracle: the Euler-Poisson equations with np.cross, differenced. Imports nothing of gyrostat.

On object arrays of Fractions everything is exact: a field of degree two has exact central differences,
whatever the step. A potential enters through its derivatives at the equilibrium, U'(k3) = u1 + u2 (k3 - z).
"""
from fractions import Fraction

import mpmath
import numpy as np


def exact(values):
    return np.array([Fraction(v) for v in values], dtype=object)


def field(x, inertia, rotor, slope):
    """π' = (π + l) × ω + k × ∇U, k' = k × ω; slope(k) = ∇U."""
    pi, k = x[:3], x[3:]
    omega = pi / inertia
    return np.concatenate([np.cross(pi + rotor, omega) + np.cross(k, slope(k)), np.cross(k, omega)])


def free_field(pi, inertia, rotor):
    """π' = (π + l) × ω."""
    return np.cross(pi + rotor, pi / inertia)


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


def polynomial(coefficients, z):
    """a0 + a1 z + a2 z² + …"""
    value = 0 * z
    for a in reversed(coefficients):
        value = value * z + a
    return value


def product(a, b):
    """Coefficients of the product of two polynomials."""
    c = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def quotient(a, b, order):
    """Power series a / b up to the given order.

    B may begin later than with its constant, a then does so too.
    """
    start = next(i for i, y in enumerate(b) if y)
    assert not any(a[:start])
    a, b = list(a[start:]) + [0] * (order + 1), b[start:]
    c = []
    for n in range(order + 1):
        c.append((a[n] - sum(b[j] * c[n - j] for j in range(1, min(n, len(b) - 1) + 1))) / b[0])
    return c


def expand(coefficients, z, sigma):
    """Coefficients in y of a polynomial in z + sigma y."""
    c = list(coefficients)
    for i in range(len(c)):
        for j in reversed(range(i, len(c) - 1)):
            c[j] += z * c[j + 1]
    return [a * sigma**i for i, a in enumerate(c)]


def axial_integrals(x, I1, l, potential):
    """e = h − π3²/(2 I3), v = (π + l)·k, P = π3 + l for U(k3) = a0 + a1 k3 + …"""
    pi, k = x[:3], x[3:]
    P = pi[2] + l
    return (
        (pi[0] ** 2 + pi[1] ** 2) / (2 * I1) + polynomial(potential, k[2]),
        pi[0] * k[0] + pi[1] * k[1] + P * k[2],
        P,
    )


def reduced_motion(I1, e, v, P, potential):
    """Coefficients of g = 2 I1 (e − U)(1 − z²) − (v − P z)², all of them.

    I1² ż² = g(z) along every motion, z = k3.
    """
    energy = [-a for a in potential]
    energy[0] += e
    g = [2 * I1 * c for c in product(energy, [1, 0, -1])]
    for i, c in enumerate(product([v, -P], [v, -P])):
        g[i] -= c
    return g


def axial_field(x, I1, I3, l, slope):
    """The field above, written out for I1 = I2, l = (0, 0, l), U = U(k3): numbers, not arrays.

    Slope = U' as coefficients.
    """
    p1, p2, p3, k1, k2, k3 = x
    w1, w2, w3, u = p1 / I1, p2 / I1, p3 / I3, polynomial(slope, k3)
    return [p2 * w3 - (p3 + l) * w2 + k2 * u, (p3 + l) * w1 - p1 * w3 - k1 * u, p1 * w2 - p2 * w1,
            k2 * w3 - k3 * w2, k3 * w1 - k1 * w3, k1 * w2 - k2 * w1]


def taylor(g, z):
    """Coefficients in x of a polynomial in z + x, by repeated synthetic division.

    Whole numbers stay whole.
    """
    rest, found = list(reversed(g)), []
    while rest:
        carry, quotients = 0, []
        for c in rest:
            carry = carry * z + c
            quotients.append(carry)
        found.append(quotients.pop())
        rest = quotients
    return found


def moves_away(g, z, sides):
    """Whether x² = g(x) has motions that leave its rest point z on a side.

    G > 0 beside z, or g = 0 everywhere.
    """
    rest = list(reversed(g))
    for n in range(len(g)):
        carry, quotients = 0, []
        for c in rest:
            carry = carry * z + c
            quotients.append(carry)
        first, rest = quotients.pop(), quotients
        if first:
            assert n >= 2                              # a rest point is a double root
            return any(first * side**n > 0 for side in sides)
    return True


def whole_motion(A, W, P, B, m, q, r):
    """g at z = y/q in powers of y, times (d r q⁴)², in whole numbers; U has six coefficients.

    I1 = A/d, ω·k = W/r, π3 + l = P/(d r q), U = (B1 z + … + B6 z⁶)/d, k3 = m/q; the state is π1 = I1 ω k1, π2
        = k2 = 0, with
    k1² = 1 − k3², hence 2 I1 e = I1² ω² k1² + 2 I1 U(k3), v = I1 ω k1² + P k3.
    """
    across = q * q - m * m
    V = A * W * across + P * m
    energy = [0] * 7
    for n, b in enumerate(B, 1):
        energy[n] = -b * q ** (6 - n)
    energy[0] = -polynomial(energy, m)
    twice = 2 * A * r * r
    whole = [twice * c for c in energy]
    whole[0] += A * A * W * W * across * q**4
    g = [q * q * c for c in whole] + [0, 0]
    for n, c in enumerate(whole, 2):
        g[n] -= c
    scale = q**4
    g[0] -= scale * V * V
    g[1] += scale * 2 * V * P
    g[2] -= scale * P * P
    return g


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


def slope(f):
    """Coefficients of the derivative of a polynomial."""
    return [n * c for n, c in enumerate(f)][1:]


def _trimmed(f):
    f = list(f)
    while f and not f[-1]:
        f.pop()
    return f


def _division(a, b):
    """Quotient and remainder of polynomials over the rationals."""
    a, q = _trimmed(a), [Fraction(0)] * max(len(a) - len(b) + 1, 0)
    while len(a) >= len(b):
        shift, factor = len(a) - len(b), Fraction(a[-1]) / b[-1]
        q[shift] = factor
        a = _trimmed([x - factor * b[i - shift] if i >= shift else x for i, x in enumerate(a)][:-1])
    return q, a


def count_roots(f, low=None, high=None):
    """Number of distinct real roots of a polynomial over the rationals in an open interval, by Sturm's
    theorem.
    """
    f = _trimmed(f)
    a, b = f, _trimmed(slope(f))
    while b:
        a, b = b, _division(a, b)[1]
    f = _division(f, a)[0]                             # each root once
    chain = [f, slope(f)]
    while _trimmed(chain[-1]):
        chain.append([-c for c in _division(chain[-2], chain[-1])[1]])

    def changes(x, side):
        values = [polynomial(g, x) if x is not None else g[-1] * side ** (len(g) - 1)
                  for g in map(_trimmed, chain) if g]
        signs = [v > 0 for v in values if v]
        return sum(s != t for s, t in zip(signs, signs[1:]))

    return changes(low, -1) - changes(high, 1) - (high is not None and polynomial(f, high) == 0)


def level_slope(I1, P, v, potential):
    """I1 (1 − z²)² V' of the effective potential V = U + (v − P z)²/(2 I1 (1 − z²)), as coefficients."""
    across = product([1, 0, -1], [1, 0, -1])
    first, second = [I1 * c for c in product(across, slope(potential) or [0])], product([v, -P], [-P, v])
    return [(first[n] if n < len(first) else 0) + (second[n] if n < len(second) else 0)
            for n in range(max(len(first), 3))]


def rate_slope(I1, I3, l, omega, potential):
    """U' − ω l + ω² z (I1 − I3), what vanishes on E3, as coefficients."""
    f = [*slope(potential), 0, 0]
    f[0] -= omega * l
    f[1] += omega**2 * (I1 - I3)
    return f


class Series:
    """A power series in time whose coefficients are found when they are asked for, each once."""

    def __init__(self, coefficient):
        self.known, self.coefficient = [], coefficient

    def __getitem__(self, n):
        while len(self.known) <= n:
            self.known.append(self.coefficient(len(self.known)))
        return self.known[n]

    def upto(self, n):
        self[n]
        return self.known[:n + 1]

    def __add__(self, other):
        return Series(lambda n: self[n] + other[n])

    def __sub__(self, other):
        return Series(lambda n: self[n] - other[n])

    def __mul__(self, other):
        return Series(lambda n: mpmath.fdot(self.upto(n), other.upto(n)[::-1]))

    def scaled(self, factor):
        return Series(lambda n: factor * self[n])

    def exp(self):
        """e' = x' e."""
        found = Series(lambda n: mpmath.exp(self[0]) if n == 0
                       else sum(i * self[i] * found[n - i] for i in range(1, n + 1)) / n)
        return found


def constant(value):
    return Series(lambda n: value if n == 0 else mpmath.mpf(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _number(value):
    return (
        mpmath.mpf(value.numerator) / value.denominator if isinstance(value, Fraction) else mpmath.mpf(value)
    )


def _gradient(terms, k):
    """∇U as series, U = Σ coefficient · k1^a k2^b k3^c."""
    slopes = []
    for axis in range(3):
        total = constant(mpmath.mpf(0))
        for coefficient, exponents in terms:
            if exponents[axis]:
                part = constant(_number(coefficient) * exponents[axis])
                for i, power in enumerate(exponents):
                    for _ in range(power - (i == axis)):
                        part = part * k[i]
                total = total + part
        slopes.append(total)
    return slopes


def taylor_motion(inertia, rotor, state, time, potential=(), digits=30, attitude=None):
    """The state at a time, π then k (if any), by Taylor series of M' = M × ω + k × ∇U, k' = k × ω, M = π + l:
    mpmath numbers.

    potential: terms (coefficient, (a, b, c)) of a polynomial in k, or a function from the Series of k3 to
    that of U'(k3). attitude: R at time 0; then (state, R) is returned, R' = R hat(ω), rows r' = r × ω. The
    step keeps the last two of about 1.2 · digits terms below 10^−(digits + 4), with ten digits more in the
    arithmetic.
    """
    with mpmath.workdps(digits + 10):
        inertia, rotor = list(map(_number, inertia)), list(map(_number, rotor))
        values = [_number(x) for x in state] + [_number(x) for row in attitude or () for x in row]
        values[:3] = [p + l for p, l in zip(values, rotor)]
        left, order, small = _number(time), int(1.2 * digits) + 8, mpmath.mpf(10) ** -(digits + 4)
        while left:
            x = _series(values, inertia, rotor, potential, len(state) == 6)
            size = {n: max(abs(s[n]) for s in x) for n in (order - 1, order)}
            step = min(((small / c) ** (mpmath.mpf(1) / n) for n, c in size.items() if c), default=abs(left))
            step = mpmath.sign(left) * min(step, abs(left))
            values, left = [mpmath.polyval(s.upto(order)[::-1], step) for s in x], left - step
        values[:3] = [m - l for m, l in zip(values, rotor)]
        n = len(state)
        return (values[:n], [values[n + i:n + i + 3] for i in (0, 3, 6)]) if attitude else values


def _series(values, inertia, rotor, potential, field):
    """The motion from the values as series: M, k (with a field), rows of R."""
    rates = []
    x = [Series(lambda n, i=i: values[i] if n == 0 else rates[i][n - 1] / n) for i in range(len(values))]
    M, vectors = x[:3], [x[i:i + 3] for i in range(3, len(x), 3)]
    omega = [(m - constant(l)).scaled(1 / moment) for m, l, moment in zip(M, rotor, inertia)]
    turning = cross(M, omega)
    if field:
        k, zero = vectors[0], constant(mpmath.mpf(0))
        slopes = [zero, zero, potential(k[2])] if callable(potential) else _gradient(potential, k)
        turning = [a + b for a, b in zip(turning, cross(k, slopes))]
    rates += turning + [rate for v in vectors for rate in cross(v, omega)]
    return x
