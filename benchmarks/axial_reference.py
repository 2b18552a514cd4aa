"""A body of revolution in U(k3) by Taylor series in whole numbers, to any number of digits.

The package gyrostat is not used.

π̇ = (π + l) × ω + k × ∇U, k̇ = k × ω, ωᵢ = πᵢ/Iᵢ, ∇U = U′(k3) e3. U is a sum of terms, each with its own
    recurrence:

    ("polynomial", c0, c1, …)     Σ cₙ k3ⁿ
    ("exp", A, B)                 A exp(B k3)
    ("sin", A, B, C)              A sin(B k3 + C)
    ("tan", A, B)                 A tan(B k3)
    ("power", A, c, r)            A (k3 + c)^r, r any rational number but 0
    ("log", A, c)                 A log(k3 + c)

All numbers are rational.
"""
from fractions import Fraction
from math import ceil
from operator import mul

from mpmath import cos, exp, floor, mp, mpf, sin, tan, workprec

# bits beyond the digits: for what grows, e.g. away from an unstable pole
GUARD = 96


class Reference:
    """The motion from a state on.

    Parameters
    ----------
    terms : list of tuple
        U
    I1, I3, l : Fraction
    state : six Fractions
    digits : int
        of the states
    """

    def __init__(self, terms, I1, I3, l, state, digits=40):
        self.digits, self.bits = digits, ceil(3.33 * digits) + GUARD
        self.order = digits + 20
        self.terms, self.l = terms, self.fixed(l)
        self.rates = [self.fixed(1 / Fraction(I)) for I in (I1, I1, I3)]
        self.time, self.step, self.x = Fraction(0), Fraction(1, 4), [self.fixed(c) for c in state]

    def fixed(self, x):
        """A rational number times 2^bits."""
        x = Fraction(x)
        return (x.numerator << self.bits) // x.denominator

    def real(self, x):
        """A whole number as the number it stands for."""
        with workprec(self.bits + 20):
            return mpf(x) / (1 << self.bits)

    def at(self, time):
        """The state at a time not before the last one, six mpf."""
        time, small = Fraction(time), (1 << self.bits) // 10 ** (self.digits + 8)
        while self.time < time:
            h = min(self.step, time - self.time)
            columns = self.series(self.x, self.fixed(h))
            last = max(abs(c) for column in columns for c in column[-6:])
            factor = Fraction(
                min(4.0, max(0.05, (small / max(last, 1)) ** (1 / self.order)))
            ).limit_denominator(100)
            if last > 64 * small:
                self.step = h * factor
                continue
            self.x, self.time = [sum(column) for column in columns], self.time + h
            if h == self.step:
                self.step = h * factor
        return [self.real(x) for x in self.x]

    def series(self, x, h):
        """The terms xₙ hⁿ of each coordinate."""
        bits, columns = self.bits, [[c] for c in x]
        p1, p2, p3, k1, k2, k3 = columns
        forces = [self.force(term, k3) for term in self.terms]
        w, slope = [[], [], []], []

        def product(a, b):
            return sum(map(mul, a, reversed(b))) >> bits

        for n in range(1, self.order + 1):
            for i in range(3):
                w[i].append(columns[i][-1] * self.rates[i] >> bits)
            slope.append(sum(next(force) for force in forces))
            l, (w1, w2, w3) = self.l, w
            new = [product(p2, w3) - product(p3, w2) - (l * w2[-1] >> bits) + product(k2, slope),
                   product(p3, w1) - product(p1, w3) + (l * w1[-1] >> bits) - product(k1, slope),
                   product(p1, w2) - product(p2, w1),
                   product(k2, w3) - product(k3, w2), product(k3, w1) - product(k1, w3),
                   product(k1, w2) - product(k2, w1)]
            for column, change in zip(columns, new):
                column.append((change * h >> bits) // n)
        return columns

    def value(self, function, z, B=1, C=0):
        """A function at B z + C, times 2^bits."""
        with workprec(self.bits + 60):
            return int(floor(function(mpf(z) / (1 << self.bits) * number(B) + number(C)) * (1 << self.bits)))

    def force(self, term, z):
        """Of one term, the coefficients of U′(k3), one after another as those of k3 = z become known."""
        kind, *numbers = term
        return getattr(self, kind)(z, *numbers)

    def polynomial(self, z, *c):
        """Horner's rule in series."""
        slopes = [self.fixed(n * Fraction(x)) for n, x in enumerate(c)][1:] or [0]
        parts = [[] for _ in slopes]                   # parts[i]: slopes[i] + z parts[i + 1]
        while True:
            n = len(z) - 1
            for i in range(len(slopes) - 1, -1, -1):
                constant = slopes[i] if n == 0 else 0
                parts[i].append(constant + (sum(map(mul, z, reversed(parts[i + 1]))) >> self.bits
                                            if i + 1 < len(slopes) else 0))
            yield parts[0][n]

    def exp(self, z, A, B):
        """e′ = B e z′."""
        e = [self.value(exp, z[0], B)]
        scale, rate = self.fixed(Fraction(A) * Fraction(B)), self.fixed(B)
        while True:
            yield scale * e[-1] >> self.bits
            n = len(e)
            inner = sum(j * z[j] * e[n - j] for j in range(1, n + 1)) >> self.bits
            e.append((rate * inner >> self.bits) // n)

    def sin(self, z, A, B, C=0):
        """s′ = B c z′, c′ = −B s z′."""
        s, c = [self.value(sin, z[0], B, C)], [self.value(cos, z[0], B, C)]
        scale, rate = self.fixed(Fraction(A) * Fraction(B)), self.fixed(B)
        while True:
            yield scale * c[-1] >> self.bits
            n = len(s)
            first = sum(j * z[j] * c[n - j] for j in range(1, n + 1)) >> self.bits
            second = sum(j * z[j] * s[n - j] for j in range(1, n + 1)) >> self.bits
            s.append((rate * first >> self.bits) // n)
            c.append(-(rate * second >> self.bits) // n)

    def tan(self, z, A, B):
        """T′ = (1 + T²) B z′; the force is A B (1 + T²)."""
        T, square = [self.value(tan, z[0], B)], []
        scale, rate, one = self.fixed(Fraction(A) * Fraction(B)), self.fixed(B), 1 << self.bits
        while True:
            square.append((one if not square else 0) + (sum(map(mul, T, reversed(T))) >> self.bits))
            yield scale * square[-1] >> self.bits
            n = len(T)
            inner = sum(j * z[j] * square[n - j] for j in range(1, n + 1)) >> self.bits
            T.append((rate * inner >> self.bits) // n)

    def power(self, z, A, c, r):
        """y = (z + c)^(r − 1): (z + c) y′ = (r − 1) y z′."""
        r = Fraction(r)
        q = r - 1
        base = z[0] + self.fixed(c)
        y = [self.value(lambda x: x ** number(q), z[0], 1, c)]
        scale, ratio = self.fixed(Fraction(A) * r), self.fixed(q)
        while True:
            yield scale * y[-1] >> self.bits
            n = len(y)
            inner = sum(j * z[j] * y[n - j] for j in range(1, n + 1)) * ratio >> self.bits
            inner -= sum((n - j) * y[n - j] * z[j] for j in range(1, n))
            y.append(inner // (n * base))

    def log(self, z, A, c):
        """The force A/(z + c) is that of the power 0, but for the factor."""
        base = z[0] + self.fixed(c)
        y, scale = [(1 << 2 * self.bits) // base], self.fixed(A)
        while True:
            yield scale * y[-1] >> self.bits
            y.append(-sum(z[j] * y[len(y) - j] for j in range(1, len(y) + 1)) // base)


def number(x):
    """A rational number at the precision of the moment."""
    return mpf(Fraction(x).numerator) / Fraction(x).denominator


def deviation(x, reference):
    """The largest of a coordinate."""
    with workprec(mp.prec + 200):
        return float(max(abs(mpf(a) - b) for a, b in zip(x, reference)))
