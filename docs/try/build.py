"""The page that runs the library in a browser, with all that it loads. Usage: build.py TARGET.

It needs pip, npm and node. What is fetched has a name and a hash in sources.toml; what the page loads is
listed with its hash in TARGET/files.json.
"""
import hashlib
import json
import lzma
import shutil
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import zipfile
from base64 import b64encode
from pathlib import Path
from typing import Any

from licences import shipped
from linked import linked, linking
from trimmed import FIRST, lazy, named

HERE = Path(__file__).parent
MODULES = ("session.py", "examples.json")
LOADER = "pyodide.asm.mjs"
LIST, SERVICE = "files.json", "sw.js"


def run(*command: str | Path, where: Path = HERE) -> None:
    """A command that has to succeed."""
    subprocess.run(command, cwd=where, check=True, stdout=subprocess.DEVNULL)


def fetched(name: str, source: dict[str, Any], folder: Path) -> Path:
    """The one file of a source, with the hash that it must have."""
    place = folder / name
    place.mkdir()
    if "npm" in source:
        run("npm", "pack", "--silent", source["npm"], where=place)
    else:
        run(sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:",
            *source.get("options", ()), "--dest", place, source["pip"])
    file, = place.iterdir()
    if (found := hashlib.sha256(file.read_bytes()).hexdigest()) != source["sha256"]:
        sys.exit(f"{file.name} has the hash {found}, sources.toml another: it is not what was tried")
    return file


def unpacked(files: dict[str, Path], stage: Path) -> None:
    """The interpreter, KaTeX, and one folder of packages, the library and what asks it among them."""
    for name in ("pyodide", "katex", "xz", "binaryen", "esbuild"):
        with tarfile.open(files[name]) as archive:
            archive.extractall(stage / name, filter="data")
    run(sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", stage / "wheel",
        HERE.parents[1])
    for wheel in (*(files[name] for name in ("python-flint", "sympy", "mpmath")),
                  *(stage / "wheel").iterdir()):
        zipfile.ZipFile(wheel).extractall(stage / "packages")
    packages = stage / "packages"
    names = named(packages / package for package in ("sympy", "gyrostat"))
    for package, first in FIRST.items():
        folder = packages.joinpath(*package.split("."))
        text = lazy(folder, package, first, names if package == "flint" else None)
        (folder / "__init__.py").write_text(text, encoding="utf-8")
    for name in MODULES:
        shutil.copy(HERE / name, stage / "packages")
    zipfile.ZipFile(stage / "pyodide" / "package" / "python_stdlib.zip").extractall(stage / "python")
    (stage / "table").mkdir()


def archives(stage: Path) -> dict[str, dict[str, bytes]]:
    """What the page unpacks before it answers: the interpreter; python-flint; all other packages."""
    pyodide, packages = stage / "pyodide" / "package", stage / "packages"
    lock = json.loads((pyodide / "pyodide-lock.json").read_text(encoding="utf-8"))
    python = {LOADER: linking((pyodide / LOADER).read_text(encoding="utf-8")).encode(),
              "pyodide.asm.wasm": (pyodide / "pyodide.asm.wasm").read_bytes()}
    python |= {"python.zip": (stage / "python.zip").read_bytes(),
               "pyodide-lock.json": json.dumps({**lock, "packages": {}}).encode()}
    libraries = [packages / name for name in json.loads((stage / "flint.json").read_text(encoding="utf-8"))]
    flint = {path.relative_to(packages).as_posix(): path.read_bytes()
             for path in sorted([*libraries, *(packages / "python_flint.libs").glob("*.so")])}
    for name, data in linked({name: data for name, data in flint.items() if name.endswith(".so")}).items():
        flint[name] = reachable(data, stage) if "libs/" in name else data
    return {"python": python, "flint": flint,
            "packages": {"finder.py": (HERE / "finder.py").read_bytes(),
                         **{path.relative_to(stage / "table").as_posix(): path.read_bytes()
                            for path in sorted((stage / "table").rglob("*")) if path.is_file()}}}


