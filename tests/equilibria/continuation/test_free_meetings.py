"""Where permanent rotations meet, along any name: complete, exact, and named."""
import random
from fractions import Fraction as F
from itertools import pairwise

import counted_rotations as found
import pytest
from slow import sampled
from small_circle import is_extremum
from sympy import Rational, S, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.balls import ball, fraction_of
from gyrostat.errors import ScopeError, ValuesError

NAMES = ("I1", "I2", "I3", "l1", "l2", "l3")
BOX = gs.assemble(gs.Gyrostat())


def fraction(value):
    return F(int(value.p), int(value.q))


def near(value):
    return fraction_of(ball(value, 128).mid())


def count(values):
    """Of a fraction for each name and M."""
    inertia, rotor = ([values[name] for name in names] for names in (NAMES[:3], NAMES[3:]))
    return found.count(inertia, rotor, values["M"])


def drawn(rnd, empty):
    values = {name: F(rnd.randint(50, 300), 100) for name in NAMES[:3]}
    values |= {name: F(rnd.choice([-1, 1]) * rnd.randint(5, 90), 100) for name in NAMES[3:]} | {"M": F(1)}
    for name in rnd.sample(NAMES[3:], empty):
        values[name] = F(0)
    name = rnd.choice([n for n in (*NAMES, "M") if values[n]] or ["M"])
    return name, {n: Rational(x.numerator, x.denominator) for n, x in values.items() if n != name}


def cases(kinds, number):
    for empty in kinds:
        yield pytest.param(empty, number, id=f"{empty}-{number}")
        yield pytest.param(empty, 200, id=f"{empty}-200", marks=pytest.mark.slow)


@pytest.mark.slow
@pytest.mark.parametrize(("empty", "number"), list(cases((0, 1, 2), 3)))
def test_their_number_changes_there_alone(empty, number, full):
    """Sturm's theorem counts as many rotations at five fractions of each gap between the values, two of them
    beside its ends.

    At a value the number changes by two for each fold and each pitchfork. The number of components of the
    rotor that are 0 is given.
    """
    rnd = random.Random(f"meetings {empty} {number}")
    for _ in range(sampled(number, full, 15)):
        name, values = drawn(rnd, empty)
        points = gs.bifurcation_points(BOX, name, values)
        at = list(dict.fromkeys(near(point.value) for point in points))
        assert at == sorted(at)
        low, high = (F(1, 100), F(9)) if name in ("M", *NAMES[:3]) else (F(-9), F(9))
        at = [value for value in at if low < value < high]
        gaps = []
        for a, b in pairwise([low, *at, high]):
            parts = (F(1, 10**9), F(1, 5), F(4483, 9001), F(7, 9), 1 - F(1, 10**9))
            given = {n: fraction(x) for n, x in values.items()}
            numbers = {count({**given, name: a + (b - a) * part}) for part in parts}
            assert len(numbers) == 1, (name, values, a, b)
            gaps.append(numbers.pop()[0])
        for value, before, after in zip(at, gaps, gaps[1:]):
            here = [point.kind for point in points if near(point.value) == value]
            met = [kind for kind in here if kind in ("fold", "pitchfork")]
            assert abs(after - before) == 2 * len(met), (name, values)
            # two moments are equal, there or everywhere, and carry no rotor
            assert {kind.split()[0] for kind in here} - {*met} <= {"circle"}


def test_a_rotor_along_an_axis():
    """abs(l)/M = abs(1 − I3/Ij): the rotation about axis 3 against l meets those of axis j."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    points = gs.bifurcation_points(scene, "l", {"M": 2})
    assert [(point.kind, point.value, point.nu, point.momentum) for point in points] == [
        ("pitchfork", -4, 1, (0, 0, 2)), ("pitchfork", -1, Rational(1, 2), (0, 0, 2)),
        ("pitchfork", 1, Rational(1, 2), (0, 0, -2)), ("pitchfork", 4, 1, (0, 0, -2))]
    assert all(point.k3 is None and point.name == "l" for point in points)
    assert str(points[0]) == "pitchfork at l = −4, ν = 1"


def test_each_is_a_degenerate_rotation():
    """At a rational value the rotation is found with Δ = 0, and decided as 60 digits of the energy say."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (gs.symbol("l1"), 0, "3/10")))
    pitchforks = [p for p in gs.bifurcation_points(scene, "l1", {"M": 1}) if p.kind == "pitchfork"]
    assert [(p.value, p.nu) for p in pitchforks] == [(Rational(-2, 5), Rational(1, 2)),
                                                     (Rational(2, 5), Rational(1, 2))]
    for point in pitchforks:
        rotor = (point.value, S.Zero, Rational(3, 10))
        free = gs.assemble(gs.Gyrostat((1, 2, 3), rotor))
        (met,) = [p for p in gs.relative_equilibria(free, {"M": 1}) if p.momentum == point.momentum]
        held = is_extremum((F(1), F(2), F(3)), [fraction(l) for l in rotor],
                           [fraction(m) for m in point.momentum])
        assert met.form.signs[-1] == 0 and met.decision.verdict is gs.Verdict.of(held)


