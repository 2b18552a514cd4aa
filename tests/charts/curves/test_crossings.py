"""Edges on which a sign changes, in the order of the lines that cross them."""
import contourpy
import numpy as np
import pytest

from gyrostat.charts.curves.crossings import edges
from gyrostat.charts.signs.grid_signs import UNKNOWN


def theirs(signs):
    """Vertices half-way on the edges, in the order of contourpy, with NaN between two lines."""
    heights = np.where(signs == UNKNOWN, np.nan, np.where(signs == 1, 1.0, -1.0))
    (lines,) = contourpy.contour_generator(z=heights, corner_mask=False,
                                              line_type="ChunkCombinedNan").lines(0.0)[0]
    return np.empty((0, 2)) if lines is None else lines


def ours(signs):
    gaps, good, bad = edges(signs)
    assert (signs[good][~gaps] == 1).all() and (abs(signs[bad][~gaps]) <= 1).all()
    return np.where(gaps[:, None], np.nan, (np.array(good) + np.array(bad))[::-1].T / 2)


def pieces(vertices):
    """Every step from one vertex to the next, and how many lines there are."""
    gap = np.isnan(vertices[:, 0])
    steps = {(*a, *b) for a, b, gone in zip(vertices, vertices[1:], gap[:-1] | gap[1:]) if not gone}
    return steps, gap.sum() + bool(len(vertices))


@pytest.mark.few(1)
@pytest.mark.parametrize("unknown", [0.0, 0.15])
def test_the_lines_are_those_of_contourpy(unknown):
    """On random signs: crossings of two lines, closed lines, ends at the frame and at unknown points."""
    rng = np.random.default_rng(6)
    for _ in range(300):
        signs = rng.choice([-1, 0, 1, UNKNOWN], size=rng.integers(1, 9, 2) + 1,
                           p=[0.4, 0.1, 0.5 - unknown, unknown]).astype(np.int8)
        (steps, count), (expected, lines) = pieces(ours(signs)), pieces(theirs(signs))
        assert steps == expected and count == lines, signs


def test_closed_lines_end_where_they_begin():
    """Around one point, and nothing where no sign changes."""
    signs = np.full((3, 3), -1, np.int8)
    assert edges(signs)[0].size == 0
    signs[1, 1] = 1
    assert ours(signs).tolist() == [[0.5, 1], [1, 0.5], [1.5, 1], [1, 1.5], [0.5, 1]]
