"""Finds every permanent rotation of any body in a field: at a rate, on a level, or in a direction."""
import contextlib
from collections.abc import Iterator, Mapping
from typing import Any

from sympy import Add, Expr, Matrix, S, eye

from ..._lazy import loaded
from ...algebra.pencils.exact_points import points_on_sphere
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.solving.real_fields import balls
from ...algebra.solving.roots import real_roots
from ...errors import ScopeError, ValuesError
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import symbol
from ...stability.form import PRECISION
from .heavy_form import HeavyForm, data_at
from .heavy_polynomials import DIRECTION, degree_in_k, directions_at_rate, rates_by_elimination
from .rate_level_tilt import C1, exact_point, refuse_as_level

OMEGA, SIGMA = symbol("omega"), symbol("sigma")


def heavy_forms(scene: System, values: Mapping[str, Any]) -> list[HeavyForm]:
    """Return every rotation at a rate omega, on a level C1, or in a direction k1, k2, k3.

    relative_equilibria says more about what is asked.
    """
    needed = {s.name for s in names_of_scene(scene)}
    asked = {"omega", "C1", *map(str, DIRECTION)} - needed
    numbers = exact_point(scene, values, needed | asked)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
    here = at_numbers(scene, {s: x for s, x in numbers.items() if s.name in needed})
    given = values.keys() & asked
    if given == {"omega"}:
        return sorted(_at_rate(here, numbers[OMEGA]), key=_place)
    if given == {"C1"}:
        return sorted(_on_level(here, numbers[C1]), key=_place)
    if given == set(map(str, DIRECTION)):
        return _in_direction(here, tuple(numbers[x] for x in DIRECTION))
    if not given:
        refuse_as_level(scene, C1.name)
    raise ValuesError(f"given were {', '.join(sorted(given)) or 'no names of the motion'}: give omega, the "
                      "rate about the vertical, or C1, the value of M·k, or k1, k2, k3, a direction")


def _at_rate(scene: System, omega: Expr) -> Iterator[HeavyForm]:
    """Yield the rotations at a rate: (omega² I − Q + sigma) k = c − omega l if U = c·k + k·Qk/2.

    In any other polynomial U they are found by elimination.
    """
    if degree_in_k(scene, "at a rate omega") > 2:
        yield from (HeavyForm(scene, *found) for found in directions_at_rate(scene, omega))
        return
    linear, curved = _quadratic(scene)
    pencil = omega**2 * scene.body.tensor - curved + SIGMA * eye(3)
    vector = linear - omega * Matrix(scene.body.gyrostatic_momentum)
    for numbers, circle in points_on_sphere(pencil, vector, S.One, SIGMA):
        yield HeavyForm(scene, numbers[1:], omega, circle)


def _on_level(scene: System, level: Expr) -> list[HeavyForm]:
    """Return the rotations on a level of C1.

    If U = c·k + k·Qk/2 and resultants tell all rotations apart, these are used, else elimination.
    """
    if degree_in_k(scene, "on a level of C1") < 3:
        linear, curved = _quadratic(scene)
        inertia, rotor = scene.body.tensor, Matrix(scene.body.gyrostatic_momentum)
        rates_on_level = loaded("equilibria.finders.heavy_levels:rates_on_level")
        with contextlib.suppress(ScopeError):
            return [HeavyForm(scene, k, omega, circle)
                    for omega, k, circle in rates_on_level(inertia, curved, linear, rotor, level)]
    return [HeavyForm(scene, *found) for found in rates_by_elimination(scene, level)]


def _quadratic(scene: System) -> tuple[Matrix, Matrix]:
    """Return c and Q of U = c·k + k·Qk/2."""
    _, _, linear, curved = data_at(scene, (S.Zero,) * 3)
    return Matrix(linear), Matrix(curved)


def _in_direction(scene: System, k: tuple[Expr, ...]) -> list[HeavyForm]:
    """Return the rotations in a direction: omega² Ik × k + omega l × k = ∇U × k."""
    length = evaluate(Add(*(x**2 for x in k)), {})
    if proved_sign(length - 1) != 0:
        raise ValuesError(f"k = ({', '.join(map(str, k))}) has |k|² − 1 = {length - 1}: k is a direction, "
                          "|k| = 1; divide it by its length")
    inertia, rotor, gradient, _ = data_at(scene, k)
    sides = zip(cross(scene.body.tensor * Matrix(k), k), cross(rotor, k), cross(gradient, k))
    residuals = [OMEGA**2 * a + OMEGA * b - c for a, b, c in sides]
    rates = [real_roots(residual, OMEGA) for residual in residuals]
    if not (proper := [found for found in rates if found is not None]):
        raise ValuesError("in that direction every rate omega is that of a permanent rotation: give omega "
                          "too, to Report.verdict")
    return [HeavyForm(scene, k, omega) for omega in proper[0]
            if all(proved_sign(evaluate(r, {OMEGA: omega})) == 0 for r in residuals)]


def _place(rotation: HeavyForm) -> list[float]:
    """Return the key that sorts rotations from the upright one down."""
    k1, k2, k3 = (float(x.mid()) for x in balls(rotation.k, PRECISION))
    return [-k3, k1, k2]
