"""A motion by its power series in time, to any number of digits."""
from fractions import Fraction

import mpmath


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
