"""Families of permanent rotations whose margins factor: about axis 3, in a plane of symmetry, and off it."""
import random
from fractions import Fraction

import pytest
from drawn_rotations import NOTHING, direction
from heavy_scenes import scene_of
from slow import sampled
from sympy import Rational, Symbol, diag, expand, fraction, rem, symbols, together

import gyrostat as gs
from gyrostat.stability.criteria.amended_form import amended_form

I = I1, I2, I3 = symbols("I1:4")
k1, k2, k3, l1, l3, w, m0, sigma = symbols("k1 k2 k3 l1 l3 omega m0 sigma")


def form_of(k, rotor, sigma):
    """The closed form, with ∇U = omega² Ik + omega l + sigma k of a uniform field."""
    slopes = [w**2 * m * x + w * l + sigma * x for m, x, l in zip(I, k, rotor)]
    return amended_form(diag(*I).tolist(), rotor, slopes, NOTHING, k, w)


def vanishes(expression, k: Symbol, square):
    """Whether it is 0 on abs(k) = 1."""
    return rem(fraction(together(expression))[0].expand(), square - 1, k) == 0


def test_about_axis_3():
    form = form_of((0, 0, 1), (0, 0, l3), m0 - w * l3 - w**2 * I3)
    a, b = ((I3 - m) * w**2 + w * l3 - m0 for m in (I1, I2))
    assert expand(form.determinant - a * b) == expand(form.trace - a - b) == 0
    B = (I1 + I2 - I3) * w - l3
    assert expand(form.p * I1 * I2 - (B**2 + I1 * a + I2 * b)) == 0
    assert expand(form.q * I1 * I2 - a * b) == 0


@pytest.mark.slow
def test_in_a_plane_of_symmetry():
    """k2 = l2 = c2 = 0: one margin across the plane, one in it."""
    form, J = form_of((k1, 0, k3), (l1, 0, l3), sigma), I1 * k1**2 + I3 * k3**2
    across = -(sigma + w**2 * I2)
    twist = 2 * w * (I1 - I3) * k1 * k3 + l1 * k3 - l3 * k1
    within = twist**2 / J - (sigma + w**2 * (I1 * k3**2 + I3 * k1**2))
    assert vanishes(form.determinant - across * within, k1, k1**2 + k3**2)
    assert vanishes(form.trace - across - within, k1, k1**2 + k3**2)


@pytest.mark.slow
def test_off_it():
    """c3 = 0 = l, sigma = −omega² I3."""
    form, J = form_of((k1, k2, k3), (0, 0, 0), -(w**2) * I3), sum(m * k**2 for m, k in zip(I, (k1, k2, k3)))
    factored = w**4 * k3**2 * (I1 - I3) * (I2 - I3) * (4 * I3 - 3 * J) / J
    assert vanishes(form.determinant - factored, k3, k1**2 + k2**2 + k3**2)


def check(rng):
    """At numbers, any axis: the determinant, and J by I, omega and c alone; stable about the largest."""
    k, omega = direction(rng), Fraction(rng.randint(1, 12), rng.randint(1, 6))
    moments = [Fraction(x, 10) for x in rng.sample(range(4, 31), 3)]
    n = rng.randrange(3)
    c = [omega**2 * (m - moments[n]) * x for m, x in zip(moments, k)]
    found = gs.relative_equilibria(scene_of(moments, [0, 0, 0], c, NOTHING), {"omega": omega})
    (here,) = [r for r in found if r.directions[0] == tuple(Rational(x) for x in k)]
    others = [m for m in range(3) if m != n]
    J = moments[n] + sum(c[m]**2 / (moments[m] - moments[n]) for m in others) / omega**4
    a, b = (moments[m] - moments[n] for m in others)
    determinant = here.form.invariants(None).form[-1]
    assert determinant == Rational(omega**4 * k[n]**2 * a * b * (4 * moments[n] - 3 * J) / J)
    if moments[n] == max(moments):
        assert here.decision.verdict.name == "STABLE"
    elif a * b * (4 * moments[n] - 3 * J) < 0:
        assert here.decision.verdict.name == "UNSTABLE"
    return here.decision.verdict.name


@pytest.mark.slow
def test_at_numbers():
    rng = random.Random("off every plane")
    assert {check(rng) for _ in range(12)} >= {"STABLE", "UNSTABLE"}


@pytest.mark.slow
def test_many(full):
    rng = random.Random("many off every plane")
    seen = [check(rng) for _ in range(sampled(1000, full, 120))]
    assert {*seen} == {"STABLE", "UNSTABLE"}
