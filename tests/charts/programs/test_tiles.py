"""Tiles: block by block the same as all at once, and nothing is done again along an axis on which it does not
depend.
"""
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import gyrostat as gs
from gyrostat.charts.grids import cut, grid_of
from gyrostat.charts.programs.straightline import program_of
from gyrostat.charts.programs.tiles import Tiles, layout_of

NAMES = ("I1", "I3", "k3", "l", "omega")
SYMBOLS = dict(zip(NAMES, map(gs.symbol, NAMES)))
OPERATIONS = ("add", "subtract", "multiply", "negative")
shapes = arrays.mutually_broadcastable_shapes(num_shapes=5, max_dims=5, min_side=1, max_side=4)


def margin():
    """p of E3 in U = k3², written by hand."""
    I1, I3, k3, l, w = SYMBOLS.values()
    return 2 * I1 * (1 - k3**2) - 4 * I1 * k3**2 + I1**2 * w**2 + ((I1 - I3) * w * k3 - l) ** 2


def whole_numbers(input_shapes, seed):
    """Arrays of small integers: every operation on them is exact."""
    source = np.random.default_rng(seed)
    return {name: source.integers(-6, 7, size=shape).astype(float)
            for name, shape in zip(NAMES, input_shapes)}


def tiles_over(grid, kind=np.float64):
    program = program_of(margin(), grid.axes)
    return Tiles(program, grid.full, lambda leaf, block: cut(grid.values[leaf], block), kind)


def block_by_block(grid, points, kind=np.float64, into=False):
    """The values of the margin over the grid."""
    tiles, result = tiles_over(grid, kind), np.full(grid.merged, np.nan, dtype=kind)
    for tile in grid.blocks(points):
        for block in tile:
            out = result[block][(0,) * (result.ndim - 2)]
            value = tiles.value(block, out if into else None)
            if value is not out:
                out[...] = value
    return result.reshape(grid.shape)


@given(drawn=shapes, points=st.integers(1, 30), seed=st.integers(0, 99), into=st.booleans())
def test_blocks_of_any_size_are_the_whole(drawn, points, seed, into):
    """On small integers the values are the margin at each point, exactly, for 1 to 5 axes and blocks of 1 to
    30 points.
    """
    values = whole_numbers(drawn.input_shapes, seed)
    found = block_by_block(grid_of(values), points, into=into)
    full = np.broadcast_arrays(*values.values())
    program = program_of(margin(), {})
    for index in np.ndindex(found.shape):
        at = {s: Fraction(x[index]) for s, x in zip(SYMBOLS.values(), full)}
        exact = program.run(at.__getitem__, lambda c: Fraction(int(c.p), int(c.q)))[-1]
        assert Fraction(float(found[index])) == exact


def elements(monkeypatch, call):
    """How many elements the operations of NumPy are done on, by name."""
    done = dict.fromkeys(OPERATIONS, 0)

    def spied(name, operation):
        def counting(*arguments, **options):
            result = operation(*arguments, **options)
            done[name] += result.size
            return result
        return counting

    with monkeypatch.context() as patch:
        for name in OPERATIONS:
            patch.setattr(np, name, spied(name, getattr(np, name)))
        call()
    return sum(done.values())


def hoisted(grid):
    """Elements that steps have if each is done once at every point of the axes along which it varies."""
    steps = program_of(margin(), grid.axes).steps
    return sum(math.prod(grid.merged[i] for i in step.axes) for step in steps if step.arguments)


@pytest.mark.parametrize("shapes", [
    {"k3": (40, 1), "omega": (50,)}, {"l": (40, 1), "omega": (50,)},
    {"I1": (30, 1, 1), "k3": (20, 1), "l": (10,)}, {"k3": (2000,)},
    {"k3": (2000,), "l": (2000,), "omega": (2000,)}, {"I3": (40, 1), "omega": (40, 50)},
    {"omega": (6, 1, 1, 1), "l": (5, 1, 1), "k3": (3, 4)}, {}],
    ids=str)
