"""Checks of printed claims: conditions for stability and existence, verdicts in words."""
from collections.abc import Iterator
from itertools import islice
from typing import Any

import mpmath
from sympy import Expr, Integer, Poly, Symbol

from ..conditions import Criterion
from ..errors import GyrostatError, PublishedError
from ..notation import symbol
from . import independent
from .criteria import K3, Claim, agree, criterion, free_symbols, holds
from .language import comparisons
from .sampling import K, on_family
from .statements import Counterexample, Outcome, Reading, named


def condition(r: Reading) -> Outcome:
    """The printed comparisons are the derived condition, in normal form."""
    s, quantity = r.statement, str(r.statement.quantity)
    if not isinstance(s.printed, str):
        raise PublishedError("a condition is one text: join its comparisons with and")
    derived = r.claim.derived(quantity)
    never = s.printed == "never"                           # a method that proves nothing
    margins = [] if never else [(r.finish(margin), strict) for margin, strict in comparisons(s.printed, r.own)]
    if quantity == "existence":                            # what is divided by is not zero
        bottoms = {f**2 for margin, _ in margins for f in [margin.as_numer_denom()[1]] if f.free_symbols}
        margins += [(f, True) for f in bottoms]
    at = r.scene.equilibrium.at if r.scene.equilibrium else K3
    printed = Criterion("formal", ()) if never else criterion("printed", margins, at)
    both = quantity == "necessary and sufficient for stability"
    claim = "sufficient for stability" if both else quantity
    if agree(claim, printed, derived, r.claim.domain(claim)):
        return _at_equality(r, "necessary for stability", printed, derived) if both else Outcome(True, printed, derived)
    if "stability" in claim and agree(claim, printed, derived, r.claim.domain(claim), strictness=False):
        return _at_equality(r, claim, printed, derived)
    found = _separatrix(printed) if claim == "sufficient for periodic motion" else _refuted(r, claim, printed, derived)
    return Outcome(False if found else None, printed, derived, None, found)


def _at_equality(r: Reading, claim: str, printed: Criterion, derived: Criterion) -> Outcome:
    """The print says more than is derived, at equality only: a point on the boundary refutes it, or nothing does."""
    wanted = -1 if claim.startswith("sufficient for stability") else 1     # an unstable point called stable, or the other way round
    for values in islice(_on_boundary(r, derived), 150):
        if wanted == -1 and holds(r.claim.report.sufficient, values):
            continue
        model = independent.Model(r.scene, values)
        if model.level_set() == wanted:
            said, truth = ("unstable", "stable") if wanted == 1 else ("stable", "unstable")
            why = "no point near it has the same energy and momenta (the square of dk3/dt would be negative): it is Lyapunov stable" \
                if wanted == 1 else "motions with the same energy and momenta leave it: it is unstable"
            both = r.statement.quantity == "necessary and sufficient for stability"
            shown = "sufficient as printed; necessary only with equality allowed" if both else derived
            example = Counterexample(named(values), said, truth, f"{why}, though the two sides are equal")
            return Outcome(False, printed, shown, None, example)
    return Outcome(True if wanted == -1 and _stable_at_equality(r, derived) else None, printed, derived)


def _stable_at_equality(r: Reading, derived: Criterion) -> bool:
    """Whether the boundary criterion proves stability on the whole boundary of a single condition."""
    if len(derived.alternatives) != 1 or len(derived.alternatives[0]) != 1:
        return False
    margin = derived.alternatives[0][0].margin
    for s in sorted(margin.free_symbols, key=str):
        slope = margin.diff(s)
        if not slope.has(s) and s not in K and all(e.is_positive for e in slope.free_symbols):
            on = {s: (s - margin / slope).expand()}
            given = tuple(e.xreplace(on) for e in r.claim.given) + ((on[s],) if s.is_positive else ())
            return Claim(r.scene, given, {**r.at, **on}).verdict() == "stable"
    return False


def _on_boundary(r: Reading, derived: Criterion) -> Iterator[dict[Symbol, Expr]]:
    """Points where a margin is 0, found along a name in which it is affine; the curvature of an unspecified U is drawn too."""
    for alternative in derived.alternatives:
        for condition in alternative:
            yield from _at_rest(r, condition.margin)
            for values in r.points([condition.margin, *([symbol("d2U")] if condition.margin.has(symbol("dU")) else [])]):
                for s in sorted(condition.margin.free_symbols, key=str):
                    slope = condition.margin.diff(s)
                    if slope.subs(values) and not slope.has(s) and s not in K:
                        on = values | {s: (s - condition.margin / slope).subs(values)}
                        if all(e.subs(on) > 0 for e in (*r.given, *(x for x in on if x.is_positive))):
                            yield on | _flat(r, on)
                            yield from _next(r, on)
                            yield from _double(r, condition.margin, s, on)


