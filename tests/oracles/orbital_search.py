"""Equilibria of a gyrostat satellite by Newton's method from many starts, in floats; without gyrostat."""
import numpy as np


def frames(quaternions):
    """Rows t, n, r in body axes, shape (m, 3, 3)."""
    a, b, c, d = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    return np.stack([
        np.stack([a*a + b*b - c*c - d*d, 2*(b*c - a*d), 2*(b*d + a*c)], -1),
        np.stack([2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)], -1),
        np.stack([2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d], -1)], 1)


def torques(turn, moments, rotor, rate):
    """t·Ir, t·(ω0 In + l), r·(4 ω0 In + l): they vanish at equilibria."""
    t, n, r = turn[:, 0], turn[:, 1], turn[:, 2]
    along = moments * n
    return np.stack([np.sum(t * moments * r, 1), np.sum(t * (rate * along + rotor), 1),
                     np.sum(r * (4 * rate * along + rotor), 1)], 1)


def turned(turn, angles):
    """The frames turned by small angles about the body axes."""
    size = np.linalg.norm(angles, axis=1)[:, None, None]
    hat = np.zeros((len(angles), 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        hat[:, i, j], hat[:, j, i] = -angles[:, k], angles[:, k]
    safe = np.where(size > 0, size, 1)
    step = np.eye(3) + np.sin(size) / safe * hat + (1 - np.cos(size)) / safe**2 * hat @ hat
    return turn @ np.transpose(step, (0, 2, 1))


def search(moments, rotor, rate, starts=400, seed=0):
    """(n, r) of every equilibrium that Newton's method ends at."""
    moments, rotor = (np.array([float(x) for x in v]) for v in (moments, rotor))
    rate, rng = float(rate), np.random.default_rng(seed)
    turn, step = frames(rng.normal(size=(starts, 4))), 1e-6
    for _ in range(60):
        value = torques(turn, moments, rotor, rate)
        slopes = np.stack([(torques(turned(turn, step * e[None].repeat(starts, 0)), moments, rotor, rate)
                            - torques(turned(turn, -step * e[None].repeat(starts, 0)), moments, rotor, rate))
                           / (2 * step) for e in np.eye(3)], 2)
        move = -np.einsum("mij,mj->mi", np.linalg.pinv(slopes), value)
        length = np.linalg.norm(move, axis=1, keepdims=True)
        turn = turned(turn, move * np.minimum(1, 0.5 / (length + 1e-300)))
    good = np.abs(torques(turn, moments, rotor, rate)).max(1) < 1e-12
    found: list[np.ndarray] = []
    for place in turn[good][:, 1:].reshape(-1, 6):
        if all(np.abs(place - other).max() > 1e-6 for other in found):
            found.append(place)
    return np.array(found)
