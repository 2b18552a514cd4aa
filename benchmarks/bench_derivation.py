"""How long does the whole derivation take, beside python-flint used for these equilibria alone, SymPy used
naively, SymPy used with care, and PoissonGeometry?

    python benchmarks/bench_derivation.py            all of it, minutes; prints a section of RESULTS.md
    python benchmarks/bench_derivation.py --quick    once each, for breakage

Every route runs in processes of its own, in turn with the others. The last column says whether the result is
the printed one: E1 (π3 + l)² > 4 I1 U'(1) and p of E3, Vera & Viguera (2003), §4.1 and §5.
"""
import argparse
import json
import re
import statistics
import subprocess
import sys
import time
from importlib.util import find_spec

from measured import BYTECODE, here_and_now, ratios, seconds, spread

PACKAGES = ("gyrostat", "sympy", "python-flint", "poissongeometry")


def child(route: str, repeats: int) -> None:
    """Time one route in this process: import of SymPy, first run, repeats; print them as JSON."""
    start = time.process_time()
    import sympy  # noqa: F401
    imported = time.process_time()
    import routes
    if ":" in route:
        kind, step = route.split(":", 1)
        run = getattr(routes, f"{kind}_steps")()[step]
    else:
        run = getattr(routes, f"{route}_route")
    times, right = [], True
    for _ in range(repeats + 1):
        begin = time.process_time()
        right &= bool(run())
        times.append(time.process_time() - begin)
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


def whole(command: list[str]) -> None:
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=BYTECODE)


def ratio(ours: list[float], theirs: list[float]) -> str:
    return spread(ratios(ours, theirs), ".2f")


def steps(kind: str, limit: float) -> list[str]:
    """One row for each step of a route, each in a process of its own with the limit."""
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
    rounds, repeats, limit = (1, 1, 1.5) if given.quick else (9, 5, 120.0)
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
            processes[name].append(seconds(lambda c=command: whole(c)))
        for route in results:
            found = spawn(route, repeats, 120.0)           # these answer, however busy the machine is
            assert found and "error" not in found, (route, found)
            results[route].append(found)
    imports = [r["import"] for r in results["gyrostat"]]
    lines = [
        f"{here_and_now(*PACKAGES)}; medians and (min–max) of {rounds} rounds, everything in turn. "
        "Seconds of CPU; ratios are of the same round.", "",
        "| whole process | seconds | × `import sympy` |", "|---|---|---|",
        *(f"| `{name}` | {spread(times, '.3f')} | {ratio(times, processes['import sympy'])} |"
          for name, times in processes.items()), "",
        "| derivation, U(k3) undefined: bracket with Jacobi check, E1, E2, E3, both criteria | first in "
        "its process | repeated | "
        "repeated × `import sympy` there | result |", "|---|---|---|---|---|"]
    repeated = {route: [statistics.median(r["warm"]) for r in runs] for route, runs in results.items()}
    for route, name in (("gyrostat", "gyrostat"), ("flint", "python-flint, for these three alone"),
                        ("careful", "SymPy with care (no criteria, no reduction)")):
        runs, warm = results[route], repeated[route]
        lines.append(f"| {name} | {spread([r['cold'] for r in runs], '.3f')} | {spread(warm, '.3f')} | "
                     f"{ratio(warm, imports)} | "
                     f"{'right' if all(r['right'] for r in runs) else 'wrong'} |")
    lines += ["", f"Repeated, gyrostat takes {ratio(repeated['gyrostat'], repeated['flint'])} × the time of "
              "python-flint for these three alone."]
    for kind, title in (("naive",
                         "SymPy as one writes it first (`jacobian`, `subs`, `charpoly`, `simplify`, "
                         "`solve`), U undefined"),
                        ("poissongeometry", "PoissonGeometry, where it has the feature, U = m0 k3")):
        if kind == "poissongeometry" and not find_spec("poisson"):
            lines += ["", f"{title}: not installed (`pip install poissongeometry`)."]
            continue
        lines += ["", f"| {title} | seconds, limit {limit:.0f} s a step | result |", "|---|---|---|",
                  *steps(kind, limit)]
    print("\n".join(lines))


if __name__ == "__main__":
    main()
