"""How long does it take to check all published formulas, and how does the zero test compare with SymPy's
simplify?

    python benchmarks/bench_verify.py            all of it, minutes; prints a section of RESULTS.md
    python benchmarks/bench_verify.py --quick    one source, once, and without SymPy's simplify, for breakage
"""
import argparse
import signal
import subprocess
import sys

import sympy
from measured import cpu, here_and_now, spread
from sympy import MatrixBase

from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.published import SOURCES, check, load
from gyrostat.published.checks.readings import Reading
from gyrostat.published.language import read
from gyrostat.published.names.derived_names import is_zero

LIMIT = 10


def differences(sources=SOURCES):
    """printed − derived of every confirmed identity, entry by entry."""
    found = []
    for source in sources:
        for statement in load(source).statements:
            if statement.kind in ("identity", "family") and statement.key not in load(source).expected:
                r = Reading(statement)
                printed, derived = (r.finish(read(x, r.own)) for x in (statement.printed, statement.quantity))
                found.append(list(printed - derived) if isinstance(printed, MatrixBase)
                             else [printed - derived])
    return found


def vanishes(expression):
    """As checks do: by polynomials, and of a number whose roots are nested by its sign."""
    return is_zero(expression) or not expression.free_symbols and sign_of_constant(expression) == 0


def stopped(*_):
    raise TimeoutError


def decided(test, entries):
    """Seconds and outcome of a zero test on one formula, stopped at the limit."""
    signal.signal(signal.SIGALRM, stopped)
    signal.alarm(LIMIT)
    begin = cpu()
    try:
        return all(test(e) for e in entries), cpu() - begin
    except TimeoutError:
        return None, cpu() - begin
    finally:
        signal.alarm(0)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    given = parser.parse_args()
    rounds, sources = (1, ("AR",)) if given.quick else (5, SOURCES)
    cold, warm, wrong = [], [], 0
    for _ in range(rounds):
        begin = cpu()
        subprocess.run([sys.executable, "-m", "gyrostat", "verify", *sources], check=True,
                       stdout=subprocess.DEVNULL)
        cold.append(cpu() - begin)
        check(sources)                             # what a first run leaves in SymPy's caches
        begin = cpu()
        wrong += sum(f.status != f.expected for f in check(sources))
        warm.append(cpu() - begin)
    print(f"{here_and_now('sympy', 'python-flint')}; medians and (min–max) of {rounds} rounds, seconds of "
          "CPU.\n")
    count = sum(len(load(source).statements) for source in sources)
    print(f"| {', '.join(sources)}: {count} statements | seconds | not as expected |\n|---|---|---|")
    print(f"| `gyrostat verify`, whole process | {spread(cold, '.2f')} | 0 |\n| `check()`, repeated | "
          f"{spread(warm, '.2f')} | {wrong} |")
    formulas = differences(sources)
    tests = {"ours": vanishes} if given.quick else {
        "ours": vanishes, "`sympy.simplify(…) == 0`": lambda e: sympy.simplify(e) == 0}
    found = {name: [decided(test, f) for f in formulas] for name, test in tests.items()}
    print(f"\n| {len(formulas)} confirmed identities, zero test | seconds in all | right | stopped at "
          f"{LIMIT} s |\n|---|---|---|---|")
    for name, results in found.items():
        answers = [answer for answer, _ in results]
        print(f"| {name} | {sum(t for _, t in results):.2f} | {answers.count(True)} | "
              f"{answers.count(None)} |")
    return 1 if wrong or not all(a for a, _ in found["ours"]) else 0


if __name__ == "__main__":
    sys.exit(main())
