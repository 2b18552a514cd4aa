"""Checks printed formulas: identities, equilibria, solutions of the equations of motion, and numbers."""
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, islice
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, Matrix, MatrixBase, Pow, Symbol

from ...algebra.reals.exact import sign_of_constant
from ...errors import PublishedError
from ...mechanics.classical.attitude import reduced
from ...notation import symbol
from ..language import decimal, read
from ..names.derived_names import is_zero
from ..statements import Doubt, Outcome
from . import routes
from .readings import Reading
from .sampling import on_family


def identity(r: Reading) -> Outcome | Doubt:
    """Check that printed − quantity vanishes identically; at an equilibrium, on its family."""
    s = r.statement
    printed, derived = r.finish(read(s.printed, r.own)), r.finish(read(s.quantity, r.own))
    entries, places = _entries(printed, derived)
    wrong = [(place, p, d) for place, (p, d) in zip(places, entries) if not _equal(p, d)]
    if not wrong:
        return Outcome(True, printed, derived, route=routes.of_identity(r.scene, len(entries) > 1))
    difference = tuple((place, reduced(p - d)) for place, p, d in wrong)
    place, p, d = wrong[0]
    return Doubt(_where_they_differ(r, p, d), printed, derived, difference, (p, d), place)


def _equal(p: Expr, d: Expr) -> bool:
    """Return whether both are equal identically; of numbers with nested roots the difference decides."""
    return is_zero(p - d) or not (p - d).free_symbols and sign_of_constant(p - d) == 0


def _where_they_differ(r: Reading, p: Expr, d: Expr,
                       functions: Sequence[Expr] = ()) -> Iterator[Mapping[Symbol, Expr]]:
    """Yield points at which both sides are defined and different.

    If a printed function is real at none of them, points at which it is not real come first.
    """
    drawn = r.points([p, d])
    tried = list(islice(drawn, 12)) if any(f.atoms(Pow) for f in functions or (p,)) else []
    for f in (f for f in functions or (p,) if f.atoms(Pow)):
        if all(f.subs(values).evalf(20).is_real is False for values in tried):
            yield from (values for values in tried if functions or d.subs(values).evalf(20).is_real is True)
    yield from (values for values in chain(tried, drawn) if _differ(p, d, values))


def _entries(printed: Any, derived: Any) -> tuple[list[tuple[Expr, Expr]], list[Any]]:
    if isinstance(printed, MatrixBase) != isinstance(derived, MatrixBase) or (
            isinstance(printed, MatrixBase) and printed.shape != derived.shape):
        shapes = [f"{x.rows}×{x.cols} matrix" if isinstance(x, MatrixBase) else "number"
                  for x in (printed, derived)]
        raise PublishedError(f"printed is a {shapes[0]}, the quantity a {shapes[1]}: give as many entries "
                             "as it has")
    if not isinstance(printed, MatrixBase):
        return [(printed, derived)], [None]
    places = [(i, j) for i in range(printed.rows) for j in range(printed.cols)]
    return [(printed[p], derived[p]) for p in places], places


def _differ(p: Expr, d: Expr, values: Mapping[Symbol, Expr]) -> bool:
    x, y = p.subs(values).evalf(30), d.subs(values).evalf(30)
    return bool(x.is_Number and y.is_Number and x.is_finite and y.is_finite and abs(x - y) >= 1e-20)


def equilibrium(r: Reading) -> Outcome | Doubt:
    """Check that the field vanishes at the printed point, on the family."""
    s, scene = r.statement, r.scene
    point = read(s.printed, r.own)
    coordinates = scene.system.space.coordinates
    if not isinstance(point, MatrixBase) or len(point) != len(coordinates):
        raise PublishedError(f"an equilibrium has {len(coordinates)} coordinates: give as many")
    field = r.finish(scene.system.jet_field.xreplace(dict(zip(coordinates, point))))
    left = tuple(((i, 0), reduced(rate)) for i, rate in enumerate(field) if not is_zero(rate))
    if not left:
        return Outcome(True, point, ImmutableMatrix(scene.point or field),
                       route=routes.of_point(scene.equilibrium))
    rate = field[left[0][0][0]]
    points = (values for values in r.points(list(field)) if _differ(rate, Integer(0), values))
    return Doubt(points, point, ImmutableMatrix(scene.point), left, (rate,), left[0][0])


