"""Dual spin with a damper in each body: the energy-sink condition against spectra of two viscous spheres."""
import random
from fractions import Fraction

import pytest
from slow import sampled
from sympy import Rational, pi
from two_spheres import growing_modes

import gyrostat as gs
from gyrostat.derivation import energy_sink_criterion
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.printing.formats.json_data import criterion_data

C_P, C_R, C, OMEGA = map(gs.symbol, ("c_p", "c_r", "C_r", "Omega"))
LIGHT, WEAK = Fraction(1, 10**7), Fraction(1, 10**5)       # moment of a light sphere; c beside that times λ0


def drawn(rnd):
    """A, C and C_r, the rates of the platform and of the rotor relative to it, c_p and c_r."""
    A, whole = (Fraction(rnd.randint(5, 60), 10) for _ in range(2))
    axial = whole * Fraction(rnd.randint(1, 9), 10)
    rate, spin = Fraction(rnd.randint(-20, 20), 7), Fraction(rnd.randint(-60, 60), 7)
    return A, whole, axial, rate, spin, *(Fraction(rnd.randint(1, 99), rnd.randint(1, 9)) for _ in range(2))


def condition(A, whole, axial, rate, spin, c_p, c_r, driven):
    """Whether the energy-sink condition holds at numbers; the rotor held at its rate, or free."""
    numbers = {name: Rational(x.numerator, x.denominator) for name, x in
               {"A": A, "whole": whole, "C": axial, "w": rate, "spin": spin, "p": c_p, "r": c_r}.items()}
    A, whole, axial, rate, spin, c_p, c_r = numbers.values()
    speed = {"rate": spin} if driven else {"momentum": axial * (rate + spin)}
    rotor = gs.Rotor((0, 0, 1), axial, **speed)
    scene = gs.assemble(gs.gyrostat_with_rotors((A, A, whole), [rotor], lumped=True))
    turning = gs.equilibrium(scene, (0, 0, scene.body.moments[2] * rate))
    criterion = energy_sink_criterion(turning, rotor, platform_damping=c_p, rotor_damping=c_r)
    assert criterion.alternatives in ((), ((),))
    return bool(criterion.alternatives)


def falls(A, whole, axial, rate, spin):
    """P (P − A Ω) of the platform and of the rotor."""
    momentum = whole * rate + axial * spin
    return [momentum * (momentum - A * x) for x in (rate, rate + spin)]


@pytest.mark.slow
@pytest.mark.parametrize("cases", [8, pytest.param(2000, marks=pytest.mark.slow)])
def test_weak_dampers_in_both_bodies(cases, full):
    """With light spheres and weak dampers a mode grows where the condition fails, and only there."""
    rnd, seen = random.Random(2), set()
    for _ in range(sampled(cases, full, 200)):
        *numbers, c_p, c_r = drawn(rnd)
        first, second = falls(*numbers)
        if abs(c_p * first + c_r * second) * 100 <= c_p * abs(first) + c_r * abs(second):
            continue                                       # too near to 0 for the terms of second order
        A, whole, axial, rate, spin = numbers
        holds = condition(*numbers, c_p, c_r, rnd.random() < 0.5)
        weak = WEAK * LIGHT * abs(whole * rate + axial * spin) / A
        spheres = [(LIGHT, weak * c) for c in (c_p, c_r)]
        modes = growing_modes((A, A, whole), axial * spin, rate, spin, *spheres)
        assert (modes == 0) == holds, numbers
        seen.add((holds, first > 0, second > 0))
    assert len(seen) > 2


@pytest.mark.parametrize("cases", [8, pytest.param(2000, marks=pytest.mark.slow)])
def test_where_both_terms_have_one_sign_the_dampers_do_not_matter(cases, full):
    """Spheres and dampers of any size."""
    rnd, seen = random.Random(3), set()
    for _ in range(sampled(cases, full, 200)):
        *numbers, c_p, c_r = drawn(rnd)
        first, second = falls(*numbers)
        if first * second <= 0:
            continue
        A, whole, axial, rate, spin = numbers
        spheres = [(min(A, moment) / rnd.randint(3, 50), c * Fraction(10) ** rnd.randint(-4, 3))
                   for moment, c in ((whole - axial, c_p), (axial, c_r))]
        modes = growing_modes((A, A, whole), axial * spin, rate, spin, *spheres)
        assert (modes == 0) == (first > 0) == condition(*numbers, c_p, c_r, True), numbers
        seen.add(first > 0)
    assert seen == {True, False}


def test_damping_of_the_platform_alone_is_the_secular_criterion():
    """And that of the rotor alone is the same with the two exchanged."""
    rotor = gs.Rotor((0, 0, 1), C, rate=OMEGA)
    I1, I3 = gs.symbol("I1"), gs.symbol("I3")
    spin = gs.principal_rotation(gs.assemble(gs.gyrostat_with_rotors((I1, I1, I3), [rotor], lumped=True)), 3)
    platform = energy_sink_criterion(spin, rotor, platform_damping=1, rotor_damping=0)
    ((condition,),) = gs.analyze(spin).damped.alternatives
    assert platform.alternatives[0][0].margin == condition.margin
    # of the rotor as the body, at ω + Ω, and the platform as its rotor: I3 − C_r at −Ω
    exchanged = {gs.symbol("omega3_0"): gs.symbol("omega3_0") + OMEGA, C: I3 - C, OMEGA: -OMEGA}
    of_rotor = energy_sink_criterion(spin, rotor, platform_damping=0, rotor_damping=1).alternatives[0][0]
    assert (of_rotor.margin - condition.margin.subs(exchanged, simultaneous=True)).expand() == 0


@pytest.fixture
def despun():
    """Theory page E12: A = 1000, C_r = 40, the rotor at 60 rpm."""
    rotor = gs.Rotor((0, 0, 1), "40 kg m^2", rate="60 rpm")
    body = gs.gyrostat_with_rotors(["1000 kg m^2", "1000 kg m^2", "200 kg m^2"], [rotor], lumped=True)
    return gs.equilibrium(gs.assemble(body), (0, 0, 0)), rotor


def test_it_prints_as_text_latex_and_json(despun):
    criterion = energy_sink_criterion(*despun, platform_damping=C_P, rotor_damping=C_R)
    assert (str(criterion), gs.to_latex(criterion)) == ("c_p > 24 c_r", "c_{p} > 24 c_{r}")
    data = criterion_data(criterion)
    assert (data["notion"], data["any_of"][0]["all_of"][0]["margin"]) == ("energy sink", "c_p - 24*c_r")
    lost = energy_sink_criterion(*despun, platform_damping=1, rotor_damping=1)
    assert (str(lost), gs.to_latex(lost)) == ("never", r"\text{never}")


def test_what_is_refused(despun):
    turning, rotor = despun
    for given, words in ((("-1", 1), "not negative"), ((0, 0), "not both 0")):
        with pytest.raises(ValuesError, match=words):
            energy_sink_criterion(turning, rotor, platform_damping=given[0], rotor_damping=given[1])
    other = gs.Rotor((0, 0, 1), "40 kg m^2", rate="61 rpm")
    with pytest.raises(ScopeError, match="this one rotor"):
        energy_sink_criterion(turning, other, platform_damping=1, rotor_damping=1)
    three = gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 80 * pi)))
    with pytest.raises(ScopeError, match="transverse moments are 3 and 2|2 and 3"):
        energy_sink_criterion(gs.principal_rotation(three, 3), rotor, platform_damping=1, rotor_damping=1)
