"""Run before all others: the modules of the page, whose bytecode one file has behind a table of their names.

An import asks the table, no folder and no archive. What is not there is looked for as ever.
"""
import marshal
import sys
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import CodeType, ModuleType, SimpleNamespace
from typing import Any

# beside the table the libraries and the other files of packages
FOLDER = Path("/packages")


class Table:
    """Finds and loads what a table has: of each module whether it is a package, and where its bytecode is."""

    def __init__(self, table: Path) -> None:
        self.file, self.folder = table.open("rb"), table.parent
        self.modules: dict[str, tuple[bool, int, int]] = marshal.load(self.file)
        self.begin = self.file.tell()

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """Return the specification of a module; a package has a folder too."""
        if name not in self.modules:
            return None
        is_package, place = self.modules[name][0], self.folder.joinpath(*name.split("."))
        spec = ModuleSpec(name, self, origin=f"{place}.pyc", is_package=is_package)
        if is_package:
            spec.submodule_search_locations = [str(place)]
        return spec

    def create_module(self, spec: ModuleSpec) -> None:
        """Leave it to Python."""

    def exec_module(self, module: ModuleType) -> None:
        """Run the code of a module."""
        exec(self.get_code(module.__name__), module.__dict__)

    def get_code(self, name: str) -> CodeType:
        """Return the code of a module."""
        _, place, size = self.modules[name]
        self.file.seek(self.begin + place)
        return marshal.loads(self.file.read(size))

    def get_resource_reader(self, name: str) -> Any:
        """Return what reads the files of a package."""
        from importlib.readers import FileReader
        return FileReader(SimpleNamespace(path=str(self.folder.joinpath(*name.split("."), "__init__.py"))))


if __name__ == "__main__":
    sys.path.insert(0, str(FOLDER))
    sys.meta_path.insert(0, Table(FOLDER / "table"))
