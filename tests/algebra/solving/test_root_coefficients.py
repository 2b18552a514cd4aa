"""Roots of polynomials with algebraic and transcendental coefficients, against mpmath."""
import mpmath
import pytest
from algebra.zeros import agree, k3, real_zeros, x
from slow import slow
from sympy import CRootOf, I, Poly, Rational, S, Symbol, cbrt, cos, exp, expand, log, pi, root, sin, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.algebra.solving.roots import real_roots
from gyrostat.errors import ScopeError

THIRD, FIFTH = cbrt(2), CRootOf(x**5 - x - 1, 0)


@pytest.mark.slow
@pytest.mark.parametrize("number", [
    FIFTH, 1 + sqrt(2) / 3, sqrt(2 + sqrt(3)),
    *slow((sqrt(2),), (THIRD,), (THIRD**2 - 1,), (sqrt(1 + 1 / (2 + sqrt(2))),), (-FIFTH / 2,))])
def test_algebraic_coefficients(number):
    """(x − a)(x + 2 a − 1)(x² − a), (a x − 1)(x − 1/2), x³ − a x + 1.

    The roots of mpmath, of the polynomial and not of its conjugates.
    """
    for f in ((x - number) * (x + 2 * number - 1) * (x**2 - number), (number * x - 1) * (x - S.Half),
              x**3 - 3 * number * x + 1):
        f = expand(f)
        assert agree(real_roots(f, x), real_zeros(f))


@pytest.mark.parametrize("variable", [x, k3, Symbol("x")])
def test_a_root_may_be_a_coefficient(variable):
    """x² − ρ, ρ a root written in the unknown itself: it is not inserted into its own polynomial."""
    rho = CRootOf(variable**5 - variable - 1, 0)
    found = real_roots(k3**2 - rho, k3)
    assert (
        [sign_of_constant(r**2 - rho) for r in found] == [0, 0]
        and found[0] == -found[1]
        or found[0].evalf(30) < 0 < found[1].evalf(30)
    )


def test_numbers_that_depend_on_each_other():
    """√2, √3 and √6 in one polynomial; where the norm vanishes, only formulas are left."""
    for f in (sqrt(3) * x**2 + sqrt(2) * x - sqrt(6), x**3 - sqrt(2) * x**2 - sqrt(3) * x + sqrt(6),
              sqrt(6) * x**2 - 5 * x + sqrt(3)):
        assert agree(real_roots(f, x), real_zeros(f))
    hidden = sqrt(2) + sqrt(3) - sqrt(5 + 2 * sqrt(6))
    assert real_roots(hidden * x, x) is None
    total = sqrt(2) + sqrt(3) + sqrt(5 + 2 * sqrt(6))
    with pytest.raises(ScopeError, match="so that its roots are not found: write them in one root"):
        real_roots(total * x**3 - 2 * total, x)
    assert real_roots(total * x**2 - total, x) == [-1, 1]
    assert real_roots(total * x - 1, x)[0].evalf(20) > 0


@pytest.mark.parametrize("refused", [exp(x) - 2, sin(x), x - gs.symbol("y"), sqrt(x) - 1, I * x - I,
                                     x - CRootOf(x**3 - x - 1, 1), x**2 - sqrt(1 - sqrt(2)),
                                     (x - 1) ** Rational(1, 3)])
def test_what_is_not_a_polynomial_with_real_coefficients(refused):
    """Functions, other names, roots of x, complex coefficients: refused, not overlooked."""
    with pytest.raises(ScopeError, match="is not a fraction of polynomials in x with real numbers for"):
        real_roots(refused, x)


@pytest.mark.parametrize(("rotor", "moment"), [
    (Rational(1, 6), root(2, 12)),
    *slow((root(3, 7) / 2, root(2, 12)), (sqrt(1 + sqrt(2 + sqrt(3))) / 9, cbrt(5)))])
def test_coefficients_of_high_degree(rotor, moment):
    """The tilts of E3 where they have degree 36, 252 and 72, against mpmath."""
    f = 4 * x**3 - x - rotor + x * (2 - moment) / 4
    expected = [a.real for a in mpmath.polyroots([float(c) for c in Poly(f, x).all_coeffs()], extraprec=99)
                if abs(a.imag) < 1e-12]
    # coefficients are doubles
    assert [float(ball(r, 64).mid()) for r in real_roots(f, x)] == pytest.approx(sorted(expected))


def test_coefficients_that_are_algebraic():
    """Roots of even multiplicity, coefficients that are 0 in disguise, cosines of rπ."""
    for found, number in zip(real_roots((x - root(2, 12)) ** 2 * (x - cbrt(3)), x), (root(2, 12), cbrt(3)),
                             strict=True):
        assert sign_of_constant(found - number) == 0
    zero = sqrt(2 + sqrt(3)) - (sqrt(6) + sqrt(2)) / 2
    assert real_roots(zero * x**2 + x - 1, x) == [1] and real_roots(zero * x, x) is None
    assert [float(ball(r, 64).mid()) for r in real_roots(x**2 - cos(pi / 9), x)] == pytest.approx(
        [-0.96937746, 0.96937746]
    )


@pytest.mark.parametrize("polynomial, expected", [
    ((x - pi) * (x + 1) * (x**2 - 2 * x - pi), [1 - sqrt(1 + pi), -1, 1 + sqrt(1 + pi), pi]),
    (((pi + 1) ** 2 * x - pi * (pi**2 + 2 * pi + 1)) * (x - pi), [pi]), (x**2 - 2 * pi * x + pi**2, [pi]),
    (x**2 + log(2), []),
    ((log(4) - 2 * log(2)) * x**5 + x**2 - exp(1), [-exp(Rational(1, 2)), exp(Rational(1, 2))]),
    (pi * x**3 - pi * x, [-1, 0, 1]),
    ((x**2 - 9 * pi**2) / (x - 3 * pi), [-3 * pi]), ((log(6) - log(2) - log(3)) * x, None)])
def test_transcendental_coefficients_of_factors_of_low_degree(polynomial, expected):
    """Linear and quadratic factors by formula.

    Equal roots once, leading coefficients that vanish, poles left out.
    """
    found = real_roots(polynomial, x)
    assert (found is None) == (expected is None)
    assert [sign_of_constant(a - b) for a, b in zip(found or (), expected or (), strict=True)] == [0] * len(
        expected or ()
    )
