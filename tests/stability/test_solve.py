"""A condition solved for one parameter.

The set contains a value exactly where the equilibrium exists and its verdict is STABLE.
"""
import random
from fractions import Fraction
from functools import cache, partial

import oracle
import pytest
from slow import slow
from sympy import CRootOf, Rational, oo, pi, sin, sqrt

import gyrostat as gs
from gyrostat.algebra.exact import Point, evaluate, sign_of_constant
from gyrostat.algebra.numbers import exact_number
from gyrostat.algebra.roots import between
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.printing.results import result_blocks
from gyrostat.printing.text import text
from gyrostat.stability.report import Verdict
from gyrostat.stability.sets import EXCLUDED, INCLUDED, Interval
from gyrostat.stability.solve import solve_condition
from gyrostat.stability.stabilizing import stabilizing_set

BODY, k3 = gs.symmetric_gyrostat(), gs.symbol("k3")
POSITIVE = ("I1", "I3", "mass1", "mass3", "p0", "r")
FIELDS = {"U1": gs.uniform_field(), "U2": gs.newtonian_field(2), "U3": gs.newtonian_field(3),
          "fluid": gs.ideal_fluid(),
          "square": gs.axial_potential(lambda z: gs.symbol("a") ** 2 * z),
          "bowl": gs.axial_potential(lambda z: gs.symbol("a") ** 2 * z - (z - 1) ** 2),
          "quartic": gs.axial_potential(lambda z: (gs.symbol("b") * gs.symbol("a") ** 2
                                                   - gs.symbol("a") ** 4) * z
                                        + gs.symbol("c") * (z - 1) ** 2),
          "product": gs.axial_potential(lambda z: gs.symbol("a") * gs.symbol("b") ** 2 * gs.symbol("c") * z),
          "exp": gs.axial_potential(lambda z: gs.symbol("a") * z**2 - gs.symbol("b") * z**5)}


@cache
def reports(field):
    scene = gs.assemble(BODY, FIELDS[field])
    return {"E1": gs.analyze(gs.upright(scene)), "E2": gs.analyze(gs.hanging(scene, spin="omega3_0")),
            "E3": gs.analyze(gs.inclined(scene))}


@cache
def tilt_solved(field):
    return gs.analyze(gs.inclined(gs.assemble(BODY, FIELDS[field]), eliminate="k3"))


def truth(report, values):
    """Whether the equilibrium exists there and is stable."""
    try:
        verdict = report.verdict(values).verdict
    except ValuesError:
        return False
    assert verdict is not Verdict.UNDECIDED
    return verdict is Verdict.STABLE


def ends_at(solution, values):
    """The ends of all intervals of the cases that hold at the values of the other names."""
    numbers = Point({gs.symbol(n): exact_number(x, n) for n, x in values.items() if n != solution.name})
    compare = {">": (1,), "<": (-1,), "=": (0,), "!=": (1, -1)}
    for part in solution.parts:
        for case in part.cases:
            if any(gs.symbol(solution.name) in e.free_symbols for e, _ in case.when):
                continue
            if all(sign_of_constant(evaluate(e, numbers)) in compare[relation] for e, relation in case.when):
                for interval in case.intervals:
                    values_of = (evaluate(end, numbers)
                                 for end in (interval.low, interval.high) if end not in (oo, -oo))
                    yield from (end for end in values_of if end.is_finite)


def drawn(draw, names):
    number = lambda: Fraction(draw.randint(-12, 12), draw.choice((1, 1, 2, 3)))  # noqa: E731
    values = {n: abs(number()) or Fraction(1) if n in POSITIVE else number() for n in names}
    return values | {n: Fraction(draw.randint(-8, 8), 9) for n in names if n == "k3"}


