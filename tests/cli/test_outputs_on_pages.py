"""What how-to pages show as output is what their commands print."""
import re
import shlex
from pathlib import Path

import pytest
from commands import run
from slow import slow

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md"))]
FILE = re.compile(r"```toml\n# (\S+)\n(.*?)```", re.DOTALL)                 # its name stands on top of it
SHOWN = re.compile(r"```sh\n((?:[^\n`]*\\\n)*[^\n`]*)\n```\n\n```text\n(.*?)```", re.DOTALL)
OUTPUT = re.compile(r"```text\n(.*?)```", re.DOTALL)
CASES = [(page, command.replace("\\\n", ""), output) for page in PAGES
         for command, output in SHOWN.findall(page.read_text(encoding="utf-8"))]


@pytest.mark.parametrize(("page", "command", "output"), slow(*CASES))
def test_an_output_is_what_the_command_above_it_prints(capsys, tmp_path, monkeypatch, page, command, output):
    """In a terminal of 76 columns, beside the files of the page; ⋮ stands for lines that are not shown."""
    monkeypatch.setenv("COLUMNS", "76")
    monkeypatch.chdir(tmp_path)
    for name, content in FILE.findall(page.read_text(encoding="utf-8")):
        Path(name).write_text(content)
    program, verb, *arguments = shlex.split(command)
    _, out, _ = run(capsys, *arguments, verb=verb)
    assert program == "gyrostat"
    assert re.fullmatch(".*".join(map(re.escape, output.split("⋮\n"))), out, re.DOTALL)


def alone(name):
    """The outputs on a how-to page that stand below no command."""
    text = (ROOT / "docs" / "how-to" / name).read_text(encoding="utf-8")
    below = [output for _, output in SHOWN.findall(text)]
    return [output for output in OUTPUT.findall(text) if output not in below]


def test_every_output_is_compared():
    """Below its command, but for three refusals."""
    outputs = [output for page in PAGES for output in OUTPUT.findall(page.read_text(encoding="utf-8"))]
    assert len(outputs) == len(CASES) + len(alone("large-stores.md")) + len(alone("check-a-paper.md"))
    assert len(outputs) == len(CASES) + 3


def test_a_store_of_another_chart_is_refused_as_its_page_says(capsys, tmp_path, monkeypatch):
    """With other axes."""
    pytest.importorskip("zarr")
    monkeypatch.setenv("COLUMNS", "76")
    monkeypatch.chdir(tmp_path)
    top = ("--equilibrium", "upright", "--potential", "m0*k3", "--set", "I1=1", "--y", "l=-2:2:10",
           "--axis", "m0=0:2:2", "--output", "top.zarr")
    for x in ("pi3_0=-4:4:20", "pi3_0=-4:4:10"):
        status, _, err = run(capsys, *top, "--x", x, verb="chart")
    assert status == 2 and [err.replace(f"{tmp_path}/", "").split()] == [
        output.split() for output in alone("large-stores.md")]


def refused(capsys, folder, monkeypatch, paper):
    """What verify writes of a refused file, as wide as pages are."""
    monkeypatch.setenv("COLUMNS", "76")
    monkeypatch.chdir(folder)
    Path("my_paper.toml").write_text(paper)
    status, _, err = run(capsys, "my_paper.toml", verb="verify")
    assert status == 2
    return err


def test_a_letter_of_two_meanings_is_refused_as_its_page_says(capsys, tmp_path, monkeypatch):
    """In a formula about m g h k3."""
    err = refused(capsys, tmp_path, monkeypatch, """
        source = { name = "mine", title = "A paper" }
        scene = { top = { potential = "m*g*h*k3" } }
        [[formula]]
        key = "energy"
        where = "eq. (1)"
        quantity = "h"
        printed = "pi1"
        kind = "identity"
        scene = "top" """)
    assert err == alone("check-a-paper.md")[1]


def test_unknown_names_are_refused_as_their_page_says(capsys, tmp_path, monkeypatch):
    """Two in the condition of the page, one of them in another statement; the page has the first lines."""
    page = (ROOT / "docs/how-to/check-a-paper.md").read_text(encoding="utf-8")
    (paper,) = (text for name, text in FILE.findall(page) if name == "my_paper.toml")
    wrong = paper.replace("omega3_0)", "omega_30)").replace("2*I1*m0", "2*I1*mass")
    err = refused(capsys, tmp_path, monkeypatch, wrong + """
        [[formula]]
        key = "slow"
        where = "eq. (6)"
        quantity = "q"
        printed = "mass**2"
        kind = "identity"
        scene = "top" """)
    assert err.startswith(alone("check-a-paper.md")[0].removesuffix("⋮\n"))
