"""All real roots of integer polynomials, against Sturm's theorem in fractions; roots that nearly coincide."""
from fractions import Fraction

import pytest
from flint import ctx, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from gyrostat.algebra.enclosures.balls import ends
from gyrostat.algebra.enclosures.precision import own_precision
from gyrostat.algebra.enclosures.real_roots import isolated_roots


def value(f, x):
    """The value of a polynomial, coefficients from the constant term on."""
    return sum(c * x**n for n, c in enumerate(f))


def remainder(f, g):
    """The remainder of f by g, in fractions."""
    f = [Fraction(c) for c in f]
    while len(f) >= len(g):
        lead = f[-1] / g[-1]
        f = [c - lead * g[n - len(f) + len(g)] if n >= len(f) - len(g) else c for n, c in enumerate(f)][:-1]
    while f and not f[-1]:
        f.pop()
    return f


def counted(f, low, high):
    """How many distinct roots lie between low, exclusive, and high, inclusive: Sturm."""
    chain = [f, [n * c for n, c in enumerate(f)][1:]]
    while chain[-1] and (rest := remainder(chain[-2], chain[-1])):
        chain.append([-c for c in rest])

    def changes(x):
        signs = [v > 0 for g in chain if g and (v := value(g, x))]
        return sum(a != b for a, b in zip(signs, signs[1:]))

    return changes(low) - changes(high)


linear = st.tuples(st.integers(-40, 40), st.sampled_from([1, 2, 3, 7, 1024]))


@given(st.lists(linear, max_size=4), st.lists(st.integers(-9, 9), min_size=1, max_size=5))
def test_every_root_is_isolated_once(factors, rest):
    f = fmpz_poly([*rest, 1])
    for c, d in factors:
        f *= fmpz_poly([c, d])
    coefficients = [int(c) for c in f.coeffs()]
    with own_precision(80):
        found = isolated_roots(f)
        assert all(x.rel_accuracy_bits() >= 80 for x in found)
    if f.degree():
        far = Fraction(2 * max(map(abs, coefficients)) + 1)
        assert len(found) == counted(coefficients, -far, far)
    for low, high in map(ends, found):
        assert value(coefficients, low) == 0 == high - low or counted(
            coefficients, low - Fraction(1, 10**60), high) == 1
    assert all(a < b for a, b in zip(found, found[1:]))


@pytest.mark.parametrize("gap", [10, 300, 2000])
def test_roots_that_nearly_coincide(gap):
    """Two roots 2⁻ᵍᵃᵖ apart, neither a dyadic fraction, of either sign: each is enclosed apart."""
    for side in (1, -1):
        f = fmpz_poly([-5 * side, 3]) * fmpz_poly([-side * (5 * 2**gap + 1), 3 * 2**gap])
        with own_precision(128):
            found = isolated_roots(f * fmpz_poly([1, 0, 1]))
        (a, b), (c, d) = (ends(x) for x in found)
        near, beside = sorted((side * Fraction(5, 3), side * Fraction(5 * 2**gap + 1, 3 * 2**gap)))
        assert a <= near <= b < c <= beside <= d and ctx.prec == 53


def test_sizes_far_apart():
    """Roots near 10⁹⁰⁰ and 10⁻³⁰⁰, to as many bits."""
    with own_precision(100):
        found = isolated_roots(fmpz_poly([-(10**300), 0, 10**900, 1]))
        assert [x.rel_accuracy_bits() >= 100 for x in found] == [True] * 3
    for x, (sign, order) in zip(found, ((-1, 900), (-1, -300), (1, -300))):
        assert all(abs(e / (sign * Fraction(10)**order) - 1) < Fraction(1, 10**25) for e in ends(x))
