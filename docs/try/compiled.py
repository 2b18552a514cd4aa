"""Run by Pyodide itself, in build.py: the bytecode of Python and its packages.

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

    The libraries of python-flint have an archive of their own; their list is written beside.
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
    for package in [module for module in sys.modules.values() if hasattr(module, "LAZILY")]:
        for name in package.LAZILY:
            getattr(package, name)
    files = [Path(module.__file__ or "") for name, module in sys.modules.items()
             if name.split(".")[0] == "flint"]
    libraries = [path.relative_to(STAGE / "packages").as_posix() for path in files if path.suffix == ".so"]
    (STAGE / "flint.json").write_text(json.dumps(libraries), encoding="utf-8")
    loaded = {name if hasattr(module, "__path__") else name.rpartition(".")[0]
              for name, module in sys.modules.items()}
    packages = STAGE / "packages"
    answering = {path.parent.relative_to(packages).as_posix() for floor in FLOORS
                 for path in (packages / "gyrostat" / floor).rglob("__init__.py")}
    return answering | {name.replace(".", "/") for name in loaded}


def codes(folder: Path, packages: set[str]) -> dict[str, bytes]:
    """Every module of the packages by its path in the folder, compiled."""
    found = {}
    for path in sorted(folder.rglob("*.py")):
        if path.parent.relative_to(folder).as_posix().removeprefix(".") in packages:
            name = path.relative_to(folder).as_posix()
            tree = without_docstrings(ast.parse(path.read_text(encoding="utf-8")))
            code = compile(tree, name, "exec", dont_inherit=True)
            found[name] = marshal.dumps(without_lines(code))
    return found


def zipped(modules: dict[str, bytes], target: Path) -> None:
    """The modules that Pyodide itself loads, as it looks for them."""
    with zipfile.ZipFile(target, "w") as out:
        for name, code in modules.items():
            out.writestr(zipfile.ZipInfo(f"{name}c"), HEADER + code)


def table(modules: dict[str, bytes]) -> bytes:
    """A table of modules, as finder.py looks for them, and behind it their codes.

    Of each module it says whether it is a package, where its code begins, and how long it is.
    """
    found, place = {}, 0
    for path, code in modules.items():
        is_package, name = path.endswith("/__init__.py"), path.removesuffix(".py").removesuffix("/__init__")
        found[name.replace("/", ".")] = (is_package, place, len(code))
        place += len(code)
    return marshal.dumps(found) + b"".join(modules.values())


if __name__ == "__main__":
    own = {name.partition(".")[0] for name in sys.modules}      # what Pyodide itself loads
    kept = used() | {""}
    standard = codes(STAGE / "python", kept)
    first = {name: code for name, code in standard.items() if Path(name).parts[0].removesuffix(".py") in own}
    others = {name: code for name, code in standard.items() if name not in first}
    zipped(first, STAGE / "python.zip")
    (STAGE / "table" / "table").write_bytes(table(others | codes(STAGE / "packages", kept)))
    for path in (STAGE / "packages" / "gyrostat").rglob("*.toml"):
        name = path.relative_to(STAGE / "packages")
        if name.parent.as_posix() in kept:
            (STAGE / "table" / name).parent.mkdir(parents=True, exist_ok=True)
            (STAGE / "table" / name).write_bytes(path.read_bytes())
