"""conditions --well: barriers and kicks as formulas, in three formats."""
import json
import re
import shutil
import subprocess

import pytest
from commands import run
from matplotlib.mathtext import MathTextParser

ORBIT = "--orbit", "omega0", "--gyrostatic-momentum", "0,l,0"
SCENES = {"satellite": ORBIT,
          "top": ("--potential", "m0*k3", "--gyrostatic-momentum", "0,0,0"),
          "free": ("--potential", "none", "--gyrostatic-momentum", "0,0,l", "--equilibrium", "axis 3"),
          "polynomial": ("--potential", "a*k3 + b*k3**3")}


def asked(capsys, *options):
    return run(capsys, *options, "--well", verb="conditions")


def test_a_well_in_words_and_as_data(capsys):
    """The conditions, both cases of each way out, the lower of the two; as data the same."""
    _, out, _ = asked(capsys, *ORBIT)
    part = out[out.index("Earth-pointing, its well"):]
    for line in ("l + ω₀ (I₂ − I₁) > 0", "If |l| < ω₀ (I₂ − I₁):", "by_yaw = 2 ω₀ l",
                 "barrier = Min(by_pitch, by_yaw)", "kick < √(2 barrier Min(I₂, I₃))"):
        assert line in part, line
    _, out, _ = asked(capsys, *SCENES["free"])
    part = out[out.index("its well"):]
    assert part.count("Else, if I_near |l|") == 2 and part.count("kick < |I₃ ω₃⁰ + l|") == 2
    _, out, _ = asked(capsys, *ORBIT, "--format", "json",
                      "--set", "omega0=1", "I1=60", "I2=70", "I3=35", "l=5")
    [form] = json.loads(out)["wells"]["Earth-pointing"]
    assert form["barrier"] == "45/4" and form["positive"] == [] and form["names"] == {}
    _, out, _ = asked(capsys, *SCENES["top"], "--format", "json",
                      "--set", "I1=1", "I3=8/5", "m0=1", "pi3_0=12/5")
    wells = json.loads(out)["wells"]
    assert wells["E2"][0]["barrier"] == "oo" and len(wells["E1"]) == 2
    assert "no closed form" not in out and "0 and 1" in wells["E1"][1]["root"]


def test_where_there_is_no_closed_form_it_says_so(capsys):
    """One of several equilibria has none; if none has one the question is refused."""
    status, out, err = asked(capsys, "--potential", "k3", "--set", "I1=1", "I3=1", "l=0", "pi3_0=1",
                             "--equilibrium", "E1", "--equilibrium", "E2")
    assert status == 0, err
    assert "It is no strict minimum at these numbers, so that it is in no well." in out
    status, out, err = asked(capsys, "--potential", "exp(k3)", "--equilibrium", "E1")
    assert status != 0 and out == "" and "E1: its well has no closed form: closed forms are known of" in err
    assert "Ask without the well" in err


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
def test_the_latex_of_wells_compiles(capsys, tmp_path, scene):
    """By pdflatex if it is there, else each formula by the parser of Matplotlib."""
    _, out, _ = asked(capsys, *SCENES[scene], "--format", "latex")
    if shutil.which("pdflatex"):
        (tmp_path / "paper.tex").write_text(out, encoding="utf-8")
        said = subprocess.run(["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "paper.tex"],
                              cwd=tmp_path, capture_output=True, text=True, check=False)
        assert said.returncode == 0, said.stdout[-2000:]
    part = out[out.index("its well}"):]
    formulas = [*re.findall(r"\\begin\{equation\}(.*?)\\end\{equation\}", part, re.DOTALL),
                *re.findall(r"\$(.+?)\$", part)]
    assert len(formulas) > 5
    for formula in formulas:
        if r"\begin" not in formula:
            MathTextParser("path").parse(f"${' '.join(formula.split())}$".replace(r"\nobreak", ""))
