"""Roots of irreducible polynomials as numbers that SymPy can evaluate, however close or small they are."""
from fractions import Fraction

import pytest
from flint import fmpz_poly
from sympy import Rational

from gyrostat.algebra.solving.root_numbers import refuse_touching, roots_of
from gyrostat.errors import ScopeError


def value(coefficients, x):
    """Of a polynomial at a fraction."""
    return sum(a * x**n for n, a in enumerate(coefficients))


@pytest.mark.parametrize("a", [3, 10**4, 10**15, 10**30], ids="{:.0e}".format)
def test_roots_that_are_close_to_one_another(a):
    """x⁵ − 2 (a x − 1)² has two roots 1/a ± δ, δ² a⁷ = 1/2: each to 100 digits.

    References
    ----------
    Mignotte, Some useful bounds (1983).
    """
    coefficients = [-2, 4 * a, -2 * a**2, 0, 0, 1]
    found = roots_of(list(map(Rational, coefficients)))
    assert len(found) == 3
    for root in found:
        near = Fraction(str((root + root**2 - root**2).evalf(140)))
        low, high = (value(coefficients, near * (1 + s * Fraction(1, 10**100))) for s in (1, -1))
        assert low * high < 0


@pytest.mark.parametrize("order", [0, 8, -30, 60, 300])
def test_products_with_roots_of_any_size(order):
    """y⁵ + y³ = 1 at x = 10ⁿ y: one root, and SymPy knows where."""
    unit = Rational(10) ** order
    (root,) = roots_of([-unit**5, Rational(0), Rational(0), unit**2, Rational(0), Rational(1)])
    y = Fraction(str((2 * root).evalf(60))) / 2 / Fraction(10)**order
    assert abs(y**5 + y**3 - 1) < Fraction(1, 10**50)


@pytest.mark.parametrize("middle", [10**4000, Rational(1, 10**4000)], ids=["large", "small"])
def test_roots_of_too_different_sizes_are_refused(middle):
    """x³ + m x + 1, and m x³ + x² + 1: one root is 10⁴⁰⁰⁰ times another, said at once."""
    coefficients = [1, middle, 0, 1] if middle > 1 else [1, 0, 1, middle]
    with pytest.raises(ScopeError, match="of so different sizes .*: leave out what is far too small"):
        roots_of(list(map(Rational, coefficients)))


def test_roots_too_close_for_all_complex_ones_are_refused():
    """Roots 2⁻²⁰⁰⁰ apart are, and not those at a moderate distance or a double one."""
    x = fmpz_poly([0, 1])
    for allowed in ((x - 1) * (x - 2), (x - 1) ** 2 * (x - 2), (2**40 * x - 2**40 - 1) * (x - 1)):
        refuse_touching(allowed)
    with pytest.raises(ScopeError, match="no longer told apart"):
        refuse_touching((2**2000 * x - 2**2000 - 1) * (x - 1))
