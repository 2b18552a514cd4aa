"""Takes the numbers of a picture as exact numbers; a body of revolution in its own axes."""
from collections.abc import Mapping
from typing import Any

from ..algebra.reals.exact import Point
from ..algebra.text.numbers import exact_number
from ..equilibria.finders.rate_level_tilt import exact_point
from ..errors import ValuesError
from ..mechanics.equilibrium.recognition import recognise
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System, at_numbers, names_of_scene
from ..notation import symbol
from ..stability.criteria.numbers_asked import names_in


def numbers_of(scene: System, values: Mapping[str, Any], also: tuple[str, ...] = ()) -> Point:
    """Return the values as exact numbers: for each parameter of the scene, and for other names asked for."""
    field = scene.potential.parameters if scene.potential else ()
    needed = {*names_in([*scene.body.entries, *scene.body.gyrostatic_momentum, *field]), *also}
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the picture needs {', '.join(missing)}: give a number for each")
    return numbers


def in_own_axes(scene: System, values: Mapping[str, Any]) -> tuple[System, Mapping[str, Any], str, list[str]]:
    r"""Return a body of revolution with its axis as the third, the values left, its k3 and a line about c.

    A scene that is none, or has that axis already, is returned as it is. k3 is named in the axes of the user:
    k1, or k·c.

    Examples
    --------
    >>> import gyrostat as gs
    >>> T = [["17/9", "-2/9", "-2/9"], ["-2/9", "14/9", "-4/9"], ["-2/9", "-4/9", "14/9"]]
    >>> field = gs.general_potential(lambda *k: gs.symbol("m0") * (k[0] + 2 * k[1] + 2 * k[2]))
    >>> scene = gs.assemble(gs.Gyrostat(T, (0, 0, 0)), field)
    >>> standard, left, *names = in_own_axes(scene, {"m0": 2, "C1": 1})
    >>> standard.body.moments, standard.potential.expression, left, names
    ((2, 2, 1), 6*k3, {'C1': 1}, ['k \\cdot c', ['$c$ along $(1, 2, 2)$']])
    """
    if scene.kind is not Kind.FIELD or not scene.potential or not scene.potential.given:
        return scene, values, "k_3", []
    own = {s.name for s in names_of_scene(scene)}
    known = {symbol(name): exact_number(x, name) for name, x in values.items() if name in own}
    if (found := recognise(at_numbers(scene, known))) is None:
        return scene, values, "k_3", []
    left = {name: x for name, x in values.items() if name not in own}
    if found.name != "k·c":
        return found.standard, left, f"k_{found.name[1]}", []
    along = ", ".join(map(str, found.direction))
    return found.standard, left, r"k \cdot c", [f"$c$ along $({along})$"]
