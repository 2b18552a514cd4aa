"""Each published formula beside what the library derives, and where they differ a counterexample that confirms itself."""
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, Matrix, MatrixBase, Symbol, nsimplify

from ..conditions import Criterion
from ..errors import GyrostatError, PublishedError
from ..notation import symbol
from . import independent
from .criteria import CLAIMS, Claim, agree, free_symbols, holds, normal, printed_criterion
from .language import comparisons, decimal, read
from .sampling import K, points, unknowns
from .scenes import Names, Scene, is_zero, reduced

KINDS = ("identity", "family", "equilibrium", "solution", "condition", "number", "statement")


@dataclass(frozen=True)
class Statement:
    """One formula or claim of a source, exactly as printed, in the library's symbols.

    Parameters
    ----------
    source, key : str
    where : str                      section and equation number or position
    quantity : str or list           what the formula is about, as an expression in the names of the scene, or a claim
    printed : str or (nested) list   the right-hand side, the condition, the verdict
    kind : str                       identity, family (an identity on the family of an equilibrium), equilibrium,
                                     solution (of the equations of motion), condition, number, statement
    note : str
    scene : Scene
    let : mapping                    the source's own abbreviations, as printed
    at : mapping                     values inserted on both sides
    given : str                      comparisons under which the claim is made
    constants : tuple of str         those of a solution that is called general
    """

    source: str
    key: str
    where: str
    quantity: Any
    printed: Any
    kind: str
    note: str = ""
    scene: Scene = field(default_factory=Scene)
    let: Mapping[str, str] = field(default_factory=dict)
    at: Mapping[str, str] = field(default_factory=dict)
    given: str = ""
    constants: tuple[str, ...] = ()


@dataclass(frozen=True)
class Counterexample:
    """Rational values at which printed and derived differ, and what confirms the derived side without either formula."""

    values: tuple[tuple[str, Expr], ...]
    printed: Any
    derived: Any
    confirmation: str


@dataclass(frozen=True)
class Outcome:
    """What a check found; agrees is None where nothing can be checked."""

    agrees: bool | None
    printed: Any = None
    derived: Any = None
    difference: Any = None
    counterexample: Counterexample | None = None


def check(statement: Statement) -> Outcome:
    """Compare one statement with what the library derives.

    Raises
    ------
    PublishedError       the statement cannot be read, or a difference was found that is not confirmed independently
    """
    try:
        return _CHECKS[statement.kind](_Reading(statement))
    except KeyError:
        raise PublishedError(f"kind = {statement.kind!r}: the kinds are {', '.join(KINDS)}") from None


class _Reading:
    """A statement with its texts read."""

    def __init__(self, statement: Statement):
        self.statement, self.scene = statement, statement.scene
        bare = self.scene.names({})
        self.at: dict[Symbol, Expr] = {}
        for name, text in statement.at.items():
            self.at[symbol(name)] = read(text, bare)
        self.names = self.scene.names(self.at) if self.at else bare
        self.own = _with_let(self.names, statement.let)
        parsed = comparisons(statement.given, self.names) if statement.given else []
        self.given = tuple(margin for margin, _ in parsed)

    def finish(self, expression: Any) -> Any:
        return self.scene.finish(expression).xreplace(self.at)

    @cached_property
    def claim(self) -> Claim:
        return Claim(self.scene, tuple(map(self.finish, self.given)), self.at)

    def points(self, expressions: list[Expr]) -> Iterator[dict[Symbol, Expr]]:
        return points(self.scene, expressions, self.given, self.at, self.statement.quantity != "existence")

    def independently(self, text: Any, values: Mapping[Symbol, Expr]) -> Any:
        """A quantity from Newton and Euler's equations at numbers."""
        names = independent.names(self.scene, values)
        return read(text, _with_let(names, self.statement.let))


def _with_let(names: Mapping[str, Any], let: Mapping[str, str]) -> Mapping[str, Any]:
    own: dict[str, Any] = dict(names) if not isinstance(names, Names) else {}
    layered = _Layer(own, names)
    for name, text in let.items():
        own[name] = read(text, layered)
    return layered


class _Layer(Mapping[str, Any]):
    """The source's own abbreviations before the names of the scene."""

    def __init__(self, own: Mapping[str, Any], names: Mapping[str, Any]):
        self.own, self.names = own, names

    def __getitem__(self, name: str) -> Any:
        return self.own[name] if name in self.own else self.names[name]

    def __iter__(self) -> Iterator[str]:
        return iter({**dict.fromkeys(self.names), **dict.fromkeys(self.own)})

    def __len__(self) -> int:
        return len(set(self.names) | set(self.own))


