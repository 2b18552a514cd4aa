"""What is known of a sign must be true at every point of the domain."""
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, exp, sqrt

from gyrostat.algebra.rings.polynomials import Ring
from gyrostat.algebra.solving.margins import Signs
from gyrostat.notation import symbol

I1, I3, k3, x, omega = map(symbol, ("I1", "I3", "k3", "x", "omega"))
DOMAIN = (1 - k3**2, omega**2)
POINTS = [{I1: Rational(a), I3: Rational(b), k3: Rational(c), x: Rational(d), omega: Rational(e)}
          for a, b, c, d, e in (
    (1, 3, "1/2", -2, 1), (5, "1/7", "-9/10", 0, -3), ("1/3", 2, "99/100", 4, "1/9"), (2, 2, 0, 1, -1))]


def known(expression, domain=DOMAIN):
    ring = Ring([expression, *domain])
    return Signs(ring, domain).of(ring.fraction(expression)[0])


def test_known_signs():
    """Positive symbols, sums of positive terms, domain factors, roots and exponentials.

    None where it depends.
    """
    root = sqrt(1 - k3**2)
    assert (
        known(I1 * I3)
        == known(I1 + 2 * I3)
        == known(1 - k3**2)
        == known(root * I1)
        == known(exp(x))
        == known(omega**2)
        == 1
    )
    assert known(-I1 - I3 * x**2) == known(k3**2 - 1) == -1 and known(I1 - I1) == 0
    assert known(I1 - I3) is known(x) is known(omega) is known(1 - k3) is known(x**2) is None
    assert known(x**2 + I1) == known(x**2 + omega**2 * I1) == 1 and known(x**2 + k3**2 * I1) is None
    assert known((1 - k3) ** 2 * I1, (1 - k3,)) == known(1 - k3, (1 - k3,)) == 1
    assert known(k3 - 1, (1 - k3,)) == -1


def test_a_domain_is_read_in_lowest_terms():
    """(a² − b²)/(a − b) > 0 says a + b > 0, and nothing of a² − b²."""
    a, b = symbol("a"), symbol("b")
    domain = ((a**2 - b**2) / (a - b),)
    assert known(a + b, domain) == 1 and known(a**2 - b**2, domain) is None


def test_quadratics_without_real_roots_have_a_sign():
    """A negative discriminant on the whole domain; not one that only may be negative."""
    # (I1 ω² − k3 x)² + x² (1 − k3²)
    assert known(I1**2 * omega**4 - 2 * I1 * omega**2 * k3 * x + x**2, (*DOMAIN, x**2)) == 1
    assert known(12 * x**2 - 4 * x + 363) == 1 and known(-x**2 + x - 1) == -1
    assert known(x**2 - 2 * x + 1 + I1 - I3) is known(x**2 - 4 * x + 4) is known(x**2 + 3 * x + 2) is None


FACTORS = [I1, I1 + I3, I1 - I3, k3 - 1, k3 + 1, 1 - k3**2, omega, x, x**2 + 1, sqrt(1 - k3**2), exp(x),
           -x - 3, I1 * x - k3]


@given(st.lists(st.tuples(st.sampled_from(FACTORS), st.integers(-2, 3)), min_size=1, max_size=4),
       st.sampled_from([-2, 1, 3]))
def test_the_margin_has_the_sign_of_the_fraction(parts, c):
    """sign(fraction) = 0 where an even factor vanishes, else sign(margin), at points of the domain where it
    is defined.
    """
    expression = Rational(c)
    for factor, n in parts:
        expression *= factor**n
    ring = Ring([expression, *DOMAIN])
    margin, even = Signs(ring, DOMAIN).split(*ring.fraction(expression))
    shown, degenerate = ring.expression(margin), [ring.expression(e) for e in even]
    for point in POINTS:
        value = expression.subs(point)
        if not value.is_finite:
            continue
        vanishes = any(e.subs(point) == 0 for e in degenerate)
        got = 0 if vanishes else shown.subs(point)
        assert (got > 0) == (value > 0) and (got < 0) == (value < 0)


@given(st.lists(st.tuples(st.sampled_from(FACTORS[:9]), st.integers(0, 3)), min_size=1, max_size=4))
def test_the_margin_is_primitive_and_square_free(parts):
    """Integer coefficients without common factor, and no square left: the normal form of the sign."""
    expression = Rational(6, 35)
    for factor, n in parts:
        expression *= factor**n
    ring = Ring([expression, I1, I3, *DOMAIN])
    margin, _ = Signs(ring, DOMAIN).split(*ring.fraction(expression))
    content, factors = margin.factor()
    assert abs(content) == 1 and all(n == 1 for _, n in factors)
    top, bottom = ring.fraction(expression)
    positive = ring.fraction(15 * I1**3 * (I1 + I3) ** 2)[0]
    assert Signs(ring, DOMAIN).split(top * positive, bottom)[0] == margin


def test_nonnegative_and_nonzero():
    """Squares times positive factors; factors of the domain."""
    ring = Ring([x, I1, *DOMAIN, x * I1, k3])
    signs = Signs(ring, DOMAIN)
    polynomial = lambda e: ring.fraction(e)[0]  # noqa: E731
    assert signs.nonnegative(polynomial(x**2 * I1))
    assert not signs.nonnegative(polynomial(x))
    assert signs.nonnegative(ring.zero)
    assert signs.nonzero(polynomial(omega * I1)) and signs.nonzero(polynomial(1 - k3**2))
    assert not signs.nonzero(polynomial(x))
    assert not signs.nonzero(polynomial(x**2))
    assert not signs.nonzero(ring.zero)
