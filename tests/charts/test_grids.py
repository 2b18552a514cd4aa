"""Grids: what np.broadcast_arrays says, element by element.

Numbers are kept exactly, and what is no number is named.
"""
import math
from collections import Counter
from fractions import Fraction

import numpy as np
import pytest
from charts.grid_points import points
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import gyrostat as gs
from gyrostat.charts.grids import cut, grid_of, last
from gyrostat.errors import ValuesError

shapes = arrays.mutually_broadcastable_shapes(num_shapes=3, max_dims=5, min_side=0, max_side=4)
filled = arrays.mutually_broadcastable_shapes(num_shapes=3, max_dims=5, min_side=1, max_side=4)


def counted(input_shapes):
    """An array of different numbers in each shape."""
    return {f"x{n}": np.arange(math.prod(shape), dtype=float).reshape(shape) + 1000 * n
            for n, shape in enumerate(input_shapes)}


@pytest.mark.slow
@given(drawn=shapes)
def test_the_grid_is_the_broadcast(drawn):
    """The shape is that of np.broadcast_arrays.

    At each place of the merged grid, in C order, the numbers are those of the same element.
    """
    given_arrays = counted(drawn.input_shapes)
    grid, full = grid_of(given_arrays), np.broadcast_arrays(*given_arrays.values())
    assert grid.shape == drawn.result_shape == full[0].shape
    assert math.prod(grid.merged) == math.prod(grid.shape) and len(grid.merged) >= 2
    numbers = points(grid)
    for n, place in enumerate(np.ndindex(grid.merged)):
        index = grid.index(place)
        assert index == (np.unravel_index(n, grid.shape) if grid.shape else ())
        assert numbers[n] == {gs.symbol(name): x[index] for name, x in zip(given_arrays, full)}


@pytest.mark.slow
@given(drawn=shapes)
def test_axes_are_those_of_length_above_one(drawn):
    """Each array is merged to the number of axes of the grid, of length 1 where it does not vary.

    The attribute axes says where it does.
    """
    grid = grid_of(counted(drawn.input_shapes))
    for s, array in grid.values.items():
        assert array.ndim == len(grid.merged)
        assert all(n in (1, m) for n, m in zip(array.shape, grid.merged))
        assert grid.axes[s] == {i for i, n in enumerate(array.shape) if n > 1}


@given(drawn=filled)
def test_neighbours_are_merged_where_they_can_be(drawn):
    """Neighbouring axes of more than one element are joined wherever each array varies along both or neither.
    """
    given_arrays = counted(drawn.input_shapes)
    full = [(1,) * (len(drawn.result_shape) - x.ndim) + x.shape for x in given_arrays.values()]
    long = [i for i, n in enumerate(drawn.result_shape) if n > 1]
    kinds = [tuple(s[i] > 1 for s in full) for i in long]
    touching = [j == i + 1 for i, j in zip(long, long[1:])]
    runs = len(kinds) - sum(near and one == other for one, other, near in zip(kinds, kinds[1:], touching))
    assert sum(n > 1 for n in grid_of(given_arrays).merged) <= runs


def test_short_axes_are_joined_as_long_as_that_repeats_little():
    """(n, 2, 3) of arrays along one axis each is (n, 6); what varies along all axes stays as it is."""
    whole = np.arange(6000.0).reshape(1000, 2, 3)
    grid = grid_of({"a": np.arange(1000.0).reshape(-1, 1, 1), "b": np.zeros((2, 1)), "c": np.zeros(3),
                    "d": whole})
    assert grid.merged == (1000, 6) and np.shares_memory(grid.values[gs.symbol("d")], whole)
    assert {s.name: x.shape for s, x in grid.values.items()} == {
        "a": (1000, 1),
        "b": (1, 6),
        "c": (1, 6),
        "d": (1000, 6),
    }
    apart = grid_of({"a": np.zeros((1000, 1, 3)), "b": np.zeros((2, 1))})
    # what would be repeated is not
    assert apart.merged == (1000, 2, 3) and apart.values[gs.symbol("a")].size == 3000
    long = grid_of({"a": np.zeros((1000, 1, 1)), "b": np.zeros((3000, 1)), "c": np.zeros(3000)})
    assert long.merged == (1000, 3000, 3000)


@pytest.mark.parametrize(("shape", "merged"),
                         [((), (1, 1)), ((5,), (1, 5)), ((3, 4), (1, 12)), ((2, 3, 4), (1, 24))])
def test_equal_shapes_are_one_row(shape, merged):
    """Arrays of one shape make a single axis."""
    assert grid_of({"a": np.zeros(shape), "b": np.ones(shape), "c": 3}).merged == merged


