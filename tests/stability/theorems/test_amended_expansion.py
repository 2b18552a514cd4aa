"""Minima and maxima of the amended potential beyond the second variation."""
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import Rational, cosh, exp, pi, sqrt, symbols

import gyrostat as gs
from gyrostat.algebra.solving.binary_forms import valley, values_of
from gyrostat.parameters.stabilizing_set import stabilizing_set

UP, NORTH = (0, 0, 0, 0, 0, 1), (0, 0, 0, 2 * Rational(1, 3), Rational(1, 3), 2 * Rational(1, 3))
x, y = symbols("x y", real=True)


def decided(inertia, rotor, U, point, values=None):
    scene = gs.assemble(gs.Gyrostat(inertia=inertia, gyrostatic_momentum=rotor), gs.general_potential(U))
    return gs.analyze(gs.equilibrium(scene, point)).verdict(values or {})


@pytest.mark.few(2)
@pytest.mark.parametrize("U, rotor, expected", [
    (lambda a, b, c: a**4 + b**4, (0, 0, 0), "STABLE"),
    (lambda a, b, c: (b + a**2) ** 2 + a**6, (0, 0, 0), "STABLE"),
    (lambda a, b, c: exp(c) * (a**4 + b**4), (0, 0, 0), "STABLE"),
    (lambda a, b, c: a**4 - 2 * a**2 * b**2 + (1 + Rational(1, 10**30)) * b**4, (0, 0, 0), "STABLE"),
    (lambda a, b, c: a**4 - 2 * a**2 * b**2 + (1 - Rational(1, 10**30)) * b**4, (0, 0, 0), "UNSTABLE"),
    (lambda a, b, c: (b + a**2) ** 2 + a**5, (0, 0, 0), "UNSTABLE"),
    (lambda a, b, c: a**3 + b**2, (0, 0, 1), "UNSTABLE"),
    (lambda a, b, c: a**4 + b**6, (0, 0, 0), "UNDECIDED"),
    *slow(
        (lambda a, b, c: a**2 + b**4, (0, 0, 0), "STABLE"),
        (lambda a, b, c: a**4 + b**4, (0, 0, 1), "STABLE"),
        (lambda a, b, c: a**4 + b**4, (1, -2, 1), "STABLE"),
        (lambda a, b, c: a**6 + a**2 * b**4 + b**6, (0, 0, 0), "STABLE"),
        (lambda a, b, c: a**14 + b**14, (0, 0, 0), "STABLE"),
        (lambda a, b, c: cosh(a) - a**2 / 2 + b**2, (0, 0, 0), "STABLE"),
        (lambda a, b, c: pi * a**4 + b**4, (0, 0, 0), "STABLE"),
        (lambda a, b, c: (a**4 + b**4) / (2 + c), (0, 0, 0), "STABLE"),
        (lambda a, b, c: -(a**4) - b**4, (0, 0, 0), "UNSTABLE"),
        (lambda a, b, c: a**2 - b**4, (0, 0, 0), "UNSTABLE"),
        (lambda a, b, c: a**3 + b**2, (0, 0, 0), "UNSTABLE"),
        (lambda a, b, c: a**3 * b, (0, 0, 0), "UNSTABLE"),
        (lambda a, b, c: -(a**4) - b**4, (0, 0, 1), "UNDECIDED"),
        (lambda a, b, c: a**2, (0, 0, 0), "UNDECIDED"))])
def test_rest_in_a_degenerate_field_is_decided_by_the_leading_form(U, rotor, expected):
    """Lagrange-Dirichlet where it is positive; Chetaev where it is not and l = 0.

    With l ≠ 0 Sokolskii where one direction is degenerate; nothing where two are.
    """
    decision = decided((1, 2, 3), rotor, U, UP)
    assert decision.verdict.name == expected, decision


@pytest.mark.parametrize("U, rotor, point, expected", [
    (lambda a, b, c: 0, (0, 0, 1), UP, "STABLE"),
    (lambda a, b, c: 0, (0, 0, -1), UP, "STABLE"),
    (lambda a, b, c: a**2 + b**2 + c**2, (2, 1, 2), NORTH, "STABLE"),
    (lambda a, b, c: exp(a**2 + b**2 + c**2), (0, 0, 1), UP, "STABLE"),
    (lambda a, b, c: 0, (0, 0, 1), NORTH, "UNSTABLE"),
    (lambda a, b, c: 0, (0, 0, 0), UP, "UNSTABLE"),
    (lambda a, b, c: 0, (0, 0, -1), (0, 0, 1, 0, 0, 1), "UNDECIDED")])
def test_rest_without_torque_is_decided_by_the_momentum(U, rotor, point, expected):
    """k along l ≠ 0 is stable, because M and k stay where they are in space; any other k is carried away.

    M = 0 is left open.
    """
    inertia = (1, 2, 2) if expected == "UNDECIDED" else (1, 2, 3)
    decision = decided(inertia, rotor, U, point)
    assert decision.verdict.name == expected, decision


