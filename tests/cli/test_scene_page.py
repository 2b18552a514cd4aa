"""The page on scenes: its commands run, its file is read."""
import re
import shlex
from pathlib import Path

import pytest
from commands import run
from slow import slow

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "scene-files.md"
TEXT = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
COMMANDS = [line for block in re.findall(r"```sh\n(.*?)```", TEXT, re.DOTALL)
            for line in block.replace("\\\n", " ").splitlines()]


@pytest.mark.skipif(not PAGE.exists(), reason="the page is not part of an installed copy")
@pytest.mark.parametrize("command", [*COMMANDS[:2], *slow(*((command,) for command in COMMANDS[2:]))])
def test_a_command_of_the_page(capsys, tmp_path, monkeypatch, command):
    """It answers, as it is typed, beside the file of the page."""
    monkeypatch.chdir(tmp_path)
    (file,) = re.findall(r"```toml\n(.*?)```", TEXT, re.DOTALL)
    Path("scenes.toml").write_text(file)
    program, verb, *arguments = shlex.split(command)
    status, out, _ = run(capsys, *arguments, verb=verb)
    assert program == "gyrostat" and status == 0 and (out or list(tmp_path.glob("*.png")))


def test_every_key_has_its_line():
    """The keys of a table that are for the command line, and no others."""
    from gyrostat.mechanics.families.scene_tables import KEYS
    listed = TEXT.split("## Options and keys")[1].split("\n## ")[0]
    named = re.findall(r"^- `(\w+)`", listed, re.MULTILINE)
    keys = KEYS - {"angles", "vertical", "given", "parameters"}
    assert len(named) == len(set(named)) and set(named) == keys
