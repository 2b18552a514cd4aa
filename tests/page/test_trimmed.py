"""What is named of python-flint is loaded where it is first used, all else is left out."""
import importlib
import sys

import pytest
from trimmed import lazy, named

PACKAGE = """
from .other import ctx
from .types.a import a, a_ctx
from .types.b import b
from .functions.f import f
__version__ = "1"
__all__ = ["ctx", "a", "a_ctx", "b", "f"]
"""


def test_names_are_found_wherever_they_are_imported(tmp_path):
    """In one line, in several, and as attributes."""
    (tmp_path / "one.py").write_text("from flint import arb, fmpq\nimport flint\nflint.fmpz(1)\n",
                                     encoding="utf-8")
    (tmp_path / "two.py").write_text("from flint import (\n    acb,\n    ctx)\n", encoding="utf-8")
    assert named([tmp_path]) == {"arb", "fmpq", "fmpz", "acb", "ctx"}


def test_a_type_is_loaded_where_it_is_first_used(tmp_path, monkeypatch):
    """Another one is an attribute that is not there."""
    folder = tmp_path / "lazily"
    (folder / "types").mkdir(parents=True)
    (folder / "__init__.py").write_text(lazy(PACKAGE, {"a", "ctx"}), encoding="utf-8")
    (folder / "other.py").write_text("ctx = 0\n", encoding="utf-8")
    (folder / "types" / "a.py").write_text("a = 1\na_ctx = 2\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    package = importlib.import_module("lazily")
    assert (package.ctx, package.__version__) == (0, "1") and "lazily.types.a" not in sys.modules
    assert package.a == 1 and "lazily.types.a" in sys.modules
    for name in ("a_ctx", "b", "f"):
        with pytest.raises(AttributeError, match=name):
            getattr(package, name)
