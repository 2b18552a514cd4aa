"""Writes margins as straight-line programs: additions and products, in an order that suits a grid.

The order leaves least to do for each point.

References
----------
Bürgisser, Clausen & Shokrollahi, Algebraic Complexity Theory (1997), chapter 4.
"""
import operator
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from math import prod
from types import SimpleNamespace
from typing import Any, Literal, Protocol, TypeVar

from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol

from ..._cached import cached_property
from ...algebra.enclosures.arithmetic import Arithmetic, in_arithmetic
from ...algebra.rings.readable import readable
from ...notation import symbol
from .quotients import Quotient, Term, quotient

Axes = frozenset[int]
Operation = Literal["leaf", "constant", "add", "subtract", "multiply", "negative"]
Value = TypeVar("Value")
OPERATORS = SimpleNamespace(add=operator.add, subtract=operator.sub, multiply=operator.mul,
                            negative=operator.neg)


@dataclass(frozen=True)
class Step:
    """One operation on the results of earlier steps.

    Parameters
    ----------
    operation : str
        one of Operation; a leaf is a symbol, or a function or constant that is no polynomial
    arguments : tuple of int
        the earlier steps whose results it takes
    value : Expr or None
        the leaf, or the rational constant
    axes : frozenset of int
        the axes of the grid along which the result varies
    """

    operation: Operation
    arguments: tuple[int, ...]
    value: Expr | None
    axes: Axes


@dataclass(frozen=True)
class Program:
    """Steps in order, and which of them are the results; by default the last one is the only result."""

    steps: tuple[Step, ...]
    results: tuple[int, ...] = (-1,)

    @property
    def leaves(self) -> Iterator[Expr]:
        """The symbols and functions that are read."""
        return (step.value for step in self.steps if step.operation == "leaf")

    @property
    def outcomes(self) -> list[int]:
        """The places of the results."""
        return [place % len(self.steps) for place in self.results]

    @cached_property
    def kept(self) -> dict[Any, Any]:
        """What was derived of the program for the axes of a grid: programs outlive a call."""
        return {}

    def needed(self, results: Iterable[int]) -> set[int]:
        """Return the steps that some steps need, themselves included."""
        found = {*results}
        for i in range(len(self.steps) - 1, -1, -1):
            if i in found:
                found.update(self.steps[i].arguments)
        return found

    def run(self, leaf: Callable[[Expr], Value], constant: Callable[[Rational], Value],
            arithmetic: Any = OPERATORS) -> list[Value]:
        """Return the results of all steps, in any arithmetic that has add, subtract, multiply and negative.

        By default it is that of Python's operators. The last result is the program's.

        Examples
        --------
        >>> import gyrostat as gs
        >>> from fractions import Fraction
        >>> program = program_of(gs.symbol("x")**3 - 2, {})
        >>> program.run(lambda _: Fraction(3, 2), int)[-1]
        Fraction(11, 8)
        """
        results: list[Value] = []
        for step in self.steps:
            if step.operation == "leaf":
                results.append(leaf(step.value))
            elif step.operation == "constant":
                results.append(constant(step.value))
            else:
                results.append(getattr(arithmetic, step.operation)(*(results[i] for i in step.arguments)))
        return results


class Named(Protocol):
    """Numbers that have names, and are computed from names of the scene in any arithmetic."""

    def values(self, number: Callable[[Expr], Any]) -> Mapping[Symbol, Any]:
        """Return the numbers by name, if number gives those of the scene in the arithmetic."""

    def __hash__(self) -> int:
        """Programs are kept by it."""


def program_of(margin: Expr, axes: Mapping[Symbol, Axes], named: Named | None = None) -> Program:
    """Return the program of a polynomial in symbols and functions, in the order that suits a grid.

    Squares are completed. Sums and products are taken first among what varies along the fewest axes, so that
    nothing is done again along an axis on which it does not depend; equal parts are computed once. A symbol
    that is not in axes varies along none. If some of the symbols are named numbers, the program is that of
    another number of the same sign, without their denominators.
    """
    return programs_of((margin,), axes, named)


def programs_of(margins: tuple[Expr, ...], axes: Mapping[Symbol, Axes],
                named: Named | None = None) -> Program:
    """Return one program with a result for each margin; what they have in common is computed once."""
    varying = sorted(((s.name, a) for s, a in axes.items() if a), key=lambda pair: pair[0])
    return _program(margins, tuple(varying), named)


