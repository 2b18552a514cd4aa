"""All relative equilibria in fields that vanish, are flat, infinite or made for a level, and by any name."""
from fractions import Fraction
from functools import cache

import mpmath
import oracle
import pytest
from equilibria.branching import a1, a2, digits, in_field, k3, named, real, signs, tilted
from slow import slow
from sympy import CRootOf, Rational, S, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.equilibria.search import relative_equilibria
from gyrostat.errors import ValuesError


def test_a_field_that_turns_nothing():
    """U = 0 at rest: every tilt, stable with a rotor, unstable without.

    With ω ≠ 0: cos θ = l/(ω (I1 − I3)) alone.
    """
    free = in_field(S.Zero)
    body = {"I1": 2, "I3": 1}
    assert [signs(relative_equilibria(free, body | {"l": l, "omega": 0})) for l in (1, 0)] == [
        [1, 1, 1],
        [-1, -1, -1],
    ]
    assert [b.place["k3"] for b in relative_equilibria(free, body | {"l": 1, "omega": 2})] == [1, S.Half, -1]
    assert [b.place["k3"] for b in relative_equilibria(free, body | {"l": 1, "omega": 1})] == [1, -1]


@pytest.mark.parametrize(("l", "pi3"), [(0, 0), (1, -1), ("-2/3", "2/3")])
def test_a_level_on_which_every_tilt_rests(l, pi3):
    """U = 0, P = v = 0: V is constant, every tilt is a precession with W = 0, and E1, E2 are there.

    All are left by motions.
    """
    found = relative_equilibria(in_field(S.Zero), {"I1": 2, "I3": 1, "l": l, "pi3_0": pi3, "C1": 0})
    assert [(b.label, b.place["k3"]) for b in found] == [("E1", 1), ("precession", None), ("E2", -1)]
    assert set(found[1].place.values()) == {None} and None not in found[0].place.values()
    assert signs(found) == [-1, -1, -1]


@pytest.mark.slow
@pytest.mark.parametrize(("P", "v"), [(1, 0), (1, 1), *slow((3, Rational(-1, 2)), (2, -2))])
def test_a_field_made_for_a_level(P, v):
    """U = −(v − P k3)²/(2 I1 (1 − k3²)): V is constant, g = 0.

    A pole is left out where U is infinite there.
    """
    U = -((v - P * k3) ** 2) / (4 * (1 - k3**2))
    found = relative_equilibria(in_field(U.cancel()),
                                {"I1": 2, "I3": 1, "l": Rational(1, 3), "pi3_0": P - Rational(1, 3), "C1": v})
    assert [b.label for b in found] == ["E1"] * (v == P) + ["precession"] + ["E2"] * (v == -P)
    assert set(signs(found)) == {-1}


def test_a_field_that_is_infinite_somewhere():
    """U = 1/(1 − k3) has no E1, U = 1/k3 no tilt at k3 = 0; the rest is found."""
    body = {"I1": 2, "I3": 1, "l": 0}
    found = relative_equilibria(in_field(1 / (1 - k3)), body | {"omega": 1})
    assert [b.label for b in found] == ["E3", "E2"]
    assert agree(found[0].place["k3"], CRootOf(k3 * (1 - k3) ** 2 + 1, 0))
    assert [b.label for b in relative_equilibria(in_field(1 / k3), body | {"omega": 1})] == ["E1", "E2"]
    with pytest.raises(ValuesError, match="U = 1/k3 is not defined at k3 = 0"):
        relative_equilibria(in_field(1 / k3), body | {"k3": 0})


def agree(a, b):
    """Whether two exact numbers are equal."""
    return sign_of_constant(a - b) == 0


@pytest.mark.parametrize("l", [0, 1, -3])
def test_tilts_at_rest(l):
    """ω = 0: U' = 0, whatever l; U = a1 k3² + a2 k3⁴ rests at k3 = 0 and at k3² = −a1/(2 a2).

    P = I1 (1 − k3²) U'' + l².
    """
    scene = in_field(a1 * k3**2 + a2 * k3**4)
    for b1, b2 in ((1, -1), (-1, 1), (0, 1), (0, -1), (-1, "1/2"), (1, 1)):
        found = relative_equilibria(scene, {"I1": 2, "I3": 1, "l": l, "omega": 0, "a1": b1, "a2": b2})
        square = -Rational(b1) / (2 * Rational(b2))
        expected = [sqrt(square), S.Zero, -sqrt(square)] if 0 < square < 1 else [S.Zero]
        assert [b.place["k3"] for b in found] == [1, *expected, -1]
        for b in found[1:-1]:
            z = b.place["k3"]
            margin = 2 * (1 - z**2) * (2 * Rational(b1) + 12 * Rational(b2) * z**2) + Rational(l) ** 2
            assert b.place["omega"] == b.place["pi3"] == 0
            assert not margin or signs([b]) == [1 if margin > 0 else -1]
            if not margin:                             # U = ± k3⁴: g‴′ ∝ −U⁗
                assert (b1, z) == (0, 0) and signs([b]) == [1 if b2 == 1 else -1]


def test_a_linear_field_never_rests():
    """U = 3 k3, without parameters: E1 and E2 at rest; with a rotor, tilts at other rates."""
    scene = in_field(3 * k3)
    assert [b.label for b in relative_equilibria(scene, {"I1": 2, "I3": 1, "l": 1, "omega": 0})] == [
        "E1",
        "E2",
    ]
    assert [b.place["k3"] for b in relative_equilibria(scene, {"I1": 2, "I3": 1, "l": 1, "omega": 2})] == [
        1,
        Rational(-1, 4),
        -1,
    ]


