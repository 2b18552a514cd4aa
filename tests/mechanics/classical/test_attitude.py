"""Euler angles: kinematics beside the bracket on e(3)*."""
import pytest
from sympy import Matrix, cos, eye, sin

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.mechanics.classical.attitude import (
    ANGLES,
    CONVENTIONS,
    RATES,
    angle_rates,
    angular_velocity,
    direction,
    reduced,
    rotation,
)

PHI, THETA, PSI = ANGLES


def rate(expression):
    """d/dt of a function of the angles."""
    return sum((expression.diff(angle) * angle_rate for angle, angle_rate in zip(ANGLES, RATES)),
               0 * expression)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_rotations(convention):
    """R is a rotation, and takes the body axis e3 to the direction (θ, φ) of space."""
    R = rotation(convention)
    assert (R.T * R).applyfunc(reduced) == eye(3) and reduced(R.det()) == 1
    azimuth = {"zxz": (sin(PHI), -cos(PHI)), "zyz": (cos(PHI), sin(PHI))}[convention]
    assert R.col(2).applyfunc(reduced) == Matrix([azimuth[0] * sin(THETA), azimuth[1] * sin(THETA),
                                                  cos(THETA)])


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_direction_moves_as_the_bracket_says(convention):
    """k = Rᵀ e_z moves as k̇ = k × ω, the second equation on e(3)*."""
    k = direction(convention)
    assert (rate(k) - k.cross(angular_velocity(convention))).applyfunc(reduced) == Matrix([0, 0, 0])


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_angle_rates_invert_angular_velocity(convention):
    """From ω back to the rates of the angles."""
    assert angle_rates(angular_velocity(convention), convention) == RATES


def test_errors():
    """An unknown convention is refused."""
    with pytest.raises(ScopeError, match="xyz"):
        rotation("xyz")


def test_texts_are_read_and_not_executed(tmp_path):
    """As in every place for an expression: by the grammar."""
    assert gs.mechanics.angle_rates(("omega1", 0, 0)) == gs.mechanics.angle_rates((gs.symbol("omega1"), 0, 0))
    with pytest.raises(gs.errors.GyrostatError, match="is not part of the grammar"):
        gs.mechanics.angle_rates((f"__import__('pathlib').Path({str(tmp_path / 'made')!r}).touch()", 0, 0))
    assert not list(tmp_path.iterdir())
