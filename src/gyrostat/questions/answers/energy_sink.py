"""The energy-sink condition of a dual spinner, a platform and one rotor with dampers."""
from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr

from ...algebra.text.numbers import exact_expression
from ...errors import ValuesError
from ...mechanics.families.principal_rotation import principal_rotation
from ...mechanics.families.scene_tables import SceneTable
from ...notation import symbol
from ...stability.criteria.conditions import Criterion
from ...stability.damping.energy_sink import energy_sink_criterion


def sink_of(scene: SceneTable, dampings: tuple[str | None, str | None],
            numbers: Mapping[str, Expr]) -> Criterion:
    """The energy-sink condition of a rotation about the axis of the one rotor of a scene, at numbers."""
    if len(scene.rotors) != 1:
        raise ValuesError("the energy-sink condition is that of a platform and one rotor, and the scene has "
                          f"{len(scene.rotors)} rotors: give one wheel, or a scene of a file with rotors")
    (rotor,) = scene.rotors
    along = [n for n, x in enumerate(rotor.axis, 1) if x != 0]
    if len(along) != 1:
        raise ValuesError(f"the axis of the rotor is {tuple(rotor.axis)}, and the energy-sink condition is "
                          "for a principal axis: give 1, 0, 0 or 0, 1, 0 or 0, 0, 1")
    eq = principal_rotation(scene.system, along[0])
    eq = replace(eq, relations=tuple((symbol(name), x) for name, x in numbers.items()))
    platform, wheel = (exact_expression(text or "0", name)
                       for text, name in zip(dampings, ("platform_damping", "rotor_damping")))
    return energy_sink_criterion(eq, rotor, platform_damping=platform, rotor_damping=wheel)
