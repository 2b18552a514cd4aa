"""The command line: gyrostat VERB --option."""
import argparse
import math
import sys
from collections.abc import Sequence
from contextlib import nullcontext
from functools import cache

from ..version import __version__
from .completion import SHELLS, PrintCompletion
from .did_you_mean import Parser
from .help import PROGRAM, VERBS, Formatter, examples
from .options.kinds_of_pictures import kinds_of_pictures
from .options.scene_options import a_motion, a_scene, an_equilibrium, claimed_point, integral
from .output import look_options, standard_streams, told
from .run_verb import carried_out
from .time_limit import signals

LIMIT = 60.0                                           # seconds of a verb, or of a line of a batch


@cache
def parser() -> argparse.ArgumentParser:
    """The command line's grammar."""
    top = Parser(prog="gyrostat", description=PROGRAM, epilog=examples("gyrostat"), formatter_class=Formatter)
    top.add_argument("--version", action="version", version=f"gyrostat {__version__}")
    top.add_argument("--print-completion", choices=SHELLS, action=PrintCompletion,
                     help="print a script with which the shell completes verbs, options and names of files; "
                     "it needs gyrostat[completion]")
    verbs = top.add_subparsers(dest="verb", required=True, metavar="VERB")
    report, conditions, decide, chart, motion, plot, verify = (
        verbs.add_parser(name, help=line, description=sentences, epilog=examples(name),
                         formatter_class=Formatter) for name, (line, sentences) in VERBS.items())
    for verb, meaning in ((report, "with enough of them a verdict is added"),
                          (conditions, "each takes the place of its name"),
                          (decide, "those of the moments, of l, of the names in U and of the motion"),
                          (chart, "those of all names except the axes")):
        a_scene(verb, meaning)
        claimed_point(verb)
    a_motion(motion)
    for verb in (report, conditions, decide, chart, motion):
        integral(verb)
    kinds = kinds_of_pictures(plot)
    conditions.add_argument("--solve-for", metavar="NAME",
                            help="give the values of NAME (l, pi3_0, omega3_0, omega, m0, …) for which each "
                            "equilibrium exists and is stable; in closed form, or as exact numbers if --set "
                            "gives all other names; NAME may be the speed of a --wheel in orbit")
    conditions.add_argument("--windows", action="store_true", help="add what decides between the two "
                            "conditions of an asymmetric body in a field: resonances and D4, as formulas")
    conditions.add_argument("--well", action="store_true", help="add how far it is stable: the "
                            "barrier of its well and the kick it bears, as formulas, where they are known")
    conditions.add_argument("--full", action="store_true", help="print every case of --solve-for, however "
                            "long; default: at most 25 lines")
    for option, body in (("--platform-damping", "platform"), ("--rotor-damping", "rotor")):
        conditions.add_argument(option, metavar="C", help="add the energy-sink condition of a --scene with "
                                f"one rotor: C, a number or a name, is the weak damping of its {body}")
    for verb in (report, conditions):
        an_equilibrium(verb, "may be repeated; default: all that are known", "append")
    an_equilibrium(decide, "default: every relative equilibrium that the numbers allow")
    decide.add_argument("--momentum", metavar="M", help="find every permanent rotation of a free body with "
                        "this |M|; the same as --set M")
    decide.add_argument("--normal-form", type=int, choices=(4, 6), help="give Birkhoff's normal form of "
                        "this degree at the equilibrium that is named, instead of its verdict; for degree "
                        "4, if --set leaves names open, D4 in these names and its conditions")
    decide.add_argument("--batch", metavar="FILE",
                        help="read an object of numbers from each line of FILE, or of standard input if "
                        "FILE is -; --set gives numbers for all lines")
    decide.add_argument("--from", type=_line, default=1, metavar="N", dest="start",
                        help="begin with line N of the batch, to go on after an interruption; default: 1")
    decide.add_argument("--processes", type=int, default=1, metavar="N",
                        help="how many processes answer the lines of a batch side by side; default: 1")
    an_equilibrium(chart, "default for a free body: axis 3")
    for option, text in (("--x", "the horizontal axis: a name and COUNT equally spaced numbers, LOW to HIGH"),
                         ("--y", "the vertical axis")):
        chart.add_argument(option, metavar="NAME=LOW:HIGH:COUNT", required=True, help=text)
    chart.add_argument("--axis", metavar="NAME=LOW:HIGH:COUNT", action="append",
                       help="a further axis of the data; may be repeated")
    chart.add_argument("--damped", action="store_true",
                       help="decide under internal damping, too; a picture is hatched where damping destroys "
                       "stability")
    chart.add_argument("--well", action="store_true", help="add the kick below which a stable point stays, "
                       "and its barrier, where they are known in closed form; contours in a picture")
    chart.add_argument("--threads", type=int, default=1, metavar="N", help="how many threads; default: 1")
    chart.add_argument("--backend", choices=("numpy", "numba"), default="numpy",
                       help="numba is faster and needs gyrostat[fast]; default: numpy")
    chart.add_argument("--output", metavar="FILE", help="write to chart.png, .pdf, .svg, .nc or .zarr")
    look_options(chart)
    verify.add_argument("sources", nargs="*", metavar="SOURCE",
                        help="VV2003, N2025, EA, AR, literature, windows, satellites, or a .toml file of "
                        "your own; default: the first seven")
    verify.add_argument("--full", action="store_true",
                        help="print whole formulas, the hypotheses of each statement, and by which route a "
                        "confirmed one was derived and compared; with --format latex: add a table of what "
                        "is confirmed")
    decide.add_argument("--full", action="store_true", help="print below the table of several equilibria "
                        "the details of each: exact numbers, frequencies, margins and reasons")
    decide.add_argument("--well", action="store_true",
                        help="add the well of each stable equilibrium: the height of its lowest pass, and "
                        "the kick below which it stays")
    decide.add_argument("--format", choices=("text", "csv", "latex", "json"),
                        help="default: by the suffix of --output: .csv, .tex, .json; else text; batch: json")
    decide.add_argument("--exact", action="store_true",
                        help="with --format json: add exact numbers, by minimal polynomial and interval")
    for verb in (report, conditions, verify):
        verb.add_argument("--format", choices=("text", "latex", "json"), default="text",
                          help="default: text")
        verb.add_argument("--symbols", nargs="+", action="extend", default=[], metavar="NAME=LATEX",
                          help="with --format latex: write the symbols of a paper, I1=A I3=C 'l=\\sigma'")
    for verb in (report, conditions, decide, verify):
        verb.add_argument("--fragment", action="store_true",
                          help="with --format latex: leave out the preamble, for \\input")
        verb.add_argument("--label", metavar="PREFIX",
                          help="with --format latex: begin every label with PREFIX; default: gyrostat")
    motion.add_argument("--precision", type=int, metavar="DIGITS",
                        help="give the numbers of a table to so many digits, as many as you like; default: "
                        "doubles")
    for verb in (report, conditions, decide, motion, *kinds, chart, verify):
        limit = None if verb in (chart, verify) else LIMIT
        batch = " (in a batch: SECONDS per line)" if verb is decide else ""
        verb.add_argument("--timeout", type=_seconds, default=limit, metavar="SECONDS",
                          help=f"stop after SECONDS{batch}; none: no limit; "
                          f"default: {'none' if limit is None else f'{limit:g}'}")
    for verb in (report, conditions, decide, motion, verify):
        verb.add_argument("--output", metavar="FILE", help="write to a file instead of the terminal" + (
            ": motion.csv, .nc, .png, .pdf, .svg, .gif or .mp4" if verb is motion else ""))
    return top


