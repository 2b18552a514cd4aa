"""Closed curves of attitudes in orbit: stable as a set where K is positive across all of them."""
from fractions import Fraction as F

import numpy as np
import pytest
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import evaluate


def found(moments, rotor):
    """All equilibria at the rate 1."""
    return gs.relative_equilibria(gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(1)), {})


@pytest.mark.slow
def test_the_curve_of_equilibria():
    """L² = 4 ω0² a b: the cubic vanishes, and a closed curve joins the tilted families.

    Axis 2 has the least moment: the curve is stable as a set, a point of it is not decided.
    """
    equilibria = found(("3/2", "9/10", "6/5"), (0, 2 * sqrt(Rational(9, 50)), 0))
    on_curve = [e for e in equilibria if e.locus]
    assert len(on_curve) == 8
    assert on_curve and all("closed curve" in e.locus for e in on_curve)
    for e in on_curve:
        assert e.decision.stable and e.damped.stable
        assert e.decision.scope.startswith("as a set, the closed curve")
        assert gs.analyze(e.equilibrium).verdict({}) == e.decision
    assert len([e for e in equilibria if not e.locus]) == 8
    # λ² = −1, and 0 along the curve
    assert min(abs(x - 1) for e in on_curve for x in e.frequencies) < 1e-29


@pytest.mark.slow
@pytest.mark.parametrize(("moments", "least"), [((F(3), F(1), F(2)), True), ((F(2), F(1), F(4, 3)), True),
                                                ((F(9, 5), F(1), F(6, 5)), False)])
def test_k_is_positive_across_the_whole_curve(moments, least):
    """At places all along it; where a = 4b the curve meets n along the axis, and K vanishes twice there."""
    inertia = np.array([float(x) for x in moments])
    a, b = inertia[0] - inertia[1], inertia[2] - inertia[1]
    rotor, across = 2 * np.sqrt(a * b), []
    for z in np.linspace(1e-6, 1, 4001):
        rows = [-4 * a * a, 4 * (-b * b * z + (a - b)**2 * z + a * a * (1 - z)) + a * b,
                4 * b * b * (1 - z) * z - a * b * (1 - z)]
        for x in np.roots(rows):
            if abs(x.imag) < 1e-9 and x.real >= 0 and (y := 1 - x.real - z) > 1e-9:
                r = np.sqrt([x.real, y, z])
                n = (inertia * r - (inertia * r * r).sum() * r) / (-rotor * r[1] / 4)
                assert n @ n == pytest.approx(1, abs=1e-6)
                across.append(np.linalg.eigvalsh(stiffness(inertia, rotor, n, r)))
    across = np.array(across)
    assert len(across) > 30 and abs(across[:, 0]).max() < 1e-6
    assert (across[:, 1].min() > 1e-2) == least
    scene = gs.assemble(gs.Gyrostat([Rational(str(x)) for x in moments],
                                    (0, 2 * sqrt(Rational(str((moments[0] - 1) * (moments[2] - 1)))), 0)),
                        gs.circular_orbit(1))
    found = [e for e in gs.relative_equilibria(scene, {}) if e.locus]
    assert found and all(e.decision.stable == least for e in found)


def stiffness(inertia, rotor, n, r):
    """K in the basis t, n, r, at the rate 1."""
    frame = np.cross(n, r), n, r
    (tt, tn, _), (_, nn, nr), (_, _, rr) = [[(inertia * p) @ q for q in frame] for p in frame]
    along = rotor * n[1]
    return np.array([[4 * (nn - rr) + along, -3 * tn, 0], [-3 * tn, 3 * (tt - rr), 3 * nr],
                     [0, 3 * nr, nn - tt + along]])


def test_a_curve_that_is_left():
    """λ² in a complex pair, or one that is positive: unstable, whatever moves along the curve."""
    on_curve = [e for e in found(("3/2", 2, "9/5"), (0, sqrt(10) / 5, 0)) if e.locus]
    assert len(on_curve) == 8
    for e in on_curve:
        assert e.decision.verdict is gs.Verdict.UNSTABLE
        c2, c1, c0 = (float(evaluate(c, {})) for c in gs.derivation.linearize(e.equilibrium).coefficients)
        assert abs(c0) < 1e-15
        assert float(e.growth_rate) == pytest.approx(max(np.roots([1, 0, c2, 0, c1]).real), rel=1e-12)
