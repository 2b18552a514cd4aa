"""Sets of one name where gyroscopic forces hold a maximum: stretches whole, resonances and D4 = 0 singly."""
import random
from itertools import pairwise

import pytest
from sympy import Rational, S, oo
from window_families import FAMILIES
from window_scenes import windows

import gyrostat as gs
from gyrostat.algebra.solving.roots import between, in_order
from gyrostat.algebra.text.numbers import exact_number

A = gs.symbol("a")


def with_a_cubic(rotation, v):
    """The rotation in its field and a (v·(x − k))³, which changes D4 alone."""
    k = [exact_number(x) for x in rotation.k]

    def U(*x):
        field = sum(exact_number(c) * x[0]**i * x[1]**j * x[2]**n for (i, j, n), c in rotation.field.items())
        return field + A * sum(y * (at - on) for y, at, on in zip(v, x, k))**3

    scene = gs.assemble(gs.Gyrostat(rotation.tensor, tuple(rotation.rotor)), gs.general_potential(U))
    pi = [m - l for m, l in zip(rotation.momentum, rotation.rotor)]
    return gs.equilibrium(scene, (*pi, *rotation.k))


def check(report, name, values=None):
    """Inside every piece, between pieces, at every end, and elsewhere, the set is what a verdict says."""
    values, lowest = values or {}, S.Zero if gs.symbol(name).is_positive else -oo
    solution = gs.stabilizing_set(report, name, values)
    ends = in_order(list({end for part in solution.parts for case in part.cases for i in case.intervals
                          for end in (i.low, i.high)} - {lowest, oo}))
    inside = [between(a, b) for a, b in zip([lowest, *ends], [*ends, oo])]
    elsewhere = [Rational(n, 3) for n in (1, 4, 7, 11, 14, 20, 31)]
    for at in (*inside, *ends, *elsewhere):
        decision = report.verdict({**values, name: at})
        known = None if decision.verdict is gs.Verdict.UNDECIDED else decision.verdict is gs.Verdict.STABLE
        assert solution.contains({**values, name: at}) is known, (at, decision.reason)
    return ends, solution


@pytest.mark.slow
@pytest.mark.parametrize("values, name", [
    ({"I1": 5, "I2": 4, "I3": 3, "m0": 1, "l": 0}, "pi3_0"),
    ({"I1": 5, "I2": 4, "I3": "9/2", "m0": 1, "l": 2}, "pi3_0"),
    ({"I1": 5, "I2": 4, "I3": "9/2", "m0": 1, "pi3_0": 5}, "l"),
    ({"I1": 3, "I2": 7, "I3": 5, "m0": -1, "l": 1}, "pi3_0"),
    ({"I1": 5, "I2": 4, "pi3_0": 9, "m0": 1, "l": 1}, "I3")])
def test_a_sleeping_body(values, name):
    """Nothing is left open; at both ends of the window equal frequencies or q = 0 decide."""
    report = gs.analyze(FAMILIES["E1 with a rotor"]())
    _, solution = check(report, name, values)
    assert {part.meaning for part in solution.parts} == {"stable"}


@pytest.mark.slow
def test_off_symmetry():
    """At 1:2 and 1:3 inside the window it is unstable, at equal frequencies stable, where q = 0 unstable."""
    report = gs.analyze(FAMILIES["off symmetry"]())
    ends, solution = check(report, "a")
    resonances = [e for _, _, e in report.window().resonances]
    inside = [at for at in ends if any(abs(e.xreplace({A: at}).evalf(30)) < 1e-20 for e in resonances)]
    assert len(inside) == 2 and len(solution.parts[0].cases[0].intervals) == 3
    assert {report.verdict({"a": at}).verdict.name for at in inside} == {"UNSTABLE"}


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_where_D4_is_0(seed):
    """D4 is of degree 2 in a; where it vanishes D6 decides, and all numbers are stable."""
    rng = random.Random(seed)
    while True:
        rotation = next(windows(rng, True))
        report = gs.analyze(with_a_cubic(rotation, [rng.randint(-3, 3) for _ in range(3)]))
        zeros = report.window().D4.as_numer_denom()[0].as_poly(A)
        if zeros.degree() == 2 and zeros.discriminant() > 0:
            break
    solution = gs.stabilizing_set(report, "a")
    (interval,) = solution.parts[0].cases[0].intervals
    assert (interval.low, interval.high) == (-oo, oo)
    for at in zeros.all_roots():
        decision = report.verdict({"a": at})
        assert decision.verdict is gs.Verdict.STABLE and "D6" in decision.reason


