"""Where relative equilibria of a body of revolution meet: E3 leaves E1 or E2, two tilts meet in a fold. Equations, and numbers."""
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from flint import fmpq_mpoly
from sympy import Expr, S, Symbol, expand

from .algebra import Ring, by_degree
from .branches import exact_point, names_of
from .errors import EquilibriumError, ValuesError
from .exact import Point, evaluate
from .families import hanging, upright
from .notation import Typeset, jet, symbol
from .reduction import K3, OMEGA, P, V, expansion, reduce
from .roots import in_order, inserted, proved_sign, real_roots
from .system import System
from .values import unknown

KINDS = {
    "E3 leaves E1": "at a fixed rotor and rate about the vertical; E1 is stable on both sides",
    "E3 leaves E2": "at a fixed rotor and rate about the vertical; E2 is stable on both sides",
    "fold at fixed rate": "two E3 meet at a fixed rotor and rate about the vertical; stability does not change there",
    "precessions leave E1": "the boundary of E1, on the levels of E1; Report.boundary decides whether they are stable",
    "precessions leave E2": "the boundary of E2, on the levels of E2; Report.boundary decides whether they are stable",
    "fold on a level": "two precessions meet on a level of both momenta; one is stable, the other is not",
}


@dataclass(frozen=True, repr=False)
class Bifurcation(Typeset):
    """Equations of one kind of bifurcation.

    Parameters
    ----------
    kind : str                   a key of KINDS, which says what happens there
    equations : tuple of Expr    vanish there; omega is the rate about the vertical, p_psi is π3 + l
    at : Expr                    the k3 at which derivatives of U are taken
    """

    kind: str
    equations: tuple[Expr, ...]
    at: Expr


@dataclass(frozen=True, repr=False)
class BifurcationPoint(Typeset):
    """The value of the free name at which a bifurcation takes place, and the k3 where."""

    kind: str
    name: str
    value: Expr
    k3: Expr


def bifurcations(scene: System) -> tuple[Bifurcation, ...]:
    """The bifurcations of the relative equilibria of a body of revolution in U(k3), as equations.

    Source
    ------
    Lewis, Ratiu, Simo & Marsden, Nonlinearity 5 (1992) 1-48, for the heavy top; else derived.

    Examples
    --------
    >>> from gyrostat import assemble, axial_potential, symmetric_gyrostat
    >>> for b in bifurcations(assemble(symmetric_gyrostat(), axial_potential()))[:5]:
    ...     print(b.kind, *b.equations, sep=": ")
    E3 leaves E1: I1*omega**2 - I3*omega**2 + dU - l*omega
    E3 leaves E2: -I1*omega**2 + I3*omega**2 + dU - l*omega
    fold at fixed rate: I1*k3*omega**2 - I3*k3*omega**2 + dU - l*omega: I1*omega**2 - I3*omega**2 + d2U
    precessions leave E1: 4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2
    precessions leave E2: -4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2
    """
    relation, motion = _relation(scene), reduce(scene)
    slope = relation.diff(K3) + symbol("d2U")
    found: list[tuple[str, tuple[Expr, ...], Expr]] = [
        ("E3 leaves E1", (relation.xreplace({K3: S.One}),), S.One), ("E3 leaves E2", (relation.xreplace({K3: -S.One}),), -S.One),
        ("fold at fixed rate", (relation, slope), K3)]
    for make in (upright, hanging):
        with suppress(EquilibriumError):                   # U is infinite at the pole
            eq = make(scene)
            found.append((f"precessions leave {eq.label}", (expansion(eq, 2)[2],), eq.at))
    found.append(("fold on a level", (motion.precession(), motion.restoring()), K3))
    return tuple(Bifurcation(*row) for row in found)


def bifurcation_points(scene: System, values: Mapping[str, Any], name: str) -> list[BifurcationPoint]:
    """The values of one name at which relative equilibria meet, all others being given; exact and complete.

    Parameters
    ----------
    scene : System                         a body of revolution in a U rational in k3
    values : mapping of name to number     everything but the name: moments, l, the parameters of U, and omega (fixed rate), pi3_0
                                           (the levels C1 = ±(π3 + l) of E1 and E2), or pi3_0 and C1 (a level)
    name : str                             what is left free; a moment is positive

    Returns
    -------
    list of BifurcationPoint               by value

    Raises
    ------
    ValuesError       names are missing or unknown, or a number is not admissible
    ScopeError        the body is not of revolution, U is unspecified, or not rational in k3

    Examples
    --------
    >>> from gyrostat import assemble, symmetric_gyrostat, uniform_field
    >>> top = assemble(symmetric_gyrostat(), uniform_field())
    >>> [(b.kind, b.value) for b in bifurcation_points(top, {"I1": 2, "I3": 1, "m0": 3, "omega": 1}, "l")]
    [('E3 leaves E2', 2), ('E3 leaves E1', 4)]
    >>> [(b.kind, b.value) for b in bifurcation_points(top, {"I1": 1, "l": 0, "m0": 1}, "pi3_0")]
    [('precessions leave E1', -2), ('precessions leave E1', 2)]
    """
    known = names_of(scene) | {"omega", "pi3_0", "C1"}
    if name not in known:
        raise ValuesError(unknown(name, sorted(known), "the scene"))
    free, numbers = symbol(name), exact_point(scene, values, known)
    given = {OMEGA, symbol("pi3_0"), symbol("C1")} & {free, *numbers}
    kinds = {frozenset({OMEGA}): ("E3 leaves E1", "E3 leaves E2", "fold at fixed rate"),
             frozenset({symbol("pi3_0")}): ("precessions leave E1", "precessions leave E2"),
             frozenset({symbol("pi3_0"), symbol("C1")}): ("fold on a level",)}.get(frozenset(given))
    if kinds is None or free in numbers:
        raise ValuesError(f"given were {', '.join(map(str, values))}, free is {name}: of omega, or pi3_0, or pi3_0 and C1, give each or "
                          "leave it free, and give a number for every other name")
    found = [point for b in bifurcations(scene) if b.kind in kinds for point in _points(b, scene, numbers, free)]
    order = {value: n for n, value in enumerate(in_order(list(dict.fromkeys(point.value for point in found))))}
    return sorted(found, key=lambda point: order[point.value])


