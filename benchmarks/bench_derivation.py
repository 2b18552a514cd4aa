"""How long does the whole derivation take, beside python-flint used for these equilibria alone, SymPy used
naively, SymPy used with care, and PoissonGeometry?

    python benchmarks/bench_derivation.py            all of it, several minutes, writes benchmarks/RESULTS.md
    python benchmarks/bench_derivation.py --quick    once each, for breakage; writes nothing

Every route runs in processes of its own, in turn with the others. The last column says whether the result is
the printed one: E1 (π3 + l)² > 4 I1 U'(1) and p of E3, Vera & Viguera (2003), §4.1 and §5.
"""
import argparse
import datetime
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import time
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

HERE = Path(__file__).parent
BYTECODE = {**os.environ, "PYTHONDONTWRITEBYTECODE": ""}     # what is installed has it, as SymPy has
PACKAGES = ("gyrostat", "sympy", "python-flint", "poissongeometry")


def child(route: str, repeats: int) -> None:
    """Time one route in this process: import of SymPy, first run, repeats; print them as JSON."""
    start = time.perf_counter()
    import sympy  # noqa: F401
    imported = time.perf_counter()
    import routes
    if ":" in route:
        kind, step = route.split(":", 1)
        run = getattr(routes, f"{kind}_steps")()[step]
    else:
        run = getattr(routes, f"{route}_route")
    times, right = [], True
    for _ in range(repeats + 1):
        begin = time.perf_counter()
        right &= bool(run())
        times.append(time.perf_counter() - begin)
    print(json.dumps({"import": imported - start, "cold": times[0], "warm": times[1:], "right": right}))


def spawn(route: str, repeats: int, limit: float) -> dict | None:
    """One route in a new process; None beyond the limit, an "error" where it raises."""
    try:
        run = subprocess.run([sys.executable, __file__, "--child", route, str(repeats)], capture_output=True,
                             text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None
    if run.returncode:
        lines = [line for line in run.stderr.splitlines() if re.match(r"\w*Error", line)]
        return {"error": lines[-1].strip()[:90] if lines else "failed"}
    return json.loads(run.stdout)


def whole(command: list[str]) -> float:
    begin = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=BYTECODE)
    return time.perf_counter() - begin


def spread(values: list[float]) -> str:
    return f"{statistics.median(values):.3f} ({min(values):.3f}–{max(values):.3f})"


def ratio(ours: list[float], theirs: list[float]) -> str:
    pairs = [a / b for a, b in zip(ours, theirs)]
    return f"{statistics.median(pairs):.2f} ({min(pairs):.2f}–{max(pairs):.2f})"


def installed(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def steps(kind: str, limit: float) -> list[str]:
    """One row for each step of a route, each in a process of its own with the limit."""
    sys.path.insert(0, str(HERE))
    import routes
    rows = []
    for name in getattr(routes, f"{kind}_steps")():
        result = spawn(f"{kind}:{name}", 0, limit)
        if result is None:
            shown = f"> {limit:.0f}, stopped | no answer"
        elif "error" in result:
            shown = f"— | {result['error']}"
        else:
            shown = f"{result['cold']:.3f} | {'right' if result['right'] else 'wrong'}"
        rows.append(f"| {name} | {shown} |")
    return rows


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__,
                                        formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--quick", action="store_true")
    arguments.add_argument("--child", nargs=2, metavar=("ROUTE", "REPEATS"), help=argparse.SUPPRESS)
    given = arguments.parse_args()
    if given.child:
        child(given.child[0], int(given.child[1]))
        return
    rounds, repeats, limit = (1, 2, 4.0) if given.quick else (9, 5, 120.0)
    python = [sys.executable, "-c"]
    commands = {"import sympy": [*python, "import sympy"], "import gyrostat": [*python, "import gyrostat"],
                "from gyrostat import analyze": [*python, "from gyrostat import analyze"],
                "gyrostat --version": [sys.executable, "-m", "gyrostat", "--version"],
                "gyrostat report": [sys.executable, "-m", "gyrostat", "report"]}
    processes: dict[str, list[float]] = {name: [] for name in commands}
    results: dict[str, list[dict]] = {"gyrostat": [], "flint": [], "careful": []}
    for command in commands.values():
        whole(command)                                 # warm the file cache and the bytecode
    for _ in range(rounds):
        for name, command in commands.items():
            processes[name].append(whole(command))
        for route in results:
            found = spawn(route, repeats, 120.0)           # these answer, however busy the machine is
            assert found and "error" not in found, (route, found)
            results[route].append(found)
    imports = [r["import"] for r in results["gyrostat"]]
    lines = [
        "# Results", "", "## The whole derivation (`bench_derivation.py`)", "",
        f"{datetime.date.today()}, commit {commit()}, {platform.machine()} ({os.cpu_count()} cores, "
        "shared), Python "
        f"{platform.python_version()}, " + ", ".join(f"{name} {installed(name)}" for name in PACKAGES)
        + f"; medians and (min–max) of {rounds} rounds, everything in turn. Seconds; ratios are of the "
          "same round.", "",
        "| whole process | seconds | × `import sympy` |", "|---|---|---|",
        *(f"| `{name}` | {spread(times)} | {ratio(times, processes['import sympy'])} |"
          for name, times in processes.items()), "",
        "| derivation, U(k3) undefined: bracket with Jacobi check, E1, E2, E3, both criteria | first in "
        "its process | repeated | "
        "repeated × `import sympy` there | result |", "|---|---|---|---|---|"]
    repeated = {route: [statistics.median(r["warm"]) for r in runs] for route, runs in results.items()}
    for route, name in (("gyrostat", "gyrostat"), ("flint", "python-flint, for these three alone"),
                        ("careful", "SymPy with care (no criteria, no reduction)")):
        runs, warm = results[route], repeated[route]
        lines.append(f"| {name} | {spread([r['cold'] for r in runs])} | {spread(warm)} | "
                     f"{ratio(warm, imports)} | "
                     f"{'right' if all(r['right'] for r in runs) else 'wrong'} |")
    lines += ["", f"Repeated, gyrostat takes {ratio(repeated['gyrostat'], repeated['flint'])} × the time of "
              "python-flint for these three alone."]
    for kind, title in (("naive",
                         "SymPy as one writes it first (`jacobian`, `subs`, `charpoly`, `simplify`, "
                         "`solve`), U undefined"),
                        ("poissongeometry", "PoissonGeometry, where it has the feature, U = m0 k3")):
        if kind == "poissongeometry" and installed(kind) == "not installed":
            lines += ["", f"{title}: not installed (`pip install poissongeometry`)."]
            continue
        lines += ["", f"| {title} | seconds, limit {limit:.0f} s a step | result |", "|---|---|---|",
                  *steps(kind, limit)]
    text = "\n".join(lines) + "\n"
    print(text)
    if not given.quick:
        results = HERE / "RESULTS.md"
        _, mark, others = results.read_text(encoding="utf-8").partition("\n## Published formulas")
        results.write_text(text + mark + others, encoding="utf-8")


def commit() -> str:
    run = subprocess.run(["git", "-C", str(HERE), "rev-parse", "--short", "HEAD"], capture_output=True,
                         text=True)
    return run.stdout.strip() or "unknown"


if __name__ == "__main__":
    main()