@pytest.mark.slow
def test_windows_at_irrational_numbers():
    """√2 for a moment: what decides has coefficients in ℚ(√2); the window is as at rational ones nearby."""
    report = gs.analyze(FAMILIES["E1"]())
    values = {"I1": "3*sqrt(2)", "I2": 4, "I3": 3, "m0": 1}
    solution = gs.stabilizing_set(report, "pi3_0", values)
    assert [part.meaning for part in solution.parts] == ["stable"]
    near = gs.stabilizing_set(report, "pi3_0", {**values, "I1": "4.2426406871"})
    assert shape(solution) == shape(near)
    for pi3_0 in (3, 4, 5, 8, 20):
        stable = report.verdict({**values, "pi3_0": pi3_0}).stable
        assert solution.contains({**values, "pi3_0": pi3_0}) is stable


def shape(solution):
    """Ends of intervals in floats, and whether they belong to them."""
    return [(round(float(i.low), 8), round(float(i.high), 8), i.low_if, i.high_if)
            for part in solution.parts for case in part.cases for i in case.intervals]


ARCS = [((3, 5, 4), (0, 2, 2), (0, 0, 0)), ((1, 2, 3), (1, Rational(1, 2), 0), (0, 0, 0)),
        ((1, 2, 3), (1, 1, 1), (0, 0, 0)),
        ((2, 3, 4), (Rational(3, 7), Rational(-5, 4), Rational(11, 9)), (0, 0, 0)),
        ((1, 2, 3), (0, 0, 1), (0, 0, Rational(1, 2))), ((1, 2, 3), (1, 1, 1), (0, Rational(1, 2), 1)),
        ((2, 2, 3), (1, 1, 2), (1, 0, Rational(1, 2)))]


def twist(rotation):
    return float(rotation.decision.reason.split("D4 = ")[1].split(",")[0])


@pytest.mark.slow
@pytest.mark.parametrize("inertia, c, rotor", ARCS)
def test_the_arcs_of_staudes_cone(inertia, c, rotor):
    """A held piece is stable wherever it is asked; it ends where a resonance holds or D4 changes its sign.

    The latter without a rotor.
    """
    U = gs.general_potential(lambda *k: sum(x * y for x, y in zip(c, k)))
    found = 0
    for arc in gs.staude_cone(gs.assemble(gs.Gyrostat(inertia, rotor), U)).arcs({}):
        assert all(piece.decision.verdict is not gs.Verdict.UNDECIDED for piece in arc.pieces)
        held = [piece for piece in arc.pieces if "D4 is not 0" in piece.decision.reason]
        for piece in held:
            decision = arc.rotation(between(piece.low, between(piece.low, piece.high))).decision
            assert (decision.verdict, decision.notion) == (gs.Verdict.STABLE, piece.decision.notion)
        for one, two in pairwise(held):
            if one.high == two.low:
                found += 1
                sides = [arc.rotation(between(piece.low, piece.high)) for piece in (one, two)]
                ratios = [side.frequencies[1] / side.frequencies[0] for side in sides]
                resonant = any((ratios[0] - m) * (ratios[1] - m) < 0 for m in (2, 3))
                assert resonant or not any(rotor) and twist(sides[0]) * twist(sides[1]) < 0
    assert found
