"""A gyrostat at rest in its orbit by Newton and Euler, in floats: torque, growth, stiffness; no gyrostat."""
import numpy as np


def field(state, I, l, w):
    """π̇, ṅ, ṙ of π = I ω, with the gravity gradient 3 w² r × I r."""
    pi, n, r = state.reshape(3, 3)
    omega = np.linalg.solve(I, pi)
    return np.concatenate([np.cross(pi + l, omega) + 3 * w**2 * np.cross(r, I @ r), np.cross(n, omega),
                           np.cross(r, omega - w * n)])


def turned(theta, *directions):
    """Directions in a body that is turned by a vector, by the series of the exponential up to degree 4."""
    hat = np.cross(np.eye(3), -theta)
    turn = np.eye(3) - hat + hat @ hat / 2 - hat @ hat @ hat / 6 + hat @ hat @ hat @ hat / 24
    return [turn @ a for a in directions]


def stiffness(I, n, r, l, w, step=1e-3):
    """Hessian of 3/2 w² r·I r − 1/2 w² n·I n − w l·n over rotations, by differences."""
    def potential(theta):
        a, b = turned(theta, n, r)
        return 1.5 * w**2 * b @ I @ b - 0.5 * w**2 * a @ I @ a - w * l @ a

    e = step * np.eye(3)
    return np.array([[potential(a + b) - potential(a - b) - potential(b - a) + potential(-a - b) for a in e]
                     for b in e]) / (4 * step**2)


def at_rest(I, n, r, l, w):
    """(largest torque, fastest growth, least eigenvalue of the stiffness)."""
    state, step = np.concatenate([w * I @ n, n, r]), 1e-5
    jacobian = np.array([(field(state + step * e, I, l, w) - field(state - step * e, I, l, w)) / (2 * step)
                         for e in np.eye(9)]).T
    return (np.abs(field(state, I, l, w)).max(), np.linalg.eigvals(jacobian).real.max(),
            np.linalg.eigvalsh(stiffness(I, n, r, l, w)).min())
