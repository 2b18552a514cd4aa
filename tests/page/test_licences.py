"""The licences of what the page ships."""
import tomllib

import pytest
from licences import HERE, parts, shipped, version

SOURCES = tomllib.loads((HERE.parent / "sources.toml").read_text(encoding="utf-8"))
# of each licence what its text says
SAYS = {"mpl-2.0.txt": "Mozilla Public License Version 2.0", "ofl-1.1.txt": "SIL OPEN FONT LICENSE",
        "python.txt": "PYTHON SOFTWARE FOUNDATION LICENSE", "gyrostat.txt": "MIT License",
        "interpreter.txt": "LLVM Exceptions to the Apache 2.0 License", "xz-decompress.txt": "xz-embedded"}


def test_everything_that_is_fetched_has_its_licence():
    """Each entry of sources.toml that is no tool; what is linked into the interpreter too."""
    shipped = {name for name, source in SOURCES.items() if not source.get("tool")}
    assert {part["of"] for part in parts() if "of" in part} == shipped
    linked = (HERE / "interpreter.txt").read_text(encoding="utf-8")
    for name in ("Emscripten", "LLVM", "musl", "libffi", "zlib", "bzip2", "Zstandard", "XZ Utils", "SQLite",
                 "HACL*", "hiwire", "stackframe"):
        assert name in linked and any(name in part["name"] for part in parts())
    for name in ("Mersenne", "Expat", "libmpdec", "Lucent", "Majkowski"):
        assert name in (HERE / "python.txt").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", SAYS)
def test_a_text_that_no_package_brings_is_here(name):
    """Under the name that the table has."""
    place = next(part["texts"][name] for part in parts() if name in part["texts"])
    assert SAYS[name] in (HERE / place).read_text(encoding="utf-8")


def test_the_table_names_each_part_with_its_version_and_its_source(tmp_path):
    """What comes from packages is found where they are unpacked, whatever their version."""
    stage, target = tmp_path / "stage", tmp_path / "licences"
    for part in parts():
        for place in part["texts"].values():
            if not (HERE / place).is_file():
                path = stage / place.replace("*", "1.2.3")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(f"text of {place}", encoding="utf-8")
    shipped(stage, SOURCES, target)
    page = (target / "index.html").read_text(encoding="utf-8")
    for part in parts():
        assert version(part, SOURCES) in page and part["source"].partition(",")[0] in page
        assert all(f'href="{name}"' in page and (target / name).stat().st_size for name in part["texts"])
    assert {version(part, SOURCES) for part in parts() if part["name"] in ("Pyodide", "SymPy", "KaTeX")} == {
        SOURCES[name][how].partition("@" if how == "npm" else "==")[2].lstrip("=")
        for name, how in (("pyodide", "npm"), ("sympy", "pip"), ("katex", "npm"))}