def reachable(library: bytes, stage: Path) -> bytes:
    """A library without the functions that its exports do not call, by Binaryen."""
    before, after = stage / "before.wasm", stage / "after.wasm"
    before.write_bytes(library)
    run("node", stage / "binaryen" / "package" / "bin" / "wasm-opt", "--remove-unused-module-elements",
        before, "-o", after)
    return after.read_bytes()


def stream(files: dict[str, bytes]) -> bytes:
    """Files as one stream: the length of a list, the list of paths and sizes, the files."""
    listed = json.dumps([[name, len(data)] for name, data in files.items()]).encode()
    return lzma.compress(len(listed).to_bytes(4, "little") + listed + b"".join(files.values()),
                         preset=9 | lzma.PRESET_EXTREME)


def module(script: str) -> str:
    """A script that adds to `this`, as a module, in which there is none."""
    found = script.replace("}(this,", "}(globalThis,")
    if found == script:
        sys.exit("xz-decompress is not the script that was tried")
    return found


def built(target: Path, stage: Path) -> None:
    """Fetch, compile, bundle, copy, list."""
    sources = tomllib.loads((HERE / "sources.toml").read_text(encoding="utf-8"))
    (stage / "fetched").mkdir()
    unpacked({name: fetched(name, source, stage / "fetched") for name, source in sources.items()}, stage)
    shutil.rmtree(target, ignore_errors=True)
    runtime = target / "runtime"
    runtime.mkdir(parents=True)
    run("node", HERE / "compile.mjs", stage, HERE / "compiled.py")
    for name, files in archives(stage).items():
        (runtime / f"{name}.xz").write_bytes(stream(files))
    script = stage / "xz" / "package" / "dist" / "package" / "xz-decompress.min.js"
    (runtime / "xz.js").write_text(module(script.read_text(encoding="utf-8")), encoding="utf-8")
    shutil.copy(stage / "pyodide" / "package" / "pyodide.mjs", runtime)
    katex = stage / "katex" / "package" / "dist"
    (target / "katex" / "fonts").mkdir(parents=True)
    for path in (katex / "katex.min.js", katex / "katex.min.css", *katex.glob("fonts/*.woff2")):
        shutil.copy(path, target / "katex" / path.relative_to(katex))
    shipped(stage, sources, target / "licences")
    for folder in ("prepared", "pictures"):
        shutil.copytree(stage / folder, target / folder)
    shutil.copy(stage / "examples.json", target)
    run("node", HERE / "bundle.mjs", stage, target)
    for path in (HERE / "index.html", *HERE.glob("*.css")):
        shutil.copy(path, target)
    print(f"try: {listed(target)}")


def listed(target: Path) -> str:
    """Write the list of the files, and the service worker that keeps them; say how many there are."""
    for name in (LIST, SERVICE):
        (target / name).unlink(missing_ok=True)
    files = {path.relative_to(target).as_posix(): _listed(path)
             for path in sorted(target.rglob("*")) if path.is_file()}
    (target / LIST).write_text(json.dumps(files, indent=1), encoding="utf-8")
    worker = (HERE / SERVICE).read_text(encoding="utf-8")
    version = str(_listed(target / LIST)["integrity"])
    (target / SERVICE).write_text(worker.replace("{version}", version), encoding="utf-8")
    return f"{len(files)} files, {sum(int(entry['bytes']) for entry in files.values()) / 1e6:.1f} MB"


def _listed(path: Path) -> dict[str, str | int]:
    """Size and hash of a file, as a browser compares it."""
    data = path.read_bytes()
    return {"bytes": len(data), "integrity": f"sha256-{b64encode(hashlib.sha256(data).digest()).decode()}"}


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        built(Path(sys.argv[1]).resolve(), Path(folder))
