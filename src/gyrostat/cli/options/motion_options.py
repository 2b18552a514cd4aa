"""The motion that options name, and its times."""
import argparse
from collections.abc import Collection, Mapping, Sequence
from decimal import Context, Decimal

import numpy as np
from sympy import Expr, Rational, floor

from ...algebra.enclosures.floats import Array
from ...algebra.text.numbers import exact_number
from ...errors import ValuesError
from ...mechanics.families.release import release
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, at_numbers
from ...notation import symbol
from ...questions.given_numbers import numbers_of
from ...questions.scene_texts import one_for_each, pointing_of, scene_of
from ...stability.criteria.numbers_asked import names_in
from ...trajectories import Motion, motion
from .axis_option import LONGEST
from .scene_files import asked_of

LATEST = 10**300                                       # a time that is a double


def motion_of(given: argparse.Namespace) -> Motion:
    """The motion of the body and from the state that the options give."""
    numbers = numbers_of(given.values)
    if given.state is None and given.release is None:
        raise ValuesError("--state is missing, and a motion starts from a state: give "
                          "PI1,PI2,PI3,K1,K2,K3, for a free body PI1,PI2,PI3, or for a satellite in orbit "
                          "--release ROLL,PITCH,YAW")
    scene = whole_scene(given, numbers)
    tolerance = None if given.tolerance is None else float(_positive("--tolerance", given.tolerance))
    return motion(scene, _state(given, scene, numbers), numbers, precision=given.precision,
                  tolerance=tolerance)


def whole_scene(given: argparse.Namespace, names: Collection[str]) -> System:
    """The scene of a motion, in which every name has a number."""
    if given.potential is None and given.orbit is None:
        raise ValuesError('--potential is missing, and the motion depends on it: write --potential "m0*k3", '
                          'or none for a free body')
    scene = scene_of(asked_of(given, names))
    body, potential = scene.body, scene.potential
    if potential is not None and not potential.given:
        raise ValuesError(f'--potential is {potential.expression}, and no motion follows from an unspecified '
                          'U: write --potential "m0*k3", or none for a free body')
    parameters = potential.parameters if potential else ()
    if missing := [name for name in names_in([*body.entries, *body.gyrostatic_momentum, *parameters])
                   if name not in names]:
        moments, momentum = (f"({', '.join(map(str, vector))})"
                             for vector in (body.entries, body.gyrostatic_momentum))
        raise ValuesError(f"--set gives no number for {', '.join(missing)}, and a motion needs one for each "
                          f"name; the body has the moments {moments} and the rotor {momentum}: "
                          f"add --set {' '.join(f'{name}=…' for name in missing)}")
    return scene


def _state(given: argparse.Namespace, scene: System, numbers: Mapping[str, Expr]) -> Sequence[Expr]:
    """The state of --state, or the one that --release means."""
    if given.release is None:
        texts = one_for_each("--state", given.state, scene)
        return [exact_number(text, str(name)) for text, name in zip(texts, scene.space.coordinates)]
    if given.state is not None:
        raise ValuesError("--state and --release are both given: leave out one of the two")
    if scene.kind is not Kind.ORBIT:
        raise ValuesError("--release starts a satellite in orbit, and this body is in no orbit: add --orbit, "
                          "or give --state instead")
    here = at_numbers(scene, {symbol(name): x for name, x in numbers.items()})
    return release(here, given.release.split(","), pointing_of(given.pointing))


def times_of(given: argparse.Namespace, count: int) -> Array:
    """The times from 0 to --until, doubles or decimals.

    The states beside them are those at the times as they are written.
    """
    end = exact_number(given.until, "--until")
    if not 0 < abs(end) < LATEST:
        raise ValuesError(f"--until {given.until} cannot be the last time of a motion that starts at 0: give "
                          "another time, a negative one to go back")
    if given.step is None:
        count = count if given.count is None else given.count
        step = end / max(count - 1, 1)
    else:
        step = _positive("--step", given.step)
        count = int(floor(abs(end) / step)) + 1
        step = step if end > 0 else -step
    if not 2 <= count <= LONGEST:
        asked = f"--count {count}" if given.step is None else f"--step {given.step}"
        raise ValuesError(f"--until {given.until} with {asked} gives {count} times, which is no table: "
                          f"ask for 2 to {LONGEST}")
    p, q = (step if isinstance(step, Rational)
            else Rational(str(step.evalf(40 + (given.precision or 0))))).as_numer_denom()
    p, q = int(p), int(q)
    if given.precision is None:
        return np.array([p * i / q for i in range(count)])
    rounding = Context(prec=max(given.precision, 1))
    return np.array([rounding.divide(Decimal(p * i), Decimal(q)) for i in range(count)], dtype=object)


def _positive(option: str, text: str) -> Expr:
    number = exact_number(text, option)
    if not number > 0:
        raise ValuesError(f"{option} {text} is not positive, and it has to be: give, for example, {option} "
                          "1e-3")
    return number
