"""A condition solved for one parameter with numbers for the others: intervals with exact ends."""
from fractions import Fraction

import pytest
from parameters.solved import BODY, POSITIVE, reports, truth
from sympy import Rational, oo, pi, sin, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.algebra.solving.roots import between
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.parameters.sets import INCLUDED, Interval
from gyrostat.parameters.stabilizing_set import stabilizing_set

POLYNOMIAL = gs.assemble(BODY, gs.axial_potential(lambda z: z**5 - z**3 + z**2 / 7 + z / 10))
NUMERIC = [("E1", gs.upright, "l", {"I1": 2, "pi3_0": 1}), ("E1", gs.upright, "I1", {"l": 2, "pi3_0": 1}),
           ("E2", gs.hanging, "pi3_0", {"I1": 2, "l": 1}),
           ("E3", gs.inclined, "omega", {"I1": 2, "I3": 1, "k3": "1/3"}),
           ("E3", gs.inclined, "k3", {"I1": 2, "I3": 1, "omega": "1/3"}),
           ("E3", gs.inclined, "I3", {"I1": 2, "omega": "1/3", "k3": "1/2"})]


@pytest.mark.few(1)
@pytest.mark.parametrize(("label", "family", "name", "values"), NUMERIC)
def test_numbers_give_intervals_with_exact_ends(label, family, name, values):
    """For a polynomial U of degree 5.

    The verdict on a fine grid, at every end, and just inside and outside.
    """
    report = gs.analyze(family(POLYNOMIAL))
    solution = stabilizing_set(report, name, values)
    tiny = Fraction(1, 10**12)
    ends = [e for p in solution.parts for c in p.cases for i in c.intervals
            for e in (i.low, i.high) if e not in (oo, -oo)]
    for x in [Fraction(n, 8) for n in range(-32, 33)] + [e + d for e in ends for d in (-tiny, 0, tiny)]:
        if name in POSITIVE and sign_of_constant(exact_number(x)) != 1:
            continue
        assert solution.contains(values | {name: x}) is truth(report, values | {name: x}), x


@pytest.mark.slow
def test_rotor_of_a_tilt_along_the_family():
    """E3 solved for l with k3 free.

    The map k3 → l is monotone on each run, and the stable tilts are exactly those of the runs.
    """
    report = gs.analyze(gs.inclined(POLYNOMIAL))
    values = {"I1": 2, "I3": 1, "omega": "1/3"}
    (part,) = stabilizing_set(report, "l", values).parts
    runs = part.cases[0].intervals
    rotor = lambda z: 3 * (5 * z**4 - 3 * z**2 + 2 * z / 7 + Fraction(1, 10)) + z / 3  # noqa: E731      U'/ω + ω k3 (I1 − I3)
    for n in range(-40, 41):
        z = Fraction(n, 41)
        inside = [i for i in runs if sign_of_constant((exact_number(z) - i.tilt[0])
                                                      * (i.tilt[1] - exact_number(z))) == 1]
        assert bool(inside) is truth(report, values | {"k3": z}) and len(inside) <= 1
        for i in inside:
            assert (
                sign_of_constant(exact_number(rotor(z)) - i.low)
                == 1
                == sign_of_constant(i.high - exact_number(rotor(z)))
            )
    for i in runs:
        for k, included in ((i.tilt[0], i.low_if), (i.tilt[1], i.high_if)):
            assert (included == INCLUDED) is (k not in (1, -1) and truth(report, values | {"k3": k}))
    samples = sorted((float(i.tilt[0]), float(i.tilt[1]), float(i.low), float(i.high)) for i in runs)
    for a, b, low, high in samples:
        path = [rotor(a + (b - a) * t / 50) for t in range(51)]
        assert path == sorted(path) and abs(path[0] - low) < 1e-9 > abs(path[-1] - high)


def test_some_numbers_are_put_in_their_places():
    """With numbers for some names the closed form is that of all names, at those numbers."""
    some, rest = {"I1": 2, "m1": "1/3"}, {"I3": "1/2", "m0": "5/3", "pi3_0": "-1/2"}
    report = reports("U2")["E1"]
    partly, wholly = stabilizing_set(report, "l", some), stabilizing_set(report, "l")
    assert not {s.name for p in partly.parts for c in p.cases for e, _ in c.when
                for s in e.free_symbols} & some.keys()
    for l in range(-8, 9):
        assert (
            partly.contains({**rest, "l": l})
            is wholly.contains({**some, **rest, "l": l})
            is truth(report, {**some, **rest, "l": l})
        )


