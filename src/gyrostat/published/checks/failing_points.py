"""Proposes points at which a printed condition may be seen to fail.

They are drawn at random, lie in the wedges between its boundary and the derived one, or lie at equality.
"""
from collections.abc import Iterable, Iterator
from functools import partial
from itertools import islice

from sympy import Expr, Integer, Mul, Poly, S, Symbol, fraction, oo, together

from ...algebra.reals.exact import sign_of_constant
from ...algebra.solving.roots import between, real_roots
from ...errors import ScopeError
from ...mechanics.families.named_families import E3, FAMILIES
from ...notation import symbol
from ...stability.criteria.conditions import Criterion
from .criteria import SPECTRAL, free_symbols, holds
from .readings import Reading
from .sampling import K, on_family

Values = dict[Symbol, Expr]
LINES, ON_BOUNDARY = 6, 150                                # base points of lines; points at equality
# points that are drawn, once that many are found that are only left out
DRAWN, LEFT_OUT = 100, 4


def suspects(r: Reading, printed: Criterion, derived: Criterion, alike: bool) -> Iterator[Values]:
    """Yield points that may refute a condition, then some that it may only leave out.

    If alike is True, the printed condition and the derived one differ at equality at most.
    """
    claim = str(r.statement.quantity)
    if claim == "sufficient for periodic motion":
        yield {symbol(name): Integer(n) / d for name, n, d in (("I1", 1, 1), ("I2", 2, 1), ("I3", 3, 1),
                                                               ("E", 1, 4), ("L2", 1, 1))}
        return
    wanted = (
        None
        if claim in ("existence", "necessary and sufficient for stability", SPECTRAL)
        else claim.startswith("sufficient")
    )
    truths = [derived]
    if claim == "necessary and sufficient for stability":  # between the two, either side may be true
        truths.append(r.claim.derived("necessary for stability"))
    symbols, later = {s for c in (printed, *truths) for s in free_symbols(c)}, list[Values]()
    drawn: Iterable[Values] = (
        () if alike else _anywhere(r, symbols) if claim == "existence" else r.points(symbols)
    )
    enough = (values for n, values in enumerate(drawn) if n < DRAWN or len(later) < LEFT_OUT)
    for values in map(partial(_settled, r), _in_turn(enough, _between(r, printed, *truths))):
        said = holds(printed, values)
        if all(said == holds(c, values) for c in truths):
            continue
        if wanted in (None, said):
            yield values
        elif len(later) < LEFT_OUT:
            later.append(values)
    never = not printed.alternatives  # it holds nowhere
    if (
        not (never and wanted)
        and "stability" in claim
        and not claim.endswith(("Casimirs alone", "on the boundary"))
    ):
        at_equality = (_settled(r, values) for values in islice(_on_boundary(r, derived), ON_BOUNDARY))
        yield from (values for values in at_equality if wanted in (None, holds(printed, values)))
    yield from later


def _in_turn(*sources: Iterator[Values]) -> Iterator[Values]:
    """Yield one of each source in turn, so that none uses up the points that are looked at."""
    left = list(sources)
    while left:
        for source in tuple(left):
            try:
                yield next(source)
            except StopIteration:
                left.remove(source)


def _settled(r: Reading, values: Values) -> Values:
    """Return the values with those that `at` and the family determine by the others."""
    return on_family(r.scene, values | {name: value.xreplace(values)
                                        for name, value in r.at.items() if name in values})


def _admissible(r: Reading, values: Values) -> bool:
    """Return whether what is given is positive, and every symbol that is assumed to be."""
    return all(sign_of_constant(e.subs(values)) == 1
               for e in (*r.given, *(x for x in values if x.is_positive)))


def _anywhere(r: Reading, symbols: set[Symbol]) -> Iterator[Values]:
    """Yield points, special ones too: existence may fail if a parameter is 0, or abs(k) is not 1."""
    for values in r.points(symbols):
        for s in sorted(symbols, key=str):
            yield values | {s: Integer(2 if s in K else s.is_positive or 0)}
        yield values


