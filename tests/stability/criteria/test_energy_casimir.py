"""Multipliers, the second variation on the slice, its minors, and the same definiteness by an independent
route.
"""
from fractions import Fraction

import numpy as np
import oracle
import pytest
from draw import moments, nonzero, numbers
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Matrix, Rational, cancel, expand, simplify

import gyrostat as gs

THREE = st.tuples(*[numbers] * 3)


def R(value):
    return Rational(Fraction(value).numerator, Fraction(value).denominator)


def test_first_variation_vanishes(scene, free):
    """∇h + Σ νⱼ ∇Fⱼ = 0, whatever the free multiplier."""
    for eq in (*(make(scene) for make in (gs.upright, gs.hanging, gs.inclined, gs.static_tilt)),
               gs.principal_rotation(free, 3)):
        variation = gs.derivation.second_variation(eq)
        total = eq.at_point(eq.system.energy_gradient)
        for function, nu in variation.multipliers:
            total += nu * eq.at_point(eq.system.space.gradient(function))
        assert total.applyfunc(cancel) == Matrix.zeros(len(eq.point), 1)


def test_multipliers_of_the_source(e3):
    """At E3 λ = −ω, μ = I1 ω²/2 (VV2003 §3)."""
    (_, first), (_, second) = e3.second_variation.multipliers
    assert first == -gs.symbol("omega")
    assert expand(second - gs.symbol("I1") * gs.symbol("omega") ** 2 / 2) == 0


def test_slices(e1, e2, e3, at_rest):
    """At E1, E2 the integral π3 is critical and frees a multiplier.

    At E3 it is held fixed and its flow divided out.
    """
    for report in (e1, e2):
        variation = report.second_variation
        assert (variation.basis.cols, len(variation.free), variation.modulo) == (4, 1, ())
    for report in (e3, at_rest):
        variation = report.second_variation
        assert (variation.basis.cols, variation.free, variation.modulo) == (2, (), (gs.symbol("pi3"),))
        assert all(entry == 0 for entry in variation.basis.row(2))


def test_slice_at_e3_is_transversal_to_the_spin(scene):
    """The slice and the direction of the spin span the tangent space of the level set of π3."""
    eq = gs.inclined(scene)
    flow = eq.at_point(scene.space.tensor * scene.space.gradient(gs.symbol("pi3")))
    values = {gs.symbol(n): Rational(v) for n, v in (("k3", "3/5"), ("I1", 2), ("I3", 1), ("l", "1/3"),
                                                     ("omega", "5/7"))}
    together = Matrix.hstack(Matrix(gs.derivation.symplectic_slice(eq)), Matrix(flow)).subs(values)
    assert together.rank() == 3
    casimirs = Matrix.vstack(*(Matrix(eq.at_point(scene.space.gradient(c)).T)
                               for c in (*scene.space.casimirs, gs.symbol("pi3"))))
    assert (casimirs.subs(values) * together).applyfunc(simplify) == Matrix.zeros(3, 3)


def test_minors_are_determinants(e1, e3):
    """Leading principal minors of the symmetric matrix."""
    for report in (e1, e3):
        matrix = report.second_variation.matrix
        assert matrix.T == matrix
        for n, minor in enumerate(report.second_variation.minors, 1):
            assert cancel(minor - matrix[:n, :n].det()) == 0


def reduced_form(inertia, rotor, k, w, g, H):
    """The 2×2 form on δk ⟂ k.

    It is δk·(Hess U + μ − w² I) δk + (v·δk)²/(k·Ik), v = 2 w I k + l, μ = w k·M − k·∇U.
    """
    I, l, k = oracle.exact(inertia), oracle.exact(rotor), np.array(k, dtype=object)
    grad = g + H.dot(k)
    mu = w * k.dot(w * I * k + l) - k.dot(grad)
    A = H + np.diag([mu - w**2 * i for i in I])
    v = 2 * w * I * k + l
    A = A + np.outer(v, v) / k.dot(I * k)
    a = (
        np.array([k[1], -k[0], 0 * k[0]], dtype=object)
        if k[0] or k[1]
        else np.array([1, 0, 0], dtype=object) + 0 * k
    )
    b = np.cross(k, a)
    return [[x.dot(A.dot(y)) for y in (a, b)] for x in (a, b)]


@pytest.mark.slow
@given(inertia=st.tuples(*[moments] * 3), rotor=THREE, a=numbers, b=numbers, w=nonzero,
       s=st.tuples(*[numbers] * 6), mu=numbers)
@settings(max_examples=10)
def test_definiteness_of_a_general_body(inertia, rotor, a, b, w, s, mu):
    """Energy-Casimir at ω = w k of any gyrostat in any quadratic U(k).

    Definite iff the 2×2 form on δk is (Simo, Lewis & Marsden).
    """
    n = a * a + b * b + 1
    k = [2 * a / n, 2 * b / n, (n - 2) / n]
    I, l = oracle.exact(inertia), oracle.exact(rotor)
    H = np.array([[s[0], s[1], s[2]], [s[1], s[3], s[4]], [s[2], s[4], s[5]]], dtype=object)
    g = (
        w**2 * I * np.array(k, dtype=object)
        + w * l
        + mu * np.array(k, dtype=object)
        - H.dot(np.array(k, dtype=object))
    )
    form = reduced_form(inertia, rotor, k, w, g, H)
    determinant = form[0][0] * form[1][1] - form[0][1] * form[1][0]
    assume(determinant != 0)
    U = gs.general_potential(lambda *d: sum(R(c) * x for c, x in zip(g, d))
                             + sum(R(H[i, j]) * d[i] * d[j] for i in range(3) for j in range(3)) / 2)
    eq = gs.equilibrium(gs.assemble(gs.Gyrostat(inertia, rotor), U),
                        [*map(R, w * I * np.array(k, dtype=object)), *map(R, k)])
    criterion = gs.derivation.formal_criterion(gs.derivation.second_variation(eq, integrals=False))
    assert bool(criterion.alternatives) == (determinant > 0 and form[0][0] > 0)


def test_spherical_bodies_have_no_slice():
    """A free sphere: every point is an equilibrium, the level set of its three integrals is a point."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, 0)))
    report = gs.analyze(gs.principal_rotation(scene, 1))
    assert report.second_variation.matrix.shape == (0, 0)
    assert report.sufficient.alternatives == ((),) == report.necessary.alternatives


@pytest.mark.parametrize("integrals", [True, False])
def test_e1_forms_differ_by_the_integral(scene, integrals):
    """With π3 one multiplier is free, with the Casimirs alone none is.

    The value π3's multiplier 0 gives the same form.
    """
    eq = gs.upright(scene)
    variation = gs.derivation.second_variation(eq, integrals=integrals)
    assert len(variation.free) == integrals
    alone = gs.derivation.second_variation(eq, integrals=False).matrix
    at_zero = variation.matrix.xreplace({nu: -gs.symbol("pi3_0") / gs.symbol("I3") for nu in variation.free})
    assert (at_zero - alone).applyfunc(cancel) == Matrix.zeros(4, 4)
