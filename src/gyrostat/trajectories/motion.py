"""The motion of a scene: state, attitude, periods and invariants at any time."""
from collections.abc import Sequence
from typing import Any

import numpy as np
from sympy import Expr

from .._cached import cached_property
from ..algebra.enclosures.floats import Array, doubles, row
from ..arguments import checked
from ..errors import optional
from ..mechanics.scenes.system import System
from ..stability.criteria.number_notes import state_note
from .columns import columns, dataset, euler, turns_of
from .route import Route
from .states_in_digits import states_in_digits, states_in_doubles
from .summary import attributes, conserved, frequencies, gained, lost, period, rate, summary


class Motion:
    """The state of a scene at any time: call it with times.

    motion(t), t [T] of any shape, has the shape (..., n), in the order of scene.space.coordinates; in
    doubles, in long equidistant rows interpolated to the last bits; with a precision in mpmath.mpf.

    Parameters
    ----------
    scene : System
        at given numbers
    state : tuple of Expr
        at the time 0, exact
    route : Route
        the model that computes it
    digits : int or None
        decimal digits, asked for as precision; None for doubles

    Examples
    --------
    >>> import gyrostat as gs
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> turning = gs.trajectories.motion(free, (0, 0, 3))
    >>> turning.route, turning(10.0)
    ('equilibrium', array([0., 0., 3.]))
    """

    def __init__(self, scene: System, state: tuple[Expr, ...], route: Route, digits: int | None):
        self.scene, self.state, self._route, self._digits = scene, state, route, digits

    def __call__(self, t: Any) -> Array:
        """Return the states at the times t [T], shape (..., n)."""
        if self._digits is None:
            return states_in_doubles(self._route, self.state, t)
        return states_in_digits(self._route, self.state, t, self._digits)

    def attitude(self, t: Any) -> Array:
        """Return R from the body to space, x_space = R x_body, in doubles.

        The vertical is the direction of the field, k/abs(k) seen from the body; for a free body, that of M.
        At the time 0 the Euler angle φ is 0, and so is ψ if sin θ = 0.

        Parameters
        ----------
        t : array-like, any shape
            [T]

        Returns
        -------
        array, shape (..., 3, 3)
        """
        return np.asarray(self._route.attitude(doubles(t, "the times")))

    def angles(self, t: Any) -> Array:
        """Return Euler's angles φ, θ, ψ (z-x-z), φ and ψ between −π and π; if sin θ = 0, ψ = 0.

        Parameters
        ----------
        t : array-like, any shape
            [T]

        Returns
        -------
        array, shape (..., 3)

        Examples
        --------
        >>> import gyrostat as gs
        >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
        >>> state, numbers = (0, 1, 5, 0, "0.6", "0.8"), {"I1": 1, "I3": 1}
        >>> numbers |= {"l": 0, "m0": 1}
        >>> top = gs.trajectories.motion(scene, state, numbers)
        >>> top.angles(0.0).round(6)
        array([0.      , 0.643501, 0.      ])
        """
        return euler(self.attitude(t))

    @property
    def route(self) -> str:
        """The name of the model that computes it.

        It is "equilibrium", "steady precession", "elliptic", "quadrature", "separatrix", "free body", "free
        gyrostat", "heyoka" or "DOP853".
        """
        return self._route.name

    @property
    def period(self) -> Any:
        """The period of the nutation, or of the momentum in a free body [T], or None."""
        return period(self._route, self._digits)

    @property
    def precession(self) -> Any:
        """The angle gained about the vertical in a period; None if there is no period.

        Over 2π it is the rotation number, a half of it the apsidal angle.
        """
        return self._gained[0] if self._route.period else None

    @property
    def spin(self) -> Any:
        """The angle gained about the axis of a body of revolution in a period; None without one."""
        return self._gained[1] if self._route.period else None

    @property
    def precession_rate(self) -> Any:
        """The mean rate of the precession; on a separatrix, that in which it ends [1/T]."""
        return rate(self._gained[0], self._route, self._digits)

    @property
    def spin_rate(self) -> Any:
        """The mean rate of the spin about the axis of a body of revolution [1/T]."""
        return rate(self._gained[1], self._route, self._digits)

    @property
    def _gained(self) -> tuple[Any, Any]:
        """The angles of precession and spin, in a period, or in a unit of time if there is none."""
        return gained(self._route, self._digits)

    @property
    def frequencies(self) -> dict[str, float]:
        """The rates 2π/period, and the mean ones of precession and spin [1/T], as far as they exist."""
        return frequencies(self._route, self._gained)

    @property
    def limits(self) -> tuple[float, float] | None:
        """The lowest and highest component of k along the axis of a body of revolution, or None."""
        return self._route.limits

    @property
    def axis(self) -> Array:
        """The axis of a body of revolution; for any other body e3."""
        return np.array(self._route.axis)

    @property
    def recognised(self) -> str:
        """The sentence that says what the scene is, if it is a body of revolution in other axes; else ""."""
        return self._route.recognised

    @property
    def nodes(self) -> int:
        """The nodes of the quadrature, or steps of the integration."""
        return self._route.nodes

    @property
    def error(self) -> float:
        """The error of the state, estimated."""
        return self._route.error

    @cached_property
    def note(self) -> str:
        """A sentence on what is unusual about the numbers, if anything."""
        return state_note(self.scene, self.state)

    def __repr__(self) -> str:
        """Return what is known about the motion, a line each."""
        return summary(self._route, self._gained, self.note)

    @cached_property
    def invariants(self) -> dict[str, Expr]:
        """Energy, Casimirs and integrals at the time 0, exact."""
        point = dict(zip(self.scene.space.coordinates, self.state))
        return {name: value.xreplace(point) for name, value in conserved(self.scene, self.state).items()}

    @property
    def energy(self) -> float:
        """The value of h at the time 0."""
        return float(self.invariants["energy"])

    @property
    def casimirs(self) -> tuple[float, ...]:
        """The Casimirs at the time 0, in the order of scene.space.casimirs."""
        return tuple(float(value) for name, value in self.invariants.items() if name.startswith("C"))

    @property
    def integrals(self) -> tuple[float, ...]:
        """The integrals at the time 0, in the order of scene.integrals_at(state)."""
        return tuple(float(value) for name, value in self.invariants.items() if name.startswith("F"))

    def drift(self, t: Any) -> dict[str, float]:
        """Return how far the integrals are off at these times, at most, relative to their largest term.

        Parameters
        ----------
        t : array-like, any shape
            [T]

        Returns
        -------
        dict of str to float
            for energy, the Casimirs C1, C2 and the integrals F1, …
        """
        return lost(self.scene, self.state, np.asarray(self(t), dtype=float))

    @property
    def attributes(self) -> dict[str, Any]:
        """What is known about the motion, in doubles, and its numbers, exact, as texts."""
        return attributes(self.scene, self.state, self._route, self.energy, self.note)

    @checked
    def to_xarray(self, t: Any, pointing: Sequence[int] = (1, 2, 3)) -> Any:
        """Return the motion as an xarray.Dataset.

        It has state, ω, quaternion, Euler's angles or in orbit roll, pitch, yaw; the rest are attributes.

        Parameters
        ----------
        t : array-like, shape (times,)
            [T]
        pointing : sequence of three int
            in an orbit, the body axes of roll, pitch and yaw; default (1, 2, 3)

        Returns
        -------
        xarray.Dataset

        Raises
        ------
        MissingExtraError
            pip install "gyrostat[charts]"
        ValuesError
            the times are not a row
        """
        optional("xarray", "charts")
        times = row(t, "the times")
        states, turns = np.asarray(self(t), dtype=float), turns_of(self.attitude, times)
        return dataset(columns(self.scene, times, states, turns, pointing), times, self.attributes)
