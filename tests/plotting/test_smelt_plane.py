"""The Smelt plane as it is drawn, against the inequalities of DeBra and Delp in fractions."""
import random
from fractions import Fraction as F

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from gyrostat.errors import ValuesError
from gyrostat.plotting import draw_smelt_plane
from gyrostat.plotting.looks import LOOKS


def drawn(rotor=0, bodies=None):
    ax = draw_smelt_plane(rotor, bodies, Figure(figsize=(4, 4)).subplots())
    (image,) = ax.images
    low, high, *_ = image.get_extent()
    return ax, np.asarray(image.get_array()), image, (low, high)


def pixels(image, array, count, rng):
    """Random pixels: k_R, k_Y at their middles, and the colour there."""
    n = len(array)
    for _ in range(count):
        i, j = rng.randrange(n), rng.randrange(n)
        yield F(2 * j + 1, n) - 1, F(2 * i + 1, n) - 1, to_hex(image.cmap(image.norm(array[i, j])))


def truth(kR, kY, rotor):
    """A3 with I_roll = 1 − k_Y, I_pitch = 1 − k_R k_Y, I_yaw = 1 − k_R, rate 1: K, factors of the sextic."""
    It, In, Ir = 1 - kY, 1 - kR * kY, 1 - kR
    l = rotor * In
    roll, pitch, yaw = 4 * (In - Ir) + l, 3 * (It - Ir), In - It + l
    if roll > 0 and pitch > 0 and yaw > 0:
        return "stable"
    b, c = It * yaw + Ir * roll + (It + Ir - In - l) ** 2, roll * yaw
    spectral = pitch >= 0 and b >= 0 and c >= 0 and b * b >= 4 * It * Ir * c
    return "undecided" if spectral else "unstable"


@pytest.mark.slow
@pytest.mark.parametrize("rotor", [F(0), *(pytest.param(x, marks=pytest.mark.slow) for x in (
    F(1, 2), F(-3, 5)))])
def test_the_colour_of_each_pixel(rotor):
    """Of random ones."""
    _, array, image, extent = drawn(str(rotor))
    assert np.allclose(extent, (-1, 1))
    for kR, kY, colour in pixels(image, array, 4000, random.Random(f"smelt {rotor}")):
        assert colour == LOOKS[truth(kR, kY, rotor)][0], (kR, kY)


@pytest.mark.slow
def test_the_corners_of_the_region_of_debra_and_delp():
    """(0, 0), (−5/2 + √6, −1), and k_R = k_Y = −((3 − √5)/2)²; the curve between the last two."""
    ax, *_ = drawn()
    at = np.concatenate([line.get_xydata() for line in ax.lines])
    at = at[~np.isnan(at).any(axis=1)]
    corner = -((3 - np.sqrt(5)) / 2) ** 2
    for x, y in ((0, 0), (corner, corner)):
        assert np.hypot(at[:, 0] - x, at[:, 1] - y).min() < 6e-3
    curved = at[(at[:, 0] < -1e-3) & (at[:, 1] < corner)]
    assert len(curved) > 50
    assert np.allclose(curved[:, 1], (2 - np.sqrt(3 - 3 * curved[:, 0])) ** 2 / curved[:, 0], atol=1e-6)
    lowest = curved[curved[:, 1].argmin()]
    assert lowest == pytest.approx((-2.5 + np.sqrt(6), -1), abs=5e-3)
    assert not ((at[:, 0] < corner - 5e-3) & (at[:, 1] != at[:, 0])).any()     # (−1/3, 0) is none


@pytest.mark.slow
def test_bodies_are_marked_where_they_are():
    """The body (60, 32, 35) at (−1/20, −4/5); its number stands in the legend."""
    ax, *_ = drawn(bodies={"ours": (60, 32, 35), "other": ("1", "6/5", "1/2")})
    spots = [line.get_xydata()[0] for line in ax.lines if line.get_marker() == "o"]
    assert np.allclose(spots, [(-0.05, -0.8), (0.7, 0.4)])
    assert [text.get_text() for text in ax.get_legend().get_texts()][-2:] == ["ours", "other"]


@pytest.mark.slow
def test_what_gyroscopic_forces_hold_is_lost_by_damping():
    """The legend says so."""
    ax, *_ = drawn("1/3")
    texts = [text.get_text() for text in ax.get_legend().get_texts()]
    assert texts[:3] == ["stable", "gyroscopic, lost by damping", "unstable"]
    assert "1/3" in ax.get_title()


@pytest.mark.parametrize(("moments", "wrong"), [
    ((1, 2), "2 moments"), ((1, 2, 4), "no body"), ((1, -1, 1), "no body"), ((1, 2, "I3"), "ours")])
def test_impossible_bodies(moments, wrong):
    """Refused by name."""
    with pytest.raises(ValuesError, match=wrong):
        drawn(bodies={"ours": moments})
