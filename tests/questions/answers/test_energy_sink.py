"""The energy-sink condition of a dual spinner on the command line."""
import json

import pytest
from commands import run

ROTOR = 'rotors = [{ axis = [0, 0, 1], axial = "40 kg m^2", rate = "60 rpm" }]'
DAMPERS = ("--platform-damping", "c_p", "--rotor-damping", "c_r")


@pytest.fixture
def scene(tmp_path):
    """A long satellite whose platform is despun, of the transverse moment that is asked for."""
    def written(transverse="1000 kg m^2", rotors=ROTOR):
        path = tmp_path / f"{len(list(tmp_path.iterdir()))}.toml"
        lumped = "lumped = true" if rotors else ""
        path.write_text(f'[scene.dual]\ninertia = ["1000 kg m^2", "{transverse}", "200 kg m^2"]\n{rotors}\n'
                        f"{lumped}\nvalues = {{ omega3_0 = 0 }}\n", encoding="utf-8")
        return ["--scene", str(path)]
    return written


def test_it_is_added(capsys, scene):
    """P − A Ω_p = 80 π and P − A Ω_r = 80 π − 2000 π: the platform 24 times as much as the rotor."""
    status, out, _ = run(capsys, *scene(), *DAMPERS, verb="conditions")
    assert status == 0 and "\n    c_p > 24 c_r\n" in out and "to first order" in out
    _, out, _ = run(capsys, *scene(), *DAMPERS, "--format", "json", verb="conditions")
    sink = json.loads(out)["energy_sink"]
    assert sink["notion"] == "energy sink" and sink["any_of"][0]["all_of"][0]["margin"] == "c_p - 24*c_r"
    _, out, _ = run(capsys, *scene(), *DAMPERS, "--format", "latex", verb="conditions")
    assert "Energy sink" in out and r"c_p > 24 c_r" in out.replace("{p}", "p").replace("{r}", "r")
    for numbers, said in ((("25", "1"), "always"), (("23", "1"), "never"), (("1", None), "always")):
        given = [text for pair in zip(DAMPERS[::2], numbers) if pair[1] for text in pair]
        out = run(capsys, *scene(), *given, verb="conditions")[1]
        assert f"  Stable, to first order in weak dampers: {said}.\n" in out
    assert "Energy sink" not in run(capsys, *scene(), verb="conditions")[1]


def test_what_is_refused(capsys, scene):
    for given, why in (
        (["--potential", "none", *DAMPERS], "the scene has 0 rotors"),
        ([*scene(rotors=""), *DAMPERS], "the scene has 0 rotors"),
        ([*scene(transverse="900 kg m^2"), *DAMPERS], "a body of revolution"),
        ([*scene(), "--platform-damping=-1"], "damping takes power"),
        ([*scene(), "--platform-damping", "import os"], "import"),
        ([*scene(rotors=ROTOR.replace("[0, 0, 1]", "[0, 3, 4]")), *DAMPERS], "is for a principal axis"),
    ):
        status, out, err = run(capsys, *given, verb="conditions")
        assert (status, out) == (2, "") and why in err and err.count("\n") == 1, err
