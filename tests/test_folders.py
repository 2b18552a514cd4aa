"""The folders of the house: how many modules each holds, their names, and what it tells of them."""
import ast
import re
from collections import defaultdict
from itertools import combinations
from pathlib import Path

import pytest

import gyrostat

SRC = Path(gyrostat.__file__).parent
FOLDERS = [path.parent for path in SRC.rglob("__init__.py")]


def modules(folder):
    """The names of the modules of a folder."""
    return {path.stem for path in folder.glob("*.py")} - {"__init__", "__main__"}


def test_folders_are_seen_at_a_glance():
    """At most 16 modules each; each picture has a file of its own."""
    for folder in FOLDERS:
        assert len(modules(folder)) <= 16 or folder.name == "plotting", folder


def differ_by_a_letter(one, other):
    """Whether one name becomes the other by at most one letter that is changed, added or left out."""
    short, long = sorted((one, other), key=len)
    changed = sum(a != b for a, b in zip(short, long))
    return len(short) == len(long) and changed <= 1 or any(
        long[:n] + long[n + 1:] == short for n in range(len(long)))


def test_no_two_modules_are_taken_for_each_other():
    """Within a package more than a letter tells two names apart; no name stands in three packages."""
    packages = defaultdict(list)
    for folder in FOLDERS:
        packages[folder.relative_to(SRC).parts[:1]] += sorted(modules(folder))
    for package, names in packages.items():
        assert not [pair for pair in combinations(names, 2) if differ_by_a_letter(*pair)], package
    everywhere = [name for names in packages.values() for name in names]
    assert not {name for name in everywhere if everywhere.count(name) > 2}


@pytest.mark.parametrize("folder", [folder for folder in FOLDERS if folder != SRC],
                         ids=lambda folder: str(folder.relative_to(SRC)))
def test_a_package_tells_what_its_modules_do(folder):
    """Its docstring has at most 12 lines, names every module and folder in it, and no other."""
    told = ast.get_docstring(ast.parse((folder / "__init__.py").read_text(encoding="utf-8")))
    inside = modules(folder) | {path.name for path in FOLDERS if path.parent == folder}
    assert len(told.splitlines()) <= 12
    assert {name for name in re.findall("`(.*?)`", told) if name.isidentifier()} == inside


def test_tests_stand_in_the_folders_of_what_they_test():
    """But those of the page, which no library is."""
    here = Path(__file__).parent
    folders = {path.parent.relative_to(here) for path in here.rglob("test_*.py")}
    assert {str(folder) for folder in folders if not (SRC / folder).is_dir()} == {"browser", "page"}
