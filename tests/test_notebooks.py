"""The notebooks as they are committed.

They are executed, small and readable, and use public names only. Their text reads its numbers from the code.
They have an order, a level and three exercises. CI executes them and compares their outputs;
`python docs/stored.py NOTEBOOK ...` stores these.
"""
import ast
import importlib
import json
import re
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
KEPT = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
INDEX = Path(__file__).parents[1] / "docs" / "notebooks" / "index.md"
WIDTH = 76                                           # columns that the site shows without scrolling
HIDDEN = {"jupyter": {"source_hidden": True}, "tags": ["remove-input"]}  # a sentence: its output is shown
FOLDED = {"jupyter": {"outputs_hidden": True, "source_hidden": True},    # a solution, unfolded by a button
          "mystnb": {"code_prompt_hide": "Hide the solution", "code_prompt_show": "Show the solution"},
          "tags": ["hide-cell"]}
CHANGED = [                 # what is put instead of what is written, and words of the sentences that follow
    ("where", {'"I1": 2, "I3": 1, "l": 0, "m0": 1': '"I1": 3, "I3": 2, "l": "1/3", "m0": "5/2"'},
     ("at $m_1 = 5/4$", "$m_1 = 5/2$ and")),
    ("why-does-a-s",
     {'"I1": 1, "I3": "1/2", "m0": 1': '"I1": "3/2", "I3": 2, "m0": "3/2"', "1, 20)": "1, 10)"},
     ("$m_0 = 3/2$", "= 3$.", "same tilt, 11.4°", "falls to 84.2°", "within 18.7°")),
    ("why-does-a-top", {'"2/3"), -1, -3': '"2/3"), -2, -12'}, ("$D_4 = 691181/1539000", "1.604556")),
    ("what-happens", {'"I1": 2, "I3": 1, "l": 0, "m0": 1': '"I1": 3, "I3": 1, "l": "1/3", "m0": 3'},
     ("$P^2 = 36 - 24", "at $m_1 = 3/4$ of order", "sign at $m_1 = 3/4$")),
    ("what-does-stable", {'"omega": 1, "k3": "1/2"': '"omega": "3/2", "k3": "0"'},
     ("tilted by 90°", "rotor $l = 2$", "= -4/3$")),
    ("why-does-dz", {"inertia = (1, 2, 3)": "inertia = (2, 3, 5)"},
     ("moments 2, 3, 5", "= 1/3$", "0.149071")),
    ("what-does-a", {"n = 10_000": "n = 500", '"I3": "0.6"': '"I3": "0.8"', "100, 10_000)": "100)"},
     ("twice 500", "I3 = 0.8", "1, 100 periods")),
    ("how-do-i-get", {'rate="2000 rpm"': 'rate="1000 rpm"', 'height = "500 km"': 'height = "400 km"',
                      '"f": "0.05 mN"': '"f": "0.4 mN"'},
     ("in 6 attitudes; 2 of", "above 130.932 rpm", "turns 7.6 times", "yaw wheel at 101 rpm")),
    ("how-do-we-get", {'rate="540 rpm"': 'rate="450 rpm"', '"100 kg m^2"': '"90 kg m^2"'},
     ("wheel at 450 rpm", "at 183.00 rpm (pitchfork)", "period 28.10 s")),
    ("which-rotations", {'(0, "1/2", 1), 2': '(0, "1/3", 1), 3'}, ("$\\omega = 3$",)),
    ("is-my", {'rate="600 rpm"': 'rate="300 rpm"', '"52 kg m^2"': '"53 kg m^2"'}, ("13.9 in the units",)),
    ("how-hard", {"(60, 70, 35)": "(60, 80, 50)"}, ("energy is 1.5 times the barrier",)),
    ("which-are", {'("3/10", "1/5", "1/10")': '("1/50", "3/100", "1/25")'}, ("with the wheel 24",)),
    ("what-does-the", {'"l": "1/2"': '"l": "1/4"'}, ("$l = 1/4$",)),
]


def cells(path, kind):
    return [cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
            if cell["cell_type"] == kind]


