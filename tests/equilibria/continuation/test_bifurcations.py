"""Where equilibria meet.

Between consecutive points their number is constant, at a point it changes as its kind says.
"""
from fractions import Fraction
from itertools import pairwise

import oracle
import pytest
from equilibria.meetings import FIELD, STEP, k3, near, numbers_of, omega, tilts
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign
from gyrostat.equilibria.continuation.meeting_equations import bifurcations
from gyrostat.equilibria.continuation.meeting_values import bifurcation_points
from gyrostat.notation import jet, jet_name


def slope_at(kind, values):
    """What vanishes on E3 at a rate, or on the precessions of a level, as coefficients."""
    potential = [Fraction(0), *(values[f"a{n}"] for n in range(1, 6))]
    if kind == "rate":
        return oracle.rate_slope(values["I1"], values["I3"], values["l"], values["omega"], potential)
    return oracle.level_slope(values["I1"], values["pi3_0"] + values["l"], values["C1"], potential)


def count(kind, values):
    """The number between the poles, by Sturm's theorem."""
    return oracle.count_roots(slope_at(kind, values), -1, 1)


def groups(points):
    """The values, each with the kinds of what happens there, in order."""
    found = {}
    for p in points:
        found.setdefault(near(p.value), []).append(p.kind)
    assert list(found) == sorted(found)
    return list(found.items())


RATE = [("cubic", "l", Fraction(3, 4)), ("quartic", "l", -2), ("oblate", "omega", None),
        ("cubic", "a1", 1), ("quartic", "a2", Fraction(5, 4)), ("quintic", "I1", 2), ("quartic", "I3", 2)]
LEVEL = [("cubic", "C1", 1), ("oblate", "pi3_0", Fraction(1, 5)), ("cubic", "l", Fraction(3, 2)),
         ("cubic", "a1", 1), ("quartic", "a3", 2), ("oblate", "I1", Fraction(1, 2))]


def cases(*named):
    """Kind, the values given, the free name; those that are not named in the slow run only."""
    for case in every_case():
        yield case if case.id in named else pytest.param(*case.values, id=case.id, marks=pytest.mark.slow)


def every_case():
    for field, name, rate in RATE:
        values = numbers_of(field) | ({"omega": Fraction(rate)} if rate is not None else {})
        yield pytest.param("rate", {n: x for n, x in values.items() if n != name}, name,
                           id=f"rate-{field}-{name}")
    for field, name, level in LEVEL:
        values = numbers_of(field) | {"pi3_0": Fraction(1), "C1": Fraction(level)}
        if name == "C1":
            # and not −l: the middle of a gap is not to be on the level of a pole
            values["pi3_0"] = Fraction(level)
        yield pytest.param("level", {n: x for n, x in values.items() if n != name}, name,
                           id=f"level-{field}-{name}")


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "values", "name"), list(cases(
    "rate-quartic-l", "rate-oblate-omega", "rate-quintic-I1", "level-cubic-C1", "level-cubic-a1")))
def test_all_points_are_found(quintic, kind, values, name):
    """The number of E3, or of precessions, is constant between the points.

    It changes by 1 where E3 leaves a pole, by 2 at a fold.

    Sturm's theorem counts at six fractions of each gap, two of them 10⁻¹⁵ from its ends; the branches agree
    in the middle. On a level with C1 = ±(π3 + l) a precession is replaced by E1 or E2: fractions are not
    taken there.
    """
    found = groups(bifurcation_points(quintic, name, values))
    positive, places = name in ("I1", "I3"), [value for value, _ in found]
    edges = [Fraction(0) if positive else min([Fraction(0), *places]) - 40, *places,
             max([Fraction(0), *places]) + 40]
    gaps = []
    for a, b in pairwise(edges):
        inside = [a + (b - a) * Fraction(n, 11) for n in (1, 4, 6, 9)] + [
            a + Fraction(1, 10**15),
            b - Fraction(1, 10**15),
        ]
        counts = {count(kind, values | {name: x}) for x in inside}
        assert len(counts) == 1
        assert len(tilts(quintic, values | {name: (a + b) / 2})) in counts
        gaps += counts
    for (_, kinds), before, after in zip(found, gaps, gaps[1:]):
        steps = [STEP[k] for k in kinds]
        assert abs(before - after) == steps[0] if len(steps) == 1 else abs(before - after) <= sum(steps)


