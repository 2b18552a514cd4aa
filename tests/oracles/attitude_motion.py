"""Small motions of a satellite about an attitude along the axes of its orbit, by Lagrange; no gyrostat.

L = ½ Ω·I Ω + Ω·(ω0 I n + l) + ½ ω0² n·I n + ω0 l·n − 3/2 ω0² r·G r − V, Ω the rate against the frame. G is
the tensor on which gravity acts; that of a body with a wheel that runs free has its inertia, and I has not.
"""
from sympy import Matrix, Rational, diag, expand, symbols

THETA, RATES = symbols("q1:4"), symbols("v1:4")


def cross(a, b):
    """Of columns."""
    return Matrix(a).cross(Matrix(b))


def turned(axis):
    """A direction in the body that is turned by θ, up to the second order: a − θ×a + ½ θ×(θ×a)."""
    a, theta = Matrix([int(k == axis) for k in range(3)]), Matrix(THETA)
    return a - cross(theta, a) + cross(theta, cross(theta, a)) / 2


def of_order(expression, names, order):
    """The terms of one order in some names."""
    e = symbols("e")
    return expand(expression.subs({x: e * x for x in names}, simultaneous=True)).coeff(e, order)


def small_motion(moments, gravity, l, rate, potential):
    """(gradient, K, G) of I θ̈ + G θ̇ + K θ = 0 for a potential V(t, n, r)."""
    I, theta, v = diag(*moments), Matrix(THETA), Matrix(RATES)
    t, n, r = map(turned, range(3))
    omega = v + cross(v, theta) / 2                        # what makes ȧ = a × Ω, up to the second order
    energy = (Rational(3, 2) * rate**2 * (r.T * diag(*gravity) * r)[0] - rate**2 * (n.T * I * n)[0] / 2
              - rate * (Matrix(l).T * n)[0] + potential(t, n, r))
    gradient = [of_order(energy, THETA, 1).diff(x) for x in THETA]
    second = of_order(energy, THETA, 2)
    K = Matrix(3, 3, lambda i, j: second.diff(THETA[i], THETA[j]))
    mixed = of_order((omega.T * (rate * I * n + Matrix(l)))[0], (*THETA, *RATES), 2)
    B = Matrix(3, 3, lambda i, j: mixed.diff(RATES[i], THETA[j]))
    return gradient, K, B - B.T


def coefficients(moments, K, G):
    """Of det(λ² I + λ G + K), a cubic in λ²: from the highest."""
    x = symbols("x")
    found = expand((x**2 * diag(*moments) + x * G + K).det())
    return [found.coeff(x, n) for n in (6, 4, 2, 0)]


def spectrally_stable(c):
    """Whether c3 x³ + … + c0 with c3 > 0 has no root x but real ones that are not positive, at numbers."""
    a, b, d = (y / c[0] for y in c[1:])
    return min(a, b, d) >= 0 and a**2 * b**2 - 4 * b**3 - 4 * a**3 * d + 18 * a * b * d - 27 * d**2 >= 0


def positive(K):
    """Whether a symmetric matrix of numbers is positive definite."""
    return all(K[:n, :n].det() > 0 for n in (1, 2, 3))
