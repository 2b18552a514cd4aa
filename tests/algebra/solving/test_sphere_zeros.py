"""Zeros of polynomials on the sphere: points beside complex curves, curves, circles."""
import pytest
from sympy import Rational, S, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import evaluate, sign_of_constant
from gyrostat.algebra.solving.sphere_zeros import zeros_on_sphere

k1, k2, k3 = K = tuple(gs.symbol(f"k{n}") for n in (1, 2, 3))
HALF = Rational(1, 2)
J = k1**2 + 2 * k2**2 + 3 * k3**2                      # at least 1 where k is real


def points(polynomials, but=S.One):
    """As exact triples; there is no curve."""
    found = zeros_on_sphere(polynomials, K, but)
    assert found.curves == []
    assert len(found.points) == len(set(map(tuple, found.points)))
    return set(map(tuple, found.points))


def test_zeros_that_count_twice_and_zeros_left_out():
    assert points([k1**2, k2]) == {(0, 0, -1), (0, 0, 1)}
    both = [k1 * k3, (k2 - 1) * (2 * k2 - 1) * k2, k1 * (k1 - HALF)]
    assert points(both, but=k2) == {(0, 1, 0), (0, HALF, sqrt(3) / 2), (0, HALF, -sqrt(3) / 2)}
    assert points(both) == {(0, 1, 0), (0, HALF, sqrt(3) / 2), (0, HALF, -sqrt(3) / 2), (0, 0, 1), (0, 0, -1)}
    assert points([k1 - 2, k3 - 1, k2 - 1]) == set()


def test_a_basis_that_one_does_not_reach_is_none():
    """Monomials that lead nothing up to a degree may depend on each other: a higher degree is taken."""
    sides = (-sqrt(2) / 2, sqrt(2) / 2)
    given = [k1**2 * (k1 + 2 * k2), 2 * k2**2 - 1, k1 * k2]
    assert points(given) == {(0, y, z) for y in sides for z in sides}
    given = [k2 * k3, k1**2 * (2 * k2 - k1) + 2 * k1 * k3, k2 * (2 * k2 - k1**2) - 2]
    assert points(given) == {(0, 1, 0), (0, -1, 0)}


UP, DOWN = {(0, 0, 1)}, {(0, 0, -1)}
ACROSS = {(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)}


@pytest.mark.parametrize("polynomials, wanted", [
    ([J**2 * k1, J**2 * k2], UP | DOWN),                   # a curve on the cone k·Ik = 0
    ([(2 * J**2 - 1) * k1 * k2, (2 * J**2 - 1) * k3], ACROSS),
    ([k1**2 + k2**2], UP | DOWN),                          # real points of pairs of complex lines: with both,
    ([(k3 - 1) * (k1 - 1), (k3 - 1) * (k2 - 3)], UP),      # and with one of the points that are projected
    ([(k3 + 1) * (k1 - 1), (k3 + 1) * (k2 - 3)], DOWN),
    ([(k3 - 1) * k1 * k2, (k3 - 1) * k3], UP | ACROSS),
    ([(k1 - k3)**2 + k2**2], {(s * sqrt(2) / 2, 0, s * sqrt(2) / 2) for s in (1, -1)}),
    ([((k1 - k3)**2 + k2**2) * (k2 - k1), ((k1 - k3)**2 + k2**2) * k3],
     {(s * sqrt(2) / 2, 0, s * sqrt(2) / 2) for s in (1, -1)}
     | {(s * sqrt(2) / 2, s * sqrt(2) / 2, 0) for s in (1, -1)}),
    ([k3 - 2], set()),
    ([(k1 + k2)**2 + (k2 - 2 * k3)**4], {(-2 * s / S(3), 2 * s / S(3), s / S(3)) for s in (1, -1)}),
])
def test_real_points_on_complex_curves(polynomials, wanted):
    found = points(polynomials)
    assert all(any(all(sign_of_constant(x - y) == 0 for x, y in zip(a, b)) for b in wanted) for a in found)
    assert len(found) == len(wanted)


@pytest.mark.parametrize("polynomial, axis, levels", [
    (k1, (1, 0, 0), [0]),
    (2 * k3**2 - 1, (0, 0, 1), [-sqrt(2) / 2, sqrt(2) / 2]),
    (4 * (k1 + k2 + k3)**3 - 3 * (k1 + k2 + k3)**2, (1, 1, 1), [0, Rational(3, 4)]),
    (2 * (k1**2 + k2**2) - 1, (0, 0, 1), [-sqrt(2) / 2, sqrt(2) / 2]),
    (3 * k1 + 4 * k2 - 2, (3, 4, 0), [2]),
])
def test_circles(polynomial, axis, levels):
    """A point of each: the polynomial vanishes there, and the height on the axis is that of the circle."""
    found = zeros_on_sphere([polynomial * k2, polynomial * k3], K).curves
    samples = [sample for curve in found for sample in curve.samples]
    assert all(curve.axis[0] * axis[1] == curve.axis[1] * axis[0] and
               curve.axis[2] * axis[0] == curve.axis[0] * axis[2] for curve in found)
    for sample in samples:
        assert sign_of_constant(sum(x**2 for x in sample) - 1) == 0
        assert sign_of_constant(evaluate(polynomial, dict(zip(K, sample)))) == 0
    heights = [sum(x * y for x, y in zip(axis, sample)) for sample in samples]
    assert len(heights) == len(levels)
    assert all(any(sign_of_constant(h - level) == 0 for h in heights) for level in levels)


def test_a_curve_that_is_no_circle():
    """k·Ik = 3/√2 and I between 1 and 3: a curve about an axis; k·Ik = 1/√2: none."""
    (curve,) = zeros_on_sphere([2 * J**2 - 9], K).curves
    assert curve.axis is None and len(curve.samples) == 1
    at = dict(zip(K, curve.samples[0]))
    assert sign_of_constant(evaluate(2 * J**2 - 9, at)) == 0
    assert sign_of_constant(evaluate(curve.expression(K), at)) == 0
    assert zeros_on_sphere([2 * J**2 - 1], K) == ([], [])


def test_points_beside_a_curve_are_those_off_it():
    """(k3 − 1/2) times what vanishes at ±e1, ±e2, and on the circle at (√3/2, 0, 1/2)."""
    zeros = zeros_on_sphere([(2 * k3 - 1) * k1 * k2 * (2 * k3 - 1), (2 * k3 - 1) * k3 * (2 * k3 - 1)], K)
    assert set(map(tuple, zeros.points)) == ACROSS
    assert [(curve.axis, len(curve.samples)) for curve in zeros.curves] == [((0, 0, 1), 1)]


def test_the_whole_sphere():
    assert zeros_on_sphere([k1**2 + k2**2 + k3**2 - 1], K) is None
