"""Numbers and equilibria as a person types them: several after one --set, Greek, words of the field."""
import json

import pytest
from commands import decide, run

from gyrostat.cli.options.axis_option import axis_of
from gyrostat.cli.options.scene_files import with_scene
from gyrostat.cli.parser import main, parser
from gyrostat.errors import GyrostatError, ValuesError
from gyrostat.mechanics.families.named_families import FAMILIES, called, in_words, known_of, named
from gyrostat.mechanics.scenes.kind import Kind
from gyrostat.questions.given_numbers import numbers_of

HEAVY = ["--potential", "m0*k3", "--equilibrium", "E1"]
SPUN = ["I1=1", "I3=1.6", "l=0", "m0=1", "omega3_0=1.25"]


@pytest.mark.parametrize("settings", [
    ["--set", *SPUN], ["--set", *SPUN[:2], "--set", *SPUN[2:]], [f"--set={each}" for each in SPUN],
    ["--set", "I₁=1", "I₃=1.6", "l=0", "m₀=1", "ω₃⁰=1.25"]])
def test_numbers_after_one_set_or_several(capsys, settings):
    """In any spelling; the verdict is one."""
    status, out, _ = decide(capsys, *HEAVY, *settings)
    assert (status, out) == decide(capsys, *HEAVY, *(f"--set={each}" for each in SPUN))[:2] and status == 0
    assert "Lyapunov stable" in out


@pytest.mark.parametrize(("settings", "said"), [
    (["I1=1", "I1=2"], "I1 is given twice"), (["π₃⁰=1", "pi3_0=1"], "pi3_0 is given twice"),
    (["ω₃⁰=1", "pi3_0=1"], "both pi3_0 and omega3_0"), (["I1=1,6"], "write a decimal point, 1.6"),
    (["I1=1,I3=2"], "the setting I1=1,I3=2 is not NAME=VALUE: write, for example, I1=1.6 l=1/2"),
    (["I1=1,", "I3=2"], "the setting I1=1, is not NAME=VALUE"),
    (["I1", "=", "1"], "the setting I1 is not NAME=VALUE"),
    (["І1=1"], "is not NAME=VALUE, 'І' (CYRILLIC CAPITAL LETTER BYELORUSSIAN-UKRAINIAN I) is in no name")])
def test_numbers_that_are_refused(settings, said):
    """With what was typed, and how it is to be."""
    with pytest.raises(GyrostatError) as error:
        numbers_of(settings)
    assert said in str(error.value)


def test_axes_and_names_to_solve_for_are_spelled_alike(capsys):
    """--x π₃⁰=…, --solve-for π₃⁰."""
    assert axis_of("--x", "π₃⁰=-1:1:3")[0] == "pi3_0"
    with pytest.raises(ValuesError, match="'а' .CYRILLIC SMALL LETTER A. is in no name: write, for example"):
        axis_of("--x", "а=-1:1:3")
    asked = [*HEAVY, "--set", "I1=1", "l=1", "--solve-for"]
    answers = [run(capsys, *asked, name, verb="conditions") for name in ("π₃⁰", "pi3_0")]
    assert answers[0] == answers[1] and answers[0][0] == 0 and "Stable for" in answers[0][1]


@pytest.mark.parametrize(("text", "label"), [("E2", "E2"), ("e2", "E2"), ("hanging", "E2"), ("Hanging", "E2"),
                                             ("inclined", "E3"), ("UPRIGHT", "E1")])
def test_equilibria_have_the_words_of_the_field(text, label):
    """Of every verb that has the option."""
    for verb in ("report", "conditions"):
        assert parser().parse_args([verb, "--equilibrium", text]).equilibrium == [label]
    assert parser().parse_args(["decide", "--equilibrium", text]).equilibrium == label


