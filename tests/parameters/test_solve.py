"""A condition solved for one parameter.

The set contains a value exactly where the equilibrium exists and its verdict is STABLE.
"""
import random
from fractions import Fraction
from functools import cache

import pytest
from parameters.solved import BODY, FIELDS, POSITIVE, k3, reports, truth
from slow import slow
from sympy import CRootOf, oo

import gyrostat as gs
from gyrostat.algebra.reals.exact import Point, evaluate, sign_of_constant
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.parameters.sets import EXCLUDED, INCLUDED
from gyrostat.parameters.stabilizing_set import stabilizing_set


@cache
def tilt_solved(field):
    return gs.analyze(gs.inclined(gs.assemble(BODY, FIELDS[field]), eliminate="k3"))


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


@pytest.mark.few(1)
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
    names = [n for n in dict.fromkeys([*names, *_of_boundary(report)])
             if n not in report.equilibrium.eliminated]
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

    At m0 = 0 every l but −π3 does, for m0 < 0 every l.
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


@pytest.mark.parametrize(("call", "error", "why"), [
    (lambda: stabilizing_set(reports("U1")["E1"], "mass"), ValuesError, "no parameter mass"),
    (lambda: stabilizing_set(reports("U1")["E1"], "l", {"l": 1}), ValuesError, "leave out one"),
    (lambda: stabilizing_set(reports("U2")["E1"], "I1"), ScopeError, "positive: give numbers"),
    (lambda: stabilizing_set(reports("U1")["E3"], "l", {"I1": 1}), ScopeError,
     "ties l .* while I3, k3, m0, omega are open"),
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
