"""Records a computation: numbers that write down, step by step, what is done with them.

Parts that are equal are recorded once, and constants are computed as fractions.
"""
from collections.abc import Sequence
from typing import Any

from flint import fmpq
from sympy import Expr

from .computation import Computation, Step


class Recording:
    """The steps of a computation, as it is recorded."""

    def __init__(self) -> None:
        self.steps: list[Step] = []
        self.known: dict[Step, int] = {}

    def step(self, *step: Any) -> "Recorded":
        """Return the result of a step, which is recorded if it is new."""
        if step not in self.known:
            self.known[step] = len(self.steps)
            self.steps.append(step)
        return Recorded(self, self.known[step])

    def leaf(self, name: Expr) -> "Recorded":
        """Return a number that is given when the computation is repeated."""
        return self.step("leaf", name)

    def constant(self, value: Any) -> "Recorded":
        """Return a whole number or a fraction as a recorded number."""
        return self.step("constant", fmpq(value))

    def computation(self, results: "Sequence[Recorded]") -> Computation:
        """Return the steps that lead to some results."""
        needed = {result.place for result in results}
        for place in range(len(self.steps) - 1, -1, -1):
            if place in needed and self.steps[place][0] not in ("leaf", "constant"):
                needed.update(self.steps[place][1:])
        order = sorted(needed)
        new = {old: n for n, old in enumerate(order)}
        steps = tuple(_constant(step[1]) if step[0] == "constant" else step if step[0] == "leaf"
                      else (step[0], *(new[i] for i in step[1:])) for step in map(self.steps.__getitem__,
                                                                                  order))
        return Computation(steps, tuple(new[result.place] for result in results))


class Recorded:
    """A number in a recording: what is done with it is recorded."""

    __slots__ = ("place", "recording")
    __hash__ = None                                        # type: ignore[assignment]

    def __init__(self, recording: Recording, place: int):
        self.recording, self.place = recording, place

    @property
    def constant(self) -> fmpq | None:
        """The fraction that it is whatever the leaves are, or None."""
        step = self.recording.steps[self.place]
        return step[1] if step[0] == "constant" else None

    def _with(self, other: Any) -> "Recorded":
        return other if isinstance(other, Recorded) else self.recording.constant(other)

    def __add__(self, other: Any) -> "Recorded":
        other = self._with(other)
        a, b = self.constant, other.constant
        if a is not None and b is not None:
            return self.recording.constant(a + b)
        if a == 0 or b == 0:
            return other if a == 0 else self
        return self.recording.step("add", *sorted((self.place, other.place)))

    __radd__ = __add__

    def __neg__(self) -> "Recorded":
        return self * -1

    def __sub__(self, other: Any) -> "Recorded":
        other = self._with(other)
        a, b = self.constant, other.constant
        if a is not None and b is not None:
            return self.recording.constant(a - b)
        if a == 0 or b == 0:
            return -other if a == 0 else self
        return self.recording.step("subtract", self.place, other.place)

    def __rsub__(self, other: Any) -> "Recorded":
        return self._with(other) - self

    def __mul__(self, other: Any) -> "Recorded":
        other = self._with(other)
        a, b = self.constant, other.constant
        if a is not None and b is not None:
            return self.recording.constant(a * b)
        if a == 0 or b == 0:
            return self.recording.constant(0)
        if a == 1 or b == 1:
            return other if a == 1 else self
        return self.recording.step("multiply", *sorted((self.place, other.place)))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Recorded":
        other = self._with(other)
        if (b := other.constant) is not None:
            return self * (1 / b)
        return self * self.recording.step("inverse", other.place)

    def __rtruediv__(self, other: Any) -> "Recorded":
        return self._with(other) / self

    def __pow__(self, exponent: int) -> "Recorded":
        if not exponent:
            return self.recording.constant(1)
        half = self**(exponent // 2)
        return half * half * self if exponent % 2 else half * half

    def __eq__(self, other: object) -> bool:
        """Tell whether it is this whole number whatever the leaves are."""
        return isinstance(other, int) and self.constant == other


def _constant(value: fmpq) -> Step:
    near = int(value.p) / int(value.q)
    return "constant", near, fmpq(*near.as_integer_ratio()) == value