def _points(b: Bifurcation, scene: System, numbers: Point, free: Symbol) -> list[BifurcationPoint]:
    assert scene.potential is not None
    motion, body = reduce(scene), scene.body
    first = b.equations[0]
    if b.kind == "fold on a level":
        level = {P: symbol("pi3_0") + body.gyrostatic_momentum[2], V: symbol("C1")}
        first = first.xreplace({OMEGA: motion.rate.xreplace(level)}).xreplace(level)
    jets = {d: scene.potential.value(d).xreplace({K3: b.at}) for d in first.free_symbols if jet(d.name)}
    placed = first.xreplace(jets).xreplace(numbers)
    allowed = {free, K3} if len(b.equations) == 2 else {free}
    if missing := sorted(s.name for s in placed.free_symbols - allowed):
        raise ValuesError(f"{b.kind} needs {', '.join(missing)}: give a number for each")
    if placed.has(S.ComplexInfinity, S.NaN):               # U is infinite at the pole: there is no E1 or E2
        return []
    positive = [m for m in body.inertia[1:] if free in m.free_symbols] + [free] * bool(free.is_positive)
    folds = len(b.equations) == 2
    found = dict.fromkeys(_folds(placed, free) if folds else ((value, b.at) for value in real_roots(placed, free) or ()))
    return [BifurcationPoint(b.kind, free.name, value, k3) for value, k3 in found
            if all(proved_sign(evaluate(m, {**numbers, free: value})) == 1 for m in positive)]


def _folds(expression: Expr, free: Symbol) -> Iterator[tuple[Expr, Expr]]:
    """(value, k3) where the numerator F and its slope in k3 vanish: k3 from their resultant, the value as a function of k3."""
    ring = Ring([expression, K3, free])
    k, t = ring.generators.index(K3), ring.generators.index(free)
    F = ring.one
    for factor, _ in ring.reduce(ring.fraction(expression)[0]).factor()[1]:
        if factor.degrees()[k] and factor not in (ring.gens[K3] - 1, ring.gens[K3] + 1):
            F *= factor                                    # each once; one that vanishes at a pole only, or at every tilt, is no fold
    slope = F.derivative(k)
    if not slope:
        return
    common = F.resultant(slope, F.context().names()[t]) if slope.degrees()[t] and F.degrees()[t] else slope
    bottom, top = _linear(F, slope, t)
    lead = by_degree(F, t, F.degrees()[t])[-1]
    for k3 in real_roots(ring.expression(common), K3, S.NegativeOne, S.One) or ():
        below, leading = (inserted(ring, f, {K3: k3}) for f in (bottom, lead))
        if proved_sign(below) and proved_sign(leading):          # the common root of F and the slope is that of a t + b
            yield -inserted(ring, top, {K3: k3}) / below, k3
            continue
        values = real_roots(inserted(ring, F, {K3: k3}), free)
        if values is None:                                 # a tilt that exists at every value: where another branch crosses it
            values = real_roots(inserted(ring, slope, {K3: k3}), free)
        for value in values or []:
            if proved_sign(inserted(ring, slope, {K3: k3, free: value})) == 0:
                yield value, k3


def _linear(F: fmpq_mpoly, G: fmpq_mpoly, place: int) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """(a, b) of a combination a t + b of two polynomials in t, by pseudo-division; (0, 0) where none is found."""
    while G.degrees()[place] > 1 and F.degrees()[place] > 1:
        F, G = (G, _remainder(F, G, place)) if F.degrees()[place] >= G.degrees()[place] else (F, _remainder(G, F, place))
    for f in (G, F):
        if f.degrees()[place] == 1:
            b, a = by_degree(f, place, 1)
            return a, b
    return G * 0, G * 0


def _remainder(F: fmpq_mpoly, G: fmpq_mpoly, place: int) -> fmpq_mpoly:
    """Pseudo-remainder of F by G in one generator."""
    n, t = G.degrees()[place], F.context().gens()[place]
    lead = by_degree(G, place, n)[n]
    while F and (m := F.degrees()[place]) >= n:
        F = lead * F - by_degree(F, place, m)[m] * t ** (m - n) * G
    return F


def _relation(scene: System) -> Expr:
    """U' − ω l + ω² k3 (I1 − I3), the precession without spin about the axis."""
    total = scene.body.inertia[2] * OMEGA * K3 + scene.body.gyrostatic_momentum[2]
    return expand(reduce(scene).precession().xreplace({P: total}))
