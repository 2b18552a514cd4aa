"""Compares published conditions and verdicts with the derived criteria, both in margin normal form."""
import operator
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

from sympy import Expr, Symbol

from ..._cached import cached_property
from ...algebra.reals.exact import sign_of_constant
from ...algebra.solving.margins import Signs
from ...errors import PublishedError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...notation import symbol
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.implication import Item, reduced
from ...stability.criteria.truth import Relation, truth
from ...stability.notion import Notion
from ...stability.report.analysis import analyze
from ...stability.report.report import Report
from ..scenes import Scene
from . import routes
from .sign_patterns import sign_pattern

K3 = symbol("k3")
Margins = Sequence[tuple[Expr, bool]]
DAMPED = "sufficient for stability under internal damping"
SPECTRAL = "necessary and sufficient for spectral stability"
CLAIMS = ("necessary for stability", "sufficient for stability", "sufficient for stability, Casimirs alone",
          DAMPED, SPECTRAL,
          "necessary and sufficient for stability", "sufficient for instability",
          "sufficient for stability on the boundary",
          "sufficient for instability on the boundary", "existence", "sufficient for periodic motion")


@dataclass(frozen=True)
class Claim:
    """A scene on the domain where a claim is made.

    Parameters
    ----------
    scene : Scene
    given : tuple of Expr
        positive where the claim is made
    at : mapping
        values inserted
    """

    scene: Scene
    given: tuple[Expr, ...]
    at: Mapping[Symbol, Expr]

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The equilibrium of the scene, its domain narrowed to what is given."""
        if (eq := self.scene.equilibrium) is None:
            raise PublishedError("a claim of stability or existence needs a scene with an equilibrium")
        return replace(eq, domain=(*eq.domain, *self.given))

    @cached_property
    def report(self) -> Report:
        """The analysis of the equilibrium."""
        return analyze(self.equilibrium)

    def domain(self, claim: str = "") -> tuple[Expr, ...]:
        """Return what is positive where the claim is made and, unless that is the claim, the point exists."""
        positive = (
            self.equilibrium.existence() if self.scene.equilibrium and claim != "existence" else self.given
        )
        return tuple(e.xreplace(self.at) for e in positive)

    def derived(self, claim: str) -> Criterion:
        """Return what the library derives for a claim, with the values inserted."""
        found = self._derived(claim)
        return replace(found, alternatives=tuple(tuple(replace(
            c, margin=c.margin.xreplace(self.at),
            degenerate=tuple(e.xreplace(self.at) for e in c.degenerate)) for c in alternative)
            for alternative in found.alternatives))

    def _derived(self, claim: str) -> Criterion:
        """Return what the library derives for a claim.

        Raises
        ------
        PublishedError
            the claim is none of those that can be checked
        """
        if claim in ("necessary for stability", SPECTRAL):
            return self.report.necessary
        if claim in ("sufficient for stability", "necessary and sufficient for stability"):
            return self.report.sufficient
        if claim == "sufficient for stability, Casimirs alone":
            return self.report.casimirs_only
        if claim == DAMPED:
            return self.report.damped
        if claim == "sufficient for instability":
            return Criterion(Notion.PRINTED, tuple((replace(c, margin=-c.margin, strict=True),)
                                                  for (a,) in [self.report.necessary.alternatives]
                                                  for c in a))
        if claim in ("sufficient for stability on the boundary",
                     "sufficient for instability on the boundary"):
            return self._first_rung(1 if claim == "sufficient for stability on the boundary" else -1)
        if claim == "existence":
            return criterion(claim, [(e, True) for e in self.scene.equilibrium.existence()]
                             if self.scene.equilibrium else [])
        if claim == "sufficient for periodic motion":
            return self._periodic()
        raise PublishedError(f"quantity = {claim!r}: a condition is {', '.join(CLAIMS)}")

    def _periodic(self) -> Criterion:
        """Return the limits of abs(M)² = L2 at an energy E; on the separatrix the period is infinite."""
        if self.scene.potential is not None or any(self.scene.body.gyrostatic_momentum):
            raise PublishedError("periodic motion is decided for a free rigid body: leave out potential "
                                 "and gyrostatic_momentum")
        E, L2 = symbol("E"), symbol("L2")
        low, middle, high = (L2 - 2 * E * moment for moment in self.scene.body.moments)
        return criterion("periodic", [(low, True), (-high, True), (middle**2, True)])

    def _first_rung(self, sign: int) -> Criterion:
        """Return the condition on the first coefficient beyond the boundary; sign 1 is for stability."""
        if self.report.boundary is None:
            raise PublishedError("a boundary is decided only for a body of revolution in U(k3)")
        rung = self.report.boundary.rung(3)
        if rung.escapes:
            raise PublishedError("at a tilt the first coefficient beyond the boundary decides against "
                                 "stability whatever its sign")
        return criterion("boundary", [(sign * rung.condition.margin, True)], self.equilibrium.at)

    def verdict(self) -> tuple[str, str]:
        """Return the verdict, undecided unless the whole domain has the same, and what decided it."""
        sufficient, necessary = (normal(self.derived(f"{kind} for stability"), self.domain())
                                 for kind in ("sufficient", "necessary"))
        stable = "stable" + (f", modulo the flow of {', '.join(map(str, m))}"
                             if (m := self.report.sufficient.modulo) else "")
        if () in sufficient:
            return stable, routes.HOLDS
        if not necessary:
            return "unstable", routes.FAILS
        sign = self._on_boundary() if not sufficient and () in necessary else None
        if sign is None:
            return self._at_numbers()
        return stable if sign > 0 else "unstable", routes.ON_BOUNDARY

    def _at_numbers(self) -> tuple[str, str]:
        """Return what the report decides, if `at` gives a number for every name that it requires."""
        numbers = {s.name: value for s, value in self.at.items() if value.is_number}
        if not numbers.keys() >= set(self.report.required):
            return "undecided", ""
        decision = self.report.verdict({name: value for name, value in numbers.items()
                                        if name in self.report.parameters})
        notion = f", {decision.notion} {decision.scope}" if decision.level else ""
        return decision.verdict.name.lower() + notion, f"decided at the numbers given: {decision.reason}"

    def _on_boundary(self) -> int | None:
        """Return the sign of the first coefficient that is not 0, or None if the domain has no single one.

        If all coefficients vanish, the sign is −1.
        """
        if self.report.boundary is None:
            return None
        for rung in islice(self.report.boundary.rungs(), 12):
            value = rung.condition.margin.xreplace(self.at)
            signs = Signs.over([value], self.domain())
            margin, even = signs.margin(value)
            if margin:
                if even:
                    return None
                return -1 if rung.escapes and signs.nonzero(margin) else signs.of(margin)
        return -1 if self.report.boundary.last else None


def criterion(source: str, margins: Margins, at: Expr = K3) -> Criterion:
    """Return comparisons as a criterion that is not yet in normal form."""
    return Criterion(Notion.PRINTED, (tuple(Condition(margin, strict, source, (), at)
                                            for margin, strict in margins),))


Normal = frozenset[tuple[Expr, bool, frozenset[Expr]]]


def normal(given: Criterion, domain: Iterable[Expr]) -> set[Normal | tuple[()]]:
    """Return the alternatives of a criterion, each as its independent conditions in normal form.

    The alternative () is always true.
    """
    domain = list(domain)
    conditions = [c for alternative in given.alternatives for c in alternative]
    signs = Signs.over([e for c in conditions for e in (c.margin, *c.degenerate)], domain)
    ring = signs.ring
    found: set[Normal | tuple[()]] = set()
    for alternative in given.alternatives:
        items = reduced([_item(c, signs) for c in alternative], signs)
        if items is not None:
            found.add(frozenset((ring.expression(i.margin), i.strict,
                                 frozenset(map(ring.expression, i.degenerate)))
                                for i in items) or ())
    return {()} if () in found else found


def _item(condition: Condition, signs: Signs) -> Item:
    margin, even = signs.margin(condition.margin)
    for factor in condition.degenerate:
        odd, more = signs.margin(factor)
        even = (*even, *more, *(() if odd.is_constant() and odd else (odd,)))
    return Item(margin, even, condition.strict, condition.source)


def agree(claim: str, printed: Criterion, derived: Criterion, domain: Iterable[Expr],
          strictness: bool = True) -> str:
    """Return how a printed condition was found to be the derived one; "" if it was not.

    If strictness is False, > and ≥ count as the same. A sufficient condition for instability may leave out
    the points at which an even factor vanishes.
    """
    domain = list(domain)
    even = claim != "sufficient for instability"

    def bare(side: Criterion) -> set[frozenset[tuple[Any, ...]]]:
        return {frozenset((margin, strict and strictness, degenerate if even and strictness else ())
                          for margin, strict, degenerate in a
                          if strictness or margin.free_symbols) for a in normal(side, domain)}

    theirs, ours = bare(printed), bare(derived)
    if theirs == ours:
        return routes.SAME_FORM
    patterns = [{sign_pattern(a) or a for a in side} for side in (theirs, ours)]
    return routes.SAME_SIGNS if patterns[0] == patterns[1] else ""


def free_symbols(given: Criterion) -> set[Symbol]:
    """Return all symbols of a criterion."""
    return {s for a in given.alternatives for c in a for e in (c.margin, *c.degenerate)
            for s in e.free_symbols}


def holds(given: Criterion, values: dict[Symbol, Expr]) -> bool:
    """Return whether a criterion holds at rational values."""
    def compare(expression: Expr, relation: Relation) -> bool:
        value = expression.xreplace(values)
        if relation in (operator.eq, operator.ne):
            return bool(relation(value, 0))
        # where it divides by zero or is not real it says nothing
        if not value.is_finite or not value.is_real:
            return False
        sign = sign_of_constant(value)
        return sign is not None and bool(relation(sign, 0))

    return truth(given, compare, all, any)
