"""Every equilibrium of a gyrostat satellite: complete, exact, decided as fractions and floats say."""
from fractions import Fraction as F
from random import Random

import numpy as np
import pytest
from orbital_search import search
from satellites import of_orbit
from slow import sampled
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.balls import ball
from gyrostat.equilibria.finders.orbital_form import balls as enclosures

RIGID = (1, "5/4", "8/5")


def found(moments, rotor, rate=1):
    """All equilibria."""
    return gs.relative_equilibria(gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(rate)), {})


def places(equilibria):
    """(n, r) in floats."""
    return np.array([[float(ball(x, 128).mid()) for v in e.directions for x in v] for e in equilibria])


def check(moments, rotor, rate, seed):
    """Newton's method finds no other; minima and maxima of the amended potential less saddles: 0.

    Where two meet, K singular, it converges slowly, and they count as none or as more.
    """
    equilibria = found(moments, rotor, rate)
    here, meet = places(equilibria), [e.form.signs[-1] == 0 for e in equilibria]
    for place in search(moments, rotor, rate, seed=seed):
        apart = np.abs(here - place).max(1)
        assert apart.min() < (1e-4 if meet[apart.argmin()] else 1e-8), (moments, rotor)
    assert len({tuple(np.round(p, 7)) for p in here}) == len(here)
    assert any(meet) or sum((-1) ** e.form.index for e in equilibria) == 0
    return equilibria


@pytest.mark.parametrize(("rotor", "count"), [
    (("3/10", "1/5", "1/10"), 16), (("1/50", "3/100", "1/25"), 24), ((2, 2, 2), 8), ((0, 0, 0), 24)])
def test_counts(rotor, count):
    """8 to 24, and of the rigid body 24: minima 4, one negative square 8, two 8, maxima 4."""
    equilibria = found(RIGID, rotor)
    assert len(equilibria) == count
    if rotor == (0, 0, 0):
        assert [sum(e.form.index == n for e in equilibria) for n in range(4)] == [4, 8, 8, 4]
        assert sum(e.decision.verdict is gs.Verdict.STABLE for e in equilibria) == 4
        assert sum(e.decision.verdict is gs.Verdict.UNSTABLE for e in equilibria) == 20


@pytest.mark.slow
@pytest.mark.parametrize("small", [F(1, 10**15), F(1, 10**30), F(-1.2246467991473532e-16)], ids=float)
def test_a_component_of_the_rotor_of_the_size_of_a_rounding(small):
    """The same attitudes and verdicts as with 10⁻³, of which the search finds no other; so are the rates."""
    moments, rotor = (F(11, 10), F(3, 2), 2), (-2, F(1, 1000) * (1 if small > 0 else -1), F(-1, 3))
    larger, here = check(moments, rotor, 1, 0), found(moments, (-2, small, F(-1, 3)))
    nearest = [int(np.abs(balls(larger) - place).max(1).argmin()) for place in balls(here)]
    assert sorted(nearest) == list(range(12))
    for n, e in zip(nearest, here):
        other = larger[n]
        assert np.abs(balls([e]) - balls([other])).max() < 0.05
        assert (e.decision, e.damped) == (other.decision, other.damped)
        np.testing.assert_allclose(*([float(x) for x in y.frequencies] for y in (e, other)), rtol=0.05)


@pytest.mark.few(1)
@pytest.mark.parametrize("size", [10**20, 10**50], ids=["20", "50"])
@pytest.mark.parametrize("seed", range(4))
def test_long_numbers_with_unlike_denominators(size, seed):
    """Newton's method finds no other, in any order of the axes; with the rotor across one, too."""
    draw = Random(size + seed)

    def number(low, high):
        bottom = draw.randint(size, 10 * size)
        return F(draw.randint(low * bottom, high * bottom), bottom)

    moments, rotor = [number(1, 3) for _ in range(3)], [number(-1, 1) for _ in range(2)] + [0] * (seed % 2)
    rotor += [number(-1, 1)] * (len(rotor) < 3)
    draw.shuffle(rotor)
    equilibria = found(moments, rotor)
    here = balls(equilibria)
    assert all(np.abs(here - place).max(1).min() < 1e-8 for place in search(moments, rotor, 1, seed=seed))
    assert len({tuple(np.round(p, 7)) for p in here}) == len(here)
    assert sum((-1) ** e.form.index for e in equilibria) == 0
    assert {e.decision.verdict for e in equilibria} >= {gs.Verdict.STABLE, gs.Verdict.UNSTABLE}


