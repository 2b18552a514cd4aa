"""Checks of printed formulas: identities, equilibria, solutions of the equations of motion, numbers."""
from collections.abc import Mapping
from itertools import islice
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, Matrix, MatrixBase, Pow, Symbol

from ..attitude import reduced
from ..errors import PublishedError
from ..notation import symbol
from . import independent
from .independent_names import number
from .language import decimal, read
from .names import is_zero
from .statements import Counterexample, Outcome, Reading, named


def identity(r: Reading) -> Outcome:
    """printed − quantity vanishes identically, on the family where the scene has an equilibrium."""
    s = r.statement
    printed, derived = r.finish(read(s.printed, r.own)), r.finish(read(s.quantity, r.own))
    entries, places = _entries(printed, derived)
    wrong = [(place, p, d) for place, (p, d) in zip(places, entries) if not is_zero(p - d)]
    if not wrong:
        return Outcome(True, printed, derived)
    difference = tuple((place, reduced(p - d)) for place, p, d in wrong)
    place, p, d = wrong[0]
    if never := _never_real([p], d, r):
        return Outcome(False, printed, derived, difference, never)
    for values in r.points([p, d]):
        if (there := _differ(p, d, values)) is not None:
            quantity = r.independently(s.quantity, values)
            value = number(quantity[place] if isinstance(quantity, MatrixBase) else quantity, r.scene, values)
            return Outcome(False, printed, derived, difference, _compared(r, values, *there, value, place))
    return Outcome(None, printed, derived, difference)     # not refuted: at no point that was tried are both defined and different


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
    x, y = a.evalf(30), b.evalf(30)
    if not (x.is_Number and y.is_Number and x.is_finite and y.is_finite) or abs(x - y) < 1e-20:
        return None
    return a, b


def _never_real(functions: list[Expr], derived: Expr | None, r: Reading) -> Counterexample | None:
    """One of the printed functions is not a real number at any of the first points, where what is derived is one."""
    rooted = [f for f in functions if f.atoms(Pow)]
    tried = list(islice(r.points([*rooted, *([derived] if derived is not None else [])]), 12)) if rooted else []
    for f in rooted if tried else ():
        if any(f.subs(values).evalf(20).is_real is not False for values in tried):
            continue
        value = derived.subs(tried[0]) if derived is not None else None
        if value is None or value.evalf(20).is_real is True:
            real = "a real number" if value is None else value
            return Counterexample(named(tried[0]), "not real", real, f"the printed value there is {f.subs(tried[0]).evalf(8)}")
    return None


def _compared(r: Reading, values: Mapping[Symbol, Expr], p: Expr, d: Expr, value: Any, place: Any = None) -> Counterexample:
    """The independent value must be the derived one."""
    if not isinstance(value, Expr) or value.free_symbols or abs((value - d).evalf(25)) > 1e-18 * max(1, abs(d.evalf(25))):
        raise PublishedError(f"computed independently it is {value} at {dict(values)}, by the library {d}, in print {p}")
    by = "three turns of the body" if "angles" in r.scene.table else "Newton and Euler's equations"
    printed = r.statement.printed
    columns = len(printed[0]) if isinstance(printed, list) and isinstance(printed[0], list) else 1
    which = f"entry {', '.join(str(i + 1) for i in place[:2 if columns > 1 else 1])}: " if place else ""
    return Counterexample(named(values), p, d, f"{which}by {by} at these numbers {_short(value)}")


def _short(value: Expr) -> str:
    return str(value) if value.is_Rational else str(value.evalf(20))


def equilibrium(r: Reading) -> Outcome:
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
                raise PublishedError(f"Newton and Euler's equations give the rate {rate}, the library {there[0]}")
            return Outcome(False, point, ImmutableMatrix(scene.point), left, Counterexample(
                named(values), "an equilibrium", f"d{coordinates[left[0][0][0]]}/dt = {rate}",
                f"by Newton and Euler's equations the rate of {coordinates[left[0][0][0]]} there is {rate}, not 0"))
    return Outcome(None, point, ImmutableMatrix(scene.point), left)


