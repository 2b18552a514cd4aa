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


@pytest.mark.few(1)
@pytest.mark.skipif(not PAGE.exists(), reason="the page is not part of an installed copy")
@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_page(capsys, tmp_path, monkeypatch, command):
    """It answers, as it is typed, beside the files of the page."""
    monkeypatch.chdir(tmp_path)
    for name, content in FILES.items():
        Path(name).write_text(content)
    program, verb, *arguments = shlex.split(command)
    status, out, _ = run(capsys, *arguments, verb=verb)
    assert program == "gyrostat" and status == 0 and (out or "--output" in arguments)


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


TENSOR = "[[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]] kg m^2"
WHEELS = ("axis=0,1,0 inertia=0.02 kg m^2 speed=3000 rpm", "axis=0,0,1, inertia=0.02 kg m^2, speed=-500 rpm")
SHEET = f"""
[scene.sheet]
inertia = "{TENSOR}"
rotors = ["{WHEELS[0]}", {{ axis = [0, 0, 1], axial = "0.02 kg m^2", rate = "-500 rpm" }}]
lumped = true
"""


@pytest.mark.slow
def test_wheels_on_the_command_line_are_those_of_a_file(capsys, tmp_path):
    """The sheet of the page, by options alone: the same table."""
    path = tmp_path / "sheet.toml"
    path.write_text(SHEET)
    old = tmp_path / "old.toml"
    old.write_text(FILES["sheet.toml"])
    typed = ("--potential", "none", "--inertia", TENSOR, "--wheel", WHEELS[0], "--wheel", WHEELS[1])
    outs = [run(capsys, *arguments, "--momentum", "20 N m s", verb="decide")[1]
            for arguments in (typed, (*typed, "--lumped"), ("--scene", str(path)), ("--scene", str(old)))]
    assert len(set(outs)) == 1 and "13.65" in outs[0]
    with_wheel = run(capsys, "--scene", str(path), "--wheel", "axis=1,0,0 inertia=1 kg m^2 momentum=0 N m s",
                     "--momentum", "20 N m s", verb="decide")
    assert with_wheel[0] == 0 and with_wheel[1] != outs[0]
    old.write_text(FILES["sheet.toml"] + '\n[scene.given]\ninertia = "1, 2, 3 kg m^2"\n'
                   'gyrostatic_momentum = "0, 0, 3 N m s"\n')
    one = "--wheel", "axis=1,0,0 inertia=1/9 kg m^2 momentum=2 N m s", "--momentum", "20 N m s"
    asked = [run(capsys, *scene, *one, verb="decide")[1] for scene in (
        ("--scene", f"{old}#given"), ("--potential", "none", "--inertia", "1, 2, 3 kg m^2"))]
    assert asked[0] == asked[1] != ""


@pytest.mark.slow
def test_products_of_inertia_on_the_command_line(capsys):
    """Positive integrals are the tensor with the other signs."""
    other = TENSOR.replace("1.3,", "-1.3,").replace("-0.8", "0.8").replace("0.6", "-0.6")
    other = other.replace("[1.3", "[-1.3")
    asked = ("--potential", "none", "--momentum", "20 N m s", "--gyrostatic-momentum", "0, 0, 3 N m s")
    outs = [run(capsys, *asked, *more, verb="decide") for more in (
        ("--inertia", TENSOR, "--products", "positive"), ("--inertia", other), ("--inertia", TENSOR))]
    assert outs[0] == outs[1] != outs[2] and not outs[0][0]


def test_an_orbit_overrides_that_of_a_file_with_rotors(capsys, tmp_path):
    """Its tensor has a unit, and keeps it."""
    path = tmp_path / "sheet.toml"
    path.write_text('[scene.a]\ninertia = "120, 140, 80 kg m^2"\nlumped = true\norbit = "0.0011 rad/s"\n'
                    'rotors = ["axis=0,1,0 inertia=0.02 kg m^2 speed=30 rpm"]\n')
    found = [run(capsys, "--scene", str(path), *more, verb="decide") for more in (
        (), ("--orbit", "height=500 km"), ("--orbit", "1"))]
    assert [status for status, *_ in found] == [0, 0, 2]
    assert "'120 kg m^2' has a unit and orbit rate = '1' has none" in found[2][2]


@pytest.mark.parametrize("wheel", [
    "axis=0,0,1 inertia=0.01 kg speed=30 rpm", "axis=0,0,1 speed=30 rpm", "0,0,1",
    "axis=0,0,1 inertia=1 kg m^2 sped=1 rpm", "axis=0,0,1 inertia=1 kg m^2 axial=1 kg m^2", "",
    "axis=0,0 inertia=1 kg m^2",
    "axis=0,0,1 inertia=0.01 kg m^2 speed=30", "axis=0,0,1 inertia=1 g m^2 speed=1 rpm momentum=1 N m s",
    "axis=0,0,1 kg inertia=1 kg m^2", "axis=0,0,1 inertia=900 kg m^2"])
def test_what_is_no_wheel_says_why(capsys, wheel):
    """And what to write."""
    status, out, err = run(capsys, "--inertia", TENSOR, "--wheel", wheel, "--potential", "none",
                           "--momentum", "20 N m s", verb="decide")
    assert status == 2 and not out and 20 < len(err) <= 311


def test_wheels_and_a_gyrostatic_momentum_exclude_each_other(capsys):
    """And a tensor without its wheels needs their moments across."""
    asked = ("--potential", "none", "--inertia", TENSOR, "--wheel", WHEELS[0], "--momentum", "20 N m s")
    assert "both given" in run(capsys, *asked, "--gyrostatic-momentum", "0,0,1 N m s", verb="decide")[2]
    assert "transverse" in run(capsys, *asked, "--lumped", "false", verb="decide")[2]
    assert "neither true nor false" in _refused(capsys, *asked, "--lumped", "yes")


def _refused(capsys, *arguments):
    """What is written before the parser ends."""
    with pytest.raises(SystemExit):
        run(capsys, *arguments, verb="decide")
    return capsys.readouterr().err
