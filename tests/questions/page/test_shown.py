"""What a page shows of a scene."""
import contextlib
import io
import json
import tomllib
from pathlib import Path

import pytest
import session
from compiled import MORE

import gyrostat as gs
from gyrostat.cli.parser import main
from gyrostat.mechanics.families.scene_tables import SceneTable
from gyrostat.questions.page.chosen import chosen

TRY = Path(session.__file__).parent
EXAMPLES = json.loads((TRY / "examples.json").read_text(encoding="utf-8"))
TOP = EXAMPLES[0]["scene"]
VALUES = {"I1": "1", "I2": "1.2", "I3": "sqrt(2)", "l": "1/3", "k3": "1/2", "omega": "2", "omega2_0": "1",
          "m": "1", "omega3_0": "3", "pi3_0": "3"}
SCENES = [*(example["scene"] for example in EXAMPLES),
          {"potential": "sqrt(2)*m/3*k3 + exp(k3)", "inertia": ["I1", "I1", "1/3"], "values": VALUES,
           "gyrostatic_momentum": ["0", "0", "l"], "equilibrium": "E1", "spin": "omega3_0"},
          {"potential": "none", "inertia": [["3", "0", "1/2"], ["0", "4", "0"], ["1/2", "0", "5"]],
           "gyrostatic_momentum": ["0", "0", "0"], "equilibrium": "axis 2", "values": VALUES},
          {"potential": "c1*k1 + c3*k3", "inertia": ["I1", "I2", "I3"], "direction": "sin(a), 0, cos(a)",
           "equilibrium": "permanent-rotation", "gyrostatic_momentum": ["0", "0", "l"],
           "values": {**VALUES, "a": "0", "sigma": "-9", "I3": "3"}}]


def answered(want, scene):
    """The answer, as JSON has it."""
    return json.loads(json.dumps(gs.questions.show(scene, want, *MORE.get(want, ()))))


def test_the_latex_says_what_its_symbols_are():
    """The field, its letters, the rate."""
    copied = answered("copied", TOP)["latex"]
    for said in ("potential, $U$ = $m_0 k_3$", "$m_0$ & weight times height", r"$\omega_3^0$ & body rate"):
        assert said in copied


def test_rumiantsevs_condition_is_what_the_first_example_shows():
    """In LaTeX, with the names that a verdict needs."""
    found = answered("analysed", TOP)
    assert {"display": r"\left(I_3 \omega_3^0 + l\right)^{2} > 4 I_1 m_0"} in found["conditions"]
    assert [name["name"] for name in found["names"]] == ["I1", "I3", "l", "m0", "omega3_0"]
    assert [family["name"] for family in found["equilibria"]] == [
        "E1", "E2", "E3", "point", "every omega", "every k3", "every pi3_0 C1"]


@pytest.mark.parametrize("spin, verdict", [("1.2499999", "UNSTABLE"), ("1.25", "STABLE"), ("5/4", "STABLE")])
def test_a_verdict_is_exact(spin, verdict):
    """On both sides of the boundary, and on it; with its reason."""
    found = answered("decided", {**TOP, "values": {**TOP["values"], "omega3_0": spin}})
    assert found["verdict"] == verdict
    assert any("Reason" in str(block) for block in found["blocks"])


@pytest.mark.parametrize("scene", SCENES, ids=str)
@pytest.mark.few(2)
def test_every_example_is_answered(scene):
    """Whatever is wanted, and its values are those that a verdict needs."""
    for want in gs.questions.WANTED:
        found = answered(want, scene)
        assert "error" not in found, found
        if want == "analysed":
            assert {name["name"] for name in found["names"]} <= scene["values"].keys()


@pytest.mark.parametrize("scene", SCENES, ids=str)
@pytest.mark.few(4)
def test_what_is_copied_gives_the_same(scene):
    """The program prints the verdict; the scene file reads as the scene; the LaTeX has the conditions."""
    copied, decided = answered("copied", scene), answered("decided", scene)
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(copied["python"], {})                     # noqa: S102 (written by the page's own code)
    asked = chosen(scene)
    read = SceneTable(tomllib.loads(copied["scene"])["scene"]["mine"])
    assert read.system == asked.scene and read.family == asked.family
    if asked.every:
        place = "equilibrium in orbit" if "orbit" in scene else "rotation at"
        assert out.getvalue().count(place) == len(decided["found"])
        return
    verdict = decided["verdict"]
    assert out.getvalue() == f"{asked.report.necessary}\n{asked.report.sufficient}\n{verdict}\n"
    assert gs.analyze(asked.report.equilibrium).verdict(read.table["values"]).verdict.name == verdict
    shown = [block["display"] for block in answered("analysed", scene)["conditions"] if "display" in block]
    assert any(formula in copied["latex"] for formula in shown) or not shown


