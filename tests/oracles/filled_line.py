"""The energy of a body of revolution at a tilt, filled up on a grid, and its motions: no gyrostat here."""
import numpy as np
from scipy.integrate import solve_ivp


class Line:
    """V on −1 ≤ z ≤ 1 as the least energy at each tilt, by brute numbers.

    Parameters
    ----------
    U : sequence of number
        coefficients of the potential, from the constant on
    I1, I3, l : number
    level, spin : number
        C1 and π3; spin None: C1 alone is kept
    """

    def __init__(self, U, I1, I3, l, level, spin=None):
        self.U = np.polynomial.Polynomial([float(u) for u in U])
        self.I1, self.I3, self.l, self.level, self.spin = map(float, (I1, I3, l, level, spin or 0))
        self.damped = spin is None
        total = (spin or 0) + l
        # C1 = s (π3 + l): the pole s is reached
        self.reached = {s: self.damped or level == s * total for s in (-1, 1)}

    def height(self, z):
        """The least of ½ π·I⁻¹π + U at M·k = C1; the momentum across the axis and k is 0."""
        if self.damped:
            inertia = self.I1 * (1 - z**2) + self.I3 * z**2
            return self.U(z) + (self.level - self.l * z) ** 2 / (2 * inertia)
        total = self.spin + self.l
        with np.errstate(divide="ignore", invalid="ignore"):
            across = (self.level - total * z) / np.sqrt(1 - z**2)
        across = np.where(abs(z) == 1, 0, across)
        return self.U(z) + self.spin**2 / (2 * self.I3) + across**2 / (2 * self.I1)

    def side(self, z0, end):
        """(height that is first touched, height at which V falls again) between a minimum and an end."""
        z = z0 + (end - z0) * np.linspace(0, 1, 60001)
        if not self.reached[end]:
            z = z[:-1]
        found = self.height(z)
        highest = np.maximum.accumulate(found)
        fallen = np.nonzero(found < highest - 1e-11 * (1 + abs(highest)))[0]
        if not len(fallen):
            return (found[-1] if self.reached[end] else np.inf), np.inf
        top = np.argmax(found[:fallen[0] + 1])
        for _ in range(4):                                 # the same on the neighbouring steps of the grid
            z = np.linspace(z[max(0, top - 1)], z[min(top + 1, len(z) - 1)], 2001)
            top = np.argmax(self.height(z))
        return (self.height(z[top]),) * 2

    def rise(self, z0):
        """(barrier, escape) above V(z0); (0, 0) where it is no minimum."""
        sides = [self.side(z0, end) for end in (-1, 1) if end != z0]
        return tuple(min(pair) - self.height(np.array([z0]))[0] for pair in zip(*sides))

    def within(self, z0, angle):
        """The least rise with which a tilt an angle away can be reached, or oo."""
        found = []
        for s in (1, -1):
            far = np.arccos(z0) - s * angle
            if z0 * s != 1 and 0 < far < np.pi:
                found.append(self.height(np.cos(np.linspace(np.arccos(z0), far, 200001))).max())
        return min(found, default=np.inf) - self.height(np.array([z0]))[0]


def greatest_angle(U, I1, I3, l, spin, kick, time):
    """How far from k = e3 a body that spins there goes after a kick across its axis, in degrees."""
    inverse, slope = np.array([1 / I1, 1 / I1, 1 / I3], float), np.polynomial.Polynomial(U).deriv()

    def field(_, y):
        pi, k = y[:3], y[3:]
        rate, M = pi * inverse, pi + [0, 0, l]
        torque = np.cross(k, [0, 0, slope(k[2])])
        return np.concatenate([np.cross(M, rate) + torque, np.cross(k, rate)])

    found = solve_ivp(field, (0, time), [kick, 0, spin, 0, 0, 1], method="DOP853", rtol=1e-12, atol=1e-14,
                      max_step=0.02)
    return np.degrees(np.arctan2(np.hypot(found.y[3], found.y[4]), found.y[5])).max()
