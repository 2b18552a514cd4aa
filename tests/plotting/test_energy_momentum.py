"""The energy-momentum diagram: critical values are double roots of g, regions are its signs."""
import numpy as np
import oracle
import pytest
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.plotting import draw_energy_momentum
from gyrostat.plotting.energy_momentum import bands, energy_momentum

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
WELLS = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: 6 * k3**4 - 5 * k3**2 + k3 / 2))
CASES = [(TOP, {"I1": 1, "I3": 0.5, "l": 0.25, "m0": 1, "p_psi": 1}, [0, 1]),
         (TOP, {"I1": 2, "I3": 1, "l": 0, "m0": -1, "p_psi": 0}, [0, -1]),
         (WELLS, {"I1": 1, "I3": 1, "l": 0, "p_psi": 0.5}, [0, 0.5, -5, 0, 6])]


@pytest.fixture(scope="module", params=CASES, ids=["top", "pendulum", "wells"])
def found(request):
    scene, values, U = request.param
    return scene, values, U, energy_momentum(scene, values)


def g_of(values, U, v, h):
    """g at levels, as coefficients; e = h − π3²/(2 I3)."""
    return oracle.reduced_motion(values["I1"], h - (values["p_psi"] - values["l"]) ** 2 / (2 * values["I3"]),
                                 v, values["p_psi"], U)


@pytest.mark.slow
def test_critical_values_are_double_roots_of_g(found):
    """g(k3) = g'(k3) = 0 on every curve, and g'' < 0 where it is stable."""
    _, values, U, diagram = found
    for curve in diagram.curves:
        rows = np.linspace(0, len(curve.k3) - 1, 40).astype(int)[1:-1]
        for z, v, h in zip(curve.k3[rows], curve.momentum[rows], curve.energy[rows]):
            size = 1 + abs(h) + v * v
            value, slope, curvature, *_ = oracle.taylor(g_of(values, U, v, h), z)
            # round-off of terms of this size
            assert abs(value) < 1e-12 * size and abs(slope) < 1e-12 * size
            assert (curvature < 0) == (curve.verdict is gs.Verdict.STABLE)


@pytest.mark.slow
def test_the_rate_is_that_of_the_precession(found):
    """I1 k3 W² − p_ψ W + U' = 0, and C1 = I1 W (1 − k3²) + p_ψ k3."""
    _, values, U, diagram = found
    for curve in diagram.curves:
        near = np.abs(curve.omega) < 1e3
        z, W = curve.k3[near], curve.omega[near]
        residual = values["I1"] * z * W**2 - values["p_psi"] * W + oracle.polynomial(oracle.slope(U), z)
        np.testing.assert_allclose(residual / (1 + W**2), 0, atol=1e-12)
        np.testing.assert_allclose(curve.momentum[near], values["I1"] * W * (1 - z**2) + values["p_psi"] * z,
                                   rtol=1e-9, atol=1e-9)


@pytest.mark.slow
def test_both_rates_are_followed_to_where_they_meet():
    """Where P² = 4 I1 k3 U' the slow and the fast curve end in one point."""
    for P in (0.1, 0.7):
        curves = energy_momentum(WELLS, {"I1": 1, "I3": 1, "l": 0, "p_psi": P}).curves
        # P² − 4 z (1/2 − 10 z + 24 z³)
        met = np.polynomial.Polynomial([P * P, -2, 40, 0, -96]).roots()
        met = met.real[(np.abs(met.imag) < 1e-12) & (np.abs(met.real) < 1)]
        assert len(met) >= 2
        for k3 in met:
            ends = [(c.momentum[n], c.energy[n]) for c in curves for n in (0, -1) if abs(c.k3[n] - k3) < 1e-9]
            assert len(ends) == 2 and ends[0] == pytest.approx(ends[1], abs=1e-12)


