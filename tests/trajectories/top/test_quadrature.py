"""Integrals of known functions, periodic or to infinity, in doubles and in balls."""
import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from gyrostat.errors import AccuracyError
from gyrostat.trajectories.top.quadrature import FEWEST, over_a_period, to_infinity

K = 1.7


def cosine(u, j=1):
    """cos(j π u/K)."""
    return (j * arb.pi() * u / arb(K)).cos()


def periodic(bits=60, a=0.5, nodes=FEWEST):
    """dt/du = 1/(1 + a cos), a polynomial, and a constant."""
    return over_a_period(lambda u: [1 / (1 + arb(a) * cosine(u)), 3 - cosine(u, 2) / 4, arb(2)], arb(K),
                         nodes, bits)


def antiderivatives(u, a=0.5):
    """Of the three, by mpmath."""
    w = mpmath.pi / mpmath.mpf(K)
    first = mpmath.quad(lambda x: 1 / (1 + a * mpmath.cos(w * x)), mpmath.linspace(0, u, 5))
    return [first, 3 * u - mpmath.sin(2 * w * u) / (8 * w), 2 * u]


@pytest.mark.parametrize("bits", [60, 130])
def test_periodic_integrals(bits):
    """Means, series and derivatives of 1/(1 + cos/2), of a polynomial and of a constant are those of
    quadrature.
    """
    with ctx.workprec(bits + 120), mpmath.workdps(50):
        found = periodic(bits)
        assert found.quarter == arb(K)
        assert all(x == 0 for x in found.jumps)
        assert found.constant == [False, False, True]
        for mean, value in zip(found.means, (2 / mpmath.sqrt(3), 3, 2)):
            assert abs(mpmath.mpf(mean.mid().str(60, radius=False)) - value) < mpmath.mpf(2) ** (
                -2 * min(bits, 80)
            )
        for u in (0.0, 0.3, -1.1, 1.7, 4.9):
            values, slopes = found.at(arb(u))
            for ours, value in zip(values, antiderivatives(mpmath.mpf(u))):
                assert abs(mpmath.mpf(ours.mid().str(60, radius=False)) - value) < mpmath.mpf(2) ** -min(
                    bits - 8, 54
                )
            exact = [1 / (1 + cosine(arb(u)) / 2), 3 - cosine(arb(u), 2) / 4, 2]
            assert all(abs(a - b) < arb(2) ** -min(bits - 16, 48) for a, b in zip(slopes, exact))


def in_doubles(found, u):
    """The integrals less their linear parts, and the functions."""
    place, n = found.place(u), len(found.means)
    curves = [found.curve([int(i == j) for j in range(n)]) for i in range(n)]
    return tuple(np.array([getattr(curve, what)(place) + 0 * u for curve in curves])
                 for what in ("bounded", "rate"))


def test_periodic_integrals_in_doubles():
    """A curve is the integral less mean · u, and the function: for any u, to rounding."""
    with ctx.workprec(200):
        found = periodic()
    u = np.array([0.0, 0.3, -1.1, 1.7, 4.9])
    values, slopes = in_doubles(found, u)
    with mpmath.workdps(30):
        exact = np.array([[float(x) for x in antiderivatives(mpmath.mpf(x))] for x in u]).T
    means = np.array([2 / np.sqrt(3), 3, 2])[:, None]
    np.testing.assert_allclose(values, exact - means * u, atol=1e-15)
    w = np.pi * u / K
    # j errors of a term
    np.testing.assert_allclose(slopes, [1 / (1 + np.cos(w) / 2), 3 - np.cos(2 * w) / 4, 2 + 0 * w],
                               atol=2e-14)


def test_a_curve_of_a_sum():
    """Integrals are added before they are rounded: what cancels leaves nothing, and zeros at the end go."""
    with ctx.workprec(200):
        found, ends = periodic(), at_infinity()
    for one in (found, ends):
        u = np.float64(0.7)
        place = one.place(u)
        values, slopes = in_doubles(one, u)
        both = one.curve([1, -1, *[0] * (len(one.means) - 2)])
        assert both.bounded(place) == pytest.approx(values[0] - values[1], abs=1e-15)
        assert both.rate(place) == pytest.approx(slopes[0] - slopes[1], abs=1e-14)
        nothing = one.curve([0] * len(one.means))
        assert nothing.terms == [] and nothing.bounded(place) == nothing.rate(place) == 0
    assert found.curve([0, 1, 0]).terms[2:] == [] != found.time.terms[2:]


def test_inverse_of_the_first_integral():
    """u where the first integral has a value, in either direction of time."""
    with ctx.workprec(200):
        for sign in (1, -1):
            found = over_a_period(lambda u, sign=sign: [sign / (1 + arb("0.9") * cosine(u))], arb(K), FEWEST,
                                  60)
            u = np.linspace(-K, K, 41)
            mean = float(found.means[0])
            np.testing.assert_allclose(found.inverse(mean * u + in_doubles(found, u)[0][0]), u, atol=1e-14)
        assert over_a_period(lambda u: [arb(4)], arb(K), FEWEST, 60).inverse(np.array([2.0]))[0] == 0.5


