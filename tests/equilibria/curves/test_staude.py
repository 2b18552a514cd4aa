"""Staude's cone, its arcs and their verdicts, against Newton's method, spectra and signatures in doubles."""
import random
from fractions import Fraction

import heavy
import numpy as np
import pytest
from slow import sampled
from sympy import Matrix, Rational, diff, oo, simplify, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

RHO = gs.symbol("rho")
k1, k2, k3 = DIRECTION = [gs.symbol(f"k{n}") for n in (1, 2, 3)]
SPECIAL = [((1, 2, 3), (0, 0, 1)), ((3, 5, 4), (0, 2, 2)), ((1, 2, 3), (1, 0, -1)), ((2, 2, 3), (1, 2, 1)),
           ((2, 2, 3), (1, 2, 0)), ((2, 3, 2), (0, 0, 5))]


def cone_of(inertia, c, rotor=(0, 0, 0)):
    U = sum(Rational(x) * k for x, k in zip(c, DIRECTION))
    return gs.staude_cone(gs.assemble(gs.Gyrostat(tuple(inertia), rotor), gs.general_potential(U)))


def drawn(rng):
    inertia = [Fraction(rng.randint(4, 30), 10) for _ in range(3)]
    return inertia, [Fraction(rng.randint(-12, 12), rng.randint(1, 6)) for _ in range(3)]


def floats(inertia, c, omega):
    return np.diag([float(x) for x in inertia]), np.zeros(3), np.array(c, float), np.zeros((3, 3)), omega


def at(arc, value):
    """k and omega in doubles, from the formula of the arc."""
    n = np.array([float(x.subs(arc.parameter, value)) for x in arc.curve.n])
    return n / np.linalg.norm(n), float(np.sqrt(np.linalg.norm(n)))


def inside(rng, low, high):
    """Rational numbers of an interval."""
    low = Fraction(-10**4) if low == -oo else Fraction(float(low)) + Fraction(1, 10**9)
    high = Fraction(10**4) if high == oo else Fraction(float(high)) - Fraction(1, 10**9)
    return [Rational(low + (high - low) * Fraction(rng.randint(1, 999), 1000) ** n) for n in (1, 4)]


def check(rng, inertia, c):
    """Every rotation that Newton's method finds is on an arc; every piece has the verdict of its points."""
    arcs, found = cone_of(inertia, c).arcs({}), 0
    for omega in (0.7, 1.9):
        data = floats(inertia, c, omega)
        for k in heavy.directions(*data, starts=60):
            tau = (k @ data[2]) / omega**2 - k @ data[0] @ k
            near = []
            for arc in arcs:
                value = tau if arc.parameter != RHO else k[arc.curve.n.index(RHO)] * omega**2
                if arc.low < value < arc.high:
                    place, rate = at(arc, value)
                    near.append(np.abs(place - k).max() + abs(rate - omega))
            assert min(near) < 1e-5, (inertia, c, omega, k)
            found += 1
    for arc in arcs:
        for piece in arc.pieces:
            for value in inside(rng, piece.low, piece.high):
                k, omega = at(arc, value)
                verdict = heavy.verdict(*floats(inertia, c, omega), k)
                known = "STABLE" if verdict == "UNDECIDED" else verdict        # by D4
                assert known in (None, piece.decision.verdict.name), (inertia, c, value)
    return found


@pytest.mark.slow
def test_all_are_on_the_arcs_and_rightly_decided():
    rng = random.Random("staude")
    assert sum(check(rng, *drawn(rng)) for _ in range(2)) > 6


@pytest.mark.slow
@pytest.mark.parametrize(("inertia", "c"), SPECIAL)
def test_special_bodies(inertia, c):
    """c on an axis, in a principal plane, two equal moments."""
    assert check(random.Random("special"), inertia, c) >= 4


@pytest.mark.slow
def test_many(full):
    rng = random.Random("many")
    count = sampled(200, full, 8)
    assert sum(check(rng, *drawn(rng)) for _ in range(count)) > 4 * count