@pytest.mark.parametrize("P", [-1, 1])
def test_the_slow_curve_goes_through_k3_0_and_the_fast_one_does_not(P):
    """At k3 = 0 the slow rate is U'/p_ψ, the fast one infinite."""
    curves = energy_momentum(TOP, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": P}).curves
    (slow,) = [c for c in curves if c.k3.min() < 0 < c.k3.max()]
    assert np.interp(0, slow.k3, slow.omega) == pytest.approx(P, abs=1e-4) and np.abs(slow.omega).max() < 3


@pytest.mark.slow
def test_poles(found):
    """E1 and E2 at C1 = ±p_ψ, h = π3²/(2 I3) + U(±1), stable from P² = ±4 I1 U' on."""
    _, values, U, diagram = found
    for side, (v, h, branch) in zip((1, -1), diagram.poles):
        P = values["p_psi"]
        assert (v, branch.place["k3"]) == (side * P, side)
        assert h == pytest.approx((P - values["l"]) ** 2 / (2 * values["I3"]) + oracle.polynomial(U, side),
                                  rel=1e-14)
        assert (branch.decision.verdict is gs.Verdict.STABLE) == (
            P**2 > side * 4 * values["I1"] * oracle.polynomial(oracle.slope(U), side)
        )


@pytest.mark.slow
def test_regions_count_the_bands_of_motion(found):
    """As many bands as intervals of −1 < z < 1 in which g > 0, at random levels that are not critical."""
    _, values, U, diagram = found
    rng = np.random.default_rng(1)
    # the last reaches E1
    v, h = np.append(rng.uniform(-2, 2, 8), values["p_psi"]), rng.uniform(-1.5, 4, 9)
    z = np.cos(np.linspace(0, np.pi, 3001))[1:-1]
    ours = bands(diagram, v, h)
    for i, energy in enumerate(h):
        for j, momentum in enumerate(v):
            inside = np.concatenate([[False],
                                     np.polynomial.polynomial.polyval(z, g_of(values, U, momentum, energy))
                                     > 0])
            assert ours[i, j] == (inside[1:] & ~inside[:-1]).sum(), (momentum, energy)


@pytest.mark.slow
def test_the_picture():
    """Curves in the look of their verdict, E1 and E2 as markers, at the ends of the window.

    Arguments go to the curves.
    """
    scene, values, _ = CASES[2]
    window = (-3.0, 3.0, -1.5, 4.0)
    ax = draw_energy_momentum(scene, values, window, Figure().subplots(), alpha=0.5)
    curves = [line for line in ax.lines if line.get_marker() == "None"]
    diagram = energy_momentum(scene, values)
    for line, curve in zip(curves, diagram.curves, strict=True):
        np.testing.assert_array_equal(line.get_xydata().T, [curve.momentum, curve.energy])
        assert (line.get_linestyle() == "-") == (curve.verdict is gs.Verdict.STABLE)
        assert line.get_alpha() == 0.5
    points = [line.get_xydata()[0].tolist() for line in ax.lines if line.get_marker() == "o"]
    assert points == [[v, h] for v, h, _ in diagram.poles]
    assert {text.get_text() for text in ax.texts} == {"E1, focus-focus", "E2, focus-focus", "fold on a level"}
    assert (*ax.get_xlim(), *ax.get_ylim()) == window
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$C_{1}$ $[\mathrm{M\,L^{2}\,T^{-1}}]$",
                                                  r"$h$ $[\mathrm{M\,L^{2}\,T^{-2}}]$")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "stable (curves: modulo the spin)", "unstable", "1 band of $k_3$", "2 bands"]


@pytest.mark.slow
def test_all_that_is_critical_is_in_the_window(found):
    """With room below and above: E1, E2, where stability changes, and the curves beside them."""
    scene, values, _, diagram = found
    ax = draw_energy_momentum(scene, values, ax=Figure().subplots())
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    assert left == -right
    inside = np.concatenate([c.energy[np.abs(c.momentum) < right] for c in diagram.curves])
    heights = np.concatenate([inside, [h for _, h, _ in diagram.poles], [h for _, h in diagram.cusps]])
    assert low < heights.min() < heights.max() < high
    assert all(abs(v) < right for v, *_ in [*diagram.poles, *diagram.cusps])


@pytest.mark.filterwarnings("ignore:invalid value")
@pytest.mark.parametrize("numbers", [{"p_psi": "1e-350"}, {"I1": 10**400}])
def test_cuts_that_doubles_do_not_tell_apart_are_refused(numbers):
    """The two rates meet at P² = 4 I1 m0 k3, at a tilt that is no longer a double, or nearly none."""
    with pytest.raises(ScopeError, match="of so different sizes"):
        energy_momentum(TOP, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": 1} | numbers)


def test_what_cannot_be_drawn_is_refused():
    """U unspecified, a name that is missing, another body."""
    with pytest.raises(ScopeError, match="U.k3. is unspecified"):
        draw_energy_momentum(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()), {})
    with pytest.raises(ValuesError, match="the picture needs p_psi"):
        draw_energy_momentum(TOP, {"I1": 1, "I3": 1, "l": 0, "m0": 1})
    with pytest.raises(ScopeError, match="U is constant and p_psi = 0"):
        flat = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: 0 * k3))
        draw_energy_momentum(flat, {"I1": 1, "I3": 1, "l": 0, "p_psi": 0})
    with pytest.raises(ScopeError, match="body of revolution"):
        draw_energy_momentum(gs.assemble(gs.Gyrostat()), {})


@pytest.mark.slow
def test_a_field_that_is_multiplied_out():
    """U = 1/(3 k3 − 1)², written without the square: to the pole every value is a number, and the same."""
    k3, body = gs.symbol("k3"), {"I1": 2, "I3": 1, "l": 0, "p_psi": 1}
    curves = [energy_momentum(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U)), body).curves
              for U in (1 / (9 * k3**2 - 6 * k3 + 1), 1 / (3 * k3 - 1) ** 2)]
    for ours, theirs in zip(*curves, strict=True):
        np.testing.assert_allclose(ours.momentum, theirs.momentum, rtol=1e-12)
        np.testing.assert_allclose(ours.energy, theirs.energy, rtol=1e-12)
        assert np.isfinite(ours.energy).all()
