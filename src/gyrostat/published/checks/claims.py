"""Checks printed claims: conditions for stability and existence, and verdicts in words."""
from itertools import islice

from ...errors import PublishedError, brief
from ...notation import symbol
from ...stability.criteria.conditions import Criterion
from ...stability.notion import Notion
from ..statements import Doubt, Outcome
from . import routes
from .comparisons import NEVER, comparisons
from .criteria import DAMPED, K3, Claim, agree, criterion, free_symbols
from .failing_points import suspects
from .readings import Reading
from .sampling import K

AT_EQUALITY = "it is sufficient as printed; it is necessary only if equality is allowed"
NOT_NECESSARY = "it is sufficient as printed, but not necessary: gyroscopic forces stabilise other rotations"


def condition(r: Reading) -> Outcome | Doubt:
    """Check that the printed comparisons are the derived condition, both in normal form."""
    s, quantity = r.statement, str(r.statement.quantity)
    if not isinstance(s.printed, str):
        raise PublishedError("a condition is one text: join its comparisons with and")
    derived = r.claim.derived(quantity)
    never = s.printed == NEVER                             # a method that proves nothing
    margins = [] if never else [(r.finish(margin), strict)
                                for margin, strict in comparisons(s.printed, r.own)]
    if quantity == "existence":                            # what is divided by is not zero
        bottoms = [f**2 for margin, _ in margins for f in [margin.as_numer_denom()[1]] if f.free_symbols]
        margins += [(f, True) for f in dict.fromkeys(bottoms)]
    at = r.scene.equilibrium.at if r.scene.equilibrium else K3
    printed = Criterion(Notion.FORMAL, ()) if never else criterion("printed", margins, at)
    both = quantity == "necessary and sufficient for stability"
    claim = "sufficient for stability" if both else quantity
    same = agree(claim, printed, derived, r.claim.domain(claim))
    if same and not both:
        return Outcome(True, printed, derived, route=routes.of_condition(quantity, same))
    alike = same or "stability" in claim and agree(claim, printed, derived, r.claim.domain(claim),
                                                   strictness=False)
    if (
        alike
        and not same
        and claim.startswith("sufficient for stability") and claim != DAMPED
        and _stable_at_equality(r, derived)
    ):
        return Outcome(True, printed, derived, route=routes.of_condition(quantity, routes.AT_EQUALITY))
    points = suspects(r, printed, derived, bool(alike))
    if not same:
        return Doubt(points, printed, derived)
    necessary = r.claim.derived("necessary for stability")
    closed = agree(claim, printed, necessary, r.claim.domain(claim), strictness=False)
    return Doubt(points, printed, AT_EQUALITY if closed else NOT_NECESSARY)


def _stable_at_equality(r: Reading, derived: Criterion) -> bool:
    """Return whether the boundary criterion proves stability on the whole boundary of one condition."""
    if len(derived.alternatives) != 1 or len(derived.alternatives[0]) != 1:
        return False
    margin = derived.alternatives[0][0].margin
    for s in sorted(margin.free_symbols, key=str):
        slope = margin.diff(s)
        # the whole boundary, also where a difference of masses is 0
        if not slope.has(s) and s not in K and slope.is_nonzero:
            on = {s: (s - margin / slope).expand()}
            given = tuple(e.xreplace(on) for e in r.claim.given) + ((on[s],) if s.is_positive else ())
            return Claim(r.scene, given, {**r.at, **on}).verdict()[0] == "stable"
    return False


def statement(r: Reading) -> Outcome | Doubt:
    """Check a claim in words: a verdict or a signature; an empty quantity cannot be checked."""
    s = r.statement
    if not s.quantity:
        return Outcome(None, s.printed)
    if s.quantity == "stability":
        if s.printed not in ("stable", "orbitally stable", "unstable"):
            raise PublishedError(f"printed = {brief(s.printed)}: a verdict is stable, orbitally stable "
                                 "(modulo the spin), or unstable")
        verdict, route = r.claim.verdict()
        if verdict == s.printed or s.printed == "orbitally stable" and verdict.startswith("stable"):
            return Outcome(True, s.printed, verdict, route=route)
        criteria = r.claim.report.necessary, r.claim.report.sufficient
        return Doubt(islice(r.points({s for c in criteria for s in free_symbols(c)}), 40), s.printed, verdict)
    if s.quantity == "second variation, Casimirs alone":
        if s.printed != "semidefinite" or r.scene.potential is None:
            raise PublishedError(f"printed = {brief(s.printed)}: the only word that is "
                                 "checked is semidefinite, for a body in a field")
        if r.scene.equilibrium is None:
            raise PublishedError("the second variation needs a scene with an equilibrium")
        return Doubt(islice(r.points([symbol("d2U")]), 40), s.printed, "indefinite")
    raise PublishedError(f"quantity = {s.quantity!r}: a statement is about 'stability' or 'second "
                         "variation, Casimirs alone', or its quantity is ''")