def balls(equilibria):
    """(n, r) in floats, without their expressions."""
    return np.array([[float(x.mid()) for part in (e.form.n, e.form.r) for x in enclosures(part, 2000)]
                     for e in equilibria])


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["general", "in a plane", "along an axis"])
def test_none_is_missing(kind, full):
    """Random gyrostats against a search from many starts."""
    rng = Random(kind)
    for seed in range(sampled(170, full, 1)):
        moments = [F(n, 20) for n in rng.sample(range(8, 40), 3)]
        zero = {"general": 0, "in a plane": 1, "along an axis": 2}[kind]
        rotor = [F(rng.randint(1, 40) * rng.choice((-1, 1)), rng.choice((20, 40, 400))) for _ in range(3)]
        for axis in rng.sample(range(3), zero):
            rotor[axis] = F(0)
        check(moments, rotor, F(rng.randint(1, 9), 4), seed)


@pytest.mark.slow
@pytest.mark.parametrize("l", ["1/10", "2/5", "3/2", 3])
def test_a_rotor_along_an_axis(l):
    """8 + 4 [L < w|a|] + 4 [L < w|b|] + 4 [L < 4w|a|] + 4 [L < 4w|b|]; E-C of each family by A, B, C."""
    moments, L = [Rational(1), Rational(5, 4), Rational(8, 5)], Rational(l)
    a, b = moments[0] - moments[1], moments[2] - moments[1]
    equilibria = found(moments, (0, L, 0))
    assert len(equilibria) == 8 + 4 * sum(bool(x > L) for x in (abs(a), abs(b), 4 * abs(a), 4 * abs(b)))
    for e in equilibria:
        report = gs.analyze(e.equilibrium)
        decision, own = report.verdict({}), e.decision
        assert own.verdict is decision.verdict and own.notion == decision.notion
        assert e.damped.verdict is report.verdict({}, damped=True).verdict


@pytest.mark.parametrize(("moments", "squares"), [
    ((60, 32, 35), (F(1, 4), F(16, 25), F(75, 32))),
    ((F(25, 16), 1, F(9, 8)), (F(2, 5), F(2, 5), F(21, 16)))])
def test_frequencies_to_thirty_digits(moments, squares):
    """In DeBra and Delp's region, and on its boundary, where two are the same."""
    e = next(e for e in found(moments, (0, 0, 0)) if e.directions == ((0, 1, 0), (0, 0, 1)))
    for x, square in zip(e.frequencies, squares, strict=True):
        assert abs(x**2 / Rational(square.numerator, square.denominator) - 1) < 1e-28


def on_circles(moments, rotor, rate, seed):
    """Newton's method ends on none but the circles found: the axis in (t, n, r) is that of one."""
    equilibria = found(moments, rotor, rate)
    axis = next(i for i in range(3) if moments[i - 1] == moments[i - 2])
    here = np.array([np.array(e.attitude.matrix)[:, axis] for e in equilibria])
    assert len({tuple(np.round(z, 7)) for z in here}) == len(here)
    for place in search(moments, rotor, rate, starts=100, seed=seed):
        z = np.array([np.cross(place[:3], place[3:])[axis], place[axis], place[3 + axis]])
        assert np.abs(here - z).max(1).min() < 1e-8, (moments, rotor)
    return equilibria


def test_circles_of_a_body_of_revolution():
    """Two of each precession that exists; the verdicts are those of orbital_precession."""
    L, w = Rational(1, 2), 2
    equilibria = on_circles([F(2), F(1), F(1)], [F(1, 2), F(0), F(0)], F(2), 0)
    assert sorted(e.locus.split(", ")[1] for e in equilibria) == sorted(
        [f"{kind} precession" for kind in ("cylindrical", "conical", "hyperbolic")] * 2)
    assert all("about axis 1" in e.locus for e in equilibria)
    same = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, L)), gs.circular_orbit(w))
    for kind in ("hyperbolic", "conical"):
        report = gs.analyze(gs.orbital_precession(same, kind))
        for e in (e for e in equilibria if kind in e.locus):
            assert e.decision.verdict is report.verdict({}).verdict
            assert e.damped.verdict is report.verdict({}, damped=True).verdict
            assert str(e.decision.modulo) == "(pi1,)"


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["along its axis", "off its axis", "across its axis"])
def test_none_is_missing_of_two_equal_moments(kind, full):
    """Circles where the rotor is along the axis of symmetry, else points, against a search."""
    rng = Random(kind)
    for seed in range(sampled(100, full, 4)):
        A, C = (F(n, 20) for n in rng.sample(range(12, 40), 2))
        axis, rate = rng.randrange(3), F(rng.randint(1, 9), 4)
        moments = [C if i == axis else A for i in range(3)]
        rotor = [F(rng.randint(1, 40) * rng.choice((-1, 1)), rng.choice((20, 40, 400))) for _ in range(3)]
        if kind == "along its axis":
            rotor = [x * (i == axis) * (seed % 4 > 0) for i, x in enumerate(rotor)]
            on_circles(moments, rotor, rate, seed)
            continue
        if kind == "across its axis":
            rotor[axis] = F(0)
        check(moments, rotor, rate, seed)


