"""A scene at numbers, for the pictures."""
from collections.abc import Mapping
from typing import Any

from sympy import Expr

from ..algebra.reals.exact import Point, evaluate
from ..equilibria.finders.rate_level_tilt import exact_point
from ..errors import ValuesError
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.system import System
from ..stability.criteria.numbers_asked import names_in


def numbers_of(scene: System, values: Mapping[str, Any], also: tuple[str, ...] = ()) -> Point:
    """The values as exact numbers.

    One for every parameter of the scene, and for the names asked for besides.
    """
    field = scene.potential.parameters if scene.potential else ()
    needed = {*names_in([*scene.body.entries, *scene.body.gyrostatic_momentum, *field]), *also}
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the picture needs {', '.join(missing)}: give a number for each")
    return numbers


def body_at(scene: System, numbers: Point) -> Gyrostat:
    """The body with numbers in the place of its parameters."""
    inertia: list[Expr] = [evaluate(moment, numbers) for moment in scene.body.moments]
    return Gyrostat(inertia, [evaluate(rotor, numbers) for rotor in scene.body.gyrostatic_momentum])
