"""Verdicts of every kind against the motion.

The excursions from a perturbed equilibrium, in the size of the perturbation.
"""
from dataclasses import replace
from fractions import Fraction

import draw
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import ImmutableMatrix, Rational
from trajectories.confirming import LARGE, one_direction

import gyrostat as gs
from gyrostat.errors import ArgumentError, ScopeError, ValuesError
from gyrostat.stability.decision import Verdict
from gyrostat.trajectories import models
from gyrostat.trajectories.confirmation import confirm, moved
from gyrostat.trajectories.excursions import Distance
from gyrostat.trajectories.integrated import integrated_motion as integration

TOP = {"I1": 1, "I3": 1, "l": 0, "m0": 1}
COARSE = [Fraction(1, 10**d) for d in (3, 5, 7)]       # three sizes are enough for a slope
vectors = st.tuples(*[draw.numbers] * 3).map(lambda v: ImmutableMatrix([Rational(x) for x in v]))
few = pytest.fixture(autouse=True)(one_direction)


@pytest.fixture(scope="module")
def top():
    """The heavy top, upright, hanging and inclined."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    return {family: gs.analyze(getattr(gs, family)(scene)) for family in ("upright", "hanging", "inclined")}


@pytest.fixture(scope="module")
def quartic():
    """U = a k3⁴ + b k3²/2 + c k3."""
    a, b, c = map(gs.symbol, "abc")
    scene = gs.assemble(gs.symmetric_gyrostat(),
                        gs.axial_potential(lambda z: a * z**4 + b * z**2 / 2 + c * z))
    return {family: gs.analyze(getattr(gs, family)(scene)) for family in ("upright", "inclined")}


@pytest.fixture(scope="module")
def asymmetric_report():
    """I = (1, 2, 3), l = (0, 0, 1/2), U = k1 k2 + k3, spinning upright with π3."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/2")),
                        gs.general_potential(lambda x, y, z: x * y + z))
    return lambda spin: gs.analyze(gs.equilibrium(scene, (0, 0, spin, 0, 0, 1)))


@pytest.mark.slow
def test_a_sleeping_top_at_the_critical_spin(top):
    """I1 = m0 = 1, I3 ω3 = 2: stable, the distance goes with √ε.

    Above that spin with ε, below it is of order one.
    """
    critical = confirm(top["upright"], TOP | {"pi3_0": 2}, COARSE)
    assert critical.decision.verdict is Verdict.STABLE
    assert critical.expected == 0.5
    assert critical.agrees
    assert critical.complete
    assert critical.sizes == (1e-3, 1e-5, 1e-7)
    # the next term is ε as large
    np.testing.assert_allclose(np.diff(np.log10(critical.excursions)), -1, atol=0.01)
    assert abs(critical.slope - 0.5) < 1e-3
    above, below = (confirm(top["upright"], TOP | {"pi3_0": spin}, LARGE) for spin in ("5/2", "3/2"))
    assert above.agrees and above.expected == 1 and abs(above.slope - 1) < 1e-2
    assert below.agrees and below.expected == 0 and abs(below.slope) < 1e-2 and min(below.excursions) > 1


@pytest.mark.slow
@pytest.mark.parametrize("a, b, c, I1, pi3_0, verdict, slope", [
    (0, -2, 3, 1, 2, "UNSTABLE", 0), (-1, 0, 16, 3, 12, "STABLE", 1 / 4), (0, 1, -1, 1, 0, "STABLE", 1 / 2),
    *slow((1, -13, 10, 1, 2, "UNSTABLE", 0), ("1/16", "-7/4", "5/2", 1, 2, "STABLE", 1 / 6),
          (-1, 12, -8, 1, 0, "STABLE", 1 / 3))])
def test_boundary_at_a_pole(quartic, a, b, c, I1, pi3_0, verdict, slope):
    """P² = 4 I1 U′(1) and c_n the first coefficient of g: ε to the power 1/(2n), 1/(n + 1) where P = 0.

    Of order one where unstable.
    """
    found = confirm(quartic["upright"], {"a": a, "b": b, "c": c, "I1": I1, "I3": 1, "l": 0, "pi3_0": pi3_0},
                    COARSE if slope else LARGE)
    assert found.decision.verdict.name == verdict
    assert found.expected == slope
    assert found.agrees
    assert found.complete
    # next terms: ε^(1/6) or less
    assert abs(found.slope - slope) < 0.02