@pytest.mark.parametrize(("field", "label", "name"), [
    ("U1", "E1", "l"), ("U3", "E1", "pi3_0"), ("fluid", "E1", "l"), ("exp", "E1", "l"), ("U1", "E2", "l"),
    ("fluid", "E2", "omega3_0"), ("U1", "E1", "m0"), ("U2", "E1", "m1"), ("U2", "E1", "I3"),
    ("U1", "E3", "omega"), ("square", "E1", "a"), ("product", "E1", "a"), ("U1", "tilt", "l"),
    *slow(*((field, "E1", "l") for field in ("U2", "U3")),
          *((field, "E1", "pi3_0") for field in ("U1", "U2", "fluid", "exp")),
          ("U1", "E2", "omega3_0"), ("U2", "E2", "l"), ("U2", "E2", "omega3_0"), ("fluid", "E2", "l"),
          ("U2", "E1", "m0"), ("U1", "E1", "I1"), ("U3", "E1", "J3"),
          ("U2", "E3", "omega"), ("U2", "E3", "m0"), ("U2", "E3", "m1"), ("fluid", "E3", "omega"),
          ("bowl", "E1", "a"), ("quartic", "E1", "a"), ("product", "E1", "c"),
          ("U2", "tilt", "l"), ("U1", "tilt", "m0"), ("U2", "tilt", "m0"))])
def test_closed_form_is_the_verdict(field, label, name):
    """At random numbers, with I1 = I3 and P = 0 among them, and exactly at every end."""
    report = tilt_solved(field) if label == "tilt" else reports(field)[label]
    solution, draw, ends, inside = stabilizing_set(report, name), random.Random(name + label + field), 0, 0
    names = [n for n in report.parameters if n in report.required or n == name]
    names = [n for n in dict.fromkeys([*names, *_of_boundary(report)]) if n != report.equilibrium.eliminated]
    for n in range(60):
        values = drawn(draw, names)
        if n % 4 == 1 and {"I1", "I3"} <= values.keys():
            values["I3"] = values["I1"]
        if n % 4 == 2 and {"l", "pi3_0"} <= values.keys():
            values["l"] = -values["pi3_0"]
        if n % 5 == 0:
            values |= {s: Fraction(draw.randint(-1, 1)) for s in ("a", "b") if s in values}
        if n % 4 == 3 and "m0" in values:
            values["m0"] = Fraction(draw.randint(-1, 1))
        assert solution.contains(values) is truth(report, values), values
        inside += truth(report, values)
        for end in list(ends_at(solution, values))[:4] if n < 24 else []:
            if sign_of_constant(end) == 1 or name not in POSITIVE:
                ends += 1
                assert solution.contains(values | {name: end}) is truth(report, values | {name: end}), (
                    values,
                    end,
                )
    assert inside and (ends > 5 or (field, label) == ("U1", "E3"))


def _of_boundary(report):
    margins = (report.boundary.rung(power).condition.margin
               for power in range(3, (report.boundary.last or 3) + 1))
    return {s.name for margin in margins for s in margin.free_symbols}


def test_an_end_that_is_not_stable_is_no_point():
    """U = a² k3 − (k3 − 1)²: at P = 0 only a = 0 is on the boundary, and there it is unstable."""
    (part,) = stabilizing_set(reports("bowl")["E1"], "a").parts
    assert [case.intervals for case in part.cases if len(case.when) == 1 and case.when[0][1] == "="] == [()]


def test_a_root_in_a_symbol_of_ours():
    """A tilt given as a root of a polynomial in k3: the variable inside is not the k3 outside."""
    root = CRootOf(9 * k3**3 - 3 * k3 + 1, 0)
    report = reports("U2")["E3"]
    values = {"I1": 2, "I3": 1, "m0": 1, "m1": "1/3", "k3": root}
    solution = stabilizing_set(report, "omega", values)
    for omega in (Fraction(1, 3), 1, 2):
        assert solution.contains(values | {"omega": omega}) is truth(report, values | {"omega": omega})


