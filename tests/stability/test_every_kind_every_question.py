"""Every kind of scene by every way to ask: the same equilibrium is answered the same."""
from collections import Counter

import pytest
from scene_kinds import CASES
from sympy import Rational

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF
from gyrostat.errors import ScopeError


def said(decision):
    """What a decision claims, in words."""
    return {"verdict": decision.verdict.name, "notion": decision.notion, "rung": decision.rung.value,
            "modulo": [*map(str, decision.modulo)], "level": [*map(str, decision.level)],
            "locus": decision.locus, "proved": decision.proved, "growing": decision.growing}


def both(report, values):
    """Without damping, and with it."""
    return [said(report.verdict(values, damped)) for damped in (False, True)]


@pytest.fixture(params=CASES)
def case(request):
    """One kind of scene."""
    return CASES[request.param]


@pytest.mark.few(7)
def test_the_scene_at_numbers_says_the_same(case):
    """Of a family at numbers, and of the point of the scene at these numbers."""
    here, family = both(gs.analyze(case.at_numbers), case.jets), both(case.report, case.values)
    if here[0]["modulo"] == family[0]["modulo"]:
        assert here == family
    else:                                                  # a ball has more flows that may be divided out
        assert case is CASES["conical, a ball"] and here[0]["verdict"] == "STABLE" != family[0]["verdict"]


@pytest.mark.few(7)
def test_the_names_that_are_required_are_enough(case):
    """Exactly these, and no other: for the verdict, under damping, of the point itself."""
    report, jets = case.report, case.jets
    given = jets | {name: case.values[name] for name in report.required}
    assert said(report.verdict(given)) == said(report.verdict(case.values))
    damped = jets | {name: case.values[name] for name in report.secular.required}
    assert said(report.verdict(damped, damped=True)) == said(report.verdict(case.values, damped=True))
    itself = report.itself(given)
    assert said(itself) == said(report.itself(case.values)) or itself.reason.startswith("give ")


@pytest.mark.few(39)
@pytest.mark.parametrize("damped", [False, True])
def test_arrays_need_the_same_names(case, damped):
    """Those without which there is no verdict are enough for arrays too, which then say what it says."""
    names = (case.report.secular if damped else case.report).compared
    given = case.jets | {name: case.values[name] for name in names}
    wanted = case.report.verdict(given, damped)
    try:
        assert gs.charts.verdicts(case.report, given, damped=damped) == CODE_OF[wanted.verdict]
    except ScopeError as refused:                          # no range of k1, k2, k3 stays on the sphere
        assert "leave the sphere" in str(refused)


@pytest.mark.few(10)
def test_the_list_says_the_same(case):
    """Of the same equilibrium among all."""
    if case.level is None:
        return
    found, here = case.listed(), gs.analyze(case.at_numbers)
    assert said(found.decision) == both(here, {})[0]
    if found.locus != "the whole sphere":                  # of which one rotation stands for all
        assert said(found.damped) == both(here, {})[1]
    own = here.itself({}) if found.decision.modulo else None
    assert (found.itself is None) == (own is None) and (own is None or said(found.itself) == said(own))


@pytest.mark.slow
def test_a_continuation_says_the_same(case):
    """As lists do, of all that there are at numbers beside this one, within a range of it."""
    (name,) = {"omega", "M"} & {*(case.level or {})} or {None}
    if name is None:
        return
    given = dict(case.asks_for_all)
    at = Rational(given.pop(name))
    ends = at - Rational(1, 50), at + Rational(1, 50)
    try:
        found = gs.continuation(case.equilibrium.system, name, ends, given)
    except ScopeError as refused:                          # an asymmetric body in a field of degree 4
        assert "U has degree 4 in k: branches of rotations are computed if it has degree" in str(refused)
        assert case is CASES["on a curve of rotations"]
        return
    for beside in (at - Rational(1, 70), at + Rational(1, 70)):
        listed = gs.relative_equilibria(case.equilibrium.system, {**given, name: beside})
        followed = [p for p in found.pieces if p.parameter[0] < float(beside) < p.parameter[-1]]
        assert Counter(p.verdict.name for p in followed) == Counter(e.decision.verdict.name for e in listed)


@pytest.mark.few(19)
def test_what_is_said_to_be_proved_is(case):
    """The conditions that are printed, evaluated anew."""
    report, decision = case.report, case.report.verdict(case.values)
    holds, fails = (truth(criterion, case) for criterion in (report.sufficient, report.necessary))
    if decision.proved == gs.Verdict.STABLE.value:
        assert holds
    elif decision.proved == gs.Verdict.UNSTABLE.value:
        assert not fails
    else:
        assert not holds and fails
    for verdict in gs.Verdict:
        assert (decision.verdict == verdict.name) is (decision.verdict is verdict)
    assert decision.stable == (decision.verdict == "STABLE")
    assert decision.unstable == (decision.verdict == "UNSTABLE")


def truth(criterion, case):
    """Of a disjunction of conjunctions, with exact numbers inserted by SymPy."""
    definitions = {}
    for name, e in getattr(getattr(case.report, "closed", None), "definitions", ()):
        definitions[name] = value_of(case, e, definitions)

    def holds(c):
        margin, *squares = (value_of(case, e, definitions) for e in (c.margin, *c.degenerate))
        if c.strict:
            return margin > 0 and all(x != 0 for x in squares)
        return margin >= 0 or any(x == 0 for x in squares)

    return any(all(map(holds, alternative)) for alternative in criterion.alternatives)


def value_of(case, e, definitions):
    """By SymPy's subs; what is defined depends on what is defined before it."""
    return case.equilibrium.insert(e.subs(definitions)).subs(case.numbers).subs(case.numbers)
