"""Takes the numbers of a picture as exact numbers, and refuses names that are missing."""
from collections.abc import Mapping
from typing import Any

from ..algebra.reals.exact import Point
from ..equilibria.finders.rate_level_tilt import exact_point
from ..errors import ValuesError
from ..mechanics.scenes.system import System
from ..stability.criteria.numbers_asked import names_in


def numbers_of(scene: System, values: Mapping[str, Any], also: tuple[str, ...] = ()) -> Point:
    """Return the values as exact numbers: for each parameter of the scene, and for other names asked for."""
    field = scene.potential.parameters if scene.potential else ()
    needed = {*names_in([*scene.body.entries, *scene.body.gyrostatic_momentum, *field]), *also}
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the picture needs {', '.join(missing)}: give a number for each")
    return numbers
