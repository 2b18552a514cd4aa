"""The arcs of the permanent rotations of a gyrostat, against Newton's method, spectra and signatures."""
import random
from fractions import Fraction
from itertools import pairwise

import heavy
import numpy as np
import pytest
from heavy_scenes import by_criteria, floats, k1, k2, k3, scene_of
from slow import sampled
from sympy import Rational, oo, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

NOTHING = [[Fraction(0)] * 3] * 3
GENERAL = [Fraction(11, 10), Fraction(2), Fraction(13, 5)], [1, -2, 3], [Fraction(1, 2), 1, Fraction(-3, 2)]
SPECIAL = {"c on an axis": ((1, 2, 3), (0, 0, 2), (1, Fraction(1, 2), -1)),
           "l on an axis": ((1, 2, 3), (1, 2, 1), (0, 0, 1)),
           "one l is 0": ((1, 2, 3), (1, 1, 1), (0, Fraction(1, 2), 1)),
           "l along c": ((3, 5, 4), (1, -2, 2), (Fraction(1, 2), -1, 1)),
           "on one axis": ((1, 2, Fraction(13, 5)), (0, 0, 3), (0, 0, Fraction(3, 2))),
           "in a plane": ((3, 5, 4), (1, 0, 3), (Fraction(2, 3), 0, -1)),
           "in a plane, a component 0": ((1, 2, 3), (0, 2, 2), (0, 0, 1)),
           "two moments": ((2, 2, 3), (1, 1, 2), (1, 0, Fraction(1, 2))),
           "two moments, in a plane": ((2, 2, 3), (0, 1, 1), (0, 1, 0)),
           "three moments": ((2, 2, 2), (1, 1, 3), (1, 0, Fraction(3, 2))),
           "a circle at one rate": ((1, 2, 1), (2, 1, 4), (1, 1, 2)),
           "no circle at that rate": ((1, 1, 2), (1, 1, 3), (1, 1, 1)),
           "a circle beside crossings": ((1, 1, 2), (2, 4, 1), (1, 2, Fraction(1, 2))),
           "two folds at one rate": ((1, 2, 3), (1, 1, 1), (Fraction(1, 2), 1, Fraction(1, 2)))}


def arcs_of(inertia, c, rotor):
    return gs.staude_cone(scene_of(inertia, rotor, c, NOTHING)).arcs({})


def drawn(rng):
    inertia = [Fraction(rng.randint(4, 30), 10) for _ in range(3)]
    c = [Fraction(rng.randint(-12, 12), rng.randint(1, 6)) for _ in range(3)]
    return inertia, c, [Fraction(rng.randint(-9, 9) or 4, 8) for _ in range(3)]


def check(rng, arcs, inertia, c, rotor, rates=3):
    """Each rotation that Newton's method finds is on one arc, in a piece of its verdict; nothing else is."""
    found = 0
    for _ in range(rates):
        omega = Rational(rng.randint(-4000, 4000), 1009)
        data = floats(inertia, rotor, c, NOTHING, omega)
        here = [(arc, np.array(arc.rotation(omega).directions[0], float))
                for arc in arcs if arc.low < omega < arc.high]
        for _, k in here:
            assert abs(k @ k - 1) < 1e-9
            assert np.abs(np.cross(omega**2 * data[0] @ k + omega * data[1] - data[2], k)).max() < 1e-9
        for k in heavy.directions(*data, starts=60):
            near = [arc for arc, place in here if np.abs(k - place).max() < 1e-6]
            assert len(near) == 1, (inertia, c, rotor, omega, k)
            decision = next(p for p in near[0].pieces if p.low < omega < p.high).decision
            assert heavy.verdict(*data, k) in (None, by_criteria(decision)), (inertia, c, rotor, omega, k)
            found += 1
        scene = scene_of(inertia, rotor, c, NOTHING)
        assert len(here) == len(gs.relative_equilibria(scene, {"omega": omega}))
    return found


@pytest.fixture(scope="module")
def arcs():
    return arcs_of(*GENERAL)


@pytest.mark.slow
def test_a_general_gyrostat(arcs):
    assert check(random.Random("arcs"), arcs, *GENERAL, rates=6) > 12
    assert sum(arc.low == -oo for arc in arcs) == sum(arc.high == oo for arc in arcs) == 6


@pytest.mark.slow
@pytest.mark.parametrize("kind", SPECIAL)
def test_special_gyrostats(kind):
    assert check(random.Random(kind), arcs_of(*SPECIAL[kind]), *SPECIAL[kind]) >= 6