@pytest.mark.parametrize("rotor", [(0, sqrt(2) / 10, 0), (0, 0, sqrt(2))])
def test_irrational_rotors_along_an_axis(rotor):
    """Each is an equilibrium, proved when it is built."""
    equilibria = found(RIGID, rotor)
    assert len(equilibria) == 24 - 12 * (rotor[2] == sqrt(2))
    assert all(e.equilibrium for e in equilibria)


@pytest.mark.slow
@pytest.mark.parametrize(("moments", "rotor"), [
    (RIGID, ("1/20", "1/50", "1/30")), (RIGID, ("1/20", "1/50", 0)), (RIGID, (0, "1/20", "1/5")),
    ((1, 1, "3/2"), ("1/10", "1/5", 0)), ((1, 1, "3/2"), ("1/10", 0, "1/5"))])
def test_a_root_in_the_rate(moments, rotor):
    """ω0 from μ and the radius: the attitudes are those at a rate that is as near as decimals are."""
    scene = gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(mu=2, radius=3))
    equilibria = gs.relative_equilibria(scene, {})
    others = found(moments, rotor, Rational(round(float(sqrt(Rational(2, 27))) * 10**12), 10**12))
    near = places(others)
    assert len(equilibria) == len(near)
    for e, place in zip(equilibria, places(equilibria)):
        same = np.abs(near - place).max(1).argmin()
        assert np.abs(near[same] - place).max() < 1e-9
        assert e.decision.verdict is others[same].decision.verdict
        assert e.damped.verdict is others[same].damped.verdict


@pytest.mark.slow
def test_what_is_refused():
    """In one sentence that says what there is instead."""
    with pytest.raises(gs.errors.ScopeError, match="moments are rational.* as decimals"):
        found((1, sqrt(2), 2), (0, sqrt(2) / 10, 1))
    with pytest.raises(gs.errors.ScopeError, match="the three moments are 2, .* steady_motion"):
        found((2, 2, 2), (0, 0, 0))
    with pytest.raises(gs.errors.ValuesError, match="needs omega0"):
        gs.relative_equilibria(gs.assemble(gs.Gyrostat(RIGID, (0, 0, 0)), gs.circular_orbit()), {})


@pytest.mark.slow
def test_the_rate_scales():
    """ω0 → 2 ω0 with l → 2 l: the same attitudes."""
    slow, fast = found(RIGID, ("3/10", "1/5", "1/10")), found(RIGID, ("3/5", "2/5", "1/5"), 2)
    assert np.abs(places(slow) - places(fast)).max() < 1e-12
    assert [e.decision.verdict for e in slow] == [e.decision.verdict for e in fast]


@pytest.mark.slow
def test_frequencies():
    """Those of the oracle's linearised field, in floats; where an eigenvalue has a real part, its rate."""
    moments, rotor = [1.0, 1.25, 1.6], [0.3, 0.2, 0.1]
    equilibria = found(RIGID, ("3/10", "1/5", "1/10"))
    for e, place in zip(equilibria, places(equilibria)):
        scene, state = of_orbit(moments, place[:3], place[3:], rotor)
        roots = np.linalg.eigvals(np.array(scene.jacobian(state), float))
        assert sorted(x.imag for x in roots if x.imag > 1e-3 and abs(x.real) < 1e-6) == pytest.approx(
            [float(x) for x in e.frequencies], abs=1e-6)
        assert max(x.real for x in roots) == pytest.approx(float(e.growth_rate or 0), abs=1e-5)