def says(cell):
    """Whether a cell is code whose output is a sentence."""
    return "".join(cell["source"]).startswith("Markdown(")


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
        """Less than 400 kB; no times, no state of widgets, no paths; the code of sentences is hidden."""
        text = path.read_text(encoding="utf-8")
        notebook = json.loads(text)
        assert len(text.encode()) < 400_000
        for cell in notebook["cells"]:
            assert cell["metadata"] in ([HIDDEN] if says(cell) else [{}, FOLDED])
        assert {key: value for key, value in notebook["metadata"].items() if key != "language_info"} == KEPT
        assert not any(place in text for place in ("/tmp/", "/home/", "/root/", "site-packages", "C:\\\\"))

    def test_says_for_whom_it_is(self, path):
        """The first cell ends with place and level, what is needed and what is learnt; the index agrees."""
        place = [line.split("(")[1].rstrip(")") for line in INDEX.read_text(encoding="utf-8").splitlines()
                 if line.endswith(".ipynb)")].index(path.name) + 1
        lines = "".join(cells(path, "markdown")[0]["source"]).splitlines()[-3:]
        starts = f"- **Notebook {place} of {len(NOTEBOOKS)}**, level: ", "- **You need** ", "- **You learn** "
        assert all(line.startswith(start) for line, start in zip(lines, starts, strict=True))

    def test_has_three_exercises_with_solutions_folded_away(self, path):
        """It ends with three exercises, each followed by code that solves it and prints what it finds."""
        *_, first, a, second, b, third, c = json.loads(path.read_text(encoding="utf-8"))["cells"]
        assert "## Exercises\n" in first["source"]
        for n, (exercise, solution) in enumerate(((first, a), (second, b), (third, c)), 1):
            assert f"**Exercise {n}.** " in "".join(exercise["source"])
            assert solution["metadata"] == FOLDED and solution["outputs"]

    def test_fits(self, path):
        """No line of shown code or of an output in text is wider than the site shows."""
        for cell in cells(path, "code"):
            shown = [] if says(cell) else "".join(cell["source"]).splitlines()
            for output in cell["outputs"]:
                if not {"image/png", "text/latex", "text/markdown"} & set(output.get("data", ())):
                    text = output.get("text") or output["data"]["text/plain"]
                    shown += "".join(text).splitlines()
            assert max(map(len, shown), default=0) <= WIDTH, max(shown, key=len)

    def test_functions_are_short_and_names_public(self, path):
        """No function is longer than five lines, and nothing private is imported."""
        for node in ast.walk(code(path)):
            if isinstance(node, ast.FunctionDef):
                assert node.end_lineno - node.lineno < 5, node.name
            if isinstance(node, ast.ImportFrom) and node.module.startswith("gyrostat"):
                module = importlib.import_module(node.module)
                assert all(hasattr(module, name.name) and not name.name.startswith("_")
                           for name in node.names)

    def test_text_gives_no_number_that_the_code_has(self, path):
        """Text that says I1 = 2 would be wrong where a reader takes another number."""
        number = re.compile(r"(\b|\\)(I_\d|I|m_\d|l|omega_\d|pi_3|d|t|P) = \(?-?\d")
        for cell in cells(path, "markdown"):
            assert not number.search("".join(cell["source"]))


def test_the_index_has_the_order_that_the_notebooks_say():
    """Notebook n of 15 is the nth of its list, and of its pages."""
    page = (Path(__file__).parents[1] / "docs" / "notebooks" / "index.md").read_text(encoding="utf-8")
    said = {int(re.search(r"Notebook (\d+) of (\d+)", path.read_text(encoding="utf-8"))[1]): path.stem
            for path in NOTEBOOKS}
    order = [said[n] for n in range(1, len(NOTEBOOKS) + 1)]
    assert re.findall(r"^\d+\. \[.*\]\((.*)\.ipynb\)$", page, re.MULTILINE) == order
    assert page.split(":hidden:\n")[1].split("```")[0].split() == order


def sentences(sources):
    """What the cells that are sentences say, after all cells have been run, here and not in a kernel."""
    names, said = {}, []
    matplotlib.use("Agg")
    with matplotlib.rc_context():
        for source in sources:
            if says({"source": source}):
                said.append(eval(source, names).data)
            else:
                exec(source, names)
        plt.close("all")
    return said


@pytest.mark.slow
@pytest.mark.parametrize(("stem", "changes", "words"), CHANGED, ids=[case[0] for case in CHANGED])
def test_changed_numbers_change_the_text(stem, changes, words):
    """With other numbers every cell runs, and the sentences say them."""
    pytest.importorskip("IPython")
    path, = [each for each in NOTEBOOKS if each.stem.startswith(stem)]
    sources = ["".join(cell["source"]) for cell in cells(path, "code")]
    for old, new in changes.items():
        assert sum(old in source for source in sources) == 1
        sources = [source.replace(old, new) for source in sources]
    said = sentences(sources)
    for word in words:
        assert any(word in sentence for sentence in said), (word, said)
        assert word not in path.read_text(encoding="utf-8")
