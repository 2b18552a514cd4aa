"""Writes margins as straight-line programs: additions and products, in an order that suits a grid.

The order leaves least to do for each point.

References
----------
Bürgisser, Clausen & Shokrollahi, Algebraic Complexity Theory (1997), chapter 4.
"""
import operator
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from types import SimpleNamespace
from typing import Any, Literal, TypeVar

from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol

from ...algebra.rings.readable import readable
from ...notation import symbol

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
    """Steps in order; the last one is the result."""

    steps: tuple[Step, ...]

    @property
    def leaves(self) -> Iterator[Expr]:
        """The symbols and functions that are read."""
        return (step.value for step in self.steps if step.operation == "leaf")

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


def program_of(margin: Expr, axes: Mapping[Symbol, Axes]) -> Program:
    """Return the program of a polynomial in symbols and functions, in the order that suits a grid.

    Squares are completed. Sums and products are taken first among what varies along the fewest axes, so that
    nothing is done again along an axis on which it does not depend; equal parts are computed once. A symbol
    that is not in axes varies along none.
    """
    return _program(margin,
                    tuple(sorted(((s.name, a) for s, a in axes.items() if a), key=lambda pair: pair[0])))


@lru_cache(maxsize=512)
def _program(expression: Expr, axes: tuple[tuple[str, Axes], ...]) -> Program:
    writer = _Writer({symbol(name): along for name, along in axes})
    last, negative = writer.write(readable(expression))
    if negative:
        last = writer.step("negative", (last,))
    used = _used(writer.steps, last)
    place = {old: new for new, old in enumerate(used)}
    kept = [writer.steps[i] for i in used]
    return Program(tuple(Step(s.operation, tuple(place[i] for i in s.arguments), s.value, s.axes)
                         for s in kept))


def _used(steps: Sequence[Step], last: int) -> list[int]:
    needed = {last}
    for i in range(last, -1, -1):
        if i in needed:
            needed.update(steps[i].arguments)
    return sorted(needed)


class _Writer:
    """A program as it is written; a term is a step and whether it counts negatively."""

    def __init__(self, axes: Mapping[Symbol, Axes]):
        self.axes = axes
        self.steps: list[Step] = []
        self.known: dict[Any, int] = {}

    def step(self, operation: Operation, arguments: tuple[int, ...] = (), value: Expr | None = None,
             along: Axes = frozenset()) -> int:
        arguments = tuple(sorted(arguments)) if operation in ("add", "multiply") else arguments
        key = operation, arguments, value
        if key not in self.known:
            self.steps.append(Step(operation, arguments, value,
                                   along.union(*(self.steps[i].axes for i in arguments))))
            self.known[key] = len(self.steps) - 1
        return self.known[key]

    def write(self, node: Expr) -> tuple[int, bool]:
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

    def fold(self, terms: list[tuple[int, bool]], join: Callable[..., tuple[int, bool]]) -> tuple[int, bool]:
        """Join two terms at a time, those that vary along the fewest axes together first."""
        while len(terms) > 1:
            i, j = min(combinations(self._candidates(terms), 2),
                       key=lambda pair: self._together(*(terms[n][0] for n in pair)))
            joined = join(terms[i], terms[j])
            terms = [joined if n == i else term for n, term in enumerate(terms) if n != j]
        return terms[0]

    def _candidates(self, terms: list[tuple[int, bool]]) -> list[int]:
        """Return the first two terms of those that vary along the same axes.

        Any other pair is like one of these.
        """
        count = Counter[Axes]()
        places: list[int] = []
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

    def sum(self, one: tuple[int, bool], other: tuple[int, bool]) -> tuple[int, bool]:
        (a, minus), (b, less) = one, other
        if minus == less:
            return self.step("add", (a, b)), minus
        return self.step("subtract", (b, a) if minus else (a, b)), False

    def product(self, one: tuple[int, bool], other: tuple[int, bool]) -> tuple[int, bool]:
        return self.step("multiply", (one[0], other[0])), one[1] != other[1]

    def power(self, base: int, n: int) -> int:
        if n == 1:
            return base
        half = self.power(base, n // 2)
        square = self.step("multiply", (half, half))
        return self.step("multiply", (square, base)) if n % 2 else square
