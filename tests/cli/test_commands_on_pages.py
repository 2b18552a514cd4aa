"""The commands that pages and README show are understood by the command line."""
import re
import shlex
from pathlib import Path

import pytest

from gyrostat.cli.parser import parser

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(ROOT.glob("docs/**/*.md"))]
BLOCK = re.compile(r"```sh\n(.*?)```", re.DOTALL)


def commands(page):
    """The arguments of every gyrostat that is typed in a block of a shell."""
    for block in BLOCK.findall(page.read_text(encoding="utf-8")):
        for line in re.sub(r"\\\n|\s# .*", " ", block).splitlines():
            for typed in line.split("&&"):
                program, *arguments = shlex.split(typed) or [""]
                if Path(program).name == "gyrostat" and arguments != ["--version"]:
                    yield arguments


CASES = [(page, arguments) for page in PAGES for arguments in commands(page)]


def test_there_are_commands():
    """On README, and on pages of each kind."""
    assert {"README.md", "install.md", "satellites.md", "dual-spin.md"} <= {page.name for page, _ in CASES}


@pytest.mark.parametrize(("page", "arguments"), CASES, ids=lambda value: getattr(value, "name", " "))
def test_a_command_is_understood(page, arguments):
    """Its verb and its options are those of the parser; a wrong one ends with status 2."""
    assert parser().parse_args(arguments).verb == arguments[0]