def torque_free_motion(inertia, rotor, start, time, steps):
    """k along the Euler-Poisson equations without torque, by Runge-Kutta."""
    I, l = np.array(inertia, float), np.array(rotor, float)

    def rate(z):
        w = z[:3] / I
        return np.concatenate([np.cross(z[:3] + l, w), np.cross(z[3:], w)])

    return run(rate, start, time, steps)


def run(rate, start, time, steps):
    z, h, found = np.array(start, float), time / steps, []
    for _ in range(steps):
        a = rate(z)
        b = rate(z + h / 2 * a)
        c = rate(z + h / 2 * b)
        z = z + h / 6 * (a + 2 * b + 2 * c + rate(z + h * c))
        found.append(z)
    return np.array(found)


@pytest.mark.slow
def test_a_slow_turn_carries_k_away_where_k_is_not_along_the_rotor():
    """Motions that start within 10⁻² of rest.

    The direction k stays within a few 10⁻² if k ∥ l, else it goes far.
    """
    l, small = np.array([0, 0, 1.0]), 1e-2
    along = torque_free_motion((1, 2, 3), l, [small, small, small, 0, 0, 1], 2000, 8000)
    across = torque_free_motion((1, 2, 3), l, [0, 0, small, 0.6, 0, 0.8], 2000, 8000)
    assert np.abs(along[:, 3:] - [0, 0, 1]).max() < 0.1 and np.abs(across[:, 3:] - [0.6, 0, 0.8]).max() > 1


numbers = st.fractions(min_value=-3, max_value=3, max_denominator=4)
moments = st.fractions(min_value=Fraction(1, 2), max_value=4, max_denominator=4)


def basis(k):
    """Two vectors across k, rational."""
    a = np.cross(k, [0, 0, 1] if k[0] or k[1] else [1, 0, 0])
    return a, np.cross(k, a)


@pytest.mark.slow
@settings(max_examples=10)
@given(st.tuples(moments, moments, moments), st.tuples(numbers, numbers, numbers),
       st.sampled_from([2, 4, 6]), st.sampled_from([4, 6]),
       st.sampled_from([(2, 1, 2), (-1, 2, 2), (0, 0, -3), (3, 0, 0)]), numbers, st.sampled_from([1, -1]))
def test_a_field_with_a_minimum_by_construction_is_stable_and_its_opposite_at_rest_is_not(
        inertia, rotor, p, q, axis, tilt, side):
    """U = ±((a·k)ᵖ + (b·k + tilt (a·k)²)^q (2 + k1)), a and b across k0.

    0 at k0 alone nearby. No number of it is special to our chart.
    """
    k0 = [Rational(n, 3) for n in axis]
    a, b = ([Rational(int(n)) for n in v] for v in basis(axis))

    def U(*k):
        u, v = (sum(c * x for c, x in zip(vector, k)) for vector in (a, b))
        return side * (u**p + (v + Rational(tilt) * u**2) ** q * (2 + k[0]))

    if side == 1 and (p == q or p == 2 or tilt == 0 and p == q):
        assert decided(inertia, rotor, U, (0, 0, 0, *k0)).verdict.name == "STABLE"
    if side == -1:
        decision = decided(inertia, (0, 0, 0), U, (0, 0, 0, *k0))
        assert decision.verdict.name == "UNSTABLE", decision


@pytest.mark.slow
@given(moments, moments, moments, numbers, numbers, numbers)
@settings(max_examples=12)
def test_a_pitchfork_of_a_turning_body_is_stable_where_the_amended_potential_has_a_minimum(
    I1, I2, I3, l, w, b
):
    """E1 with l on axis 3, U = m0 k3 + b k1⁴, where the form vanishes along k1.

    The fourth degree, expanded here by itself.
    """
    m0 = (I3 - I1) * w**2 + l * w
    if (I3 - I2) * w**2 + l * w - m0 <= 0:
        return
    decision = decided((I1, I2, I3), (0, 0, l), lambda x, y, z: Rational(m0) * z + Rational(b) * x**4,
                       (0, 0, I3 * w, 0, 0, 1))
    # z = √(1 − s) with s = x²: U_c = m0 z + b s² + (c − l z)²/(2 (I1 s + I3 (1 − s)))
    c = I3 * w + l
    z2 = Fraction(-1, 8)                               # z = 1 − s/2 + z2 s²
    n0, n1, n2 = (c - l) ** 2, (c - l) * l, l**2 / 4 - 2 * (c - l) * l * z2
    r = (I1 - I3) / I3
    fourth = m0 * z2 + b + (n2 - n1 * r + n0 * r**2) / (2 * I3)
    assert m0 * Fraction(-1, 2) + (n1 - n0 * r) / (2 * I3) == 0
    if fourth:
        assert decision.verdict.name == ("STABLE" if fourth > 0 else "UNSTABLE"), (decision, fourth)


