"""Zeros that come in opposite pairs: by a resultant the same as by the quotient algebra; multiple ones."""
import random

import pytest
from flint import fmpq
from sympy import sqrt

from gyrostat.algebra.enclosures.precision import own_precision
from gyrostat.algebra.solving.opposite_zeros import opposite_zeros
from gyrostat.algebra.solving.sphere_curves import ONE
from gyrostat.algebra.solving.sphere_points import finite_zeros
from gyrostat.algebra.solving.sphere_zeros import zeros_on_sphere
from gyrostat.notation import symbol

NOTHING = {ONE: fmpq(1)}
k1, k2, k3 = K = tuple(symbol(f"k{n}") for n in (1, 2, 3))


def drawn(draw, degree):
    """A form with small coefficients, without k3², which is 1 − k1² − k2² on the sphere."""
    return {(a, b, c): fmpq(draw.choice((-3, -2, -1, 1, 2, 3)), draw.randint(1, 3))
            for c in (0, 1) for a in range(degree + 1) for b in range(degree + 1)
            if a + b + c <= degree and (a + b + c - degree) % 2 == 0}


@pytest.mark.few(2)
@pytest.mark.parametrize("degrees", [(1, 2), (2, 2), (2, 3), (3, 3)])
def test_the_same_zeros_as_by_the_quotient_algebra(degrees):
    draw = random.Random(sum(degrees))
    for _ in range(6):
        forms, over = [drawn(draw, d) for d in degrees], [drawn(draw, 2)]

        def algebra(forms=forms, over=over):
            return finite_zeros(forms, [NOTHING], over)

        found, wanted = opposite_zeros(forms, [NOTHING], over, algebra), list(algebra())
        assert found is not None and len(found) == len(wanted)
        for zero in wanted:
            (same,) = [z for z in found if all(a.overlaps(b) for a, b in zip(z.balls(192), zero.balls(192)))]
            assert tuple(same) == tuple(zero)
            assert [same.is_fraction(n) for n in range(4)] == [zero.is_fraction(n) for n in range(4)]
        with own_precision(192):
            assert all(x.rad() < 1e-40 for z in found for x in z.balls(192))


@pytest.mark.parametrize("forms", [
    [{(2, 0, 0): fmpq(1)}, {(0, 1, 0): fmpq(1)}],          # (0, 0, 1) counts twice
    [{(1, 1, 0): fmpq(1)}, {(1, 0, 1): fmpq(1)}],          # a curve in common
    [{(1, 0, 0): fmpq(1), ONE: fmpq(1)}, {(0, 1, 0): fmpq(1)}],  # neither even nor odd
    [{(1, 0, 0): fmpq(1)}, {(0, 1, 0): fmpq(1)}, {(0, 0, 1): fmpq(1)}]])
def test_nothing_is_said_where_nothing_is_proved(forms):
    assert opposite_zeros(forms, [NOTHING], [], list) is None


def test_multiple_zeros_that_are_left_out():
    """k1 k3 = k2² touches k1 = 0 at ±e3, which count twice; left over are ±e1 and ±(9, 3, 1)/√91."""
    terms = [{(1, 0, 1): fmpq(1), (0, 2, 0): fmpq(-1)}, {(1, 1, 0): fmpq(1), (1, 0, 1): fmpq(-3)}]
    assert opposite_zeros(terms, [{(0, 0, 1): fmpq(1)}], [], list) is None  # at e3 that is not 0
    found = opposite_zeros(terms, [{(1, 0, 0): fmpq(1)}], [], list)
    assert found is not None
    places = {tuple(round(float(x.mid()), 12) + 0.0 for x in zero.balls(128)) for zero in found}
    ray = [round(x / 91**0.5, 12) for x in (9.0, 3.0, 1.0)]
    assert places == {(s * x, s * y, s * z) for s in (1, -1) for x, y, z in ((1.0, 0.0, 0.0), ray)}
    exact = zeros_on_sphere([k1 * k3 - k2**2, k1 * (k2 - 3 * k3)], K, k1).points
    assert {tuple(x * sqrt(91) if x**2 != 1 else x for x in zero) for zero in exact} == {
        (9, 3, 1), (-9, -3, -1), (1, 0, 0), (-1, 0, 0)}