def test_rumiantsev_solved_for_the_rotor():
    """Which l stabilises the upright heavy gyrostat: abs(π3 + l) ≥ 2 √(I1 m0), the ends included.

    L ≠ −π3 at m0 = 0; every l below.
    """
    (part,) = stabilizing_set(reports("U1")["E1"], "l").parts
    below, at, above = part.cases
    m0, I1, pi3 = map(gs.symbol, ("m0", "I1", "pi3_0"))
    assert [case.when for case in part.cases] == [((m0, "<"),), ((m0, "="),), ((m0, ">"),)]
    assert [(i.low, i.high) for i in below.intervals] == [(-oo, oo)]
    assert [(i.high, i.high_if) for i in at.intervals[:1]] == [(-pi3, EXCLUDED)]
    outer = [(i.low, i.low_if, i.high, i.high_if) for i in above.intervals]
    assert outer == [(-oo, EXCLUDED, -pi3 - 2 * (I1 * m0) ** Fraction(1, 2), INCLUDED),
                     (-pi3 + 2 * (I1 * m0) ** Fraction(1, 2), INCLUDED, oo, EXCLUDED)]


def test_heavy_tilt_exists_for():
    """E3 in U = m0 k3 for abs(ω l − m0) < ω² abs(I1 − I3), always stable: the ends, E1 and E2, left out."""
    *fixed, part, always = stabilizing_set(tilt_solved("U1"), "l").parts
    assert {p.meaning for p in (*fixed, part)} == {"exists"} and len(part.cases) == 1
    assert always.meaning == "stable"
    assert [(i.low, i.high) for c in always.cases for i in c.intervals] == [(-oo, oo)]
    ((interval,),) = (case.intervals for case in part.cases)
    values = {gs.symbol(n): exact_number(x) for n, x in {"I1": 2, "I3": 5, "omega": -2, "m0": 3}.items()}
    assert (evaluate(interval.low, values), evaluate(interval.high, values)) == (
        Fraction(-15, 2),
        Fraction(9, 2),
    )
    assert interval.low_if == interval.high_if == EXCLUDED


POLYNOMIAL = gs.assemble(BODY, gs.axial_potential(lambda z: z**5 - z**3 + z**2 / 7 + z / 10))
NUMERIC = [("E1", gs.upright, "l", {"I1": 2, "pi3_0": 1}), ("E1", gs.upright, "I1", {"l": 2, "pi3_0": 1}),
           ("E2", gs.hanging, "pi3_0", {"I1": 2, "l": 1}),
           ("E3", gs.inclined, "omega", {"I1": 2, "I3": 1, "k3": "1/3"}),
           ("E3", gs.inclined, "k3", {"I1": 2, "I3": 1, "omega": "1/3"}),
           ("E3", gs.inclined, "I3", {"I1": 2, "omega": "1/3", "k3": "1/2"})]


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


@pytest.mark.parametrize(("call", "error", "why"), [
    (lambda: stabilizing_set(reports("U1")["E1"], "mass"), ValuesError, "no parameter mass"),
    (lambda: stabilizing_set(reports("U1")["E1"], "l", {"l": 1}), ValuesError, "leave out one"),
    (lambda: stabilizing_set(reports("U2")["E1"], "I1"), ScopeError, "positive: give numbers"),
    (lambda: stabilizing_set(reports("U1")["E3"], "l", {"I1": 1}), ScopeError,
     "ties l .* while k3, omega are open"),
    (lambda: stabilizing_set(reports("U1")["E3"], "m0", {"l": 1, "I1": 1}), ScopeError, "or leave out l"),
    (lambda: stabilizing_set(reports("U1")["E1"], "l").contains({"I1": 1, "m0": 1, "pi3_0": 2}), ValuesError,
     "a set of l"),
    (lambda: stabilizing_set(reports("U1")["E1"], "l").contains({"I1": -1, "m0": 1, "pi3_0": 2, "l": 1}),
     ValuesError, "positive"),
    (lambda: stabilizing_set(reports("U3")["E3"], "k3"), ScopeError, "degree"),
    (lambda: stabilizing_set(reports("U1")["E1"], "l").contains({"l": 1}), ValuesError, "needs"),
    (lambda: stabilizing_set(gs.analyze(gs.upright(gs.assemble(BODY,
                                                               gs.axial_potential(gs.symbol("k3") ** 3)))),
                             "l",
                             {"I1": 1, "pi3_0": -2}), None, "")])