def _identity(r: _Reading) -> Outcome:
    """printed − quantity vanishes identically, on the family where the scene has an equilibrium."""
    s = r.statement
    printed, derived = r.finish(read(s.printed, r.own)), r.finish(read(s.quantity, r.own))
    entries, places = _entries(printed, derived)
    wrong = [(place, p, d) for place, (p, d) in zip(places, entries) if not is_zero(p - d)]
    if not wrong:
        return Outcome(True, printed, derived)
    difference = tuple((place, reduced(p - d)) for place, p, d in wrong)
    place, p, d = wrong[0]
    for values in r.points([p, d]):
        if (there := _differ(p, d, values)) is not None:
            quantity = r.independently(s.quantity, values)
            value = independent.number(quantity[place] if isinstance(quantity, MatrixBase) else quantity, r.scene, values)
            return Outcome(False, printed, derived, difference, _compared(values, *there, value, place))
    raise PublishedError(f"{s.key}: printed and derived differ by {difference}, but at no rational point that was tried")


def _entries(printed: Any, derived: Any) -> tuple[list[tuple[Expr, Expr]], list[Any]]:
    if isinstance(printed, MatrixBase) != isinstance(derived, MatrixBase) or (
            isinstance(printed, MatrixBase) and printed.shape != derived.shape):
        shapes = [f"{x.rows}×{x.cols} matrix" if isinstance(x, MatrixBase) else "number" for x in (printed, derived)]
        raise PublishedError(f"printed is a {shapes[0]}, the quantity a {shapes[1]}: give as many entries as it has")
    if not isinstance(printed, MatrixBase):
        return [(printed, derived)], [None]
    places = [(i, j) for i in range(printed.rows) for j in range(printed.cols)]
    return [(printed[p], derived[p]) for p in places], places


def _differ(p: Expr, d: Expr, values: Mapping[Symbol, Expr]) -> tuple[Expr, Expr] | None:
    a, b = p.subs(values), d.subs(values)
    if not all(x.is_finite and not x.free_symbols for x in (a, b)) or abs((a - b).evalf(30)) < 1e-20:
        return None
    return a, b


def _compared(values: Mapping[Symbol, Expr], p: Expr, d: Expr, value: Any, place: Any = None) -> Counterexample:
    """The independent value must be the derived one."""
    if not isinstance(value, Expr) or value.free_symbols or abs((value - d).evalf(25)) > 1e-18 * max(1, abs(d.evalf(25))):
        raise PublishedError(f"Newton and Euler's equations give {value} at {dict(values)}, the library {d}, the print {p}")
    which = f"entry {', '.join(str(i + 1) for i in place)}: " if place else ""
    return Counterexample(_named(values), p, d, f"{which}by Newton and Euler's equations at these numbers {_short(value)}")


def _named(values: Mapping[Symbol, Expr]) -> tuple[tuple[str, Expr], ...]:
    return tuple(sorted(((s.name, v) for s, v in values.items()), key=lambda pair: pair[0]))


def _short(value: Expr) -> str:
    return str(value) if value.is_Rational else str(value.evalf(20))


def _equilibrium(r: _Reading) -> Outcome:
    """The field vanishes at the printed point, on the family."""
    s, scene = r.statement, r.scene
    point = read(s.printed, r.own)
    coordinates = scene.system.space.coordinates
    if not isinstance(point, MatrixBase) or len(point) != len(coordinates):
        raise PublishedError(f"an equilibrium has {len(coordinates)} coordinates: give as many")
    field = r.finish(scene.system.jet_field.xreplace(dict(zip(coordinates, point))))
    left = tuple(((i, 0), reduced(rate)) for i, rate in enumerate(field) if not is_zero(rate))
    if not left:
        return Outcome(True, point, ImmutableMatrix(scene.point))
    for values in r.points(list(field)):
        if (there := _differ(field[left[0][0]], Integer(0), values)) is not None:
            model = independent.Model(scene, values)
            at = dict(zip(model.coordinates, [x.subs(values) for x in r.finish(point)]))
            rate = model.field.subs(at)[left[0][0]]
            if rate != there[0]:
                raise PublishedError(f"{s.key}: Newton and Euler's equations give the rate {rate}, the library {there[0]}")
            return Outcome(False, point, ImmutableMatrix(scene.point), left, Counterexample(
                _named(values), "an equilibrium", f"d{coordinates[left[0][0][0]]}/dt = {rate}",
                f"by Newton and Euler's equations the rate of {coordinates[left[0][0][0]]} there is {rate}, not 0"))
    raise PublishedError(f"{s.key}: the field is {left}, but vanishes at every point that was tried")


