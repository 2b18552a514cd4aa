"""Bifurcations of free gyrostats as equations: they hold where rotations meet, and there alone."""
import random
from fractions import Fraction as F

import pytest
from equilibria.degenerate_rotations import drawn, exact
from slow import sampled
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign

VALUES = {"I1": 1, "I2": 2, "I3": "5/2", "M": "3/2"}


def scene_of(zeros):
    rotor = [0 if n in zeros else gs.symbol(f"l{n}") for n in (1, 2, 3)]
    return gs.assemble(gs.Gyrostat(gyrostatic_momentum=rotor))


@pytest.mark.few(2)
@pytest.mark.parametrize("zeros", [(1, 2), (2, 3), (1, 3), (1,), (2,), (3,)])
def test_they_hold_at_the_points_that_are_found(zeros):
    """Of each kind at the points of that kind and ν, exactly; found by another route, double points of ν."""
    scene, (first, *others) = scene_of(zeros), [n for n in (1, 2, 3) if n not in zeros]
    values = VALUES | {f"l{n}": "1/7" for n in others}
    points = gs.bifurcation_points(scene, f"l{first}", values)
    kinds = gs.bifurcations(scene)
    assert {p.kind for p in points} == {b.kind for b in kinds} and len(kinds) == 2
    for point in points:
        at = {gs.symbol(n): Rational(x) for n, x in values.items()} | {gs.symbol(point.name): point.value}
        holds = [b for b in kinds if b.kind == point.kind and all(sign(e, at) == 0 for e in b.equations)]
        assert holds and (point.kind == "fold" or [b.at.xreplace(at) for b in holds] == [point.nu])


@pytest.mark.parametrize("cases", [8, pytest.param(500, marks=pytest.mark.slow)])
def test_a_rotation_that_was_drawn_degenerate(cases, full):
    """The parametrised fold at its M and ν; a plane's own equation at a pitchfork."""
    rnd = random.Random(f"loci {cases}")
    for _ in range(sampled(cases, full, 100)):
        for kind in ("fold", "pitchfork"):
            moments, rotor, M, size = drawn(rnd, kind)
            (b,) = [b for b in gs.bifurcations(gs.assemble(gs.Gyrostat(exact(moments), exact(rotor))))
                    if b.kind == kind]
            n = next(n for n in range(3) if M[n])
            nu = (1 - F(rotor[n]) / M[n]) / moments[n]
            names = dict(zip(("M1", "M2", "M3", "M", "nu"), exact([*M, size, nu])))
            at = {gs.symbol(name): x for name, x in names.items()}
            assert [e.xreplace(at).expand() for e in b.equations] == [0] * len(b.equations)


def test_bodies_of_revolution():
    """l along the axis: the circle leaves it at abs(l)/M = abs(1 − I3/I1).

    With l = 0, and with three equal moments, nothing meets.
    """
    (b,) = gs.bifurcations(gs.assemble(gs.symmetric_gyrostat()))
    I1, I3, l, M = map(gs.symbol, ("I1", "I3", "l", "M"))
    assert b.kind == "circle leaves an axis" and b.at == 1 / I1
    assert (b.equations[0] - (I1**2 * l**2 - (I1 - I3)**2 * M**2)).expand() == 0
    assert gs.bifurcations(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))) == ()
    assert gs.bifurcations(gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, gs.symbol("l"))))) == ()


def test_they_are_printed():
    """The threshold of a rotor along an axis, with what happens there."""
    text = str(gs.bifurcations(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l")))))[0])
    assert text.startswith("pitchfork (two permanent rotations on either side of a principal plane meet one")
    assert "l²" in text and "M²" in text
