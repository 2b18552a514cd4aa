"""Finds all relative equilibria of a body of revolution in a given U(k3): E1, E2, E3, precessions."""
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

from sympy import Expr, Integer, Pow, S, Symbol, sqrt

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.reals.exact import Point, evaluate, proved_sign, sign_of_constant
from ...algebra.solving.roots import real_roots
from ...errors import ValuesError
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.recognition import UNITS, Recognition
from ...mechanics.equilibrium.reduction import K3, OMEGA, P, V, reduce
from ...mechanics.families.family import Family
from ...mechanics.families.named_families import E3, E3_AT_REST, POLES
from ...mechanics.scenes.body import symmetric_gyrostat
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.potential import Potential
from ...mechanics.scenes.system import System, assemble, at_numbers, names_of_scene
from ...notation import symbol
from ...stability.decision import Verdict
from ...stability.report.analysis import analyze
from ...stability.report.report import Report
from .rate_level_tilt import C1, PI3, asked_about, asked_for
from .revolution_form import PRECESSION, RevolutionForm

DU = symbol("dU")
_MOMENTS = frozenset(map(symbol, ("I1", "I2", "I3")))


def revolution_forms(scene: System, values: Mapping[str, Any]) -> list[RevolutionForm]:
    """Return every relative equilibrium of a body of revolution in U(k3), as relative_equilibria says."""
    if scene.kind is Kind.FIELD and not scene.unspecified and (turned := asked_about(scene, values)):
        found, own = turned
        return _asked_of(SceneAtNumbers(found.standard, *asked_for(found.standard, own), found))
    return _asked_of(SceneAtNumbers(scene, *asked_for(scene, values)))


def _asked_of(here: "SceneAtNumbers") -> list[RevolutionForm]:
    numbers = here.numbers
    if here.asked == ("omega",):
        return here.at_rate(numbers[OMEGA])
    if here.asked == ("pi3_0", "C1"):
        return here.on_level(numbers[PI3], numbers[C1])
    if here.asked == ("k3",):
        return here.at_tilt(numbers[K3])
    return here.at_tilt(numbers[K3], numbers[PI3])


def pole_at(scene: System, s: int, values: Mapping[str, Any]) -> RevolutionForm | None:
    """Return E1 (s = 1) or E2 (s = −1) at values with omega; None if U is infinite there."""
    here = SceneAtNumbers(scene, *asked_for(scene, values))
    return next(iter(here.pole(s, s * here.I3 * here.numbers[OMEGA])), None)


def critical_tilt(scene: System, k3: Expr, values: Mapping[str, Any]) -> Verdict:
    """Return the verdict of an E3 at a fixed rate whose margin is known to vanish.

    It is what the first higher derivative of g says.

    Parameters
    ----------
    scene : System
    k3 : Expr
        exact, an E3 at these numbers
    values : mapping of name to number
        as in relative_equilibria, with omega
    """
    here = SceneAtNumbers(scene, *asked_for(scene, values))
    report = _report(here.potential, E3_AT_REST if sign_of_constant(here.numbers[OMEGA]) == 0 else E3)
    assert report.boundary is not None
    return report.boundary.decide(Point({**here.known, K3: k3, OMEGA: here.numbers[OMEGA]}), {}).verdict


@lru_cache(maxsize=256)
def _report(potential: Potential, family: Family) -> Report:
    """Return the report of a family of the symbolic body in a field."""
    scene = assemble(symmetric_gyrostat(), potential)
    # no name eliminated: that would ask its coefficient not to vanish
    if family is E3_AT_REST:
        point = (0, 0, 0, sqrt(1 - K3**2), 0, K3)
        return analyze(equilibrium(scene, point, relations=((DU, 0),), domain=(1 - K3**2,),
                                   label=family.label))
    return analyze(family.of(scene, eliminate="l"))


