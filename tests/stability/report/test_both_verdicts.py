"""The verdict and that under damping at once are the two that are asked one after the other."""
from fractions import Fraction

import pytest
from draw import moments, numbers
from hypothesis import given
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.stability.report import report as reports
from gyrostat.stability.report.report import both_verdicts


def _two(report, values):
    return report.verdict(values), report.verdict(values, damped=True)


@given(I1=moments, I3=moments, l=numbers, pi3=numbers, u=numbers, boundary=st.booleans())
def test_both_are_those_of_two_questions(e1, I1, I3, l, pi3, u, boundary):
    """With margins, notes and names, on the boundary too."""
    if boundary:
        u = (pi3 + l) ** 2 / (4 * I1)
    values = {"I1": I1, "I3": I3, "l": l, "pi3_0": pi3, "dU": u}
    assert both_verdicts(e1, values) == _two(e1, values)


@given(omega=numbers.filter(bool), inertia=st.permutations([1, 2, Fraction(5, 2)]),
       axis=st.sampled_from([1, 2, 3]))
def test_of_a_free_body_too(omega, inertia, axis):
    """About each axis, where damping takes the stability of the axis of least inertia."""
    report = gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat(inertia, (0, 0, 0))), axis))
    values = {f"omega{axis}_0": omega}
    assert both_verdicts(report, values) == _two(report, values)


def test_names_that_damping_alone_needs_are_asked_for():
    """Without I3 the verdict is decided, and that under damping says what is missing."""
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    values = {"I1": 1, "l": 0, "m0": 1, "pi3_0": 3}
    decision, damped = both_verdicts(report, values)
    assert decision == report.verdict(values) and decision.stable
    assert (damped.verdict, damped.reason, damped.note) == ("UNDECIDED", "give I3 to decide", "")


def test_numbers_are_checked_once(e1, monkeypatch):
    """For both verdicts, and refused as for one."""
    checks = []
    check = reports.exact_values
    monkeypatch.setattr(reports, "exact_values", lambda *asked: checks.append(asked) or check(*asked))
    values = {"I1": 1, "I3": "1/2", "l": 2, "pi3_0": 1, "dU": 2}
    both_verdicts(e1, values)
    assert len(checks) == 1
    with pytest.raises(ValuesError, match="must be positive"):
        both_verdicts(e1, values | {"I3": -1})
    with pytest.raises(ValuesError, match="E1 needs l "):
        both_verdicts(e1, {name: x for name, x in values.items() if name != "l"})