def _between(r: Reading, *criteria: Criterion) -> Iterator[Values]:
    """Yield points between the boundaries of the conditions, however near these are to one another.

    On lines along one name there is a point in each cell that the boundaries cut, and at each rational end.
    """
    margins = [c.margin for criterion in criteria for a in criterion.alternatives for c in a]
    for values in islice(r.points(margins), LINES):
        for s in sorted({x for m in margins for x in m.free_symbols} - {*K, *r.at}, key=str):
            others = {x: v for x, v in values.items() if x != s}
            yield from (values | {s: x} for x in _cells([m.xreplace(others) for m in margins], s))


def _cells(margins: list[Expr], s: Symbol) -> Iterator[Expr]:
    parts = [part for m in margins for part in fraction(together(m)) if s in part.free_symbols]
    low = S.Zero if s.is_positive else None
    try:
        ends = real_roots(Mul(*parts), s, low) or []
    except ScopeError:                                     # not rational along this name
        return
    bounds = [-oo if low is None else low, *ends, oo]
    yield from map(between, bounds, bounds[1:])
    yield from (end for end in ends if end.is_Rational)


def _on_boundary(r: Reading, derived: Criterion) -> Iterator[Values]:
    """Yield points where a margin is 0, of each margin in turn."""
    return _in_turn(*(_where_zero(r, c.margin) for a in derived.alternatives for c in a))


def _where_zero(r: Reading, margin: Expr) -> Iterator[Values]:
    """Yield points where a margin is 0, found along a name in which it is affine.

    The curvature of an unspecified U is drawn too.
    """
    yield from _at_rest(r, margin)
    slopes = {s: margin.diff(s) for s in sorted(margin.free_symbols - {*K}, key=str)}
    affine = {s: slope for s, slope in slopes.items() if not slope.has(s)}
    if not affine:
        return
    for values in r.points([margin, *([symbol("d2U")] if margin.has(symbol("dU")) else [])]):
        for s, slope in affine.items():
            if slope.subs(values):
                on = values | {s: (s - margin / slope).subs(values)}
                if _admissible(r, on):
                    yield on | _flat(r, on)
                    yield from _next(r, on)
                    yield from _double(r, margin, s, on)


def _at_rest(r: Reading, margin: Expr) -> Iterator[Values]:
    """Yield points of the boundary at rest, where both sides of a condition vanish.

    First comes a point where all names are 0 that may be, then points without spin and rotor.
    """
    for values in islice(r.points([margin]), 1):
        on = values | {s: Integer(0) for s in values if not s.is_positive and s not in {*K, *r.at}}
        if margin.xreplace(on) == 0 and _admissible(r, on):
            yield on
    still = {symbol(name): Integer(0) for name in ("l", "pi3_0", "omega3_0")}
    for values in islice(r.points([margin]), 5):
        on = values | {s: x for s, x in still.items() if s in values}
        for s in sorted(margin.free_symbols - still.keys(), key=str):
            left = margin.subs({x: v for x, v in on.items() if x != s})
            slope = left.diff(s)
            if slope and not slope.has(s) and s not in K:
                there = on | {s: s - left / slope}
                there[s] = there[s].expand()
                if _admissible(r, there):
                    yield there


def _next(r: Reading, on: Values) -> Iterator[Values]:
    """Yield a third derivative of an unspecified U of either sign, at E1 and E2.

    It decides if the first two derivatives do not.
    """
    d2U, d3U = symbol("d2U"), symbol("d3U")
    family = FAMILIES.get(r.scene.equilibrium.label) if r.scene.equilibrium else None
    if d2U in on and family and family.pole != 0:
        yield from (on | {d3U: s * (2 * abs(on[d2U]) + 1)} for s in (1, -1))


def _double(r: Reading, margin: Expr, s: Symbol, on: Values) -> Iterator[Values]:
    """Yield points of the boundary where the necessary condition is at equality too.

    There are some if its margin is a square along the boundary.
    """
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


def _flat(r: Reading, on: Values) -> Values:
    """Return the third derivative of U at a tilt with which g's vanishes, so that the fourth decides."""
    dU, d2U, d3U, k3 = map(symbol, ("dU", "d2U", "d3U", "k3"))
    if not r.scene.equilibrium or r.scene.equilibrium.label != E3.label or not {d2U, k3} <= on.keys():
        return {}
    return {d3U: (6 * on[k3] * on[d2U] + 6 * r.finish(dU).subs(on)) / (1 - on[k3] ** 2)}
