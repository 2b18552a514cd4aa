"""Attitudes of a satellite in any potential of degree 2 by Newton's method from many starts, in floats.

V = ½ Σ a·M_ab b + Σ c_a·a over the directions a, b = t, n, r in body axes, the rows of a rotation.
"""
import numpy as np
from orbital_search import frames


def hats(x):
    """hat(x) v = x × v, shape (m, 3, 3)."""
    (x, y, z), zero = x.T, np.zeros(len(x))
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], 1).reshape(-1, 3, 3)


def torque(turn, matrix, vector):
    """Σ a × V_a, and its derivative if each a becomes a + a × θ; matrix (9, 9), vector (9,)."""
    slopes = (turn.reshape(-1, 9) @ matrix + vector).reshape(-1, 3, 3)
    each = [hats(turn[:, i]) for i in range(3)]
    whole = sum(np.cross(turn[:, i], slopes[:, i]) for i in range(3))
    bends = sum(each[i] @ matrix[3 * i:3 * i + 3, 3 * j:3 * j + 3] @ each[j]
                for i in range(3) for j in range(3))
    return whole, bends - sum(hats(slopes[:, i]) @ each[i] for i in range(3))


def growth(inertia, rotor, normal, K):
    """The largest real part of λ in det(λ² I + λ hat(g) + K) = 0, g = (tr I − 2 I) n − l, ω0 = 1."""
    gyroscopic = hats(((np.trace(inertia) * np.eye(3) - 2 * inertia) @ normal - rotor)[None])[0]
    inverse, zero = np.linalg.inv(inertia), np.zeros((3, 3))
    return np.linalg.eigvals(np.block([[zero, np.eye(3)], [-inverse @ K, -inverse @ gyroscopic]])).real.max()


def search(matrix, vector, starts=300, seed=0):
    """The rotations at which the torque vanishes that Newton's method ends at, rows t, n, r; and −K there."""
    turn = frames(np.random.default_rng(seed).normal(size=(starts, 4)))
    for _ in range(50):
        whole, slope = torque(turn, matrix, vector)
        move = -np.linalg.solve(slope + 1e-13 * np.eye(3), whole[:, :, None])[:, :, 0]
        length = np.linalg.norm(move, axis=1, keepdims=True)
        move *= np.minimum(1, 0.5 / (length + 1e-300))
        size = np.linalg.norm(move, axis=1)[:, None, None] + 1e-150
        turning = hats(move)
        turn = turn @ (np.eye(3) + np.sin(size) / size * turning
                       + (1 - np.cos(size)) / size**2 * turning @ turning)
    whole, slope = torque(turn, matrix, vector)
    found: list[tuple[np.ndarray, np.ndarray]] = []
    for attitude, bend in zip(turn[np.abs(whole).max(1) < 1e-11], slope[np.abs(whole).max(1) < 1e-11]):
        if all(np.abs(attitude - other).max() > 1e-6 for other, _ in found):
            found.append((attitude, bend))
    return found


def landings(matrix, vector, starts=150, seed=0):
    """The rotations at which Newton's method ends, on curves of them too, and −K there."""
    turn = frames(np.random.default_rng(seed).normal(size=(starts, 4)))
    for _ in range(60):
        whole, slope = torque(turn, matrix, vector)
        move = -np.einsum("mij,mj->mi", np.linalg.pinv(slope, rcond=1e-7), whole)
        length = np.linalg.norm(move, axis=1, keepdims=True)
        move *= np.minimum(1, 0.3 / (length + 1e-300))
        size = np.linalg.norm(move, axis=1)[:, None, None] + 1e-150
        turning = hats(move)
        turn = turn @ (np.eye(3) + np.sin(size) / size * turning
                       + (1 - np.cos(size)) / size**2 * turning @ turning)
    whole, slope = torque(turn, matrix, vector)
    good = np.abs(whole).max(1) < 1e-11
    return list(zip(turn[good], slope[good]))
