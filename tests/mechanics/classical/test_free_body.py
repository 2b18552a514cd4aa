"""Free bodies: torque, limits of the motion, polhode period."""
import math

import numpy as np
import oracle
import pytest
from draw import moments, numbers
from hypothesis import assume, given, settings
from sympy import Rational, cos, oo, sin, sqrt

import gyrostat as gs
from gyrostat.errors import BodyError, ScopeError, ValuesError
from gyrostat.mechanics.classical.free_body import momentum_limits, polhode_period, torque_equations
from gyrostat.notation import symbol


@given(a=moments, b=moments, c=moments, pi=numbers, torque=numbers, l=numbers)
@settings(max_examples=8)
def test_torque_equations_are_eulers(a, b, c, pi, torque, l):
    """π̇ = M × ω + τ with np.cross."""
    inertia = (a, b, c)
    point, tau, rotor = [pi, pi + 1, 2 - pi], [torque, 1, -torque], [0, 0, l]
    ours = torque_equations(gs.Gyrostat(inertia, rotor),
                            tau).subs(dict(zip(map(symbol, ("pi1", "pi2", "pi3")), point)))
    theirs = oracle.free_field(
        oracle.exact(point), oracle.exact(inertia), oracle.exact(rotor)
    ) + oracle.exact(tau)
    assert list(ours) == [Rational(x.numerator, x.denominator) for x in theirs]


def test_without_torque_the_field_is_that_of_the_bracket():
    """On so(3)*, for any body."""
    body = gs.Gyrostat()
    field = gs.assemble(body).vector_field()
    assert (torque_equations(body, (0, 0, 0)) - field).expand() == field * 0


@given(a=moments, b=moments, c=moments, M1=numbers, M2=numbers, M3=numbers)
def test_sphere_meets_ellipsoid_between_the_limits(a, b, c, M1, M2, M3):
    """Every motion has abs(M)² between 2 E times the extreme moments.

    The rotations about those axes reach them.
    """
    inertia, M = (a, b, c), (M1, M2, M3)
    assume(any(M))
    energy = sum(m * m / i for m, i in zip(M, inertia)) / 2
    low, high = momentum_limits(gs.Gyrostat(inertia, (0, 0, 0)), energy)
    assert low <= Rational(sum(m * m for m in M)) <= high
    # |M|² of the rotation about each axis
    ends = [2 * energy * i for i in inertia]
    assert (low, high) == (Rational(min(ends)), Rational(max(ends)))


def quarter(inertia, M):
    """Period by the trapezoidal rule in the angle of M2 = B sin φ, exact to all digits for a smooth periodic
    integrand.
    """
    (I1, I2, I3), squares = inertia, [m * m for m in M]
    total, twice = sum(squares), sum(s / i for s, i in zip(squares, inertia))
    high, low = twice * I3 - total, total - twice * I1
    # about axis 1: the same with 1 and 3 exchanged
    if total < twice * I2:
        I1, I3, high, low = I3, I1, total - twice * I1, twice * I3 - total
        high, low = -high, -low
    top = high * I2 / (I3 - I2)
    phi = np.arange(400) * 2 * math.pi / 400
    third = np.sqrt((low - top * np.sin(phi) ** 2 * (1 - I1 / I2)) * I3 / (I3 - I1))
    return float(np.mean(math.sqrt(top) / (math.sqrt(high * I1 / (I3 - I1)) * third * abs(1 / I1 - 1 / I3)))
                 * 2 * math.pi)


@pytest.mark.parametrize(("inertia", "M"), [((1, 2, 3), (0.3, 0.2, 0.9)), ((1, 2, 3), (0.9, 0.2, 0.3)),
                                            ((1, 4, 4.5), (1, 0.3, 2)),
                                            ((2, 2.01, 3), (0.1, 0.2, 1))])