TIED = [("U1", "k3", {"l": 1, "omega": 1}, []), ("U1", "omega", {"l": 1, "k3": 0}, [3]),
        ("U1", "l", {"k3": 0, "omega": 1}, [3]),
        ("quartic", "k3", {"l": 0, "omega": "1/2"}, ["-sqrt(3)/4", "sqrt(3)/4"]),
        ("quartic", "I1", {"l": 0, "omega": "1/2", "k3": "1/2"}, [1]),
        ("quartic", "l", {"k3": "1/2", "omega": "1/2"}, ["1/4"]),
        ("quartic", "omega", {"l": 0, "k3": "1/4"}, ["-sqrt(3)/2", "sqrt(3)/2"])]


@pytest.mark.few(5)
@pytest.mark.parametrize(("field", "name", "values", "expected"), TIED)
def test_a_relation_leaves_points(field, name, values, expected):
    """E3 with its relation fully given.

    The points of the family that are stable, nothing where there is none.
    """
    U = gs.uniform_field() if field == "U1" else gs.axial_potential(lambda z: z**4 - z**2 / 2)
    report = gs.analyze(gs.inclined(gs.assemble(BODY, U)))
    values = {"I1": 2, "I3": 1, **({"m0": 3} if field == "U1" else {}), **values}
    values = {n: x for n, x in values.items() if n != name}
    solution = stabilizing_set(report, name, values)
    ends = [i.low for p in solution.parts for c in p.cases for i in c.intervals]
    assert ends == [exact_number(x) for x in expected]
    assert all(truth(report, values | {name: x}) for x in expected)
    assert all(i.low == i.high and i.low_if == INCLUDED for p in solution.parts for c in p.cases
               for i in c.intervals)


def test_a_pole_of_the_family_is_an_infinite_end():
    """a = (ω l − …)/(3 k3²) grows without bound towards k3 = 0."""
    a, b = map(gs.symbol, "ab")
    report = gs.analyze(gs.inclined(gs.assemble(BODY, gs.axial_potential(lambda z: a * z**3 + b * z)),
                                    eliminate="a"))
    (part,) = stabilizing_set(report, "a", {"I1": 2, "I3": 1, "b": 1, "omega": 1, "l": 5}).parts
    (_, run) = part.cases[0].intervals
    assert (run.low, run.high, run.tilt) == (1, oo, (1, 0))


def test_transcendental_numbers_are_solved_in_closed_form():
    """I1 = π: l ≤ −2 √π or l ≥ 2 √π."""
    solution = stabilizing_set(reports("U1")["E1"], "l", {"I1": "pi", "m0": 1, "pi3_0": 0})
    assert [solution.contains({"l": l}) for l in (3, "2*sqrt(pi)", "3.6", -4)] == [False, True, True, True]


def test_a_number_between_two_that_are_very_near():
    """Ends that differ by less than a double resolves: 10⁻²⁵, and a surd beside its 40 digits."""
    near = [(exact_number("1/3"), exact_number("1/3") + exact_number(Fraction(1, 10**25))),
            (exact_number("1.4142135623730950488016887242096980785696"), exact_number("sqrt(2)"))]
    for a, b in near:
        assert a < between(a, b) < b


@pytest.mark.slow
@pytest.mark.parametrize(("moment", "rotor"),
                         [(1, sqrt(3)), (sqrt(5), sqrt(2)), (2 ** Rational(1, 4), sqrt(2) + sqrt(3)),
                                               (sqrt(pi), sin(1)), (2 ** Rational(1, 12), sqrt(6))])
def test_numbers_that_are_not_rational_lose_no_part_of_a_set(moment, rotor):
    """The third minor and its square, the fourth, are one condition whatever numbers are in them.

    (π3 + l)² ≥ ∓4 I1 m0.
    """
    body = gs.Gyrostat((moment, moment, 1), (0, 0, rotor))
    report = gs.analyze(gs.hanging(gs.assemble(body, gs.axial_potential(lambda z: gs.symbol("m0") * z))))
    (part,) = stabilizing_set(report, "pi3_0").parts
    ends = {case.when[0][1]: case.intervals for case in part.cases}
    assert ends[">"] == (Interval(-oo, oo),) and len(ends["<"]) == 2
    distance = (ends["<"][0].high + rotor).subs(gs.symbol("m0"), -1)
    assert abs((distance**2 - 4 * moment).evalf(50)) < 1e-40
