"""Lagrangian, momenta and effective potential in Euler's angles beside the bracket on e(3)*."""
from fractions import Fraction

import pytest
from draw import moments, numbers
from hypothesis import given, settings
from oracle import reduced as reduced_motion
from sympy import Derivative, Function, Rational, cos, simplify, sin, symbols, trigsimp

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.mechanics.classical.attitude import (
    ANGLES,
    CONVENTIONS,
    RATES,
    angular_velocity,
    direction,
    reduced,
)
from gyrostat.mechanics.classical.lagrangian import effective_potential, lagrangian, momenta
from gyrostat.notation import symbol

PHI, THETA, PSI = ANGLES
FIELD = gs.axial_potential(lambda k3: symbol("m0") * k3 + k3**3)


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("body", [gs.symmetric_gyrostat(), gs.Gyrostat()])
def test_momenta_are_derivatives_of_the_lagrangian(body, convention):
    """p = ∂L/∂(φ̇, θ̇, ψ̇), rotor included."""
    function = lagrangian(body, None, convention)
    for momentum, angle_rate in zip(momenta(body, convention), RATES):
        assert reduced(momentum - function.diff(angle_rate)) == 0


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_momenta_are_the_casimir_and_the_integral(convention):
    """p_φ is C1 = M·k of e(3)* for any body; p_ψ is M3 = π3 + l, the integral of a body of revolution."""
    for body in (gs.Gyrostat(), gs.symmetric_gyrostat()):
        scene = gs.assemble(body, gs.axial_potential() if body.is_of_revolution() else gs.general_potential())
        pi = [moment * omega for moment, omega in zip(body.inertia, angular_velocity(convention))]
        place = dict(zip(scene.space.coordinates, (*pi, *direction(convention))))
        p_phi, _, p_psi = momenta(body, convention)
        assert reduced(scene.space.casimirs[0].subs(place, simultaneous=True) - p_phi) == 0
        assert reduced(symbol("pi3").subs(place) + body.gyrostatic_momentum[2] - p_psi) == 0
        assert not body.is_of_revolution() or scene.integrals == (symbol("pi3"),)


def test_effective_potential_is_the_energy():
    """½ I1 θ̇² + V(θ) is the Hamiltonian, at the momenta of the motion."""
    body = gs.symmetric_gyrostat()
    scene = gs.assemble(body, FIELD)
    pi = [moment * omega for moment, omega in zip(body.inertia, angular_velocity())]
    energy = scene.hamiltonian.subs(dict(zip(scene.space.coordinates, (*pi, *direction()))),
                                    simultaneous=True)
    p_phi, _, p_psi = momenta(body)
    moving = effective_potential(body, FIELD).subs({symbol("p_phi"): p_phi, symbol("p_psi"): p_psi})
    assert reduced(energy - symbol("I1") * RATES[1] ** 2 / 2 - moving) == 0


@given(I1=moments, I3=moments, l=numbers, p_psi=numbers, v=numbers, e=numbers, m0=numbers)
@settings(max_examples=10)
def test_effective_potential_is_the_reduced_motion(I1, I3, l, p_psi, v, e, m0):
    """2 I1 sin²θ (E − V) is the g(k3) of the reduced motion, here at k3 = 3/5, U = m0 k3."""
    z = Fraction(3, 5)
    g = reduced_motion(I1, l, p_psi - l, v, e, m0 * z, m0, 0, z)[0]
    potential = effective_potential(gs.Gyrostat((I1, I1, I3), (0, 0, l)),
                                    gs.axial_potential(lambda k3: m0 * k3))
    energy = e + (p_psi - l) ** 2 / (2 * I3)
    V = potential.subs({symbol("p_phi"): v,
                        symbol("p_psi"): p_psi}).subs({cos(THETA): Rational(3, 5),
                                                       sin(THETA): Rational(4, 5)})
    assert 2 * Rational(I1) * Rational(16, 25) * (Rational(energy) - V) == Rational(g)


def test_lagrange_equations_are_euler_poisson():
    """Lagrange's equation of θ for a heavy gyrostat of revolution is what π̇ = M × ω + k × ∇U gives at ψ = 0.
    """
    body, t = gs.symmetric_gyrostat(), symbols("t")
    moving = [Function(str(a))(t) for a in ANGLES]
    at = {**dict(zip(RATES, [f.diff(t) for f in moving])), **dict(zip(ANGLES, moving))}
    L = lagrangian(body, FIELD)
    lagrange = (L.diff(RATES[1]).subs(at).diff(t) - L.diff(THETA).subs(at)).doit()
    acceleration = Derivative(moving[1], (t, 2))
    # π1 = I1 ω1, ω1 = φ̇ sin θ sin ψ + θ̇ cos ψ
    pi1_dot = gs.assemble(body, FIELD).vector_field()[0]
    place = dict(zip(map(symbol, ("pi1", "pi2", "pi3", "k1", "k2", "k3")), (*(
        moment * omega for moment, omega in zip(body.inertia, angular_velocity())), *direction())))
    along = pi1_dot.subs(place, simultaneous=True).subs(PSI, 0)
    second = (symbol("I1") * angular_velocity()[0]).subs(at).diff(t).doit()
    second = second.subs({acceleration: symbol("a"),
                          Derivative(moving[0],
                                     (t, 2)): 0}).subs({f.diff(t): r for f, r in zip(moving, RATES)})
    second = second.subs(dict(zip(moving, ANGLES))).subs(PSI, 0)
    solved = (
        lagrange.subs(acceleration, symbol("a"))
        .subs({f.diff(t): r for f, r in zip(moving, RATES)})
        .subs(dict(zip(moving, ANGLES)))
    )
    assert trigsimp(simplify(second - along - solved)) == 0


def test_errors():
    """A θ that does not move by itself is refused with the reason."""
    with pytest.raises(ScopeError, match="of revolution"):
        effective_potential(gs.Gyrostat(), FIELD)
