"""gyrostat plot KIND: a picture of gyrostat.plotting."""
import argparse
from collections.abc import Callable, Collection
from typing import Any

import numpy as np
from sympy import Expr

from ... import plotting
from ..._lazy import loaded
from ...algebra.text.numbers import exact_number
from ...errors import ValuesError
from ...mechanics.families.scene_tables import NONE
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...questions.answers.equilibria import report_for
from ...questions.given_numbers import numbers_of, one_spin
from ...questions.scene_texts import Asked, pointing_of, scene_of
from ...stability.criteria.number_notes import scene_note
from ..options.axis_option import axis_of
from ..options.motion_options import motion_of, times_of, whole_scene
from ..options.picture_options import form_of
from ..options.scene_files import asked_of, with_scene
from ..output import Output, printed_look
from .motion import POINTS, SPACE

SAMPLES = 200                                          # of the parameter, along eigenvalues
CONES = {**SPACE, "elev": 14, "azim": 12}              # both are seen from the side
Numbers = dict[str, Expr]
Drawing = Callable[[argparse.Namespace, Numbers, Any], str]


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the picture; 0."""
    given = with_scene(given)
    form = form_of(given, out)
    with printed_look():
        note = DRAWN[given.kind](given, numbers_of(given.values), figure := form.figure())
        form.save(figure)
    out.noted(note)
    return 0


def _of_field(draw: Callable[..., Any], **space: Any) -> Drawing:
    """A picture of a body in a field and its numbers alone."""
    def drawn(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
        scene = _in_a_field(given, numbers)
        draw(scene, numbers, ax=figure.add_subplot(**space))
        return _unusual(scene, numbers)
    return drawn


def _momentum_sphere(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    energies = [float(exact_number(text, "--energy")) for text in given.energy or ()]
    scene = whole_scene(argparse.Namespace(**{"potential": NONE, **vars(given)}), numbers)
    plotting.draw_momentum_sphere(scene, exact_number(given.momentum, "--momentum"), numbers,
                                  energies or None, figure.add_subplot(**SPACE))
    return _unusual(scene, numbers)


def _rotor_set(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    texts = {"potential": NONE, **vars(given)}
    scene = scene_of(asked_of(argparse.Namespace(**texts), numbers.keys() | {"l1"}))
    plotting.draw_rotor_set(scene, {**numbers, "M": exact_number(given.momentum, "--momentum")},
                            figure.subplots())
    return _unusual(scene, numbers)


def _staude_plane(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    rates = None
    if given.x is not None:
        name, *rates, _ = axis_of("--x", given.x, "NAME=LOW:HIGH")
        if name != "omega":
            raise ValuesError(f"--x is {name}, and this picture is drawn over omega: write --x omega=-2:2")
    plotting.draw_staude_plane(scene := _in_a_field(given, numbers), numbers, rates, figure.subplots())
    return _unusual(scene, numbers)


def _nutation(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    times = times_of(given, POINTS)
    plotting.draw_nutation(moving := motion_of(given), times, figure.add_subplot(**SPACE))
    return moving.note


def _effective_potential(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    plotting.draw_effective_potential(scene := _in_a_field(given, numbers), numbers, given.energy,
                                      figure.subplots())
    return _unusual(scene, numbers)


def _bifurcations(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    name, low, high, _ = axis_of("--x", given.x, "NAME=LOW:HIGH")
    _free(name, numbers)
    if given.potential is None and given.orbit is None:
        raise ValuesError('--potential is missing, and the equilibria depend on it: write --potential '
                          '"m0*k3", or none for a free gyrostat, or --orbit 1 for a satellite')
    scene = scene_of(asked_of(given, {**numbers, name: low}))
    plotting.draw_bifurcation_diagram(scene, name, (low, high), numbers, figure.subplots())
    return _unusual(scene, numbers)


def _eigenvalues(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    name, low, high, count = axis_of("--x", given.x, "NAME=LOW:HIGH[:COUNT]", SAMPLES)
    _free(name, numbers)
    one_spin(names := {**numbers, name: low})
    eq = report_for("picture", asked_of(given, names), given.equilibrium,
                    {**numbers, name: None}).equilibrium
    held = dict(eq.relations)                              # numbers without which it is no equilibrium
    plotting.draw_eigenvalues(eq, name, np.linspace(float(low), float(high), count).tolist(),
                              {n: x for n, x in numbers.items() if held.get(symbol(n)) != x},
                              figure.subplots())
    return _unusual(eq.system, numbers)


def _well(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    asked = asked_of(given, numbers)
    answers = loaded("questions.answers.answers:answers_at")(asked, None, numbers)
    found = [a.found if getattr(a, "listed", False) else None for a in answers]
    if given.number is None:
        chosen = next((e for e in found if e and e.decision.stable and e.well.barrier is not None), None)
    elif 1 <= given.number <= len(found):
        chosen = found[given.number - 1]
    else:
        raise ValuesError(f"--number is {given.number}, and the list has {len(found)}: give one of those "
                          "that gyrostat decide --well lists")
    if chosen is None:
        raise ValuesError("no well of these equilibria is known: gyrostat decide --well says why")
    flat = chosen.well.line is not None
    ax = figure.subplots() if flat else figure.add_subplot(projection="3d")
    if not flat:
        ax.view_init(*loaded("plotting.filled_well:facing")(chosen))
    plotting.draw_well(chosen, ax)
    return _unusual(scene_of(asked), numbers)


def _cones(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    transverse, axial = exact_number(given.transverse, "--transverse"), exact_number(given.axial, "--axial")
    if numbers.keys() != {"I1", "I3"}:
        raise ValuesError(f"--set gives {', '.join(numbers) or 'nothing'}, and the cones are those of a body "
                          "with I1 = I2 and without a rotor: set I1 and I3, and nothing else")
    plotting.draw_cones((numbers["I1"], numbers["I3"]), transverse, axial, figure.add_subplot(**CONES))
    return _unusual(scene_of(Asked(NONE).of_body(())), {**numbers, "I2": numbers["I1"]})


def _attitudes(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    plotting.draw_attitudes(scene := _in_orbit(given, numbers), numbers, figure.add_subplot(**SPACE))
    return _unusual(scene, numbers)


def _librations(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    _in_orbit(given, numbers)
    moving, pointing = motion_of(given), pointing_of(given.pointing)
    plotting.draw_librations(moving, times_of(given, POINTS), figure.subplots(), pointing=pointing)
    return moving.note


def _smelt_plane(given: argparse.Namespace, numbers: Numbers, figure: Any) -> str:
    scene = _in_orbit(given, numbers)
    plotting.draw_smelt_plane(ax=figure.subplots(), satellite=scene, values=numbers,
                              pointing=pointing_of(given.pointing))
    return _unusual(scene, numbers)


def _unusual(scene: System, numbers: Numbers) -> str:
    """What is unusual about the numbers, as far as they are given."""
    return scene_note(scene, {symbol(name): number for name, number in numbers.items()})


def _in_orbit(given: argparse.Namespace, names: Collection[str]) -> System:
    """The scene that is given, in its orbit."""
    if given.orbit is None:
        raise ValuesError(f"--orbit is missing, and {given.kind} shows a satellite in a circular orbit: "
                          "write --orbit 'height=500 km', or its rate, --orbit 1")
    return scene_of(asked_of(given, names))


def _in_a_field(given: argparse.Namespace, names: Collection[str]) -> System:
    """The scene that is given, with a field."""
    if given.orbit is not None:
        raise ValuesError(f"{given.kind} shows a body in a field fixed in space, and --orbit {given.orbit} "
                          "is given: leave it out; of a satellite plot draws attitudes, librations, "
                          "smelt-plane and eigenvalues, and chart the verdicts")
    if given.potential is None or given.potential.strip() == "none":
        raise ValuesError(f'--potential is {given.potential or "missing"}, and {given.kind} shows a body in '
                          'a field: write --potential "m0*k3"')
    return scene_of(asked_of(given, names))


def _free(name: str, numbers: Numbers) -> None:
    """Refuse a number for what goes along the axis."""
    if name in numbers:
        raise ValuesError(f"{name} is given by --set and is the axis --x as well: leave out one of the two")


DRAWN: dict[str, Drawing] = {
    "momentum-sphere": _momentum_sphere, "nutation": _nutation, "effective-potential": _effective_potential,
    "bifurcations": _bifurcations, "rotor-set": _rotor_set,
    "staude-cone": _of_field(plotting.draw_staude_cone, **SPACE), "staude-plane": _staude_plane,
    "amended-potential": _of_field(plotting.draw_amended_potential, **SPACE),
    "energy-momentum": _of_field(plotting.draw_energy_momentum), "eigenvalues": _eigenvalues, "well": _well,
    "cones": _cones, "attitudes": _attitudes, "librations": _librations, "smelt-plane": _smelt_plane}
