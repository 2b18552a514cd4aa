"""The momentum sphere: every equilibrium with its verdict, polhodes on sphere and level, and the picture."""
import numpy as np
import pytest
from draw import moments, numbers
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure
from sympy import Rational

import gyrostat as gs
from gyrostat.errors import ArgumentError, ScopeError, ValuesError
from gyrostat.plotting import draw_momentum_sphere
from gyrostat.plotting.energy_levels import energies_between, floats, level_curve
from gyrostat.plotting.looks import BLUE

CASES = [((1, 2, 3), (0, 0, 0), 1), ((1, 2, 3), (0, 0, "0.55"), 1),
         ((2, 1, "3/2"), ("1/5", "1/10", "1/8"), 1),
         ((3, 2, 1), (0, "1/4", 1), 2), ((2, 3, 3), ("1/3", 0, 0), "3/2")]


def rotations(body, radius):
    return gs.relative_equilibria(gs.assemble(body), {"M": radius})


def drawn(inertia, rotor, radius, energies=None, **kwargs):
    ax = Figure(figsize=(4, 4)).add_subplot(projection="3d", elev=22, azim=40)
    return draw_momentum_sphere(gs.assemble(gs.Gyrostat(inertia, rotor)), radius, {}, energies, ax, **kwargs)


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia, rotor, radius", CASES)
def test_polhodes_lie_on_sphere_and_level(inertia, rotor, radius):
    """abs(M) = R and Σ (M − l)²/(2 I) = energy to 1e-12, at every energy, and curves are closed.

    Each end of a piece is another's.
    """
    body, R = gs.Gyrostat(inertia, rotor), float(Rational(radius))
    I, l = floats(body.inertia), floats(body.gyrostatic_momentum)
    points = rotations(body, radius)
    for energy in energies_between(body, points, 2):
        M = level_curve(body, points, R, energy)
        M0 = M[np.isfinite(M[:, 0])]
        assert len(M0) > 20
        np.testing.assert_allclose(np.linalg.norm(M0, axis=1), R, rtol=1e-12)
        np.testing.assert_allclose(((M0 - l) ** 2 / I).sum(axis=1) / 2, energy, rtol=1e-12)
        gaps = np.flatnonzero(np.isnan(np.concatenate([[np.nan], M[:, 0], [np.nan]])))
        ends = np.array([M[n] for a, b in zip(gaps, gaps[1:]) for n in (a, b - 2)])
        apart = np.linalg.norm(ends[:, None] - ends[None], axis=-1) + 9 * np.eye(len(ends))
        # Newton's method ends at one point from one start
        assert apart.min(axis=1).max() < 1e-9


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia, rotor, radius", [case for case in CASES if case[0] != (2, 3, 3)])
def test_separatrices_lie_on_sphere_and_level(inertia, rotor, radius):
    """To rounding at the saddle too, where the gradient vanishes."""
    body, R = gs.Gyrostat(inertia, rotor), float(Rational(radius))
    I, l = floats(body.inertia), floats(body.gyrostatic_momentum)
    points = rotations(body, radius)
    for energy in {float(p.energy) for p in points if p.decision.verdict is gs.Verdict.UNSTABLE}:
        M = level_curve(body, points, R, energy)
        M = M[np.isfinite(M[:, 0])]
        np.testing.assert_allclose(np.linalg.norm(M, axis=1), R, rtol=1e-14)
        np.testing.assert_allclose(((M - l) ** 2 / I).sum(axis=1) / 2, energy, rtol=2e-14)


def test_beside_a_saddle_both_curves_are_there():
    """Closer to each other than the chords are long."""
    body = gs.Gyrostat((2, 1, 3), (0, 0, 0))
    M = level_curve(body, rotations(body, 1), 1.0, 0.25 - 1e-5)
    gap = np.flatnonzero(np.isnan(M[:, 0]))
    assert len(gap) == 1 and np.sign(M[0, 2]) == -np.sign(M[-1, 2])
    assert (np.diff(np.sign(M[np.isfinite(M[:, 0]), 2])) != 0).sum() == 1


def test_energies_lie_between_the_critical_ones():
    """As many in each band, none at its ends."""
    body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    chosen = energies_between(body, rotations(body, 1), 4)
    assert ((chosen > 1 / 6) & (chosen < 1 / 4)).sum() == ((chosen > 1 / 4) & (chosen < 1 / 2)).sum() == 4


