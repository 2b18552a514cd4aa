"""Boundary points at algebraic numbers: surds, roots of polynomials, points that are claimed."""
from math import factorial

import oracle
import pytest
from slow import slow
from stability.boundary_ladder import HALF, k3, name
from sympy import CRootOf, Poly, Rational, S, Symbol, cancel, expand, integrate, invert, radsimp, rem, sqrt

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.notation import jet_name


def designed(moments, z, w, total, power, first, order):
    """Derivatives of U at a tilt where g = first · x^power exactly, and l.

    2 I1 (e − U)(1 − k3²) = (v − P k3)² + first · x^power.
    """
    A, C = moments
    v = A * w * (1 - z**2) + total * z
    wanted = [radsimp(expand(c)) for c in ((v - total * z) ** 2, -2 * (v - total * z) * total, total**2)] + [
        S.Zero
    ] * order
    wanted[power] += first
    sphere, series = [2 * A * (1 - z**2), -4 * A * z, -2 * A], []
    for n in range(order + 1):
        rest = wanted[n] - sum(sphere[j] * series[n - j] for j in (1, 2) if j <= n)
        series.append(radsimp(expand(rest / sphere[0])))
    jets = {jet_name(n): radsimp(expand(-factorial(n) * c)) for n, c in enumerate(series) if n}
    return jets, radsimp(expand(total - C * w * z))


@pytest.mark.few(1)
@pytest.mark.parametrize(("power", "first", "expected"), [
    (2, -1, "STABLE"), (3, 1, "UNSTABLE"), (4, Rational(1, 10**30), "UNSTABLE"),
    (4, 12 * sqrt(2) - 17, "STABLE"), (6, 2, "UNSTABLE"),
    *slow((2, 1, "UNSTABLE"), (3, -1, "UNSTABLE"), (4, -1, "STABLE"), (4, 17 - 12 * sqrt(2), "UNSTABLE"),
          (5, 1, "UNSTABLE"), (6, -1, "STABLE"))])
def test_quadratic_surds_at_a_tilt(e3, power, first, expected):
    """k3 = 1/3, ω = 1 + √2, P = √2 − 3, every derivative of U in ℚ(√2), so that g begins with first ·
    x^power: by design.
    """
    z, w, total = Rational(1, 3), 1 + sqrt(2), sqrt(2) - 3
    jets, rotor = designed((S(2), S(3)), z, w, total, power, first, 6)
    assert name(e3, {"I1": 2, "I3": 3, "l": rotor, "omega": w, "k3": z} | jets) == expected
    surd = radsimp(1 / (2 + sqrt(2)))                  # and a k3 that is a surd itself, 1 − √2/2
    jets, rotor = designed((S(2), S(3)), surd, w, total, power, first, 6)
    assert name(e3, {"I1": 2, "I3": 3, "l": rotor, "omega": w, "k3": surd} | jets) == expected


@pytest.mark.parametrize(("b", "expected"), [(0, "UNSTABLE"), (3, "STABLE"), *slow((-3, "UNSTABLE"))])
def test_an_algebraic_rate_at_a_given_tilt(b, expected):
    """I = (1, 1, 3), l = 0, k3 = 1/2, nothing eliminated: ω² = U' = 2, p = 3/4 U″ + 2 = 0, g‴ = 0.

    The number b moves U⁗ off g⁗ = 0.
    """
    y, across = k3 - HALF, Rational(3, 4)
    u1, u2 = S(2), -2 / across
    u3 = (6 * HALF * u2 + 6 * u1) / across
    u4 = (8 * HALF * u3 + 12 * u2) / across + b
    u5 = 1 + (10 * HALF * u4 + 20 * u3) / across       # g^(5) is not 0
    field = expand(u1 * y + u2 * y**2 / 2 + u3 * y**3 / 6 + u4 * y**4 / 24 + u5 * y**5 / 120)
    report = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((1, 1, 3), (0, 0, 0)),
                                                gs.axial_potential(field))))
    assert report.equilibrium.eliminated == ()
    for w in (sqrt(2), -sqrt(2)):
        assert name(report, {"k3": HALF, "omega": w}) == expected
    with pytest.raises(ValuesError, match="not on E3"):
        report.verdict({"k3": HALF, "omega": "1.41421356237309504880"})


def at_a_root(modulus, moments, rotor, w, rungs, last):
    """A numeric polynomial U with E3 at every root of the modulus m, and g″, g‴, … 0 there, as many as rungs.

    U' = ω l − ω² k3 (I1 − I3) + m h1 + m² h2 + … + last m^(rungs + 1), each h chosen modulo m.
    """
    A, C = moments
    slope = w * rotor - w**2 * k3 * (A - C)
    for n in range(2, 2 + rungs):
        d = [None, *(slope.diff(k3, i) for i in range(n))]                # U', U″, …, without the new term
        if n == 2:
            g = -2 * (A * (1 - k3**2) * d[2] - 2 * A * k3 * d[1] + A**2 * w**2
                      + ((A - C) * w * k3 - rotor) ** 2)
        else:
            g = 2 * A * (-(1 - k3**2) * d[n] + 2 * n * k3 * d[n - 1] + n * (n - 1) * d[n - 2])
        pivot = 2 * A * (1 - k3**2) * factorial(n - 1) * modulus.diff(k3) ** (n - 1)
        inverse = invert(rem(expand(pivot), modulus, k3), modulus, k3)
        slope = expand(slope + modulus ** (n - 1) * rem(expand(g * inverse), modulus, k3))
    return integrate(expand(slope + last * modulus ** (rungs + 1)), k3)


