"""Precession of a free body of revolution: the composed angular velocity, the cones."""
from fractions import Fraction

import oracle
import pytest
from draw import moments, numbers
from hypothesis import given, settings
from sympy import Rational, acos, sqrt

from gyrostat.errors import BodyError, ScopeError
from gyrostat.mechanics.classical.free_precession import free_precession


@given(I1=moments, I3=moments, across=moments, along=numbers)
@settings(max_examples=10)
def test_precession_composes_the_angular_velocity(I1, I3, across, along):
    """ω = φ̇ M/abs(M) + ψ̇ e3, and in the body ω̇ = −Ω e3 × ω is Euler's equation."""
    motion = free_precession((I1, I3), across, along)
    M = (Rational(I1 * across), Rational(I3 * along))
    total = sqrt(M[0] ** 2 + M[1] ** 2)
    assert motion.precession * M[0] / total == Rational(across)
    assert (motion.precession * M[1] / total + motion.spin - Rational(along)).simplify() == 0
    rates = oracle.free_field(oracle.exact([I1 * across, 0, I3 * along]), oracle.exact([I1, I1, I3]),
                              oracle.exact([0, 0, 0]))
    assert rates[1] / Fraction(I1) == -Fraction(str(motion.body_rate)) * across and rates[0] == rates[2] == 0
    assert motion.body_rate == motion.spin


@pytest.mark.parametrize(("inertia", "sign"), [((2, 1), 1), ((1, 2), -1)])
def test_cones(inertia, sign):
    """Prolate: the body cone rolls outside the space cone, θ is their sum.

    Oblate: inside, θ is their difference.
    """
    motion = free_precession(inertia, 3, 4)
    assert motion.body_cone == acos(Rational(4, 5))
    assert float(motion.tilt) == pytest.approx(float(motion.body_cone + sign * motion.space_cone), rel=1e-14)


def test_precession_refuses():
    """Three moments, and a body at rest."""
    with pytest.raises(BodyError, match="transverse and the axial"):
        free_precession((1, 2, 3), 1, 1)
    with pytest.raises(ScopeError, match="at rest"):
        free_precession((1, 2), 0, 0)
