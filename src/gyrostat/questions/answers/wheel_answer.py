"""Answers conditions for the open speed of a wheel: the speeds at which an attitude in orbit is stable."""
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from sympy import Expr

from ..._lazy import loaded
from ...mechanics.families.circular_orbit import by_gradient_alone
from ...mechanics.families.named_families import EARTH_POINTING
from ...mechanics.scenes.system import at_numbers, names_of_scene
from ...notation import symbol
from ...printing.blocks import Block, Heading
from ...printing.formats.json_data import strings
from ..scene_texts import Asked, pointing_of, scene_of, table_of
from .equilibrium_labels import named
from .solve_for import interval_data

if TYPE_CHECKING:
    from ...parameters.wheel_speeds import SpeedSets, WheelSpeeds


def speeds_at(asked: Asked, given: Sequence[str] | None, name: str, numbers: Mapping[str, Expr],
              unit: str = "") -> "WheelSpeeds | None":
    """The speeds of a wheel at which the attitude that is asked for is stable; None if that is not asked.

    The name has to be that of the speed of a wheel, and every other name has to have a number.
    """
    if not asked.rotors or named(asked, given) not in ((), (EARTH_POINTING.label,)):
        return None
    scene, x = scene_of(asked), symbol(name)
    rates = [rotor.rate for rotor in table_of(asked).rotors if rotor.rate is not None]
    here = at_numbers(scene, {symbol(n): value for n, value in numbers.items()})
    if not by_gradient_alone(scene) or names_of_scene(here) != {x} or all(r.is_number for r in rates):
        return None
    found: WheelSpeeds = loaded("parameters.wheel_speeds:wheel_speeds")(
        here, name, *pointing_of(asked.pointing), unit=unit)
    return found


def speeds_blocks(found: "WheelSpeeds") -> list[Block]:
    """The sentences below the name of the attitude."""
    return [Heading(EARTH_POINTING.label), *loaded("printing.results.wheel_speeds:speeds_blocks")(found)]


def speeds_data(found: "WheelSpeeds") -> dict[str, Any]:
    """The same as data for JSON, in SI and exactly."""
    return {"equilibria": [{
        "label": EARTH_POINTING.label, "name": found.name, "parts": _parts(found.undamped),
        "damped": _parts(found.damped), "turn": str(found.turn), "carried": strings(found.carried),
        "only": None if found.only is None else str(found.only)}]}


def _parts(sets: "SpeedSets") -> list[dict[str, Any]]:
    """The sets as those of a condition that is solved without cases."""
    return [{"meaning": meaning, "margin": "1",
             "cases": [{"when": [], "intervals": list(map(interval_data, getattr(sets, meaning)))}]}
            for meaning in ("stable", "unstable", "undecided")]