@pytest.mark.slow
def test_a_fold_at_a_great_rate():
    """At 19.54, sigma = −475.29, of roots from −1286 to −448."""
    c = [6, Fraction(11, 5), Fraction(1, 3)]
    body = (3, Fraction(7, 5), Fraction(6, 5)), c, [-Fraction(8, 7) * x for x in c]
    found = arcs_of(*body)
    assert [f"{float(arc.low):.4f}" for arc in found].count("19.5450") == 2
    assert check(random.Random("fold"), found, *body, rates=2) >= 4


@pytest.mark.slow
def test_many(full):
    rng, count = random.Random("many arcs"), sampled(120, full, 8)
    cases = [drawn(rng) for _ in range(count)]
    assert sum(check(rng, arcs_of(*case), *case) for case in cases) >= 6 * count


@pytest.mark.slow
def test_ends_are_folds_and_axes(arcs):
    """At a fold k is that of two arcs, and a direction turns there about no rotation of its rate."""
    inertia, c, rotor = GENERAL
    ends = [end for arc in arcs for end in arc.ends]
    folds = [end for end in ends if end.omega not in (oo, -oo)]
    assert folds and all(sum(other == end for other in folds) == 2 for end in folds)
    for end in folds:
        omega, k = float(end.omega), np.array([x.evalf(20) for x in end.k], float)
        I, l, g = np.diag(np.array(inertia, float)), np.array(rotor, float), np.array(c, float)
        sigma = k @ (g - omega * l - omega**2 * I @ k)
        across = np.linalg.svd(k[None])[2][1:]
        form = across @ (omega**2 * I + sigma * np.eye(3)) @ across.T
        assert abs(np.linalg.det(form)) < 1e-9 * np.abs(form).max() ** 2
        assert np.abs(np.cross(omega**2 * I @ k + omega * l - g, k)).max() < 1e-9


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", ["on one axis", "two moments", "three moments", "in a plane"])
def test_what_the_arcs_go_to(kind):
    for arc in arcs_of(*SPECIAL[kind]):
        for end, beside in zip(arc.ends, (-1, 1)):
            if end.omega in (oo, -oo):
                k, *_ = arc.near(Fraction(beside * 10**7))
                assert np.abs(np.array(k) - np.array(end.k, float)).max() < 1e-5
            else:
                k, *_ = arc.near(Fraction(float(end.omega)) - beside * Fraction(1, 10**12))
                assert np.abs(np.array(k) - [float(x) for x in end.k]).max() < 1e-4


@pytest.mark.slow
def test_the_verdict_changes_at_the_boundaries(arcs):
    """On either side of each, in doubles."""
    inertia, c, rotor = GENERAL
    changes = 0
    for arc in arcs:
        for before, after in zip(arc.pieces, arc.pieces[1:]):
            for piece, side in ((before, -1), (after, 1)):
                omega = Fraction(float(after.low)) + side * Fraction(1, 2000)
                if piece.low < Rational(omega) < piece.high:
                    data = floats(inertia, rotor, c, NOTHING, omega)
                    found = heavy.verdict(*data, np.array(arc.near(omega)[0]))
                    if found == "UNDECIDED":               # held by gyroscopic forces
                        assert piece.decision.stable and piece.decision.rung is gs.Rung.TWIST
                    else:
                        assert found in (None, piece.decision.verdict.name)
                    changes += found is not None
    assert changes >= 8


def held(arcs):
    """The pieces in windows, in order, each with its arc."""
    return [(arc, piece) for arc in arcs for piece in arc.pieces if piece.decision.rung is gs.Rung.TWIST]


@pytest.mark.slow
def test_windows_are_decided_between_resonances():
    """Where two pieces of a window meet, the frequencies are as 1 to 2 or 3; inside a piece never."""
    inertia, c, rotor = (1, 2, 3), (0, 0, 1), (0, 0, Fraction(1, 2))
    arcs = arcs_of(inertia, c, rotor)
    found = held(arcs)
    assert not any(piece.decision.verdict == "UNDECIDED" for arc in arcs for piece in arc.pieces)

    def ratio(arc, omega):
        return heavy.ratio(*floats(inertia, rotor, c, NOTHING, omega), np.array(arc.near(omega).k))

    for arc, piece in found:
        low, high = (Fraction(float(x)) if x not in (oo, -oo) else x for x in (piece.low, piece.high))
        low, high = max(low, -9), min(high, 9)
        ratios = [ratio(arc, low + (high - low) * Fraction(n, 100)) for n in range(2, 99)]
        assert all((ratios[0] - m) * (x - m) > 0 for x in ratios for m in (2, 3))
    meet = [(arc, one.high) for (arc, one), (other, two) in pairwise(found)
            if arc is other and one.high == two.low]
    assert len(meet) >= 4
    for arc, omega in meet:
        assert min(abs(ratio(arc, Fraction(float(omega))) - m) for m in (2, 3)) < 1e-9


