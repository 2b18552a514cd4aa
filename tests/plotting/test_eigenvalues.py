"""Eigenvalues along a parameter, against those of differenced equations of motion."""
import numpy as np
import oracle
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from sympy import exp

import gyrostat as gs
from gyrostat.errors import ArgumentError, ScopeError, ValuesError
from gyrostat.parameters.spectra import spectrum
from gyrostat.plotting import draw_eigenvalues

TOP = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0")
FREE = gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))), 3)
SLEEPING = {"I1": 1, "I3": "8/5", "l": 0, "m0": 1}


def agree(ours, theirs):
    """Every eigenvalue of ours is one of theirs.

    Those of theirs that are left belong to the Casimirs and are 0.
    """
    for value in ours:
        n = int(np.argmin(np.abs(theirs - value)))
        assert abs(theirs[n] - value) < 1e-6               # a double one has the root of the round-off
        theirs = np.delete(theirs, n)
    np.testing.assert_allclose(theirs, 0, atol=1e-6)


def test_a_parameter_that_is_none_is_refused():
    """The spectrum does not depend on it."""
    with pytest.raises(ValuesError, match="the spectrum of E1 has no parameter nothing"):
        draw_eigenvalues(TOP, "nothing", [0, 1], {**SLEEPING, "omega3_0": 1}, Figure().subplots())


def test_the_sleeping_top():
    """The six eigenvalues of the Euler-Poisson field are ours and two zeros."""
    found = spectrum(TOP, "omega3_0", np.linspace(2.3, 0.1, 23), SLEEPING)
    inertia, rotor = np.array([1, 1, 1.6]), np.zeros(3)
    for spin, ours in zip(found.parameter, found.eigenvalues):
        x = np.array([0, 0, 1.6 * spin, 0, 0, 1])
        J = oracle.jacobian(lambda y: oracle.field(y, inertia, rotor, oracle.axial_slope(1.0, 0.0, 1.0)), x,
                            1.0)
        agree(ours, np.linalg.eigvals(J.astype(float)))


def test_the_free_gyrostat():
    """The three of M' = M × ω are ours and one zero; they meet at 0 where f1 f2 = 0."""
    found = spectrum(FREE, "l", np.linspace(-3, 3, 20), {"I1": 1, "I2": 3, "I3": 2, "omega3_0": 1})
    for l, ours in zip(found.parameter, found.eigenvalues):
        J = oracle.jacobian(lambda y, l=l: oracle.free_field(y, np.array([1.0, 3, 2]), np.array([0, 0, l])),
                            np.array([0.0, 0, 2]), 1.0)
        agree(ours, np.linalg.eigvals(J.astype(float)))
    assert [(c.kind, c.value, c.changes, c.eigenvalues.tolist()) for c in found.collisions] == [
        ("zero eigenvalue", -1, True, [0]), ("zero eigenvalue", 1, True, [0])]


def test_a_satellite_with_a_pitch_wheel():
    """All six, of I θ̈ + g × θ̇ + K θ = 0 with K and g as printed; they meet where roll and yaw change."""
    I1, I2, I3 = 1, 0.7, 0.8
    body = gs.Gyrostat((1, "7/10", "4/5"), (0, gs.symbol("l"), 0))
    pointing = gs.earth_pointing(gs.assemble(body, gs.circular_orbit(1)))
    found = spectrum(pointing, "l", np.linspace(2, -2, 41), {})
    assert found.eigenvalues.shape == (45, 6) and np.abs(np.diff(found.eigenvalues, axis=0)).max() < 0.3
    for l, ours in zip(found.parameter, found.eigenvalues):
        K = np.diag([4 * (I2 - I3) + l, 3 * (I1 - I3), I2 - I1 + l])
        turning = (I1 + I3 - I2 - l) * np.array([[0, 0, 1], [0, 0, 0], [-1, 0, 0]])
        over = np.diag([1 / I1, 1 / I2, 1 / I3])
        theirs = np.linalg.eigvals(np.block([[np.zeros((3, 3)), np.eye(3)], [-over @ K, -over @ turning]]))
        agree(ours, theirs)
    assert [(c.kind, c.changes) for c in found.collisions] == [("Hamiltonian Hopf", True)] * 2 + [
        ("zero eigenvalue", True)] * 2
    np.testing.assert_allclose([c.value for c in found.collisions], [
        -1.4134959831540943713, 0.020762905883088805319, 0.3, 0.4], atol=1e-15)


def test_six_that_are_in_no_factors():
    """A refusal, not the roots of another polynomial."""
    tensor = [["3/2", "1/10", 0], ["1/10", 2, "1/20"], [0, "1/20", 1]]
    orbit = gs.circular_orbit(1)
    held = gs.earth_pointing_gyrostat(gs.Gyrostat(tensor, (0, gs.symbol("l"), 0)), orbit)
    with pytest.raises(ScopeError, match="degree six that does not factor"):
        spectrum(gs.earth_pointing(gs.assemble(held, orbit)), "l", (0, 1), {})