def test_the_picture_has_what_was_found():
    """Markers at the equilibria, filled or open; separatrices heavy; axes named.

    Arguments go to the polhodes.
    """
    ax = drawn((1, 2, 3), (0, 0, 0), 1, [0.2, 0.3], color="green", linewidth=0.5)
    assert [text.get_text() for text in ax.texts][:3] == ["$M_{1}$", "$M_{2}$", "$M_{3}$"]
    green = [line for line in ax.lines if line.get_color() == "green"]
    assert len(green) == 2 and all(line.get_linewidth() == 0.5 for line in green)
    M = np.array(green[1].get_data_3d()).T
    heights = (M[np.isfinite(M[:, 0])] ** 2 / [2, 4, 6]).sum(axis=1)
    assert set(heights.round(3)) == {0.2, 0.3}                         # points at the limb are put on a chord
    dots = [np.array(line.get_data_3d()).T for line in ax.lines if line.get_marker() == "o"]
    assert sorted(map(tuple, np.concatenate(dots).round(12).tolist())) == sorted(
        tuple(s * e for e in row) for row in np.eye(3).tolist() for s in (1, -1))
    open_ones = [line for line in ax.lines if line.get_marker() == "o"
                 and line.get_markerfacecolor() == "white"]
    assert sum(len(line.get_data_3d()[0]) for line in open_ones) == 2
    # no polhode
    assert [line for line in drawn((1, 2, 3), (0, 0, 0), 1, [], color="green").lines
            if line.get_color() == "green"]
    ring = drawn((1, 1, 2), (0, 0, 0), 1)
    assert [text.get_text() for text in ring.get_legend().get_texts()] == [
        "polhode",
        "equilibria, stable modulo the spin",
        "stable",
    ]


def test_a_circle_of_equilibria_lies_where_they_are():
    """I = (1, 1, 2), l = (0, 0, 1/2), abs(M) = 1: M3 = −1/2 and any direction of the others."""
    rings = [c for c in energy_curves(drawn((1, 1, 2), (0, 0, "1/2"), 1, []), BLUE) if len(c) > 1]
    M = np.concatenate(rings)
    assert np.ptp(np.arctan2(M[:, 1], M[:, 0])) > 6
    np.testing.assert_allclose(M[:, 2], -0.5, rtol=1e-4)               # points at the limb are on a chord
    np.testing.assert_allclose(np.linalg.norm(M, axis=1), 1, rtol=1e-14)


def test_what_cannot_be_drawn_is_refused():
    """What was given, why it is impossible, what to do."""
    field = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    with pytest.raises(ScopeError, match="the scene has the potential k3\\*m0: assemble the body alone"):
        draw_momentum_sphere(field, 1)
    with pytest.raises(ScopeError,
                       match=r"inertia = \(2, 2, 2\) and l = 0: every point .* give different moments"):
        drawn((2, 2, 2), (0, 0, 0), 1)
    with pytest.raises(ValuesError,
                       match="momentum = 0 is not the radius of a sphere: give a positive number"):
        drawn((1, 2, 3), (0, 0, 0), 0)
    free = gs.assemble(gs.Gyrostat())
    with pytest.raises(ValuesError, match="needs l1, l2, l3: give a number for each"):
        draw_momentum_sphere(free, 1, {"I1": 1, "I2": 2, "I3": 3})
    with pytest.raises(ValuesError, match="no parameter m0"):
        draw_momentum_sphere(free, 1, {"m0": 1})
    with pytest.raises(ArgumentError, match="the axes are rectilinear"):
        draw_momentum_sphere(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), 1, ax=Figure().subplots())


@pytest.mark.parametrize("energy", [0.1, 0.6, 0.500001])
def test_an_energy_that_is_not_on_the_sphere(energy):
    """abs(M) = 1, I = (1, 2, 3): the energies on the sphere lie between 1/6 and 1/2."""
    with pytest.raises(ValuesError, match="energies between 0.166667 and 0.5"):
        drawn((1, 2, 3), (0, 0, 0), 1, [0.3, energy])


def energy_curves(ax, color):
    """The pieces of the curves of a colour, front and back put together, as arrays of shape (n, 3)."""
    found = []
    for line in ax.lines:
        M = np.array(line.get_data_3d()).T
        if line.get_color() == color and line.get_marker() == "None" and len(M):
            gaps = np.flatnonzero(np.isnan(np.concatenate([[np.nan], M[:, 0], [np.nan]])))
            found += [M[a:b - 1] for a, b in zip(gaps, gaps[1:]) if b - a > 2]
    return found


def on_circle(inertia, rotor, radius, energy, normal):
    """How often a great circle meets the level, from 40 000 of its points; None where it almost touches."""
    first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    first /= np.linalg.norm(first)
    turn = np.linspace(0, 2 * np.pi, 40001)[:, None]
    M = radius * (np.cos(turn) * first + np.sin(turn) * np.cross(normal, first))
    excess = ((M - rotor) ** 2 / inertia).sum(axis=1) / 2 - energy
    inner = (np.diff(excess)[1:] * np.diff(excess)[:-1] <= 0).nonzero()[0] + 1
    if (np.abs(excess[inner]) < 1e-3 * np.ptp(excess)).any():
        return None
    return int((excess[1:] * excess[:-1] < 0).sum())