QUARTIC, QUINTIC = 3 * k3**4 + k3**3 - 2 * k3 - 1, 5 * k3**5 - 10 * k3 + 3


@pytest.mark.slow
@pytest.mark.parametrize(("modulus", "rungs", "last"), [
    (QUARTIC, 0, 1), (QUINTIC, 1, 0),
    *slow((QUINTIC, 0, -20), (QUARTIC, 1, 1), (QUARTIC, 2, -9), (QUARTIC, 2, 9))])
def test_tilts_that_are_roots_of_polynomials(modulus, rungs, last):
    """k3 a root of degree 4 or 5, ω and l given: off the boundary, on it, and on it with g‴ = 0 too.

    Always decided.

    Expected is the first coefficient of g at the root that is not 0, g written with the numbers of 120
    digits.
    """
    assert Poly(modulus, k3).is_irreducible
    (A, C), rotor, w = (Rational(3, 2), S(2)), Rational(1, 3), S(2)
    root = next(r for r in Poly(modulus, k3).real_roots() if abs(r.evalf(20)) < 1)
    field = at_a_root(modulus, (A, C), rotor, w, rungs, last)
    report = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((A, A, C), (0, 0, rotor)),
                                                gs.axial_potential(field))))
    assert report.equilibrium.eliminated == () and isinstance(root, CRootOf)
    z = root.evalf(120)
    P = C * w * z + rotor
    v, e = A * w * (1 - z**2) + P * z, A * w**2 * (1 - z**2) / 2 + field.subs(k3, z)
    g = Poly(expand(2 * A * (e - field) * (1 - k3**2) - (v - P * k3) ** 2), k3)
    taylor = oracle.taylor(g.all_coeffs()[::-1], z)
    n = next(n for n, c in enumerate(taylor) if abs(c) > Rational(1, 10**60))
    assert n == 2 + rungs
    expected = "STABLE" if n % 2 == 0 and taylor[n] < 0 else "UNSTABLE"
    decision = report.verdict({"omega": w, "k3": root})
    assert decision.verdict.name == expected and ("on the boundary" in decision.reason) == (rungs > 0)


UP, DOWN, RATIONAL, SURD = (0, 0, 1), (0, 0, -1), ("-2/7", "3/7", "6/7"), (0, sqrt(3) / 2, "-1/2")


@pytest.mark.few(1)
@pytest.mark.parametrize(("k", "power", "first"), [
    (UP, 3, 1), (DOWN, 3, -1), (RATIONAL, 4, -1), (SURD, 4, 1),
    *slow(*((k, 3, first) for k in (RATIONAL, SURD) for first in (1, -1)),
          *((k, 4, first) for k in (UP, DOWN) for first in (1, -1)),
          (UP, 3, -1), (DOWN, 3, 1), (RATIONAL, 4, 1), (SURD, 4, -1))])
def test_claimed_points_have_a_boundary(k, power, first):
    """A point given by numbers, π = I ω k, P = 2, with g = ±x³ or ±x⁴ by design.

    The ladder of its tilt decides.
    """
    k = [S(c) for c in k]
    z, w, (A, C), P = k[2], S(2), (S(2), S(3)), S(2)
    v = A * w * (1 - z**2) + P * z
    y = 1 - z * k3 if z**2 == 1 else k3 - z
    field = cancel(-((v - P * k3) ** 2 + first * y**power) / (2 * A * (1 - k3**2)))
    scene = gs.assemble(gs.Gyrostat((A, A, C), (0, 0, P - C * w * z)), gs.axial_potential(field))
    report = gs.analyze(gs.equilibrium(scene, [A * w * k[0], A * w * k[1], C * w * k[2], *k]))
    stable = first < 0 and (z**2 == 1 or power == 4)
    assert report.boundary.pole == (z**2 == 1)
    assert name(report, {}) == ("STABLE" if stable else "UNSTABLE")


def test_a_tilt_of_a_symbol_has_no_boundary():
    """k = (√(1 − b²), 0, b) with abs(b) < 1 not said: a pole or not, so no ladder; with the domain, one."""
    b = gs.symbol("b")
    scene = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 0)), gs.axial_potential((k3 - b) ** 3))
    point = (0, 0, 0, sqrt(1 - b**2), 0, b)
    assert gs.analyze(gs.equilibrium(scene, point)).boundary is None
    inside = gs.analyze(gs.equilibrium(scene, point, domain=(1 - b**2,)))
    assert inside.boundary is not None
    assert not inside.boundary.pole
    assert name(inside, {"b": "1/2"}) == "UNSTABLE"


@pytest.mark.parametrize(("beside", "expected"), [(0, "UNSTABLE"), *slow((1, "STABLE"), (-1, "UNSTABLE"))])
def test_a_claimed_point_at_the_root_of_a_polynomial(beside, expected):
    """k3 = CRootOf in the point itself, exactly on p = 0 and beside it: never undecided."""
    k3, root = gs.symbol("k3"), CRootOf(9 * Symbol("x") ** 3 - 4 * Symbol("x") + 1, 0)
    I1, I3, l = 2, 1, 1
    slope = l - root * (I1 - I3)                           # ω = 1
    flat = -((I3 * root + l - 2 * I1 * root) ** 2) / (I1 * (1 - root**2)) - I1
    scene = gs.assemble(gs.Gyrostat((I1, I1, I3), (0, 0, l)),
                        gs.axial_potential(slope * k3 + (flat + beside) / 2 * (k3 - root) ** 2))
    point = (I1 * sqrt(1 - root**2), 0, I3 * root, sqrt(1 - root**2), 0, root)
    assert name(gs.analyze(gs.equilibrium(scene, point)), {}) == expected
