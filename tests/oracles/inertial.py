"""A gyrostat in orbit by Newton and Euler's equations in inertial axes: nothing of gyrostat is imported."""
import numpy as np
from scipy.integrate import solve_ivp


def followed(moments, rotor, rate, omega, turn, times, wheels=0.0):
    """ω, and n and r in body axes, at times; ω0 = rate, ω and the matrix from body to space at t = 0.

    The centre of the Earth is at rest, the satellite at (cos ω0 t, sin ω0 t, 0) from it; the torque of the
    gravity gradient is 3 ω0² r × Ir. The axial moments of free wheels, along the axes, are in I there, not in
    the moments.
    """
    moments, rotor = np.array(moments, float), np.array(rotor, float)
    whole = moments + wheels

    def vertical(t):
        return np.array([np.cos(rate * t), np.sin(rate * t), 0.0])

    def rates(t, y):
        w, R = y[:3], y[3:].reshape(3, 3)
        r = R.T @ vertical(t)
        torque = np.cross(moments * w + rotor, w) + 3 * rate**2 * np.cross(r, whole * r)
        # each row of R is a direction fixed in space, in body axes
        return np.concatenate([torque / moments, np.cross(R, w).ravel()])

    start = np.concatenate([np.array(omega, float), np.array(turn, float).ravel()])
    y = solve_ivp(rates, (0, times[-1]), start, "DOP853", times, rtol=3e-14, atol=1e-15).y.T
    R = y[:, 3:].reshape(-1, 3, 3)
    return y[:, :3], R[:, 2], np.array([m.T @ vertical(t) for m, t in zip(R, times)])
