"""Finds as numbers the values of a name at which relative equilibria of a body of revolution meet."""
from collections.abc import Iterator, Mapping
from typing import Any

from sympy import Expr, S, Symbol, oo

from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import in_order, real_roots
from ...algebra.solving.stations import critical_points, stations
from ...arguments import checked
from ...errors import ValuesError
from ...mechanics.equilibrium.reduction import K3, OMEGA, P, V, reduce
from ...mechanics.families.named_families import POLES
from ...mechanics.scenes.coupled import in_one_direction
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, at_numbers
from ...notation import symbol
from ...stability.criteria.numbers_asked import unknown
from ..finders.rate_level_tilt import LENGTH, MARKED, exact_point, names_of, numbers_of_rotations
from .bifurcation_kinds import AT_RATE, ON_LEVEL, defined, kind_of, tilt_leaves
from .following import follow
from .free_meetings import rotation_curve, rotations_meet
from .mark import Mark
from .meeting_equations import bifurcations, insert, relation_at_rate
from .orbit_branches import OrbitBranches


@checked
def bifurcation_points(scene: System, name: str, values: Mapping[str, Any]) -> list[Mark]:
    """Return the exact values of one name at which relative equilibria meet, all others given.

    None is missing. For a satellite in a circular orbit these are the marks of continuation over all values
    of the name, complete as far as it says; each has in `numbers` how many attitudes there are before and
    after it, which papers print as 24, 20, …, 8.

    Parameters
    ----------
    scene : System
        a body of revolution in a U rational in k3, any body without a field, or a satellite in a circular
        orbit
    name : str
        what is left free; a moment is positive
    values : mapping of name to number
        everything but the name: moments, l, the parameters of U, and omega (fixed rate), pi3_0 (the levels
        C1 = ±(π3 + l) of E1 and E2), or pi3_0 and C1 (a level); for a free gyrostat moments, rotor and M;
        for a satellite tensor, rotor, omega0 and the parameters of the potential

    Returns
    -------
    list of Mark
        by value

    Raises
    ------
    ValuesError
        names are missing or unknown, or a number is not admissible
    ScopeError
        the body is not of revolution, U is unspecified, or not rational in k3; for a satellite as in
        continuation

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> at_rate = {"I1": 2, "I3": 1, "m0": 3, "omega": 1}
    >>> [(b.kind, b.value) for b in gs.bifurcation_points(top, "l", at_rate)]
    [('E3 leaves E2', 2), ('E3 leaves E1', 4)]
    >>> at_poles = {"I1": 1, "l": 0, "m0": 1}
    >>> for b in gs.bifurcation_points(top, "pi3_0", at_poles):
    ...     print(b.kind, b.value)
    precessions leave E1 -2
    precessions leave E1 2
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    >>> for b in gs.bifurcation_points(free, "M", {"l": 1}):
    ...     print(b.kind, b.value, b.nu)
    pitchfork 1/2 1
    pitchfork 2 1/2
    >>> tensor = gs.Gyrostat((1, "5/4", "8/5"), (0, gs.symbol("l"), 0))
    >>> satellite = gs.assemble(tensor, gs.circular_orbit(1))
    >>> for point in gs.bifurcation_points(satellite, "l", {})[8::2]:
    ...     print(point)
    pitchfork at l = 1/4, from 24 to 20 attitudes
    pitchfork at l = 7/20, from 20 to 16 attitudes
    pitchfork at l = 1, from 16 to 12 attitudes
    pitchfork at l = 7/5, from 12 to 8 attitudes
    """
    if scene.kind is Kind.ORBIT:
        curve = OrbitBranches(scene, name, -oo, oo, values)
        return follow(curve, *curve.ends).marks
    in_one_direction(scene.potential, "bifurcation_points")
    if scene.potential is None:
        return _of_rotations(scene, name, values)
    own = names_of(scene, MARKED)
    asked = {"omega", "pi3_0", "C1"} - own
    known = own | asked
    if name not in known:
        raise ValuesError(unknown(name, sorted(known), "the scene"))
    free, numbers = symbol(name), exact_point(scene, values, known)
    given = set(map(symbol, asked)) & {free, *numbers}
    kinds = {frozenset({OMEGA}): AT_RATE, frozenset({symbol("pi3_0")}): "precessions leave",
             frozenset({symbol("pi3_0"), symbol("C1")}): ON_LEVEL}.get(frozenset(given))
    if kinds is None or free in numbers:
        raise ValuesError(f"given were {', '.join(map(str, values))}, and {name} is free: choose omega, or "
                          "pi3_0, or pi3_0 and C1; give a number for each of these and for every other name, "
                          "except for the one that is free")
    found = [point for point in (_at_poles if kinds == "precessions leave"
                                 else _meetings)(scene, numbers, free, kinds)
             if positive(scene, numbers, free, point.value)]
    return _by_value(found)


def _by_value(found: list[Mark]) -> list[Mark]:
    order = {
        value: n for n, value in enumerate(in_order(list(dict.fromkeys(point.value for point in found))))
    }
    return sorted(found, key=lambda point: order[point.value])


def _of_rotations(scene: System, name: str, values: Mapping[str, Any]) -> list[Mark]:
    """Return the values for a scene without a field."""
    numbers = numbers_of_rotations(scene, values, name)
    body, radius, free = at_numbers(scene, numbers).body, numbers.get(LENGTH, LENGTH), symbol(name)
    met = rotations_meet(body, radius, free, rotation_curve(body, radius, free).double)
    return _by_value([Mark(kind, name, value, nu=nu, momentum=M) for kind, value, nu, M in met])


def positive(scene: System, numbers: Point, free: Symbol, value: Expr) -> bool:
    """Tell whether every moment of inertia is positive at a value of a free name."""
    moments = [m for m in scene.body.moments[1:] if free in m.free_symbols]
    if free.is_positive:
        moments.append(free)
    return all(proved_sign(evaluate(m, {**numbers, free: value})) == 1 for m in moments)


def _at_poles(scene: System, numbers: Point, free: Symbol, kinds: str) -> Iterator[Mark]:
    for b in bifurcations(scene):
        if b.kind.startswith(kinds):
            placed = insert(scene, b.equations[0], b.at, numbers, {free}, b.kind)
            # U is infinite at the pole: there is no E1 or E2
            if not placed.has(S.ComplexInfinity, S.NaN):
                yield from (Mark(b.kind, free.name, value, b.at)
                            for value in real_roots(placed, free) or ())


def _meetings(scene: System, numbers: Point, free: Symbol, kinds: str) -> Iterator[Mark]:
    motion = reduce(scene)
    relation = relation_at_rate(scene)
    if kinds == ON_LEVEL:
        level = {P: symbol("pi3_0") + scene.body.gyrostatic_momentum[2], V: symbol("C1")}
        relation = motion.precession().xreplace({OMEGA: motion.rate.xreplace(level)}).xreplace(level)
    first = tilt_leaves(POLES[1]) if kinds == AT_RATE else f"fold {kinds}"
    curve = PlaneCurve(insert(scene, relation, K3, numbers, {free, K3}, first), K3, free)
    points = critical_points(curve)
    infinite = {point for F in curve.components for pole in curve.poles for point in curve.common(F, pole)}
    for station in stations(curve, points):
        for place in station.places:
            kind = kind_of(place, kinds) if (station.t, place.x) not in infinite else ""
            if kind and (place.x**2 != 1 or (kinds == AT_RATE and defined(curve, station.t, place.x))):
                yield Mark(kind, free.name, station.t, place.x)
