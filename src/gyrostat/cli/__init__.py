"""The command line: gyrostat VERB --option."""
import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from .. import __version__
from ..errors import GyrostatError, ValuesError
from .output import Output

_REPORT = """examples:
  gyrostat report                                            any field U(k3): E1, E2 and E3
  gyrostat report --potential "m0*k3"                        a heavy gyrostat
  gyrostat report --potential "m0*k3 + m1/2*(I3 - I1)*k3**2" --equilibrium E1 --format latex --output e1.tex
  gyrostat report --potential "m0*k3" --equilibrium E1 --set I1=1 --set I3=1.6 --set l=0 --set m0=1 --set omega3_0=1.3
"""
_CONDITIONS = """examples:
  gyrostat conditions                                        any field U(k3): E1, E2 and E3
  gyrostat conditions --potential "m0*k3" --equilibrium E1 --set I1=1 --set m0=1
  gyrostat conditions --potential "m0*k3" --equilibrium E1 --solve-for l
  gyrostat conditions --format latex --fragment              a table for \\input
"""
_DECIDE = """examples:
  gyrostat decide --equilibrium E1 --potential "m0*k3" --set I1=1 --set I3=1.6 --set l=0 --set m0=1 --set omega3_0=1.25
  gyrostat decide --potential "m0*k3" --set I1=2 --set I3=1 --set l=1 --set m0=1/2 --set omega=1    E1, E2 and every E3
  gyrostat decide --equilibrium E1 --potential "m0*k3" --set I1=1 --set I3=1.6 --set l=0 --batch spins.jsonl --output verdicts.jsonl

A line of a batch is an object of numbers, {"m0": 1, "omega3_0": 1.25, "l": "1/3"}, each the exact decimal that it is written as;
"equilibrium" and "potential" in it go before the options. A line of the output is an object with "line" and "equilibria" or "error".

The exit status is 0 whatever the verdict, 2 for bad input, and after a batch with a bad line.
"""
_CHART = """examples:
  gyrostat chart --potential "m0*k3" --equilibrium E1 --x pi3_0=-4:4:400 --y l=-2:2:300 --set I1=1 --set m0=1 --output chart.png
  gyrostat chart --equilibrium E3 --x k3=-1:1:500 --y d2U=-6:2:500 --set I1=1 --set I3=1/2 --set l=0.3 --set omega=1 --output chart.pdf
  gyrostat chart --potential "m0*k3" --equilibrium E1 --x pi3_0=-4:4:9000 --y l=-2:2:9000 --axis m0=-1:1:20 --set I1=1 --output chart.zarr

The kind of the file is that of its name: .png, .pdf, .svg, a picture of two axes; .nc, netCDF; .zarr, a store of any size, written block by
block, which the same command continues after an interruption. Every verdict is proved; the line between them runs
through zeros of the margins.
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
        epilog=_REPORT, formatter_class=argparse.RawDescriptionHelpFormatter)
    top.add_argument("--version", action="version", version=f"gyrostat {__version__}")
    verbs = top.add_subparsers(dest="verb", required=True, metavar="VERB")
    report, conditions, decide, chart, verify = (
        verbs.add_parser(name, help=text, epilog=epilog, formatter_class=argparse.RawDescriptionHelpFormatter) for name, text, epilog in (
            ("report", "the whole derivation, and verdicts where numbers are set", _REPORT),
            ("conditions", "where each equilibrium exists, its conditions, and what decides between them", _CONDITIONS),
            ("decide", "verdicts at numbers, of one body or of many", _DECIDE),
            ("chart", "verdicts over a grid of parameters, as a picture or as data", _CHART),
            ("verify", "check published formulas against what is derived", _VERIFY)))
    for verb, meaning in ((report, "with enough of them a verdict is added"), (conditions, "put in the place of the name"),
                          (decide, "names of the moments, l, U and the motion"), (chart, "all names but the axes")):
        verb.add_argument("--potential", metavar="EXPR", help="U in k3 and parameters: names, numbers, + - * / **, parentheses, sqrt, "
                          "exp, log, sin, …; none for a free body; left out: U unspecified")
        verb.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", dest="values",
                          help=f"a number, exact: I1=1.6, l=1/2, k3='sqrt(3)/2'; {meaning}")
    conditions.add_argument("--solve-for", metavar="NAME", help="the values of one name, l, pi3_0, omega3_0, omega, m0, …, for which each "
                            "equilibrium exists and is stable; in closed form, or exact where --set gives all other names")
    for verb in (report, conditions):
        verb.add_argument("--equilibrium", action="append", choices=("E1", "E2", "E3"), help="upright, hanging or inclined; "
                          "may be repeated; left out: all three")
    decide.add_argument("--equilibrium", choices=("E1", "E2", "E3"), help="upright, hanging or inclined; left out: every relative "
                        "equilibrium that the numbers allow")
    decide.add_argument("--batch", metavar="FILE", help="an object of numbers in each line, - for standard input; --set gives numbers for "
                        "all lines")
    chart.add_argument("--equilibrium", choices=("E1", "E2", "E3"), help="upright, hanging or inclined; left out for a free body")
    for option, text in (("--x", "the horizontal axis: a name and COUNT numbers, evenly from LOW to HIGH"), ("--y", "the vertical axis")):
        chart.add_argument(option, metavar="NAME=LOW:HIGH:COUNT", required=True, help=text)
    chart.add_argument("--axis", metavar="NAME=LOW:HIGH:COUNT", action="append", help="a further axis of the data; may be repeated")
    chart.add_argument("--threads", type=int, default=1, metavar="N", help="left out: 1")
    chart.add_argument("--backend", choices=("numpy", "numba"), default="numpy", help="numba: faster, gyrostat[fast]")
    chart.add_argument("--output", metavar="FILE", help="chart.png, .pdf, .svg, .nc or .zarr")
    verify.add_argument("sources", nargs="*", metavar="SOURCE", help="VV2003, N2025, EA, AR, literature, or a .toml file of your own; "
                        "left out: the first five")
    decide.add_argument("--format", choices=("text", "json"), help="left out: text, of a batch JSON")
    for verb in (report, conditions, verify):
        verb.add_argument("--format", choices=("text", "latex", "json"), default="text")
        verb.add_argument("--fragment", action="store_true", help="with --format latex: without preamble, for \\input")
    for verb in (report, conditions, decide, verify):
        verb.add_argument("--output", metavar="FILE", help="write to a file instead of the terminal")
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; 0: done, 1: a published formula is not as expected, 2: bad input, with the reason on stderr."""
    given = parser().parse_args(arguments)
    out = Output(given.output)
    try:
        if getattr(given, "fragment", False) and given.format != "latex":
            raise ValuesError(f"--fragment is for LaTeX, --format is {given.format}: add --format latex")
        return int(import_module(f".{given.verb}", __package__).run(given, out))     # SymPy is loaded after the arguments are understood
    except GyrostatError as error:
        print(f"gyrostat: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:                            # the reader has seen enough, as in gyrostat report | head
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        print(f"gyrostat: cannot write {given.output or 'to standard output'}: {error.strerror}", file=sys.stderr)
        return 2
    finally:
        out.close()