LEVELS = [({}, "every omega", {"omega": "2"}), ({}, "every k3", {"k3": "1/2"}),
          ({}, "every pi3_0 C1", {"pi3_0": "2", "C1": "1"}),
          ({"potential": "c1*k1 + c3*k3", "inertia": ["I1", "I2", "I3"]}, "every C1",
           {"I2": "1.2", "c1": "1/2", "c3": "1", "C1": "1/4"}),
          ({"potential": "none", "inertia": ["I1", "I2", "I3"]}, "every M", {"I2": "1.2", "M": "5/2"}),
          ({"potential": "none", "orbit": "omega0", "inertia": ["I1", "I2", "I3"]}, "every",
           {"I2": "1.2", "omega0": "1"})]


@pytest.mark.few(3)
@pytest.mark.parametrize("table, every, values", LEVELS, ids=[every for _, every, _ in LEVELS])
def test_a_copied_scene_file_keeps_the_level_that_was_asked(table, every, values, tmp_path, capsys):
    """It says which, and `decide` answers it with the same verdicts as the page."""
    scene = {**TOP, **table, "equilibrium": every,
             "values": {"I1": "1", "I3": "1.6", "l": "0", "m0": "1", **values}}
    copied = answered("copied", scene)["scene"]
    level = ", ".join(f"{name} = {values[name]}" for name in every.split()[1:])
    assert copied.startswith(f"# every equilibrium{f' at {level}' if level else ''}: gyrostat decide --scene")
    file = tmp_path / "scene.toml"
    file.write_text(copied, encoding="utf-8")
    assert main(["decide", "--scene", str(file), "--format", "json"]) == 0
    decided = [found["decision"]["verdict"] for found in json.loads(capsys.readouterr().out)["equilibria"]]
    assert sorted(decided) == sorted(found["verdict"] for found in answered("decided", scene)["found"])


def test_a_level_on_two_lines_stays_in_its_comment():
    """What is typed does not leave it."""
    scene = {**TOP, "equilibrium": "every k3", "values": {**TOP["values"], "k3": "1\n/2"}}
    copied = answered("copied", scene)["scene"]
    assert copied.startswith("# every equilibrium at k3 = 1 /2: ") and tomllib.loads(copied)["scene"]["mine"]


@pytest.mark.parametrize("name, said", [
    ("M0", "not m0"), ("L", "not l"), ("Omega0", "not omega0"), ("m0", ""), ("mass", "")])
def test_a_name_in_other_capitals_says_which_it_is_not(name, said):
    """Beside its number."""
    found = answered("analysed", {**TOP, "potential": f"{name}*k3"})
    meaning = next(entry["meaning"] for entry in found["names"] if entry["name"] == name)
    assert (f"; {said}: capitals count in names" in meaning) if said else ("capitals" not in meaning)


def test_a_name_has_its_dimension_and_is_printed_without_latex():
    """That of the table; a parameter of the user has none."""
    found = {entry["name"]: entry for entry in answered("analysed", {**TOP, "potential": "c1*k3"})["names"]}
    assert {name: (entry["text"], entry["dimension"]) for name, entry in found.items()} == {
        "I1": ("I₁", [1, 0, 0]), "I3": ("I₃", [1, 0, 0]), "l": ("l", [1, 1, 0]),
        "omega3_0": ("ω₃⁰", [0, 1, 0]), "c1": ("c₁", None)}


def test_an_equilibrium_that_a_field_does_not_have_says_why():
    """The others are listed beside it."""
    found = answered("analysed", {"potential": "c1*k1 + c3*k3", "equilibrium": "E1"})
    assert "E1 is not an equilibrium" in found["error"]
    assert [bool(family["why"]) for family in found["equilibria"]] == [True, True, *[False] * 4]


@pytest.mark.parametrize("table, first", [
    ({"potential": "none", "inertia": ["I1", "I2", "I3"], "gyrostatic_momentum": ["0", "0", "l"]}, "axis 3"),
    ({"potential": "c1*k1 + c3*k3"}, "permanent-rotation"),
    ({"orbit": "omega0", "equilibrium": "E1"}, "earth-pointing"),
    ({"orbit": "omega0", "equilibrium": "every"}, "every"), ({"equilibrium": "every omega"}, "axis 1")])
def test_the_first_equilibrium_that_a_scene_has_is_chosen(table, first):
    """Where it names none, or one of another kind of scene."""
    assert answered("analysed", table)["chosen"] == first