def _solution(r: _Reading) -> Outcome:
    """The printed functions of t satisfy the equations of motion; a general solution has as many constants as equations."""
    s, scene = r.statement, r.scene
    names = list(map(str, s.quantity))
    if not set(names) <= {f"{x}{i}" for x in ("omega", "pi") for i in (1, 2, 3)}:
        raise PublishedError("the quantity of a solution is a list of omega1, omega2, omega3, or of pi1, pi2, pi3")
    t, printed = symbol("t"), read(s.printed, r.own)
    place = {symbol(f"pi{n[-1]}"): f * (scene.body.inertia[int(n[-1]) - 1] if n.startswith("omega") else 1) for n, f in zip(names, printed)}
    slopes = [f.diff(t) for f in printed]
    rates = [read(f"dt({n})", r.names).xreplace(place) for n in names]
    wrong = [i for i, (a, b) in enumerate(zip(slopes, rates)) if not is_zero((a - b).rewrite("exp") if a.has(t) else a - b)]
    if wrong:
        i = wrong[0]
        for values in r.points([slopes[i], rates[i]]):
            if (there := _differ(slopes[i], rates[i], values)) is not None:
                moving = values | {x: f.subs(values) for x, f in place.items()}
                value = independent.number(r.independently(f"dt({names[i]})", moving), scene, moving)
                difference = tuple(((j, 0), slopes[j] - rates[j]) for j in wrong)
                return Outcome(False, printed, ImmutableMatrix(rates), difference, _compared(values, *there, value, (i, 0)))
        raise PublishedError(f"{s.key}: no solution, but its rate is right at every point that was tried")
    missing = len(names) - _rank(printed, [symbol(c) for c in s.constants]) if s.constants else 0
    if not missing:
        return Outcome(True, printed, printed)
    start = printed.subs(t, 0)
    fixed = next(n for n, f in zip(names, start) if f.is_number)
    value = start[names.index(fixed)] + 1
    return Outcome(False, printed, f"a solution with {len(s.constants)} of the {len(names)} constants of the general one",
                   ((None, Integer(missing)),), Counterexample(((f"{fixed}(0)", value),), start[names.index(fixed)], value,
                   f"{fixed} may start at {value}; the printed functions start it at {start[names.index(fixed)]} for every choice of "
                   f"{', '.join(s.constants)}"))


def _rank(printed: Any, constants: list[Symbol]) -> int:
    slopes = Matrix([[f.diff(c) for c in constants] for f in printed])
    chosen = {s: Integer(n + 2) / 7 for n, s in enumerate(sorted(slopes.free_symbols, key=str))}
    return int(slopes.subs(chosen).rank(iszerofunc=lambda e: abs(e.evalf(30)) < 1e-20))


def _number(r: _Reading) -> Outcome:
    """The derived number rounds to the printed digits."""
    s = r.statement
    derived, (printed, half) = read(s.quantity, r.own), decimal(s.printed)
    if derived.free_symbols:
        raise PublishedError(f"the quantity still contains {', '.join(sorted(map(str, derived.free_symbols)))}: give numbers under at")
    excess = abs(derived.evalf(50) - printed)
    if excess <= half:
        return Outcome(True, s.printed, derived)
    value = independent.number(r.independently(s.quantity, r.at), r.scene, r.at)
    return Outcome(False, s.printed, derived, ((None, printed - derived.evalf(20)),), _compared(r.at, printed, derived, value))


def _condition(r: _Reading) -> Outcome:
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


def _necessary_and_sufficient(r: _Reading, printed: Criterion) -> Outcome:
    """Sufficient as printed; necessary unless a point on the boundary is stable too."""
    derived, domain = r.claim.report.sufficient, r.claim.domain
    if not agree("sufficient for stability", printed, derived, domain):
        return Outcome(False, printed, derived, None, _refuted(r, "sufficient for stability", printed, derived))
    for values in _on_boundary(r, derived):
        model = independent.Model(r.scene, values)
        if model.isolated():
            return Outcome(False, printed, derived, None, Counterexample(
                _named(values), "unstable", "stable",
                "the energy, momenta and k of the point are shared by no other point near it (g(k3) < 0 around it): it is Lyapunov stable, "
                f"though equality holds; growth rate of the linearised field {_short_float(model.growth())}"))
    return Outcome(None, printed, derived)


def _on_boundary(r: _Reading, criterion: Criterion) -> Iterator[dict[Symbol, Expr]]:
    ((condition,),) = criterion.alternatives
    margin = condition.margin.subs(symbol("dU"), r.finish(symbol("dU")))
    for values in r.points([margin]):
        for s in sorted(margin.free_symbols, key=str):
            slope = margin.diff(s)
            if slope and not slope.has(s):
                on = values | {s: (s - margin / slope).subs(values)}
                if all(e.subs(on) > 0 for e in (*r.given, *(x for x in on if x.is_positive))):
                    yield on


