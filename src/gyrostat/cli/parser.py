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
from .help import KINDS, PROGRAM, VERBS, Formatter, examples
from .options.scene_options import (
    a_scene,
    an_equilibrium,
    claimed_point,
    integral,
    numbers,
    pointing,
    scene_file,
)
from .output import look_options, picture_options, standard_streams, told
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
    _motion(motion)
    for verb in (report, conditions, decide, chart, motion):
        integral(verb)
    kinds = _kinds(plot)
    conditions.add_argument("--solve-for", metavar="NAME",
                            help="give the values of NAME (l, pi3_0, omega3_0, omega, m0, …) for which each "
                            "equilibrium exists and is stable; in closed form, or as exact numbers if --set "
                            "gives all other names; NAME may be the speed of a --wheel in orbit")
    conditions.add_argument("--windows", action="store_true", help="add what decides between the two "
                            "conditions of an asymmetric body in a field: resonances and D4, as formulas")
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


def _motion(verb: argparse.ArgumentParser) -> None:
    """Declare the options of a body, its state and its times."""
    a_scene(verb, "I1, I3 or I1, I2, I3; l or l1, l2, l3; the names in U",
           "none for a free body")
    verb.add_argument("--state", metavar="PI1,PI2,PI3,K1,K2,K3",
                      help="the exact state at time 0: pi is the momentum with the rotor locked, k the "
                      "direction of the field in the body; for a free body PI1,PI2,PI3, in orbit "
                      "PI1,PI2,PI3,N1,N2,N3,R1,R2,R3")
    pointing(verb)
    verb.add_argument("--release", metavar="ROLL,PITCH,YAW",
                      help="instead of --state: start a satellite at rest in the frame of the orbit, turned "
                      "by these angles, first by yaw and last by roll; '5 deg,0,0', or in rad without a unit")
    verb.add_argument("--until", metavar="T", required=True,
                      help="the last time; if it is negative, the motion goes back from 0")
    among = verb.add_mutually_exclusive_group()
    among.add_argument("--count", type=int, metavar="N",
                       help="how many times from 0 to T; default: 201, for a curve 2001, for a film 150")
    among.add_argument("--step", metavar="DT", help="the time from one to the next, instead of --count")
    verb.add_argument("--tolerance", metavar="X",
                      help="the largest error of a motion that is integrated numerically; default: 1e-3")


def _kinds(plot: Parser) -> list[Parser]:
    """Declare the pictures, each with its options."""
    kinds = plot.add_subparsers(dest="kind", required=True, metavar="KIND")
    sphere, nutation, well, branches, rotors, staude, plane, amended, diagram, eigenvalues, cones = (
        kinds.add_parser(name, help=line, description=sentences, formatter_class=Formatter)
        for name, (line, sentences) in KINDS.items())
    scene_file(sphere)
    numbers(sphere, "I1, I2, I3; l or l1, l2, l3")
    sphere.add_argument("--momentum", metavar="M", required=True, help="the radius of the sphere, |M|")
    sphere.add_argument("--energy", metavar="H", action="append",
                        help="draw the polhode of this energy; may be repeated; default: some of each kind")
    _motion(nutation)
    nutation.set_defaults(precision=None)
    a_scene(well, "I1, I3, l, the names in U, p_phi and p_psi", "required")
    well.add_argument("--energy", metavar="H", help="draw the motion at this energy, too")
    a_scene(branches, "I1, I3, l, omega and the names in U, or I1, I2, I3, l1, l2, l3 and M, except the name "
           "of the axis", "none for a free gyrostat; required")
    branches.add_argument("--x", metavar="NAME=LOW:HIGH", required=True,
                          help="the parameter, omega or another name, and its range")
    scene_file(rotors)
    numbers(rotors, "I1, I2, I3 and one of l1, l2, l3; the others are the axes")
    rotors.add_argument("--momentum", metavar="M", required=True, help="|M|")
    for kind in staude, plane:
        a_scene(kind, "I1, I2, I3, l or l1, l2, l3, and the names in U",
               "of degree 1 in k1, k2, k3; required")
    plane.add_argument("--x", metavar="omega=LOW:HIGH",
                       help="the range of the rates; default: all at which there are rotations")
    a_scene(amended, "I1, I2, I3, l or l1, l2, l3, the names in U, and C1",
           "of degree 1 or 2 in k1, k2, k3; required")
    a_scene(diagram, "I1, I3, l, the names in U, and p_psi", "required")
    a_scene(eigenvalues, "those of all names in the spectrum except the axis")
    an_equilibrium(eigenvalues, "default for a free body: axis 3")
    claimed_point(eigenvalues)
    eigenvalues.add_argument("--x", metavar="NAME=LOW:HIGH[:COUNT]", required=True,
                             help="the parameter, its range in either direction, and how many values; "
                             "default: 200")
    numbers(cones, "I1 and I3")
    cones.add_argument("--transverse", metavar="W", required=True,
                       help="the angular velocity across the axis")
    cones.add_argument("--axial", metavar="W3", required=True, help="the angular velocity along the axis")
    for kind in kinds.choices.values():
        picture_options(kind)
    return list(kinds.choices.values())


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