def test_nothing_is_done_again(monkeypatch, shapes):
    """In one block, each step is done once at each point of the axes along which it varies, and no more."""
    source = np.random.default_rng(1)
    values = {name: source.random(shapes.get(name, ())) for name in NAMES}
    grid = grid_of(values)
    outer = [i for i, n in enumerate(grid.merged[:-2]) if n > 1]
    done = elements(monkeypatch, lambda: block_by_block(grid, 10**6))
    steps = program_of(margin(), grid.axes).steps
    assert done >= hoisted(grid)
    if not outer:
        assert done == hoisted(grid)
    inner = sum(math.prod(grid.merged) for step in steps if step.arguments and step.axes == frozenset(
        i for i, n in enumerate(grid.merged) if n > 1))
    assert done <= inner + math.prod(grid.merged) // min(grid.merged[-2:]) * len(steps) or not inner


@pytest.mark.parametrize("points", [64, 256])
def test_little_is_done_again_in_blocks(monkeypatch, points):
    """In blocks of n points of a grid of rows and columns, what varies along one of them is done again once a
    block at most.
    """
    source = np.random.default_rng(1)
    grid = grid_of({"I1": 1.5, "I3": 0.5, "l": 2.0, "k3": source.random((60, 1)), "omega": source.random(70)})
    blocks = [block for tile in grid.blocks(points) for block in tile]
    sides = sum(s.stop - s.start for block in blocks for s in block)
    steps = program_of(margin(), grid.axes).steps
    inner = sum(step.axes == frozenset({0, 1}) for step in steps if step.arguments)
    assert elements(monkeypatch, lambda: block_by_block(grid, points)) <= inner * 60 * 70 + sides * len(steps)


def test_what_does_not_change_between_blocks_is_kept(monkeypatch):
    """Along an outer axis only what varies along it is computed again."""
    source = np.random.default_rng(2)
    grid = grid_of({"I1": source.random((5, 7)), "I3": 1.0, "l": source.random((20, 1, 1)),
                    "omega": source.random(7), "k3": 0.5})
    steps = program_of(margin(), grid.axes).steps
    rest = [s for s in steps if s.arguments and 0 not in s.axes]
    assert rest
    once = sum(math.prod(grid.merged[i] for i in s.axes) for s in rest)
    again = 20 * sum(math.prod(grid.merged[i] for i in s.axes if i)
                     for s in steps if s.arguments and 0 in s.axes)
    assert elements(monkeypatch, lambda: block_by_block(grid, 1000)) == once + again


def test_few_buffers_are_used():
    """Inner steps share buffers.

    No more than are alive at once, none for the last step where it is written out.
    """
    grid = grid_of({name: np.random.default_rng(3).random(500) for name in NAMES})
    tiles = tiles_over(grid)
    assert len(tiles.inner) > 10 and len(set(tiles.layout.slots)) <= 4
    out, (tile,) = np.empty((1, 500)), grid.blocks(10**4)
    assert tiles.value(tile[0], out) is out and len(tiles.buffers) <= 4


def test_what_a_grid_needs_of_a_program_is_found_once():
    """For the same axes; along other axes other steps are done at each point."""
    program = program_of(margin(), {s: frozenset({1}) for s in SYMBOLS.values()})
    row = layout_of(program, frozenset({1}))
    assert layout_of(program, frozenset({1})) is row
    assert len(row.inner) > 10 and not layout_of(program, frozenset({0, 1})).inner


def test_the_type_is_that_of_the_buffers():
    """Single precision stays single, constants too."""
    values = {name: np.random.default_rng(4).random(50).astype(np.float32) for name in NAMES}
    grid = grid_of(values, np.float32)
    tiles = tiles_over(grid, np.float32)
    (tile,) = grid.blocks(1000)
    assert tiles.value(tile[0]).dtype == np.float32
    assert all(tiles.small(i, tile[0]).dtype == np.float32 for i in tiles.operands)
