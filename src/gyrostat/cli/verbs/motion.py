"""gyrostat motion: a body from a state on, as a table, as data, as a picture or as an animation."""
import argparse
import sys
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
from sympy import Add, sqrt

from ...algebra.enclosures.floats import Array
from ...charts.progress import telling
from ...errors import ValuesError
from ...mechanics.scenes.kind import Kind
from ...notation import NOTATION
from ...plotting import animate_top, draw_librations, draw_momentum_sphere, draw_nutation, save_animation
from ...plotting.globe import curve_on, dots_on, towards
from ...plotting.legends import legend, named
from ...plotting.looks import BLUE, DARK, INK, axis, label
from ...printing.files import save_netcdf
from ...questions.scene_texts import pointing_of
from ...trajectories import Motion
from ...trajectories.columns import columns, dataset, turns_of
from ..options.motion_options import motion_of, times_of
from ..options.scene_files import with_scene
from ..options.units_given import units_given
from ..output import FILMS, PICTURES, Output, fact, file_of, printed_look, save_picture

KINDS = ("a table, motion.csv; data, motion.nc; a picture, motion.png, .pdf or .svg; "
         "an animation, motion.gif or .mp4")
# times of a table, of a curve and of an animation where none are asked for
ROWS, POINTS, FRAMES = 201, 2001, 150
PARTS = 50                                             # of the times, between which the progress is shown
# above a table
NUMBERS = ("inertia", "gyrostatic_momentum", "potential", "state", "route", "gyrostat_version")
SPACE: dict[str, Any] = {"projection": "3d", "elev": 22, "azim": 40}


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the motion, and to standard error what is known of it; 0."""
    given = with_scene(given)
    path = None if out.path is None else file_of(out, "motion", (".csv", ".nc", *PICTURES, *FILMS), KINDS)
    kind, digits = path.suffix if path else ".csv", given.precision
    if digits is not None and kind != ".csv":
        raise ValuesError(f"--precision {digits} is for a table, and {path} holds doubles: leave it out, or "
                          "write a .csv")
    times = times_of(given, {**dict.fromkeys(PICTURES, POINTS),
                             **dict.fromkeys(FILMS, FRAMES)}.get(kind, ROWS))
    moving, pointing = motion_of(given), pointing_of(given.pointing)
    if path is None or kind == ".csv":
        drift = _table(moving, times, out, digits, pointing)
    elif kind == ".nc":
        drift = _data(moving, times, path, pointing)
    else:
        drift = (_picture(moving, times, path, pointing) if kind in PICTURES
                 else _film(moving, times, path))
    print(_summary(moving, drift, digits, units_given(given)), end="", file=sys.stderr)
    return 0


def _followed(moving: Motion, times: Array, at: Callable[[Array], Any],
              exact: bool = False) -> tuple[list[Any], dict[str, float]]:
    """Evaluate the motion at the times, part by part; if it is in doubles, with the largest drifts."""
    found, drift, done = [], dict[str, float](), 0
    with telling(None, "motion") as told:
        for part in np.array_split(times, min(len(times), PARTS)):
            found.append(at(part))
            if not exact:
                drift = {name: max(off, drift.get(name, 0.0)) for name, off in moving.drift(part).items()}
            told(done := done + len(part), len(times))
    return found, drift


def _table(moving: Motion, times: Array, out: Output, digits: int | None,
           pointing: Sequence[int]) -> dict[str, float]:
    """Write a table of comma-separated values, below lines with # that say what is known of it.

    Doubles are written so that they are read back unchanged; with a precision, all digits of the state.
    """
    if digits is None:
        states, turns, drift = _computed(moving, times)
        found = columns(moving.scene, times, states, turns, pointing)
        names, rows = [c.name for c in found], np.stack([c.values for c in found], axis=1)
        meaning = [f"{c.name} [{c.units}]: {c.meaning}" for c in found]
        write: Callable[[Any], str] = repr
    else:
        parts, drift = _followed(moving, times, lambda part: moving([Fraction(t) for t in part]), exact=True)
        names, rows = [str(s) for s in moving.scene.space.coordinates], np.concatenate(parts)
        meaning = [f"{name}: {NOTATION[name].meaning}" for name in names]
        write = partial(mpmath.nstr, n=digits)
    out(_head(moving, meaning, digits) + ",".join(["time", *names]) + "\n")
    for at, values in zip(*(np.array_split(array, min(len(times), PARTS)) for array in (times, rows))):
        out("".join(",".join([str(t), *map(write, row)]) + "\n"
                    for t, row in zip(at.tolist(), values.tolist())))
    return drift


def _head(moving: Motion, meaning: list[str], digits: int | None) -> str:
    """The lines with # of a table: the numbers of the body, and what the columns mean."""
    known = [f"{name} = {value}" for name, value in moving.attributes.items()
             if name in NUMBERS or name == "error" and digits is None]     # the error is that of the doubles
    return "".join(f"# {line}\n" for line in [*known, "time [s]: from the state given", *meaning])