def test_every_rate_of_a_tilt():
    """l = 0 = k3 (I1 − I3) and U' = 0: every rate; P = 0 = k3 and U' = 0: every rate; both are said."""
    for values in ({"k3": 0}, {"k3": 0, "pi3_0": 0}):
        with pytest.raises(ValuesError, match="every rate about the vertical"):
            relative_equilibria(in_field(k3**2), {"I1": 2, "I3": 1, "l": 0} | values)
    assert relative_equilibria(in_field(k3), {"I1": 2, "I3": 1, "l": 0, "k3": 0}) == []


def outcome(branches):
    """What is asked of a branch, without the text of its decision."""
    return [(b.label, b.place, b.decision.verdict) for b in branches]


NEWTONIAN = {"m0": "1/2", "m1": 3}


@cache
def newtonian(moments, rotor):
    """A scene of a body of revolution in the Newtonian field of second order."""
    return gs.assemble(gs.Gyrostat(moments, (0, 0, rotor)), gs.newtonian_field(2))


@pytest.mark.slow
@pytest.mark.parametrize("motion", [{"omega": 1}, {"pi3_0": 1, "C1": "3/4"}, {"k3": "1/3", "pi3_0": 5}])
def test_bodies_by_any_name(motion):
    """I = (2, 2, 3), l = 1 as symbols A, C, h, as numbers, as 2 I1, and with names in each other's places.

    The same branches.
    """
    A, C, h, I1, I2, I3, l = map(gs.symbol, ("A", "C", "h", "I1", "I2", "I3", "l"))
    plain = outcome(relative_equilibria(newtonian((I1, I1, I3), l),
                                        {"I1": 2, "I3": 3, "l": 1, **NEWTONIAN, **motion}))
    for body, values in (((A, A, C, h), {"A": 2, "C": 3, "h": 1}), ((2, 2, 3, 1), {}),
                         ((2 * I1, 2 * I1, I3, l), {"I1": 1, "I3": 3, "l": 1}),
                         ((I3, I3, I1, l), {"I3": 2, "I1": 3, "l": 1}),
                         ((A, A, I2, I3), {"A": 2, "I2": 3, "I3": 1}),
                         ((A, A, 3, 1), {"A": 2}), ((I2, I2, I3, 2 * l), {"I2": 2, "I3": 3, "l": "1/2"})):
        scene = newtonian(body[:3], body[3])
        assert outcome(relative_equilibria(scene, {**values, **NEWTONIAN, **motion})) == plain


def test_the_rotor_may_be_in_the_field():
    """A letter of both is one number: U = s k3 with l = s is U = m0 k3 with m0 = l.

    Also at ω = 1, where it drops out of the relation.
    """
    s, body = gs.symbol("s"), gs.symmetric_gyrostat()
    shared = gs.assemble(gs.Gyrostat(body.moments, (0, 0, s)), gs.axial_potential(s * k3))
    for omega in (1, 2):
        theirs = relative_equilibria(in_field(gs.symbol("m0") * k3),
                                     {"I1": 2, "I3": 1, "l": 1, "m0": 1, "omega": omega})
        ours = relative_equilibria(shared, {"I1": 2, "I3": 1, "s": 1, "omega": omega})
        assert outcome(ours) == outcome(theirs)


@pytest.mark.slow
def test_algebraic_numbers(polynomial):
    """ω = √2/3, and an l, k3, π3 that are roots of polynomials: found and decided.

    Results may be given back.
    """
    field = named(map(Fraction, ("1/2", "-3", "2/7", "0", "0", "0")))
    body = {"I1": 2, "I3": 3, "l": "1/2"} | field
    found = relative_equilibria(polynomial, body | {"omega": sqrt(2) / 3})
    f = [float(c) for c in (Rational(1, 2) - sqrt(2) / 6, -6 - Rational(2, 9), Rational(6, 7))]
    assert [round(float(b.place["k3"]), 12) for b in found[1:-1]] == [
        round(float(r.real), 12) for r in mpmath.polyroots(f[::-1]) if -1 < r.real < 1]
    rho = CRootOf(k3**3 - k3 - 1, 0)                   # written in k3 itself
    for motion in ({"omega": "1/2", "l": rho}, {"k3": 1 / (1 + rho), "pi3_0": 4},
                   {"pi3_0": sqrt(2) / 3, "C1": "1/3", "a3": 0}):
        values = body | motion
        found = relative_equilibria(polynomial, values)
        assert tilted(found) and set(signs(found)) <= {1, -1}
        with mpmath.workdps(60):
            l = digits(rho) if "l" in motion else mpmath.mpf(1) / 2
            for b in tilted(found):
                z, W, sigma, pi3 = (digits(b.place[name]) for name in ("k3", "omega", "sigma", "pi3"))
                slope = oracle.polynomial([real(Fraction(values[f"a{n}"])) * n for n in range(1, 7)], z)
                assert abs(slope - (pi3 + l) * W + 2 * z * W**2) < mpmath.mpf(10) ** -45
                assert abs(pi3 - 3 * (W * z + sigma)) < mpmath.mpf(10) ** -45
    for b in relative_equilibria(polynomial, body | {"omega": "1/2"})[1:-1]:
        rates = relative_equilibria(polynomial, body | {"k3": b.place["k3"], "pi3_0": b.place["pi3"]})
        (back,) = [c for c in rates if c.label == "E3"]
        assert agree(back.place["omega"], S.Half) and signs([back]) == signs([b])