def test_what_is_not_solved_is_said(call, error, why):
    """Unknown names, a form beyond those solved, missing numbers."""
    if error is None:
        assert call().contains({"l": 100, "I1": 1, "pi3_0": -2})
        return
    with pytest.raises(error, match=why):
        call()


TIED = [("U1", "k3", {"l": 1, "omega": 1}, []), ("U1", "omega", {"l": 1, "k3": 0}, [3]),
        ("U1", "l", {"k3": 0, "omega": 1}, [3]),
        ("quartic", "k3", {"l": 0, "omega": "1/2"}, ["-sqrt(3)/4", "sqrt(3)/4"]),
        ("quartic", "I1", {"l": 0, "omega": "1/2", "k3": "1/2"}, [1]),
        ("quartic", "l", {"k3": "1/2", "omega": "1/2"}, ["1/4"]),
        ("quartic", "omega", {"l": 0, "k3": "1/4"}, ["-sqrt(3)/2", "sqrt(3)/2"])]


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


@pytest.mark.parametrize("name", ["l", "I2", "omega3_0"])
def test_a_free_body_in_closed_form(name):
    """Rotation about axis 3 with l along it.

    The set is that of the verdicts, ends included as the fourth order says.
    """
    report = gs.analyze(
        gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))), 3)
    )
    solution, draw = stabilizing_set(report, name), random.Random(name)
    for n in range(60):
        values = {s: Fraction(draw.randint(1, 4)) for s in ("I1", "I2", "I3")}
        values |= {s: Fraction(draw.randint(-3, 3)) for s in ("l", "omega3_0")}
        if n % 2:
            values["l"] = (values[("I1", "I2")[n % 4 // 2]] - values["I3"]) * values["omega3_0"]
        assert solution.contains(values) is truth(report, values), values


def test_where_the_margin_is_zero_all_along():
    """U = k3 + a (k3 − 1)², P² = 4 I1: on the boundary for every a, stable for a ≥ −1/2.

    I2 of a free body with f1 = 0 likewise.
    """
    report = gs.analyze(
        gs.upright(gs.assemble(BODY, gs.axial_potential(lambda z: z + gs.symbol("a") * (z - 1) ** 2)))
    )
    free = gs.analyze(
        gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))), 3)
    )
    for r, name, values, expected in ((report, "a", {"I1": 1, "l": 0, "pi3_0": 2}, Fraction(-1, 2)),
                                      (free, "I2", {"I1": 1, "I3": 3, "l": -2, "omega3_0": 1}, 1)):
        numeric, symbolic = stabilizing_set(r, name, values), stabilizing_set(r, name)
        (interval,) = numeric.parts[0].cases[0].intervals
        assert (interval.low, interval.low_if, interval.high) == (expected, INCLUDED, oo)
        for x in (Fraction(1, 3), Fraction(-3, 5), Fraction(2), Fraction(expected)):
            if x > 0 or name == "a":
                assert (
                    numeric.contains({name: x})
                    is symbolic.contains(values | {name: x})
                    is truth(r, values | {name: x})
                )


def test_a_claimed_point_that_is_on_the_boundary_for_every_value():
    """E1 of numbers, P² = 4 I1 U' exactly: no margin is left, and the ladder decides: a ≥ −1/2."""
    scene = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 2)),
                        gs.axial_potential(lambda z: z + gs.symbol("a") * (z - 1) ** 2))
    report = gs.analyze(gs.equilibrium(scene, (0, 0, 0, 0, 0, 1)))
    (interval,) = stabilizing_set(report, "a").parts[0].cases[0].intervals
    assert (interval.low, interval.low_if, interval.high) == (Fraction(-1, 2), INCLUDED, oo)
    assert [report.verdict({"a": a}).verdict.name for a in (-1, "-1/2", 0)] == [
        "UNSTABLE",
        "STABLE",
        "STABLE",
    ]


def test_transcendental_numbers_are_solved_in_closed_form():
    """I1 = π: l ≤ −2 √π or l ≥ 2 √π."""
    solution = stabilizing_set(reports("U1")["E1"], "l", {"I1": "pi", "m0": 1, "pi3_0": 0})
    assert [solution.contains({"l": l}) for l in (3, "2*sqrt(pi)", "3.6", -4)] == [False, True, True, True]


