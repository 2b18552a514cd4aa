"""The well of a relative equilibrium as columns of a table, with its weakest kick and tilt."""
from typing import Any

from sympy import oo

from ..algebra.enclosures.balls import ball
from ..errors import ScopeError
from ..mechanics.families.circular_orbit import by_gradient_alone
from ..mechanics.scenes.kind import Kind
from .wells.disturbances.kicks import below
from .wells.in_balls import BITS
from .wells.well import Well


def well_columns(well: Well) -> dict[str, Any]:
    """Return what is known of a well; infinite is what has no pass, and None what is not known."""
    return {"barrier": well.barrier_double, "barrier_at_least": well.bound, "escape": well.escape_double,
            "pass_kind": well.kind or None, "passes": len(well.passes) or None, **_place(well),
            "kick": weakest_kick(well), "any_kick": any_kick(well), "damped_kick": damped_kick(well),
            "tilt_deg": weakest_tilt(well),
            "well_damped": well.damped, "well_reason": well.reason}


def weakest_kick(well: Well) -> float | None:
    """Return the kick below which it stays whatever the direction, in a field across k; None if unknown."""
    if well.barrier_double is None:
        return None
    try:
        return well.kick(level=well.rotation.scene.kind is not Kind.ORBIT)
    except ScopeError:                                     # of a free body that does not spin about an axis
        return None


def any_kick(well: Well) -> float | None:
    """Return the kick that keeps k over the well of its frame, whatever the direction; None if unknown."""
    return well.kick() if well.frame.found.passes else None


def damped_kick(well: Well) -> float | None:
    """Return the kick across its axis that a damped body of revolution survives; None if unknown."""
    damped = well.under_damping
    return None if damped is None or damped.kick in (None, oo) else below(ball(damped.kick, BITS))


def weakest_tilt(well: Well) -> float | None:
    """Return the angle by which a satellite at rest may be turned about any axis [°]; None of others."""
    known = well.barrier_double is not None and by_gradient_alone(well.rotation.scene)
    return well.tilt() if known else None


def _place(well: Well) -> dict[str, Any]:
    """Where the first pass is, by the names of its own columns."""
    if not well.passes:
        return {}
    first = well.passes[0]
    angles = {} if first.attitude is None else {
        name: x for name, x in first.attitude.columns.items() if name.endswith("_deg")}
    return {f"pass_{name}": x for name, x in (angles | first.doubles.place).items()}