def test_the_collision_of_the_sleeping_top():
    """At I3² ω² = 4 I1 m0, to the last bits, at ±i abs(P/(2 I1) − ω).

    Two steps beside it the spectrum is of another kind.
    """
    (met,) = spectrum(TOP, "omega3_0", np.linspace(2.3, 0.1, 23), SLEEPING).collisions
    assert (met.value, met.kind, met.changes) == (1.25, "Hamiltonian Hopf", True)
    np.testing.assert_allclose(sorted(met.eigenvalues.imag), [-0.25, 0.25], atol=1e-15)


def test_a_disc():
    """I3 = 2 I1 without a rotor.

    At E1 p² = 4q everywhere, two pairs meet at 0 together where I3² ω² = 4 I1 U'(1).
    """
    for U in (gs.symbol("m0") * gs.symbol("k3"), exp(gs.symbol("m0") * gs.symbol("k3"))):
        eq = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U)), spin="omega3_0")
        (met,) = spectrum(eq, "m0", np.linspace(3, 0.1, 80),
                          {"I1": 1, "I3": 2, "l": 0, "omega3_0": 1}).collisions
        assert (met.kind, met.changes, met.eigenvalues.tolist()) == ("zero eigenvalue", True, [0])
        assert met.value * np.exp(0 if U.is_polynomial() else met.value) == pytest.approx(1)


def test_a_crossing_in_the_middle_of_the_range():
    """E1, l = 0, U'(1) > 0: at π3 = 0, the middle, p² − 4q touches 0 from below.

    Beside it is a complex quadruple.
    """
    eq = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()))
    found = spectrum(eq, "pi3_0", np.linspace(-3, 3, 40), {"I1": 1, "I3": "9/8", "l": 0, "m0": 5})
    assert found.collisions == [] and (np.abs(found.eigenvalues[[0, -1]].imag) > 0.1).all()


def test_e3_collides_at_0():
    """At E3 λ² (λ² + p): two eigenvalues stay at 0, the others meet there where p = 0."""
    eq = gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3**4 - k3**2 / 2)))
    found = spectrum(eq, "omega", np.linspace(0.1, 2, 30), {"I1": 2, "I3": 1, "k3": "1/10"})
    assert len(found.collisions) == 1 and np.sort(np.abs(found.eigenvalues), axis=1)[:, :2].max() == 0


def test_columns_are_continuous():
    """From one sample to the next each eigenvalue takes the shortest way, through the collision too."""
    found = spectrum(TOP, "omega3_0", np.linspace(2.3, 0.1, 400), SLEEPING)
    # a root of the step beside the collision
    assert np.abs(np.diff(found.eigenvalues, axis=0)).max() < 0.08
    assert 1.25 == pytest.approx(found.parameter[np.argmin(np.abs(found.parameter - 1.25))], abs=1e-15)


def test_the_picture():
    """One curve for each eigenvalue, coloured by the parameter, crosses at the collisions, axes named."""
    ax = draw_eigenvalues(TOP, "omega3_0", np.linspace(2.3, 0.1, 60), SLEEPING, Figure().subplots(),
                          linewidths=1.5)
    (lines,) = [c for c in ax.collections if isinstance(c, LineCollection)]
    found = spectrum(TOP, "omega3_0", np.linspace(2.3, 0.1, 60), SLEEPING)
    starts = np.array([segment[0] for segment in lines.get_segments()])
    np.testing.assert_array_equal(starts @ [1, 1j], found.eigenvalues[:-1].T.ravel())
    assert lines.get_linewidth() == 1.5
    assert lines.get_array()[0] == found.parameter[:2].mean()
    assert lines.get_cmap().name == "cividis"
    (crosses,) = [line for line in ax.lines if line.get_marker() == "x"]
    assert len(crosses.get_xdata()) == 2
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "Hamiltonian Hopf, stability changes"]
    (said,) = [text for text in ax.texts if text.get_text()]
    assert said.get_text() == r"$\omega_3^0 = 1.25$" and said.xy in list(map(tuple, crosses.get_xydata()))
    FigureCanvasAgg(ax.figure).draw()
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    box = ax.get_window_extent()
    # Matplotlib leaves limits as they are that are within half a per cent of equal units
    assert box.width / (right - left) == pytest.approx(box.height / (high - low), rel=0.005)
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$\mathrm{Re}\,\lambda$ $[\mathrm{T^{-1}}]$",
                                                  r"$\mathrm{Im}\,\lambda$ $[\mathrm{T^{-1}}]$")
    assert ax.figure.axes[1].get_ylabel() == r"$\omega_3^0$ $[\mathrm{T^{-1}}]$"


def test_what_cannot_be_drawn_is_refused():
    """A name that is missing, samples that go back and forth, a scene in the place of an equilibrium."""
    with pytest.raises(ValuesError, match="the spectrum of E1 needs I3"):
        draw_eigenvalues(TOP, "omega3_0", [1, 2], {"I1": 1, "l": 0, "m0": 1})
    with pytest.raises(ValuesError, match="increasing or decreasing"):
        draw_eigenvalues(TOP, "omega3_0", [1, 2, 1], SLEEPING)
    with pytest.raises(ArgumentError, match="the equilibrium is a System"):
        draw_eigenvalues(TOP.system, "omega3_0", [1, 2], SLEEPING)
