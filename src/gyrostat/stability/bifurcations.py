"""Where relative equilibria of a body of revolution meet.

E3 leaves E1 or E2, tilts meet. Equations, and numbers.
"""
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from sympy import Expr, S, Symbol, expand

from ..algebra.exact import Point, evaluate, proved_sign
from ..algebra.plane_curves import PlaneCurve
from ..algebra.roots import in_order, real_roots
from ..algebra.stations import Place, critical_points, stations
from ..errors import EquilibriumError, ValuesError
from ..mechanics.family import Family
from ..mechanics.reduction import K3, OMEGA, P, V, expansion, reduce
from ..mechanics.system import System
from ..mechanics.tilted import E3
from ..mechanics.vertical import POLES
from ..notation import Shown, Stored, jet, symbol
from .asked import exact_point, names_of
from .values import unknown

KINDS = {
    "E3 leaves E1": "at a fixed rotor and rate about the vertical; E1 is stable on both sides",
    "E3 leaves E2": "at a fixed rotor and rate about the vertical; E2 is stable on both sides",
    "fold at fixed rate": "two E3 meet at a fixed rotor and rate about the vertical; stability does not "
                          "change there",
    "precessions leave E1": "the boundary of E1, on the levels of E1; Report.boundary decides whether they "
                            "are stable",
    "precessions leave E2": "the boundary of E2, on the levels of E2; Report.boundary decides whether they "
                            "are stable",
    "fold on a level": "two precessions meet on a level of both momenta; one is stable, the other is not",
}
MEETINGS = {
    "fold": "branches meet that exist on one side only",
    "pitchfork": "one branch on one side, three or more on the other",
    "crossing": "as many branches on one side as on the other, two or more",
    "isolated": "there is a tilt at this value, and none beside it",
}
AT_RATE, ON_LEVEL = "at fixed rate", "on a level"


@dataclass(frozen=True, repr=False)
class Bifurcation(Shown, Stored):
    """Equations of one kind of bifurcation.

    Parameters
    ----------
    kind : str
        a key of KINDS, which says what happens there
    equations : tuple of Expr
        vanish there; omega is the rate about the vertical, p_psi is π3 + l
    at : Expr
        the k3 at which derivatives of U are taken

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> first = gs.bifurcations(top)[0]
    >>> first.kind, first.equations
    ('E3 leaves E1', (I1*omega**2 - I3*omega**2 + dU - l*omega,))
    """

    kind: str
    equations: tuple[Expr, ...]
    at: Expr


@dataclass(frozen=True, repr=False)
class BifurcationPoint(Shown, Stored):
    """The value of the free name at which a bifurcation takes place, and the k3 where.

    Its kind says what happens; where branches meet between the poles "at fixed rate" or "on a level", it
    starts with "fold", "pitchfork", "crossing" or "isolated".

    Parameters
    ----------
    kind : str
    name : str
        the one that is free
    value : Expr
    k3 : Expr

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> point = gs.bifurcation_points(top, values={"I1": 1, "l": 0, "m0": 1}, name="pi3_0")[0]
    >>> point.kind, point.value, point.k3
    ('precessions leave E1', -2, 1)
    """

    kind: str
    name: str
    value: Expr
    k3: Expr


def bifurcations(scene: System) -> tuple[Bifurcation, ...]:
    """The bifurcations of the relative equilibria of a body of revolution in U(k3), as equations.

    Parameters
    ----------
    scene : System
        a body of revolution in U(k3)

    Returns
    -------
    tuple of Bifurcation
        each with what vanishes there, in the names of the scene and the derivatives of U

    Raises
    ------
    ScopeError
        the body is not of revolution, or U is not U(k3)

    References
    ----------
    Lewis, Ratiu, Simo & Marsden, Nonlinearity 5 (1992) 1-48, for the heavy top; else derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> for b in gs.bifurcations(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()))[:5]:
    ...     print(b.kind, *b.equations, sep=": ")
    E3 leaves E1: I1*omega**2 - I3*omega**2 + dU - l*omega
    E3 leaves E2: -I1*omega**2 + I3*omega**2 + dU - l*omega
    fold at fixed rate: I1*k3*omega**2 - I3*k3*omega**2 + dU - l*omega: I1*omega**2 - I3*omega**2 + d2U
    precessions leave E1: 4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2
    precessions leave E2: -4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2
    """
    relation, motion = relation_at_rate(scene), reduce(scene)
    slope = relation.diff(K3) + symbol("d2U")
    found: list[tuple[str, tuple[Expr, ...], Expr]] = [
        *((tilt_leaves(family), (relation.xreplace({K3: S(s)}),), S(s)) for s, family in POLES.items()),
        ("fold at fixed rate", (relation, slope), K3)]
    for family in POLES.values():
        with suppress(EquilibriumError):                   # U is infinite at the pole
            eq = family.of(scene)
            found.append((precessions_leave(family), (expansion(eq, 2)[2],), eq.at))
    found.append(("fold on a level", (motion.precession(), motion.restoring()), K3))
    return tuple(Bifurcation(*row) for row in found)


