"""What --solve-for says in few lines, and what it leaves out."""
import re
from itertools import product

import pytest
from commands import run

import gyrostat as gs
from gyrostat.questions.answers.brief_solutions import brief

ASKED = [["--equilibrium", "E3"], [], ["--potential", "a*k3 + b*k3^2", "--equilibrium", "E3"],
         ["--potential", "none"], ["--orbit", "omega0"]]


def solved(capsys, *arguments):
    return run(capsys, *arguments, "--solve-for", "l", verb="conditions")[1]


@pytest.mark.few(1)
@pytest.mark.parametrize("arguments", ASKED, ids=" ".join)
def test_at_most_25_lines(capsys, monkeypatch, arguments):
    """In 80 columns; what is shown stands in full too, what is not is counted."""
    monkeypatch.setenv("COLUMNS", "80")
    short, full = solved(capsys, *arguments), solved(capsys, *arguments, "--full")
    assert len(short.splitlines()) <= 25 and "Not shown" not in full
    assert (short == full) == (len(full.splitlines()) <= 25)
    cases = [len(re.findall(r"\b(?:for|exists) [^:]*: ", " ".join(out.split()))) for out in (short, full)]
    left_out = [int(n) for n in re.findall(r"(\d+)\s+(?:long\s+)?cases?\b", short)]
    assert cases[0] + sum(left_out) == cases[1]


def test_the_least_is_left_out_first():
    """The ends, then cases in which an expression vanishes, then the longest one."""
    field = gs.axial_potential(lambda k3: gs.symbol("a") * k3 + gs.symbol("b") * k3**2)
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), field), eliminate="k3"))
    found = [("E3", report, gs.stabilizing_set(report, "l"))]
    assert brief(found, lambda *_: True) == (found, "")
    said = [brief(found, lambda _, note, n=n: note.count(";") == n and note != "")[1] for n in range(2)]
    assert said[0] == "Not shown: whether the ends of the intervals belong to them. Everything: --full"
    assert "an expression vanishes" in said[1] and "long case" not in said[1]
    shown, note = brief(found, lambda *_: False)
    assert not any(part.cases for part in shown[0][2].parts) and "long cases" in note


def test_what_is_shown_is_true():
    """A value inside the sets that are shown is inside those that are not cut, at an end of them too."""
    field = gs.axial_potential(lambda k3: gs.symbol("a") * k3 + gs.symbol("b") * k3**2)
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), field)))
    whole = gs.stabilizing_set(report, "l")
    ((_, _, short),), _ = brief([("E1", report, whole)], lambda _, note: "vanishes" in note)
    answers = []
    for (a, b), l in product([(1, 0), (3, -1), (-1, 1), (-1, 0), (2, -1)], (-4, -3, "-5/2", -1, 1, 2)):
        values = {"I1": 1, "pi3_0": 1, "a": a, "b": b, "l": l}
        answers.append((short.contains(values), whole.contains(values)))
    assert all(right for shown, right in answers if shown)
    assert (True, True) in answers and (False, True) in answers