@pytest.mark.few(1)
@pytest.mark.parametrize(("body", "values", "kinds"), [
    (((1, 1, 2), (0, 0, "l")), {"M": 1}, [("circle leaves an axis", -1), ("circle leaves an axis", 1)]),
    (((1, 1, 2), ("l", 0, 0)), {"M": 1}, [("pitchfork", Rational(-1, 2)), ("circle at this value alone", 0),
                                          ("pitchfork", Rational(1, 2))]),
    (((2, 2, 2), (0, "l", 0)), {"M": 3}, [("sphere at this value alone", 0)]),
    (((1, 1, 2), ("1/5", "1/5", "l")), {"M": 3}, None),
    (((2, 2, "a"), ("3/5", 0, 0)), {"M": 1}, [("pitchfork", Rational(5, 4)), ("pitchfork", 5)])])
def test_equal_moments(body, values, kinds):
    """Circles and the sphere of equilibria begin, or are there at one value alone."""
    scene = gs.assemble(gs.Gyrostat(*body))
    points = gs.bifurcation_points(scene, "a" if "a" in body[0] else "l", values)
    if kinds is None:
        assert {point.kind for point in points} == {"fold"} and len(points) == 2
    else:
        assert [(point.kind, point.value) for point in points] == kinds


def test_an_umbilic_is_named():
    """d = 1/I − ν = (1, −1/4, 0), M = (2, 1, 0): both coefficients of the energy vanish."""
    M, nu, d = (2, 1, 0), 1, (S.One, Rational(-1, 4), S.Zero)
    moments = [1 / (x + nu) for x in d]
    rotor = [(1 - nu * i) * m for i, m in zip(moments, M)]
    scene = gs.assemble(gs.Gyrostat(moments, [rotor[0], gs.symbol("l2"), rotor[2]]))
    points = [p for p in gs.bifurcation_points(scene, "l2", {"M": "sqrt(5)"}) if p.value == rotor[1]]
    assert ("umbilic", tuple(M)) in [(point.kind, point.momentum) for point in points]


def test_a_tensor_has_those_of_its_principal_axes():
    """Turned by the rotation that takes axis 1 to (1, 2, 2)/3."""
    R = [[Rational(n, 3) for n in row] for row in ((1, -2, 2), (2, -1, -2), (2, 2, 1))]
    moments, rotor = (1, 2, 3), (0, Rational(1, 5), Rational(3, 10))
    tensor = [[sum(R[i][n] * moments[n] * R[j][n] for n in range(3)) for j in range(3)] for i in range(3)]
    turned = [sum(R[i][n] * rotor[n] for n in range(3)) for i in range(3)]
    ours, theirs = (gs.bifurcation_points(gs.assemble(gs.Gyrostat(*body)), "M", {})
                    for body in ((tensor, turned), (moments, rotor)))
    assert [(p.kind, p.value, p.nu) for p in ours] == [(p.kind, p.value, p.nu) for p in theirs]
    assert "pitchfork" in {p.kind for p in ours}


@pytest.mark.parametrize(("name", "values", "error", "words"), [
    ("l", {"I1": 1, "I2": 2, "I3": 3, "l1": 0, "l2": 0, "l3": 0, "M": 1}, ValuesError,
     "no parameter l: did you"),
    ("l1", {"I1": 1, "I2": 2, "I3": 3, "l1": 0, "l2": 0, "l3": 0, "M": 1}, ValuesError, "leave out one"),
    ("l1", {"I1": 1, "I2": 2, "I3": 3, "l2": 0, "l3": 0}, ValuesError, "need M: give"),
    ("l1", {"I1": 1, "I2": 2, "I3": 3, "l2": 0, "l3": 0, "M": 0}, ValuesError, "that is positive"),
    ("l1", {"I1": 1, "I2": 2, "I3": 3, "l2": "pi", "l3": 0, "M": 1}, ScopeError, "meet are not found")])
def test_what_is_refused(name, values, error, words):
    """What was given, why it is impossible, what to do."""
    with pytest.raises(error, match=words):
        gs.bifurcation_points(BOX, name, values)


def test_the_length_may_be_a_root():
    """M = √5."""
    values = {"I1": 1, "I2": 2, "I3": 3, "l1": 0, "l2": 0, "M": sqrt(5)}
    assert [p.value for p in gs.bifurcation_points(BOX, "l3", values)] == [
        -2 * sqrt(5), -sqrt(5) / 2, sqrt(5) / 2, 2 * sqrt(5)]
