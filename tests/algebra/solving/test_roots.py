"""Roots of polynomials: products of known factors, Sturm's theorem.

Enclosures of roots without a formula.
"""
from fractions import Fraction
from itertools import pairwise

import mpmath
import oracle
import pytest
from algebra.zeros import agree, digits, real_zeros, x
from draw import numbers
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import CRootOf, Integer, Poly, Rational, S, atan, expand, oo, pi, sqrt

from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.algebra.solving.roots import between, in_order, real_roots
from gyrostat.errors import ScopeError

polynomials = st.lists(numbers, min_size=2, max_size=8).filter(lambda c: any(c[1:]))


def rational(a):
    """A fraction as a number of SymPy."""
    return Rational(a.numerator, a.denominator)


def written(coefficients, variable=x):
    """A polynomial of fractions as an expression."""
    return sum((rational(a) * variable**n for n, a in enumerate(coefficients)), S.Zero)


@given(st.lists(st.tuples(numbers, st.integers(1, 3)), max_size=3),
       st.lists(st.tuples(numbers, numbers, st.integers(1, 2)), max_size=2),
       numbers.filter(bool))
@settings(max_examples=12)
def test_products_of_known_factors(linear, quadratic, scale):
    """Π (x − a)ᵐ Π ((x − b)² − d)ⁿ: each a, each b ± √d with d ≥ 0, once, in increasing order.

    The factors with d < 0 have none.
    """
    expected = {rational(a) for a, _ in linear}
    product = rational(scale)
    for a, m in linear:
        product *= (x - rational(a)) ** m
    for b, d, n in quadratic:
        product *= ((x - rational(b)) ** 2 - rational(d)) ** n
        expected |= {rational(b) + s * sqrt(rational(d)) for s in (1, -1) if d >= 0}
    found = real_roots(expand(product), x)
    assert set(found) == expected and len(found) == len(expected)
    assert all(a.evalf(60) < b.evalf(60) for a, b in zip(found, found[1:]))


@pytest.mark.slow
@given(polynomials, st.tuples(numbers, numbers).filter(lambda ends: ends[0] < ends[1]))
@settings(max_examples=8)
def test_as_many_roots_as_sturm_counts(coefficients, ends):
    """Random polynomials of degree up to 7.

    The number of roots on the line and in an interval, its ends left out.
    """
    f, (low, high) = written(coefficients), ends
    found = real_roots(f, x)
    assert len(found) == oracle.count_roots(coefficients)
    inside = real_roots(f, x, rational(low), rational(high))
    assert len(inside) == oracle.count_roots(coefficients, low, high)
    assert inside == [r for r in found if low < r.evalf(60) < high]
    assert len(real_roots(f, x, low=rational(low))) == oracle.count_roots(coefficients, low, None)
    # between two rationals beside each root there is one, and no other
    for r in found:
        centre = Fraction(int((r.evalf(50) * 10**30).round()), 10**30)
        assert (
            oracle.count_roots(coefficients, centre - Fraction(1, 10**25), centre + Fraction(1, 10**25)) == 1
        )


def test_ends_are_left_out():
    """Roots at the ends of the interval, rational and algebraic, exactly and by 10⁻⁶⁰."""
    cubic = x * (x**2 - 1)
    assert real_roots(cubic, x, -S.One, S.One) == [0] and real_roots(cubic, x, low=S.Zero) == [1]
    assert real_roots(cubic, x, high=S.Zero) == [-1]
    half = sqrt(2) / 2
    assert real_roots(2 * x**2 - 1, x, -half, half) == []
    assert real_roots(2 * x**2 - 1, x, -half, half + Rational(1, 10**60)) == [half]
    root = CRootOf(x**5 - x - 1, 0)
    assert real_roots(x**5 - x - 1, x, low=root) == []
    assert real_roots(x**5 - x - 1, x, low=root - Rational(1, 10**60)) == [root]


def test_irreducible_factors_keep_their_own_polynomial():
    """(x³ − x − 1)² (x⁴ − 10 x² + 1) (3 x − 2): roots of the factors, not of the product."""
    found = real_roots(expand((x**3 - x - 1) ** 2 * (x**4 - 10 * x**2 + 1) * (3 * x - 2)), x)
    assert [r for r in found if not isinstance(r, CRootOf)] == [Rational(2, 3)]
    assert sorted(r.poly.degree() for r in found if isinstance(r, CRootOf)) == [3, 4, 4, 4, 4]
    assert agree([r for r in found if isinstance(r, CRootOf) and r.poly.degree() == 4],
                 real_zeros(x**4 - 10 * x**2 + 1))