def bifurcation_points(scene: System, name: str, values: Mapping[str, Any]) -> list[BifurcationPoint]:
    """The values of one name at which relative equilibria meet, all others being given; exact and complete.

    Parameters
    ----------
    scene : System
        a body of revolution in a U rational in k3
    name : str
        what is left free; a moment is positive
    values : mapping of name to number
        everything but the name: moments, l, the parameters of U, and omega (fixed rate), pi3_0 (the levels C1
        = ±(π3 + l) of E1 and E2), or pi3_0 and C1 (a level)

    Returns
    -------
    list of BifurcationPoint
        by value

    Raises
    ------
    ValuesError
        names are missing or unknown, or a number is not admissible
    ScopeError
        the body is not of revolution, U is unspecified, or not rational in k3

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> [(b.kind, b.value) for b in gs.bifurcation_points(top, "l", {"I1": 2, "I3": 1, "m0": 3, "omega": 1})]
    [('E3 leaves E2', 2), ('E3 leaves E1', 4)]
    >>> [(b.kind, b.value) for b in gs.bifurcation_points(top, "pi3_0", {"I1": 1, "l": 0, "m0": 1})]
    [('precessions leave E1', -2), ('precessions leave E1', 2)]
    """
    known = names_of(scene) | {"omega", "pi3_0", "C1"}
    if name not in known:
        raise ValuesError(unknown(name, sorted(known), "the scene"))
    free, numbers = symbol(name), exact_point(scene, values, known)
    given = {OMEGA, symbol("pi3_0"), symbol("C1")} & {free, *numbers}
    kinds = {frozenset({OMEGA}): AT_RATE, frozenset({symbol("pi3_0")}): "precessions leave",
             frozenset({symbol("pi3_0"), symbol("C1")}): ON_LEVEL}.get(frozenset(given))
    if kinds is None or free in numbers:
        raise ValuesError(f"given were {', '.join(map(str, values))}, free is {name}: of omega, or pi3_0, "
                          "or pi3_0 and C1, give each or "
                          "leave it free, and give a number for every other name")
    found = [point for point in (_at_poles if kinds == "precessions leave"
                                 else _meetings)(scene, numbers, free, kinds)
             if positive(scene, numbers, free, point.value)]
    order = {
        value: n for n, value in enumerate(in_order(list(dict.fromkeys(point.value for point in found))))
    }
    return sorted(found, key=lambda point: order[point.value])


def positive(scene: System, numbers: Point, free: Symbol, value: Expr) -> bool:
    """Whether every moment of inertia is positive at a value of a free name."""
    moments = [m for m in scene.body.inertia[1:] if free in m.free_symbols]
    if free.is_positive:
        moments.append(free)
    return all(proved_sign(evaluate(m, {**numbers, free: value})) == 1 for m in moments)


def _at_poles(scene: System, numbers: Point, free: Symbol, kinds: str) -> Iterator[BifurcationPoint]:
    for b in bifurcations(scene):
        if b.kind.startswith(kinds):
            placed = insert(scene, b.equations[0], b.at, numbers, {free}, b.kind)
            # U is infinite at the pole: there is no E1 or E2
            if not placed.has(S.ComplexInfinity, S.NaN):
                yield from (BifurcationPoint(b.kind, free.name, value, b.at)
                            for value in real_roots(placed, free) or ())


def _meetings(scene: System, numbers: Point, free: Symbol, kinds: str) -> Iterator[BifurcationPoint]:
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
                yield BifurcationPoint(kind, free.name, station.t, place.x)


def tilt_leaves(family: Family) -> str:
    """The kind of bifurcation at a fixed rate at which tilts come from a pole."""
    return f"{E3.label} leaves {family.label}"


def precessions_leave(family: Family) -> str:
    """The kind of bifurcation on the levels of a pole at which precessions come from it."""
    return f"precessions leave {family.label}"


def kind_of(place: Place, kinds: str) -> str:
    """The name of what happens at a place of the curve of E3, or of the precessions of a level, by the
    branches that come to it.
    """
    few, many = sorted((len(place.left), len(place.right)))
    if place.x**2 == 1:
        return tilt_leaves(POLES[int(place.x)]) if many else ""
    if few == many == 1:                                   # one branch passes
        return ""
    if many == 0:
        return f"isolated {kinds}"
    if few == 0:
        return f"fold {kinds}"
    return f"pitchfork {kinds}" if few == 1 else f"crossing {kinds}"


def defined(curve: PlaneCurve, t: Expr, x: Expr) -> bool:
    """Whether U' is finite at a point."""
    return all(curve.sign(pole, t, x) != 0 for pole in curve.poles)


def insert(scene: System, expression: Expr, at: Expr, numbers: Point, allowed: set[Symbol],
           what: str) -> Expr:
    """With the derivatives of U at a k3, and numbers for all names but those allowed."""
    assert scene.potential is not None
    jets = {d: scene.potential.value(d).xreplace({K3: at}) for d in expression.free_symbols if jet(d.name)}
    placed = expression.xreplace(jets).xreplace(numbers)
    if missing := sorted(s.name for s in placed.free_symbols - allowed):
        raise ValuesError(f"{what} needs {', '.join(missing)}: give a number for each")
    return placed


def relation_at_rate(scene: System) -> Expr:
    """U' − ω l + ω² k3 (I1 − I3), the precession without spin about the axis."""
    total = scene.body.inertia[2] * OMEGA * K3 + scene.body.gyrostatic_momentum[2]
    return expand(reduce(scene).precession().xreplace({P: total}))
