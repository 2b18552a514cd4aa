"""Roots of polynomials: products of known factors, Sturm's theorem, mpmath.

Enclosures of roots without a formula.
"""
from fractions import Fraction

import mpmath
import oracle
import pytest
from draw import numbers
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import (
    CRootOf,
    I,
    Integer,
    Poly,
    Rational,
    S,
    Symbol,
    atan,
    cbrt,
    cos,
    exp,
    expand,
    log,
    pi,
    root,
    sin,
    sqrt,
)

import gyrostat as gs
from gyrostat.algebra.balls import ball
from gyrostat.algebra.exact import sign_of_constant
from gyrostat.algebra.roots import in_order, real_roots
from gyrostat.errors import ScopeError

x, k3 = gs.symbol("x"), gs.symbol("k3")
polynomials = st.lists(numbers, min_size=2, max_size=8).filter(lambda c: any(c[1:]))


def rational(a):
    """A fraction as a number of SymPy."""
    return Rational(a.numerator, a.denominator)


def written(coefficients, variable=x):
    """A polynomial of fractions as an expression."""
    return sum((rational(a) * variable**n for n, a in enumerate(coefficients)), S.Zero)


def digits(number, n=60):
    """A number to n digits, of mpmath."""
    return mpmath.mpf(str(number.evalf(n)))


def real_zeros(expression):
    """The real roots of a polynomial by mpmath, to 50 digits.

    For roots that are distinct and not close together.
    """
    with mpmath.workdps(80):
        terms = {n: expand(expression).coeff(x, n) for n in range(9)}
        coefficients = [mpmath.mpf(str(c.evalf(80))) for _, c in sorted(terms.items(), reverse=True)]
        while not coefficients[0]:
            coefficients.pop(0)
        found = mpmath.polyroots(coefficients, maxsteps=400, extraprec=400)
        return sorted(mpmath.re(r) for r in found if abs(mpmath.im(r)) < mpmath.mpf(10) ** -50)


def agree(ours, theirs):
    """Whether two lists of numbers are the same to 45 digits: both are computed to 50 or more."""
    with mpmath.workdps(80):
        return len(ours) == len(theirs) and all(abs(digits(a) - b) < mpmath.mpf(10) ** -45
                                                for a, b in zip(ours, theirs))


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


@given(polynomials, st.tuples(numbers, numbers).filter(lambda ends: ends[0] < ends[1]))
@settings(max_examples=12)
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


THIRD, FIFTH = cbrt(2), CRootOf(x**5 - x - 1, 0)


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
    with pytest.raises(ScopeError, match="depend on each other: write them in one root"):
        real_roots(total * x**3 - 2 * total, x)
    assert real_roots(total * x**2 - total, x) == [-1, 1]
    assert real_roots(total * x - 1, x)[0].evalf(20) > 0


def test_identically_zero_is_none():
    """0, x − x in disguise, and a product that expands to it, are no polynomial with roots.

    A constant has none.
    """
    assert real_roots(S.Zero, x) is None and real_roots((x + 1) ** 2 - x**2 - 2 * x - 1, x) is None
    assert real_roots(x * (sqrt(2) ** 2 - 2), x) is None
    assert real_roots(sqrt(2) * (x + 1) - sqrt(2) * x - sqrt(2), x) is None
    assert real_roots(S.One, x) == [] and real_roots(sqrt(2), x) == [] and real_roots(1 / x, x) == []


@pytest.mark.parametrize("refused", [x**3 - pi, exp(x) - 2, sin(x), x - gs.symbol("y"), sqrt(x) - 1,
                                     x**3 * log(2) - 1, x**4 - cos(1),
                                     I * x - I,
                                     x - CRootOf(x**3 - x - 1, 1), x**2 - sqrt(1 - sqrt(2)),
                                     (x - 1) ** Rational(1, 3)])
def test_what_is_not_a_polynomial_with_real_algebraic_coefficients(refused):
    """Transcendental coefficients from degree 3 on, functions, other names, roots of x, complex coefficients:
    refused, not overlooked.
    """
    with pytest.raises(ScopeError, match="is not a polynomial in x with algebraic coefficients"):
        real_roots(refused, x)


def test_zeros_of_the_denominator_are_no_roots():
    """Rational functions: zeros of the numerator where the function is defined."""
    assert real_roots((x**2 - 1) / (x - 1), x) == [-1]
    assert real_roots((x**2 - 2) / (x - sqrt(2)), x) == [-sqrt(2)]
    assert real_roots(1 / (x - 1) + 1 / (x + 1), x) == [0]
    assert real_roots(x / (x**3 - x - 1), x) == [0]
    assert real_roots((x**3 - x - 1) / (x**3 - x - 1) ** 2, x) == []


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


def test_order():
    """Numbers nearer to each other than any float, in order."""
    near = [sqrt(2) + Rational(n, 10**80) for n in (3, -1, 0, 2, -5)]
    assert in_order(near) == sorted(near, key=lambda a: (a - sqrt(2)))
    with pytest.raises(ScopeError, match="is not proved"):
        in_order([16 * atan(Rational(1, 5)) - 4 * atan(Rational(1, 239)), pi])


@given(st.lists(st.integers(-9, 9), min_size=4, max_size=8).filter(lambda c: c[-1] and c[0]),
       st.lists(numbers, min_size=3, max_size=3))
@settings(max_examples=12)
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
