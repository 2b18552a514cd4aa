"""The arcs of a body whose tensor is given in any axes: those in principal axes, turned."""
import random
from fractions import Fraction

import heavy
import numpy as np
import pytest
from heavy_scenes import k1, k2, k3
from sympy import Matrix, Poly, Rational, diag, fraction, oo, together

import gyrostat as gs
from gyrostat.errors import ScopeError

TURN = Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
SLANTED = [["62.1", "1.3", "-0.8"], ["1.3", "58", "0.2"], ["-0.8", "0.2", "30"]]     # irrational moments
KINDS = {"cone": ((1, 2, 3), (1, 1, 1), (0, 0, 0)), "c across an axis": ((1, 2, 3), (1, 0, 1), (0, 0, 0)),
         "rotor": ((1, 2, 3), (1, 1, 1), (0, Rational(1, 2), 1)),
         "rotor across an axis": ((1, 2, 3), (0, 2, 1), (0, Rational(1, 2), 1)),
         "c and l on one axis": ((1, 2, Rational(13, 5)), (0, 0, 3), (0, 0, Rational(3, 2))),
         "two moments": ((2, 2, 3), (1, 1, 2), (1, 0, Rational(1, 2))),
         "a circle at one rate": ((1, 2, 1), (2, 1, 4), (1, 1, 2))}
DEFAULT = "cone", "c across an axis", "rotor across an axis"


def arcs_of(tensor, c, rotor):
    U = gs.general_potential(c[0] * k1 + c[1] * k2 + c[2] * k3)
    return gs.staude_cone(gs.assemble(gs.Gyrostat(tensor, rotor), U)).arcs({})


def turned(vector):
    return list(TURN.T * Matrix(vector))


def both(inertia, c, rotor):
    """The arcs in principal axes, and in others."""
    tensor = (TURN.T * diag(*inertia) * TURN).tolist()
    return arcs_of(inertia, c, rotor), arcs_of(tensor, turned(c), turned(rotor))


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", [*DEFAULT, *(pytest.param(kind, marks=pytest.mark.slow)
                                              for kind in KINDS if kind not in DEFAULT)])
def test_a_turned_body_has_the_same_arcs(kind):
    """Between the same values, to the turned directions; a component of k may be counted the other way."""
    found = [], []
    for one, other in zip(*both(*KINDS[kind]), strict=True):
        assert (one.low, one.high) == (other.low, other.high)
        assert [end.omega for end in one.ends] == [end.omega for end in other.ends]
        ends = [[[float(x) for x in turned(end.k)] for end in one.ends],
                [[float(x.evalf(20)) for x in end.k] for end in other.ends]]
        if one.parameter == gs.symbol("tau") or getattr(one.curve, "moment", 1) is None:
            assert np.abs(np.subtract(*ends)).max() < 1e-12
        for several, two in zip(found, ends):
            several += [[round(x, 9) + 0.0 for x in k] for k in two]
    assert sorted(found[0]) == sorted(found[1])


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_turned_body_has_the_same_verdicts(kind):
    for one, other in zip(*both(*KINDS[kind]), strict=True):
        assert [(p.low, p.high, p.decision.verdict, p.decision.rung) for p in one.pieces] == [
            (p.low, p.high, p.decision.verdict, p.decision.rung) for p in other.pieces]
        assert [circle.rates for circle in one.circles] == [circle.rates for circle in other.circles]


def check(arcs, c, rotor, omegas):
    """Newton's method finds, in the axes of the tensor, what the arcs have, no more, and their verdicts."""
    found, c, rotor = 0, [Fraction(x) for x in c], [Fraction(x) for x in rotor]
    tensor = np.array(SLANTED, float)
    for omega in omegas:
        data = tensor, np.array(rotor, float), np.array(c, float), np.zeros((3, 3)), float(omega)
        here = []
        for arc in arcs:
            values = at_rate(arc, omega) if arc.both_ways else [omega]
            here += [(arc.near(Fraction(x)).k, next(p.decision for p in arc.pieces if p.low < x < p.high))
                     for x in values if arc.low < x < arc.high]
        known = heavy.directions(*data, starts=60)
        assert len(known) == len(here)
        for k in known:
            apart = [np.abs(k - np.array(place)).max() for place, _ in here]
            assert min(apart) < 1e-6
            _, decision = here[np.argmin(apart)]
            theirs = heavy.verdict(*data, k)                # UNDECIDED: normal forms may decide it
            assert theirs is None or decision.unstable == (theirs == "UNSTABLE")
            assert theirs != "STABLE" or decision.stable
            found += 1
    return found


def at_rate(arc, omega):
    """The values of tau at which the rate is omega, by its square, from the roots of a polynomial."""
    n = Matrix(arc.curve.n)
    top, _ = fraction(together(n.dot(n) - Rational(omega) ** 4))
    roots = Poly(top, arc.parameter).nroots(n=30, maxsteps=200)
    return [Rational(str(x)) for x in roots if x.is_real]


@pytest.mark.slow
def test_irrational_moments():
    """The axes are roots of a cubic, and so are the rates at which branches of a gyrostat cross."""
    rng = random.Random("slanted")
    for c, rotor in (((1, 0, 2), (0, 0, 0)), ((1, 0, 2), (0, "0.5", 1))):
        arcs = arcs_of(SLANTED, c, rotor)
        assert check(arcs, c, rotor, [Rational(rng.randint(1, 400), 499) for _ in range(3)]) >= 6
        axes = np.linalg.eigh(np.array(SLANTED, float))[1].T
        for end in (end for arc in arcs for end in arc.ends if end.omega in (oo, -oo)):
            k = np.array([x.evalf(20) for x in end.k], float)
            assert np.abs(axes @ k).max() == pytest.approx(1, abs=1e-12)


def test_both_along_an_axis_between_irrational_moments():
    tensor = [[2, 0, 1], [0, 5, 0], [1, 0, 4]]
    assert len(arcs_of(tensor, (0, 2, 0), (0, 0, 0))) == 4
    with pytest.raises(ScopeError, match="both are along one principal axis"):
        arcs_of(tensor, (0, 2, 0), (0, 1, 0))
