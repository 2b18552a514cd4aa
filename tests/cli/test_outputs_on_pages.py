"""What how-to pages show as output is what their commands print."""
import re
import shlex
from pathlib import Path

import pytest
from commands import run
from slow import slow

PAGES = sorted((Path(__file__).parents[2] / "docs" / "how-to").glob("*.md"))
FILE = re.compile(r"```toml\n# (\S+)\n(.*?)```", re.DOTALL)                 # its name stands on top of it
SHOWN = re.compile(r"```sh\n((?:[^\n`]*\\\n)*[^\n`]*)\n```\n\n```text\n(.*?)```", re.DOTALL)
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
