"""gyrostat verify: tables, errata, files of one's own, progress."""
import json
import sys
from functools import cache

import pytest
from commands import run

from gyrostat.published import check


def verify(capsys, *arguments):
    return run(capsys, *arguments, verb="verify")


OWN = """[source]
name = "mine"
title = "A paper of my own"

[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
spin = "omega3_0"

[[formula]]
key = "stable"
where = "eq. (1)"
quantity = "sufficient for stability"
printed = "(I3*omega3_0)**2 > 2*I1*m0"
kind = "condition"
scene = "top"
"""
findings = cache(lambda source: check([source]))


@pytest.fixture
def checked_once(monkeypatch):
    """The sources are checked by the first test that asks for them."""
    monkeypatch.setattr("gyrostat.cli.verbs.verify.each",
                        lambda sources, progress=None: [f for source in sources for f in findings(source)])


@pytest.mark.slow
def test_verify_text(capsys):
    """A table by source; what is wrong with what is right, and where.

    No progress where standard error is no terminal.
    """
    status, out, err = verify(capsys, "AR")
    assert status == 0
    assert err == ""
    assert "39 confirmed, 5 misprints, 2 unchecked\n" in out
    assert out.endswith("46 statements: 39 confirmed, 5 misprints, 2 unchecked; "
                        "all 5 known misprints were found\n")
    assert "printed:   (I2 - I3)*omega1*omega2" in out and "right:     (I2 - I3)*omega2*omega3" in out


@pytest.mark.slow
def test_verify_json(capsys, checked_once):
    """The documented keys; a misprint has its counterexample."""
    _, out, _ = verify(capsys, "AR", "--format", "json")
    data = json.loads(out)["statements"]
    assert set(data[0]) == {"source", "key", "where", "quantity", "kind", "printed", "derived", "status",
                            "expected", "difference",
                            "counterexample", "not_sharp", "remark", "note", "route", "hypotheses"}
    assert data[0]["hypotheses"] == {"body": "moments of inertia I1, I2, I3, positive",
                                     "field": "none, the body is free"}
    assert all(bool(d["route"]) == (d["status"] == "confirmed") for d in data)
    (wrong,) = (d for d in data if d["key"] == "2K-dot")
    assert wrong["status"] == "misprint"
    assert set(wrong["counterexample"]) == {"values", "printed", "derived", "confirmation"}
    assert wrong["derived"] == "dot(vector_pi, vector_omega)" and wrong["difference"][0]["entry"] is None


@pytest.mark.slow
def test_verify_latex(capsys, tmp_path, checked_once):
    """A table of errata, of misprints only, as a document or a fragment; --full adds what is confirmed."""
    (path := tmp_path / "mine.toml").write_text(OWN)
    _, out, _ = verify(capsys, "AR", str(path), "--format", "latex")
    assert "A paper of my own" in out
    assert r"\begin{longtable}" in out
    assert r"\omega_{2} \omega_{3}" in out
    assert "K-constant" not in out
    assert "norm" not in out
    _, part, _ = verify(capsys, "AR", "--format", "latex", "--fragment")
    assert part.startswith("% needs amsmath, array and longtable\n" + r"\begingroup")
    assert r"\documentclass" not in part
    _, full, _ = verify(capsys, "AR", "--format", "latex", "--full")
    assert r"\caption{Confirmed statements}" in full and "K-constant" in full
    assert r"\caption{Confirmed" not in out


def test_errata_in_the_symbols_of_a_paper(capsys, tmp_path, checked_once):
    """In what is printed, derived and set; prose has the names as they are typed, and that is said."""
    (path := tmp_path / "mine.toml").write_text(OWN)
    _, out, _ = verify(capsys, str(path), "--format", "latex", "--symbols", "I1=A", "m0=\\mu",
                       "--label", "my")
    assert r"\caption{Misprints}\label{my:errata}" in out and r"\mu" in out and "I_1" not in out
    assert r"\noindent In what is said in words, I1 is $A$, m0 is $\mu$.\par" in out
    status, out, err = verify(capsys, str(path), "--symbols", "I1=A")
    assert status == 2 and out == "" and "--symbols is for LaTeX, and --format is text: add" in err