@pytest.mark.slow
@pytest.mark.parametrize("a, b, c, verdict, slope", [
    (0, 1, 0, "STABLE", 1), (0, -2, 0, "UNSTABLE", 0), (0, -1, 0, "STABLE", 1 / 3),
    *slow((-1, -1, 0, "UNSTABLE", 0), (0, -2, 1, "UNSTABLE", 0), (0, -2, -1, "UNSTABLE", 0))])
def test_inclined_modulo_the_spin(quartic, a, b, c, verdict, slope):
    """E3 with its axis horizontal, l = c.

    Definite, indefinite, and p = 0 with the first coefficient of order 4, 4 and 3.

    Of order 3, at a fold, one sign of the perturbation leads away, and the other does not.
    """
    found = confirm(quartic["inclined"], {"a": a, "b": b, "c": c, "I1": 1, "I3": 2, "omega": 1, "k3": 0},
                    COARSE if slope else LARGE)
    assert found.decision.verdict.name == verdict
    assert found.expected == slope
    assert found.agrees
    assert found.complete
    assert found.decision.modulo and abs(found.slope - slope) < 0.02


def test_every_vertical_and_tilted_top(top):
    """E2 of the heavy top, and a steady precession, are stable: the excursion is proportional to ε."""
    for family, values in (("hanging", TOP | {"pi3_0": 1}),
                           ("inclined", {"I1": 2, "I3": 1, "m0": 3, "k3": "3/5", "omega": 1, "l": "18/5"})):
        found = confirm(top[family], values, COARSE)
        assert found.agrees and found.expected == 1 and abs(found.slope - 1) < 1e-3
        assert max(e / s for e, s in zip(found.excursions, found.sizes)) < 20


@pytest.mark.parametrize("axis, verdict", [(1, "STABLE"), (2, "UNSTABLE"), (3, "STABLE")])
def test_free_body(axis, verdict):
    """About its intermediate axis a free body turns over, about the two others it stays."""
    body = gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), axis))
    found = confirm(body, {f"omega{axis}_0": 1}, COARSE)
    assert found.decision.verdict.name == verdict and found.agrees and found.complete
    # 2 |M| = 4
    assert found.routes == ("free body",) and (axis != 2 or min(found.excursions) > 3.9)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["heyoka", *slow(("DOP853",))])
def test_asymmetric_body_in_a_field(asymmetric_report, monkeypatch, method):
    """Integrated motions, over some turns and not a whole orbit: definite, and with a growing mode."""
    pytest.importorskip(method if method == "heyoka" else "scipy")
    monkeypatch.setattr(integration, "find_spec", lambda name: method == "heyoka" or None)
    for spin, verdict in ((4, "STABLE"), (2, "UNSTABLE")):
        found = confirm(asymmetric_report(spin), {}, LARGE)
        assert found.decision.verdict.name == verdict
        assert found.agrees
        assert not found.complete
        assert found.routes == (method,)


def test_sizes_that_do_not_tell(top):
    """Closer to the boundary than the sizes go, an unstable top moves like a stable one on it.

    Neither agreed nor denied.
    """
    near = confirm(top["upright"], TOP | {"pi3_0": 2 - Fraction(1, 10**9)}, COARSE)
    assert near.decision.verdict is Verdict.UNSTABLE and near.agrees is None and abs(near.slope - 0.5) < 0.05


@pytest.mark.slow
@pytest.mark.parametrize("method", ["DOP853", "heyoka"])
def test_too_slow_an_escape_is_not_waited_for(asymmetric_report, monkeypatch, method):
    """The growth is 3·10⁻⁵ of a turn: neither agreed nor denied, and the time it takes is named."""
    pytest.importorskip(method if method == "heyoka" else "scipy")
    monkeypatch.setattr(integration, "find_spec", lambda name: method == "heyoka" or None)
    found = confirm(asymmetric_report(Fraction(19466783, 6250000)), {}, LARGE)
    assert found.decision.verdict is Verdict.UNSTABLE
    assert found.agrees is None and found.sizes == ()
    assert "until t = 4.12e+05 it takes about" in found.why and f"steps of {method}, more than" in found.why


