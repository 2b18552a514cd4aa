"""Which scenes are bodies of revolution, and about which axis: proved, and refused where it is not so."""
import random
from fractions import Fraction as F

import pytest
from slow import sampled
from sympy import ImmutableMatrix, Rational, S, cos, exp, log, sin, sqrt, symbols
from turns import OBLIQUE, TURNS, K, scene

import gyrostat as gs
from gyrostat.mechanics.equilibrium.recognition import recognise, turned_up
from gyrostat.mechanics.scenes.functions_on_sphere import along_third

k1, k2, k3 = K
a, b = symbols("a b", real=True)
SQUARE = k1**2 + k2**2 + k3**2


def entered(U, inertia=(2, 2, 2), rotor=(0, 0, 0)):
    return recognise(gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U)))


@pytest.mark.slow
@pytest.mark.parametrize("name", TURNS)
def test_a_body_of_revolution_is_recognised_about_every_axis(name):
    """The axis, the moments, the rotor and U' with U'(k3) = f(k3), spelled with abs(k)² = 1 besides."""
    found = recognise(scene(name, 2, 2 if name in OBLIQUE else 5, F(2, 5), (1, F(-1, 3), 0, 2),
                            (1, -2, F(1, 2))))
    standard = found.standard
    assert name in found.sentence
    assert (found.rotation * ImmutableMatrix(found.axis)).expand() == ImmutableMatrix([0, 0, 1])
    assert (found.rotation * found.rotation.T).expand() == ImmutableMatrix.eye(3)
    assert found.rotation.det().expand() == 1
    assert standard.body.inertia == ((2, 2, 2) if name in OBLIQUE else (2, 2, 5))
    assert standard.body.gyrostatic_momentum == (0, 0, Rational(2, 5))
    assert (standard.potential.expression - (k3 - k3**2 / 3 + 2 * k3**4)).expand() == 0


@pytest.mark.few(1)
@pytest.mark.parametrize(("U", "inertia", "expected"), [
    (exp(k1 - k2**2 - k3**2), (3, 1, 1), exp(k3 + k3**2 - 1)), (1 / (k2 + 2), (1, 3, 1), 1 / (k3 + 2)),
    (a * (k1**2 + k2**2) + b * k3, (1, 1, 3), a * (1 - k3**2) + b * k3),
    (sin(k1 * a) ** 2 + cos(k1 * a) ** 2 + k1, (2, 1, 1), k3 + 1),
    ((k1 + k2 * k1) / (1 + k2) - k2**2, (3, 1, 1), None), ((k3 - k3**3) / (k1**2 + k2**2), (1, 1, 3), k3),
    (7 + 0 * k1, (2, 1, 1), S(7)),
    (log(2 + k1 / 3 + 2 * k2 / 3 + 2 * k3 / 3), (2, 2, 2), log(k3 + 2)),
    (exp(a * (k1 + k2 + k3)), (2, 2, 2), exp(sqrt(3) * a * k3)),
    (k1 * sqrt(2) + k2, (2, 2, 2), sqrt(3) * k3), ((k1 - k2) ** 7, (2, 2, 2), 8 * sqrt(2) * k3**7),
    (sqrt(k2**2 + k3**2), (3, 1, 1), sqrt(1 - k3**2)),
    (k1**2 * k2**2 + k2**4 + k2**2 * k3**2, (2, 2, 2), k3**2),
    (-k2 + k1**4 + k1**2 * (k2**2 + k3**2 - 1), (2, 2, 2), -k3)])
def test_fields_in_other_spellings(U, inertia, expected):
    """Exponentials, quotients, roots, parameters, algebraic axes.

    A function of the height alone on the sphere is found to be one.
    """
    found = entered(U, inertia)
    assert (
        found is None
        if expected is None
        else (found.standard.potential.expression - expected).simplify() == 0
    )


