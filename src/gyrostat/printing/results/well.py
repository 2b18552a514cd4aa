"""Writes the well of a stable rotation: its barrier, its pass, the kicks that stay inside."""
import math
from decimal import ROUND_FLOOR, Context
from typing import Any

from ...equilibria.relative_equilibrium import RelativeEquilibrium
from ...equilibria.well_columns import any_kick, damped_kick, weakest_kick, weakest_tilt
from ...equilibria.wells.frame import Frame
from ...equilibria.wells.well import Well
from ...mechanics.scenes.kind import Kind
from ..blocks import Block, sentence

BEHIND = {"well": "behind which lies another stable equilibrium",
          "round": "over which it closes round a summit and leads to no other stable equilibrium",
          "summit": "the summit of its level", "shelf": "a shelf, beyond which the energy goes on to rise"}
SHORT = Context(prec=6, rounding=ROUND_FLOOR)


def well_blocks(well: Well | str, units: bool) -> list[Block]:
    """Write the sentences about a well."""
    return [sentence(said) for said in well_sentences(well, units)]


def frame_blocks(frame: Frame) -> list[Block]:
    """Write the sentences about the well in the frame of a rotation."""
    if frame.barrier_double is None:
        return [sentence(f"Well in its frame: {frame.reason}.")]
    return [sentence(f"Well in its frame: {frame.barrier_double:.6g} up to the pass at "
                     f"{_where(frame.passes[0])}."), *map(sentence, _over_it(frame.kick(), ""))]


def blocks_without_units(well: Well) -> list[Block]:
    """Write the same where it is not known whether the numbers are those of SI."""
    return well_blocks(well, units=False)


def well_sentences(well: Well | str, units: bool) -> list[str]:
    """Say what there is of a well, to six digits; a kick and a bound are rounded down.

    In place of a well there may be the reason why there is none.
    """
    if isinstance(well, str):
        return [f"Well: {well}."]
    barrier, joule, impulse = well.barrier_double, " J" if units else "", " N m s" if units else ""
    if barrier is None:
        least = "" if well.bound is None else f", and its barrier is at least {_short(well.bound)}{joule}"
        return [f"Well: {well.reason}{least}.", *_in_its_frame(well, impulse)]
    if math.isinf(barrier):
        return [f"Well: {well.reason}.", *_if_damped(well, impulse)]
    pass_ = f" at {_where(well.passes[0])}" if well.passes else ""
    said = [f"Well: {barrier:.6g}{joule} up to the pass{pass_}, {BEHIND[well.kind]}."]
    escape = well.escape_double
    if escape is not None and not math.isinf(escape) and escape > barrier:
        said.append(f"Another stable equilibrium is reached from {escape:.6g}{joule} on.")
    if (kick := weakest_kick(well)) is not None:
        said.append(f"A kick of less than {_short(kick)}{impulse}, {_which(well)}, does not take it out.")
    if (angle := weakest_tilt(well)) is not None:
        said.append(f"Turned by less than {_short(angle)}° about whatever axis, and let go at rest in the "
                    "orbit, it stays too.")
    if well.damped:
        said.append("Under internal damping every motion inside comes back.")
    return said + _if_damped(well, impulse) + _in_its_frame(well, impulse)


def well_data(well: Well | str) -> dict[str, Any]:
    """The same as data for JSON; null for what is not known, or is infinite."""
    if isinstance(well, str):
        return {**dict.fromkeys(("barrier", "escape", "at_least", "kick", "any_kick", "damped_kick", "tilt",
                                "damped")),
                "kind": "", "held_at_every_energy": False, "passes": [], "beyond": [], "reason": well}
    barrier, kick = well.barrier_double, weakest_kick(well)
    return {"barrier": _finite(barrier), "escape": _finite(well.escape_double), "kind": well.kind,
            "held_at_every_energy": barrier == math.inf, "at_least": well.bound,
            "passes": [e.doubles.place for e in well.passes],
            "beyond": [e.doubles.place for e in well.beyond],
            "kick": _finite(kick), "any_kick": any_kick(well), "damped_kick": damped_kick(well),
            "tilt": weakest_tilt(well),
            "damped": well.damped, "reason": well.reason}


def _which(well: Well) -> str:
    """The kicks that are bounded."""
    if well.line is not None:
        return "across its axis, about the line of nodes"
    return "in whatever direction" + (" across k" if well.rotation.scene.kind is Kind.FIELD else "")


def _in_its_frame(well: Well, unit: str) -> list[str]:
    """What holds for kicks that change C1; it promises less, for other places to rest may lie inside."""
    if (kick := any_kick(well)) is None:
        return []
    return _over_it(kick, unit)


def _if_damped(well: Well, unit: str) -> list[str]:
    """What a body of revolution survives that loses energy inside, and its spin with it."""
    if (kick := damped_kick(well)) is None:
        return []
    return [f"Under internal damping a kick across its axis of less than {_short(kick)}{unit} does not "
            "take it out."]


def _over_it(kick: float, unit: str) -> list[str]:
    return [f"Any kick of less than {_short(kick)}{unit} keeps k over its well in the frame that turns with "
            "it, inside which there may be other places to rest."]


def _where(found: RelativeEquilibrium) -> str:
    if found.attitude is not None:
        return str(found.attitude).replace("-", "−")
    numbers = [x for name, x in found.doubles.place.items() if name[-1] in "123" and x is not None]
    name = next(iter(found.doubles.place)).rstrip("123")
    return f"{name} = ({', '.join(f'{x:.6f}' for x in numbers)})".replace("-", "−")


def _short(number: float) -> str:
    return f"{float(SHORT.create_decimal(number)):.6g}"


def _finite(number: float | None) -> float | None:
    return number if number is not None and math.isfinite(number) else None