def _refuted(r: _Reading, claim: str, printed: Criterion, derived: Criterion) -> Counterexample:
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


def _anywhere(r: _Reading, symbols: list[Expr]) -> Iterator[dict[Symbol, Expr]]:
    """Points with special values too: existence may fail where a parameter is 0."""
    for values in r.points(symbols):
        for s in symbols:
            yield values | {s: Integer(0)} if not s.is_positive and s not in K else values


def _confirmed(r: _Reading, claim: str, said: bool, values: dict[Symbol, Expr]) -> Counterexample | None:
    says, word = ("holds", "fails") if said else ("fails", "holds")
    try:
        model = independent.Model(r.scene, values)
    except GyrostatError:
        return None
    if claim == "existence":
        unit = not model.U or sum(x**2 for x in model.point[3:]) == 1
        why = f"the field of Newton and Euler vanishes there, at {model.point}" if unit else "there is no such direction, |k| > 1"
        return Counterexample(_named(values), f"the printed condition {says}", f"the derived one {word}", why)
    growth = model.growth()
    unstable = growth > independent.mpmath.mpf(10) ** -20
    if not unstable and not model.isolated():
        return None
    why = f"an eigenvalue of the differenced field has the real part {_short_float(growth)}: unstable" if unstable else \
        "the level set of all integrals there is the orbit of the point alone: Lyapunov stable, modulo the spin"
    return Counterexample(_named(values), f"the printed condition {says}", f"the derived one {word}", why)


def _short_float(value: Any) -> str:
    return str(independent.mpmath.nstr(value, 15))


def _separatrix(r: _Reading, printed: Criterion) -> Counterexample:
    """Motion on L2 = 2 E I2: (a sech, tanh, c sech)(μt), which Euler's equations are checked to have, is not periodic."""
    I1, I2, I3 = values = [Integer(n) for n in (1, 2, 3)]
    chosen = dict(zip(map(symbol, ("I1", "I2", "I3", "E", "L2")), (*values, 1 / (2 * I2), Integer(1))))
    mp = independent.mpmath
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
    return Counterexample(_named(chosen), "periodic", "not periodic", "M2 = tanh(√((1/I1 − 1/I2)(1/I2 − 1/I3)) t) on the separatrix satisfies "
                          "Euler's equations (residual below 1e-20) and grows for ever")


def _statement(r: _Reading) -> Outcome:
    """A claim in words: a verdict, a signature, or nothing that can be checked."""
    s = r.statement
    if not s.quantity:
        return Outcome(None, s.printed)
    if s.quantity == "stability":
        verdict = r.claim.verdict()
        if verdict == s.printed:
            return Outcome(True, s.printed, verdict)
        for values in r.points([]):
            model = independent.Model(r.scene, values)
            growth = model.growth()
            if growth > 1e-20 or model.isolated():
                truth = "unstable" if growth > 1e-20 else "stable"
                why = f"an eigenvalue of the differenced field has the real part {_short_float(growth)}" if growth > 1e-20 else \
                    "the level set of all integrals there is the point alone"
                if truth == verdict or verdict == "undecided" and truth != s.printed:
                    return Outcome(False, s.printed, verdict, None, Counterexample(_named(values), s.printed, truth, why))
        raise PublishedError(f"{s.key}: the verdict {verdict} is not confirmed at any point that was tried")
    if s.quantity == "second variation, Casimirs alone":
        for values in r.points([]):
            plus, zero, minus = independent.Model(r.scene, values).inertia_of_second_variation()
            if (s.printed == "semidefinite") == bool(plus and minus):
                return Outcome(False, s.printed, "indefinite" if plus and minus else "semidefinite", None, Counterexample(
                    _named(values), s.printed, f"{plus} positive, {zero} zero and {minus} negative squares",
                    "counted exactly on the tangent space of the orbit, from D²(h + ν·C) at these numbers"))
        return Outcome(None, s.printed)
    raise PublishedError(f"quantity = {s.quantity!r}: a statement is about stability, second variation, Casimirs alone, or is left empty")


_CHECKS = {"identity": _identity, "family": _identity, "equilibrium": _equilibrium, "solution": _solution, "condition": _condition,
           "number": _number, "statement": _statement}
__all__ = ["CLAIMS", "KINDS", "Counterexample", "Outcome", "Statement", "check", "nsimplify", "unknowns"]