def test_the_words_are_those_of_the_families():
    """A word that several have names none of them."""
    assert list(named(known_of(Kind.FIELD))) == ["E1", "E2", "E3", "permanent-rotation", "upright", "hanging",
                                              "inclined"]
    assert in_words(known_of(Kind.FIELD)) == (
        "E1 or upright, E2 or hanging, E3 or inclined, permanent-rotation")
    free = known_of(Kind.FREE)
    assert called("Axis 2", free) is FAMILIES["rotation about axis 2"]
    assert called("principal rotation", free) is None


@pytest.mark.parametrize(("text", "said"), [
    ("uprigth", "uprigth is no equilibrium: did you mean upright? give E1 or upright, E2 or hanging, E3 or "),
    ("E4", "E4 is no equilibrium: give E1 or upright, E2 or hanging, E3 or inclined")])
def test_a_word_that_is_none_is_guessed(capsys, text, said):
    """The list has both names."""
    with pytest.raises(SystemExit):
        main(["decide", "--equilibrium", text])
    assert said in capsys.readouterr().err


def test_a_name_of_a_field_is_no_formula(capsys):
    """What is wanted, and where the formulas are; a letter for k3 is guessed as before."""
    status, out, err = decide(capsys, "--potential", "newtonian", "--set", "I1=2")
    assert (status, out) == (2, "") and "U is a formula, such as m0*k3" in err
    assert "reference/fields.md" in err
    err = decide(capsys, "--potential", "K3", "--set", "I1=2")[2]
    assert "k3 for K3, as in U = k3" in err and "formula" not in err


def test_a_part_of_the_rotor_alone_is_a_name_of_the_scene(capsys):
    """Of a free body in no equilibrium that is known: what finds all; what is no name has a list of them."""
    given = ["--potential", "none", "--inertia", "1,2,3", "--set", "l1=1"]
    status, out, err = run(capsys, *given, verb="report")
    assert (status, err) == (0, "") and "decide finds all if" in " ".join(out.split())
    status, out, err = run(capsys, *given, "l7=2", verb="report")
    assert (status, out) == (2, "") and "its parameters are l1, l2, l3" in err


def test_a_batch_is_spelled_alike(capsys, tmp_path):
    """Names and equilibria of its lines; a name twice is refused."""
    lines = tmp_path / "spins.jsonl"
    lines.write_text('{"ω₃⁰": 1.25, "equilibrium": "Upright"}\n{"omega3_0": 1.25, "equilibrium": "E1"}\n'
                     '{"ω₃⁰": 1, "omega3_0": 2}\n{"equilibrium": "up"}\n', encoding="utf-8")
    status, out, err = decide(capsys, *HEAVY[:2], "--set", *SPUN[:4], "--batch", str(lines))
    first, second, third, fourth = map(json.loads, out.splitlines())
    assert status == 2 and first["equilibria"] == second["equilibria"]
    assert "omega3_0 gives a name twice" in third["error"]
    assert "the equilibrium as E1 or upright" in fourth["error"]


def test_a_scene_of_a_file_is_spelled_alike(capsys, tmp_path):
    """Its texts, its equilibrium; an axis and a number go before its numbers, however they are typed."""
    file = tmp_path / "top.toml"
    file.write_text('[scene.top]\npotential = "m₀·k₃"\nequilibrium = "Upright"\n'
                    'inertia = ["I₁", "I₁", "I₃"]\ngyrostatic_momentum = [0, 0, "l"]\n'
                    'values = { I1 = 1, I3 = 1.6, l = 0, m0 = 1, omega3_0 = 9 }\n', encoding="utf-8")
    found = decide(capsys, "--scene", str(file), "--set", "ω₃⁰=1.25")
    assert found == decide(capsys, *HEAVY, "--set", *SPUN) and found[0] == 0
    axes = ["--x", "ω₃⁰=1:2:3", "--y", "l=0:1:3"]
    asked = with_scene(parser().parse_args(["chart", "--scene", str(file), *axes]))
    assert asked.values == ["I1=1", "I3=1.6", "m0=1"] and asked.equilibrium == "E1"