def _line(text: str) -> int:
    """Read the number of a line."""
    if not text.isdecimal() or not int(text[:18]):
        raise argparse.ArgumentTypeError(f"{text} is not the number of a line: give 1 or more")
    return int(text[:18])


def _seconds(text: str) -> float | None:
    """Read seconds; None stands for no limit."""
    try:
        seconds = math.inf if text == "none" else float(text)
    except ValueError:
        seconds = math.nan
    if not seconds > 0 or math.isinf(seconds) and text != "none":
        raise argparse.ArgumentTypeError(f"{text} is not a time: give seconds, 60 or 0.5, or none")
    return None if text == "none" else seconds


def _values_joined(arguments: Sequence[str]) -> list[str]:
    """--state -1,0,2 as --state=-1,0,2: what starts with one minus is the value of the option before it."""
    joined: list[str] = []
    for argument in arguments:
        if (
            joined
            and joined[-1].startswith("--")
            and "=" not in joined[-1]
            and argument[:1] == "-"
            and argument[1:2] not in ("", "-", "h")
        ):
            joined[-1] += f"={argument}"
        else:
            joined.append(argument)
    return joined


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line, of this process where no arguments are given.

    The limit of --timeout needs processes of its own: a verb that is called from Python runs in the calling
    process, without a limit; the lines of a batch have theirs.

    Returns
    -------
    int
        0: done, 1: a published formula is not as expected, 2: bad input, with the reason on stderr; 130:
        Ctrl-C, 143: SIGTERM
    """
    own = arguments is None
    with standard_streams() if own else nullcontext(), signals() if own else nullcontext():
        try:
            given = parser().parse_args(_values_joined(sys.argv[1:] if arguments is None else arguments))
            return carried_out(given, own)
        except KeyboardInterrupt as error:             # before there was anything to keep
            told("interrupted, nothing was done")
            return getattr(error, "status", 130)