def at_infinity(bits=60):
    """dt/du = 3 + tanh(u/2) + ½ sech²(u/2)/(2 + tanh(u/2)), whose limits are 2 and 4; an even bump.

    A step; a constant.
    """
    def functions(u):
        y = (u / 2).tanh()
        bump = (1 - y * y) / 2
        return [3 + y + bump / (2 + y), bump, -y, arb(5)]

    ends = [arb(2), arb(0), arb(1), arb(5)], [arb(4), arb(0), arb(-1), arb(5)]
    return to_infinity(functions, ends, bits)


def exact_at_infinity(u):
    y, log = mpmath.tanh(u / 2), 2 * mpmath.log(mpmath.cosh(u / 2))
    return [3 * u + log + mpmath.log(1 + y / 2), y, -log, 5 * u]


@pytest.mark.parametrize("bits", [60, 130])
def test_integrals_to_infinity(bits):
    """The mean and the difference of the limits, log cosh and Chebyshev polynomials: at any u, in balls."""
    with ctx.workprec(bits + 120), mpmath.workdps(60):
        found = at_infinity(bits)
        assert found.quarter is None
        assert [float(x) for x in found.means] == [3, 0, 0, 5]
        assert [float(x) for x in found.jumps] == [1, 0, -1, 0]
        assert found.constant == [False, False, False, True]
        for u in (0.0, 0.3, -2.5, 17.0, -300.0):
            values, slopes = found.at(arb(u))
            for ours, value in zip(values, exact_at_infinity(mpmath.mpf(u))):
                assert abs(mpmath.mpf(ours.mid().str(60, radius=False)) - value) < mpmath.mpf(2) ** -min(
                    bits - 8, 52
                )
            y = (arb(u) / 2).tanh()
            bump = (1 - y * y) / 2
            assert all(abs(a - b) < arb(2) ** -min(bits - 16, 46)
                       for a, b in zip(slopes, [3 + y + bump / (2 + y), bump, -y, 5]))


def test_integrals_to_infinity_in_doubles():
    """A curve leaves mean · u + jump · abs(u) out; far away it is a constant."""
    with ctx.workprec(200):
        found = at_infinity()
    u = np.array([0.0, 0.3, -2.5, 17.0, -300.0, 1e5])
    values, slopes = in_doubles(found, u)
    with mpmath.workdps(30):
        exact = np.array([[float(x - m * v - j * abs(v))
                           for x, m, j in zip(exact_at_infinity(v), (3, 0, 0, 5), (1, 0, -1, 0))]
                          for v in map(mpmath.mpf, u)]).T
    np.testing.assert_allclose(values, exact, atol=4e-15)
    y = np.tanh(u / 2)
    np.testing.assert_allclose(slopes, [3 + y + (1 - y * y) / 2 / (2 + y), (1 - y * y) / 2, -y, 5 + 0 * y],
                               atol=1e-14)
    np.testing.assert_allclose(found.inverse(values[0] + 3 * u + np.abs(u)), u, rtol=2e-15, atol=1e-14)


def test_more_nodes_where_the_function_is_steeper():
    """The number of nodes is doubled until the last terms vanish, from as many as are asked for."""
    with ctx.workprec(200):
        assert [periodic(a=a).nodes for a in (0.01, 0.9, 0.999)] == [12, 192, 1536]
        assert periodic(a=0.9, nodes=50).nodes == 200
        assert (
            len(periodic(a=0.9).time.terms)
            > len(periodic(a=0.5).time.terms)
            > len(periodic(a=0.01).time.terms)
        )


@pytest.mark.slow
def test_a_kink_is_no_smooth_function():
    """abs(cos) is integrated to no accuracy, neither is a step at 0, and a value known to a few bits is
    refused.
    """
    with ctx.workprec(150):
        with pytest.raises(AccuracyError, match="8192 nodes do not reach the accuracy of 60 bits"):
            over_a_period(lambda u: [2 + abs(cosine(u))], arb(K), 2048, 60)
        with pytest.raises(AccuracyError, match="8192 nodes do not reach"):
            to_infinity(lambda u: [2 + abs((u / 2).tanh())], ([arb(3)], [arb(3)]), 60)
        with pytest.raises(AccuracyError, match="not known to 110 bits"):
            over_a_period(lambda u: [cosine(u) + 2 + arb(0, "1e-20")], arb(K), FEWEST, 60)
        with pytest.raises(AccuracyError, match="not known"):
            to_infinity(lambda u: [2 + (u / 2).sech() ** 2 + arb(0, "1e-20")], ([arb(2)], [arb(2)]), 60)


def test_nothing_to_integrate():
    """A function that is 0 but for its enclosure has the integral 0."""
    with ctx.workprec(200):
        found = over_a_period(lambda u: [arb(1), cosine(u) - cosine(u)], arb(K), FEWEST, 60)
        assert abs(float(found.means[1])) < 1e-50 and abs(in_doubles(found, 0.4)[0][1]) < 1e-50