def solution(r: Reading) -> Outcome:
    """The printed functions of t satisfy the equations of motion; a general solution has as many constants as equations."""
    s, scene = r.statement, r.scene
    names = list(map(str, s.quantity))
    if names not in ([f"{x}{i}" for i in (1, 2, 3)] for x in ("omega", "pi")) or scene.potential or scene.equilibrium or (
            "angles" in scene.table):
        raise PublishedError("a solution is one of a free body, its quantity the list omega1, omega2, omega3 or pi1, pi2, pi3")
    t, printed = symbol("t"), read(s.printed, r.own)
    if not isinstance(printed, MatrixBase) or len(printed) != 3:
        raise PublishedError("a solution is printed as a list of three functions of t")
    place = {symbol(f"pi{n[-1]}"): f * (scene.body.inertia[int(n[-1]) - 1] if n.startswith("omega") else 1) for n, f in zip(names, printed)}
    slopes = [f.diff(t) for f in printed]
    rates = [read(f"dt({n})", r.names).xreplace(place) for n in names]
    wrong = [i for i, (a, b) in enumerate(zip(slopes, rates)) if not is_zero(a - b)]
    if wrong:
        i = wrong[0]
        if never := _never_real(list(printed), None, r):
            return Outcome(False, printed, ImmutableMatrix(rates), None, never)
        for values in r.points([slopes[i], rates[i]]):
            if (there := _differ(slopes[i], rates[i], values)) is not None:
                moving = values | {x: f.subs(values) for x, f in place.items()}
                value = number(r.independently(f"dt({names[i]})", moving), scene, moving)
                difference = tuple(((j, 0), slopes[j] - rates[j]) for j in wrong)
                return Outcome(False, printed, ImmutableMatrix(rates), difference, _compared(r, values, *there, value, (i, 0)))
        return Outcome(None, printed, ImmutableMatrix(rates))
    missing = len(names) - _rank(printed, [symbol(c) for c in s.constants]) if s.constants else 0
    if not missing:
        return Outcome(True, printed, printed)
    start = printed.subs(t, 0)
    fixed = next((n for n, f in zip(names, start) if f.is_number), None)
    if fixed is None:
        return Outcome(None, printed, f"a solution with {len(names) - missing} of the {len(names)} constants of the general one")
    value = start[names.index(fixed)] + 1
    return Outcome(False, printed, f"a solution with {len(s.constants)} of the {len(names)} constants of the general one",
                   ((None, Integer(missing)),), Counterexample(((f"{fixed}(0)", value),), start[names.index(fixed)], value,
                   f"{fixed} may start at {value}; the printed functions start it at {start[names.index(fixed)]} for every choice of "
                   f"{', '.join(s.constants)}"))


def _rank(printed: Any, constants: list[Symbol]) -> int:
    slopes = Matrix([[f.diff(c) for c in constants] for f in printed])
    chosen = {s: Integer(n + 2) / 7 for n, s in enumerate(sorted(slopes.free_symbols, key=str))}
    return int(slopes.subs(chosen).rank(iszerofunc=lambda e: abs(e.evalf(30)) < 1e-20))


def rounded(r: Reading) -> Outcome:
    """The derived number rounds to the printed digits."""
    s = r.statement
    derived, (printed, half) = r.finish(read(s.quantity, r.own)), decimal(str(s.printed))
    if isinstance(derived, MatrixBase):
        raise PublishedError("the quantity of a number is one number, this is a vector or matrix: use entry(…, i, j)")
    if derived.free_symbols:
        raise PublishedError(f"the quantity still contains {', '.join(sorted(map(str, derived.free_symbols)))}: give numbers under at")
    excess = abs(derived.evalf(50) - printed)
    if excess <= half:
        return Outcome(True, s.printed, derived)
    value = number(r.independently(s.quantity, r.at), r.scene, r.at)
    return Outcome(False, s.printed, derived, ((None, printed - derived.evalf(20)),), _compared(r, r.at, printed, derived, value))
