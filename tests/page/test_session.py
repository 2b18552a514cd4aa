"""What the page of the site asks of the library: one function, JSON in, JSON out."""
import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest
import session
from compiled import MORE
from fuzz_texts import drawn

import gyrostat as gs

TRY = Path(session.__file__).parent
TOP = json.loads((TRY / "examples.json").read_text(encoding="utf-8"))[0]["scene"]


def answered(want, scene):
    """The answer, which is JSON whatever is asked."""
    return json.loads(session.answer(json.dumps({"want": want, "scene": scene, "more": MORE.get(want, ())})))


def test_it_imports_nothing_but_public_names():
    """The page is no second library: it stands on gyrostat and its namespaces."""
    for path in TRY.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                assert not [a.name for a in node.names if a.name.startswith("gyrostat.")], path.name
            elif isinstance(node, ast.ImportFrom) and (node.module or "").partition(".")[0] == "gyrostat":
                home = gs
                for name in node.module.split(".")[1:]:
                    assert name in home.__all__, (path.name, node.module)
                    home = getattr(home, name)
                known = set(getattr(home, "__all__", vars(home)))
                assert {alias.name for alias in node.names} <= known, path.name


def test_memory_that_is_not_there_is_said(monkeypatch):
    """It is no bug to be reported."""
    def full(*_):
        raise MemoryError
    monkeypatch.setattr(session, "show", full)
    said = answered("decided", TOP)["error"]
    assert "more memory" in said and "bug" not in said


@pytest.mark.parametrize("change, said", [
    ({"potential": "__import__('os')"}, "not part of the grammar"),
    ({"potential": "m0"}, "does not depend on k3"),
    ({"inertia": ["1", "2"]}, "inertia"),
    ({"inertia": "x"}, "not three numbers"),
    ({"colour": "red"}, "a scene has no entry colour"),
    ({"values": {**TOP["values"], "I1": "abc("}}, "abc("),
    ({"values": {"a b": "1"}}, "is not a name"),
    ({"values": {"I1": "1"}}, "I3"),
    ({"equilibrium": "E9"}, "E9"),
    ({"spin": "speed"}, "speed"),
])
def test_what_is_refused_is_said_in_the_librarys_words(change, said):
    """One sentence of its own, no traceback."""
    found = answered("decided", {**TOP, **change})
    assert said in found["error"] and "internal error" not in found["error"]


@pytest.mark.slow
def test_hostile_texts_are_refused_or_answered():
    """Those of the fuzz corpus in the place of a field, of a moment and of a number."""
    for index in range(40):
        text = drawn(index, "page")[0]
        for scene in ({"potential": text}, {**TOP, "inertia": [text, text, "I3"]},
                      {**TOP, "values": {**TOP["values"], "I1": text}}, {**TOP, "values": {text: "1"}}):
            found = answered("decided", scene)
            assert "internal error" not in found.get("error", ""), (text, found)


@pytest.mark.slow
def test_the_page_needs_no_numpy():
    """It has no build of it for the browser."""
    code = ("import sys; sys.path.insert(0, sys.argv[1]); sys.modules['numpy'] = None; import session, json; "
            "from gyrostat.questions import WANTED; "
            "from compiled import MORE; print([session.answer(json.dumps({'want': w, 'scene': e['scene'], "
            "'more': MORE.get(w, ())})) for w in WANTED "
            "for e in json.load(open(sys.argv[1] + '/examples.json', encoding='utf-8'))])")
    run = subprocess.run([sys.executable, "-c", code, str(TRY)], capture_output=True, text=True, check=True)
    assert "error" not in run.stdout
