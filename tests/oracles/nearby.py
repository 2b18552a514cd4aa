"""Motions beside an equilibrium, and how far they go from it or from a set: nothing here imports gyrostat.

π̇ = M × ω + Σ a × ∂h/∂a, ȧ = a × ∂h/∂π for up to two directions, all motions integrated as one system.
"""
import numpy as np
from scipy.integrate import solve_ivp

TURNS = np.linspace(0, 2 * np.pi, 361)


class Motion:
    """Of h = ½ π·I⁻¹π + β(a)·π + U(a).

    Parameters
    ----------
    inertia : array, shape (3, 3)
    rotor : array, shape (3,)
    slopes : callable
        of the directions, shape (n, d, 3): ∂U/∂a, of the same shape
    coupling : array, shape (d, 3, 3)
        β = Σ Bₐ a
    """

    def __init__(self, inertia, rotor, slopes=None, coupling=None):
        self.inverse, self.rotor = np.linalg.inv(np.array(inertia, float)), np.array(rotor, float)
        self.slopes, self.coupling = slopes, coupling

    def field(self, states):
        """Of states, shape (n, 1 + d, 3)."""
        pi, directions = states[:, 0], states[:, 1:]
        M, rate = pi + self.rotor, pi @ self.inverse
        torques = np.zeros_like(directions) if self.slopes is None else self.slopes(directions)
        if self.coupling is not None:
            rate = rate + np.einsum("dij,ndj->ni", self.coupling, directions)
            torques = torques + np.einsum("dij,ni->ndj", self.coupling, pi)
        turning = np.cross(M, rate) + np.cross(directions, torques).sum(axis=1)
        return np.concatenate([turning[:, None], np.cross(directions, rate[:, None])], axis=1)

    def beside(self, point, size, count=20):
        """Neighbours of a point: every coordinate disturbed, the lengths and angles of directions kept."""
        rng = np.random.default_rng(1)
        point = np.array(point, float).reshape(1, -1, 3)
        states = point + size * rng.uniform(-1, 1, (count, *point.shape[1:]))
        if point.shape[1] > 1:
            gram = np.einsum("dx,ex->de", point[0, 1:], point[0, 1:])
            states[:, 1:] = _with_products(states[:, 1:], gram)
        return states

    def excursions(self, states, places, time, steps=200):
        """For each set of places the largest distance that a motion has from it at some time."""
        shape = states.shape
        found = solve_ivp(lambda _, y: self.field(y.reshape(shape)).ravel(), (0, time), states.ravel(),
                          "DOP853", rtol=1e-7, atol=1e-9, t_eval=np.linspace(0, time, steps))
        moved = found.y.T.reshape(-1, *shape)
        for each in places:
            away = [np.abs(state[:, None] - each[None]).max(axis=(2, 3)).min(axis=1).max() for state in moved]
            yield max(away)


def turned(point, axis):
    """A point and all its turns about an axis of the body."""
    e = np.array(axis, float) / np.linalg.norm(axis)
    along = (point @ e)[:, None] * e
    across, third = point - along, np.cross(e, point)
    return np.array([along + np.cos(t) * across + np.sin(t) * third for t in TURNS])


def _with_products(directions, gram):
    """Directions near those given with the inner products given (by Gram and Schmidt)."""
    found = []
    for states in directions:
        first = states[0] * np.sqrt(gram[0, 0]) / np.linalg.norm(states[0])
        kept = [first]
        if len(states) > 1:
            along = gram[0, 1] / gram[0, 0]
            rest = states[1] - (states[1] @ first) / gram[0, 0] * first
            size = gram[1, 1] - along**2 * gram[0, 0]
            length = np.linalg.norm(rest)
            # parallel directions stay a little apart: their angle is not kept
            kept.append(along * first + rest * (np.sqrt(max(size, 0)) / length if size > 1e-12 else 1))
        found.append(kept)
    return np.array(found)