@pytest.mark.few(1)
@pytest.mark.parametrize(("U", "inertia", "rotor"), [
    (k1, (1, 1, 3), (0, 0, 0)), (k1**2, (1, 1, 3), (0, 0, 0)), (k3, (1, 1, 3), (0, Rational(1, 10**9), 0)),
    (k3, (1, 2, 3), (0, 0, 0)),
    (k1 + k2 + k3 + Rational(1, 10**9) * k1**2, (2, 2, 2), (0, 0, 0)),
    (k1 + k2 + k3, (2, 2, 2), (1, 1, Rational(1001, 1000))),
    (k1 + k2 + k3, (2, 2, 2 + Rational(1, 10**20)), (0, 0, 0)), (k1 + k2**2, (2, 2, 2), (0, 0, 0)),
    (k1 * k2 * k3, (2, 2, 2), (0, 0, 0)),
    (k1**2 + 2 * k2**2 + 3 * k3**2, (2, 2, 2), (0, 0, 0)), (a * k1 + b * k2, (2, 2, 2), (0, 0, 0)),
    (k3 + a * k1 * k2, (1, 1, 3), (0, 0, 0)), (exp(k3) * cos(k1), (1, 1, 3), (0, 0, 0)),
    (k3 + (SQUARE - 2) * k1, (1, 1, 3), (0, 0, 0)),
    (sqrt(1 - k1**2 - k2**2), (1, 1, 3), (0, 0, 0)),
    (k1, (gs.symbol("I1"), gs.symbol("I2"), gs.symbol("I3")), (0, 0, 0))])
def test_what_is_not_of_revolution_is_not_recognised(U, inertia, rotor):
    """Nearly equal moments, a rotor or a field a little off the axis, and abs(k3), which is not smooth.

    Refused.
    """
    assert entered(U, inertia, rotor) is None


@pytest.mark.parametrize("name", ["(1, 2, 2)", "(3, 4, 0)"])
def test_the_sphere_on_which_k_lies_counts(name):
    """On abs(k)² = 2 the field U + (abs(k)² − 1) a·k is not one along the axis, but U + (abs(k)² − 2) a·k is.
    """
    height = (TURNS[name] * ImmutableMatrix(K))[2]
    for square in (1, 2):
        U = height**3 + (SQUARE - square) * (k1 - k2)
        assert (along_third(U, turned_up(recognise(scene(name, 1, 1, 0, (1,))).axis), S(2)) is None) == (
            square == 1
        )


def test_names_of_the_moments_stay_those_of_the_scene():
    """U = I1 k1 of a body (I1, I2, I2): in the standard scene (I2, I2, I1) it is I1 k3, not I2 k3."""
    I1, I2 = gs.symbol("I1"), gs.symbol("I2")
    found = entered(I1 * k1, (I1, I2, I2), (gs.symbol("l1"), 0, 0))
    assert found.standard.body.inertia == (I2, I2, I1) and found.standard.potential.expression == I1 * k3
    assert found.standard.hamiltonian.has(I1 * k3)


@pytest.mark.slow
def test_random_fields_are_recognised_where_they_are_of_revolution(full):
    """300 random polynomials of degree up to 7 about six axes, a third of them without --full, spelled with
    abs(k)² = 1.

    A generic term more, and none is recognised.
    """
    draw = random.Random(20261122)
    for n in range(sampled(300, full, 100)):
        name = draw.choice(list(TURNS))
        c = [F(draw.randint(-9, 9), draw.randint(1, 5)) for _ in range(draw.randint(1, 7))]
        c[-1] = c[-1] or F(1)
        other = [F(draw.randint(-3, 3)) for _ in range(3)]
        this = scene(name, 2, 2 if name in OBLIQUE else 3, draw.randint(-1, 1), c, other)
        assert name in recognise(this).sentence or name == "axis 3" and not any(other)
        more = gs.general_potential(this.potential.expression + Rational(1, draw.randint(1, 10**6)) * k1 * k2
                                    * k3**draw.randint(0, 2))
        assert recognise(gs.assemble(this.body, more)) is None, (n, name, c)


def test_a_sphere_with_roots_in_its_numbers_keeps_its_condition():
    """Along (1, 1, 1) the momentum is √3 p.

    The second variation is definite, no boundary is reached, and the slope is that.
    """
    p, m0, c = gs.symbol("p0"), gs.symbol("m0"), 1 / sqrt(3)
    sphere = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.general_potential(m0 * exp(k1 + k2 + k3)))
    report = gs.analyze(gs.equilibrium(sphere, (p, p, p, c, c, c)))
    decision = report.verdict({"p0": 5, "m0": 1})
    assert report.sufficient.alternatives[0][0].margin == report.necessary.alternatives[0][0].margin
    assert decision.verdict.name == "STABLE" and "definite" in decision.reason