def test_identically_zero_is_none():
    """0, x − x in disguise, and a product that expands to it, are no polynomial with roots.

    A constant has none.
    """
    assert real_roots(S.Zero, x) is None and real_roots((x + 1) ** 2 - x**2 - 2 * x - 1, x) is None
    assert real_roots(x * (sqrt(2) ** 2 - 2), x) is None
    assert real_roots(sqrt(2) * (x + 1) - sqrt(2) * x - sqrt(2), x) is None
    assert real_roots(S.One, x) == [] and real_roots(sqrt(2), x) == [] and real_roots(1 / x, x) == []


def test_zeros_of_the_denominator_are_no_roots():
    """Rational functions: zeros of the numerator where the function is defined."""
    assert real_roots((x**2 - 1) / (x - 1), x) == [-1]
    assert real_roots((x**2 - 2) / (x - sqrt(2)), x) == [-sqrt(2)]
    assert real_roots(1 / (x - 1) + 1 / (x + 1), x) == [0]
    assert real_roots(x / (x**3 - x - 1), x) == [0]
    assert real_roots((x**3 - x - 1) / (x**3 - x - 1) ** 2, x) == []


def test_order():
    """Numbers nearer to each other than any float, in order."""
    near = [sqrt(2) + Rational(n, 10**80) for n in (3, -1, 0, 2, -5)]
    assert in_order(near) == sorted(near, key=lambda a: (a - sqrt(2)))
    with pytest.raises(ScopeError, match="is not proved"):
        in_order([16 * atan(Rational(1, 5)) - 4 * atan(Rational(1, 239)), pi])


@pytest.mark.few(2)
@pytest.mark.parametrize("size", [Integer(1), 10**17 + sqrt(2), Integer(10)**300 * pi, Rational(1, 10**300)],
                         ids=["1", "10^17", "10^300", "10^-300"])
def test_a_number_lies_between_two_of_any_size(size):
    """Beyond 10^16 too, where a double has no fraction, and next to a number of 300 digits."""
    for a, b in ((size, 2 * size), (size, size + 1), (size, size * (1 + Rational(1, 10**40)))):
        for low, high in ((a, b), (-b, -a)):
            order = [between(-oo, low), low, between(low, high), high, between(high, oo)]
            assert [sign_of_constant(y - x) for x, y in pairwise(order)] == [1] * 4


@pytest.mark.parametrize("order", [20, -40, 300])
def test_roots_of_any_size(order):
    """Those of x⁵ − x − 1 and of x³ − 7x + 7 for x = y/10ⁿ: 10ⁿ times the roots; soon known as floats."""
    unit = Rational(10) ** order
    for coefficients in ([-1, -1, 0, 0, 0, 1], [7, -7, 0, 1]):
        near, found = (real_roots(written(c), x) for c in (coefficients, [
            a / unit**n for n, a in enumerate(coefficients)]))
        assert [sign_of_constant(b - unit * a) for a, b in zip(near, found, strict=True)] == [0] * len(near)
        assert agree([b / unit for b in found], real_zeros(written(coefficients)))


@pytest.mark.slow
@given(st.lists(st.integers(-9, 9), min_size=4, max_size=8).filter(lambda c: c[-1] and c[0]),
       st.lists(numbers, min_size=3, max_size=3))
@settings(max_examples=8)
def test_signs_of_roots_without_a_formula(coefficients, points):
    """CRootOf(f, n) − q is positive where at most n roots of f are below q; zero is found.

    A complex root has no sign.
    """
    f = Poly(coefficients[::-1], x)
    assume(f.is_irreducible)
    real = oracle.count_roots(coefficients)
    for n in range(f.degree()):
        root = CRootOf(f, n)
        if n >= real:
            assert sign_of_constant(root) is None
            assert sign_of_constant(root - 1) is None
            assert not ball(root, 100).is_finite()
            continue
        for q in points:
            below = oracle.count_roots(coefficients, None, q)
            assert sign_of_constant(root - rational(q)) == (1 if below <= n else -1)
        assert sign_of_constant(sum((Integer(c) * root**i for i, c in enumerate(coefficients)), S.Zero)) == 0
        with mpmath.workdps(60):
            assert (
                abs(mpmath.mpf(str(ball(root, 200).mid().str(55, radius=False))) - digits(root, 55))
                < mpmath.mpf(10) ** -50
            )