@given(drawn=shapes, size=st.integers(1, 40))
def test_blocks_tile_the_grid_once(drawn, size):
    """Each place is in one block.

    A block is of length 1 along all axes but the last two, and of about so many points at most.
    """
    grid = grid_of(counted(drawn.input_shapes))
    covered = np.zeros(grid.merged, dtype=int)
    for tile in grid.blocks(size):
        assert len({(s.start, s.stop, t.start, t.stop) for *_, s, t in tile}) == 1
        for block in tile:
            assert all(0 <= s.start < s.stop <= n for s, n in zip(block, grid.merged))
            assert all(s.stop - s.start == 1 for s in block[:-2])
            covered[block] += 1
            rows, columns = (s.stop - s.start for s in block[-2:])
            assert rows * columns <= size
            for array in grid.values.values():
                assert last(cut(array, block)).shape in {(n, m) for n in (1, rows) for m in (1, columns)}
    assert (covered == 1).all()


@given(rows=st.integers(1, 70), columns=st.integers(1, 70), outer=st.integers(1, 3), size=st.integers(1, 900))
def test_blocks_of_rows_and_columns(rows, columns, outer, size):
    """The same for grids of many rows and columns, and short axes before them."""
    grid = grid_of({"a": np.zeros((outer, 1, 1)), "b": np.zeros((rows, 1)),
                    "c": np.zeros((outer, 1, columns)), "d": np.zeros(columns)})
    covered = np.zeros(grid.merged, dtype=int)
    for block in (block for tile in grid.blocks(size) for block in tile):
        assert all(0 <= s.start < s.stop <= n for s, n in zip(block, grid.merged))
        covered[block] += 1
        assert math.prod(s.stop - s.start for s in block) <= size
    assert (covered == 1).all()


@given(drawn=filled, size=st.integers(1, 20), data=st.data())
def test_some_points_of_a_block(drawn, size, data):
    """at takes the numbers of some rows and columns of a block."""
    given_arrays = counted(drawn.input_shapes)
    given_arrays["x3"] = np.array([Fraction(1, 3), Fraction(1, 7)], dtype=object)[:1]
    grid = grid_of(given_arrays)
    block = data.draw(st.sampled_from([block for tile in grid.blocks(size) for block in tile]))
    heights, widths = (s.stop - s.start for s in block[-2:])
    some = data.draw(st.lists(st.tuples(st.integers(0, heights - 1), st.integers(0, widths - 1)), min_size=1,
                              max_size=5))
    part = grid.at(block, *map(np.array, zip(*some)))
    assert part.shape == (len(some),) and part.merged == (1, len(some))
    everywhere = np.array(points(grid), dtype=object).reshape(grid.merged)
    start = tuple(s.start for s in block)
    assert points(part) == [everywhere[(*start[:-2], start[-2] + i, start[-1] + j)] for i, j in some]


@given(drawn=filled, size=st.integers(1, 40))
def test_cut_is_the_part_in_a_block(drawn, size):
    """cut(array, block) broadcasts to the block of the broadcast array."""
    grid = grid_of(counted(drawn.input_shapes))
    for tile in grid.blocks(size):
        for block in tile:
            for array in grid.values.values():
                whole = np.broadcast_to(array, grid.merged)[block]
                assert (np.broadcast_to(cut(array, block), whole.shape) == whole).all()


@pytest.mark.parametrize("size", [10**5, 10**6])
def test_blocks_are_not_many_where_the_last_axes_are_short(size):
    """A grid (n, 2, 2) of arrays that vary along one axis each has about n·4/points blocks, not n."""
    grid = grid_of({"a": np.zeros((size, 1, 1)), "b": np.zeros((2, 1)), "c": np.zeros(2)})
    assert sum(map(len, grid.blocks(2**15))) < 1000


@pytest.mark.parametrize("shape", [(0,), (3, 0), (0, 3), (0, 0), (2, 0, 3), (0, 1), (1, 0)])
def test_empty_grids_have_no_blocks(shape):
    """No points, no blocks."""
    grid = grid_of({"a": np.zeros(shape), "b": 1.0})
    assert grid.shape == shape and not [block for tile in grid.blocks(7) for block in tile]


def test_shapes_that_do_not_broadcast_are_named():
    """The message has each name that is not a number, with its shape."""
    with pytest.raises(ValuesError, match=r"do not broadcast: a \(2,\), b \(3,\); give shapes"):
        grid_of({"a": np.zeros(2), "b": np.zeros(3), "c": 1})


def test_no_names_are_one_point():
    """A grid of no names is one point."""
    grid = grid_of({})
    assert grid.shape == () and grid.merged == (1, 1) and points(grid) == [{}]
    assert Counter(map(len, grid.blocks(7))) == {1: 1}