def solution(r: Reading) -> Outcome | Doubt:
    """Check that the printed functions of t satisfy the equations of motion.

    A general solution needs as many independent constants as there are equations.
    """
    s, scene = r.statement, r.scene
    names = list(map(str, s.quantity))
    if (
        names not in ([f"{x}{i}" for i in (1, 2, 3)] for x in ("omega", "pi"))
        or scene.potential
        or scene.equilibrium
        or ("angles" in scene.table)
    ):
        raise PublishedError("a solution is one of a free body, its quantity the list omega1, omega2, "
                             "omega3 or pi1, pi2, pi3")
    t, printed = symbol("t"), read(s.printed, r.own)
    if not isinstance(printed, MatrixBase) or len(printed) != 3:
        raise PublishedError("a solution is printed as a list of three functions of t")
    place = {symbol(f"pi{n[-1]}"): f * (scene.body.moments[int(n[-1]) - 1] if n.startswith("omega") else 1)
             for n, f in zip(names, printed)}
    slopes = [f.diff(t) for f in printed]
    rates = [read(f"dt({n})", r.names).xreplace(place) for n in names]
    wrong = [i for i, (a, b) in enumerate(zip(slopes, rates)) if not is_zero(a - b)]
    if wrong:
        i = wrong[0]
        sides, difference = (slopes[i], rates[i]), tuple(((j, 0), slopes[j] - rates[j]) for j in wrong)
        return Doubt(_where_they_differ(r, *sides, printed), printed, ImmutableMatrix(rates), difference,
                     sides, (i, 0), place)
    missing = len(names) - _rank(printed, [symbol(c) for c in s.constants]) if s.constants else 0
    if not missing:
        return Outcome(True, printed, ImmutableMatrix(rates),
                       route=routes.of_solution(len(names) if s.constants else 0))
    known = f"it is a solution with {len(names) - missing} of the {len(names)} constants of the general one"
    fixed = [(i, f) for i, f in enumerate(printed.subs(t, 0)) if f.is_number]
    starts = [read(n, r.names) for n in names]
    points = (values for i, f in fixed for values in r.points(starts) if starts[i].subs(values) != f)
    return Doubt(points, printed, known, ((None, Integer(missing)),), sides=tuple(starts))


def _rank(printed: Any, constants: list[Symbol]) -> int:
    slopes = Matrix([[f.diff(c) for c in constants] for f in printed])
    chosen = {s: Integer(n + 2) / 7 for n, s in enumerate(sorted(slopes.free_symbols, key=str))}
    return int(slopes.subs(chosen).rank(iszerofunc=lambda e: abs(e.evalf(30)) < 1e-20))


def rounded(r: Reading) -> Outcome | Doubt:
    """Check that the derived number rounds to the printed digits."""
    s = r.statement
    derived, (printed, half) = r.finish(read(s.quantity, r.own)), decimal(str(s.printed))
    if isinstance(derived, MatrixBase):
        raise PublishedError("the quantity of a number is one number, but this is a vector or matrix: use "
                             "entry(…, i, j)")
    if derived.free_symbols:
        raise PublishedError("the quantity still contains "
                             f"{', '.join(sorted(map(str, derived.free_symbols)))}: give numbers under at")
    excess = abs(derived.evalf(50) - printed)
    if excess <= half:
        return Outcome(True, s.printed, derived, route=routes.of_number(str(s.printed)))
    at = on_family(r.scene, r.at)
    return Doubt([at], s.printed, derived, ((None, printed - derived.evalf(20)),))