def test_the_cone_in_symbols():
    """Of the axes, of c and of I⁻¹c; the polynomial of the books."""
    c, I = [gs.symbol(f"c{n}") for n in (1, 2, 3)], [gs.symbol(f"I{n}") for n in (1, 2, 3)]
    U = gs.symbol("m0") * sum(x * k for x, k in zip(c, DIRECTION))
    cone = gs.staude_cone(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)), gs.general_potential(U)))
    printed = sum((I[i - 2] - I[i - 1]) * c[i] * DIRECTION[i - 2] * DIRECTION[i - 1] for i in range(3))
    assert (cone.polynomial - gs.symbol("m0") * printed).expand() == 0
    for point in ((1, 0, 0), (0, 1, 0), (0, 0, 1), c, [x / m for x, m in zip(c, I)]):
        assert simplify(cone.polynomial.subs(dict(zip(DIRECTION, point)), simultaneous=True)) == 0
    assert "k₂ k₃ (I₂ − I₃)" in str(cone) and r"\omega^{2} =" in gs.to_latex(cone)


@pytest.mark.slow
def test_equations_of_motion_in_symbols():
    """ω² Ik × k = ∇U × k, where k = n/ω²."""
    for inertia, c in [((1, 2, 3), (1, -2, 1)), *SPECIAL]:
        for arc in cone_of(inertia, c).arcs({}):
            n, I = Matrix(arc.curve.n), Matrix.diag(*inertia)
            assert not any(map(simplify, (I * n).cross(n) - Matrix(c).cross(n)))


@pytest.mark.slow
def test_with_a_rotor():
    """Every rotation of given rates is on the curve, and has that rate there."""
    rng = random.Random("curve")
    for _ in range(4):
        inertia, c = drawn(rng)
        rotor, omega = [Fraction(rng.randint(-9, 9), 8) or Fraction(1, 3) for _ in range(3)], 1.3
        data = (*floats(inertia, c, omega)[:1], np.array(rotor, float), *floats(inertia, c, omega)[2:])
        cone = cone_of(inertia, c, tuple(rotor))
        size = float(sum(x * x for x in c)) * 10
        for k in heavy.directions(*data, starts=60):
            place = dict(zip(DIRECTION, k))
            assert abs(float(cone.polynomial.subs(place))) < 1e-7 * size
            assert abs(float(cone.rate.subs(place)) - omega) < 1e-5


@pytest.mark.slow
def test_boundaries_between_minimum_and_saddle_are_extrema_of_c1():
    """C1² = (n·In)²/|n|³ is stationary along the arc just there."""
    for inertia, c in (((1, 2, 3), (1, 1, 1)), ((3, 5, 4), (-1, 2, 2))):
        for arc in cone_of(inertia, c).arcs({}):
            square, x = sum(y * y for y in arc.curve.n), arc.parameter
            level = sum(m * y * y for m, y in zip(inertia, arc.curve.n)) ** 4 / square**3
            for before, after in zip(arc.pieces, arc.pieces[1:]):
                kinds = {p.decision.reason.split(":")[0].split(",")[0] for p in (before, after)}
                value = diff(level, x).subs(x, after.low.evalf(40))
                assert (abs(value) < 1e-20) == (len(kinds) == 2), (inertia, after.low, kinds)


@pytest.mark.slow
def test_the_verdict_does_not_change_where_d4_changes_its_sign():
    """Between resonances, and where D4 is 0: other pieces, the same verdict."""
    arc = cone_of((1, 2, 3), (1, 1, 1)).arcs({})[2]
    first, *held = arc.pieces
    assert first.decision.unstable and len(held) == 4 and all(piece.decision.stable for piece in held)
    assert len({piece.decision.rung for piece in held}) == 2
    assert arc.boundaries == (first.high,)


