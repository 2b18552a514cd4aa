"""Scene files of spacecraft: a tensor, rotors, units; and the page that shows them."""
import json
import re
import shlex
from pathlib import Path

import pytest
from commands import run
from sympy import Rational, pi

from gyrostat.errors import GyrostatError
from gyrostat.mechanics.families.scene_tables import SceneTable

PAGE = Path(__file__).parents[3] / "docs" / "how-to" / "data-sheet.md"
TEXT = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
FILES = dict(re.findall(r"```toml\n# (\S+)\n(.*?)```", TEXT, re.DOTALL))     # by the names on top of them
COMMANDS = [line for block in re.findall(r"```sh\n(.*?)```", TEXT, re.DOTALL)
            for line in block.replace("\\\n", "").splitlines()]
SATELLITE = """
[scene.satellite]
inertia = [["120 kg m^2", "2 kg m^2", 0], ["2 kg m^2", "110 kg m^2", 0], [0, 0, "80 kg m^2"]]
lumped = true
rotors = [{ axis = [0, 0, 2], axial = "50 g m^2", rate = "100 rad/s" },
          { axis = [1, 0, 0], axial = "20 g m^2", momentum = "Hx" }]
values = { Hx = "1 N m s" }
"""


@pytest.mark.skipif(not PAGE.exists(), reason="the page is not part of an installed copy")
@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_page(capsys, tmp_path, monkeypatch, command):
    """It answers, as it is typed, beside the files of the page."""
    monkeypatch.chdir(tmp_path)
    for name, content in FILES.items():
        Path(name).write_text(content)
    program, verb, *arguments = shlex.split(command)
    status, out, _ = run(capsys, *arguments, verb=verb)
    assert program == "gyrostat" and status == 0 and out


def decided(capsys, *arguments):
    """What decide says, as data."""
    status, out, err = run(capsys, *arguments, "--format", "json", verb="decide")
    assert status == 0, err
    return json.loads(out)["equilibria"]


@pytest.mark.slow
def test_a_file_with_rotors_is_the_body_with_a_tensor_and_a_momentum(capsys, tmp_path):
    """The free rotor taken out of the tensor, the other in it."""
    path = tmp_path / "sheet.toml"
    path.write_text(SATELLITE)
    found = decided(capsys, "--scene", str(path), "--set", "M=2000 kg m^2/s")
    assert len(found) == 6
    assert found == decided(capsys, "--potential", "none", "--inertia", "5999/50,2,0;2,110,0;0,0,80",
                            "--gyrostatic-momentum", "Hx,0,5", "--set", "Hx=1", "--set", "M=2000")


def test_a_table_is_a_body():
    """Units converted, names kept."""
    body = SceneTable({"inertia": ["120 kg m^2", "110 kg m^2", "8e4 kg mm^2 "], "lumped": False, "rotors": [
        {"axis": [0, 0, 1], "axial": "0.05 kg m^2", "transverse": "0.03 kg m^2", "rate": "600 rpm"}]}).body
    assert body.moments == (120 + Rational(3, 100), 110 + Rational(3, 100), Rational(13, 100))
    assert body.gyrostatic_momentum == (0, 0, pi)


REFUSED = [
    ({"rotors": [{"axis": [0, 0, 1], "axial": 1}]}, "rotors and lumped must both be given"),
    ({"lumped": True}, "rotors and lumped must both"), ({"lumped": True, "rotors": []}, "list of tables"),
    ({"lumped": 1}, "write true or false"),
    ({"lumped": True, "rotors": [{"axis": [0, 0, 1]}]}, "no axial"),
    ({"lumped": True, "rotors": [{"axis": [0, 0, 1], "axial": 1, "spin": 1}]}, "no entry spin"),
    ({"lumped": True, "rotors": [{"axis": [0, 0, 0], "axial": 1}]}, "not a direction"),
    ({"lumped": True, "rotors": [{"axis": [0, 0, 1], "axial": 1}], "gyrostatic_momentum": [0, 0, 1]},
     "both given"),
    ({"inertia": ["1 kg m^2", "2 kg m^2", "3 kg m^2"], "lumped": True,
      "rotors": [{"axis": [0, 0, 1], "axial": "0.1"}]}, "has a unit and axial = '0.1' has none"),
    ({"inertia": ["I1", "2 kg m^2", "3 kg m^2"], "values": {"I1": 2}}, "I1 = '2' has none"),
    ({"inertia": ["1 rpm", "2 kg m^2", "3 kg m^2"]}, "inertia is one of kg m"),
    ({"inertia": [["1", "2"], ["2", "1"], [0, 0]]}, "inertia"),
    ({"inertia": [["1", "0.1", 0], ["0.2", "1", 0], [0, 0, 1]]}, "symmetric")]


@pytest.mark.parametrize(("table", "why"), REFUSED)
def test_what_is_no_data_sheet_says_why(table, why):
    """And what to write."""
    with pytest.raises(GyrostatError, match=why):
        _ = SceneTable(table).body
