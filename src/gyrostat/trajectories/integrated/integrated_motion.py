"""Integrates the motion of any concrete scene, with an estimate of its error by a second run.

What the scene conserves is a check of both.
"""
import math
from collections.abc import Sequence
from functools import lru_cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from flint import arb
from sympy import Dummy, Expr

from ...algebra.enclosures.floats import Array, in_floats
from ...errors import AccuracyError, ArgumentError, ScopeError, ValuesError
from ...mechanics.scenes.lie_poisson import hat
from ...mechanics.scenes.system import System
from ..periods import nearest
from .integrators import METHODS, Rates, RungeKutta, Taylor, beside, beyond

# the error that is accepted if no tolerance is given
WORTHLESS = 1e-3
MARKER = tuple(Dummy(f"a{i}") for i in (1, 2, 3))      # a vector that shows how the body is turned


class Integration:
    """The motion of a concrete scene, integrated as far as it is asked for.

    It is integrated twice, with two tolerances and with every number that is no double rounded in two ways.
    The error is estimated as twice how far the two are apart, or by what the Casimirs, the energy and the
    integrals have lost; as a rule it is far smaller.

    Parameters
    ----------
    scene : System
        without symbols but its coordinates
    state : tuple of Expr
        exact numbers, one for each coordinate
    tolerance : float or None
        the absolute error that is accepted in the state; default 10⁻³. The integrator always does its best
    method : "heyoka", "DOP853" or None
        default heyoka if it is installed, else DOP853

    Attributes
    ----------
    name : str
        the method
    error : float
        the largest estimate so far
    nodes : int
        steps so far, of both integrations

    Raises
    ------
    ArgumentError
        there is no such method
    ScopeError
        U has a function that is not elementary
    MissingExtraError
        the package of the method is not installed
    AccuracyError, when it is called
        the estimate exceeds the tolerance, or U is singular on the way

    References
    ----------
    Biscani & Izzo, Monthly Notices of the Royal Astronomical Society 504 (2021) 2614-2628; Hairer, Nørsett &
    Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), §II.10.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from sympy import S
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> state = S.Zero, S(2), S.One / 100
    >>> tumbling = Integration(free, state, method="DOP853")
    >>> tumbling.state([0.0, -9.0]).round(6)
    array([[0.      , 2.      , 0.01    ],
           [0.488121, 1.745552, 0.845509]])
    >>> tumbling.error < 1e-10
    True
    """

    enclosed, recognised, axis = False, "", (0.0, 0.0, 1.0)
    period = precession = spin = limits = None

    def __init__(self, scene: System, state: Sequence[Expr], tolerance: float | None = None,
                 method: str | None = None):
        self.name = method or ("heyoka" if find_spec("heyoka") else "DOP853")
        if self.name not in METHODS:
            raise ArgumentError(f"method = {method!r} is not known: use {' or '.join(METHODS)}, "
                                "or None")
        self.scene, self.tolerance, self.error = scene, WORTHLESS if tolerance is None else tolerance, 0.0
        rates, kind = _rates(scene), METHODS[self.name]
        self._kept = scene.hamiltonian, *scene.space.casimirs, *scene.integrals_at(state)
        self._runs: list[Taylor | RungeKutta] = []
        for rounding, accuracy in ((nearest, kind.FINE), (beside, kind.COARSE)):
            start = np.array([rounding(x) for x in state])
            other = start[6:] if len(start) == 9 else _across(self._vertical(start))
            self._runs.append(kind(rates, np.concatenate([start, other]), rounding, accuracy))
        self._last = np.empty(0), np.empty((2, 0, len(rates)))

    @property
    def nodes(self) -> int:
        """The number of steps so far, of both integrations."""
        return sum(run.steps for run in self._runs)

    def state(self, t: Any) -> Array:
        """Return the state at times of any shape, in any order; shape (..., n)."""
        t = np.asarray(t, dtype=float)
        n = len(self.scene.space.coordinates)
        return self._at(t.ravel(), n)[:, :n].reshape(*t.shape, n)

    def attitude(self, t: Any) -> Array:
        """Return R from body to space axes at times of any shape; shape (..., 3, 3).

        The space axis z is k, on so(3)* it is M; the Euler angle φ is 0 at t = 0, and so is ψ if sin θ = 0.
        With two directions z is the first and x the second: in an orbit the axes are r, t and n.

        Raises
        ------
        ValuesError
            k, or M on so(3)*, is 0
        """
        t = np.asarray(t, dtype=float)
        values = self._at(t.ravel(), None)
        z, x = self._vertical(values.T), values.T[-3:]
        length = np.sqrt((z * z).sum(axis=0))
        if not length.all():
            raise ValuesError(f"the vertical has the direction of {'k' if self.scene.potential else 'M'}, "
                              "which is 0: give another state")
        z = z / length
        x = x - (x * z).sum(axis=0) * z
        x = x / np.sqrt((x * x).sum(axis=0))
        return np.stack([x, np.cross(z, x, axis=0), z]).transpose(2, 0, 1).reshape(*t.shape, 3, 3)

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """Refuse: it is integrated in doubles."""
        raise ScopeError(f"{self.name} integrates in doubles: leave the precision out")

    def exact_period(self, bits: int) -> None:
        """Return None: no period is known."""

    def exact_angles(self, bits: int) -> tuple[None, None]:
        """Return None for both: no angles are known."""
        return None, None

    def _vertical(self, x: Array) -> Array:
        """Return k, or M = π + l if there is no k."""
        if self.scene.potential:
            return x[3:6]
        return (x[:3].T + [float(l) for l in self.scene.body.gyrostatic_momentum]).T

    def _at(self, times: Array, columns: int | None) -> Array:
        """Return all values at times in any order, the first columns of them to the tolerance."""
        unique, places = np.unique(times, return_inverse=True)
        if not np.isfinite(unique).all():
            raise ValuesError(f"t = {unique[~np.isfinite(unique)][0]} is not a finite time: leave it out")
        if not np.array_equal(unique, self._last[0]):
            self._last = unique, np.stack([self._followed(run, unique) for run in self._runs])
        fine, coarse = self._last[1]
        apart = np.abs(fine - coarse)[:, :columns].max(axis=1, initial=0)
        estimate = np.maximum(2 * apart, self._broken(unique, fine))
        if (bad := ~(estimate <= self.tolerance)).any():
            first = np.abs(unique[bad]).argmin()
            raise AccuracyError(f"at t = {unique[bad][first]} the error is about "
                                f"{estimate[bad][first]:.1e}, more than the tolerance "
                                f"{self.tolerance}: ask for times nearer to 0, or accept a larger tolerance")
        self.error = max(self.error, float(estimate.max(initial=0)))
        return fine[places]

    def _followed(self, run: Taylor | RungeKutta, times: Array) -> Array:
        """Return all values at ascending times: from 0 back, from 0 on, or on from where the run is."""
        before, after = times[times < 0], times[times >= 0]
        found = [np.empty((0, len(run.start)))]
        for side, order in ((before[::-1], -1), (after, 1)):
            if len(side):
                if run.time * side[0] < 0 or abs(side[0]) < abs(run.time):
                    run.restart()
                found.append(run.reach(side)[::order])
        return np.concatenate(found)

    def _broken(self, times: Array, values: Array) -> Array:
        """Return the least error in the state that explains what the conserved functions have lost.

        They are the Casimirs, the energy and the integrals.
        """
        scene, least = self.scene, np.zeros(len(values))
        arrays = dict(zip(scene.space.coordinates, np.vstack([self._runs[0].start, values]).T))
        for kept in self._kept:
            with np.errstate(all="ignore"):
                value = in_floats(kept, np, arrays)
                slope = np.sqrt(sum(in_floats(d, np, arrays) ** 2 for d in scene.space.gradient(kept))).max()
            if not np.isfinite(value).all():
                raise beyond(times[~np.isfinite(value[1:])][0])
            least = np.maximum(least, np.abs(value - value[0])[1:] / (slope or math.inf))
        return least


@lru_cache(maxsize=64)
def _rates(scene: System) -> Rates:
    """Return the equations of motion, and ȧ = a × ω of a vector at rest in space.

    In two directions it is at rest in their frame, the second of them.
    """
    turning = hat(MARKER) * scene.energy_gradient[:3, :]
    return tuple(zip((*scene.space.coordinates, *MARKER), (*scene.vector_field(), *turning)))


def _across(z: Array) -> Array:
    """Return the axis x of space in body axes at φ = 0, in z-x-z; (1, 0, 0) if z lies on axis 3."""
    length = math.hypot(z[0], z[1])
    return np.array([z[1] / length, -z[0] / length, 0.0] if length else [1.0, 0.0, 0.0])
