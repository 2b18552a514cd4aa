"""At a fixed rotor and rate.

The values of a parameter where branches of E1, E2 and E3 meet or end, or their stability may change.
"""
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from sympy import Expr, S, Symbol

from ...algebra.reals.exact import Point, evaluate, sign_of_constant
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import real_roots
from ...algebra.solving.stations import critical_points
from ...errors import EquilibriumError, ValuesError
from ...mechanics.equilibrium.reduction import K3, OMEGA, P
from ...mechanics.families.named_families import E3, POLES
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.report.analysis import analyze
from ..finders.rate_level_tilt import exact_point, names_of
from .bifurcation_kinds import precessions_leave
from .meeting_equations import bifurcations, insert, relation_at_rate

# derivative of g; if all up to it vanish on a branch, g vanishes there
HIGHEST = 24


@dataclass(frozen=True)
class Critical:
    """What may happen over a range of one parameter.

    Parameters
    ----------
    curve : PlaneCurve
        E3 in k3 and the parameter
    points : tuple
        (value, k3) where E3 meets, ends, or its margin vanishes
    margins : frozenset
        those where its margin vanishes
    infinite : frozenset
        those where U is infinite
    lines : tuple
        values at which every tilt is E3
    poles : dict
        for E1 (1) and E2 (−1) the values where its margin vanishes or U is infinite
    """

    curve: PlaneCurve
    points: tuple[tuple[Expr, Expr], ...]
    margins: frozenset[tuple[Expr, Expr]]
    infinite: frozenset[tuple[Expr, Expr]]
    lines: tuple[Expr, ...]
    poles: dict[int, tuple[Expr, ...]]


def critical_of(scene: System, name: str, low: Expr, high: Expr, values: Mapping[str, Any]) -> Critical:
    """All of them, exact; arguments as in continuation, the ends of the range as exact numbers."""
    known = names_of(scene) | {"omega"}
    numbers, free = exact_point(scene, values, known), symbol(name)
    if name not in known or "omega" not in (name, *values):
        raise ValuesError(f"E3 is followed at a rate about the vertical, given were {', '.join(values)}, "
                          f"free is {name}: give omega "
                          f"too, or leave it free; the names are {', '.join(sorted(known))}")
    if free in numbers:
        raise ValuesError(f"{name} is along the axis, and has the value {numbers[free]} too: leave "
                          "out one of the two")
    admissible({*scene.body.moments[1:]} | ({free} if free.is_positive else set()), numbers, free, low, high)
    margin, held = _margin(scene, numbers, free)
    curve = PlaneCurve(insert(scene, relation_at_rate(scene), K3, numbers, {free, K3}, E3.label), K3, free,
                       (margin, held))
    inside = cache(lambda t: within(t, low, high))

    def kept(points: Iterable[tuple[Expr, Expr]]) -> tuple[tuple[Expr, Expr], ...]:
        return tuple(dict.fromkeys(point for point in points if inside(point[0])))

    margins = kept(_margins(curve, margin, held))
    infinite = kept(point for F in curve.components for pole in curve.poles
                    for point in curve.common(F, pole))
    lines = tuple(t for line in curve.lines for t in real_roots(curve.ring.expression(line), free) or ()
                  if inside(t))
    poles = {s: tuple(t for t in _at_pole(scene, numbers, free, s) if inside(t)) for s in POLES}
    points = tuple(dict.fromkeys((*kept(critical_points(curve)), *margins, *infinite)))
    return Critical(curve, points, frozenset(margins), frozenset(infinite), lines, poles)


def within(t: Expr, low: Expr, high: Expr) -> bool:
    """Whether a value is in a range, its ends included."""
    return sign_of_constant(t - low) != -1 and sign_of_constant(high - t) != -1


def admissible(positive: Iterable[Expr], numbers: Point, free: Symbol, low: Expr, high: Expr) -> None:
    """Refuse a range in which what is positive of a body is not."""
    for moment in dict.fromkeys(m for m in positive if free in m.free_symbols):
        placed = moment.xreplace(numbers)
        if placed.free_symbols - {free}:
            continue                                       # named as missing later
        zeros = real_roots(placed, free) or []
        at_end = evaluate(placed, {free: low})
        if sign_of_constant(at_end) != 1 or any(within(zero, low, high) for zero in zeros):
            raise ValuesError(f"{free} goes from {low} to {high}, and {moment} is a moment of inertia: "
                              "give a range in which it is "
                              "positive")


def _margin(scene: System, numbers: Point, free: Symbol) -> tuple[Expr, Expr]:
    """−g''/2 at E3 in k3 and the free name, and (1 − k3²) U, whose higher derivatives are those of g but for
    a factor.
    """
    (level,) = [b for b in bifurcations(scene) if b.kind == "fold on a level"]
    spin = scene.body.moments[2] * OMEGA * K3 + scene.body.gyrostatic_momentum[2]
    assert scene.potential is not None
    held = ((1 - K3**2) * scene.potential.expression).xreplace(numbers)
    return insert(scene, level.equations[1].xreplace({P: spin}), K3, numbers, {free, K3}, E3.label), held


def _margins(curve: PlaneCurve, margin: Expr, held: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Where g'' vanishes on E3.

    On a component on which it does everywhere, the first derivative of g that does not.
    """
    for component in curve.components:
        expression, n = margin, 2
        while n < HIGHEST and divmod(top := curve.polynomial(expression), component)[1] == 0:
            n += 1
            expression = held.diff(K3, n)
        if n < HIGHEST:
            yield from curve.common(component, top)


def _at_pole(scene: System, numbers: Point, free: Symbol, s: int) -> list[Expr]:
    """Where the first coefficient of g at E1 or E2 that is not 0 everywhere vanishes or is infinite."""
    spin = {symbol("pi3_0"): s * scene.body.moments[2] * OMEGA}
    try:
        eq = POLES[s].of(scene)
    except EquilibriumError:                               # U is infinite there
        return []
    margins = (b.equations[0] for b in bifurcations(scene) if b.kind == precessions_leave(POLES[s]))
    boundary = analyze(eq).boundary
    assert boundary is not None
    for margin in (*margins, *(eq.insert(rung.condition.margin) for rung in boundary.rungs())):
        placed = insert(scene, margin.xreplace(spin), S(s), numbers, {free}, eq.label)
        if placed.has(S.ComplexInfinity, S.NaN):
            return []
        ring = Ring([placed, free])
        if (zeros := real_roots(placed, free)) is not None:
            return zeros + (real_roots(ring.expression(ring.fraction(placed)[1]), free) or [])
    return []
