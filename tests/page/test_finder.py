"""The modules of the page are those of a table; what they are does not depend on where they come from."""
import importlib
import marshal
import sys
from importlib.resources import files

import pytest
from compiled import table
from finder import Table

MODULES = {"tabled/__init__.py": "from .part import x\n", "tabled/part.py": "x = 1\nname = __name__\n",
           "tabled/deep/__init__.py": "", "tabled/deep/below.py": "from ..part import x\ny = x + 1\n",
           "alone.py": "z = 3\n"}


@pytest.fixture
def tabled(monkeypatch, tmp_path):
    """The table of these modules, in use, beside a folder with other files of theirs."""
    codes = {path: marshal.dumps(compile(text, path, "exec")) for path, text in MODULES.items()}
    (tmp_path / "table").write_bytes(table(codes))
    found = Table(tmp_path / "table")
    monkeypatch.setattr(sys, "meta_path", [found, *sys.meta_path])
    yield found
    found.file.close()
    for name in found.modules:
        sys.modules.pop(name, None)


def test_packages_and_modules_are_found_by_their_names(tabled):
    """What is imported relatively too; a package has a path, a module none."""
    below, alone = importlib.import_module("tabled.deep.below"), importlib.import_module("alone")
    assert (below.y, alone.z) == (2, 3) and sys.modules["tabled.part"].name == "tabled.part"
    assert below.__package__ == "tabled.deep" and sys.modules["tabled"].x == 1
    assert not hasattr(alone, "__path__") and not hasattr(below, "__path__")
    assert set(tabled.modules) == {"tabled", "tabled.part", "tabled.deep", "tabled.deep.below", "alone"}


def test_what_is_not_in_the_table_is_looked_for_as_ever(tabled, tmp_path):
    """A library that lies in the folder of a package; a module that is nowhere."""
    (tmp_path / "tabled" / "deep").mkdir(parents=True)
    (tmp_path / "tabled" / "deep" / "beside.py").write_text("w = 4\n", encoding="utf-8")
    assert importlib.import_module("tabled.deep.beside").w == 4
    with pytest.raises(ModuleNotFoundError, match="nowhere"):
        importlib.import_module("tabled.nowhere")


def test_a_package_reads_its_files(tabled, tmp_path):
    """As glossary.toml is read."""
    (tmp_path / "tabled").mkdir()
    (tmp_path / "tabled" / "words.toml").write_text("a = 1", encoding="utf-8")
    importlib.import_module("tabled")
    assert files("tabled").joinpath("words.toml").read_text(encoding="utf-8") == "a = 1"
