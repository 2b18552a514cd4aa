"""Gyrostats: what is accepted, what is refused, kinetic energy."""
from fractions import Fraction

import numpy as np
import pytest
import sympy
from sympy import Rational, Symbol, sqrt

import gyrostat as gs
from gyrostat.errors import ArgumentError, BodyError, ValuesError
from gyrostat.mechanics.classical.attitude import angle_rates


def test_numbers_and_symbols_are_accepted():
    """Numbers are made exact, symbols matched by name."""
    body = gs.Gyrostat(inertia=(0.5, "3/2", Fraction(7, 4)), gyrostatic_momentum=(0, Symbol("l2"), sqrt(2)))
    assert body.inertia == (Rational(1, 2), Rational(3, 2), Rational(7, 4))
    assert body.gyrostatic_momentum == (0, gs.symbol("l2"), sqrt(2))


@pytest.mark.parametrize(("inertia", "error"),
                         [((1, 1, 0), BodyError), ((1, -2, 1), BodyError), ((1, 2), BodyError),
                                                ((1, 1, float("nan")), ValuesError),
                          ((1, 1, "x+"), ValueError)])
def test_impossible_bodies_are_refused(inertia, error):
    """Three positive, finite moments."""
    with pytest.raises(error):
        gs.Gyrostat(inertia=inertia)


@pytest.mark.parametrize("name", ["nu1", "dU", "k3", "omega", "pi3_0", "lamda"])
def test_names_of_the_motion_are_refused(name):
    """They would be confused with what the derivation introduces."""
    for arguments in (((1, 1, gs.symbol(name)), (0, 0, 0)), ((1, 1, 1), (0, 0, gs.symbol(name)))):
        with pytest.raises(BodyError, match="write another letter"):
            gs.Gyrostat(*arguments)


def test_the_triangle_inequality_is_no_error():
    """Published cases and bodies in fluids break it."""
    assert gs.Gyrostat(inertia=(1, 1, 5)).inertia[2] == 5


def test_bodies_of_revolution():
    """I1 = I2 and l on axis 3, nothing less."""
    l = gs.symbol("l")
    assert gs.symmetric_gyrostat().is_of_revolution() and gs.Gyrostat((2, 2, 1), (0, 0, l)).is_of_revolution()
    assert not gs.Gyrostat((2, 3, 1), (0, 0, l)).is_of_revolution()
    assert not gs.Gyrostat((2, 2, 1), (0, l, 0)).is_of_revolution()


@pytest.mark.parametrize(
    "inertia",
    [
        np.array([1.0, 2.0, 3.0]),
        np.diag([1.0, 2.0, 3.0]),
        [[1, 0, 0], [0, 2, 0], [0, 0, 3]],
        sympy.diag(1, 2, 3),
        sympy.Matrix([1, 2, 3]),
        (np.array(1), np.float32(2), np.int64(3)),
        range(1, 4),
    ],
)
def test_arrays_and_diagonal_matrices_are_bodies(inertia):
    """Moments come from NumPy as often as from a tuple."""
    assert gs.Gyrostat(inertia, np.zeros(3)) == gs.Gyrostat((1, 2, 3), (0, 0, 0))


@pytest.mark.parametrize(
    ("inertia", "error", "hint"),
    [
        ("123", BodyError, "not three numbers"),
        (b"123", ArgumentError, "three numbers"),
        (5, ArgumentError, "three numbers"),
        (np.array([[1, 0.1, 0], [0.2, 2, 0], [0, 0, 3]]), BodyError, "symmetric"),
        ([[1, 2, 0], [2, 1, 0], [0, 0, 3]], BodyError, "a leading principal minor, -3, is not positive"),
        (np.eye(2), BodyError, "three"),
        (np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0]), ValuesError, "not a real number"),
        ((1, 2, np.array([3])), ValuesError, "not a real number"),
    ],
)
def test_what_is_no_body_says_what_to_give(inertia, error, hint):
    """A text is no sequence of numbers; a tensor is symmetric and positive."""
    with pytest.raises(error, match=hint):
        gs.Gyrostat(inertia)


def test_three_numbers_are_three():
    """A rotor and an angular velocity have three components; a fourth is not dropped."""
    for wrong in ((), (1, 2), (1, 2, 3, 4)):
        with pytest.raises(BodyError, match="three"):
            gs.lie_poisson(("k",), wrong)
        with pytest.raises(ArgumentError, match="give 3 in brackets"):
            angle_rates(wrong)