@pytest.mark.slow
def test_what_is_said_of_a_window_holds_of_its_rotations(arcs):
    """By the ladder at single rates, each of one equilibrium, with D4 ≠ 0 and the notion of the piece."""
    rng, asked = random.Random("windows"), 0
    for arc, piece in held(arcs):
        low, high = max(float(piece.low), -50), min(float(piece.high), 50)
        for _ in range(4):
            omega = Rational(Fraction(rng.uniform(low, high)).limit_denominator(10**6))
            if piece.low < omega < piece.high:
                decision = arc.rotation(omega).decision
                assert decision.stable and decision.rung in (gs.Rung.TWIST_POSITIVE, gs.Rung.TWIST_NEGATIVE)
                assert decision.notion == piece.decision.notion
                asked += 1
    assert asked > 20


@pytest.mark.slow
def test_where_branches_cross(arcs):
    """At rest, and where two rotations have one sigma: each arc goes on with its own k."""
    for arc in arcs:
        for omega in (-2, 0, 2):
            if arc.low < omega < arc.high:
                k = np.array(arc.rotation(omega).directions[0], float)
                for side in (-1, 1):
                    beside = np.array(arc.near(omega + side * Fraction(1, 10**8))[0])
                    assert np.abs(k - beside).max() < 1e-6, omega
                assert np.abs(np.array(arc.near(Fraction(omega))[0]) - k).max() < 1e-12
    still = [arc.rotation(0).directions[0] for arc in arcs if arc.low < 0 < arc.high]
    assert set(still) == {tuple(s * x / sqrt(14) for x in (1, -2, 3)) for s in (1, -1)}


@pytest.mark.slow
def test_a_circle_of_one_rate_is_named():
    """b = c − omega l vanishes across axis 2 at omega = 2, where k2 = −1/4: two arcs cross it, along l."""
    arcs = arcs_of(*SPECIAL["a circle at one rate"])
    met = [(arc, circle) for arc in arcs for circle in arc.circles]
    assert [circle.rates["omega"] for _, circle in met] == [2, 2]
    assert {circle.directions[0] for _, circle in met} == {
        (side * sqrt(3) / 4, Rational(-1, 4), side * sqrt(3) / 2) for side in (1, -1)}
    for arc, circle in met:
        assert circle.locus == "the circle about axis 2"
        assert arc.rotation(2).directions == circle.directions
        for side in (-1, 1):
            beside = np.array(arc.near(2 + side * Fraction(1, 10**8))[0])
            assert np.abs(np.array(circle.directions[0], float) - beside).max() < 1e-6
        assert "At ω = 2 every direction of the circle about axis 2, through k = (" in " ".join(
            str(arc).split())
    assert not any(arc.circles for arc in arcs_of(*SPECIAL["no circle at that rate"]))


def test_as_text():
    arc = next(arc for arc in arcs_of(*SPECIAL["on one axis"]) if arc.curve.unknown == k2)
    said = " ".join(str(arc).split())
    assert said.startswith("This arc leads from k = (0, −1, 0), where ω → −∞, to k = (0, 0, 1), where ω = "
                           "−5/4 − √105/4 ≈ −3.812 and two rotations meet. Its parameter is the rate ω. ")
    assert r"\omega\to-\infty" in gs.to_latex(arc)


def test_what_is_refused():
    for inertia, c, rotor, why in (
            ((2, 2, 3), (0, 0, 1), (0, 0, 1), r"l = \(0, 0, 1\): the body is one of revolution"),
            ((2, 2, 2), (1, 1, 0), (2, 2, 0), r"l = \(2, 2, 0\): the body is one of revolution"),
            ((1, 2, 3), (0, 0, 0), (0, 0, 1), "the body is free; assemble it without a potential")):
        with pytest.raises(ScopeError, match=why):
            arcs_of(inertia, c, rotor)
    root = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential(sqrt(2) * k1 + k2 + k3))
    with pytest.raises(ScopeError, match="at rational numbers"):
        gs.staude_cone(root).arcs({})
    arc = next(arc for arc in arcs_of(*SPECIAL["on one axis"]) if arc.high != oo)
    with pytest.raises(ValuesError, match="give a number between"):
        arc.rotation(10**6)
    with pytest.raises(ValuesError, match="give a rational rate"):
        arc.rotation(-sqrt(30))