@pytest.mark.slow
def test_an_escape_without_growth_is_not_denied(quartic, monkeypatch):
    """ẍ = c x³ leaves after a time like 1/ε: integrated for less, a motion says nothing against it."""
    pytest.importorskip("heyoka")
    monkeypatch.setattr(models, "_route", lambda scene, point, bits, tolerance: models.Integration(
        scene, point, tolerance))
    values = {"a": -1, "b": -1, "c": 0, "I1": 1, "I3": 2, "omega": 1, "k3": 0}
    found = confirm(quartic["inclined"], values, [Fraction(1, 10**d) for d in (6, 7, 8)])
    assert found.decision.verdict is Verdict.UNSTABLE and found.routes == ("heyoka",)
    assert found.slope > 0.9 and found.agrees is None and "no linear growth" in found.why


@pytest.mark.parametrize("slope, stable, unstable",
                         [(0.0, False, True), (0.3, None, None), (0.5, True, None), (1.0, None, False)])
def test_agreement_has_three_values(top, slope, stable, unstable):
    """A slope of 0 speaks against stability, one of 1 for it, one in between for what it is expected for."""
    critical = confirm(top["upright"], TOP | {"pi3_0": 2}, COARSE)
    assert replace(critical, slope=slope).agrees is stable
    assert (
        replace(critical, slope=slope, decision=replace(critical.decision, verdict=Verdict.UNSTABLE)).agrees
        is unstable
    )
    left = replace(critical, slope=slope, failure="not for long enough",
                   decision=replace(critical.decision, verdict=Verdict.UNSTABLE))
    assert left.agrees is (None if unstable is False else unstable)


@settings(max_examples=10)
@given(turn=vectors, change=vectors, tilt=draw.tilts, spin=draw.numbers)
def test_a_moved_point_keeps_the_length_of_k(turn, change, tilt, spin):
    """abs(k)² = 1 exactly, π is changed by what is given, and k turns about the vector by 2
    arctan(abs(vector)/2).
    """
    k = ImmutableMatrix([Rational(tilt[0]), 0, Rational(tilt[1])])
    new = moved((0, Rational(spin), 0, *k), turn, change)
    turned = ImmutableMatrix(new[3:])
    assert turned.dot(turned) == 1 and turned.dot(turn) == k.dot(turn)
    assert tuple(new[:3]) == tuple(change + ImmutableMatrix([0, Rational(spin), 0]))
    across = turn.cross(k)
    assert across.dot(across) * turned.dot(across) == across.dot(across) ** 2 / (1 + turn.dot(turn) / 4)


def test_distance_modulo_the_spin(quartic):
    """Turned about axis 3, the equilibrium is at the distance 0 from itself, and of states a small distance
    apart no digit is lost.
    """
    report = quartic["inclined"]
    point = [Rational(x) for x in (1, 0, 2, "3/5", 0, "4/5")]
    decision = report.verdict({"a": 0, "b": 0, "c": 0, "I1": 1, "I3": 2, "omega": 1, "k3": 0})
    modulo, itself = (Distance(report.equilibrium, d, point)
                      for d in (decision, replace(decision, modulo=())))
    c, s = np.cos(2.5), np.sin(2.5)
    turned = np.array([[c, s, 2, 0.6 * c, 0.6 * s, 0.8], [1, 0, 2, 0.6, 0, 0.8 + 1e-9]])
    np.testing.assert_allclose(modulo(turned), [0, 1e-9], rtol=1e-6, atol=1e-15)
    assert itself(turned)[0] > 1


def test_what_cannot_be_confirmed_is_refused(scene, top):
    """No motion in an unspecified U; the body needs all its moments; sizes have to fall."""
    values = {"I1": 1, "I3": 1, "l": 0, "pi3_0": 3, "dU": 1}
    with pytest.raises(ScopeError, match="unspecified"):
        confirm(gs.analyze(gs.upright(scene)), values)
    with pytest.raises(ValuesError, match="needs I3, a verdict may not"):
        confirm(top["upright"], {"I1": 1, "l": 0, "m0": 1, "pi3_0": 3})
    for sizes in ([0.1, 0.01], [0.01, 0.1, 1], [0.1, 0.01, -1]):
        with pytest.raises(ValuesError, match="at least three, positive and falling"):
            confirm(top["upright"], TOP | {"pi3_0": 2}, sizes)
    with pytest.raises(ArgumentError, match="the report is an Equilibrium"):
        confirm(top["upright"].equilibrium, {})
