"""Periods, and what the angles gain in them; many periods."""
import mpmath
import numpy as np
import pytest
from slow import slow
from trajectories.tops import BODY, CASES, MANY, MOTIONS, TILTED, F, about, as_mpf, moving, theirs

from gyrostat.errors import ValuesError


@pytest.mark.parametrize("name", MANY)
def test_long_times(name):
    """After 10⁶ and 10⁹ periods doubles agree with 40 digits, at 10¹² energy, Casimirs and integrals are kept
    to rounding.
    """
    inertia, l, U, state, _, _ = MOTIONS[name]
    found, exact = moving(inertia, l, U, state), moving(inertia, l, U, state, precision=40)
    with mpmath.workdps(40):
        times = [float(found.period) * n + x for n, x in ((1e6, 0.3), (-1e6, 1.9), (1e9, 0.7), (-1e9, 0.1))]
        values = exact(times)
        assert np.abs(found(times) - values.astype(float)).max() < 1e-14
        shifted = exact([3 + 10**9 * F(mpmath.nstr(exact.period, 42)), 3])
        gained = [shifted[i, 3] ** 2 + shifted[i, 4] ** 2 for i in (0, 1)]
        assert abs(shifted[0, 5] - shifted[1, 5]) < 1e-28 and abs(gained[0] - gained[1]) < 1e-28
    assert max(found.drift(np.linspace(-1e12, 1e12, 31)).values()) < 2e-14


def test_a_stiff_field():
    """U = 10⁶ k3: a thousand swings in a unit of time cost no more than one, with an error in proportion to
    the angle.
    """
    state = ("0", "1000", "3", *TILTED)
    found, exact = moving(BODY, "2/5", ("1000000",),
                          state), moving(BODY, "2/5", ("1000000",), state, precision=40)
    times = [F(1, 1000), F(1), F(1000)]
    sizes = np.array([3000, 3000, 3000, 1, 1, 1])
    assert (np.abs(found([float(t) for t in times]) - exact(times).astype(float)) / sizes).max() < 1e-14
    with mpmath.workdps(40):
        assert (
            max(
                abs(a - b)
                for a, b in zip(exact(F(1, 1000)), theirs(BODY, "2/5", ("1000000",), state, F(1, 1000), 25))
            )
            < 1e-20
        )


def test_times_beyond_counting():
    """More periods than 5·10¹⁴ are refused; half as many are not."""
    inertia, l, U, state, _, _ = MOTIONS["degree 1"]
    found = moving(inertia, l, U, state)
    assert np.isfinite(found(1e15)).all()
    with pytest.raises(ValuesError, match="periods"):
        found([0.0, 1e16])


def quadrature(inertia, l, U, state):
    """Period, and what φ and ψ gain in it, from the textbook integrals between the roots of g next to k3.

    U a callable of mpmath.
    """
    I1, I3 = map(as_mpf, map(F, inertia))
    p1, p2, p3, k1, k2, k3 = (as_mpf(F(x)) for x in state)
    r = mpmath.sqrt(k1**2 + k2**2 + k3**2)
    P, v, z0 = p3 + as_mpf(F(l)), (p1 * k1 + p2 * k2 + (p3 + as_mpf(F(l))) * k3) / r, k3 / r
    E = (p1**2 + p2**2) / (2 * I1) + U(k3)

    def g(z):
        return 2 * I1 * (E - U(r * z)) * (1 - z * z) - (v - P * z) ** 2

    ends = []
    for side in (-1, 1):
        step = mpmath.mpf(1) / 256
        inside = z0
        while abs(inside + side * step) < 1 and g(inside + side * step) > 0:
            inside += side * step
        outside = max(min(inside + side * step, mpmath.mpf(1)), mpmath.mpf(-1))
        ends.append(mpmath.findroot(g, (inside, outside), solver="anderson", tol=1e-50) if g(outside) < 0
                    else outside)
    low, high = ends
    middle, half = (low + high) / 2, (high - low) / 2

    def over(f):
        def integrand(angle):
            z = middle + half * mpmath.sin(angle)
            return f(z) * half * mpmath.cos(angle) * I1 / mpmath.sqrt(g(z))
        return 2 * mpmath.quad(integrand, mpmath.linspace(-mpmath.pi / 2, mpmath.pi / 2, 5),
                               method="gauss-legendre")

    def precessing(z):
        return (v - P * z) / (I1 * (1 - z * z))
    return over(lambda z: 1), over(precessing), over(lambda z: p3 / I3 - z
                                                     * precessing(z)), (r * low, r * high)


