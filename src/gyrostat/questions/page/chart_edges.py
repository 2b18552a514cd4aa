"""Computes the boundary of a chart: the real zeros of exact margins along its columns and rows."""
from collections.abc import Mapping, Sequence

from flint import fmpq, fmpq_poly
from sympy import Expr, Symbol

from ...algebra.reals.exact import compiled
from ...algebra.text.numbers import exact_number
from ...notation import symbol
from ...stability.criteria.truth import Relation, truth
from ...stability.report.report import Report
from .programs import Data, demands, expressions

LINES = 64                                             # each way


def edges(report: Report, values: Mapping[str, str], axes: Sequence[str],
          ends: Sequence[Sequence[str]]) -> Data:
    """Where the verdict changes along some columns and rows of a chart: the real zeros of the margins there.

    Parameters
    ----------
    report : Report
    values : mapping of str to str
    axes : sequence of str
        the name across, and that upwards
    ends : sequence of two pairs of str
        from where to where

    Returns
    -------
    dict
        points, pairs of double; none where a margin is no polynomial with rational numbers
    """
    report = report.written_out
    margins = dict.fromkeys((*demands(report), *expressions(report.sufficient),
                             *expressions(report.necessary)))
    numbers = {symbol(name): exact_number(text, name) for name, text in values.items() if name not in axes}
    known = [margin.xreplace(numbers) for margin in margins]
    across, upwards = ([_rational(exact_number(end, name)) for end in pair] for name, pair in zip(axes, ends))
    x, y = map(symbol, axes)
    columns = _along(report, dict(zip(margins, (_plane(margin, x, y) for margin in known))), across, upwards)
    rows = _along(report, dict(zip(margins, (_plane(margin, y, x) for margin in known))), upwards, across)
    return {"points": [*columns, *([x, y] for y, x in rows)]}


def _along(report: Report, planes: Mapping[Expr, list[fmpq_poly] | None], ends: Sequence[fmpq],
           within: Sequence[fmpq]) -> list[list[float]]:
    """The points on lines of one name, which comes first; none if a margin is no polynomial."""
    if None in planes.values():
        return []
    first, last = ends
    points = []
    for n in range(LINES):
        x = first + (last - first) * fmpq(2 * n + 1, 2 * LINES)
        line = {margin: fmpq_poly([p(x) for p in plane or ()]) for margin, plane in planes.items()}
        points += [[_near(x), y] for y in _changes(report, line, *within)]
    return points


def _changes(report: Report, line: Mapping[Expr, fmpq_poly], low: fmpq, high: fmpq) -> list[float]:
    """The zeros between which the criteria do not say the same."""
    zeros = sorted({float(root.real.mid()) for p in line.values() if p.degree() > 0
                    for root, _ in p.complex_roots() if root.imag == 0 and low < root.real < high})
    between = [_near(low), *zeros, _near(high)]
    said = [_said(report, line, (fmpq(*a.as_integer_ratio()) + fmpq(*b.as_integer_ratio())) / 2)
            for a, b in zip(between, between[1:])]
    return [y for y, below, above in zip(zeros, said, said[1:]) if below != above]


def _said(report: Report, line: Mapping[Expr, fmpq_poly], y: fmpq) -> tuple[bool, ...]:
    """Whether the equilibrium exists, and what the two criteria say."""
    def compare(margin: Expr, relation: Relation) -> bool:
        return bool(relation(line[margin](y), 0))

    return (all(line[e](y) > 0 for e in demands(report)),
            *(truth(criterion, compare, all, any) for criterion in (report.sufficient, report.necessary)))


def _plane(margin: Expr, x: Symbol, y: Symbol) -> list[fmpq_poly] | None:
    """A polynomial in y whose coefficients are polynomials in x; None if it is not one."""
    found = compiled(margin)
    if found is None or found[2] is not None or not set(found[0]) <= {x, y}:
        return None
    generators, polynomial, _ = found
    terms: dict[int, dict[int, fmpq]] = {}
    for powers, coefficient in polynomial.to_dict().items():
        degree = dict(zip(generators, map(int, powers)))
        terms.setdefault(degree.get(y, 0), {})[degree.get(x, 0)] = coefficient
    return [fmpq_poly([powers.get(n, 0) for n in range(max(powers, default=0) + 1)])
            for powers in (terms.get(m, {}) for m in range(max(terms, default=0) + 1))]


def _rational(number: Expr) -> fmpq:
    return fmpq(int(number.p), int(number.q))


def _near(number: fmpq) -> float:
    return int(number.p) / int(number.q)
