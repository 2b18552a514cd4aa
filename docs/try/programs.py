"""What the page computes itself, in doubles: programs of the margins, of the equations of motion, of a state.

A program is a list of instructions on the results of earlier ones, which a page runs without evaluating any
text: ["add", 0, 1], ["name", "I1"], ["number", 0.5], ["power", 3, 0.5], ["exp", 4].
"""
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from flint import fmpq, fmpq_poly
from sympy import Expr, NumberSymbol, Pow, Rational, Symbol, exp, log

from gyrostat.algebra.exact import compiled
from gyrostat.algebra.numbers import exact_number, shown
from gyrostat.charts.straightline import Axes, program_of
from gyrostat.errors import GyrostatError, ScopeError
from gyrostat.mechanics.directions import in_any_direction
from gyrostat.notation import symbol
from gyrostat.stability.conditions import Criterion
from gyrostat.stability.report import Report
from gyrostat.stability.truth import Relation, truth

COLUMNS = 96

Data = dict[str, Any]


class Writer:
    """Instructions as they are written, each once; the arithmetic that Program.run asks for."""

    def __init__(self, axes: Mapping[Symbol, Axes]):
        self.axes = axes
        self.places: dict[tuple[Any, ...], int] = {}

    def write(self, expression: Expr) -> int:
        """The place of its value."""
        return program_of(expression, self.axes).run(self.leaf, self.number, self)[-1]

    def leaf(self, leaf: Expr) -> int:
        """What is no polynomial."""
        if isinstance(leaf, Symbol):
            return self._place("name", leaf.name)
        if isinstance(leaf, NumberSymbol):
            return self._place("number", float(leaf))
        if isinstance(leaf, Pow) and isinstance(leaf.exp, Rational):
            if not leaf.exp.is_integer:
                return self._place("power", self.write(leaf.base), float(leaf.exp))
            return self._place("divide", self.number(Rational(1)), self.write(leaf.base**-leaf.exp))
        if isinstance(leaf, Pow):
            return self.write(exp(leaf.exp * log(leaf.base), evaluate=False))
        return self._place(leaf.func.__name__, self.write(leaf.args[0]))     # a function of the grammar

    def number(self, value: Rational) -> int:
        """A constant."""
        try:
            return self._place("number", int(value.p) / int(value.q))
        except OverflowError:
            raise ScopeError(f"{shown(value)} is larger than any double, and pictures are computed in "
                             "doubles: write it in other units; the verdict is not concerned") from None

    def add(self, a: int, b: int) -> int:
        """A sum."""
        return self._place("add", a, b)

    def subtract(self, a: int, b: int) -> int:
        """A difference."""
        return self._place("subtract", a, b)

    def multiply(self, a: int, b: int) -> int:
        """A product."""
        return self._place("multiply", a, b)

    def negative(self, a: int) -> int:
        """The opposite."""
        return self._place("negative", a)

    def _place(self, *step: Any) -> int:
        return self.places.setdefault(step, len(self.places))


def charted(report: Report, axes: Sequence[str]) -> Data:
    """What decides in the plane of two names: what must be positive, the two criteria, the names of all.

    Parameters
    ----------
    report : Report
    axes : sequence of str
        the two names

    Returns
    -------
    dict
        steps, names, positive, sufficient, necessary; or why the page draws nothing
    """
    try:
        _refuse(report, axes)
        writer = Writer({symbol(name): frozenset({n}) for n, name in enumerate(axes)})
        found = {"positive": [writer.write(e) for e in _demands(report)],
                 "sufficient": _criterion(report.sufficient, writer),
                 "necessary": _criterion(report.necessary, writer)}
    except GyrostatError as error:
        return {"why": str(error)}
    return {"steps": list(writer.places), "names": _names(writer), **found}


def moving(report: Report) -> Data:
    """The equations of motion and the state of the equilibrium.

    Returns
    -------
    dict
        coordinates, rates and state, each with steps, names and results, and the names of numbers; or
        error, why the page follows no motion
    """
    eq = report.equilibrium
    coordinates = [x.name for x in eq.system.space.coordinates]
    try:
        if eq.system.potential is not None and not eq.system.potential.given:
            raise ScopeError("a motion needs a field that is given: type U as an expression, such as m0*k3")
        rates = steps_to(eq.system.vector_field())
        state = steps_to(map(eq.insert, eq.point))       # a name of it may be that of a coordinate
    except GyrostatError as error:
        return {"why": str(error)}
    names = dict.fromkeys([*state["names"], *(n for n in rates["names"] if n not in coordinates)])
    return {"coordinates": coordinates, "rates": rates, "state": state, "names": list(names)}


def steps_to(expressions: Iterable[Expr]) -> Data:
    """The steps to some results."""
    writer = Writer({})
    results = [writer.write(e) for e in expressions]
    return {"steps": list(writer.places), "names": _names(writer), "results": results}


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
    margins = dict.fromkeys((*_demands(report), *_expressions(report.sufficient),
                             *_expressions(report.necessary)))
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

    return (all(column[e](y) > 0 for e in _demands(report)),
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


def _refuse(report: Report, axes: Sequence[str]) -> None:
    """Refuse what is no chart of free names."""
    margins = [*_expressions(report.sufficient), *_expressions(report.necessary)]
    names = {s.name for e in margins for s in e.free_symbols}
    if in_any_direction(report.equilibrium):
        raise ScopeError("no chart of k1, k2, k3, which are bound to each other: write stereographic as the "
                         "direction, and k is any unit vector by two numbers, u1 and u2")
    if report.equilibrium.constraints or not names <= set(report.required):
        raise ScopeError("no chart here: the numbers of this equilibrium are bound to each other, or its "
                         "conditions are of what is made of them")
    if strange := [name for name in axes if name not in report.required]:
        raise ScopeError(f"{strange[0]} has no axis: a verdict here does not need it")


def _demands(report: Report) -> tuple[Expr, ...]:
    """What is positive where the equilibrium exists."""
    return report.equilibrium.existence()


def _expressions(criterion: Criterion) -> Iterator[Expr]:
    for alternative in criterion.alternatives:
        for condition in alternative:
            yield from (condition.margin, *condition.degenerate)


def _criterion(criterion: Criterion, writer: Writer) -> list[list[Data]]:
    """Alternatives of conditions, each a margin, whether it is strict, and its even factors."""
    return [[{"margin": writer.write(c.margin), "strict": c.strict,
              "degenerate": [writer.write(e) for e in c.degenerate]} for c in alternative]
            for alternative in criterion.alternatives]


def _names(writer: Writer) -> list[str]:
    return [name for operation, *(name,) in (s[:2] for s in writer.places) if operation == "name"]


def _rational(number: Expr) -> fmpq:
    return fmpq(int(number.p), int(number.q))


def _near(number: fmpq) -> float:
    return int(number.p) / int(number.q)