def test_verify_a_file_of_ones_own(capsys, tmp_path):
    """Exit status 1 where a formula is not as expected, 2 where it cannot be read, with file and key."""
    path = tmp_path / "mine.toml"
    path.write_text(OWN)
    status, out, _ = verify(capsys, str(path))
    assert status == 1 and "expected" not in out and out.endswith("\n1 statement: misprint\n")
    assert "I₃² (ω₃⁰)² > 4 I₁ m₀" in out and "with the real part" in " ".join(out.split())
    path.write_text(OWN.replace("2*I1*m0", "4*I1*m0"))
    status, out, _ = verify(capsys, str(path))
    assert status == 0 and "expected" not in out and out.endswith("\n1 statement: confirmed\n")
    path.write_text(OWN.replace("2*I1*m0", "4*I1*mass"))
    status, out, err = verify(capsys, str(path))
    assert status == 2 and out == "" and f"{path}: unknown names: mass in stable" in err
    assert verify(capsys, "VV2004")[0] == 2


def test_what_was_checked_before_is_shown(capsys, tmp_path):
    """Of a file in which a later formula cannot be read: what is found, then the sentence, exit status 2."""
    path = tmp_path / "mine.toml"
    later = OWN[OWN.index("[[formula]]"):].replace("stable", "later").replace("2*I1*m0", "2*I1*")
    path.write_text(OWN + "\n" + later)
    status, out, err = verify(capsys, str(path))
    assert status == 2 and "✗ misprint" in out and "with the real part" in " ".join(out.split())
    assert "mine.toml: later: " in err and err.count("\n") == 1
    status, out, _ = verify(capsys, str(path), "--format", "json")
    assert (status, out) == (2, "")


def test_progress_on_a_terminal(capsys, tmp_path, monkeypatch):
    """A bar on standard error, wiped at the end."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    (path := tmp_path / "mine.toml").write_text(OWN)
    _, out, err = verify(capsys, str(path))
    assert "#" in err and "mine" in err and err.rstrip(" ").endswith("\r") and "#" not in out


EXPECTING = OWN + '\n[expected]\n{}\n'


@pytest.mark.parametrize(("expected", "status", "last"), [
    ('misprint = ["stable"]', 0, "1 statement: misprint; the known misprint was found"),
    ("", 1, "1 statement: misprint; not as expected: mine:stable")])
def test_a_file_says_what_is_expected(capsys, tmp_path, expected, status, last):
    """Only then the summary, and the line of the statement, speak of it."""
    (path := tmp_path / "mine.toml").write_text(EXPECTING.format(expected))
    found, out, _ = verify(capsys, str(path))
    assert found == status and out.endswith(f"\n{last}\n")
    assert ("← expected: confirmed" in out) == bool(status)


def test_what_is_confirmed_is_shown(capsys, tmp_path):
    """The derived formula; with --full the route and each hypothesis beside it, of a misprint the latter."""
    path = tmp_path / "mine.toml"
    path.write_text(OWN.replace("2*I1*m0", "4*I1*m0"))
    _, short, _ = verify(capsys, str(path))
    _, full, _ = verify(capsys, str(path), "--full")
    said = " ".join(full.split())
    assert "derived:   sufficient for stability: I₃² (ω₃⁰)² > 4 I₁ m₀" in short
    assert short.count("\n") == 6 and "compared" not in short and "field:" not in short
    assert "compared: derived from the formal criterion: " in said
    assert "both conditions have the same normal form" in said
    assert "body: moments of inertia I₁, I₁, I₃, positive" in said and "field: U = m₀ k₃" in said
    assert "point: E1, (π₁, π₂, π₃, k₁, k₂, k₃) = (0, 0, I₃ ω₃⁰, 0, 0, 1)" in said
    path.write_text(OWN)
    _, wrong, _ = verify(capsys, str(path), "--full")
    assert "field:     U = m₀ k₃" in wrong and "compared" not in wrong


@pytest.mark.slow
def test_a_long_formula_is_cut(capsys, checked_once):
    """To two lines at most, and --full shows all of it."""
    _, short, _ = verify(capsys, "AR")
    _, full, _ = verify(capsys, "AR", "--full")
    lines = short.splitlines()
    (n,) = (n for n, line in enumerate(lines) if "inverse-rate " in line)
    assert "dt(inverse(R)) = [[" in lines[n + 1] and lines[n + 1].endswith("characters, see --full)")
    assert "characters, see --full" not in full and full.count("compared:  ") == 39
