"""The effective potential drawn: turning points, equilibria, heights."""
from fractions import Fraction
from itertools import pairwise

import numpy as np
import oracle
import pytest
from draw import moments, numbers
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure
from numpy.polynomial import Polynomial
from sympy import Rational

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.plotting import draw_effective_potential
from gyrostat.plotting.effective_potential import well
from gyrostat.plotting.looks import BLUE, DARK

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
QUARTIC = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: 6 * k3**4 - 5 * k3**2))
CASES = [(TOP, {"I1": 1, "I3": "1/2", "l": 0, "m0": 1, "p_phi": 2, "p_psi": 3}, 10, [0, 1]),
         (TOP, {"I1": 2, "I3": 1, "l": "1/2", "m0": -1, "p_phi": 1, "p_psi": "-1/3"}, 3, [0, -1]),
         (QUARTIC, {"I1": 1, "I3": "1/2", "l": 0, "p_phi": "1/5", "p_psi": "1/10"}, "-0.3", [0, 0, -5, 0, 6])]


@pytest.mark.slow
@pytest.mark.parametrize("scene, values, energy, U", CASES)
def test_turning_points_are_roots_of_g(scene, values, energy, U):
    """g = 2 I1 (e − U)(1 − z²) − (v − P z)² vanishes there, nowhere else between.

    V is the energy there and g ≥ 0 is V ≤ energy.
    """
    I1, I3, l, v, P = (float(Fraction(values[name])) for name in ("I1", "I3", "l", "p_phi", "p_psi"))
    g = np.polynomial.Polynomial(oracle.reduced_motion(I1, float(Fraction(energy)) - (P - l) ** 2 / (2 * I3),
                                                       v, P, U))
    found = well(scene, values, energy)
    turning = np.array([float(k3) for k3 in found.turning_points])
    roots = g.roots()
    expected = np.sort(roots.real[(np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) < 1)])
    np.testing.assert_allclose(turning, expected, rtol=1e-9)           # simple roots in doubles
    inside = g(np.cos(found.theta))
    clear = np.abs(inside) > 1e-9
    np.testing.assert_array_equal((inside > 0)[clear], (found.height < float(Fraction(energy)))[clear])


@pytest.mark.parametrize("scene, values, energy, U", CASES)
def test_equilibria_are_the_minima_and_maxima(scene, values, energy, U):
    """Between two angles where the differences of V change sign lies an equilibrium, stable at a minimum, at
    the height of V.
    """
    found = well(scene, values)
    turns = np.flatnonzero(np.diff(np.sign(np.diff(found.height))))
    minima = np.diff(found.height)[turns] < 0
    inner = sorted((t, h, branch) for t, h, _, branch in found.equilibria)
    assert len(inner) == len(turns) and found.turning_points == []
    for (theta, height, branch), n, minimum in zip(inner, turns, minima):
        assert found.theta[n] <= theta <= found.theta[n + 2]
        # a step of the angles away, where the slope vanishes
        assert height == pytest.approx(found.height[n + 1], abs=1e-3)
        assert (branch.decision.verdict is gs.Verdict.STABLE) == minimum


@pytest.mark.slow
def test_poles_are_on_their_level():
    """Where p_phi = p_psi E1 is on the level, at the height U(1) + π3²/(2 I3).

    Below the critical spin it is open.
    """
    values = {"I1": 1, "I3": "1/2", "l": "1/4", "m0": 1, "p_phi": 1, "p_psi": 1}
    (theta, height, _, branch), *_ = well(TOP, values).equilibria
    assert (theta, height, branch.label) == (0.0, 1 + 0.75**2, "E1")
    ax = draw_effective_potential(TOP, values, ax=Figure().subplots())
    markers = {line.get_markerfacecolor(): line.get_xydata().tolist()
               for line in ax.lines if line.get_marker() == "o"}
    assert markers["white"] == [[0.0, height]] and len(markers[BLUE]) == 1


