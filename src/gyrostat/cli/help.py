"""Holds the words of the help, and fits them and the examples into the width of the terminal."""
import argparse
import re
from pkgutil import get_data
from textwrap import wrap

from .output import columns

WIDEST = 100                                           # columns of a text that is read
PROGRAM = ("Analyses the stability of a gyrostat that is free, in a field or in a circular orbit: from the "
           "Lie-Poisson bracket to inequalities, verdicts at given numbers, charts and motions. Every "
           "verdict is proved.")
# of each verb: the line in the list of verbs, and what its help begins with
VERBS = {
    "report": (
        "the whole derivation, and verdicts if numbers are set",
        "Derives the stability of the equilibria of a body in a field, step by step: bracket, "
        "equations of motion, linearisation, second variation, the necessary and the sufficient "
        "condition, and what decides between them. With enough numbers a verdict is added."),
    "conditions": (
        "where each equilibrium exists, its conditions, and what decides between them",
        "Gives the conditions of each equilibrium alone, without the derivation: where it exists, "
        "the necessary and the sufficient one. With --solve-for it gives the values of one name for"
        " which the equilibrium is stable."),
    "decide": (
        "verdicts at given numbers, for one body or for many",
        "Decides whether equilibria are stable at given numbers. Each verdict has its notion of "
        "stability and its reason. Without --equilibrium it finds every relative equilibrium that "
        "the numbers allow and lists them in a table. For a body in U = c·k, if no number of its motion "
        "is given, it finds every arc of permanent rotations. With --batch it answers a file of bodies, "
        "line by line."),
    "chart": (
        "verdicts over a grid of parameters, as a picture or as data",
        "Decides at every point of a grid of parameters, and writes a picture of two axes, or data "
        "of any number of axes."),
    "motion": (
        "the motion from a state on, as a table, data, a picture or an animation",
        "Follows the motion from a state: exactly, at any time, if the body is free, or one of "
        "revolution in U(k3); otherwise the motion is integrated and checked."),
    "plot": (
        "polhodes, nutation, bifurcations, eigenvalues, …, as a picture",
        "Draws one of the pictures below; each has its own options."),
    "verify": (
        "check published formulas against what is derived",
        "Derives published formulas and claims anew and says of each whether it is confirmed, a "
        "misprint, with a counterexample in numbers, or unchecked.")}