def test_polhode_period_is_the_time_of_a_turn(inertia, M):
    """On either side of the separatrix, against quadrature with the two conserved quantities."""
    assert float(polhode_period(inertia, M)) == pytest.approx(quarter(inertia, M), rel=1e-12)


def test_polhode_period_does_not_depend_on_the_names_of_the_axes():
    """Permuting the axes permutes nothing of the period."""
    assert polhode_period((3, 1, 2), ("0.9", "0.3", "0.2")) == polhode_period(
        (1, 2, 3), ("0.3", "0.2", "0.9")
    )


@pytest.mark.parametrize(("inertia", "M", "digits", "value"), [
    ((1, 2, 3), ("0.3", "0.2", "0.9"), 14, "22.898647550620"),             # Landau & Lifshitz, (37.12)
    ((2, 1, "2/3"), (cos(Rational(11, 10)), 0, sin(Rational(11, 10))), 18, "10.7314652348828038"),
    ((3, 5, 9), (0, 2, "0.01"), 15, "118.110887046386")])                  # 4 × 29.5277217615964
def test_published_periods(inertia, M, digits, value):
    """Values of the literature, to the printed digits."""
    assert abs(polhode_period(inertia, M, digits) - Rational(value)) < Rational(6, 10) * Rational(10) ** -len(
        value.split(".")[1]
    )


def test_polhode_period_near_the_separatrix():
    """T grows by (4/μ) log 10 for each factor 10 of M3, μ the growth rate.

    On the separatrix it is infinite.
    """
    rate = math.sqrt((1 / 3 - 1 / 5) * (1 / 5 - 1 / 9)) * 2
    near, nearer = (polhode_period((3, 5, 9), (0, 2, f"1e-{n}"), 40) for n in (60, 61))
    assert float(nearer - near) == pytest.approx(4 * math.log(10) / rate, rel=1e-13)
    assert polhode_period((1, 2, 3), (1, 0, sqrt(3))) == oo                # |M|² = 2 E I2


def test_polhode_refuses():
    """Equal moments, rest on an axis, and what is no number."""
    for inertia, M, error, why in (((1, 1, 2), (1, 1, 1), ScopeError, "free_precession"),
                                   ((1, 2, 3), (0, 1, 0), ScopeError, "rests"),
                                   ((1, 2, 3), ("x", 1, 0), ValuesError, "contains the names"),
                                   ((1, 2, -3), (1, 1, 0), BodyError, "positive")):
        with pytest.raises(error, match=why):
            polhode_period(inertia, M)
    with pytest.raises(ScopeError, match="rotor"):
        momentum_limits(gs.symmetric_gyrostat(), 1)
    for call, error, why in ((lambda: polhode_period((1, 2, 3), (1, 1)), ValuesError, "three components"),
                             (lambda: polhode_period((1, 2, 3), (1, 1, 0), 0), ValuesError,
                              "number of digits"),
                             (lambda: momentum_limits(gs.Gyrostat((1, 2, 3), (0, 0, 0)), -1), ValuesError,
                              "energy = -1 is negative, and no kinetic energy is: give 0"),
                             (lambda: torque_equations(5), TypeError, "not a Gyrostat"),
                             (lambda: torque_equations(gs.Gyrostat(), ("a*", "0", "0")), ValueError,
                              "cannot read")):
        with pytest.raises(error, match=why):
            call()
    with pytest.raises(BodyError, match="components"):
        torque_equations(gs.Gyrostat(), (1, 2))


@pytest.mark.parametrize("n", [36, 44, 98])
def test_period_next_to_the_separatrix(n):
    """M = (10⁻ⁿ, 1, 0), I = (1, 2, 3).

    The period grows by 4 ln 10/λ for each power of ten, λ = 1/(2 √3) the rate at the saddle.
    """
    nearer, here = (polhode_period((1, 2, 3), (f"1e-{k}", 1, 0)) for k in (n + 1, n))
    assert abs(nearer - here - 8 * math.log(10) * math.sqrt(3)) < 1e-9
