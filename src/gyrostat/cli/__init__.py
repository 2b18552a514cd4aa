"""The command line: gyrostat VERB --option."""
import argparse
import os
import sys
from collections.abc import Sequence

from .. import __version__
from ..errors import GyrostatError, ValuesError

_EXAMPLES = """examples:
  gyrostat report                                            any field U(k3): E1, E2 and E3
  gyrostat report --potential "m0*k3"                        a heavy gyrostat
  gyrostat report --potential "m0*k3 + m1/2*(I3 - I1)*k3**2" --equilibrium E1 --format latex --output e1.tex
  gyrostat report --potential "m0*k3" --equilibrium E1 --set I1=1 --set I3=1.6 --set l=0 --set m0=1 --set omega3_0=1.3
"""
_VERIFY = """examples:
  gyrostat verify                              every source: confirmed, misprint (with a counterexample) or unchecked
  gyrostat verify VV2003 --format latex        its misprints as a table of errata
  gyrostat verify my_paper.toml --format json  formulas of your own

The exit status is 1 when a status is not the expected one.
"""


def parser() -> argparse.ArgumentParser:
    """The command line's grammar."""
    top = argparse.ArgumentParser(prog="gyrostat", description=(
        "Stability of a gyrostat of revolution in a field U(k3): from the Lie-Poisson bracket to the inequalities."),
        epilog=_EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter)
    top.add_argument("--version", action="version", version=f"gyrostat {__version__}")
    verbs = top.add_subparsers(dest="verb", required=True, metavar="VERB")
    report = verbs.add_parser("report", help="the whole derivation, and verdicts where numbers are set", epilog=_EXAMPLES,
                              formatter_class=argparse.RawDescriptionHelpFormatter)
    report.add_argument("--potential", metavar="EXPR", help="U in k3 and parameters: names, numbers, + - * / **, parentheses, sqrt, "
                        "exp, log, sin, …; none for a free body; left out: U unspecified")
    report.add_argument("--equilibrium", action="append", choices=("E1", "E2", "E3"), help="upright, hanging or inclined; "
                        "may be repeated; left out: all three")
    report.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", dest="values",
                        help="a number, exact: I1=1.6, l=1/2, k3='sqrt(3)/2'; with enough of them a verdict is added")
    report.add_argument("--conditions", action="store_true", help="only a table of the conditions")
    verify = verbs.add_parser("verify", help="check published formulas against what is derived", epilog=_VERIFY,
                              formatter_class=argparse.RawDescriptionHelpFormatter)
    verify.add_argument("sources", nargs="*", metavar="SOURCE", help="VV2003, N2025, EA, AR, literature, or a .toml file of your own; "
                        "left out: the first five")
    for verb in (report, verify):
        verb.add_argument("--format", choices=("text", "latex", "json"), default="text")
        verb.add_argument("--fragment", action="store_true", help="with --format latex: without preamble, for \\input")
        verb.add_argument("--output", metavar="FILE", help="write to a file instead of the terminal")
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; 0: done, 1: a published formula is not as expected, 2: bad input, with the reason on stderr."""
    given = parser().parse_args(arguments)
    agreed = True
    try:
        if given.fragment and given.format != "latex":
            raise ValuesError(f"--fragment is for LaTeX, --format is {given.format}: add --format latex")
        if given.verb == "report":                     # SymPy is loaded after the arguments are understood
            from .report import run
            output = run(given)
        else:
            from .verify import run as verified
            output, agreed = verified(given)
        if given.output is None:
            _print(output)
        else:
            with open(given.output, "w", encoding="utf-8") as file:
                file.write(output)
    except GyrostatError as error:
        print(f"gyrostat: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:                            # the reader has seen enough, as in gyrostat report | head
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        print(f"gyrostat: cannot write {given.output}: {error.strerror}", file=sys.stderr)
        return 2
    return 0 if agreed else 1


def _print(output: str) -> None:
    """To standard output, in UTF-8 where its own encoding has no λ."""
    try:
        output.encode(sys.stdout.encoding)
    except UnicodeEncodeError:
        sys.stdout.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
    print(output, end="", flush=True)
