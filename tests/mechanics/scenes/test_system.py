"""Scenes: the vector field against np.cross, its vector form, and the integrals that are found."""
from fractions import Fraction

import numpy as np
import oracle
import pytest
from draw import moments, numbers
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Matrix, Rational, expand

import gyrostat as gs
from gyrostat.errors import StructureError
from gyrostat.mechanics.scenes.system import System

SIX = st.tuples(*[numbers] * 6)
THREE = st.tuples(*[numbers] * 3)


def rational(values):
    return [Rational(Fraction(v).numerator, Fraction(v).denominator) for v in values]


@pytest.mark.slow
@given(x=SIX, inertia=st.tuples(*[moments] * 3), rotor=THREE, g=THREE, s=SIX)
@settings(max_examples=8)
def test_field_is_euler_poisson(x, inertia, rotor, g, s):
    """B ∇h is (π + l) × ω + k × ∇U, k × ω, for U = g·k + ½ k·Sk of a general body, exactly."""
    S = [[s[0], s[1], s[2]], [s[1], s[3], s[4]], [s[2], s[4], s[5]]]
    gradient = np.array(S, dtype=object)
    theirs = oracle.field(oracle.exact(x), oracle.exact(inertia), oracle.exact(rotor),
                          lambda k: oracle.exact(g) + gradient.dot(k))
    U = gs.general_potential(lambda *k: sum(a * b for a, b in zip(rational(g), k))
                             + sum(rational([S[i][j]])[0] * k[i] * k[j] for i in range(3) for j in range(3))
                             / 2)
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), U)
    ours = scene.vector_field().subs(dict(zip(scene.space.coordinates, rational(x))))
    assert list(ours) == rational(theirs)


@pytest.mark.parametrize("potential", [None, gs.axial_potential(), gs.general_potential(),
                                       gs.newtonian_field(2)])
def test_vector_form(potential):
    """π̇ = M × ω + k × ∇U, k̇ = k × ω; without a field π̇ = M × ω."""
    scene = gs.assemble(gs.symmetric_gyrostat() if potential and potential.revolution else gs.Gyrostat(),
                        potential)
    pi = Matrix(scene.space.coordinates[:3])
    omega = Matrix([p / i for p, i in zip(pi, scene.body.inertia)])
    M = pi + Matrix(scene.body.gyrostatic_momentum)
    rows = list(M.cross(omega))
    if potential:
        k = Matrix(scene.space.coordinates[3:])
        torque = k.cross(Matrix([scene.hamiltonian.diff(x) for x in k]))
        rows = [a + b for a, b in zip(rows, torque)] + list(k.cross(omega))
    assert [expand(a - b) for a, b in zip(rows, scene.vector_field())] == [0] * len(rows)


def test_energy_and_casimirs_are_conserved(scene):
    """{h, h} = 0 is trivial, but the field itself conserves h and the Casimirs."""
    field = scene.vector_field()
    for f in (scene.hamiltonian, *scene.space.casimirs, *scene.integrals):
        assert expand((scene.space.gradient(f).T * field)[0].doit()) == 0


@pytest.mark.parametrize(("body", "potential", "count"), [
    (gs.symmetric_gyrostat(), gs.axial_potential(), 1), (gs.symmetric_gyrostat(), None, 1),
    (gs.Gyrostat(), gs.axial_potential(), 0),
    (gs.Gyrostat(), None, 0), (gs.Gyrostat((2, 2, 2), (0, 0, 0)), None, 3), (gs.Gyrostat((2, 2, 2)), None, 1),
    (gs.Gyrostat((1, 2, 2), (3, 0, 0)), gs.general_potential(lambda *k: k[0] ** 4), 1),
    (gs.Gyrostat((2, 2, 2), (0, 0, 0)), gs.general_potential(lambda *k: (k[0] + 2 * k[1] - k[2]) ** 3), 1),
    (gs.Gyrostat((2, 2, 3), (0, 1, 0)), gs.axial_potential(), 0),
    (gs.Gyrostat((2, 2, 3), (0, 0, 1)), gs.general_potential(), 0)])
def test_integrals_are_found(body, potential, count):
    """As many linear integrals as the body and its field have symmetries; each commutes with h."""
    scene = gs.assemble(body, potential)
    assert len(scene.integrals) == count
    assert all(scene.space.bracket(f, scene.hamiltonian) == 0 for f in scene.integrals)


def test_the_integral_follows_the_symmetry():
    """Not π3 by assumption: along the axis of U where the body is a sphere."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, 0)),
                        gs.general_potential(lambda *k: (k[0] + 2 * k[1] - k[2]) ** 3))
    p1, p2, p3 = scene.space.coordinates[:3]
    assert expand(scene.integrals[0] / scene.integrals[0].coeff(p1)) == p1 + 2 * p2 - p3


def test_a_false_integral_does_not_exist(scene):
    """A System checks its integrals."""
    with pytest.raises(StructureError, match="pi1 is not an integral"):
        System(scene.body, scene.space, scene.hamiltonian, (scene.space.coordinates[0],), scene.potential)


def test_no_field_means_three_coordinates(free):
    """The smallest space: so(3)* without a potential."""
    assert len(free.space.coordinates) == 3 and free.potential is None


@pytest.mark.parametrize("rotor", ["sqrt(6)", "1/(3 - sqrt(6))", "6 - (3 - sqrt(6))/2", "cos(1)"])
def test_a_rotor_with_an_irrational_momentum(rotor):
    """l may be any real number: Jacobi holds, and π3 is an integral."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, rotor)), gs.uniform_field())
    assert [str(f) for f in scene.integrals] == ["pi3"] and scene.space.jacobiator(0, 1, 4) == 0


def test_a_rotor_that_is_a_quotient_of_names():
    """l = a/b: Jacobi holds."""
    a, b = gs.symbol("a"), gs.symbol("b")
    assert (
        gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, a / b)), gs.uniform_field()).space.jacobiator(0, 1, 4) == 0
    )
