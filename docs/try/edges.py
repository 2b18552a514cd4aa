"""The boundary of a chart: the real zeros of its margins, column by column, in exact polynomials."""
from collections.abc import Mapping, Sequence

from flint import fmpq, fmpq_poly
from programs import Data, demands, expressions
from sympy import Expr, Symbol

from gyrostat.algebra.exact import compiled
from gyrostat.algebra.numbers import exact_number
from gyrostat.notation import symbol
from gyrostat.stability.report import Report
from gyrostat.stability.truth import Relation, truth

COLUMNS = 96


def edges(report: Report, values: Mapping[str, str], axes: Sequence[str],
          ends: Sequence[Sequence[str]]) -> Data:
    """Where the verdict changes in some columns of a chart: the real zeros of the margins along each.

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
    margins = dict.fromkeys((*demands(report), *expressions(report.sufficient),
                             *expressions(report.necessary)))
    numbers = {symbol(name): exact_number(text, name) for name, text in values.items() if name not in axes}
    planes = {margin: _plane(margin.xreplace(numbers), *map(symbol, axes)) for margin in margins}
    if None in planes.values():
        return {"points": []}
    (left, right), (low, high) = ([_rational(exact_number(end, "end")) for end in pair] for pair in ends)
    points = []
    for n in range(COLUMNS):
        x = left + (right - left) * fmpq(2 * n + 1, 2 * COLUMNS)
        column = {margin: fmpq_poly([p(x) for p in plane]) for margin, plane in planes.items()}
        points += [[_near(x), y] for y in _changes(report, column, low, high)]
    return {"points": points}


def _changes(report: Report, column: Mapping[Expr, fmpq_poly], low: fmpq, high: fmpq) -> list[float]:
    """The zeros between which the criteria do not say the same."""
    zeros = sorted({float(root.real.mid()) for p in column.values() if p.degree() > 0
                    for root, _ in p.complex_roots() if root.imag == 0 and low < root.real < high})
    between = [_near(low), *zeros, _near(high)]
    said = [_said(report, column, (fmpq(*a.as_integer_ratio()) + fmpq(*b.as_integer_ratio())) / 2)
            for a, b in zip(between, between[1:])]
    return [y for y, below, above in zip(zeros, said, said[1:]) if below != above]


def _said(report: Report, column: Mapping[Expr, fmpq_poly], y: fmpq) -> tuple[bool, ...]:
    """Whether the equilibrium exists, and what the two criteria say."""
    def compare(margin: Expr, relation: Relation) -> bool:
        return bool(relation(column[margin](y), 0))

    return (all(column[e](y) > 0 for e in demands(report)),
            *(truth(criterion, compare, all, any) for criterion in (report.sufficient, report.necessary)))


def _plane(margin: Expr, x: Symbol, y: Symbol) -> list[fmpq_poly] | None:
    """A polynomial in y whose coefficients are polynomials in x; None where it is none."""
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
