"""Names of packages are loaded where they are first used."""
import importlib
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from trimmed import FIRST, lazy, named

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


@pytest.fixture
def package(tmp_path, monkeypatch):
    """What makes a package of modules by their texts, lazy, and imports it."""
    def made(name, modules, first, names=None):
        for path, text in modules.items():
            place = tmp_path / name / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, encoding="utf-8")
        text = lazy(tmp_path / name, name, first, names)
        (tmp_path / name / "__init__.py").write_text(text, encoding="utf-8")
        return importlib.import_module(name)
    monkeypatch.syspath_prepend(tmp_path)
    return made


def test_a_type_is_loaded_where_it_is_first_used(package):
    """Another one is an attribute that is not there."""
    found = package("lazily", {"__init__.py": PACKAGE, "other.py": "ctx = 0\n",
                               "types/a.py": "a = 1\na_ctx = 2\n"}, {"other"}, {"a"})
    assert (found.ctx, found.__version__) == (0, "1") and "lazily.types.a" not in sys.modules
    assert found.a == 1 and "lazily.types.a" in sys.modules
    for name in ("a_ctx", "b", "f"):
        with pytest.raises(AttributeError, match=name):
            getattr(found, name)


def test_a_function_is_not_taken_for_the_module_of_its_name(package):
    """After `import twins.solve` twins.solve is the function still, as without laziness."""
    code = "from .solve import solve, others\nfrom .far import here as there\n"
    found = package("twins", {"__init__.py": code, "far.py": "here = 3\n",
                              "solve.py": "def solve(): return 1\ndef others(): return 2\n"}, set())
    importlib.import_module("twins.solve")
    assert found.solve() == 1 and found.others() == 2
    assert "twins.far" not in sys.modules and found.there == 3


def test_a_module_is_an_attribute_as_if_it_were_loaded(package):
    """In what it imports itself an error remains one."""
    found = package("parts", {"__init__.py": "from parts.one import x\n", "one.py": "x = 1\n",
                              "two.py": "y = 2\n", "bad.py": "import nowhere_at_all\n"}, set())
    assert found.two.y == 2 and found.x == 1
    with pytest.raises(ModuleNotFoundError, match="nowhere_at_all"):
        found.bad  # noqa: B018


NAMES = """
import importlib, json, sys
packages, seed = json.loads(sys.argv[1]), int(sys.argv[2])
names = sorted((package, name) for package in packages for name in packages[package])
found = {}
for package, name in names[seed:] + names[:seed]:
    it = getattr(importlib.import_module(package), name)
    found[f"{package}:{name}"] = [str(getattr(it, x, "")) for x in ("__class__", "__module__", "__name__")]
print(json.dumps(found))
"""


@pytest.mark.slow
@pytest.mark.parametrize("first", [0, 300, 900])
def test_sympy_has_the_names_that_it_has(tmp_path, first):
    """Every public one, whichever is asked first, is what it is in SymPy as it comes."""
    for package in (package for package in FIRST if package != "flint"):
        home = Path(importlib.import_module(package).__file__).parent
        place = tmp_path.joinpath(*package.split("."))
        if place.is_symlink():
            place.unlink()
        place.mkdir()
        for path in home.iterdir():
            if path.name not in ("__init__.py", "__pycache__"):
                (place / path.name).symlink_to(path)
        (place / "__init__.py").write_text(lazy(home, package, FIRST[package]), encoding="utf-8")
    public = {package: sorted(importlib.import_module(package).__all__) for package in FIRST
              if package != "flint"}
    lazily, as_it_comes = (json.loads(subprocess.run(
        [sys.executable, "-c", NAMES, json.dumps(public), str(first)], env=os.environ | {"PYTHONPATH": path},
        capture_output=True, text=True, check=True).stdout) for path in (str(tmp_path), ""))
    assert lazily == as_it_comes and len(lazily) > 1000