def escapes(U_slope, inertia, small, time):
    """The largest tilt from e3 of a motion that starts at rest, tilted by small."""
    I = np.array(inertia, float)

    def rate(z):
        w = z[:3] / I
        return np.concatenate([np.cross(z[:3], w) + np.cross(z[3:], U_slope(z[3:])), np.cross(z[3:], w)])

    return np.abs(run(rate, [0, 0, 0, small, small, np.sqrt(1 - 2 * small**2)], time, 6000)[:, 3:5]).max()


@pytest.mark.slow
@pytest.mark.parametrize("slope, bound", [
    (lambda k: np.array([4 * k[0] ** 3, 4 * k[1] ** 3, 0]), False),
    (lambda k: np.array([-4 * k[0] ** 3, -4 * k[1] ** 3, 0]), True),
    (lambda k: np.array([2 * k[0], -4 * k[1] ** 3, 0]), True),
    (lambda k: np.array([3 * k[0] ** 2, 2 * k[1], 0]), True),
    (lambda k: np.array([3 * k[0] ** 2 * k[1], k[0] ** 3, 0]), True)])
def test_motions_at_rest_do_what_the_leading_form_says(slope, bound):
    """Euler-Poisson from a tilt of 0.1.

    It grows fivefold where the form takes negative values, and not twofold where it has a minimum.
    """
    tilt = max(escapes(slope, (1, 2, 3), 0.1 * side, 120) for side in (1, -1))
    assert tilt > 0.5 if bound else tilt < 0.2


@pytest.mark.slow
@given(st.lists(numbers, min_size=5, max_size=5))
def test_signs_of_a_form_are_those_of_its_values(coefficients):
    """A binary quartic, at 400 directions."""
    form = {(4 - n, n): Rational(c) for n, c in enumerate(coefficients) if c}
    if form:
        angles = np.linspace(0, np.pi, 400)
        values = sum(float(c) * np.cos(angles) ** i * np.sin(angles) ** j for (i, j), c in form.items())
        found = values_of(form, 4)
        # a sine of 400 directions, doubles
        assert {1} <= found if values.max() > 1e-9 else 1 not in found
        assert {-1} <= found if values.min() < -1e-9 else True


@given(numbers, numbers, numbers, numbers)
def test_the_valley_is_found_along_a_curved_bottom(shear, bend, third, fourth):
    """(x + shear y + bend y²)² + third y³ + fourth y⁴ has the lowest values third y³ + fourth y⁴ over x."""
    value = ((x + Rational(shear) * y + Rational(bend) * y**2) ** 2 + Rational(third) * y**3
             + Rational(fourth) * y**4).expand()
    forms = [{k: c for k, c in value.as_poly(x, y).terms() if sum(k) == n and c} for n in range(5)]
    assert list(valley(forms)) == [Rational(third), Rational(fourth)]


def test_a_name_that_the_leading_form_needs_is_asked_for():
    """No verdict without it, and the right one with it."""
    a = gs.symbol("a")
    missing = decided((1, 2, 3), (0, 0, 0), lambda u, v, w: a * u**4 + v**4, UP)
    assert missing.verdict.name == "UNDECIDED" and "give a " in missing.reason
    for value, expected in ((1, "STABLE"), (-1, "UNSTABLE"), ("pi", "STABLE"), ("sqrt(2) - 3/2", "UNSTABLE"),
                            (0, "UNDECIDED")):
        assert (
            decided((1, 2, 3), (0, 0, 0), lambda u, v, w: a * u**4 + v**4, UP, {"a": value}).verdict.name
            == expected
        )


@pytest.mark.slow
def test_irrational_directions_are_expanded_exactly():
    """At (1, 1, 1)/√3."""
    k0 = (1 / sqrt(3),) * 3
    for U, expected in ((lambda a, b, c: (a - b) ** 4 + (b - c) ** 4, "STABLE"),
                        (lambda a, b, c: (a - b) ** 2 - (b - c) ** 4, "UNSTABLE")):
        assert decided((1, 2, 3), (0, 0, 0), U, (0, 0, 0, *k0)).verdict.name == expected


def test_a_set_of_values_is_not_claimed_where_the_second_variation_is_degenerate_throughout():
    """U = (a − 1) k1⁴ + k2⁴ changes at a = 1, which no margin of second order sees."""
    a = gs.symbol("a")
    scene = gs.assemble(gs.Gyrostat(inertia=(1, 2, 3), gyrostatic_momentum=(0, 0, 0)), gs.general_potential(
        lambda u, v, w: (a - 1) * u**4 + v**4))
    found = stabilizing_set(gs.analyze(gs.equilibrium(scene, UP)), "a", {})
    assert [found.contains({"a": value}) for value in (0, 1, 2)] == [None] * 3
