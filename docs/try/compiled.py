"""Run by Pyodide itself, in build.py: Python and its packages as two archives of bytecode.

A package stays where the examples load a module of it. Docstrings are left out, nobody reads them on the
page; assertions stay.
"""
import ast
import importlib
import json
import marshal
import sys
import zipfile
from importlib.util import MAGIC_NUMBER
from pathlib import Path
from types import CodeType

STAGE = Path("/stage")
# what SymPy loads when it meets some sums
LATER = ("sympy.physics.units",)
# of the library, what a question may load that no example asks
FLOORS = ("algebra", "mechanics", "stability", "equilibria", "parameters", "printing", "questions")
# what a question has beside its scene: the axes of a chart, and their ends
MORE = {"charted": [["I1", "I3"]], "edges": [["I1", "I3"], [["1/2", "2"], ["1/2", "2"]]]}
# of a module without a source, which is not looked for
HEADER = MAGIC_NUMBER + (1).to_bytes(4, "little") + bytes(8)


def without_docstrings(tree: ast.Module) -> ast.Module:
    """The same code without its docstrings."""
    for node in ast.walk(tree):
        documented = isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
        if documented and ast.get_docstring(node, clean=False):
            node.body = node.body[1:] or [ast.copy_location(ast.Pass(), node.body[0])]
    return tree


def without_lines(code: CodeType) -> CodeType:
    """The same code without the places of its instructions, which only a traceback shows."""
    constants = tuple(without_lines(x) if isinstance(x, CodeType) else x for x in code.co_consts)
    return code.replace(co_linetable=b"", co_consts=constants)


def used() -> set[str]:
    """The folders of the packages of which the examples load a module, and all that answer questions.

    python-flint is not among them, it has an archive of its own; the list of its files is written beside.
    """
    sys.path.insert(0, f"{STAGE}/packages")
    session = importlib.import_module("session")
    wanted = importlib.import_module("gyrostat.questions").WANTED
    for example in json.loads((STAGE / "packages" / "examples.json").read_text(encoding="utf-8")):
        for want in wanted:
            question = {"want": want, "scene": example["scene"], "more": MORE.get(want, ())}
            said = json.loads(session.answer(json.dumps(question)))
            if "error" in said:
                sys.exit(f"{example['title']}, {want}: {said['error']}")
    for name in LATER:
        importlib.import_module(name)
    flint = importlib.import_module("flint")
    for name in flint.PLACES:
        getattr(flint, name)
    types = [Path(module.__file__ or "") for name, module in sys.modules.items()
             if name.split(".")[0] == "flint"]
    files = [path.relative_to(STAGE / "packages").as_posix() for path in types]
    (STAGE / "flint.json").write_text(json.dumps(files), encoding="utf-8")
    loaded = {name if hasattr(module, "__path__") else name.rpartition(".")[0]
              for name, module in sys.modules.items()}
    packages = STAGE / "packages"
    answering = {path.parent.relative_to(packages).as_posix() for floor in FLOORS
                 for path in (packages / "gyrostat" / floor).rglob("__init__.py")}
    return answering | {name.replace(".", "/") for name in loaded if name.split(".")[0] != "flint"}


def archive(folder: Path, packages: set[str], target: Path) -> None:
    """Every module of the packages, compiled, and the other files beside them as they are."""
    with zipfile.ZipFile(target, "w") as out:
        for path in sorted(folder.rglob("*")):
            name = path.relative_to(folder).as_posix()
            if path.parent.relative_to(folder).as_posix().removeprefix(".") not in packages:
                continue
            if path.suffix == ".py":
                tree = without_docstrings(ast.parse(path.read_text(encoding="utf-8")))
                code = compile(tree, name, "exec", dont_inherit=True)
                out.writestr(zipfile.ZipInfo(f"{name}c"), HEADER + marshal.dumps(without_lines(code)))
            elif path.is_file() and path.suffix not in (".so", ".pyi", ".pyx", ".pxd"):
                out.writestr(zipfile.ZipInfo(name), path.read_bytes())


if __name__ == "__main__":
    kept = used() | {""}
    archive(STAGE / "python", kept, STAGE / "python.zip")
    archive(STAGE / "packages", kept, STAGE / "packages.zip")
