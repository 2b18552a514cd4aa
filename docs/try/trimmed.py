"""Packages whose names are loaded where they are first used.

python-flint loads all of its types at once, some forty libraries of WebAssembly; SymPy all that solves,
integrates and draws.
"""
import ast
import re
from collections.abc import Iterable
from pathlib import Path

# of each package the modules that it loads itself, in their order; what they need they load
FIRST = {"flint": {"pyflint", "flint_base"},
         "sympy": {"release", "core", "logic", "assumptions", "polys", "series"},
         "sympy.tensor": set(), "sympy.printing": set(), "sympy.combinatorics": set(),
         "sympy.integrals": set()}
LAZY = '''{rest}
LAZILY = {places!r}


def __getattr__(name):
    from importlib import import_module
    place, known = LAZILY.get(name, (name, None))
    try:
        found = import_module(f"{{__name__}}.{{place}}")
    except ModuleNotFoundError as error:
        if error.name != f"{{__name__}}.{{place}}":
            raise
        raise AttributeError(f"this page has no {{__name__}}.{{name}}") from None
    globals()[name] = found = getattr(found, known) if known else found
    return found
'''


def named(folders: Iterable[Path]) -> set[str]:
    """What the modules in folders name of flint: flint.fmpq, or from flint import arb, fmpq."""
    found: set[str] = set()
    for path in (path for folder in folders for path in folder.rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        found |= set(re.findall(r"\bflint\.(\w+)", text))
        for names in re.findall(r"from flint import (\([^)]*\)|.*)", text):
            found |= set(re.findall(r"\w+", names))
    return found


def lazy(folder: Path, package: str, first: set[str], names: set[str] | None = None) -> str:
    """A package in which what it imports of its own modules has places.

    What it imports of the first ones it still imports, and what has the name of a module, for a package shows
    the module under that name as soon as it is loaded.

    Parameters
    ----------
    folder : Path
        of the package
    package : str
        its name
    first : set of str
    names : set of str, optional
        those that have places; the others are left out
    """
    places: dict[str, tuple[str, str]] = {}
    rest = []
    for node in ast.parse((folder / "__init__.py").read_text(encoding="utf-8")).body:
        module = _own(node, package)
        if isinstance(node, ast.ImportFrom) and module and module.partition(".")[0] not in first \
                and not any(_is_module(folder, alias.asname or alias.name) for alias in node.names):
            places |= {alias.asname or alias.name: (module, alias.name) for alias in node.names}
        elif "__all__" not in ast.unparse(node):
            rest.append(node)
    if names is not None:
        places = {name: place for name, place in places.items() if name in names}
    return LAZY.format(rest=ast.unparse(ast.Module(rest, [])), places=places)


def _own(node: ast.stmt, package: str) -> str:
    """The module of a package from which a statement imports, without the name of the package."""
    if not isinstance(node, ast.ImportFrom):
        return ""
    module = f".{node.module or ''}" if node.level else node.module or ""
    return module.removeprefix(package).removeprefix(".") if module.startswith((".", f"{package}.")) else ""


def _is_module(folder: Path, name: str) -> bool:
    return (folder / f"{name}.py").exists() or (folder / name).is_dir()