def test_ends_of_an_unspecified_field():
    """The ends of E1 belong to the set where U' + U'' > 0; three rungs of the ladder are kept."""
    report = gs.analyze(gs.upright(gs.assemble(BODY, gs.axial_potential())))
    part = solve_condition(report.sufficient.alternatives[0][0], "l", report.boundary)
    above = part.cases[2].intervals[0]
    dU, d2U, d3U, d4U = map(gs.symbol, ("dU", "d2U", "d3U", "d4U"))
    assert above.high_if == (d2U + dU, -3 * d2U - 2 * d3U, 2 * d3U + d4U)


ASYMMETRIC = [((2, 1, 3), "omega3_0", {"m0": 1, "l": 0}), ((2, 3, 1), "l", {"m0": 1, "omega3_0": 4}),
              ((2, 3, 1), "omega3_0", {"m0": 1, "l": 1}),
              ((1, 2, "5/2"), "m0", {"omega3_0": "3/2", "l": -1}),
              ((3, 4, 2), "l", {"m0": -2, "omega3_0": 1})]


@pytest.mark.parametrize("wholly", [True, pytest.param(False, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("inertia", "name", "values"),
                         [ASYMMETRIC[1], *(pytest.param(*case, marks=pytest.mark.slow) for case in (
    ASYMMETRIC[:1] + ASYMMETRIC[2:]))])
def test_an_asymmetric_body_as_far_as_it_is_proved(inertia, name, values, wholly):
    """Unstable iff Euler and Poisson's equations have a growing mode.

    Stable where (I3 − Ii) ω² + l ω − m0 > 0 for both; else unproved.

    With numbers for all other names, and with none: then what is claimed is true, and what is sufficient is
    found.
    """
    body = gs.Gyrostat(tuple(map(exact_number, inertia)), (0, 0, gs.symbol("l")))
    report = gs.analyze(gs.upright(gs.assemble(body, gs.axial_potential(lambda z: gs.symbol("m0") * z)),
                                   "omega3_0"))
    solution, kinds = stabilizing_set(report, name, values if wholly else None), set()
    I1, I2, I3 = map(Fraction, inertia)
    for n in range(-40, 41, 2):
        v = {s: Fraction(x) for s, x in values.items()} | {name: Fraction(n, 4)}
        omega, l, m0 = v["omega3_0"], v["l"], v["m0"]
        x, moments, rotor = oracle.exact([0, 0, I3 * omega, 0, 0,
                                          1]), oracle.exact([I1, I2, I3]), oracle.exact([0, 0, l])
        unstable = oracle.growth(partial(oracle.field, inertia=moments, rotor=rotor,
                                         slope=oracle.axial_slope(m0, Fraction(0), 1)), x)
        lowest = min((I3 - i) * omega**2 + l * omega - m0 for i in (I1, I2))
        stable = lowest > 0
        answer = solution.contains({name: v[name]} if wholly else v)
        kinds.add(answer)
        if lowest == 0 and not unstable:                   # the fourth order may prove it stable
            assert answer is not False
            continue
        assert (
            answer is (True if stable else False if unstable else None)
            or not wholly
            and answer is None
            and not stable
        ), v
    shown = text(result_blocks(solution))
    assert len(kinds) > 1 and shown.count("\n") >= len(solution.parts) and shown.count("Stable:") <= 1
    assert None not in kinds or ("Nothing is proved for" if wholly else "nothing is claimed") in shown


def test_a_number_between_two_that_are_very_near():
    """Ends that differ by less than a double resolves: 10⁻²⁵, and a surd beside its 40 digits."""
    near = [(exact_number("1/3"), exact_number("1/3") + exact_number(Fraction(1, 10**25))),
            (exact_number("1.4142135623730950488016887242096980785696"), exact_number("sqrt(2)"))]
    for a, b in near:
        assert a < between(a, b) < b


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
