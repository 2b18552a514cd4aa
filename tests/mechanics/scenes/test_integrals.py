"""Integrals that are given to a scene: read, proved, or refused in one sentence."""
import pytest
from sympy import S, exp, sin

import gyrostat as gs
from gyrostat.errors import ArgumentError, GyrostatError, StructureError
from gyrostat.mechanics.scenes.system import at_numbers

K1, K2, K3, M0 = map(gs.symbol, ("k1", "k2", "k3", "m0"))
BODY = gs.Gyrostat((2, 2, 1), (0, 0, gs.symbol("l")))
KOWALEVSKI = ("(M1^2 - M2^2 - 4*m0*k1)^2 + (2*M1*M2 - 4*m0*k2)^2"
              " + 8*l*(M3 - 2*l)*(M1^2 + M2^2) - 32*l*m0*M1*k3")
UNIFORM = gs.general_potential(M0 * K1)


def test_read_and_proved():
    """M = π + l, moments and rotor of the body inserted; in an expression or in a text, kept at numbers."""
    scene = gs.assemble(BODY, UNIFORM, integrals=(KOWALEVSKI,))
    (F,) = scene.given_integrals
    assert scene.integrals == (F,) and not scene.level_only and not scene.linear_integrals
    assert not scene.space.bracket(F, scene.hamiltonian) and gs.symbol("pi3") in F.free_symbols
    assert gs.assemble(BODY, UNIFORM, integrals=[F]) == scene
    here = at_numbers(scene, {gs.symbol("l"): S(2), M0: S(3)})
    assert here.given_integrals == (F.xreplace({gs.symbol("l"): S(2), M0: S(3)}),)
    moments = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    clebsch = "M1^2 + M2^2 + M3^2 - e*(I2*I3*k1^2 + I3*I1*k2^2 + I1*I2*k3^2)"
    squares = sum(gs.symbol(f"I{n}") * k**2 for n, k in ((1, K1), (2, K2), (3, K3)))
    U = gs.general_potential(gs.symbol("e") * squares / 2)
    for body in (moments, gs.Gyrostat((1, 2, 3), (0, 0, 0))):
        assert len(gs.assemble(body, U, integrals=(clebsch,)).given_integrals) == 1


def test_on_the_sphere_and_beside_what_is_found():
    """On |k| = 1 only, as it is everywhere that a body is; of revolution, π3 is found and stays the first."""
    on_sphere = gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0)), gs.general_potential(K1**2 + K2**2 + K3**2),
                            integrals=("M1^2 + M2^2 + M3^2 + exp(k1)*(k1^2 + k2^2 + k3^2 - 1)",))
    assert not on_sphere.level_only
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    assert scene.given_integrals == () and scene.linear_integrals == scene.integrals == (gs.symbol("pi3"),)


REFUSED = [(("M1^2",), StructureError, "its bracket with the Hamiltonian is -l*pi1*pi2 + pi1*pi2*pi3, not 0"),
           (("pi1*x",), StructureError, "names x, which the scene does not have: write it in pi1, pi2, pi3"),
           (("3*m0",), StructureError, "3*m0 is a constant"), ((2,), StructureError, "2 is a constant"),
           (("(M1*k1 + M2*k2 + M3*k3)^2",), StructureError, "is a function of the Hamiltonian, the Casimirs"),
           (("pi1^2/4 + pi2^2/4 + pi3^2/2 + m0*k1 + 7",), StructureError, "is a function of the Hamiltonian"),
           ((KOWALEVSKI, KOWALEVSKI), StructureError, "and the integrals that are known"),
           (("1e400*M1",), StructureError, "… is not an integral: its bracket"),
           (("(M1 + M2 + M3 + k1 + k2 + k3)^30",), GyrostatError, "the limits are 1000 terms"),
           ("M1^2", ArgumentError, "integrals = 'M1^2' is a str, not several entries"),
           (M0, ArgumentError, "integrals = m0 is a Symbol, not several entries"),
           (("__import__('os')",), GyrostatError, ""), (("M1^",), GyrostatError, "")]


@pytest.mark.parametrize("integrals, kind, words", REFUSED)
def test_refused_in_one_sentence(integrals, kind, words):
    with pytest.raises(kind) as refusal:
        gs.assemble(BODY, UNIFORM, integrals=integrals)
    assert words in str(refusal.value) and "\n" not in str(refusal.value) and len(str(refusal.value)) < 600


def test_refused_of_other_scenes():
    """k without a field, a transcendental field that breaks it, and π3 of a body of revolution."""
    with pytest.raises(StructureError, match="names k1, which the scene does not have"):
        gs.assemble(BODY, integrals=("M1*k1",))
    with pytest.raises(StructureError, match=r"is not an integral.*not 0 where M·k = 0 either"):
        gs.assemble(BODY, gs.general_potential(exp(K1) + sin(K2)), integrals=(KOWALEVSKI.replace("m0", "1"),))
    with pytest.raises(StructureError, match="and the integrals that are known"):
        gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field(), integrals=("M3^2",))


@pytest.mark.slow
def test_monitored_along_a_motion():
    """Motion.invariants and drift; an integral of the level C1 = 0 only on that level."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.general_potential(K1),
                        integrals=("(M1^2 - M2^2 - 4*k1)^2 + (2*M1*M2 - 4*k2)^2",))
    motion = gs.trajectories.motion(scene, (1, "1/2", 2, 0, "3/5", "4/5"))
    assert list(motion.invariants) == ["energy", "C1", "C2", "F1"]
    assert motion.drift([5.0, 10.0])["F1"] < 1e-11
    level = gs.assemble(gs.Gyrostat((4, 4, 1), (0, 0, 0)), gs.general_potential(M0 * K1),
                        integrals=("M3*(M1^2 + M2^2) - 4*m0*M1*k3",))
    assert level.level_only == level.integrals
    on, off = ((1, 2, S(-3) / 2, 0, "3/5", "4/5"), (1, 2, 1, 0, "3/5", "4/5"))
    assert gs.trajectories.motion(level, on, {"m0": 1}).drift([5.0])["F1"] < 1e-11
    assert list(gs.trajectories.motion(level, off, {"m0": 1}).invariants) == ["energy", "C1", "C2"]
