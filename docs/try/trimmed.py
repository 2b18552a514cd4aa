"""python-flint with the types that SymPy and the library name, each loaded where it is first used.

Its own package loads all of its types at once, some forty libraries of WebAssembly.
"""
import ast
import re
from collections.abc import Iterable
from pathlib import Path

LAZY = '''{rest}
PLACES = {places!r}


def __getattr__(name):
    if name not in PLACES:
        raise AttributeError(f"this page has no flint.{{name}}")
    from importlib import import_module
    found = getattr(import_module(f".{{PLACES[name]}}", __name__), name)
    globals()[name] = found
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


def lazy(package: str, names: set[str]) -> str:
    """The same package, in which these of its types have places, and the others are left out."""
    tree = ast.parse(package)
    types = [node for node in tree.body if isinstance(node, ast.ImportFrom)
             and (node.module or "").partition(".")[0] in ("types", "functions")]
    places = {alias.name: node.module for node in types for alias in node.names if alias.name in names}
    tree.body = [node for node in tree.body if node not in types and not _of_all(node)]
    return LAZY.format(rest=ast.unparse(tree), places=places)


def _of_all(node: ast.stmt) -> bool:
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__"
