"""Counts the critical points of V over all orientations, by Newton's method in floats.

Nothing here uses the equilibria of the library, nor any published formula.
"""
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from sympy import Matrix, Rational, hessian, lambdify

from ...notation import symbol
from ..scenes import Scene
from .counterexample import Values
from .frame_equations import other_energy, rate_of

STARTS, STEPS = 400, 60
FLAT = 1e-7                                                # of det D²V, beside the cube of its size
Array = NDArray[np.float64]


def found_by_search(scene: Scene, values: Values) -> list[int | None]:
    """Return the number of negative squares of D²V for each critical point of V; None if it is degenerate.

    V = (3/2) ω0² r·Ir − (1/2) ω0² n·In − ω0 n·l + U.
    """
    derivatives = _derivatives_of(scene, values)
    place = _directions(np.random.default_rng(1).normal(size=(STARTS, 4)))
    for _ in range(STEPS):
        slope, bent = derivatives(place)
        move = -np.einsum("mij,mj->mi", np.linalg.pinv(bent, rcond=1e-13, hermitian=True), slope)
        length = np.linalg.norm(move, axis=1, keepdims=True)
        place = _turned(place, move * np.minimum(1, 0.4 / (length + 1e-300)))
    slope, bent = derivatives(place)
    found: list[Array] = []
    indices: list[int | None] = []
    for here, form in zip(place[np.abs(slope).max(1) < 1e-11], bent[np.abs(slope).max(1) < 1e-11]):
        if all(np.abs(here - other).max() > 1e-5 for other in found):
            found.append(here)
            flat = abs(np.linalg.det(form)) < FLAT * np.abs(form).max() ** 3
            indices.append(None if flat else int((np.linalg.eigvalsh(form) < 0).sum()))
    return indices


def _derivatives_of(scene: Scene, values: Values) -> Callable[[Array], tuple[Array, Array]]:
    """Return what gives DV and D²V by θ at 0; each row a of a place, n or r, turns to a + a × θ."""
    x = [symbol(f"{a}{i}") for a in "nr" for i in (1, 2, 3)]
    n, r = Matrix(x[:3]), Matrix(x[3:])
    rate, tensor, rotor = rate_of(scene), scene.body.tensor, Matrix(scene.body.gyrostatic_momentum)
    V = (Rational(3, 2) * rate**2 * r.dot(tensor * r) - rate**2 * n.dot(tensor * n) / 2 - rate * n.dot(rotor)
         + other_energy(scene, n, r)).subs(dict(values))
    slopes, bends = (lambdify([x], list(entries)) for entries in (Matrix([V]).jacobian(x), hessian(V, x)))

    def derivatives(place: Array) -> tuple[Array, Array]:
        at = place.reshape(-1, 6).T
        force, curved = (np.stack(np.broadcast_arrays(at[0], *f(at))[1:], -1) for f in (slopes, bends))
        force, curved = force.reshape(-1, 2, 3), curved.reshape(-1, 2, 3, 2, 3)
        turns = np.cross(place[:, :, None], np.eye(3))     # a × e_i
        twice = np.cross(turns[:, :, :, None], np.eye(3))
        bent = np.einsum("mdia,mdaeb,mejb->mij", turns, curved, turns)
        bent += np.einsum("mdija,mda->mij", (twice + twice.transpose(0, 1, 3, 2, 4)) / 2, force)
        return np.einsum("mdia,mda->mi", turns, force), bent

    return derivatives


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
