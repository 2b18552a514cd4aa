"""The normal form of Hamiltonians that are given: oscillators, the triangular Lagrange point."""
from dataclasses import dataclass
from functools import partial

import pytest
from flint import acb, arb, fmpq
from sympy import Expr, Rational, expand, sqrt

from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.enclosures.precision import own_precision
from gyrostat.algebra.reals.eigenvalues import eigenvalues_of
from gyrostat.algebra.rings.series import composed, variable
from gyrostat.notation import symbol
from gyrostat.stability.normal_forms.birkhoff import characteristic, linear_motion, modes, normalised, twist
from gyrostat.stability.normal_forms.resonances import fourth_order_resonance, third_order_resonance

PRECISION = 256
Q, P = (symbol(f"k{n}") for n in (1, 2))


def triangular(mu, degree, number):
    """The planar problem of three bodies about the triangular point: (x, p, y, r), less the constant."""
    one = number(Rational(1))
    x, p, y, r = (variable(n, degree, 0 * one) for n in range(4))
    root, shift = number(sqrt(3) / 2), one / 2 - number(mu)
    # places and momenta at rest in the rotating axes: p = −y, r = x
    x, y, p, r = x.shifted(shift), y.shifted(root), p.shifted(-root), r.shifted(shift)
    place = {Q: x, P: y}
    U = -(1 - mu) / sqrt((Q + mu)**2 + P**2) - mu / sqrt((Q + mu - 1)**2 + P**2)
    kinetic = (p * p + r * r).scaled(one / 2)
    return (kinetic + y * p - x * r + composed(U, place, number)).parts


def in_balls(mu, degree):
    """p, q, the parts of the normal form, the modes."""
    parts = triangular(mu, degree, partial(ball, precision=PRECISION))
    A = linear_motion(parts[2])
    p, q = characteristic(A)
    root = (p * p - 4 * q).sqrt()
    squares = (p + root) / 2, (p - root) / 2
    found = modes(A, p, tuple(acb(0, square.sqrt()) for square in squares)).oriented()
    return p, q, normalised(parts, found), found


@pytest.mark.few(8)
@pytest.mark.parametrize("n", range(1, 41))
def test_the_triangular_point_in_closed_form(n):
    """2 D4 = (36 − 541 s + 644 s²)/(8 (1 − 4 s)(4 − 25 s)), s = ω1² ω2² (Deprit and Deprit-Bartholomé)."""
    mu = Rational(n, 1050)
    with own_precision(PRECISION):
        _, s, h, found = in_balls(mu, 4)
        D4 = twist(h[4], found).real
        assert abs(2 * D4 - (36 - 541 * s + 644 * s**2) / (8 * (1 - 4 * s) * (4 - 25 * s))) < arb("1e-40")
        assert found.values[0].imag > 0 > found.values[1].imag


def at_product(product):
    """The mass with μ (1 − μ) of that value."""
    return (1 - sqrt(1 - 4 * product)) / 2


def test_the_triangular_point_where_the_closed_form_vanishes():
    """At μ = 0.0109136676772 D4 = 0 and D6 = 66.6297952504 (Meyer and Schmidt)."""
    mu = at_product((541 - sqrt(541**2 - 4 * 36 * 644)) / 1288 * 4 / 27)
    assert abs(mu - 0.0109136676772) < 1e-12
    with own_precision(PRECISION):
        _, _, h, found = in_balls(mu, 6)
        assert abs(twist(h[4], found).real) < arb("1e-40")
        assert abs(twist(h[6], found).real - arb("66.6297952504")) < arb("1e-10")


@dataclass
class Given:
    """What the resonances ask of a motion."""

    mu: Expr
    rational: bool = False

    @property
    def p(self):
        return Rational(1)

    @property
    def q(self):
        return expand(27 * self.mu * (1 - self.mu) / 4)

    def energy(self, degree, number):
        return triangular(self.mu, degree, number)


@pytest.mark.parametrize("product, mass, decides, words", [
    (Rational(16, 675), 0.0242938971421, third_order_resonance, "b of z1 z2² is not 0"),
    (Rational(1, 75), 0.0135160160225, fourth_order_resonance, " < R = ")])
def test_the_triangular_point_at_the_resonances(product, mass, decides, words):
    """Unstable at 1:2 and at 1:3 (Markeev)."""
    motion = Given(at_product(product))
    assert abs(motion.mu - mass) < 1e-12
    finding = decides(motion)
    assert finding.unstable and words in finding.reason


def oscillators(*above):
    """(5/2)(x² + p²) − (y² + r²) and terms above it, by exponents."""
    parts = [{} for _ in range(7)]
    for place, c in ((0, fmpq(5, 2)), (1, fmpq(5, 2)), (2, fmpq(-1)), (3, fmpq(-1))):
        parts[2][2 << 4 * place] = c
    for degree, code, c in above:
        parts[degree][code] = fmpq(c)
    p, q = characteristic(linear_motion(parts[2]))
    assert (p, q) == (29, 100)
    found = modes(linear_motion(parts[2]), p, eigenvalues_of(p, q))
    return normalised(parts, found), found


@pytest.mark.parametrize("above, fourth, sixth", [
    ([(4, 4, 1)], fmpq(3, 2), -fmpq(17, 4) / 5),           # x⁴
    ([(3, 3, 1)], fmpq(-15, 4) / 5, -fmpq(705, 16) / 5**3),  # x³
])
def test_one_oscillator(above, fourth, sixth):
    """Of ω (x² + p²)/2 + x⁴, K = ω I + (3/2) I² − (17/4)/ω I³; of x³, −(15/4)/ω I² − (705/16)/ω³ I³."""
    h, found = oscillators(*above)
    D4, D6 = (twist(h[n], found) for n in (4, 6))
    # I1 = ω2 = ∓2, of an order of the frequencies that is not fixed
    assert D4.rational() == fourth * 4
    assert (D6 * D6).rational() == (sixth * 8) ** 2
