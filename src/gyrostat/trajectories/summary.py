"""What is known of a motion: lines to read, and attributes of its table."""
from collections.abc import Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix

from ..mechanics.scenes.system import System
from ..version import __version__
from .route import Route


def summary(route: Route, angles: tuple[Any, Any], note: str) -> str:
    """What is known of a motion, a line each."""
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
    """What is known of a motion, in doubles, and the numbers that it is of, exact, as texts."""
    body, potential = scene.body, scene.potential
    known = {"note": note or None, "route": route.name, "period": route.period,
             "precession": route.precession, "spin": route.spin, "energy": energy,
             "error": route.error, "nodes": route.nodes, "recognised": route.recognised or None}
    inertia = body.inertia
    numbers = {"inertia": inertia.tolist() if isinstance(inertia, ImmutableMatrix) else inertia,
               "gyrostatic_momentum": body.gyrostatic_momentum,
               "state": state, "potential": potential.expression if potential else "none",
               "gyrostat_version": __version__}
    return ({name: value for name, value in known.items() if value is not None}
            | {name: str(value) for name, value in numbers.items()})
