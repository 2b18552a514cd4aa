"""What may be shown against a printed claim.

Numbers at which it fails as it is read. Nothing else makes a Counterexample.
"""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

from sympy import Expr, MatrixBase, Symbol

from ..algebra.exact import sign_of_constant
from ..errors import ExpressionError, GyrostatError, PublishedError
from ..notation import symbol
from . import independent
from .independent_names import number
from .language import decimal, holds_as_printed
from .sampling import is_a_body, on_family
from .statements import Counterexample, Doubt, Outcome, Reading

Values = Mapping[Symbol, Expr]
MOST = 80                                                  # points that are looked at
NEITHER = "it differs from what is derived, and at no point that was tried is the claim seen to fail"


@dataclass(frozen=True)
class Seen:
    """What a claim says at a point, what is true there, why, and whether the claim fails there or only leaves
    the point out.
    """

    printed: Any
    derived: Any
    why: str
    refutes: bool


def decided(r: Reading, doubt: Doubt) -> Outcome:
    """The first point at which the claim fails; else one that it leaves out; else nothing is shown.

    Raises
    ------
    PublishedError
        the library and Newton and Euler's equations disagree at a point
    """
    look = {"condition": _condition, "statement": _words, "number": _rounded,
            "equilibrium": _at_rest}.get(r.statement.kind, _formula)
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
    """Values by name, in order."""
    return tuple(sorted(((s.name, v) for s, v in values.items()), key=lambda pair: pair[0]))


