"""Roots of polynomials over transcendental numbers: all of them, in order, and what vanishes at them."""
import pickle
import random

import mpmath
import pytest
from sympy import E, Rational, S, cos, exp, log, pi, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.reals.exact import evaluate, sign_of_constant
from gyrostat.algebra.rings.enclosed_roots import RealRoot, roots_by_enclosures
from gyrostat.algebra.solving.roots import real_roots
from gyrostat.errors import ScopeError

x = gs.symbol("x")


def agree(f):
    """Its real roots are those of mpmath at 60 digits, and f is proved to vanish at them."""
    found = real_roots(f, x)
    with mpmath.workdps(60):
        coefficients = [mpmath.mpf(str(c.evalf(70))) for c in f.as_poly(x).all_coeffs()]
        roots = mpmath.polyroots(coefficients, maxsteps=500, extraprec=500)
        wanted = sorted(z.real for z in roots if abs(z.imag) < mpmath.mpf(10)**-40)
        assert len(found) == len(wanted), f
        for root, near in zip(found, wanted):
            assert abs(mpmath.mpf(ball(root, 200).mid().str(60, radius=False)) - near) < mpmath.mpf(10)**-45
    assert all(sign_of_constant(evaluate(f, {x: root})) == 0 for root in found)
    return found


@pytest.mark.few(9)
@pytest.mark.parametrize("f", [
    x**3 - pi, x**3 * log(2) - 1, x**4 - cos(1), x**5 - pi * x + 1, (pi + 1) * x**3 - 4 * x + 1,
    -pi**2 * x**4 + x**3 + 3 * x**2 - pi, x**3 - sqrt(2) * pi * x**2 + 1, (x**2 - pi) * (x**3 - 2),
    E * x**3 - x - 1, x**6 - pi, (3 - pi) * x**3 + x**2 - 1, x**3 - exp(2) * x + Rational(1, 7),
    Rational(2, 3) * x**3 - pi * x / 5 + Rational(1, 9)])
def test_all_real_roots(f):
    agree(f)


@pytest.mark.slow
def test_random_polynomials():
    rng = random.Random("pi")
    count = 0
    for _ in range(12):
        def number():
            return Rational(rng.randint(-9, 9), rng.randint(1, 5))
        f = sum((number() + number() * pi + number() * pi**2 * rng.randint(0, 1)) * x**n for n in range(7))
        count += len(agree(f))
    assert count > 12


def test_signs_order_and_bounds():
    low, middle, high = real_roots(x**3 - pi * x + 1, x)
    assert sign_of_constant(low + 1) == -1 and sign_of_constant(high - middle) == 1
    assert real_roots(x**3 - pi * x + 1, x, S.Zero, S.One) == [middle]
    assert sign_of_constant(low + middle + high) is None   # 0 by Vieta's theorem, which is not asked
    assert sign_of_constant(middle**3 - pi * middle + 1) == 0


def test_a_root_is_a_number():
    (root,) = real_roots(x**3 - pi, x)
    assert isinstance(root, RealRoot) and root == pickle.loads(pickle.dumps(root))
    assert root.is_real and root.is_number and not root.free_symbols
    assert f"{float(root):.12f}" == f"{3.14159265358979**(1 / 3):.12f}"
    assert str(root.evalf(30)) == str((pi ** Rational(1, 3)).evalf(30))


@pytest.mark.slow
def test_zeros_that_are_spelt_otherwise():
    """√2 log 8 − 3 √2 log 2 = 0 and e − e = 0 are no coefficients; a double root is isolated by nobody."""
    two = sqrt(2) * log(8) - 3 * sqrt(2) * log(2)
    hidden = exp(Rational(1, 3)) ** 3 - E + log(6) - log(2) - log(3)
    (root,) = real_roots(x**3 - pi, x)
    assert real_roots((x**3 - pi)**2 + two * x, x) == [root]
    assert real_roots(hidden * x**5 + x**3 - pi, x) == [root]
    assert roots_by_enclosures([pi**2, S.Zero, -2 * pi, S.Zero, S.One]) is None


@pytest.mark.slow
def test_roots_that_are_not_told_apart_are_refused():
    """x (x³ − a) + b (x − 1)² at a = 1, with a zero b that is not known to be one: a root 1 may be double."""
    unknown = log(sqrt(2) + 1) + log(sqrt(2) - 1)          # 0
    with pytest.raises(ScopeError, match="round"):
        real_roots((x - 1)**2 * (x**2 - pi) + unknown * x, x)


def test_tilts_at_a_rate_in_rpm():
    """Of U = k3 + k3⁴ at omega = π/3: those at a decimal near it, with the same verdicts."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3 + k3**4))
    found, near = (gs.relative_equilibria(scene, {"I1": 2, "I3": 1, "l": 3, "omega": omega})
                   for omega in ("pi/3", "1.0471975511965977461542144610931676"))
    assert [b.label for b in found] == [b.label for b in near] == ["E1", "E3", "E2"]
    assert [b.decision.verdict for b in found] == [b.decision.verdict for b in near]
    exact, decimal = (each[1].place["k3"] for each in (found, near))
    assert abs(float(exact - decimal)) < 1e-30 and isinstance(exact, RealRoot)
