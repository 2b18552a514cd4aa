"""Checks of printed claims: conditions for stability and existence, verdicts in words."""
from collections.abc import Iterator
from typing import Any

import mpmath
from sympy import Expr, Integer, Symbol

from ..conditions import Criterion
from ..errors import GyrostatError, PublishedError
from ..notation import symbol
from . import independent
from .criteria import agree, free_symbols, holds, normal, printed_criterion
from .language import comparisons
from .sampling import K
from .statements import Counterexample, Outcome, Reading, named


def condition(r: Reading) -> Outcome:
    """The printed comparisons are the derived condition, in normal form."""
    s, quantity = r.statement, str(r.statement.quantity)
    derived = r.claim.derived(quantity)
    if s.printed == "never":                               # a method that proves nothing
        return Outcome(not normal(derived, r.claim.domain), s.printed, derived)
    margins = [(r.finish(margin), strict) for margin, strict in comparisons(s.printed, r.own)]
    if quantity == "existence":                            # what is divided by is not zero
        bottoms = {f**2 for margin, _ in margins for f in [margin.as_numer_denom()[1]] if f.free_symbols}
        margins += [(f, True) for f in bottoms]
    printed = printed_criterion(margins, r.scene.equilibrium.at if r.scene.equilibrium else symbol("k3"))
    if quantity == "necessary and sufficient for stability":
        return _necessary_and_sufficient(r, printed)
    if agree(quantity, printed, derived, r.claim.domain):
        return Outcome(True, printed, derived)
    return Outcome(False, printed, derived, None, _refuted(r, quantity, printed, derived))


def _necessary_and_sufficient(r: Reading, printed: Criterion) -> Outcome:
    """Sufficient as printed; necessary unless a point on the boundary is stable too."""
    derived, domain = r.claim.report.sufficient, r.claim.domain
    if not agree("sufficient for stability", printed, derived, domain):
        return Outcome(False, printed, derived, None, _refuted(r, "sufficient for stability", printed, derived))
    for values in _on_boundary(r, derived):
        model = independent.Model(r.scene, values)
        if model.isolated():
            return Outcome(False, printed, derived, None, Counterexample(
                named(values), "unstable", "stable",
                "the energy, momenta and k of the point are shared by no other point near it (g(k3) < 0 around it): it is Lyapunov stable, "
                f"though equality holds; growth rate of the linearised field {_short_float(model.growth())}"))
    return Outcome(None, printed, derived)


def _on_boundary(r: Reading, criterion: Criterion) -> Iterator[dict[Symbol, Expr]]:
    ((condition,),) = criterion.alternatives
    margin = condition.margin.subs(symbol("dU"), r.finish(symbol("dU")))
    for values in r.points([margin]):
        for s in sorted(margin.free_symbols, key=str):
            slope = margin.diff(s)
            if slope and not slope.has(s):
                on = values | {s: (s - margin / slope).subs(values)}
                if all(e.subs(on) > 0 for e in (*r.given, *(x for x in on if x.is_positive))):
                    yield on


def _refuted(r: Reading, claim: str, printed: Criterion, derived: Criterion) -> Counterexample:
    """A point where the printed condition says something else than is true."""
    if claim == "sufficient for periodic motion":
        return _separatrix(r, printed)
    symbols = list(free_symbols(printed) | free_symbols(derived))
    fallback = None
    for values in r.points(symbols) if claim != "existence" else _anywhere(r, symbols):
        said, true = holds(printed, values), holds(derived, values)
        if said == true:
            continue
        found = _confirmed(r, claim, said, values)
        refutes = said if claim.startswith("sufficient") else not said
        if found and (refutes or claim == "existence"):
            return found
        fallback = fallback or found
    if fallback is None:
        raise PublishedError(f"{r.statement.key}: the printed condition is not {derived}, but agrees with it at every point that was tried")
    return fallback


def _anywhere(r: Reading, symbols: list[Expr]) -> Iterator[dict[Symbol, Expr]]:
    """Points with special values too: existence may fail where a parameter is 0."""
    for values in r.points(symbols):
        for s in symbols:
            yield values | {s: Integer(0)} if not s.is_positive and s not in K else values


def _confirmed(r: Reading, claim: str, said: bool, values: dict[Symbol, Expr]) -> Counterexample | None:
    says, word = ("holds", "fails") if said else ("fails", "holds")
    try:
        model = independent.Model(r.scene, values)
    except GyrostatError:
        return None
    if claim == "existence":
        unit = not model.U or sum(x**2 for x in model.point[3:]) == 1
        why = f"the field of Newton and Euler vanishes there, at {model.point}" if unit else "there is no such direction, |k| > 1"
        return Counterexample(named(values), f"the printed condition {says}", f"the derived one {word}", why)
    growth = model.growth()
    unstable = growth > mpmath.mpf(10) ** -20
    if not unstable and not model.isolated():
        return None
    why = f"an eigenvalue of the differenced field has the real part {_short_float(growth)}: unstable" if unstable else \
        "the level set of all integrals there is the orbit of the point alone: Lyapunov stable, modulo the spin"
    return Counterexample(named(values), f"the printed condition {says}", f"the derived one {word}", why)


def _short_float(value: Any) -> str:
    return str(mpmath.nstr(value, 15))


def _separatrix(r: Reading, printed: Criterion) -> Counterexample:
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
        raise PublishedError("the printed condition does not admit the separatrix: no counterexample is known")
    return Counterexample(named(chosen), "periodic", "not periodic", "on the separatrix M2 = tanh(√((1/I1 − 1/I2)(1/I2 − 1/I3)) t) "
                          "satisfies Euler's equations (residual below 1e-20) and grows for ever")


def statement(r: Reading) -> Outcome:
    """A claim in words: a verdict, a signature, or nothing that can be checked."""
    s = r.statement
    if not s.quantity:
        return Outcome(None, s.printed)
    if s.quantity == "stability":
        verdict = r.claim.verdict()
        if verdict == s.printed:
            return Outcome(True, s.printed, verdict)
        criteria = r.claim.report.necessary, r.claim.report.sufficient
        for values in r.points({s for c in criteria for s in free_symbols(c)}):
            model = independent.Model(r.scene, values)
            growth = model.growth()
            if growth > 1e-20 or model.isolated():
                truth = "unstable" if growth > 1e-20 else "stable"
                why = f"an eigenvalue of the differenced field has the real part {_short_float(growth)}" if growth > 1e-20 else \
                    "the level set of all integrals there is the point alone"
                if truth == verdict or verdict == "undecided" and truth != s.printed:
                    return Outcome(False, s.printed, verdict, None, Counterexample(named(values), s.printed, truth, why))
        raise PublishedError(f"{s.key}: the verdict {verdict} is not confirmed at any point that was tried")
    if s.quantity == "second variation, Casimirs alone":
        for values in r.points([symbol("d2U")]):
            plus, zero, minus = independent.Model(r.scene, values).inertia_of_second_variation()
            if (s.printed == "semidefinite") == bool(plus and minus):
                return Outcome(False, s.printed, "indefinite" if plus and minus else "semidefinite", None, Counterexample(
                    named(values), s.printed, f"{plus} positive, {zero} zero and {minus} negative squares",
                    "counted exactly on the tangent space of the orbit, from D²(h + ν·C) at these numbers"))
        return Outcome(None, s.printed)
    raise PublishedError(f"quantity = {s.quantity!r}: a statement is about stability, second variation, Casimirs alone, or is left empty")