POTENTIALS = {"exp": mpmath.exp, "log": lambda z: mpmath.log(z + 2), "pole": lambda z: 1 / (z + 2)}


@pytest.mark.slow
@pytest.mark.parametrize("name", [
    "degree 4", "exp", "k of length 5",
    *slow(("degree 1",), ("degree 2 between",), ("negative l and pi3",))])
def test_period_and_gains_are_the_textbook_integrals(name):
    """T = 2 ∫ I1 dz/√g, Δφ = 2 ∫ (v − P z)/(1 − z²) dz/√g, Δψ = π3 T/I3 − 2 ∫ z (v − P z)/(1 − z²) dz/√g, by
    Gauss's rule in mpmath.
    """
    inertia, l, U, state, _, _ = MOTIONS[name]
    found, exact = moving(inertia, l, U, state), moving(inertia, l, U, state, precision=20)
    with mpmath.workdps(28):
        function = (
            POTENTIALS[U]
            if isinstance(U, str)
            else lambda z: sum(as_mpf(F(c)) * z**n for n, c in enumerate(U, 1))
        )
        period, precession, spin, limits = quadrature(inertia, l, function, state)
        assert abs(exact.period / period - 1) < 1e-19
    assert found.period == pytest.approx(float(period), rel=4e-16) and isinstance(exact.period, mpmath.mpf)
    assert found.precession == pytest.approx(float(precession), rel=1e-15, abs=1e-15)
    assert found.spin == pytest.approx(float(spin), rel=1e-15, abs=1e-15)
    assert found.limits == pytest.approx([float(x) for x in limits], rel=1e-15)
    rates = {"nutation": 2 * np.pi / float(period), "precession": float(precession / period),
             "spin": float(spin / period)}
    assert found.frequencies == pytest.approx(rates, rel=1e-14)


def test_period_of_degree_one_is_a_complete_integral():
    """U = m k3: T = 4 √(I1/(2 m (z3 − z1))) K((z2 − z1)/(z3 − z1)), z1 < z2 < z3 the roots of the cubic."""
    inertia, l, (m,), state, _, _ = MOTIONS["degree 1"]
    with mpmath.workdps(30):
        I1, m, (p1, p2, p3, k1, k2, k3) = as_mpf(F(inertia[0])), as_mpf(F(m)), [as_mpf(F(x)) for x in state]
        P, E = p3 + as_mpf(F(l)), (p1**2 + p2**2) / (2 * I1) + m * k3
        v = p1 * k1 + p2 * k2 + P * k3
        z = sorted(mpmath.polyroots([2 * I1 * m, -2 * I1 * E - P**2, 2 * P * v - 2 * I1 * m,
                                     2 * I1 * E - v**2], 200, 50), key=mpmath.re)
        K = mpmath.ellipk((z[1] - z[0]) / (z[2] - z[0]))
        period = 4 * mpmath.sqrt(I1 / (2 * m * (z[2] - z[0]))) * K
        found = moving(inertia, l, (m := F(3, 2),), state, precision=25)
        assert abs(found.period - period) < 1e-24
        assert found.limits == pytest.approx((float(z[0].real), float(z[1].real)), rel=1e-15)


@pytest.mark.few(1)
@pytest.mark.parametrize("name", CASES)
def test_a_period_later_the_body_is_turned(name):
    """R(t + T) = Rz(Δφ) R(t) Rz(Δψ), and k3 is back."""
    inertia, l, U, state, _, _ = MOTIONS[name]
    found = moving(inertia, l, U, state)
    t, T = np.array([0.0, 0.37, -1.21]) * found.period, found.period
    for here, later in zip(found.attitude(t), found.attitude(t + T)):
        np.testing.assert_allclose(later, about(found.precession) @ here @ about(found.spin),
                                   atol=2e-14 * (1 + abs(found.spin)))
    np.testing.assert_allclose(found(t + T)[:, 5], found(t)[:, 5],
                               atol=1e-14 * max(1, float(F(BODY[0]))) * np.abs(found(t)).max())
