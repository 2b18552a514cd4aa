"""Says what is known about a motion: what it conserves, its period and mean rates."""
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
from flint import arb
from sympy import Add, Expr, ImmutableMatrix

from ..algebra.enclosures.floats import Array, in_floats
from ..mechanics.scenes.system import System
from ..version import __version__
from .route import Route
from .states_in_digits import bits_of, in_digits


def conserved(scene: System, state: Sequence[Expr]) -> dict[str, Expr]:
    """Return what is conserved as functions of the coordinates, by name.

    They are the energy, the Casimirs C1, C2 and the integrals F1, F2 of the level of the state.
    """
    found = {"energy": scene.hamiltonian}
    for letter, functions in (("C", scene.space.casimirs), ("F", scene.integrals_at(state))):
        found |= {f"{letter}{i}": function for i, function in enumerate(functions, 1)}
    return found


def lost(scene: System, state: Sequence[Expr], states: Array) -> dict[str, float]:
    """Return how far each conserved function is off at most, over its largest term at the first state.

    Parameters
    ----------
    scene : System
        at given numbers
    state : sequence of n Expr
        exact
    states : array, shape (..., n)
        in doubles

    Returns
    -------
    dict of str to float
    """
    coordinates, found = scene.space.coordinates, {}
    values = dict(zip(coordinates, np.moveaxis(states, -1, 0)))
    exact = dict(zip(coordinates, state))
    start = {s: np.asarray(float(value)) for s, value in exact.items()}
    for name, function in conserved(scene, state).items():
        size = max(abs(float(in_floats(term, np, start))) for term in Add.make_args(function.expand()))
        off = np.abs(in_floats(function, np, values) - float(function.xreplace(exact)))
        found[name] = float(np.max(off, initial=0.0)) / (size or 1.0)
    return found


def period(route: Route, digits: int | None) -> Any:
    """Return the period of the nutation, or of the momentum in a free body [T]; None if there is none."""
    if digits is None:
        return route.period
    found = route.exact_period(bits_of(digits))
    return None if found is None else in_digits(found, digits)


def gained(route: Route, digits: int | None) -> tuple[Any, Any]:
    """Return the angles of precession and spin, in a period, or in a unit of time if there is none."""
    if digits is None:
        return route.precession, route.spin
    precession, spin = (in_digits(x, digits) if isinstance(x, arb) else x
                        for x in route.exact_angles(bits_of(digits)))
    return precession, spin


def rate(angle: Any, route: Route, digits: int | None) -> Any:
    """Return the mean rate of an angle gained."""
    if angle is None or not route.period:
        return angle
    if digits is None:
        return angle / route.period
    with mpmath.workdps(digits):
        return angle / period(route, digits)


def frequencies(route: Route, angles: tuple[Any, Any]) -> dict[str, float]:
    """Return 2π/period, and the mean rates of the angles gained [1/T], as far as they exist."""
    cycle = route.period
    rates = {name: float(angle) / (cycle or 1.0)
             for name, angle in zip(("precession", "spin"), angles) if angle is not None}
    return ({"nutation": 2 * np.pi / cycle} if cycle else {}) | rates


def summary(route: Route, angles: tuple[Any, Any], note: str) -> str:
    """Return what is known about a motion, a line each."""
    each = "in a period" if route.period else "per unit of time"
    lines = [f"Motion: {route.name}"]
    if route.period:
        lines.append(f"period {float(route.period):.12g}")
    lines += [f"{name} {float(angle):.12g} {each}"
              for name, angle in zip(("precession", "spin"), angles) if angle is not None]
    if route.limits:
        lines.append("k3 from {:.12g} to {:.12g}".format(*route.limits))
    if route.error:
        lines.append(f"error {route.error:.1e}, estimated")
    if note:
        lines.append(f"note: {note}")
    return "\n  ".join(lines)


def attributes(scene: System, state: Sequence[Expr], route: Route, energy: float,
               note: str) -> dict[str, Any]:
    """Return what is known about a motion, in doubles, and its numbers, exact, as texts."""
    body, potential = scene.body, scene.potential
    known = {"note": note or None, "route": route.name, "period": route.period,
             "precession": route.precession, "spin": route.spin, "energy": energy,
             "error": route.error, "nodes": route.nodes, "recognised": route.recognised or None}
    inertia = body.inertia
    numbers = {"inertia": inertia.tolist() if isinstance(inertia, ImmutableMatrix) else inertia,
               "gyrostatic_momentum": body.gyrostatic_momentum, "state": state,
               "potential": potential.expression if potential else "none", "gyrostat_version": __version__}
    return ({name: value for name, value in known.items() if value is not None}
            | {name: str(value) for name, value in numbers.items()})