def _at_rest(r: Reading, margin: Expr) -> Iterator[dict[Symbol, Expr]]:
    """Points of the boundary without momentum along the vertical, where both sides vanish."""
    still = {symbol(name): Integer(0) for name in ("l", "pi3_0", "omega3_0")}
    for values in islice(r.points([margin]), 5):
        on = values | {s: x for s, x in still.items() if s in values}
        for s in sorted(margin.free_symbols - still.keys(), key=str):
            left = margin.subs({x: v for x, v in on.items() if x != s})
            slope = left.diff(s)
            if slope and not slope.has(s) and s not in K:
                there = on | {s: s - left / slope}
                there[s] = there[s].expand()
                if all(e.subs(there) > 0 for e in (*r.given, *(x for x in there if x.is_positive))):
                    yield there


def _next(r: Reading, on: dict[Symbol, Expr]) -> Iterator[dict[Symbol, Expr]]:
    """At E1 and E2 of an unspecified U, a third derivative of either sign: it decides where the first two do not."""
    d2U, d3U = symbol("d2U"), symbol("d3U")
    if d2U in on and r.scene.equilibrium and r.scene.equilibrium.label in ("E1", "E2"):
        yield from (on | {d3U: s * (2 * abs(on[d2U]) + 1)} for s in (1, -1))


def _double(r: Reading, margin: Expr, s: Symbol, on: dict[Symbol, Expr]) -> Iterator[dict[Symbol, Expr]]:
    """Points of the boundary where the necessary condition is at equality too, if it is a square along the boundary."""
    if s != symbol("dU"):
        return
    solved = s - margin / margin.diff(s)
    for condition in (c for a in r.claim.report.necessary.alternatives for c in a):
        for t in sorted(condition.margin.free_symbols - {s}, key=str):
            along = condition.margin.subs(s, solved).subs({x: v for x, v in on.items() if x not in (s, t)})
            coefficients = Poly(along, t).all_coeffs() if not t.is_positive and along.is_polynomial(t) else []
            if len(coefficients) == 3 and coefficients[1] ** 2 == 4 * coefficients[0] * coefficients[2]:
                there = on | {t: -coefficients[1] / (2 * coefficients[0])}
                yield there | {s: solved.subs(there)}


def _flat(r: Reading, on: dict[Symbol, Expr]) -> dict[Symbol, Expr]:
    """At a tilt, the third derivative of U for which that of g vanishes too, so that the fourth decides."""
    dU, d2U, d3U, k3 = map(symbol, ("dU", "d2U", "d3U", "k3"))
    if not r.scene.equilibrium or r.scene.equilibrium.label != "E3" or not {d2U, k3} <= on.keys():
        return {}
    return {d3U: (6 * on[k3] * on[d2U] + 6 * r.finish(dU).subs(on)) / (1 - on[k3] ** 2)}


def _refuted(r: Reading, claim: str, printed: Criterion, derived: Criterion) -> Counterexample | None:
    """A point where the printed condition says something else than is true."""
    symbols = free_symbols(printed) | free_symbols(derived)
    fallback = None
    for values in r.points(symbols) if claim != "existence" else _anywhere(r, symbols):
        said, true = holds(printed, values), holds(derived, values)
        refutes = claim == "existence" or said == claim.startswith("sufficient")
        if said != true and (refutes or fallback is None) and (found := _confirmed(r, claim, said, values)):
            if refutes:
                return found
            fallback = found
    return fallback


def _anywhere(r: Reading, symbols: set[Symbol]) -> Iterator[dict[Symbol, Expr]]:
    """Points with special values too: existence may fail where a parameter is 0, or where |k| is not 1."""
    for values in r.points(symbols):
        for s in sorted(symbols, key=str):
            yield on_family(r.scene, values | {s: Integer(2 if s in K else s.is_positive or 0)})
        yield values


def _confirmed(r: Reading, claim: str, said: bool, values: dict[Symbol, Expr]) -> Counterexample | None:
    says, truth = ("holds", "fails") if said else ("fails", "holds")
    try:
        model = independent.Model(r.scene, values)
    except GyrostatError:
        return None
    if claim == "existence":
        unit = r.scene.potential is None or sum(x**2 for x in model.point[3:]) == 1
        why = f"the field of Newton and Euler vanishes there, at {model.point}" if unit else f"there is no such direction, k3 = {model.k3}"
        return Counterexample(named(values), says, truth, why)
    growth, level = model.growth(), model.level_set()
    if growth < mpmath.mpf(10) ** -20 and level != 1:
        return None
    why = "the level set of all integrals there is the orbit of the point alone: Lyapunov stable, modulo the spin" if level == 1 else \
        f"an eigenvalue of the differenced field has the real part {_short_float(growth)}: unstable"
    return Counterexample(named(values), says, truth, why)


