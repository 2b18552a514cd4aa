"""Numbers are printed with units if they are given with units."""
import pytest
from commands import run

from gyrostat.cli.options.scene_files import with_scene
from gyrostat.cli.options.units_given import units_given
from gyrostat.cli.parser import parser

BOX = ["--potential", "none", "--state", "0.1 N m s,2 N m s,0", "--until", "10 s", "--count", "2", "--set",
       "I1=3 kg m^2", "I2=2 kg m^2", "I3=1 kg m^2", "l=0"]
TOP = ["--potential", "m0*k3", "--equilibrium", "E1", "--solve-for", "l", "--set", "I1=2 kg m^2", "m0=3 N m",
       "pi3_0=1 N m s"]
ARCS = ["--potential", "m0*(k1 + k3)", "--set", "I1=1 kg m^2", "I2=2 kg m^2", "I3=3 kg m^2", "l=0",
        "m0=2 N m"]
FILE = """
[scene.station]
inertia = ["3 UNIT", "3 UNIT", "5 UNIT"]
lumped = true
rotors = [{ axis = [0, 0, 1], axial = "1/2 UNIT", transverse = "1/3 UNIT", momentum = 0 }]
"""


def bare(arguments):
    """The same numbers without units."""
    for unit in (" kg m^2", " N m s", " N m", " s"):
        arguments = [text.replace(unit, "") for text in arguments]
    return arguments


@pytest.mark.few(1)
@pytest.mark.parametrize(("verb", "arguments", "said"), [
    ("motion", BOX, ["29.34434865546477 s\n", "27.27583751781326 rad in a period\n"]),
    ("conditions", TOP, ["\n  l is in kg m² s⁻¹.\n"]), ("decide", ARCS, ["\n  ω is in rad/s.\n"])])
def test_what_is_found_has_units(capsys, verb, arguments, said):
    """Period, angle, solved name and rates; without units in the input the same digits alone."""
    status, out, err = run(capsys, *arguments, verb=verb)
    assert status == 0 and all(text in out + err for text in said)
    status, plain, facts = run(capsys, *bare(arguments), verb=verb)
    assert status == 0 and not any(text in plain + facts for text in said)
    assert not any(unit in plain + facts for unit in (" is in ", " rad in", "477 s\n"))


@pytest.mark.parametrize("unit", ["kg m^2", ""])
def test_units_in_a_rotor_of_a_file(tmp_path, unit):
    """A rotor becomes part of the tensor, in SI; that it had units is not lost."""
    path = tmp_path / "station.toml"
    path.write_text(FILE.replace("UNIT", unit))
    given = with_scene(parser().parse_args(["decide", "--scene", str(path)]))
    assert units_given(given) == bool(unit)