KINDS = {
    "momentum-sphere": (
        "polhodes, separatrices and equilibria of a free body or gyrostat",
        "Draws the momentum sphere of a free body or gyrostat: polhodes, separatrices and every "
        "permanent rotation with its verdict."),
    "nutation": (
        "the path of the axis of the body on the sphere of directions",
        "Draws the path of the axis of the body on the sphere of directions, between its limits."),
    "effective-potential": (
        "V of a body of revolution in U(k3) on a level of its momenta",
        "Draws the effective potential V of a body of revolution in U(k3) on a level of its "
        "momenta, with the relative equilibria in it."),
    "bifurcations": (
        "all relative equilibria against a parameter",
        "Draws all relative equilibria against a parameter, with their verdicts and the points where "
        "they meet or change stability: k3 for a body of revolution in a field, M along the rotor or the "
        "rate for a free gyrostat, n along the rotor for a satellite, with the number of its attitudes."),
    "rotor-set": (
        "where in a plane of the rotor the rotations of a free gyrostat meet",
        "Draws the bifurcation set of a free gyrostat in a plane of two components of its rotor, at a "
        "given length of the momentum: folds, pitchforks, and the number of permanent rotations."),
    "staude-cone": (
        "the directions of the permanent rotations of a heavy body, with verdicts",
        "Draws the admissible arcs of Staude's cone on the sphere of directions (with a rotor, of the curve "
        "that takes its place): the axes about which a body of three moments in U = c·k turns permanently, "
        "with the verdicts and the points where they change."),
    "staude-plane": (
        "the permanent rotations of a heavy body against their rate",
        "Draws the permanent rotations of a body of three moments in U = c·k, with a rotor or without, in "
        "the plane of the rate omega and of sigma in ∇U = omega² Ik + omega l + sigma k, with their "
        "verdicts: it shows which rotations exist at each rate, and where two of them meet."),
    "amended-potential": (
        "U + (C1 − l·k)²/(2 k·Ik) of any body in a field, with its critical points",
        "Draws the amended potential of a body in a field on the sphere of directions, on a level of C1: "
        "level curves, those through saddles, and its critical points, the permanent rotations, with "
        "their verdicts."),
    "energy-momentum": (
        "critical values of the energy and C1 at a fixed axial momentum",
        "Draws the energy-momentum diagram: the critical values of the energy and C1 at a fixed "
        "axial momentum."),
    "eigenvalues": (
        "the spectrum of an equilibrium along a parameter",
        "Draws the eigenvalues of an equilibrium along a parameter, and where they collide."),
    "well": (
        "the well of a stable equilibrium, filled up to its lowest pass",
        "Draws the well of a stable equilibrium, which decide --well describes, filled up to its lowest "
        "pass: where in a body the vertical stays at every energy below that, of a free body the angular "
        "momentum, of a satellite the vertical and the normal of its orbit; of a body of revolution V over "
        "its tilt."),
    "cones": (
        "body cone and space cone of a free body of revolution",
        "Draws the body cone rolling on the space cone of a free body of revolution."),
    "attitudes": (
        "every attitude in which a satellite in orbit rests, with verdicts",
        "Draws every attitude in which a satellite in a circular orbit rests, by its vertical and the normal "
        "of its orbit in the body. The numbers are those of the rows of gyrostat decide --orbit."),
    "librations": (
        "roll, pitch and yaw of a satellite over its orbits",
        "Draws roll, pitch and yaw of a satellite in a circular orbit, from a state or a release on."),
    "smelt-plane": (
        "whether a satellite is stable Earth-pointing, by the ratios of its moments",
        "Draws Smelt's plane of the two ratios of moments of an Earth-pointing satellite with the rotor of "
        "the one that is given, and marks where this one lies: in Lagrange's region, in that of DeBra and "
        "Delp, or outside. The rotor is along the axis of pitch, or there is none.")}


_COMMENT = re.compile(r"(?<=\S) {2,}")
# an option stays with its value
_WORD = re.compile(r'(?:--\S+ (?!--))?(?:"[^"]*"|\S)+')


class Formatter(argparse.HelpFormatter):
    """Sentences and examples in the width of the terminal, and no wider than a text is read."""

    def __init__(self, prog: str, width: int | None = None):
        super().__init__(prog, width=width or min(columns(), WIDEST))

    def _format_args(self, action: argparse.Action, default_metavar: str) -> str:
        if action.nargs == "+":                        # NAME=VALUE [NAME=VALUE ...] is wider and says no more
            return f"{action.metavar} ..."
        return super()._format_args(action, default_metavar)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        return "\n\n".join(_typed(part, width) if part.startswith("examples:")
                           else "\n".join(wrap(part, width, break_on_hyphens=False))
                           for part in text.split("\n\n"))


def examples(verb: str) -> str:
    """The examples below the help of a verb; they are read from a folder or from an archive."""
    return (get_data(__package__, f"examples/{verb}.txt") or b"").decode().strip()


def _typed(part: str, width: int) -> str:
    """Fit examples: a long command is broken, and its comment goes below it if there is no room."""
    title, *commands = re.sub(r" \\\n +", " ", part).split("\n")
    roomy = all(len(line) <= width for line in commands if _COMMENT.search(line))
    lines = [title]
    for line in commands:
        command, _, comment = _COMMENT.sub("\0", line.strip()).partition("\0")
        shown = line if roomy else f"  {command}   {comment}".rstrip()
        if len(shown) <= width:
            lines.append(shown)
        else:
            below = wrap(comment, width, initial_indent=" " * 6, subsequent_indent=" " * 6)
            lines += [*_continued(command, width), *below]
    return "\n".join(lines)


def _continued(command: str, width: int) -> list[str]:
    r"""Break a command between its options with \, as it may be typed."""
    lines, line = list[str](), " "
    for word in _WORD.findall(command):
        if len(line) + 1 + len(word) > width - 2 and line.strip():
            lines, line = [*lines, f"{line} \\"], " " * 5
        line += f" {word}"
    return [*lines, line]
