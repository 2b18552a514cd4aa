"""Makes the columns of a table of a motion: state, angular velocity and attitude, with names and units."""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import ImmutableMatrix

from ..algebra.enclosures.floats import Array
from ..errors import ValuesError, optional
from ..mechanics.classical.quaternion import quaternion_products
from ..mechanics.families.circular_orbit import orbital_rate
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System
from ..notation import NOTATION, Entry, units
from ..typesetting import typeset
from .librations import roll_pitch_yaw

RATE = units(0, 1, 0)


@dataclass(frozen=True)
class Column:
    """A quantity over the times, with its name, units, LaTeX and meaning."""

    name: str
    units: str
    latex: str
    meaning: str
    values: Array


def columns(scene: System, times: Array, states: Array, turns: Array | None,
            pointing: Sequence[int] = (1, 2, 3)) -> list[Column]:
    """Return the state, ω and, if there is an attitude, the quaternion and Euler's angles.

    In an orbit there are roll, pitch and yaw instead of Euler's angles, and the orbits since the time 0.

    Parameters
    ----------
    scene : System
    times : array, shape (m,)
        [T]
    states : array, shape (m, n)
        doubles
    turns : array, shape (m, 3, 3)
        from the body to space, or to the frame of two directions; None if there is no vertical
    pointing : sequence of three int
        in an orbit, the body axes along t, n and r if roll, pitch and yaw are 0

    Returns
    -------
    list of Column
    """
    found = []
    for i, s in enumerate(scene.space.coordinates):
        entry = NOTATION.get(s.name) or Entry(s.name, typeset(s.name), s.name, (0, 0),
                                              f"direction {s.name[:-1]}, axis {s.name[-1]}")
        found.append(Column(s.name, units(*entry.dimension, entry.length), entry.latex, entry.meaning,
                            states[:, i]))
    for i, rate in enumerate(_rates(scene.body, states[:, :3]), 1):
        found.append(Column(f"omega{i}", RATE, rf"\omega_{i}", f"angular velocity of the body, axis {i}",
                            rate))
    if turns is None:
        return found
    where = "the frame" if scene.coupled else "space"
    for i, values in enumerate(quaternions(turns).T):
        found.append(Column(f"q{i}", "1", f"q_{i}",
                            f"quaternion from the body to {where}, {'ijk'[i - 1] if i else 'scalar'} part",
                            values))
    if scene.kind is Kind.ORBIT:
        return [*found, *_in_orbit(scene, times, turns, pointing)]
    for name, about, values in zip(("phi", "theta", "psi"), ("precession", "tilt", "spin"), euler(turns).T):
        found.append(Column(name, "rad", rf"\{name}", f"Euler angle (z-x-z) of the {about}", values))
    return found


def _in_orbit(scene: System, times: Array, turns: Array, pointing: Sequence[int]) -> list[Column]:
    """Return roll, pitch, yaw and orbits."""
    angles = roll_pitch_yaw(turns, pointing).T
    turned = float(orbital_rate(scene)) * np.asarray(times, dtype=float) / (2 * np.pi)
    return [Column("orbits", "1", r"\omega_0 t/2\pi", "orbits since the time 0", turned), *(
        Column(name, "rad", rf"\mathrm{{{name}}}", f"{name} against the axes t, n, r of the orbit, of the "
               "sequence yaw, pitch, roll", values)
        for name, values in zip(("roll", "pitch", "yaw"), angles))]


def _rates(body: Gyrostat, momentum: Array) -> list[Array]:
    """Return ω along each axis, from π."""
    if isinstance(body.inertia, ImmutableMatrix):
        return [momentum @ np.array([float(x) for x in row]) for row in body.inverse.tolist()]
    return [momentum[:, i] / float(moment) for i, moment in enumerate(body.moments)]


def quaternions(turns: Array) -> Array:
    """Return q0 + q1 i + q2 j + q3 k with x_space = q x_body q*, shape (m, 4).

    The first one has q0 ≥ 0, each other one is the nearer of two to the one before.

    References
    ----------
    Shepperd, Journal of Guidance and Control 1 (1978) 223-224: from the largest of the four components, so
    that nothing cancels.

    Examples
    --------
    >>> quarter = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    >>> quaternions(np.array([np.eye(3), quarter])).round(6).tolist()
    [[1.0, 0.0, 0.0, 0.0], [0.707107, 0.0, 0.0, 0.707107]]
    """
    rows = [list(row) for row in np.moveaxis(turns, 0, -1)]
    four: Array = np.moveaxis(np.array(quaternion_products(rows)), -1, 0)
    found = four[np.arange(len(four)), np.diagonal(four, axis1=1, axis2=2).argmax(axis=1)]
    found = found / np.linalg.norm(found, axis=1, keepdims=True)
    if len(found):
        first = found[0][np.flatnonzero(found[0])[0]]
        turned = np.sign((found[1:] * found[:-1]).sum(axis=1))
        found = found * np.cumprod(np.concatenate([[np.sign(first)],
                                                   np.where(turned == 0, 1.0, turned)]))[:, None]
    return found + 0.0                                     # no −0


def euler(turns: Array) -> Array:
    """Return φ, θ, ψ (z-x-z), shape (..., 3), φ and ψ between −π and π; if sin θ = 0, ψ = 0."""
    across = np.hypot(turns[..., 2, 0], turns[..., 2, 1])
    phi = np.where(across == 0, np.arctan2(turns[..., 1, 0], turns[..., 0, 0]),
                   np.arctan2(turns[..., 0, 2], -turns[..., 1, 2]))
    psi = np.where(across == 0, 0.0, np.arctan2(turns[..., 2, 0], turns[..., 2, 1]))
    return np.stack([phi, np.arctan2(across, turns[..., 2, 2]), psi], axis=-1)


def turns_of(attitude: Callable[[Array], Array], times: Array) -> Array | None:
    """Return the attitude of a motion at times, None if there is no vertical."""
    try:
        return attitude(times)
    except ValuesError:
        return None


def dataset(table: Sequence[Column], times: Array, attributes: Mapping[str, Any]) -> Any:
    """Return the xarray.Dataset of what was computed."""
    variables = {c.name: ("time", c.values, {"units": c.units, "latex": c.latex, "long_name": c.meaning})
                 for c in table}
    time = "time", times, {"units": "s", "long_name": "time from the state given"}
    return optional("xarray", "charts").Dataset(variables, {"time": time}, attributes)