class SceneAtNumbers:
    """A scene at given numbers, and what is asked of it in different ways."""

    def __init__(self, scene: System, asked: tuple[str, ...], numbers: Point,
                 found: Recognition | None = None):
        assert scene.potential is not None
        self.asked, self.numbers, self._scene, self._found = asked, numbers, scene, found
        self.I1, _, self.I3 = (evaluate(m, numbers) for m in scene.body.moments)
        self.l = evaluate(scene.body.gyrostatic_momentum[2], numbers)
        body = {symbol("I1"): self.I1, symbol("I3"): self.I3, symbol("l"): self.l}
        parameters = {s: numbers[s] for s in scene.potential.parameters}
        potential = scene.potential
        powers = {s for power in potential.expression.atoms(Pow) for s in power.exp.free_symbols}
        own = {s: x for s, x in parameters.items()
               if s in powers or s in _MOMENTS and body.get(s) != x}
        self.potential = (
            replace(potential, expression=potential.expression.xreplace(own)) if own else potential
        )
        self.known = body | {s: x for s, x in parameters.items() if s not in own}
        self.motion = reduce(assemble(symmetric_gyrostat(), self.potential))
        self.slope = self.motion.precession().xreplace({DU: self.potential.value(DU)})

    def at_rate(self, omega: Expr) -> list[RevolutionForm]:
        tilts = self._solved(self.slope.xreplace({P: symbol("I3") * OMEGA * K3 + symbol("l")}),
                             {OMEGA: omega}, K3)
        found = (
            [self.tilted(k3, omega, S.Zero) for k3 in reversed(tilts)]
            if tilts is not None
            else [self.tilted(S.Zero, omega, S.Zero, "k3")]
        )
        return [*self.pole(1, self.I3 * omega), *found, *self.pole(-1, -self.I3 * omega)]

    def on_level(self, pi3: Expr, c1: Expr) -> list[RevolutionForm]:
        level = {P: pi3 + self.l, V: c1}
        tilts = self._solved(self.slope.xreplace({OMEGA: self.motion.rate}), level, K3)
        first, last = ([b for b in self.pole(s, pi3) if proved_sign(c1 - s * level[P]) == 0] for s in (1, -1))
        if tilts is None:
            return [*first, self.tilted(S.Zero, c1 / self.I1, pi3 / self.I3, "omega"), *last]
        rates = [(self.motion.rate.xreplace({**self.known, **level, K3: k3}), k3) for k3 in reversed(tilts)]
        return [*first, *(self.tilted(k3, omega, pi3 / self.I3 - omega * k3) for omega, k3 in rates), *last]

    def at_tilt(self, k3: Expr, pi3: Expr | None = None) -> list[RevolutionForm]:
        if not self._defined(k3):
            raise ValuesError(f"U = {self.potential.expression} is not defined at k3 = {k3}: choose "
                              "another tilt")
        total = symbol("I3") * OMEGA * K3 + symbol("l") if pi3 is None else P
        rates = self._solved(self.slope.xreplace({P: total}),
                             {K3: k3} if pi3 is None else {K3: k3, P: pi3 + self.l}, OMEGA)
        if rates is None:                                  # l = 0 = k3 (I1 − I3) and U' = 0, or their like
            raise ValuesError(f"at k3 = {k3} every rate about the vertical is that of a precession: give "
                              "omega too, to Report.verdict")
        sigma = [S.Zero if pi3 is None else pi3 / self.I3 - omega * k3 for omega in rates]
        return [self.tilted(k3, omega, spin) for omega, spin in zip(rates, sigma)]

    @cached_property
    def found(self) -> Recognition:
        """The scene at given numbers, and the axis."""
        if self._found is not None:
            return self._found
        own = names_of_scene(self._scene)
        here = at_numbers(self._scene, {s: x for s, x in self.numbers.items() if s in own})
        return Recognition(here, UNITS[2], here)

    def pole(self, s: int, pi3: Expr) -> list[RevolutionForm]:
        """Return E1 or E2; none if U is infinite there."""
        if not self._defined(Integer(s)):
            return []
        report = _report(self.potential, POLES[s])
        return [RevolutionForm(POLES[s].label, self.found, Integer(s), s * pi3 / self.I3, S.Zero, pi3, report,
                               self._asked(report, {"pi3_0": pi3}))]

    def tilted(self, k3: Expr, omega: Expr, sigma: Expr, every: str = "") -> RevolutionForm:
        """Return E3, or the precession that is E3 with the rotor l + I3 σ."""
        rest = proved_sign(omega) == 0
        report = _report(self.potential, E3_AT_REST if rest else E3)
        given = {"k3": k3, "l": self.l + self.I3 * sigma} if rest else {"k3": k3, "omega": omega}
        label = E3.label if proved_sign(sigma) == 0 and every != "omega" else PRECESSION
        return RevolutionForm(label, self.found, k3, omega, sigma, self.I3 * (omega * k3 + sigma), report,
                              self._asked(report, given), every)

    def _asked(self, report: Report, given: dict[str, Any]) -> dict[str, Any]:
        """Return the numbers that a report takes, without the names that its family eliminates."""
        everything = {**{s.name: x for s, x in self.known.items()}, **given}
        return {n: x for n, x in everything.items() if n in report.parameters
                and n not in report.equilibrium.eliminated}

    def _defined(self, k3: Expr) -> bool:
        value = evaluate(self.potential.expression, {**self.known, K3: k3})
        return ball(value, 64).is_finite() or sign_of_constant(value) is not None

    def _solved(self, relation: Expr, given: dict[Symbol, Expr], x: Symbol) -> list[Expr] | None:
        """Return where a relation vanishes.

        All numbers are inserted at once, so that none is inserted into another.
        """
        relation = relation.xreplace({**self.known, **given})
        return real_roots(relation, x, S.NegativeOne, S.One) if x == K3 else real_roots(relation, x)
