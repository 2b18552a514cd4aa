"""Repeats a recorded computation over arrays of points, in doubles or in balls about doubles."""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from .ball_arrays import PRODUCT, QUOTIENT, SUM, TINY, BallArray, near

TOGETHER = 2**12                                       # points, of which some hundred steps fit a cache
ROUNDINGS = 2**20                                      # the most that a radius may have behind it
NEARER, OUTWARD = 1 + 2.0**-32, 1 + 2.0**-31           # more than those roundings can take from a radius
Step = tuple[Any, ...]                                 # the operation, and its arguments


@dataclass(frozen=True)
class Computation:
    """Steps in order, and the places of the results.

    Parameters
    ----------
    steps : tuple
        ("leaf", name), ("constant", double, whether it is exact), or an operation and the places of what it
        takes: "add", "subtract", "multiply", "inverse"
    results : tuple of int

    Examples
    --------
    >>> from gyrostat.charts.signs.recorded import Recording
    >>> from sympy import Symbol
    >>> recording, x = Recording(), Symbol("x")
    >>> number = recording.leaf(x)
    >>> program = recording.computation([1 / (number**2 - 2)])
    >>> program.doubles({x: np.array([2.0, 1.0])})[0].tolist()
    [0.5, -1.0]
    >>> program.balls({x: BallArray(np.array([2.0, 1.0]))}, 2)[0].sign().tolist()
    [1, -1]
    """

    steps: tuple[Step, ...]
    results: tuple[int, ...]

    @cached_property
    def leaves(self) -> frozenset[Expr]:
        """The names that are read."""
        return frozenset(step[1] for step in self.steps if step[0] == "leaf")

    @cached_property
    def deep(self) -> bool:
        """Whether more roundings may be behind a radius than OUTWARD covers."""
        return _roundings(self.steps) > ROUNDINGS

    def doubles(self, leaves: Mapping[Expr, Array]) -> list[Array]:
        """Return the results in doubles, without any bound of their error."""
        return self._repeated(leaves, lambda value, exact: np.float64(value), np.reciprocal)

    def _repeated(self, leaves: Mapping[Expr, Any], constant: Callable[[float, bool], Any],
                  inverse: Callable[[Any], Any]) -> list[Any]:
        values: list[Any] = []
        for operation, *given in self.steps:
            if operation == "leaf":
                values.append(leaves[given[0]])
            elif operation == "constant":
                values.append(constant(*given))
            elif operation == "inverse":
                values.append(inverse(values[given[0]]))
            else:
                a, b = values[given[0]], values[given[1]]
                values.append(a + b if operation == "add" else a - b if operation == "subtract" else a * b)
        return [values[place] for place in self.results]

    def balls(self, leaves: Mapping[Expr, BallArray], count: int) -> list[BallArray]:
        """Return the results over so many points, enclosed; leaves have one number or as many."""
        found = [BallArray(np.empty(count), np.empty(count)) for _ in self.results]
        for start in range(0, count, TOGETHER):
            part = slice(start, start + TOGETHER)
            here = {name: _part(leaves[name], part) for name in self.leaves}
            try:
                if self.deep:
                    raise FloatingPointError
                with np.errstate(all="ignore", under="raise"):
                    results = self._in_place(here, min(count - start, TOGETHER))
            except FloatingPointError:                     # underflow, which the bounds in place leave out
                balls = self._repeated({name: BallArray(*ball) for name, ball in here.items()},
                                       lambda value, exact: near(np.float64(value), exact), BallArray.inverse)
                results = [(ball.middle, ball.radius) for ball in balls]
            for whole, (middle, radius) in zip(found, results):
                whole.middle[part], whole.radius[part] = middle, radius
        return found

    def _in_place(self, leaves: Mapping[Expr, tuple[Any, Any]], count: int) -> list[tuple[Any, Any]]:
        """Return middles and radii; an array whose step is not read again is used for another one.

        The bounds are those of BallArray, without what underflow adds. A radius is
        rounded less than ROUNDINGS times, and is made larger at the end.
        """
        reader = {place: n for n, (operation, *given) in enumerate(self.steps)
                  if operation not in ("leaf", "constant") for place in given}
        reader |= dict.fromkeys(self.results, -1)
        balls: dict[int, tuple[Any, Any]] = {}
        free: list[Array] = []
        for n, (operation, *given) in enumerate(self.steps):
            if operation == "leaf":
                balls[n] = leaves[given[0]]
                continue
            if operation == "constant":
                value, exact = given
                balls[n] = np.float64(value), np.float64(0 if exact else abs(value) * SUM + TINY)
                continue
            numbers = [balls[place] for place in given]
            if any(np.ndim(middle) for middle, _ in numbers):
                spare = [free.pop() if free else np.empty(count) for _ in range(3)]
                free.append(spare[2])
            else:                                          # the same at all points
                spare = [np.empty(()) for _ in range(3)]
            balls[n] = _done(operation, numbers, *spare)
            for place in {*given}:
                if reader[place] == n and self.steps[place][0] not in ("leaf", "constant"):
                    free += [array for array in balls.pop(place) if np.ndim(array)]
        return [(balls[place][0], balls[place][1] * OUTWARD) for place in self.results]


def _done(operation: str, numbers: Sequence[tuple[Any, Any]], middle: Array, radius: Array,
          spare: Array) -> tuple[Any, Any]:
    """Return the ball of one operation, written to two arrays, with a third for what is between."""
    (one, close), (two, far) = numbers[0], numbers[-1]
    if operation == "inverse":
        middle, size = np.divide(1, one, out=middle), np.abs(one)
        apart = size - close * NEARER
        error = close / (size * apart) + abs(middle) * QUOTIENT
        return middle, np.where(apart > 0, error, np.inf)
    if operation == "multiply":
        middle = np.multiply(one, two, out=middle)
        radius = np.multiply(np.abs(middle, out=radius), PRODUCT, out=radius)
        for factor, error, other in ((one, far, 0.0), (two, close, far)):
            if np.ndim(error) or error:
                spare = np.add(np.abs(factor, out=spare), other, out=spare)
                radius = np.add(radius, np.multiply(spare, error, out=spare), out=radius)
        return middle, radius
    middle = (np.add if operation == "add" else np.subtract)(one, two, out=middle)
    radius = np.multiply(np.abs(middle, out=radius), SUM, out=radius)
    for error in (close, far):
        if np.ndim(error) or error:
            radius = np.add(radius, error, out=radius)
    return middle, radius


def _part(ball: BallArray, part: slice) -> tuple[Any, Any]:
    """Return the middles and radii of some points, one number if all points have the same, 0 if exact."""
    middle, radius = (x.reshape(()) if x.size == 1 else x[part] for x in (ball.middle, ball.radius))
    return middle, radius if radius.any() else np.float64(0)


def _roundings(steps: Sequence[Step]) -> int:
    """Return how many roundings at most make a radius smaller."""
    counts: list[int] = []
    for operation, *given in steps:
        own = [counts[place] for place in given] if operation not in ("leaf", "constant") else [0]
        counts.append(sum(own) + 8 if operation == "multiply" else max(own) + 8)
    return max(counts)
