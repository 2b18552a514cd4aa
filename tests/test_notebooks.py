"""The notebooks as they are committed.

Executed, small, readable, and made of public names. CI runs them again.
"""
import ast
import importlib
import json
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
KEPT = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}


def cells(path, kind):
    return [cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
            if cell["cell_type"] == kind]


def code(path):
    return ast.parse("\n".join("".join(cell["source"]).rstrip(";") for cell in cells(path, "code")))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
class TestNotebook:
    def test_title_asks_one_question(self, path):
        """The first line is a question, and the file is named by it."""
        title = "".join(cells(path, "markdown")[0]["source"]).splitlines()[0]
        assert title.startswith("# ") and title.endswith("?") and path.stem == path.stem.lower()

    def test_is_committed_executed(self, path):
        """Every cell has been run in order, without an error or a warning."""
        run = cells(path, "code")
        assert [cell["execution_count"] for cell in run] == list(range(1, len(run) + 1))
        outputs = [output for cell in run for output in cell["outputs"]]
        assert not [o for o in outputs if o["output_type"] == "error" or o.get("name") == "stderr"]

    def test_is_small_and_says_nothing_of_the_machine(self, path):
        """Less than 400 kB; no times of execution, no state of widgets, no paths."""
        text = path.read_text(encoding="utf-8")
        notebook = json.loads(text)
        assert len(text.encode()) < 400_000 and not any(cell["metadata"] for cell in notebook["cells"])
        assert {key: value for key, value in notebook["metadata"].items() if key != "language_info"} == KEPT
        assert not any(place in text for place in ("/tmp/", "/home/", "/root/", "site-packages", "C:\\\\"))

    def test_functions_are_short_and_names_public(self, path):
        """No function is longer than five lines, and nothing private is imported."""
        for node in ast.walk(code(path)):
            if isinstance(node, ast.FunctionDef):
                assert node.end_lineno - node.lineno < 5, node.name
            if isinstance(node, ast.ImportFrom) and node.module.startswith("gyrostat"):
                module = importlib.import_module(node.module)
                assert all(hasattr(module, name.name) and not name.name.startswith("_")
                           for name in node.names)
