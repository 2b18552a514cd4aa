"""What does each verb load, and how long does it take in a process of its own?

    python benchmarks/loads.py            the table, into docs/explanation/design.md
    python benchmarks/loads.py --quick    once each, for breakage; writes nothing

Times are CPU times of whole processes over that of `import sympy`, in turn with it, medians of 9.
"""
import argparse
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from measured import BYTECODE

import gyrostat

SOURCE = Path(gyrostat.__file__).parents[1]
PAGE = Path(__file__).parents[1] / "docs" / "explanation" / "design.md"
BEGIN, END = "<!-- benchmarks/loads.py writes this table -->\n", "<!-- end -->\n"
TOP = ("--potential", "m0*k3", "--set", "I1=2", "I3=1", "l=1", "m0=1/2")
BODY = ("--inertia", "1,5/4,8/5", "--gyrostatic-momentum", "3/10,1/5,1/10")
COMMANDS = {
    "--version": ("--version",),
    "report": ("report",),
    "conditions": ("conditions",),
    "decide": ("decide", *TOP, "omega=1"),
    "decide, a free gyrostat": ("decide", "--potential", "none", *BODY, "--momentum", "2"),
    "decide, a heavy gyrostat": ("decide", "--potential", "k1 + k2", *BODY, "--set", "omega=2"),
    "decide, in orbit": ("decide", "--orbit", "1", *BODY),
    "chart": ("chart", "--potential", "m0*k3", "--equilibrium", "E1", "--x", "pi3_0=-4:4:40", "--y",
              "l=-2:2:30", "--set", "I1=1", "m0=1", "--output", "chart.png"),
    "motion": ("motion", *TOP, "--state", "0,0,3,0.8,0,0.6", "--until", "16"),
    "plot": ("plot", "cones", "--set", "I1=2", "I3=1", "--transverse", "1", "--axial", "2", "--output",
             "cones.png"),
    "verify": ("verify", "AR"),
}


def modules_of(command: tuple[str, ...]) -> set[str]:
    """The modules that are there when a command ends and were not before it was loaded."""
    code = ("import sys; before = set(sys.modules); sys.argv = ['gyrostat', *sys.argv[1:]]; "
            "import gyrostat.cli.parser as p\ntry: p.main(sys.argv[1:])\nexcept SystemExit: pass\n"
            "print('', *(set(sys.modules) - before), sep='\\nLOADED ', file=sys.stderr)")
    run = _run([sys.executable, "-c", code, *command])
    return {line.removeprefix("LOADED ") for line in run.splitlines() if line.startswith("LOADED ")}


def ours(modules: set[str]) -> set[str]:
    """Those of gyrostat that are files; packages hold a docstring only."""
    return {m for m in modules if SOURCE.joinpath(*m.split(".")).with_suffix(".py").is_file()}


def _run(words: list[str]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              cwd=folder, env={**BYTECODE, "PYTHONPATH": str(SOURCE)}).stderr


def seconds(words: list[str]) -> float:
    """CPU time of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    _run(words)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__,
                                        formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--quick", action="store_true")
    quick = arguments.parse_args().quick
    ratios: dict[str, list[float]] = {name: [] for name in COMMANDS}
    for _ in range(1 if quick else 9):
        for name, command in COMMANDS.items():
            alone = seconds([sys.executable, "-c", "import sympy"])
            ratios[name].append(seconds([sys.executable, "-m", "gyrostat", *command]) / alone)
    lines = ["| `gyrostat` | modules of ours | of SymPy | of NumPy, Matplotlib and others | "
             "time / `import sympy` |", "|---|---|---|---|---|"]
    for name, command in COMMANDS.items():
        found = modules_of(command)
        sympy = sum(m.split(".")[0] in ("sympy", "mpmath") for m in found)
        rest = len(found) - sympy - sum(m.split(".")[0] == "gyrostat" for m in found)
        lines.append(f"| {name} | {len(ours(found))} | {sympy} | {rest} | "
                     f"{statistics.median(ratios[name]):.2f} |")
    table = "\n".join(lines) + "\n"
    print(table)
    if not quick:
        before, rest_of_page = PAGE.read_text(encoding="utf-8").split(BEGIN)
        _, after = rest_of_page.split(END)
        PAGE.write_text(f"{before}{BEGIN}\n{table}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
