"""Traces the real branches of a plane curve F(x, t) = 0 over t, between its vertical tangents.

It is a cylindrical decomposition of the plane: between two roots of the discriminant in x the branches are
graphs over t that do not meet.
"""
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from flint import arb, arb_poly, fmpq_poly
from sympy import Expr, Rational, Symbol, oo

from ...errors import ScopeError
from ..enclosures.balls import ball
from ..enclosures.precision import doubled, own_precision
from ..enclosures.rationals import to_flint
from ..reals.number_fields import in_one
from ..rings.enclosed_roots import divided_by_root
from ..rings.polynomials import by_degree
from .plane_curves import PlaneCurve
from .roots import between, in_order, roots_of_factor, roots_of_polynomial

FINEST, LEAST = 2**13, 1000                            # bits; of the width of a root


class Span(NamedTuple):
    """The part of a strand between two values of t: the n-th real root x there, from below."""

    low: Expr
    high: Expr
    place: int


class Strand(NamedTuple):
    """A branch over its interval of t, and x at its ends; None if t goes to ±∞ there."""

    spans: tuple[Span, ...]
    first: Expr | None
    last: Expr | None


def strands(F: Expr, x: Symbol, t: Symbol, known: Mapping[Expr, Mapping[Expr, bool]]) -> list[Strand]:
    """Return every real branch of F(x, t) = 0 over t, complete.

    The resultant of F and ∂F/∂x is the discriminant times the leading coefficient in x. Between two of its
    real roots t the number of real roots x does not change: one value of t tells it. At a root of it nothing
    happens but what is known, or else a pair of branches begins or ends in each double root x (a fold).

    Parameters
    ----------
    F : Expr
        a polynomial over ℚ without multiple factors
    x, t : Symbol
    known : mapping of t to mapping of x to bool
        the multiple roots there, and whether two branches cross in one with different slopes; they are double
        if t is irrational

    Returns
    -------
    list of Strand

    Raises
    ------
    ScopeError
        branches meet in another way

    Examples
    --------
    >>> from sympy import S
    >>> x, t = Symbol("x"), Symbol("t")
    >>> node, crossing = x**2 - t**2 * (t + 1), {S.Zero: {S.Zero: True}}
    >>> for strand in strands(node, x, t, crossing):
    ...     print(*map(tuple, strand.spans), strand.first, strand.last)
    (-1, 0, 1) (0, oo, 0) 0 None
    (-1, 0, 0) (0, oo, 1) 0 None
    """
    curve = PlaneCurve(F, x, t, ends=())
    special = _where_roots_meet(curve, 0, t)
    double = in_order(_where_roots_meet(curve, 1, x))
    found: list[Strand] = []
    growing: list[tuple[tuple[Span, ...], Expr | None]] = []
    for low, high in pairwise([-oo, *in_order(special), oo]):
        middle, before = between(low, high), len(growing)
        count = len(curve.roots(Fraction(middle)))
        if low == -oo:
            growing = [((), None)] * count
        elif low in known and before == count:
            crossed = _crossed if isinstance(low, Rational) else _crossed_at_irrational
            for n in crossed(curve, low, known[low], before):
                growing[n:n + 2] = growing[n + 1], growing[n]
        else:
            for m, (x0, n) in reversed(list(enumerate(_folds(curve, low, double, abs(before - count) // 2)))):
                if before < count:
                    growing[n:n] = [((), x0)] * 2
                else:
                    found += [Strand(spans, first, x0) for spans, first in growing[n + 2 * m:n + 2 * m + 2]]
                    del growing[n + 2 * m:n + 2 * m + 2]
        growing = [((*spans, Span(low, high, n)), first) for n, (spans, first) in enumerate(growing)]
    return found + [Strand(spans, first, None) for spans, first in growing]


def _where_roots_meet(curve: PlaneCurve, eliminated: int, left: Symbol) -> list[Expr]:
    """Return the real t, or x, of all points at which x is a multiple root, by a resultant."""
    F, name = curve.whole, str(curve.whole.context().names()[curve.place[eliminated]])
    resultant = F.resultant(F.derivative(curve.place[0]), name)
    return roots_of_polynomial(in_one(resultant, curve.ring.generators.index(left)))


def _folds(curve: PlaneCurve, at: Expr, double: Sequence[Expr], count: int) -> list[tuple[Expr, int]]:
    """Return the `count` double roots x at a value of t, and how many simple ones are below each.

    So many pairs of roots begin or end there, each at a multiple root. If balls exclude all candidates but so
    many, these are the multiple roots. Divided by (x − x0)² for each, the polynomial has none of them left:
    they are double.
    """
    for precision in doubled(256, FINEST):
        with own_precision(precision):
            t0 = ball(at, precision)
            parts = [arb_poly(part)(t0) for part in _in_x(curve)]
            whole = arb_poly(parts)
            near = {x0: ball(x0, precision) for x0 in double}
            left = [x0 for x0 in double if whole(near[x0]).contains(0)
                    and whole.derivative()(near[x0]).contains(0)]
            if not left and not count:                     # the roots that meet are complex
                return []
            if len(left) == count:
                for x0 in left:
                    parts = divided_by_root(divided_by_root(parts, near[x0]), near[x0])
                others = _isolated(parts, 2.0 ** -min(precision // 4, LEAST))
                if others is not None and not any(x.overlaps(near[x0]) for x in others for x0 in left):
                    return [(x0, sum(bool(x < near[x0]) for x in others)) for x0 in left]
    raise _untold(curve, at)


def _isolated(parts: Sequence[arb], width: float) -> list[arb] | None:
    """Return the real roots of a polynomial with balls for coefficients; None if they are not so narrow."""
    try:
        return [root.real for root in arb_poly(parts).complex_roots(tol=width) if root.imag.contains(0)]
    except ValueError:
        return None


def _untold(curve: PlaneCurve, at: Expr) -> ScopeError:
    return ScopeError(f"at {curve.t} = {at} several branches meet, and it is not decided which continues "
                      "which: change a number a little")


def _crossed(curve: PlaneCurve, at: Rational, known: Mapping[Expr, bool], count: int) -> list[int]:
    """Return how many roots are below each pair that crosses at a value of t; no others may meet there."""
    _, factors = fmpq_poly([part(to_flint(at)) for part in _in_x(curve)]).factor()
    orders = {root: order for factor, order in factors for root in roots_of_factor(factor)}
    below, found = 0, []
    for root in in_order(list(orders)):
        if known.get(root):
            found.append(below)
        below += 2 if known.get(root) else orders[root] % 2
    if below != count or any(order > 1 and root not in known for root, order in orders.items()):
        raise _untold(curve, at)
    return found


def _crossed_at_irrational(curve: PlaneCurve, at: Expr, known: Mapping[Expr, bool], count: int) -> list[int]:
    """Return the same at an irrational t, where all the known roots are double."""
    below, found = 0, []
    for x0, simple in _folds(curve, at, list(known), len(known)):
        crossing = known[x0]
        if crossing:
            found.append(simple + below)
        below += 2 if crossing else 0
    return found


def _in_x(curve: PlaneCurve) -> list[fmpq_poly]:
    """Return the coefficients of the powers of x, as polynomials in t."""
    x, t = curve.place
    return [in_one(part, t) for part in by_degree(curve.whole, x, curve.degree(curve.whole, 0))]
