"""Precessions beside a tilted equilibrium, and the ranks of its field, in fractions."""
from fractions import Fraction

import oracle
from sympy import Rational

import gyrostat as gs

k3 = gs.symbol("k3")
I1, I3, l, omega, d2U = map(gs.symbol, ("I1", "I3", "l", "omega", "d2U"))


def at(expression, **numbers):
    """The expression at numbers, as a Fraction."""
    value = expression.xreplace({gs.symbol(name): Rational(x.numerator, x.denominator)
                                 for name, x in numbers.items()})
    return Fraction(int(value.p), int(value.q))


def precession(I1, I3, l, z, W, slope):
    """σ of the regular precession ω = W k + σ e3 at k3 = z.

    I1 z W² − P W + U'(z) = 0, P = I3 (W z + σ) + l.
    """
    return ((slope + I1 * z * W**2) / W - l) / I3 - W * z


def turning(I1, I3, l, tilt, W, sigma, slope):
    """The state at (k1, 0, k3) of that precession, and whether the Euler-Poisson field there is −σ times the
    rotation about axis 3.
    """
    k1, z = tilt
    x = oracle.exact([I1 * W * k1, 0, I3 * (W * z + sigma), k1, 0, z])
    xdot = oracle.field(x, oracle.exact([I1, I1, I3]), oracle.exact([0, 0, l]),
                        oracle.axial_slope(slope, Fraction(0), z))
    return all(xdot == -sigma * oracle.exact([-x[1], x[0], 0, -x[4], x[3], 0]))


def ranks(I1, I3, l, omega, tilt, u2):
    """Ranks of J and J² on the tangent space of the coadjoint orbit, J of the Euler-Poisson field
    differenced.
    """
    x, f = oracle.inclined(I1, I3, l, omega, (tilt[0], 0, tilt[1]), u2)
    J, basis = oracle.jacobian(f, x), oracle.orbit_basis(x, oracle.exact([0, 0, l]))
    return oracle.rank(J.dot(basis)), oracle.rank(J.dot(J).dot(basis))