@lru_cache(maxsize=512)
def _program(expressions: tuple[Expr, ...], axes: tuple[tuple[str, Axes], ...],
             named: Named | None) -> Program:
    writer = Writer({symbol(name): along for name, along in axes})
    numbers = {} if named is None else named.values(lambda e: quotient(e, writer))
    results = [writer.result(readable(e) if e.free_symbols.isdisjoint(numbers) else
                             _of_numbers(e, numbers, writer)) for e in expressions]
    used = sorted(Program(tuple(writer.steps)).needed(results))
    place = {old: new for new, old in enumerate(used)}
    kept = [writer.steps[i] for i in used]
    return Program(tuple(Step(s.operation, tuple(place[i] for i in s.arguments), s.value, s.axes)
                         for s in kept), tuple(place[i] for i in results))


def _of_numbers(expression: Expr, numbers: Mapping[Symbol, Any], writer: "Writer") -> Any:
    """Return a polynomial in named numbers, by these numbers."""
    def leaf(node: Expr) -> Any:
        if node in numbers:
            return numbers[node]
        return NotImplemented if node.free_symbols & numbers.keys() else quotient(node, writer)

    def power(base: Any, exponent: Rational) -> Any:
        return base**int(exponent) if exponent.is_Integer and exponent > 0 else refused()

    def refused(*given: Any) -> Any:
        raise TypeError(f"{expression} is no polynomial in named numbers")

    return in_arithmetic(expression, Arithmetic(leaf, sum, prod, power, refused))


class Writer:
    """A program as it is written; a term is a step and whether it counts negatively."""

    def __init__(self, axes: Mapping[Symbol, Axes]):
        self.axes = axes
        self.steps: list[Step] = []
        self.known: dict[Any, int] = {}
        self.positive: set[int] = set()                # steps that are positive wherever a sign is asked

    def step(self, operation: Operation, arguments: tuple[int, ...] = (), value: Expr | None = None,
             along: Axes = frozenset()) -> int:
        arguments = tuple(sorted(arguments)) if operation in ("add", "multiply") else arguments
        key = operation, arguments, value
        if key not in self.known:
            self.steps.append(Step(operation, arguments, value,
                                   along.union(*(self.steps[i].axes for i in arguments))))
            self.known[key] = len(self.steps) - 1
        return self.known[key]

    def result(self, value: Any) -> int:
        """Return the step of an expression, or one that has the sign of a number."""
        last, negative = (value.signed() if isinstance(value, Quotient) else
                          self.write(value if isinstance(value, Expr) else Rational(value)))
        return self.step("negative", (last,)) if negative else last

    def write(self, node: Expr) -> Term:
        if isinstance(node, Rational):
            return self.step("constant", value=abs(node)), bool(node < 0)
        if isinstance(node, Add):
            return self.fold([self.write(part) for part in node.args], self.sum)
        if isinstance(node, Mul):
            turned = node.args[0] == -1
            last, negative = self.fold([self.write(part) for part in node.args[turned:]], self.product)
            return last, negative != turned
        if isinstance(node, Pow) and isinstance(node.exp, Integer) and node.exp > 1:
            base, negative = self.write(node.base)
            return self.power(base, int(node.exp)), negative and bool(node.exp % 2)
        along = frozenset().union(*(self.axes.get(s, frozenset()) for s in node.free_symbols))
        return self.step("leaf", value=node, along=along), False

    def fold(self, terms: list[Term], join: Callable[..., Term]) -> Term:
        """Join two terms at a time, those that vary along the fewest axes together first."""
        while len(terms) > 1:
            i, j = min(combinations(self._candidates(terms), 2),
                       key=lambda pair: self._together(*(terms[n][0] for n in pair)))
            joined = join(terms[i], terms[j])
            terms = [joined if n == i else term for n, term in enumerate(terms) if n != j]
        return terms[0]

    def _candidates(self, terms: list[Term]) -> list[int]:
        """Return the first two terms of those that vary along the same axes.

        Any other pair is like one of these.
        """
        count, places = Counter[Axes](), list[int]()
        for n, (term, _) in enumerate(terms):
            along = self.steps[term].axes
            count[along] += 1
            if count[along] <= 2:
                places.append(n)
        return places

    def _together(self, a: int, b: int) -> tuple[int, int]:
        # few axes are worth most: such a step is done once for a row or a column; then many in common
        one, other = self.steps[a].axes, self.steps[b].axes
        return len(one | other), -len(one & other)

    def sum(self, one: Term, other: Term) -> Term:
        (a, minus), (b, less) = one, other
        if minus == less:
            return self.step("add", (a, b)), minus
        return self.step("subtract", (b, a) if minus else (a, b)), False

    def product(self, one: Term, other: Term) -> Term:
        return self.step("multiply", (one[0], other[0])), one[1] != other[1]

    def power(self, base: int, n: int) -> int:
        if n == 1:
            return base
        half = self.power(base, n // 2)
        square = self.step("multiply", (half, half))
        return self.step("multiply", (square, base)) if n % 2 else square