def _short_float(value: Any) -> str:
    return str(mpmath.nstr(value, 15))


def _separatrix(printed: Criterion) -> Counterexample | None:
    """Motion on L2 = 2 E I2: (a sech, tanh, c sech)(μt), which Euler's equations are checked to have, is not periodic."""
    I1, I2, I3 = values = [Integer(n) for n in (1, 2, 3)]
    chosen = dict(zip(map(symbol, ("I1", "I2", "I3", "E", "L2")), (*values, 1 / (2 * I2), Integer(1))))
    mp = mpmath
    with mp.workdps(independent.DIGITS):
        low, high, whole = (mp.mpf(1) / int(a) - mp.mpf(1) / int(b) for a, b in ((I1, I2), (I2, I3), (I1, I3)))
        a, c, mu = mp.sqrt(high / whole), mp.sqrt(low / whole), mp.sqrt(low * high)

        def M(t: Any) -> list[Any]:
            return [a * mp.sech(mu * t), mp.tanh(mu * t), c * mp.sech(mu * t)]

        worst = 0
        for t in (mp.mpf("0.3"), mp.mpf(1), mp.mpf(-2)):
            x = M(t)
            rates = [x[1] * x[2] * (1 / mp.mpf(3) - 1 / mp.mpf(2)), x[2] * x[0] * (1 - 1 / mp.mpf(3)), x[0] * x[1] * (1 / mp.mpf(2) - 1)]
            worst = max(worst, *(abs(mp.diff(lambda s, i=i: M(s)[i], t) - rate) for i, rate in enumerate(rates)))
    if worst > 1e-20:
        raise PublishedError(f"the separatrix does not satisfy Euler's equations: residual {worst}")
    if not holds(printed, chosen):
        return None                                        # it leaves the separatrix out
    return Counterexample(named(chosen), "periodic", "not periodic", "on the separatrix M2 = tanh(√((1/I1 − 1/I2)(1/I2 − 1/I3)) t) "
                          "satisfies Euler's equations (residual below 1e-20) and grows for ever")


def statement(r: Reading) -> Outcome:
    """A claim in words: a verdict, a signature, or nothing that can be checked."""
    s = r.statement
    if not s.quantity:
        return Outcome(None, s.printed)
    if s.quantity == "stability":
        if s.printed not in ("stable", "orbitally stable", "unstable"):
            raise PublishedError(f"printed = {s.printed!r}: a verdict is stable, orbitally stable (modulo the spin), or unstable")
        verdict = r.claim.verdict()
        if verdict == s.printed or s.printed == "orbitally stable" and verdict.startswith("stable"):
            return Outcome(True, s.printed, verdict)
        criteria = r.claim.report.necessary, r.claim.report.sufficient
        for values in islice(r.points({s for c in criteria for s in free_symbols(c)}), 40):
            model = independent.Model(r.scene, values)
            growth, level = model.growth(), model.level_set()
            if growth > 1e-20 or level:
                truth = "unstable" if growth > 1e-20 or level == -1 else "stable"
                why = f"an eigenvalue of the differenced field has the real part {_short_float(growth)}" if growth > 1e-20 else \
                    "the level set of all integrals there is the point alone" if level == 1 else "motions with the same energy and " \
                    "momenta, or with momenta as near as one likes, leave it"
                if truth != s.printed.removeprefix("orbitally ") and (verdict.startswith(truth) or verdict == "undecided"):
                    return Outcome(False, s.printed, verdict, None, Counterexample(named(values), s.printed, truth, why))
        return Outcome(None, s.printed, verdict)
    if s.quantity == "second variation, Casimirs alone":
        if s.printed != "semidefinite" or r.scene.potential is None:
            raise PublishedError(f"printed = {s.printed!r}: in a field, the form is called semidefinite or it is not a statement")
        if r.scene.equilibrium is None:
            raise PublishedError("the second variation needs a scene with an equilibrium")
        for values in islice(r.points([symbol("d2U")]), 40):
            plus, zero, minus = independent.Model(r.scene, values).inertia_of_second_variation()
            if plus and minus:
                return Outcome(False, s.printed, "indefinite", None, Counterexample(
                    named(values), s.printed, f"{plus} positive, {zero} zero and {minus} negative squares",
                    "counted exactly on the tangent space of the orbit, from D²(h + ν·C) at these numbers"))
        return Outcome(None, s.printed)
    raise PublishedError(f"quantity = {s.quantity!r}: a statement is about stability, second variation, Casimirs alone, or is left empty")
