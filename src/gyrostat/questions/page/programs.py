"""Writes programs in doubles that the page runs itself: margins, equations of motion, a state.

A program is a list of instructions on the results of earlier ones, which a page runs without evaluating any
text: ["add", 0, 1], ["name", "I1"], ["number", 0.5], ["power", 3, 0.5], ["exp", 4].
"""
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import isfinite
from typing import Any

from sympy import Expr, NumberSymbol, Pow, Rational, Symbol, exp, log

from ...algebra.text.numbers import exact_number, shown
from ...charts.programs.straightline import Axes, program_of
from ...errors import GyrostatError, ScopeError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.unit_vectors import in_any_direction
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.conditions import Criterion
from ...stability.report.report import Report

Data = dict[str, Any]
ONE = "a picture is of one equilibrium: choose one"


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


def doubles(values: Mapping[str, str]) -> Data:
    """The doubles nearest to values, for sliders and pictures; of those that have one.

    Parameters
    ----------
    values : mapping of str to str
        as they are typed

    Returns
    -------
    dict
    """
    exact = {name: float(exact_number(text, name)) for name, text in values.items()}
    return {name: double for name, double in exact.items() if isfinite(double)}


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
        report = report.written_out
        _refuse(report, axes)
        writer = Writer({symbol(name): frozenset({n}) for n, name in enumerate(axes)})
        found = {"positive": [writer.write(e) for e in demands(report)],
                 "sufficient": _criterion(report.sufficient, writer),
                 "necessary": _criterion(report.necessary, writer)}
    except GyrostatError as error:
        return {"why": str(error)}
    return {"steps": _steps(writer), "names": _names(writer), **found}


def moving(scene: System, eq: Equilibrium | None) -> Data:
    """The equations of motion, the state of the equilibrium, and what a picture of the body needs.

    Parameters
    ----------
    scene : System
    eq : Equilibrium or None
        None if no equilibrium is chosen: then the body alone is given

    Returns
    -------
    dict
        inertia (I11, I22, I33, I23, I31, I12) and rotor; coordinates, state and velocity, ω in the frame in
        which the directions are constant; rates, or why the page follows no motion. Each is a program with
        steps, names and results; names has the numbers of all
    """
    found: Data = {}
    try:
        tensor = scene.body.tensor
        found["inertia"] = steps_to(tensor[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)))
        found["rotor"] = steps_to(scene.body.gyrostatic_momentum)
        if eq is None:
            raise ScopeError(ONE)
        state = steps_to(map(eq.insert, eq.point))       # a name of it may be that of a coordinate
        found |= {"coordinates": [x.name for x in scene.space.coordinates], "state": state,
                  "velocity": steps_to(scene.energy_gradient.flat()[:3])}
        if scene.unspecified:
            raise ScopeError("a motion needs a field that is given: type U as an expression, such as m0*k3")
        found["rates"] = steps_to(scene.vector_field())
    except GyrostatError as error:
        found["why"] = str(error)
    coordinates = found.get("coordinates", ())
    return {**found, "names": list(dict.fromkeys(
        name for key in ("state", "rates", "inertia", "rotor") for name in found.get(key, {}).get("names", ())
        if key == "state" or name not in coordinates))}


def steps_to(expressions: Iterable[Expr]) -> Data:
    """The instructions that lead to some results."""
    writer = Writer({})
    results = [writer.write(e) for e in expressions]
    return {"steps": _steps(writer), "names": _names(writer), "results": results}


def _refuse(report: Report, axes: Sequence[str]) -> None:
    """Refuse a chart whose axes are not two free names."""
    if len(report.required) < 2:
        needed = f"{report.required[0]} alone" if report.required else "no further number"
        raise ScopeError(f"a chart is over two numbers, and a verdict here needs {needed}: write a letter in "
                         "the place of a number that is given")
    margins = [*expressions(report.sufficient), *expressions(report.necessary)]
    names = {s.name for e in margins for s in e.free_symbols}
    if axes[0] == axes[1]:
        raise ScopeError("a chart has two different names")
    if in_any_direction(report.equilibrium):
        raise ScopeError("no chart of k1, k2, k3, which are bound to each other: write stereographic as the "
                         "direction, and k is any unit vector by two numbers, u1 and u2")
    if report.equilibrium.constraints or not names <= set(report.required):
        raise ScopeError("no chart here: the numbers of this equilibrium are bound to each other, or its "
                         "conditions are of what is made of them")
    if strange := [name for name in axes if name not in report.required]:
        raise ScopeError(f"{strange[0]} has no axis: a verdict here does not need it")


def demands(report: Report) -> tuple[Expr, ...]:
    """What is positive where the equilibrium exists."""
    return report.equilibrium.existence()


def expressions(criterion: Criterion) -> Iterator[Expr]:
    """The margins of a criterion and their even factors."""
    for alternative in criterion.alternatives:
        for condition in alternative:
            yield from (condition.margin, *condition.degenerate)


def _criterion(criterion: Criterion, writer: Writer) -> list[list[Data]]:
    """Alternatives of conditions, each a margin, whether it is strict, and its even factors."""
    return [[{"margin": writer.write(c.margin), "strict": c.strict,
              "degenerate": [writer.write(e) for e in c.degenerate]} for c in alternative]
            for alternative in criterion.alternatives]


def _steps(writer: Writer) -> list[list[Any]]:
    return [list(step) for step in writer.places]


def _names(writer: Writer) -> list[str]:
    return [name for operation, *(name,) in (s[:2] for s in writer.places) if operation == "name"]
