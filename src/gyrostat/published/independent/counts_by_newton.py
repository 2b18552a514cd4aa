"""Counts the critical points of V over all orientations, by Newton's method in floats.

Nothing here uses the equilibria of the library, nor any published formula.
"""
import numpy as np
from numpy.typing import NDArray

from ..scenes import Scene
from .counterexample import Values
from .frame_equations import rate_of

STARTS, STEPS = 400, 60
FLAT = 1e-7                                                # of det D²V, beside the cube of its size
Array = NDArray[np.float64]


def found_by_search(scene: Scene, values: Values) -> list[int | None]:
    """Return the number of negative squares of D²V for each critical point of V; None if it is degenerate.

    V = (3/2) ω0² r·Ir − (1/2) ω0² n·In − ω0 n·l.
    """
    at = dict(values)
    rate = float(rate_of(scene).subs(at))
    rotor = np.array([float(x.subs(at)) for x in scene.body.gyrostatic_momentum])
    tensor = np.array([[float(x.subs(at)) for x in row] for row in scene.body.tensor.tolist()])
    place = _directions(np.random.default_rng(1).normal(size=(STARTS, 4)))
    for _ in range(STEPS):
        slope, bent = _derivatives(place, tensor, rotor, rate)
        move = -np.einsum("mij,mj->mi", np.linalg.pinv(bent, rcond=1e-13, hermitian=True), slope)
        length = np.linalg.norm(move, axis=1, keepdims=True)
        place = _turned(place, move * np.minimum(1, 0.4 / (length + 1e-300)))
    slope, bent = _derivatives(place, tensor, rotor, rate)
    found: list[Array] = []
    indices: list[int | None] = []
    for here, form in zip(place[np.abs(slope).max(1) < 1e-11], bent[np.abs(slope).max(1) < 1e-11]):
        if all(np.abs(here - other).max() > 1e-5 for other in found):
            found.append(here)
            flat = abs(np.linalg.det(form)) < FLAT * np.abs(form).max() ** 3
            indices.append(None if flat else int((np.linalg.eigvalsh(form) < 0).sum()))
    return indices


def _derivatives(place: Array, tensor: Array, rotor: Array, rate: float) -> tuple[Array, Array]:
    """Return DV and D²V by θ at 0; each row a of a place, n or r, turns to a + a × θ + (a × θ) × θ/2."""
    slope, bent = np.zeros((len(place), 3)), np.zeros((len(place), 3, 3))
    for a, weight, linear in ((place[:, 0], -rate**2, -rate * rotor), (place[:, 1], 3 * rate**2, 0 * rotor)):
        force = weight * a @ tensor + linear
        turns = np.cross(a[:, None], np.eye(3)[None])      # a × e_i
        twice = np.cross(turns[:, :, None], np.eye(3)[None, None])
        slope += np.einsum("mij,mj->mi", turns, force)
        bent += weight * np.einsum("mia,ab,mjb->mij", turns, tensor, turns)
        bent += np.einsum("mija,ma->mij", (twice + twice.transpose(0, 2, 1, 3)) / 2, force)
    return slope, bent


def _directions(quaternions: Array) -> Array:
    """Return the directions n and r, in rows, that quaternions stand for."""
    a, b, c, d = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    return np.stack([np.stack([2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)], -1),
                     np.stack([2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d], -1)], 1)


def _turned(place: Array, angles: Array) -> Array:
    """Return each place after a finite turn by θ, which to first order is a + a × θ."""
    size = np.linalg.norm(angles, axis=1)[:, None, None]
    axis = angles[:, None] / np.where(size > 0, size, 1)
    across = np.cross(place, axis)
    moved: Array = place + np.sin(size) * across + (1 - np.cos(size)) * np.cross(across, axis)
    return moved
