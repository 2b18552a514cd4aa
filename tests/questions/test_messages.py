"""What is said of a scene that is given as a table."""
import ast
import re
from pathlib import Path

import pytest

import gyrostat as gs

SRC = Path(gs.__file__).parent / "questions"


@pytest.mark.parametrize("path", sorted(SRC.rglob("*.py")), ids=lambda path: str(path.relative_to(SRC)))
def test_no_message_names_an_option_of_the_command_line(path):
    """Whoever asks in Python has typed none; docstrings say which verb a function stands for."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    raised = [node for node in ast.walk(tree) if isinstance(node, ast.Raise)]
    texts = [part.value for node in raised for part in ast.walk(node)
             if isinstance(part, ast.Constant) and isinstance(part.value, str)]
    assert not [text for text in texts if re.search(r"--[a-z]", text)]


@pytest.mark.parametrize(("table", "said"), [
    ({"potential": "m0*k3", "equilibrium": "earth-pointing"}, "give an orbit"),
    ({"potential": "k1*k3", "inertia": ["1", "2", "3"]}, "give its point PI1,PI2,PI3,K1,K2,K3"),
    ({"potential": "none", "equilibrium": "E1"}, "give a potential, or name axis 1"),
    ({"potential": "k3", "point": ["0", "0", "1"]}, "has 3 numbers, and the body has 6 coordinates")])
def test_a_refused_table_is_told_what_to_give(table, said):
    """By the keys of the table."""
    with pytest.raises(gs.errors.GyrostatError, match=said) as error:
        gs.questions.conditions(table)
    assert "--" not in str(error.value)
