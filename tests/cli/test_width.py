"""Documents in the width of the terminal."""

import pytest
from commands import run, scene_file
from scene_kinds import CASES

from gyrostat.charts import progress
from gyrostat.cli import output
from gyrostat.cli.output import Output, columns, told
from gyrostat.cli.parser import main

SCENE = ["--potential", "m0*k3", "--equilibrium", "E1"]


@pytest.fixture
def terminal(monkeypatch):
    """Standard output as a terminal of some columns."""
    def opened(columns):
        monkeypatch.setattr(output, "on_terminal", lambda: True)
        monkeypatch.setenv("COLUMNS", str(columns))
    return opened


@pytest.mark.few(1)
@pytest.mark.parametrize(("columns", "widest"), [(40, 60), (60, 60), (80, 80), (140, 100)])
@pytest.mark.parametrize("arguments", [
    ("report", *SCENE), ("conditions",), ("conditions", *SCENE, "--solve-for", "l"),
    ("decide", *SCENE, "--set", "I1=1", "l=1", "m0=1", "pi3_0=1")])
def test_documents_fit_the_terminal(capsys, terminal, columns, widest, arguments):
    """Nothing is narrower than 60, no sentence wider than is read; the words are the same."""
    verb, *given = arguments
    _, wide, _ = run(capsys, *given, verb=verb)
    terminal(columns)
    _, fitted, _ = run(capsys, *given, verb=verb)
    assert max(map(len, fitted.splitlines())) <= widest
    assert ("J₁₂ = " in fitted) == (widest <= 60 and verb == "report")       # a matrix that does not fit
    if verb != "report":
        assert fitted.split() == wide.split()


def test_files_and_pipes_have_a_width_of_their_own(capsys, terminal, tmp_path):
    """Whatever the terminal is."""
    _, piped, _ = run(capsys, *SCENE)
    terminal(60)
    assert run(capsys, *SCENE, "--output", str(tmp_path / "e1.txt"))[0] == 0
    assert (tmp_path / "e1.txt").read_text(encoding="utf-8") == piped
    assert Output(None).width == 60 and Output("e1.txt").width == 100


@pytest.mark.parametrize(("columns", "width"), [("76", 76), ("40", 60), ("", 100)])
def test_a_pipe_obeys_the_columns_that_are_set(capsys, monkeypatch, columns, width):
    """COLUMNS of the environment, and 100 without it; the words are the same."""
    _, piped, _ = run(capsys, *SCENE)
    monkeypatch.setenv("COLUMNS", columns)
    _, fitted, _ = run(capsys, *SCENE)
    assert Output(None).width == width and max(map(len, fitted.splitlines())) <= width
    assert (fitted == piped) == (width == 100)


def test_short_formulas_are_left_whole(capsys, terminal):
    """No line ends in √(−I₁ m₀)."""
    terminal(60)
    _, out, _ = run(capsys, *SCENE[:3], "E2", "--solve-for", "l", verb="conditions")
    assert out.count("2 √(−I₁ m₀)") == 2 and "or l ≥\n  2 √" in out


@pytest.mark.slow
def test_findings_fit_the_terminal(capsys, terminal):
    """Of verify, of which only formulas without a blank are wider."""
    terminal(60)
    _, out, _ = run(capsys, "literature", verb="verify")
    assert max(map(len, out.splitlines()[:-1])) <= 60


ASKED = [["report"], ["conditions"], ["decide", "--full"], ["motion", "--until", "1", "--count", "3"],
         ["plot", "staude-cone", "--output", "cone.png"],
         ["chart", "--x", "nothing=0:1:3", "--y", "l=0:1:3", "--output", "none.png"]]


@pytest.mark.few(3)
@pytest.mark.parametrize("asked", ASKED, ids=" ".join)
@pytest.mark.parametrize("case", [name for name, case in CASES.items() if case.table is not None])
def test_no_line_is_wider_than_80_columns(capsys, monkeypatch, tmp_path, case, asked):
    """Of what a verb says of any kind of scene, its messages too; the rows of a table of numbers are data."""
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.chdir(tmp_path)
    path = scene_file(CASES[case], tmp_path / "scenes.toml")
    main([*asked, "--scene", str(path)])
    out, err = capsys.readouterr()
    lines = (err if asked[0] == "motion" else out + err).splitlines()
    assert max(map(len, lines), default=0) <= 80


def test_messages_are_lines_of_a_log_unless_a_terminal_shows_them(capsys, monkeypatch):
    """One line in a file; in a terminal, or where COLUMNS is set, as wide as that, with the same words."""
    message = "this is what is wrong " * 9 + "and this is what to do"
    told(message)
    line = capsys.readouterr().err
    assert line == f"gyrostat: {message}\n"
    monkeypatch.setattr(progress, "on_terminal", lambda: True)
    monkeypatch.setenv("COLUMNS", "76")
    told(message)
    lines = capsys.readouterr().err.splitlines()
    assert max(map(len, lines)) <= 76 and " ".join(" ".join(lines).split()) == line.strip()
    with pytest.raises(SystemExit):
        main(["decide", "--equilibrium", "E9"])
    lines = capsys.readouterr().err.splitlines()
    assert max(map(len, lines)) <= 76 and "gyrostat decide: error: argument --equilibrium" in "\n".join(lines)


def test_help_and_documents_have_one_width(capsys, monkeypatch):
    """100 in a pipe, and COLUMNS."""
    def widest():
        with pytest.raises(SystemExit):
            main(["decide", "--help"])
        return max(map(len, capsys.readouterr().out.splitlines()))

    assert columns() == Output(None).width == 100 and 90 < widest() <= 100
    monkeypatch.setenv("COLUMNS", "80")
    assert columns() == Output(None).width == 80 and 70 < widest() <= 80
