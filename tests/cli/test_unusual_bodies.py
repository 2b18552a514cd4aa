"""Pictures and charts of bodies that no rigid body is: a note on standard error."""
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