def test_ends():
    """Axes at infinite rate, c at rest."""
    arcs = cone_of((1, 2, 3), (0, 3, 4)).arcs({})
    assert [(end.k, end.omega) for arc in arcs for end in arc.ends] == [
        ((0, Rational(-3, 5), Rational(-4, 5)), 0), ((0, 0, -1), oo), ((0, 0, 1), oo), ((0, -1, 0), oo),
        ((0, 1, 0), oo), ((0, Rational(3, 5), Rational(4, 5)), 0), ((-1, 0, 0), oo), ((1, 0, 0), oo)]
    assert cone_of((2, 2, 3), (3, 4, 1)).arcs({})[1].ends[1].k == (Rational(-3, 5), Rational(-4, 5), 0)
    for arc in arcs:
        for end, value in zip(arc.ends, (arc.low, arc.high)):
            near = (1 if value == oo else -1) * 10**9 if value in (oo, -oo) else (
                value + (1 if value == arc.low else -1) * Rational(1, 10**9))
            assert np.abs(at(arc, near)[0] - np.array(end.k, float)).max() < 1e-6


def test_a_published_example():
    """I = (1, 2, 3), c = (1, 1, 1)/√3, k = (−1, −3, 3)/√19: a minimum; algebraic numbers are taken."""
    U = (k1 + k2 + k3) / sqrt(3)
    arcs = gs.staude_cone(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(U))).arcs({})
    rotation = arcs[1].rotation(Rational(-5, 2))
    assert f"{float(rotation.rates['omega'])**2:.11f}" == "1.67774098562"
    (k,) = rotation.directions
    assert [f"{float(x) * 19**0.5:.6f}" for x in k] == ["-1.000000", "-3.000000", "3.000000"]
    low, high, decision = next(p for p in arcs[1].pieces if p.low < Rational(-5, 2) < p.high)
    assert low == -3 and f"{float(high):.6f}" == "-2.384336" and decision.verdict.name == "STABLE"
    assert "−3 < τ < −2.38433…" in str(arcs[1]) and r"\omega\to\infty" in gs.to_latex(arcs[1])


def test_what_is_refused():
    body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    with pytest.raises(ScopeError, match="the scene has none: give a potential"):
        gs.staude_cone(gs.assemble(body))
    curved = gs.staude_cone(gs.assemble(body, gs.general_potential(k1**2 + k2)))
    with pytest.raises(ScopeError, match=r"is not c·k, and the arcs are found in a uniform field only"):
        curved.arcs({})
    with pytest.raises(ScopeError, match="the body is free"):
        cone_of((1, 2, 3), (0, 0, 0)).arcs({})
    for inertia, c in (((2, 2, 3), (0, 0, 1)), ((1, 1, 1), (1, 2, 3))):
        with pytest.raises(ScopeError, match="the axes of its permanent rotations form whole circles"):
            cone_of(inertia, c).arcs({})
    scene = gs.assemble(body, gs.general_potential(gs.symbol("m0") * k1 + k2))
    with pytest.raises(ValuesError, match="needs m0"):
        gs.staude_cone(scene).arcs({})
    with pytest.raises(ValuesError, match="m1"):
        gs.staude_cone(scene).arcs({"m0": 1, "m1": 2})
    arcs = gs.staude_cone(scene).arcs({"m0": 1})
    assert len(arcs) == 4
    with pytest.raises(ValuesError, match="tau = -2, and the arc goes from -oo to -2.*give a number between"):
        arcs[0].rotation(-2)


def test_a_sphere_with_a_rotor_is_refused():
    """Its polynomial is 0 everywhere; a body of revolution with its rotor along the axis keeps its own."""
    field = gs.general_potential(lambda k1, k2, k3: k1 + k3)
    cone = gs.staude_cone(gs.assemble(gs.Gyrostat((2, 2, 2), (1, 0, 2)), field))
    for asked in (lambda: cone.polynomial, lambda: cone.rate):
        with pytest.raises(ScopeError, match="all moments are equal, and the polynomial of the curve is 0"):
            asked()
    assert cone.arcs({})
    assert gs.staude_cone(gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 2)), field)).polynomial
