"""Runs a program over the blocks of a grid, in place.

What does not change from one block to the next is kept.
"""
from collections.abc import Callable
from typing import Any

import numpy as np
from sympy import Expr

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ..grids import Slices, last
from .rounding import rounded
from .straightline import Axes, Program, Step

Read = Callable[[Expr, Slices], Array]


class Layout:
    """Which steps of a program are done at each point of a grid, and what they start from.

    Parameters
    ----------
    program : Program
    full : frozenset of int
        the axes along which the grid varies
    """

    def __init__(self, program: Program, full: Axes):
        self.program = program
        self.whole = [bool(full) and step.axes == full for step in program.steps]
        self.sources: dict[Any, str] = {}                  # loops over its points, by what they write

    @cached_property
    def operands(self) -> list[int]:
        """The steps that the work at each point starts from: those that vary along fewer axes, and leaves."""
        used = {*(i for _, step in self.inner for i in step.arguments), *self.program.outcomes}
        return sorted(i for i in used if not self.whole[i] or not self.program.steps[i].arguments)

    @cached_property
    def inner(self) -> list[tuple[int, Step]]:
        """The steps that are done at each point."""
        return [(i, step) for i, step in enumerate(self.program.steps) if self.whole[i] and step.arguments]

    @cached_property
    def slots(self) -> list[int]:
        """The buffer of each inner step: one that no later step reads again."""
        reader = {n: i for i, step in self.inner for n in step.arguments}         # the last one of each
        free: list[int] = []
        slots: dict[int, int] = {}
        for i, step in self.inner:
            free += [slots[n] for n in dict.fromkeys(step.arguments) if n in slots and reader[n] == i]
            slots[i] = free.pop() if free else len(set(slots.values()))
        return list(slots.values())


def layout_of(program: Program, full: Axes) -> Layout:
    """Return the layout of a program on the axes of a grid, made once."""
    if full not in program.kept:
        program.kept[full] = Layout(program, full)
    layout: Layout = program.kept[full]
    return layout


class Tiles:
    """One program, block by block; each block is seen as rows and columns.

    Parameters
    ----------
    program : Program
    full : frozenset of int
        the axes along which the grid varies
    read : callable
        gives a leaf in a block, shape (1, …, 1, rows or 1, columns or 1)
    kind : NumPy type
        the type of the floats
    """

    def __init__(self, program: Program, full: Axes, read: Read, kind: Any = np.float64):
        self.program, self.read, self.kind = program, read, kind
        self.layout = layout_of(program, full)
        self.inner, self.operands = self.layout.inner, self.layout.operands
        self.kept: dict[int, tuple[Any, Array]] = {}
        self.buffers: list[Array] = []

    def small(self, place: int, block: Slices) -> Array:
        """Return a step that is not done at each point, or a leaf, in a block."""
        step = self.program.steps[place]
        if self.layout.whole[place]:
            assert step.value is not None
            return self._read(step.value, block)
        key = [(block[axis].start, block[axis].stop) for axis in sorted(step.axes)]
        if place not in self.kept or self.kept[place][0] != key:
            self.kept[place] = key, self._small(step, block)
        return self.kept[place][1]

    def _small(self, step: Step, block: Slices) -> Array:
        if step.operation == "leaf":
            assert step.value is not None
            return self._read(step.value, block)
        if step.operation == "constant":
            return np.full((1, 1), rounded(step.value)[0], dtype=self.kind)
        return getattr(np, step.operation)(*(self.small(i, block) for i in step.arguments))

    def _read(self, leaf: Expr, block: Slices) -> Array:
        return last(self.read(leaf, block))

    def value(self, block: Slices, out: Array | None = None) -> Array:
        """Return the program's result in a block, in out if it is given.

        Otherwise it is in a buffer that the next block uses again.
        """
        if not self.inner:
            return self.small(len(self.program.steps) - 1, block)
        shape = block[-2].stop - block[-2].start, block[-1].stop - block[-1].start
        results: dict[int, Array] = {i: self.small(i, block) for i in self.operands}
        for (i, step), slot in zip(self.inner, self.layout.slots):
            into = out if out is not None and i == len(self.program.steps) - 1 else self._buffer(slot, shape)
            results[i] = getattr(np, step.operation)(*(results[n] for n in step.arguments), out=into)
        return results[self.inner[-1][0]]

    def _buffer(self, slot: int, shape: tuple[int, int]) -> Array:
        while len(self.buffers) <= slot:
            self.buffers.append(np.empty(0, dtype=self.kind))
        if self.buffers[slot].size < shape[0] * shape[1]:
            self.buffers[slot] = np.empty(shape[0] * shape[1], dtype=self.kind)
        return self.buffers[slot][:shape[0] * shape[1]].reshape(shape)