@pytest.mark.few(1)
@pytest.mark.parametrize(("kind", "values", "name"), [c for c in every_case() if c.id in (
    "rate-cubic-l", "rate-quartic-l", "rate-oblate-omega", "level-cubic-C1")])
def test_the_equations_vanish(quintic, kind, values, name):
    """Each equation of the kind, with the derivatives of U at the k3 of the point: exactly 0.

    Poles at k3 = ±1, folds between them.
    """
    of_kind = {b.kind: b for b in bifurcations(quintic)}
    points = bifurcation_points(quintic, name, values)
    assert points
    for point in points:
        b = of_kind[point.kind]
        numbers = {gs.symbol(n): Rational(x.numerator, x.denominator) for n, x in values.items()}
        numbers |= {gs.symbol(name): point.value, k3: point.k3}
        assert point.name == name
        assert sign(1 - k3**2, numbers) == (b.at == k3)
        assert (b.at == k3 or b.at == point.k3)
        P, v = gs.symbol("pi3_0") + gs.symbol("l"), gs.symbol("C1")
        rate = (v - P * k3) / (gs.symbol("I1") * (1 - k3**2))
        for equation in b.equations:
            jets = {d: FIELD.diff(k3, jet(d.name)[0]) for d in equation.free_symbols if jet(d.name)}
            placed = equation.xreplace(jets)
            if kind == "level":
                placed = placed.xreplace({omega: rate, gs.symbol("p_psi"): P})
            assert sign(placed, numbers) == 0


@pytest.mark.few(1)
@pytest.mark.parametrize(("kind", "values", "name"), [
    c for c in cases("rate-quartic-l", "level-cubic-C1") if c.id in (
        "rate-quartic-l", "rate-quartic-a2", "rate-quintic-I1", "level-cubic-C1", "level-cubic-a1")])
def test_stability_at_a_fold(quintic, kind, values, name):
    """The two that meet: at a fixed rate alike, on a level one stable and one unstable.

    Others are as on the other side.
    """
    folds = [p for p in bifurcation_points(quintic, name, values) if p.kind.startswith("fold")]
    assert folds
    for point in folds:
        value, step = near(point.value), Fraction(1, 10**8)
        sides = sorted((tilts(quintic, values | {name: value + s * step}) for s in (1, -1)), key=len)
        assert len(sides[1]) == len(sides[0]) + 2
        pair = sorted(sides[1], key=lambda b: abs(b.place["k3"].evalf(30) - point.k3.evalf(30)))[:2]
        # of the order of the root of the step
        assert all(abs(b.place["k3"].evalf(30) - point.k3.evalf(30)) < 1e-2 for b in pair)
        verdicts = {b.decision.verdict.name for b in pair}
        assert verdicts == {"STABLE", "UNSTABLE"} if kind == "level" else len(verdicts) == 1
        others = [b.decision.verdict for b in sides[1] if b not in pair]
        assert others == [b.decision.verdict for b in sides[0]]


@pytest.mark.parametrize("field", ["cubic", "quartic"])
def test_what_vanishes_at_a_fold_on_a_level_is_the_margin(quintic, field):
    """On the precessions of a level its first equation vanishes, and its second is positive exactly where
    they are stable.
    """
    (b,) = [b for b in bifurcations(quintic) if b.kind == "fold on a level"]
    values = numbers_of(field) | {"pi3_0": Fraction(-1), "C1": Fraction(1, 4)}
    found = tilts(quintic, values)
    for branch in found:
        numbers = {gs.symbol(n): Rational(x.numerator, x.denominator)
                   for n, x in values.items()} | {k3: branch.place["k3"], omega: branch.rates["omega"]}
        jets = {gs.symbol(jet_name(n)): FIELD.diff(k3, n) for n in (1, 2)}
        first, second = (e.xreplace(jets).xreplace({gs.symbol("p_psi"): gs.symbol("pi3_0") + gs.symbol("l")})
                         for e in b.equations)
        assert sign(first, numbers) == 0
        assert sign(second, numbers) == (1 if branch.decision.verdict.name == "STABLE" else -1)
    assert found
