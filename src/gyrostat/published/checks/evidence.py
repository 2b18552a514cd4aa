"""Decides what is shown against a printed claim: numbers at which it fails as it is read.

No other module makes a Counterexample.
"""
from itertools import islice

from sympy import Expr

from ...algebra.reals.exact import sign_of_constant
from ...errors import ExpressionError, GyrostatError
from ..independent.counterexample import Values
from ..statements import Counterexample, Doubt, Outcome
from .both_sides import decimal_at, formula_at, rest_at
from .comparisons import holds_as_printed
from .counts import count_at
from .readings import Reading
from .sampling import is_a_body, on_family
from .truth_at_point import condition_at, model_at, verdict_at

MOST = 80                                                  # points that are looked at
NEITHER = "it differs from what is derived, and at no point that was tried is the claim seen to fail"


def decided(r: Reading, doubt: Doubt) -> Outcome:
    """Return the first point at which the claim fails, else one that it leaves out, else none.

    Raises
    ------
    PublishedError
        the library and Newton and Euler's equations disagree at a point
    """
    look = {"condition": condition_at, "statement": verdict_at, "number": decimal_at, "count": count_at,
            "equilibrium": rest_at}.get(r.statement.kind, formula_at)
    weaker = None
    for values in islice(doubt.points, MOST):
        try:
            seen = look(r, values, doubt) if is_of_the_scene(r, values) else None
        # not defined there, as the root of a negative number
        except ExpressionError:
            seen = None
        if seen is None:
            continue
        shown = Counterexample(named(values), seen.printed, seen.derived, seen.why)
        if seen.refutes:
            return Outcome(False, doubt.printed, doubt.derived, doubt.difference, shown)
        weaker = weaker or shown
    if weaker:
        return Outcome(False, doubt.printed, doubt.derived, doubt.difference, not_sharp=weaker)
    return Outcome(None, doubt.printed, doubt.derived, doubt.difference, remark=NEITHER)


def named(values: Values) -> tuple[tuple[str, Expr], ...]:
    """Return values by name, in order."""
    return tuple(sorted(((s.name, v) for s, v in values.items()), key=lambda pair: pair[0]))


def is_of_the_scene(r: Reading, values: Values) -> bool:
    """Return whether numbers are a point of the scene at which the claim is made.

    The body has to be possible, the point has to lie on the family, and what is given has to hold.
    """
    scene, claims_existence = r.scene, r.statement.quantity == "existence"
    # others are the source's own
    drawn = {s for e in scene.body.positive for s in e.free_symbols} - r.at.keys()
    if (
        any(not v.is_number or v.is_real is False or not v.is_finite for v in values.values())
        or drawn
        and not is_a_body(scene, values)
    ):
        return False
    positive = [*(s for s in values if s.is_positive), *scene.body.positive]
    if scene.equilibrium and not claims_existence:
        positive += scene.equilibrium.existence()
    if any(sign_of_constant(e.xreplace(dict(values))) != 1
           for e in positive if e.xreplace(dict(values)).is_number):
        return False
    if scene.equilibrium and not claims_existence and not ((model := model_at(r, values))
                                                           and model.has_a_unit_k()):
        return False
    if any(v.is_number and sign_of_constant(v - values[s]) != 0
           for s, v in on_family(scene, dict(values)).items() if s in values):
        return False
    try:
        names = r.without_let(values)
    except GyrostatError:                                  # no equilibrium there
        return False
    if any(text and holds_as_printed(text, names)[0] is not True
           for text in (scene.table.get("given"), r.statement.given)):
        return False
    stale = [s for s, v in values.items() if s.name in names and isinstance(names[s.name], Expr)
             and names[s.name].is_number and abs((names[s.name] - v).evalf(30)) > 1e-25 * (1 + abs(v))]
    return not stale and all(abs((values[s] - v.subs(dict(values))).evalf(30)) < 1e-25
                             for s, v in r.at.items() if s in values)
