"""Every kind of scene that a scene file can hold, by every way to ask from outside Python: one answer."""
import json
from fractions import Fraction

import pytest
from commands import run, scene_file
from scene_kinds import CASES

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF
from gyrostat.errors import GyrostatError
from gyrostat.printing.formats.json_data import damped_data, decision_data

FILED = [name for name, case in CASES.items() if case.table is not None]
SETS = [pytest.param(name, marks=pytest.mark.slow if name.startswith("conical, ") else ()) for name in FILED]


@pytest.fixture(params=FILED)
def case(request):
    """One kind of scene."""
    return CASES[request.param]


@pytest.fixture
def file(case, tmp_path):
    """The scene as a file; of a point its coordinates are named on the command line."""
    path = scene_file(case, tmp_path / "scenes.toml")
    return f"{path}#one"


def answers(decision, damped):
    """As JSON has them, without what depends on how the equilibrium was named."""
    return [{name: x for name, x in data.items() if name not in ("reason", "margins")}
            for data in (decision_data(decision), damped_data(damped))]


def told(entry):
    """The same of an entry of a document."""
    return [{name: x for name, x in entry[key].items() if name not in ("reason", "margins")}
            for key in ("decision", "damped_decision")]


@pytest.mark.few(4)
def test_decide_says_the_same(case, file, capsys):
    """As data and as text, and the point itself where the verdict is modulo a flow."""
    report = case.report
    decision, damped = report.verdict(case.values), report.verdict(case.values, damped=True)
    status, out, _ = run(capsys, "--scene", file, "--format", "json", verb="decide")
    (found,) = json.loads(out)["equilibria"]
    assert status == 0 and told(found) == answers(decision, damped)
    assert (found["itself"] is not None) == bool(decision.modulo)
    if decision.modulo:
        assert found["itself"]["verdict"] == report.itself(case.values).verdict.name
    text = " ".join(run(capsys, "--scene", file, verb="decide")[1].split())
    assert f"; {decision.proved}." in text
    if decision.notion and decision.scope:
        assert decision.scope.partition(" ")[0] in text.partition("Reason")[0]


@pytest.mark.few(1)
def test_a_batch_says_the_same(case, file, capsys, tmp_path):
    """A line of it."""
    lines = tmp_path / "lines.jsonl"
    lines.write_text(json.dumps(case.values) + "\n")
    status, out, _ = run(capsys, "--scene", file, "--batch", str(lines), verb="decide")
    (found,) = json.loads(out)["equilibria"]
    assert status == 0 and told(found) == answers(case.report.verdict(case.values),
                                                  case.report.verdict(case.values, damped=True))


@pytest.mark.few(4)
@pytest.mark.parametrize("verb", ["report", "conditions", "decide"])
def test_a_question_about_the_table_is_answered_with_the_document(case, file, capsys, verb):
    """Key by key what the verb writes of the file; or it is refused in the same words."""
    status, out, err = run(capsys, "--scene", file, "--format", "json", verb=verb)
    try:
        found = getattr(gs.questions, verb)(case.table | {"values": case.values})
    except GyrostatError as refused:
        assert (status, err) == (2, f"gyrostat: {refused}\n")
    else:
        assert status == 0 and found == json.loads(out)


@pytest.mark.few(6)
def test_the_page_says_the_same(case):
    """Its verdicts, and the sentence that says what is proved."""
    decision, damped = case.report.verdict(case.values), case.report.verdict(case.values, damped=True)
    found = gs.questions.show(case.table | {"values": case.values}, "decided")
    assert (found["verdict"], found["damped"]) == (decision.verdict.name, damped.verdict.name)
    assert decision.proved in json.dumps(found["blocks"], ensure_ascii=False)


@pytest.mark.few(10)
def test_latex_says_the_same(case):
    """The verdict with its notion and what is divided out."""
    decision = case.report.verdict(case.values)
    latex = gs.to_latex(decision)
    assert latex.startswith(rf"\text{{{decision.verdict.name.lower()}")
    assert str(decision.notion) in latex
    for words, parts in (("modulo the flow of", decision.modulo), ("on its level of", decision.level),
                         ("as a set", decision.locus)):
        assert (words in latex) == bool(parts and decision.notion)


def test_arrays_and_boxes_say_the_same(case):
    """At these numbers, and in a box of one point: what a box claims is the verdict."""
    report = case.report
    given = {name: case.values[name] for name in (*report.required, *case.jets)}
    if not given or not all(_dyadic(x) for x in given.values()):
        return
    decision = report.verdict(given)
    doubles = {n: float(Fraction(x)) for n, x in given.items()}
    assert gs.charts.verdicts(report, doubles) == CODE_OF[decision.verdict]
    name = next(iter(given))
    try:
        box = gs.charts.certify_box(report, given | {name: (given[name], given[name])})
    except GyrostatError as refused:
        assert len(str(refused)) > 30
    else:
        assert box.verdict.name in (decision.verdict.name, "UNDECIDED")


def _dyadic(text):
    """Whether a double is the same number."""
    try:
        return Fraction(float(Fraction(text))) == Fraction(text)
    except ValueError:
        return False


@pytest.mark.few(1)
@pytest.mark.parametrize("case", SETS, indirect=True)
def test_sets_say_the_same(case):
    """A value is in the stabilising set where it is stable, in what is left open where it is undecided."""
    report = case.report
    for name in report.required:
        others = {n: x for n, x in case.values.items() if n in (*report.required, *case.jets) and n != name}
        decision = report.verdict(case.values)
        try:
            found = gs.stabilizing_set(report, name, {n: x for n, x in others.items() if n not in case.jets})
        except GyrostatError as refused:
            assert len(str(refused)) > 30
            continue
        if (inside := found.contains({**others, name: case.values[name]})) is not None:
            assert inside == decision.stable, name
        elif any(part.meaning == "undecided" for part in found.parts):
            assert decision.verdict == "UNDECIDED", name
