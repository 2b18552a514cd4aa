"""Principal axes of a tensor: exact, proper, and the same body."""
import random

import pytest
from sympy import Matrix, Rational, diag, eye, pi, sqrt
from turns import of_quaternion

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.errors import ArgumentError, ValuesError
from gyrostat.mechanics import principal_axes


def zero(matrix):
    return all(sign_of_constant(x) == 0 for x in matrix)


def axes(tensor, rotor):
    """The body turned, and what makes it the same body, asked at once."""
    body, R = principal_axes(gs.Gyrostat(tensor, rotor))
    tensor, rotor = Matrix(tensor), Matrix(rotor)
    assert zero(R * R.T - eye(3)) and sign_of_constant(R.det()) == 1
    assert zero(R * tensor * R.T - diag(*body.moments))
    assert zero(R * rotor - Matrix(body.gyrostatic_momentum))
    return body


@pytest.mark.few(1)
@pytest.mark.parametrize("moments", [(1, 2, 3), (2, 2, 3), (2, 3, 3), ("1/2", "1/2", 5)])
def test_a_turned_body_comes_back(moments):
    """Its moments in increasing order, two equal ones first."""
    draw = random.Random(5)
    moments = tuple(map(Rational, moments))
    alike = moments[1] == moments[2]
    for order in ((0, 1, 2), (2, 0, 1), (1, 0, 2)):
        R = of_quaternion(*(draw.randint(1, 4) for _ in range(4)))
        tensor = R * diag(*(moments[i] for i in order)) * R.T
        body = axes(tensor.tolist(), [draw.randint(-3, 3) for _ in range(3)])
        assert body.moments == ((moments[1], moments[2], moments[0]) if alike else moments)


def test_a_body_of_revolution_is_one():
    """Its axis is the third, and so is its rotor."""
    R = of_quaternion(1, 2, 3, -1)
    for A, C in ((2, 3), (3, 1)):
        body, _ = principal_axes(gs.Gyrostat((R * diag(C, A, A) * R.T).tolist(), list(R[:, 0] * 4)))
        assert body.is_of_revolution() and body.gyrostatic_momentum[2]**2 == 16


@pytest.mark.slow
def test_moments_are_surds_or_roots_of_a_cubic():
    """Of entries that are surds too, or floats; nothing is rounded."""
    assert axes([[2, 1, 0], [1, 3, 0], [0, 0, 1]], (1, 0, 0)).moments == (
        1, Rational(5, 2) - sqrt(5)/2, Rational(5, 2) + sqrt(5)/2)
    assert axes([[3, sqrt(2), 0], [sqrt(2), 3, 0], [0, 0, 1]], (0, 0, 1)).moments == (
        1, 3 - sqrt(2), 3 + sqrt(2))
    body, R = principal_axes(gs.Gyrostat([[4.0, 1, 0], [1, 3, 1], [0, 1, 5]], (1, 0, 2)))
    x = gs.symbol("moment")
    for moment, row in zip(body.moments, R.tolist()):
        assert sign_of_constant((x**3 - 12*x**2 + 45*x - 51).xreplace({x: moment})) == 0
        away = Matrix([[4, 1, 0], [1, 3, 1], [0, 1, 5]]) * Matrix(row) - moment * Matrix(row)
        assert max(abs(complex(e.evalf(20, chop=True))) for e in away) < 1e-15
    assert float(R.det().evalf(15)) == pytest.approx(1)


def test_a_body_in_principal_axes_stays():
    """Whatever the order of its moments, and with names in them."""
    body = gs.Gyrostat()
    assert principal_axes(body) == (body, eye(3).as_immutable())


def test_what_has_no_principal_axes_says_why():
    """Names in the tensor; another kind of thing."""
    with pytest.raises(ValuesError, match="contains the names a"):
        principal_axes(gs.Gyrostat([[3, gs.symbol("a"), 0], [gs.symbol("a"), 3, 0], [0, 0, 1]]))
    with pytest.raises(ArgumentError):
        principal_axes((1, 2, 3))


def test_transcendental_entries_too():
    """Where a formula has the moments."""
    assert axes([[pi, 1, 0], [1, pi, 0], [0, 0, 1]], (0, 0, 0)).moments == (1, pi - 1, pi + 1)


@pytest.mark.parametrize("signs", [(1, 1), (1, -1), (-1, 1), (-1, -1)])
def test_all_signs_of_the_products(signs):
    """R is proper whatever they are."""
    a, b = signs
    axes([[5, a, 0], [a, 5, 0], [0, 0, 4]], (b, 0, 1))