def is_of_the_scene(r: Reading, values: Values) -> bool:
    """Whether numbers are a point of the scene at which the claim is made.

    Of a body, on the family, where what is given holds.
    """
    scene, claims_existence = r.scene, r.statement.quantity == "existence"
    # others are the source's own
    drawn = {s for moment in scene.body.inertia for s in moment.free_symbols} - r.at.keys()
    if (
        any(not v.is_number or v.is_real is False or not v.is_finite for v in values.values())
        or drawn
        and not is_a_body(scene, values)
    ):
        return False
    positive = [*(s for s in values if s.is_positive), *scene.body.inertia]
    if scene.equilibrium and not claims_existence:
        positive += scene.equilibrium.existence()
    if any(sign_of_constant(e.xreplace(dict(values))) != 1
           for e in positive if e.xreplace(dict(values)).is_number):
        return False
    if scene.equilibrium and not claims_existence and not ((model := _model(r, values))
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


def _condition(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """A printed condition as it is read, against what is proved of the point."""
    claim, model = str(r.statement.quantity), _model(r, values)
    if model is None:
        return None
    says, equal = (
        (False, False)
        if r.statement.printed == "never"
        else holds_as_printed(r.statement.printed, r.independent(values))
    )
    truth, why = _truth(r, claim, model, values)
    if None in (says, truth) or says == truth:
        return None
    either = claim in ("existence", "necessary and sufficient for stability")
    note = ", though two of the sides printed are equal" if equal else ""
    return Seen("holds" if says else "fails", _word(claim, bool(truth)), why + note,
                either or says == claim.startswith("sufficient"))


def _word(claim: str, truth: bool) -> str:
    """What is true, in the words of the claim."""
    if claim.endswith("Casimirs alone"):
        return "definite" if truth else "not definite"
    if claim in ("existence", "sufficient for periodic motion"):
        return ("" if truth else "not ") + ("an equilibrium" if claim == "existence" else "periodic")
    return "stable" if truth == ("instability" not in claim) else "unstable"


def _model(r: Reading, values: Values) -> independent.Model | None:
    try:
        return independent.Model(r.scene, values)
    except GyrostatError:
        return None


def _truth(r: Reading, claim: str, model: independent.Model, values: Values) -> tuple[bool | None, str]:
    """Whether what a condition is claimed for is true at a point; None where neither is proved."""
    if claim == "existence":
        return _exists(r, model)
    if claim == "sufficient for periodic motion":
        return _periodic(r, values)
    if claim.endswith("Casimirs alone"):
        definite = model.is_definite()
        return (
            definite,
            "the squares of D²(h + ν·C) on the tangent space of the orbit, counted exactly, are "
            + ("of one sign" if definite else "not of one sign"),
        )
    if claim.endswith("on the boundary") and not model.is_on_boundary():
        return None, ""
    sign, why = model.stability()
    return None if not sign else (sign == 1) == ("instability" not in claim), why


def _exists(r: Reading, model: independent.Model) -> tuple[bool | None, str]:
    """An equilibrium has a direction; its field vanishes, or there is no model."""
    if r.scene.equilibrium is None:
        return True, "what is given holds there"
    if len(model.point) == 6 and sign_of_constant(1 - model.k3**2) == -1:
        return False, f"there is no such direction, k3 = {model.k3}"
    if len(model.point) == 6 and sum(x**2 for x in model.point[3:]) != 1:
        return None, ""
    return True, f"the field of Newton and Euler vanishes there, at {model.point}"


def _periodic(r: Reading, values: Values) -> tuple[bool | None, str]:
    moments, E, L2 = [m.subs(dict(values))
                      for m in r.scene.body.inertia], values[symbol("E")], values[symbol("L2")]
    if moments != [1, 2, 3] or L2 != 1 or 4 * E != 1:
        return None, ""
    if (worst := independent.separatrix_residual()) > 1e-20:
        raise PublishedError(f"the separatrix does not satisfy Euler's equations: residual {worst}")
    return False, ("on the separatrix M2 = tanh(√((1/I1 − 1/I2)(1/I2 − 1/I3)) t) satisfies Euler's "
                   "equations (residual below 1e-20) and "
                   "grows for ever")


def _words(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """A verdict in words, or the signature of a form."""
    model = _model(r, values)
    if model is None:
        return None
    if r.statement.quantity == "stability":
        sign, why = model.stability()
        if not sign or (sign == 1) == (r.statement.printed != "unstable"):
            return None
        return Seen(r.statement.printed, "stable" if sign == 1 else "unstable", why, True)
    plus, zero, minus = model.inertia_of_second_variation()
    if not plus or not minus:
        return None
    return Seen(r.statement.printed, f"{plus} positive, {zero} zero and {minus} negative squares",
                "counted exactly on the tangent space of the orbit, from D²(h + ν·C) at these numbers", True)


def _formula(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Both sides at the point.

    As the library has them, and again from Newton and Euler's equations, or three turns.
    """
    if r.statement.kind == "solution":
        return _solution(r, values, doubt)
    sides = tuple(e.subs(dict(values)) for e in doubt.sides)
    quantity = number(_entry(r.independently(r.statement.quantity, values), doubt.place), r.scene, values)
    if sides[0].evalf(20).is_real is False:
        # the grammar refuses to read what is not real
        return _compared(r, values, sides, (sides[0], quantity), doubt.place)
    printed = number(_entry(r.independently(r.statement.printed, values), doubt.place), r.scene, values)
    return _compared(r, values, sides, (printed, quantity), doubt.place)


def _solution(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """The slope that is printed, against the rate along the motion.

    Or a start that no choice of the constants reaches.
    """
    quantity = list(map(str, r.statement.quantity))
    if doubt.place is None:
        for name, f, side in zip(quantity, doubt.printed.subs(symbol("t"), 0), doubt.sides):
            if f.is_number and sign_of_constant(side.subs(dict(values)) - f) in (1, -1):
                return Seen(f, side.subs(dict(values)),
                            f"{name} may start there; the printed functions start it at {f} for every choice "
                            f"of {', '.join(r.statement.constants)}", True)
        return None
    for f in (f.subs(dict(values)) for f in doubt.printed):
        if f.evalf(20).is_real is False:
            return Seen("not real", "a real number", f"the printed value there is {f.evalf(8)}", True)
    moving = {**values, **{x: f.subs(dict(values)) for x, f in doubt.moving.items()}}
    p, d = (e.subs(dict(values)) for e in doubt.sides)
    rate = number(r.independently(f"dt({quantity[doubt.place[0]]})", moving), r.scene, moving)
    return _compared(r, values, (p, d), [p, rate], doubt.place)


def _entry(value: Any, place: Any) -> Any:
    return value[place] if isinstance(value, MatrixBase) else value


def _compared(r: Reading, values: Values, library: Sequence[Expr], again: Sequence[Any],
              place: Any) -> Seen | None:
    """Both sides from both routes: these must agree, and the sides must not."""
    (p, d), (x, y) = library, again
    for one, other in ((d, y), (p, x)):
        if (
            not isinstance(other, Expr)
            or other.free_symbols
            or not abs((other - one).evalf(25)) <= 1e-18 * max(1, abs(one.evalf(25)))
        ):
            raise PublishedError(f"computed independently it is {other} at {dict(values)}, by the library "
                                 f"{one}")
    sides = x.evalf(30), y.evalf(30)
    if sides[1].is_real is not True or abs(sides[0] - sides[1]) <= 1e-20:
        return None
    by = "three turns of the body" if "angles" in r.scene.table else "Newton and Euler's equations"
    columns = (
        len(r.statement.printed[0])
        if isinstance(r.statement.printed, list) and isinstance(r.statement.printed[0], list)
        else 1
    )
    which = f"entry {', '.join(str(i + 1) for i in place[:2 if columns > 1 else 1])}: " if place else ""
    if sides[0].is_real is not True:
        return Seen("not real", d,
                    f"{which}the printed value there is {p.evalf(8)}, by {by} it is {_short(y)}", True)
    return Seen(p, d, f"{which}by {by} at these numbers {_short(y)}", True)


def _short(value: Expr) -> str:
    return str(value) if value.is_Rational else str(value.evalf(20))


def _rounded(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """A printed decimal, against the number that Newton and Euler's equations give."""
    printed, half = decimal(str(r.statement.printed))
    value = number(r.independently(r.statement.quantity, values), r.scene, values)
    if abs((value - doubt.derived).evalf(25)) > 1e-18 * max(1, abs(doubt.derived.evalf(25))):
        raise PublishedError(f"computed independently it is {value}, by the library {doubt.derived}")
    if abs((value - printed).evalf(30)) <= half:
        return None
    return Seen(printed, doubt.derived, f"by Newton and Euler's equations at these numbers {_short(value)}",
                True)


def _at_rest(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """A printed point, at which a rate does not vanish."""
    model = independent.Model(r.scene, values)
    at = dict(zip(model.coordinates, r.independently(r.statement.printed, values)))
    name, rate = model.coordinates[doubt.place[0]], model.field.subs(at)[doubt.place[0]]
    if sign_of_constant(rate - doubt.sides[0].subs(dict(values))) != 0:
        raise PublishedError(f"Newton and Euler's equations give the rate {rate}, the library "
                             f"{doubt.sides[0].subs(dict(values))}")
    if sign_of_constant(rate) in (0, None):
        return None
    why = f"by Newton and Euler's equations the rate of {name} there is {rate}, not 0"
    return Seen("an equilibrium", f"d{name}/dt = {rate}", why, True)
