"""Pictures and charts of bodies that no rigid body is: a note on standard error."""
import json

import pytest

from gyrostat.cli.parser import main


def sets(text):
    return [f"--set={setting}" for setting in text.split()]


CONES = ["plot", "cones", *sets("I1=1 I3=3"), "--transverse", "1", "--axial", "2", "--output", "a.png"]
NOTED = [["plot", "momentum-sphere", *sets("I1=1 I2=1 I3=3 l=0.1"), "--momentum", "1", "--output", "a.png"],
         ["plot", "energy-momentum", "--potential", "k3", *sets("I1=1 I3=3 l=0 p_psi=1"), "--output",
          "a.png"],
         ["chart", "--potential", "k3", "--equilibrium", "E1", *sets("I1=1 I3=3"), "--x", "l=0:1:2", "--y",
          "omega3_0=0:1:2",
          "--output", "a.nc"]]


@pytest.mark.slow
@pytest.mark.parametrize("arguments", [CONES,
                                       *(pytest.param(arguments, marks=pytest.mark.slow)
                                         for arguments in NOTED)])
def test_a_picture_says_what_is_unusual(arguments, tmp_path, monkeypatch, capsys):
    """No rigid body has the moments 1, 1, 3: said on standard error, as of a motion.

    Of a body that there is, nothing.
    """
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 0
    assert capsys.readouterr().err.startswith("note        no rigid body has the moments 1, 1, 3: ")
    assert main([text.replace("I3=3", "I3=2") for text in arguments]) == 0
    assert capsys.readouterr().err == ""

BODY = ["--inertia", "1,2,4", "--gyrostatic-momentum", "0,0,1"]
LISTS = {"free": ["--potential", "none", "--set", "M=2"], "orbit": ["--orbit", "1"],
         "at a rate": ["--potential", "k1 + k3", "--set", "omega=1"],
         "on a level": ["--potential", "k1 + k3", "--set", "C1=1"], "arcs": ["--potential", "k1 + k3"],
         "in a direction": ["--potential", "13/5*k3", "--set", "k1=0", "k2=3/5", "k3=4/5"]}


@pytest.mark.slow
@pytest.mark.parametrize("kind", LISTS)
def test_a_list_says_it_once(kind, capsys):
    """As text, and as JSON under the key of a single verdict; of a body that there is, nothing."""
    said = "no rigid body has the moments 1, 2, 4"
    for inertia, count in (("1,2,4", 1), ("2,3,4", 0)):
        given = ["decide", "--inertia", inertia, *BODY[2:], *LISTS[kind]]
        assert main(given) == 0
        text = " ".join(capsys.readouterr().out.split())
        assert text.count(said) == text.count("Note: ") == count
        assert main([*given, "--format", "json"]) == 0
        data = capsys.readouterr().out
        assert data.count(said) == count
        if count and kind != "in a direction":             # one answer alone has it in its decision
            assert json.loads(data)["note"].startswith(said)


@pytest.mark.parametrize("verb", ["conditions", "report", "conditions --solve-for l"])
def test_a_derivation_says_it_beside(verb, capsys):
    """On standard error, where a file of it is not changed."""
    verb, *solved = verb.split()
    given = [verb, *BODY[:3], "0,0,l", "--potential", "k3", "--equilibrium", "E1", *solved]
    assert main([*given, *(["--set", "omega3_0=1"] if solved else [])]) == 0
    assert capsys.readouterr().err.startswith("note        no rigid body has the moments 1, 2, 4: ")
