"""Questions about a scene as a table, held against the schemas that are published."""
import json

import pytest
from cli.test_json_schemas import faults
from commands import run
from scene_kinds import CASES

import gyrostat as gs
from gyrostat.errors import GyrostatError, ValuesError

HEAVY = {"potential": "m0*k3", "inertia": [5, 4, 3], "gyrostatic_momentum": [0, 0, "l"], "equilibrium": "E2"}
SCENES = [case.table | {"values": case.values} for case in CASES.values() if case.table is not None]


@pytest.mark.parametrize("scene", SCENES, ids=str)
@pytest.mark.few(2)
def test_what_is_asked_and_what_is_shown_is_described(scene):
    """Of every kind of scene, whatever is wanted; a key too many is refused."""
    assert not faults("scene", scene) and faults("scene", scene | {"colour": "red"})
    for want, more in {**dict.fromkeys(gs.questions.WANTED, ()), "charted": [["I1", "I3"]],
                       "edges": [["I1", "I3"], [["1/2", "2"], ["1/2", "2"]]]}.items():
        found = gs.questions.show(scene, want, *more)
        assert not faults("shown", found), want
        assert faults("shown", found | {"colour": "red"}), want


@pytest.mark.parametrize("scene", [{"values": {"I1": 1.5}}, {"values": {"I1": None}}, {"lumped": True},
                                   {"inertia": [1, 2]}, {"spin": "speed"}, {"orbit": {"mu": 1}}], ids=str)
def test_what_the_schema_of_a_scene_refuses_the_library_refuses(scene):
    """A float is no number as it is written."""
    assert faults("scene", scene)
    with pytest.raises(GyrostatError):
        gs.questions.decide(scene)


def test_conditions_are_solved_and_windows_opened(capsys):
    """As --solve-for and --windows do."""
    options = ("--potential", "m0*k3", "--inertia", "5,4,3", "--equilibrium", "E2")
    for more, asked, schema in ((["--windows"], {"windows": True}, "conditions"),
                                (["--solve-for", "l"], {"solve_for": "l"}, "solution")):
        _, out, _ = run(capsys, *options, *more, "--format", "json", verb="conditions")
        found = gs.questions.conditions(HEAVY, **asked)
        assert found == json.loads(out) and not faults(schema, found)


def test_arcs_are_the_answer_without_a_number_of_the_motion():
    """As decide writes them."""
    found = gs.questions.decide({"potential": "k1", "inertia": [1, 2, 3]})
    assert found["arcs"] and not faults("decide", found)


def test_what_is_not_shown_is_said():
    """With what there is."""
    with pytest.raises(ValuesError, match="'colours' is nothing that is shown: ask for analysed, decided"):
        gs.questions.show(HEAVY, "colours")
