"""gyrostat conditions --platform-damping --rotor-damping: the energy-sink condition of a dual spinner."""
import argparse
from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr

from ...algebra.text.grammar import parse
from ...errors import ValuesError
from ...mechanics.families.principal_rotation import principal_rotation
from ...notation import symbol
from ...stability.criteria.conditions import Criterion
from ...stability.damping.energy_sink import energy_sink_criterion
from ..options.scene_files import scene_of_file


def sink_of(given: argparse.Namespace, numbers: Mapping[str, Expr]) -> Criterion | None:
    """Of the one rotor of the file of --scene, about its axis, at numbers; None where no damping is given."""
    dampings = given.platform_damping, given.rotor_damping
    if dampings == (None, None):
        return None
    rotors = () if given.scene is None else scene_of_file(given.scene).rotors
    if len(rotors) != 1:
        raise ValuesError("--platform-damping and --rotor-damping are of a platform and one rotor, and "
                          f"{len(rotors)} are given: name a --scene with rotors = [{{ axis = …, axial = … "
                          "}]")
    (rotor,) = rotors
    along = [n for n, x in enumerate(rotor.axis, 1) if x != 0]
    if len(along) != 1:
        raise ValuesError(f"the axis of the rotor is {tuple(rotor.axis)}, and the energy-sink condition is "
                          "for a principal axis: give 1, 0, 0 or 0, 1, 0 or 0, 0, 1")
    eq = principal_rotation(scene_of_file(given.scene).system, along[0])
    eq = replace(eq, relations=tuple((symbol(name), x) for name, x in numbers.items()))
    platform, wheel = (parse(text or "0") for text in dampings)
    return energy_sink_criterion(eq, rotor, platform_damping=platform, rotor_damping=wheel)