def _computed(moving: Motion, times: Array) -> tuple[Array, Array | None, dict[str, float]]:
    """Compute states, attitudes and the largest drifts, part by part."""
    parts, drift = _followed(moving, times, lambda part: (moving(part), turns_of(moving.attitude, part)))
    states, turns = zip(*parts)
    attitudes = None if turns[0] is None else np.concatenate(turns)
    return np.concatenate(states), attitudes, drift


def _data(moving: Motion, times: Array, path: Path, pointing: Sequence[int]) -> dict[str, float]:
    """Write the motion as netCDF."""
    states, turns, drift = _computed(moving, times)
    found = columns(moving.scene, times, states, turns, pointing)
    save_netcdf(dataset(found, times, moving.attributes), path)
    return drift


def _picture(moving: Motion, times: Array, path: Path, pointing: Sequence[int]) -> dict[str, float]:
    """Draw the sphere on the left, and the components over the time on the right.

    On the sphere is the path of M for a free body, and that of the axis e3 in a field. For a satellite roll,
    pitch and yaw are drawn.
    """
    from matplotlib.figure import Figure

    states, _, drift = _computed(moving, times)
    with printed_look():
        if moving.scene.kind is Kind.ORBIT:
            figure = Figure(figsize=(5, 3.4))
            draw_librations(moving, times, figure.subplots(), pointing=pointing)
            save_picture(figure, path)
            return drift
        figure = Figure(figsize=(7, 3.4))
        left, right = np.asarray(figure.subfigures(1, 2))
        sphere = left.add_subplot(**SPACE)
        if moving.scene.kind is Kind.FREE:
            _polhode(sphere, moving, states)
        else:
            draw_nutation(moving, times, sphere)
        names = [str(s) for s in moving.scene.space.coordinates]
        panels = right.subplots(len(names) // 3, sharex=True, squeeze=False)[:, 0]
        for n, ax in enumerate(panels):
            _components(ax, times, states[:, 3 * n:3 * n + 3], names[3 * n:3 * n + 3])
        panels[-1].set_xlabel(axis("t", (0, -1, 0)))
        save_picture(figure, path)
    return drift


def _polhode(ax: Any, moving: Motion, states: Array) -> None:
    """Draw the momentum sphere with the curves of this energy; the path of M is heavy and begins at a dot."""
    rotor = moving.scene.body.gyrostatic_momentum
    momentum = sqrt(Add(*((p + l)**2 for p, l in zip(moving.state, rotor))))
    draw_momentum_sphere(moving.scene, momentum, {}, [moving.energy], ax)
    path, eye = states + [float(l) for l in rotor], towards(ax)
    curve_on(ax, path, eye, color=BLUE, linewidth=2.4)
    dots_on(ax, path[:1], eye, color=BLUE, marker="o", linestyle="none", markersize=4)


def _components(ax: Any, times: Array, values: Array, names: list[str]) -> None:
    styles = [{"color": color, "linestyle": dashes, "linewidth": 1.3} for color, dashes in (
        (DARK, (0, (4, 2))), (INK["undecided"], (0, (1, 1))), (BLUE, "-"))]
    for column, style in zip(values.T, styles):
        ax.plot(times, column, **style)
    legend(ax, [named(style, label(name)) for style, name in zip(styles, names)])
    ax.margins(x=0)


def _film(moving: Motion, times: Array, path: Path) -> dict[str, float]:
    """Write an animation, a picture for each time; none is drawn if it cannot be written."""
    from matplotlib.figure import Figure

    def save(path: Path, writer: Any) -> None:
        with telling(None, "animation") as told, printed_look():
            animation = animate_top(moving, times, Figure(figsize=(3.2, 3.4)).add_subplot(**SPACE))
            animation.save(path, writer=writer, progress_callback=lambda n, total: told(n + 1, total))

    save_animation(SimpleNamespace(save=save), path)
    return moving.drift(times)


def _summary(moving: Motion, drift: dict[str, float], digits: int | None, units: bool) -> str:
    """What is known of the motion, a line each, with units if the numbers given have them."""
    period, seconds, radians = moving.period, " s" * units, " rad" * units
    facts: dict[str, Any] = {
        "scene": moving.recognised or None, "route": moving.route,
        "period": None if period is None else
        f"{period if digits is None else mpmath.nstr(period, digits)}{seconds}"}
    for name, angle, rate in (("precession", moving.precession, moving.precession_rate),
                              ("spin", moving.spin, moving.spin_rate)):
        time = "per second" if units else "per unit of time"
        gained, each = (rate, time) if period is None else (angle, "in a period")
        facts[name] = None if gained is None else f"{gained}{radians} {each}"
    facts["error"] = f"{moving.error:.1e}, estimated" if digits is None else None
    if drift:
        worst = max(drift, key=lambda name: drift[name])
        facts["drift"] = f"{drift[worst]:.1e}, of {worst}, the largest"
    facts["note"] = moving.note or None
    return "".join(f"{fact(name, str(known))}\n" for name, known in facts.items() if known is not None)
