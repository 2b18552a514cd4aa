"""Equilibria are checked when they are built, and the message says which components fail."""
import pytest
from sympy import Rational, S, Symbol, exp, sqrt

import gyrostat as gs
from gyrostat.errors import EquilibriumError
from gyrostat.mechanics.equilibrium.equilibrium import Equilibrium

m0, l, omega, k3, I1, I3 = map(gs.symbol, ("m0", "l", "omega", "k3", "I1", "I3"))


def test_a_false_claim_is_refused_with_its_residual(scene):
    """The components that do not vanish are named and shown."""
    heavy = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    with pytest.raises(EquilibriumError,
                       match=r"E0 is not an equilibrium: dpi2/dt = -m0\. Check the point, or in "
                             r"Python pass the relation"):
        gs.equilibrium(heavy, (0, 0, 0, 1, 0, 0), label="E0")
    with pytest.raises(EquilibriumError, match="dpi1/dt = .*dk1/dt"):
        gs.equilibrium(scene, (0, 1, 2, 0, Rational(3, 5), Rational(4, 5)))
    with pytest.raises(EquilibriumError, match="5 entries, the space has 6"):
        gs.equilibrium(scene, (0, 0, 0, 0, 1))


def test_a_relation_makes_a_claim_true(scene):
    """The E3 of VV2003 is no equilibrium without U'(k3) = ω l − ω² k3 (I1 − I3), and is one with it."""
    k1 = sqrt(1 - k3**2)
    point = (I1 * omega * k1, 0, I3 * omega * k3, k1, 0, k3)
    with pytest.raises(EquilibriumError, match="dpi2/dt"):
        gs.equilibrium(scene, point)
    claimed = gs.equilibrium(scene, point, relations=[(Symbol("dU"), omega * l - omega**2 * k3 * (I1 - I3))])
    assert claimed.point == gs.inclined(scene).point
    with pytest.raises(EquilibriumError, match="dpi2/dt"):
        gs.equilibrium(scene, point, relations=[("dU", omega * l + omega**2 * k3 * (I1 - I3))])


def test_any_rotation_of_the_inclined_point_is_one(scene):
    """The spin symmetry: k = (k1, k2, k3) with k1² + k2² = 1 − k3², not only k2 = 0."""
    k1, k2 = sqrt(1 - k3**2) * Rational(3, 5), sqrt(1 - k3**2) * Rational(-4, 5)
    point = (I1 * omega * k1, I1 * omega * k2, I3 * omega * k3, k1, k2, k3)
    assert gs.equilibrium(scene, point, relations=[("dU", omega * l - omega**2 * k3 * (I1 - I3))])


def test_algebraic_points_are_recognised():
    """A residual that is zero only as an algebraic number is zero."""
    U = gs.axial_potential(k3**2 - sqrt(3) * k3)        # U' = 0 at k3 = √3/2
    scene = gs.assemble(gs.symmetric_gyrostat(), U)
    assert gs.equilibrium(scene, (0, 0, 0, S.Half, 0, sqrt(3) / 2))
    assert gs.equilibrium(scene, (0, 0, 0, "1/2", 0, "sqrt(3)/2"))
    with pytest.raises(EquilibriumError):
        gs.equilibrium(scene, (0, 0, 0, S.Half, 0, sqrt(3) / 2 + Rational(1, 10**60)))


def test_what_exists_is_true(scene):
    """The class itself checks; there is no way to build an Equilibrium that is none."""
    with pytest.raises(EquilibriumError):
        Equilibrium("E", scene, (S.Zero, S.One, S.Zero, S.Zero, S.Zero, S.One))


def test_general_unspecified_field():
    """A claim in U(k1, k2, k3) left unspecified, its gradient a relation: k ∥ ∇U for a body at rest."""
    scene = gs.assemble(gs.Gyrostat(), gs.general_potential())
    with pytest.raises(EquilibriumError, match="dpi1/dt = -dU_2, dpi2/dt = dU_1"):
        gs.equilibrium(scene, (0, 0, 0, 0, 0, 1))
    assert gs.equilibrium(scene, (0, 0, 0, 0, 0, 1), relations=[("dU_1", 0), ("dU_2", 0)])


def test_names_of_the_derivation_are_refused(scene):
    """A point in nu1 would be confused with a multiplier."""
    with pytest.raises(EquilibriumError, match="nu1, the multiplier of C1"):
        gs.equilibrium(scene, (0, 0, gs.symbol("nu1"), 0, 0, 1))


def test_directions_are_unit_vectors():
    """abs(k) = 1, exactly; k = 0 is left to the verbs, which name the singular orbit."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(lambda x, y, z: z))
    for k in ((0, 0, 2), (0, 0, Rational(1, 2)), (0, 0, gs.symbol("c"))):
        with pytest.raises(EquilibriumError, match="k is a direction"):
            gs.equilibrium(scene, (0, 0, 5, *k))


def test_transcendental_fields():
    """exp and its relation cancel exactly."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(exp(2 * k3)))
    assert gs.inclined(scene).relations[-1][0] == l
