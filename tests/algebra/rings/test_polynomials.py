"""Rings: expressions become polynomials, are reduced, and become expressions again, all exactly."""
from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import Matrix, Rational, S, cos, cosh, exp, log, sin, sinh, sqrt, tanh

from gyrostat.algebra.rings.matrices import characteristic_coefficients, determinant, null_space, row_reduce
from gyrostat.algebra.rings.polynomials import Ring, derivatives
from gyrostat.notation import symbol

x, y, k3, I1 = map(symbol, ("x", "y", "k3", "I1"))
POINT = {x: Rational(3, 7), y: Rational(-5, 4), k3: Rational(2, 9), I1: Rational(8, 3)}
EXPRESSIONS = [
    (x + y) ** 3 / (I1 * k3) - x / (x + y), sqrt(1 - k3**2) * x / I1 + sqrt(1 - k3**2) ** 3,
    1 / sqrt(2 + x) + sqrt(sqrt(2) + x),
    sqrt(1 - x**2 / I1**2) + sqrt(2) * sqrt(3), exp(2 * k3) * exp(-3 * x) + exp(k3 + x + 1),
    sinh(k3) - cosh(x) * tanh(k3),
    sin(k3) ** 3 * cos(k3) + log(I1) * x, sympy.pi * x + exp(k3 / 3) ** 2, Rational(1, 3) * x ** (-2)]


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_conversion_keeps_the_value(expression):
    """Numerator over denominator, back as an expression, has the same value (to 40 digits, working precision
    60).
    """
    ring = Ring([expression])
    back = ring.quotient(*ring.fraction(expression))
    assert abs((back - expression).subs(POINT).evalf(60)) < Rational(1, 10**40)


def test_relations_are_used():
    """sin² + cos² − 1, √a² − a and cosh² − sinh² − 1 are zero polynomials."""
    for zero in (sin(x) ** 2 + cos(x) ** 2 - 1, sqrt(1 - k3**2) ** 2 - 1 + k3**2,
                 cosh(x) ** 2 - sinh(x) ** 2 - 1,
                 sqrt(1 + sqrt(2)) ** 4 - 3 - 2 * sqrt(2),
                 sqrt(1 - x**2 / I1**2) ** 2 * I1**2 - I1**2 + x**2, exp(x) * exp(-x) - 1):
        held = sympy.Add(zero, y, evaluate=False)
        ring = Ring([held])
        assert ring.quotient(*ring.fraction(held)) == y


@given(st.lists(st.lists(st.integers(-3, 3), min_size=4, max_size=4), min_size=4, max_size=4))
def test_determinant_and_characteristic_polynomial(rows):
    """det and Faddeev-LeVerrier agree with SymPy's on integer matrices."""
    ring = Ring([x])
    polynomials = [[ring.one * a for a in row] for row in rows]
    assert ring.expression(determinant(ring, polynomials)) == Matrix(rows).det()
    ours = [ring.expression(c) for c in characteristic_coefficients(ring, polynomials)]
    assert ours == Matrix(rows).charpoly().all_coeffs()[1:]


@given(st.lists(st.lists(st.sampled_from([0, 0, 1, -2, x, y, x + y, x * y - 1]), min_size=5, max_size=5),
                min_size=2, max_size=3))
def test_null_space_is_the_kernel(rows):
    """The vectors are annihilated, independent through their diagonal, and as many as the corank."""
    ring = Ring([*(S(e) for row in rows for e in row), x, y])
    polynomials = ring.matrix([[S(e) for e in row] for row in rows])[0]
    basis = null_space(ring, polynomials, lambda j, entry: len(entry), 5)
    for _, vector in basis:
        assert not any(sum((a * b for a, b in zip(row, vector)), ring.zero) for row in polynomials)
    for free, vector in basis:
        assert vector[free] and all(not other[free] for column, other in basis if column != free)
    rank = Matrix(rows).subs({x: Rational(101, 7), y: Rational(-103, 11)}).rank()
    assert len(row_reduce(ring, polynomials, lambda j, entry: len(entry), 5)) == rank == 5 - len(basis)


@pytest.mark.parametrize("f", [x**3 * y / I1 + k3, x * exp(k3) + sin(x), x / (1 + y), sqrt(1 - k3**2) * y])
def test_derivatives_are_derivatives(f):
    """∂f/∂x agrees with SymPy's, for polynomials and for everything else."""
    for ours, variable in zip(derivatives(f, (x, y, k3)), (x, y, k3)):
        assert sympy.simplify(ours - f.diff(variable)) == 0


def test_the_kernel_prefers_the_pivots_it_is_told_to():
    """The free column is the one whose entry ranks last."""
    ring = Ring([x, y])
    rows = ring.matrix([[x, y]])[0]
    assert [null_space(ring, rows, lambda j, e, w=w: j != w, 2)[0][0] for w in (0, 1)] == [1, 0]
    assert Fraction(int(rows[0][0](2, 3).p)) == 2


@pytest.mark.parametrize("one, other", [
    (sympy.log(4), 2 * sympy.log(2)), (sympy.log(sympy.Rational(1, 12)), -2 * sympy.log(2) - sympy.log(3)),
    (sympy.sin(7 * sympy.pi / 18), sympy.cos(sympy.pi / 9)),
    (sympy.tan(sympy.pi / 9), sympy.sin(sympy.pi / 9) / sympy.cos(sympy.pi / 9))])
def test_equal_constants_are_equal_polynomials(one, other):
    """Logarithms of rationals by primes, sines of rπ by cosines.

    A formula does not differ from itself in another spelling.
    """
    ring = Ring([difference := (x + one) ** 2 - (x + other) ** 2])
    assert not ring.reduce(ring.fraction(difference)[0])
