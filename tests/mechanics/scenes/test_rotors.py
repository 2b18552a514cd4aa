"""Bodies with rotors, from their data sheets."""
import random

import pytest
from sympy import Matrix, Rational, diag, eye, pi, sqrt

import gyrostat as gs
from gyrostat.errors import ArgumentError, BodyError, ExpressionError, ValuesError


def kinetic(tensor, rotors, omega, rates):
    """Energy and momentum of a hub and rotors that turn, by their definition."""
    energy = (omega.T * tensor * omega)[0] / 2
    momentum = tensor * omega
    for (a, axial, transverse), rate in zip(rotors, rates):
        a = Matrix(a) / sqrt(sum(x**2 for x in a))
        own = transverse * (eye(3) - a * a.T) + axial * a * a.T
        spin = omega + rate * a
        energy += (spin.T * own * spin)[0] / 2
        momentum += own * spin
    return energy, momentum


AXES = [(1, 2, 2), (0, 3, 4), (0, 0, 1), (-2, 1, 2)]


def drawn(seed):
    draw = random.Random(seed)
    rotors = [(draw.choice(AXES), Rational(draw.randint(1, 9), 10), Rational(draw.randint(5, 9), 10))
              for _ in range(2)]
    rates = [draw.randint(-9, 9) for _ in rotors]
    return rotors, rates, diag(20, 30, 40), Matrix([draw.randint(-3, 3) for _ in range(3)])


@pytest.mark.parametrize("seed", range(4))
def test_the_momentum_of_hub_and_driven_rotors(seed):
    """M = I ω + l, the tensor of the hub given, or that of all."""
    rotors, rates, hub, omega = drawn(seed)
    _, momentum = kinetic(hub, rotors, omega, rates)
    sheets = [gs.Rotor(*rotor, rate=rate) for rotor, rate in zip(rotors, rates)]
    body = gs.gyrostat_with_rotors(hub.tolist(), sheets, lumped=False)
    assert body.tensor * omega + Matrix(body.gyrostatic_momentum) == momentum
    assert gs.gyrostat_with_rotors(body.tensor, sheets, lumped=True) == body


@pytest.mark.parametrize("seed", range(4))
def test_the_momentum_and_the_energy_of_free_rotors(seed):
    """The same M; and π·I⁻¹π/2 is the energy but for the constant h²/2J of the rotors."""
    rotors, rates, hub, omega = drawn(seed)
    energy, momentum = kinetic(hub, rotors, omega, rates)
    spins = [axial * ((Matrix(a).T * omega)[0] / sqrt(sum(x**2 for x in a)) + rate)
             for (a, axial, _), rate in zip(rotors, rates)]
    body = gs.gyrostat_with_rotors(hub.tolist(), [gs.Rotor(a, axial, transverse, momentum=h)
                                                  for (a, axial, transverse), h in zip(rotors, spins)],
                                   lumped=False)
    l = Matrix(body.gyrostatic_momentum)
    assert body.tensor * omega + l == momentum
    left = energy - body.kinetic_energy(list(momentum - l))
    assert left == sum(h**2 / (2 * axial) for (_, axial, _), h in zip(rotors, spins))


def test_a_data_sheet():
    """Units, any axis, several rotors; π where there are rpm."""
    wheel = gs.Rotor((1, 1, 0), axial="50 g m^2", rate="600 rpm")
    body = gs.gyrostat_with_rotors(("120 kg m^2", "110 kg m^2", "80 kg m^2"),
                                   [wheel, gs.Rotor((0, 0, 2), "0.1 kg m^2", momentum="2 N m s")],
                                   lumped=True)
    assert body.moments == (120, 110, Rational(799, 10))
    assert body.gyrostatic_momentum == (sqrt(2) * pi / 2, sqrt(2) * pi / 2, 2)
    assert gs.Rotor((0, 1, 0), 3).gyrostatic_momentum == (0, 0, 0)


REFUSED = [
    (lambda: gs.Rotor((0, 0, 0), 1), BodyError, "is not a direction"),
    (lambda: gs.Rotor((0, 1), 1), BodyError, "three numbers"), (lambda: gs.Rotor("z", 1), BodyError, "three"),
    (lambda: gs.Rotor((0, 0, 1), -1), BodyError, "negative"),
    (lambda: gs.Rotor((0, 0, 1), 1, rate=1, momentum=1), BodyError, "both given"),
    (lambda: gs.Rotor((0, 0, 1), "1 kg m^2", rate=3), ValuesError, "rate = 3 has none"),
    (lambda: gs.Rotor((0, 0, 1), "1 rpm"), ValuesError, "axial is one of kg m"),
    (lambda: gs.Rotor((0, 0, 1), "1 furlong"), ExpressionError, "no unit"),
    (lambda: gs.gyrostat_with_rotors((1, 1, 1), [gs.Rotor((0, 0, 1), 2)], lumped=True), BodyError,
     "more inertia"),
    (lambda: gs.gyrostat_with_rotors((1, 1, 1), [gs.Rotor((0, 0, 1), 2)], lumped=False), BodyError,
     "rotor 1 has no transverse"),
    (lambda: gs.gyrostat_with_rotors((1, 1, 1), [(0, 0, 1)], lumped=True), ArgumentError, "Rotor")]


@pytest.mark.parametrize(("make", "error", "why"), REFUSED)
def test_what_is_no_rotor_says_why(make, error, why):
    """And what to give."""
    with pytest.raises(error, match=why):
        make()
