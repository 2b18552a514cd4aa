"""Jacobi's functions from the complementary parameter."""
import mpmath
import numpy as np
import pytest
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis import strategies as st

from gyrostat.trajectories.elliptic import argument, jacobi, jacobi_ball, quarter_period

COMPLEMENTS = ("1", "0.7", "1e-3", "1e-10", "1e-40")
exponents = st.integers(min_value=0, max_value=300)
parts = st.fractions(min_value=-2, max_value=2, max_denominator=64)


def theirs(u, complement):
    """sn, cn, dn by mpmath, with digits to spare for m = 1 − m1."""
    with mpmath.workdps(100):
        return [mpmath.ellipfun(name, mpmath.mpf(u), m=1 - mpmath.mpf(complement))
                for name in ("sn", "cn", "dn")]


def mid(x, digits=60):
    return mpmath.mpf(x.mid().str(digits, radius=False))


@pytest.mark.parametrize("complement", COMPLEMENTS)
def test_enclosures_contain_what_mpmath_finds(complement):
    """sn, cn, dn of balls, on either side of K, to 50 digits."""
    with ctx.workprec(256), mpmath.workdps(60):
        for u in ("-0.4", "0", "1.6", "7.25"):
            for ours, value in zip(jacobi_ball(arb(u), arb(complement)), theirs(u, complement)):
                assert ours.rad() < arb("1e-60") and abs(mid(ours, 70) - value) < 1e-55


@settings(max_examples=40)
@given(n=exponents, part=parts)
def test_doubles_agree_with_enclosures(n, part):
    """At u = part · K, −2 ≤ part ≤ 2, to 20 units in the last place of 1, and 2 of u, for m1 = 10⁻ⁿ."""
    complement = 10.0**-n
    with ctx.workprec(256):
        u = float(part) * float(quarter_period(arb(complement)))
        exact = [float(x) for x in jacobi_ball(arb(u), arb(complement))]
    found = np.array(jacobi(np.array([u]), complement))[:, 0]
    assert np.abs(found - exact).max() < (20 + 2 * abs(u)) * 2.0**-53


@settings(max_examples=40)
@given(n=exponents, part=parts)
def test_squares_add_up(n, part):
    """sn² + cn² = 1, dn² = cn² + m1 sn², at any number of periods."""
    with ctx.workprec(128):
        K = float(quarter_period(arb(10) ** -n))
    sn, cn, dn = jacobi(np.array([float(part) * K, 1e6 * K, -3.7 * K]), 10.0**-n)
    # ten roundings
    assert np.abs(sn**2 + cn**2 - 1).max() < 4e-15 and np.abs(dn**2 - cn**2 - 10.0**-n * sn**2).max() < 4e-15


def test_hyperbolic_and_circular_functions_are_the_ends():
    """m1 = 0: tanh, sech, sech, at any size of u; m1 = 1: sin, cos, 1."""
    u = np.array([-1e6, -800.0, -1.5, 0.0, 2.0, 720.0])
    sn, cn, dn = jacobi(u, 0.0)
    assert (sn == np.tanh(u)).all()
    assert (cn == dn).all()
    assert np.allclose(cn, [0, 0, 1 / np.cosh(1.5), 1, 1 / np.cosh(2), 0], 1e-15, 1e-300)
    assert [float(x) for x in jacobi_ball(arb(2), arb(0))] == pytest.approx(
        [np.tanh(2), 1 / np.cosh(2), 1 / np.cosh(2)], rel=1e-15
    )
    u = np.array([-3.0, -1.5, 0.0, 2.0, 6.0])
    sn, cn, dn = jacobi(u, 1.0)
    assert np.abs(sn - np.sin(u)).max() < 1e-15 and np.abs(cn - np.cos(u)).max() < 1e-15 and (dn == 1).all()
    near = jacobi(np.array([1.25]), 1e-300)                                # continuous there
    assert np.allclose(near, [[np.tanh(1.25)], [1 / np.cosh(1.25)], [1 / np.cosh(1.25)]], rtol=4e-15)


@pytest.mark.parametrize("complement", COMPLEMENTS)
def test_quarter_period_is_where_cn_vanishes(complement):
    """K by mpmath; sn K = 1, cn K = 0, dn K = √m1."""
    with ctx.workprec(256), mpmath.workdps(60):
        K = quarter_period(arb(complement))
        with mpmath.workdps(100):
            value = mpmath.ellipk(1 - mpmath.mpf(complement))
        assert abs(mid(K, 70) - value) < 1e-55
        sn, cn, dn = jacobi_ball(K, arb(complement))
        assert sn.contains(1) and cn.contains(0) and dn.overlaps(arb(complement).sqrt())


@settings(max_examples=40)
@given(n=exponents, part=st.fractions(min_value=0, max_value=2, max_denominator=64))
def test_argument_inverts_the_functions(n, part):
    """u from sn u : cn u, 0 ≤ u ≤ 2 K, to full relative precision, also at K and near 2 K, also times any
    factor.
    """
    with ctx.workprec(512):
        m1 = arb(10) ** -n
        u = quarter_period(m1) * arb(part.numerator) / part.denominator
        sn, cn, _ = jacobi_ball(u, m1)
        found = argument(3 * sn, 3 * cn, m1)
        assert found.overlaps(u) and found.rad() < arb(2) ** -200


def test_argument_on_the_separatrix():
    """At m1 = 0 it is artanh of the sine, and odd."""
    with ctx.workprec(128):
        for u in ("-3", "0.001", "9"):
            assert abs(argument(arb(u).tanh(), arb(u).sech(), arb(0)) - arb(u)) < arb(2) ** -90
