"""The least energy of a heavy gyrostat at an angle from a rotation, and its motions: no gyrostat."""
import mpmath
import numpy as np
from scipy.integrate import solve_ivp


class HeavyBody:
    """U = c·k + k·Qk/2, principal moments I, rotors l, all in doubles.

    Parameters
    ----------
    I, l, c : sequence of number, shape (3,)
    Q : sequence of sequence of number, shape (3, 3), symmetric
    """

    def __init__(self, I, l, c, Q):
        self.I, self.l, self.c, self.Q = (np.array(x, dtype=float) for x in (I, l, c, Q))
        self.exact = I, l, c, Q

    def rotation(self, k, omega):
        """The momentum π of a rotation about k, and how far it is from one."""
        pi = omega * self.I * k
        return pi, abs(self.field(0, np.concatenate([pi, k]))).max()

    def field(self, _, y):
        pi, k = y[:3], y[3:]
        rate = pi / self.I
        return np.concatenate([np.cross(pi + self.l, rate) + np.cross(k, self.c + self.Q @ k),
                               np.cross(k, rate)])

    def greatest_angle(self, k, pi, time):
        """How far k goes from where it starts, in degrees."""
        found = self.followed(k, pi, time)
        return np.degrees(np.arctan2(np.linalg.norm(np.cross(found, k), axis=1), found @ k)).max()

    def followed(self, k, pi, time):
        """The directions k of a motion, shape (n, 3)."""
        found = solve_ivp(self.field, (0, time), [*pi, *k], method="DOP853", rtol=1e-11, atol=1e-13)
        return found.y[3:].T

    def turning(self, k, omega):
        """The function V of directions, shape (..., 3), in the frame that turns at a rate."""
        return k @ self.c + ((k @ self.Q) * k).sum(-1) / 2 - omega**2 * k**2 @ self.I / 2 - omega * k @ self.l

    def least(self, k0, omega, degrees, level):
        """The least over π of h − h0 on the circle, in the frame or at given C1, by golden sections."""
        mpmath.mp.dps = 30
        I, l, c, Q = ([mpmath.mpf(x.numerator) / x.denominator for x in v] for v in (*self.exact[:3], sum(
            map(list, self.exact[3]), [])))
        k0 = _unit(k0)
        dot = mpmath.fdot

        def energy(k):
            # least of ½π·I⁻¹π − ω(π + l)·k over π, or of ½π·I⁻¹π with (π + l)·k = C1: π = μ I k
            Ik = [i * x for i, x in zip(I, k)]
            U = dot(c, k) + sum(Q[3 * i + j] * k[i] * k[j] for i in range(3) for j in range(3)) / 2
            mu = (C1 - dot(l, k)) / dot(Ik, k) if level else omega
            pi = [mu * x for x in Ik]
            h = sum(p * p / i for p, i in zip(pi, I)) / 2 + U
            return h if level else h - omega * (dot(pi, k) + dot(l, k))

        C1 = sum((omega * i * x + b) * x for i, x, b in zip(I, k0, l))
        a = _unit(_cross(k0, [1, 0, 0] if abs(k0[0]) < 0.7 else [0, 1, 0]))
        b = _cross(k0, a)
        theta = mpmath.radians(degrees)

        def on(phi):
            return energy([mpmath.cos(theta) * x + mpmath.sin(theta) * (
                mpmath.cos(phi) * y + mpmath.sin(phi) * z) for x, y, z in zip(k0, a, b)])

        step = 2 * mpmath.pi / 72
        heights = [on(step * n) for n in range(72)]
        lows = [n for n in range(72) if heights[n] <= min(heights[n - 1], heights[(n + 1) % 72])]
        return min(_lowest(on, step * (n - 1), step * (n + 1)) for n in lows) - energy(k0)


def _lowest(f, low, high):
    golden = (mpmath.sqrt(5) - 1) / 2
    for _ in range(50):
        x, y = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, y) if f(x) < f(y) else (x, high)
    return f((low + high) / 2)


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _unit(v):
    length = mpmath.sqrt(mpmath.fdot(v, v))
    return [x / length for x in v]