def test_the_picture():
    """The curve takes the arguments; a heavy line joins two turning points; axes and legend are named."""
    scene, values, energy, _ = CASES[2]
    ax = draw_effective_potential(scene, values, energy, Figure().subplots(), linewidth=3)
    curve = ax.lines[0]
    assert curve.get_linewidth() == 3
    assert curve.get_color() == DARK
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$\theta$", r"$V$ $[\mathrm{M\,L^{2}\,T^{-2}}]$")
    np.testing.assert_array_equal(curve.get_xydata().T,
                                  [well(scene, values, energy).theta, well(scene, values, energy).height])
    turns = sorted(np.arccos([float(k3) for k3 in well(scene, values, energy).turning_points]))
    bars = [line.get_xdata() for line in ax.lines if line.get_linewidth() == 2.2
            and line.get_linestyle() == "-"]
    np.testing.assert_array_equal(bars, [turns[:2], turns[2:]])
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "motion at the energy", "stable modulo the spin", "unstable"]


def test_what_cannot_be_drawn_is_refused():
    """Another body, U unspecified, a name that is missing."""
    with pytest.raises(ScopeError, match="draw_amended_potential is the picture|is unspecified"):
        draw_effective_potential(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()), {})
    with pytest.raises(ValuesError, match="the picture needs p_psi: give a number"):
        draw_effective_potential(TOP, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_phi": 1})


fields = st.tuples(st.lists(numbers, min_size=2, max_size=8).filter(lambda c: any(c[1:])),
                   st.sampled_from([[1], [1], [1], [-2, 1], ["1/2", 1], ["-1/3", 1], [1, 0, 1],
                                    ["-1/4", 0, 1]]))


def drawn_is_true(values, top, bottom, energy):
    """Everything in the picture, from its artists, against the polynomials of V and of g = 2 I1 (e − U)(1 −
    z²) − (v − P z)².
    """
    I1, I3, l, v, P = (float(values[n]) for n in ("I1", "I3", "l", "p_phi", "p_psi"))
    N, D = (Polynomial([float(Fraction(c)) for c in f]) for f in (top, bottom))
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(
        lambda k3: sum(Rational(c) * k3**n for n, c in enumerate(top))
        / sum(Rational(c) * k3**n for n, c in enumerate(bottom))))
    axial, z = (P - l) ** 2 / (2 * I3), Polynomial([0, 1])
    g = 2 * I1 * ((float(energy) - axial) * D - N) * (1 - z**2) - (v - P * z) ** 2 * D            # of g D
    poles = [r.real for r in D.roots() if abs(r.imag) < 1e-12 and abs(r.real) < 1]

    def V(x, across=None):
        return axial + N(x) / D(x) + (v - P * x) ** 2 / (2 * I1 * (1 - x**2 if across is None else across))

    def below(x):
        return g(x) / D(x) > 0

    edge = 1 - 1e-6 * (abs(v) == abs(P))               # g has a root at E1 or E2 on the level
    roots = [r.real for r in g.roots() if abs(r.imag) < 1e-7 and abs(r.real) < edge]
    cuts = [-1, *sorted([*roots, *poles]), 1]
    expected = [(a, b) for a, b in pairwise(cuts) if b - a > 1e-6 and below((a + b) / 2)]
    try:
        ax = draw_effective_potential(scene, values, energy, Figure().subplots())
    except ValuesError as error:
        assert "no motion has it" in str(error) and not expected
        return
    curve = next(line for line in ax.lines if line.get_color() == DARK
                 and line.get_marker() == "None").get_xydata()
    good = np.isfinite(curve[:, 1])
    with np.errstate(all="ignore"):
        x = np.cos(curve[good, 0])
        # beside poles
        np.testing.assert_allclose(curve[good, 1], V(x, np.sin(curve[good, 0]) ** 2), rtol=1e-6, atol=1e-9)
    for pole in poles:
        assert any(np.isclose(theta, np.arccos(pole)) for theta in curve[~good, 0])
    step = np.diff(curve[:, 0])
    assert (step >= 0).all() and step.max() <= np.pi / 802 * 1.001 and len(poles) == (~good).sum()
    bars = [tuple(np.cos(line.get_xdata())[::-1]) for line in ax.lines if line.get_linewidth() == 2.2
            and line.get_linestyle() == "-"]
    bars = sorted(bar for bar in bars if bar[1] - bar[0] > 1e-6)
    joined = [a for a, _ in expected[:1]] + [x for (_, a),
                                             (b, _) in pairwise(expected) if abs(a - b) > 1e-6 or a in poles
                                             for x in (a, b)]
    joined += [b for _, b in expected[-1:]]
    drawn = [a for a, _ in bars[:1]] + [b for _, b in bars[-1:]]
    drawn += [x for (_, a), (b, _) in pairwise(bars) if abs(a - b) > 1e-6 or any(np.isclose(a, poles))
              for x in (a, b)]
    # double roots in doubles
    np.testing.assert_allclose(sorted(drawn), sorted(joined), atol=1e-5)
    # of V I1 (1 − z²)² D²
    slope = (N.deriv() * D - N * D.deriv()) * I1 * (1 - z**2) ** 2 + (v - P * z) * (v * z - P) * D**2
    critical = [r.real for r in slope.roots() if abs(r.imag) < 1e-7 and abs(r.real) < edge
                and abs(D(r.real)) > 1e-9]
    dots = [(np.cos(a), h, line) for line in ax.lines if line.get_marker() == "o"
            for a, h in line.get_xydata()]
    inner = sorted(x for x, _, _ in dots if abs(x) < 1 - 1e-9)
    for r in critical:
        assert min([abs(r - x) for x in inner], default=1) < 1e-4      # multiple roots in doubles
    for place, height, line in dots:
        if abs(place) < 1 - 1e-9:
            assert abs(height - V(place)) <= 1e-6 * (1 + abs(height))
            assert min(abs(place - r) for r in critical) < 1e-4
            curvature = (V(place + 1e-4) - 2 * V(place) + V(place - 1e-4)) / 1e-8
            if abs(curvature) > 1e-2 * (1 + abs(height)):
                assert (line.get_markerfacecolor() == BLUE) == (curvature > 0)
        else:
            assert abs(v - place * P) < 1e-12
    bottom_edge, top_edge = ax.get_ylim()
    assert all(bottom_edge <= h <= top_edge for _, h, _ in dots)
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert ("motion at the energy" in names) and len(names) == 1 + len({line for *_, line in dots})
    tilted = any(abs(x) < 1 - 1e-9 and line.get_markerfacecolor() == BLUE for x, _, line in dots)
    assert any("modulo the spin" in name for name in names) == tilted


@pytest.mark.slow
@given(moments, moments, numbers, numbers, numbers, fields, numbers, st.sampled_from([0, 1, -1, 0]))
def test_everything_drawn_is_true_and_nothing_is_missing(I1, I3, l, p_phi, p_psi, field, energy, side):
    """Random fields of degree 1 to 7 over 1, and over linear and quadratic denominators, poles of U inside
    included; p_phi = ±p_psi too.
    """
    drawn_is_true({"I1": I1, "I3": I3, "l": l, "p_phi": side * p_psi if side else p_phi, "p_psi": p_psi},
                  *field, energy * 3)


def test_a_field_that_is_infinite_between_the_poles_is_not_joined_across():
    """U = 1/(k3 − 1/2): the curve is cut at 60°, the motion lies on one side."""
    values = {"I1": Fraction(1), "I3": Fraction(1), "l": Fraction(0), "p_phi": Fraction(1, 2),
              "p_psi": Fraction(1)}
    drawn_is_true(values, [1], ["-1/2", 1], Fraction(2))


def test_an_energy_that_no_motion_has_is_refused():
    """Below the least V there is nothing to draw."""
    with pytest.raises(ValuesError, match="no motion has it"):
        draw_effective_potential(TOP, CASES[0][1], -5)
