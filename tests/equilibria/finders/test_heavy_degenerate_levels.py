"""Every rotation where curves, complex or real, lie among them: against Newton's method, at 50 digits."""
import random

import any_level
import mpmath
import numpy as np
import pytest
from equilibria.degenerate_levels import KINDS, drawn
from heavy_scenes import DIRECTION, k1, k2, k3
from slow import sampled
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.balls import ball
from gyrostat.equilibria.finders.heavy import heavy_forms


def exact(x):
    return Rational(x.numerator, x.denominator)


def digits(x):
    return mpmath.mpf(ball(x, 400).mid().str(80, radius=False))


def on_continuum(rotation, k):
    """Whether k lies on the circle, or the other curve, of a rotation."""
    if rotation.form.curve is not None:
        scale = sum(abs(float(c)) for c in rotation.form.curve.as_coefficients_dict().values())
        return abs(float(rotation.form.curve.subs(dict(zip(DIRECTION, map(float, k)))))) < 1e-4 * scale
    if rotation.form.circle is None:
        return False
    axis = np.array([float(x) for x in rotation.form.circle])
    place = np.array([float(x) for x in rotation.directions[0]])
    return abs(axis @ (k - place)) < 1e-4 * (1 + np.linalg.norm(axis))


def check(kind, seed):
    """Nothing missing, nothing wrong, nothing twice; verdicts by signature and spectrum; how many points."""
    inertia, rotor, terms, asked = drawn(random.Random(f"{kind} {seed}"), kind)
    if not terms:
        return 0
    U = sum(exact(c) * k1**a * k2**b * k3**n for (a, b, n), c in terms.items())
    scene = gs.assemble(gs.Gyrostat(tuple(inertia), tuple(rotor)), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {name: exact(x) for name, x in asked.items()})
    with mpmath.workdps(60):
        places = [[digits(x) for x in r.directions[0]] for r in found]
        rates = [digits(r.rates["omega"]) for r in found]
    near = [np.array([float(x) for x in k]) for k in places]
    body = np.diag([float(x) for x in inertia]), np.array([float(x) for x in rotor])
    level, rate = (None if (x := asked.get(name)) is None else float(x) for name in ("C1", "omega"))
    field = {e: float(c) for e, c in terms.items()}
    for k, _, least in any_level.found(field, *body, level, rate):
        close = min((np.abs(k - place).max() for place in near), default=9.0)
        assert close < 1e-4 or least < 1e-6 or any(on_continuum(r, k) for r in found), (kind, seed, k)
    for n, (k, omega) in enumerate(zip(near, rates)):
        wanted, force, _ = any_level.slope(field, *body, k[None], level, rate)
        assert np.abs(np.cross(force[0], k)).max() < 1e-9 * (1 + np.abs(force).max()), (kind, seed, k)
        assert abs(wanted[0] - float(omega)) < 1e-8 * (1 + abs(wanted[0]))
        assert all(np.abs(k - other).max() > 1e-9 for other in near[:n])
    rows = [[x if i == j else x * 0 for j in range(3)] for i, x in enumerate(inertia)]
    for r, k, omega in zip(found, places, rates):
        wanted = any_level.kind(terms, rows, rotor, k, omega)
        if wanted in ("STABLE", "UNSTABLE"):
            assert r.decision.verdict.name == wanted, (kind, seed, k)
        elif wanted == "HELD":
            assert r.decision.notion != "spectral", (kind, seed, k)
    return sum(not r.locus for r in found)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_all_are_found_and_rightly_decided(kind, full):
    count = sampled(30, full, 3)
    assert sum(check(kind, seed) for seed in range(count)) > 0


def directions(U, inertia, values, rotor=(0, 0, 0)):
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U))
    return gs.relative_equilibria(scene, values)


@pytest.mark.parametrize("U, count", [(k1 * k2 + k3, 2), (k1**2 + 2 * k2**2 + k3, 6), (k1**3 + k3, 6)])
def test_at_rest_without_a_rotor(U, count):
    """C1 = 0 and l = 0: omega = 0, and k·Ik = 0 is a curve without real points."""
    found = directions(U, (1, 2, 3), {"C1": 0})
    assert len(found) == count and all(r.rates["omega"] == 0 and not r.locus for r in found)
    assert {tuple(r.directions[0]) for r in found} >= {(0, 0, 1), (0, 0, -1)}


def test_a_complex_curve_beside_the_principal_axes():
    """U = k·Ik on C1 = 1: where 2 (k·Ik)² = 1 every complex k is a rotation, no real one."""
    found = directions(k1**2 + 2 * k2**2 + 3 * k3**2, (1, 2, 3), {"C1": 1})
    assert {(r.directions[0], r.rates["omega"]) for r in found} == {
        (tuple(side * (m == n) for m in range(3)), Rational(1, n + 1)) for n in range(3) for side in (1, -1)}


def test_a_curve_of_rotations_is_named():
    """U = k·Ik on C1 = 3: omega = √2 and k·Ik = 3/√2 on a curve that is no circle."""
    found = directions(k1**2 + 2 * k2**2 + 3 * k3**2, (1, 2, 3), {"C1": 3})
    (r,) = [r for r in found if r.locus]
    assert abs(float(r.rates["omega"]) - 2**0.5) < 1e-12 and len(found) == 7
    assert r.form.heading == f"permanent rotation, one of those on {r.locus}"
    J = sum(n * float(x)**2 for n, x in enumerate(r.directions[0], 1))
    assert abs(J - 3 / 2**0.5) < 1e-12 and r.locus.startswith("a curve, ") and r.locus.endswith(" = 0")
    other = dict(zip(DIRECTION, (0, sqrt(3 - 3 / sqrt(2)), sqrt(3 / sqrt(2) - 2))))
    assert abs(float(r.form.curve.subs(other))) < 1e-12
    assert r.decision.verdict is gs.Verdict.UNDECIDED and "a curve of rotations" in r.decision.reason


def test_rotations_on_a_curve_are_unstable_by_their_spectrum():
    """U = ∓(k1 k2 + k3/2)² at rest: every point of a curve is a maximum across it, or a minimum."""
    for sign, verdict in ((-1, "UNSTABLE"), (1, "UNDECIDED")):
        (r,) = [r for r in directions(sign * (k1 * k2 + k3 / 2)**2, (1, 2, 3), {"omega": 0}) if r.locus]
        assert r.locus.startswith("a curve, ") and r.decision.verdict == verdict
        assert (r.decision.notion == "spectral") == (sign == -1)
        assert r.damped.verdict == "UNDECIDED"             # a list counts no modes that grow there


def test_circles_of_a_field_of_higher_degree():
    """U = (2 k3² − 1)² at rest: both poles, the equator and two circles, each by a point."""
    found = directions((2 * k3**2 - 1)**2, (1, 2, 3), {"omega": 0})
    assert sorted((r.directions[0][2], r.locus) for r in found) == [
        (-1, ""), (-sqrt(2) / 2, "the circle about axis 3"), (0, "the circle about axis 3"),
        (sqrt(2) / 2, "the circle about axis 3"), (1, "")]
    assert all(r.decision.verdict is gs.Verdict.UNSTABLE for r in found if r.directions[0][2] in (0, 1, -1))


def test_every_direction():
    """U = (k·k)² of a ball: constant on the sphere."""
    (r,) = heavy_forms(gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, 0)), gs.general_potential(
        (k1**2 + k2**2 + k3**2)**2 + k1 - k1)), {"omega": 0})
    assert r.locus == "the whole sphere"
