"""The values of a parameter at which the stability of E1, E2 and E3 may change, at a fixed rotor and rate."""
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sympy import Expr, S, Symbol

from ...algebra.reals.exact import Point, evaluate, sign_of_constant
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import real_roots
from ...errors import EquilibriumError, ValuesError
from ...mechanics.equilibrium.reduction import K3, OMEGA, P
from ...mechanics.families.named_families import E3, POLES
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.numbers_asked import unknown
from ...stability.report.analysis import analyze
from ..finders.rate_level_tilt import exact_point
from .bifurcation_kinds import precessions_leave
from .meeting_equations import bifurcations, insert

# derivative of g; if all up to it vanish on a branch, g vanishes there
HIGHEST = 24


def within(t: Expr, low: Expr, high: Expr) -> bool:
    """Tell whether a value is in a range, its ends included."""
    return sign_of_constant(t - low) != -1 and sign_of_constant(high - t) != -1


def admissible(positive: Iterable[Expr], numbers: Point, free: Symbol, low: Expr, high: Expr) -> None:
    """Refuse a range in which a moment of inertia, or another positive number of a body, is not positive."""
    for moment in dict.fromkeys(m for m in positive if free in m.free_symbols):
        placed = moment.xreplace(numbers)
        if placed.free_symbols - {free}:
            continue                                       # a missing name is reported later
        zeros = real_roots(placed, free) or []
        at_end = evaluate(placed, {free: low})
        if sign_of_constant(at_end) != 1 or any(within(zero, low, high) for zero in zeros):
            raise ValuesError(f"{free} goes from {low} to {high}, and {moment} has to be positive: "
                              "give a range in which it is")


def numbers_beside(scene: System, name: str, values: Mapping[str, Any], needed: set[str], what: str) -> Point:
    """Return the values of all names that are needed but the one that is free; refuse any others."""
    if not needed:
        raise ValuesError(f"all numbers of the scene are given, and {name} is to be free: write the letter "
                          f"{name} in its body or its field")
    if name not in needed:
        raise ValuesError(unknown(name, sorted(needed), "the scene"))
    if name in values:
        raise ValuesError(f"{name} is free, and the value {values[name]} is given for it: leave out one "
                          "of the two")
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys() - {name}):
        raise ValuesError(f"the {what} need {', '.join(missing)}: give a number for each")
    return numbers


def margin_at_rate(scene: System, numbers: Point, free: Symbol) -> tuple[Expr, Expr]:
    """Return −g''/2 at E3 in k3 and the free name, and (1 − k3²) U.

    The higher derivatives of the second are those of g but for a factor.
    """
    (level,) = [b for b in bifurcations(scene) if b.kind == "fold on a level"]
    spin = scene.body.moments[2] * OMEGA * K3 + scene.body.gyrostatic_momentum[2]
    assert scene.potential is not None
    held = ((1 - K3**2) * scene.potential.expression).xreplace(numbers)
    return insert(scene, level.equations[1].xreplace({P: spin}), K3, numbers, {free, K3}, E3.label), held


def margins_vanish(curve: PlaneCurve, margin: Expr, held: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Yield the places of E3 at which g'' vanishes.

    On a component on which it vanishes everywhere, the first derivative of g that does not is taken.
    """
    for component in curve.components:
        expression, n = margin, 2
        while n < HIGHEST and divmod(top := curve.polynomial(expression), component)[1] == 0:
            n += 1
            expression = held.diff(K3, n)
        if n < HIGHEST:
            yield from curve.common(component, top)


def changes_at_pole(scene: System, numbers: Point, free: Symbol, s: int) -> list[Expr]:
    """Return where the first coefficient of g at E1 or E2 that is not always 0 vanishes or is infinite."""
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