def polhodes_are_complete(inertia, rotor, radius, part, seed):
    """Every vertex on sphere and level.

    Every great circle is crossed as often by the drawn curves as the level meets it.
    """
    body = gs.Gyrostat(inertia, rotor)
    points = rotations(body, radius)
    I, l, R = floats(body.inertia), floats(body.gyrostatic_momentum), float(Rational(radius))
    heights = sorted(float(p.energy) for p in points)
    energy = heights[0] + part * (heights[-1] - heights[0])
    if min(abs(energy - h) for h in heights) < 1e-7 * (heights[-1] - heights[0]):
        return
    ax = drawn(inertia, rotor, radius, [energy], color="green")
    curves = energy_curves(ax, "green")
    vertices = np.concatenate(curves)
    np.testing.assert_allclose(np.linalg.norm(vertices, axis=1), R, rtol=1e-12)
    off = np.abs(((vertices - l) ** 2 / I).sum(axis=1) / 2 - energy)
    # points at the limb are on a chord of 0.03
    assert off.max() < 1e-3 * (heights[-1] - heights[0]) + 2e-4 * R**2 / I.min()
    assert np.quantile(off, 0.8) < 1e-12 * max(map(abs, heights))
    assert max(np.linalg.norm(np.diff(c, axis=0), axis=1).max() for c in curves if len(c) > 1) < 0.031 * R
    for normal in np.random.default_rng(seed).normal(size=(6, 3)):
        normal /= np.linalg.norm(normal)
        expected = on_circle(I, l, R, energy, normal)
        if expected is not None:
            assert sum(int(((c[1:] @ normal) * (c[:-1] @ normal) < 0).sum()) for c in curves) == expected, (
                energy,
                normal,
            )


close = st.sampled_from([(1, "1.0001", 2), (1, 1, 2), (2, 1, 1), (1, "1.01", "1.02"), (3, 1, 2),
                         (1, 2, "2.999"), ("1/5", 1, "6/5")])


@pytest.mark.slow
@given(close, st.tuples(numbers, numbers, numbers), st.sampled_from([0, "1/50", 1]), moments,
       st.one_of(st.fractions(0, 1), st.sampled_from([1e-6, 1e-4, 1 - 1e-4, 1 - 1e-6])), st.integers(0, 99))
def test_polhodes_are_complete(inertia, rotor, size, radius, part, seed):
    """Nearly equal and equal moments, where polhodes are thin; rotors of any size.

    Energies next to the extrema.
    """
    polhodes_are_complete(inertia, [Rational(x) * Rational(size) for x in rotor], radius, float(part), seed)


@pytest.mark.slow
@pytest.mark.parametrize("inertia, rotor, part",
                         [((1, "1.0001", 2), ("1/100", "1/50", "1/5"), 0.9999), ((1, 2, 3), (0, 0, 0), 1e-6),
                                                  ((3, 1, 2), (0, 0, "1/10"), 0.4)])
def test_a_small_or_thin_polhode_is_not_missing(inertia, rotor, part):
    """A millionth of the way from the least energy; a body of almost equal moments."""
    polhodes_are_complete(inertia, rotor, 1, part, 1)


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia, rotor, radius",
                         [*CASES[:3], *(pytest.param(*case, marks=pytest.mark.slow) for case in CASES[3:])])
def test_separatrices_meet_the_saddles_and_are_complete(inertia, rotor, radius):
    """Every heavy vertex has the energy of a saddle.

    Each great circle is crossed as often as its level says; saddles are approached.
    """
    body = gs.Gyrostat(inertia, rotor)
    saddles = [p for p in rotations(body, radius) if p.decision.unstable and not p.locus]
    I, l, R = floats(body.inertia), floats(body.gyrostatic_momentum), float(Rational(radius))
    curves = [c for c in energy_curves(drawn(inertia, rotor, radius, []), "#1f2933")
              if np.abs(np.linalg.norm(c, axis=1) - R).max() < 1e-9]
    up, around = np.radians([22, 40])
    eye = np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)
    curves = [c for c in curves if np.ptp(c @ np.array(eye)) > 1e-3]   # without the outline
    for saddle in saddles:
        assert min(np.linalg.norm(c - floats(saddle.momentum), axis=1).min() for c in curves) < 0.02 * R
    for normal in np.random.default_rng(2).normal(size=(8, 3)):
        normal /= np.linalg.norm(normal)
        energies = {round(float(s.energy), 12): float(s.energy) for s in saddles}
        counts = [on_circle(I, l, R, energy, normal) for energy in energies.values()]
        if None not in counts:
            assert sum(int(((c[1:] @ normal) * (c[:-1] @ normal) < 0).sum()) for c in curves) == sum(counts)
