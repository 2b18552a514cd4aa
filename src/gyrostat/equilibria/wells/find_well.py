"""Finds the well of a relative equilibrium, in whatever kind of scene, or says why there is none."""
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cmp_to_key
from itertools import pairwise
from typing import TypeVar

from sympy import Expr

from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...errors import ScopeError
from ...mechanics.scenes.kind import Kind
from ...stability.decision import Verdict
from ..finders.revolution_form import RevolutionForm
from ..relative_equilibrium import RelativeEquilibrium
from .in_balls import BITS
from .landscape import Landscape, landscape_of
from .merge_tree import outcome
from .paths import Paths
from .tilts import tilt_well
from .well import Well

AnyWell = TypeVar("AnyWell", bound=Well)
UNSTABLE = "it is not stable: no kick is small enough"
UNDECIDED = "it is undecided whether this equilibrium is stable"
DEGENERATE = ("no barrier is found of an equilibrium that is not isolated, or whose second variation is "
              "degenerate")
HELD = ("the energy has no minimum here: gyroscopic forces hold it, with no bound of the energy, and damping "
        "takes it away")
NO_PATH = "the way down from an equilibrium is not proved: no pass lies below it, what lies above is open"
NOT_ISOLATED = "a degenerate equilibrium lies above: no pass lies below it, what lies above is open"


def well_of(rotation: RelativeEquilibrium) -> Well:
    """Return the well of a relative equilibrium, with a reason if it has none."""
    form = rotation.form
    if (verdict := rotation.decision.verdict) is not Verdict.STABLE:
        return Well(rotation, reason=UNSTABLE if verdict is Verdict.UNSTABLE else UNDECIDED)
    if isinstance(form, RevolutionForm):
        tilt = tilt_well(rotation)
        return Well(rotation, reason=tilt.reason, line=tilt)
    if form.index is None or form.locus:
        return Well(rotation, reason=DEGENERATE)
    turned = rotation.scene.kind is Kind.FREE and form.index == len(form.signs)
    if form.index != 0 and not turned:
        return Well(rotation, reason=HELD)
    try:
        landscape = landscape_of(rotation)
    except ScopeError as error:
        return Well(rotation, reason=str(error))
    points = landscape.points
    down = [None if e.locus or 0 in e.form.signs else e.form.index for e in points]
    indices = [len(e.form.signs) - n if turned and n is not None else n for n, e in zip(down, points)]
    return filled(Well(rotation), landscape, indices)


def filled(well: AnyWell, landscape: Landscape, indices: Sequence[int | None]) -> AnyWell:
    """Return a well with what it meets first, by the numbers of directions down from the critical points.

    The number is None for a degenerate point, and 0 for the minimum of the well.
    """
    here, points = landscape.number(well.rotation), landscape.points
    paths = Paths(landscape, indices)
    with own_precision(BITS):
        levels: list[list[int]] = []
        for n in sorted(range(len(indices)), key=lambda n: float(paths.values[n].mid())):
            if levels and paths.values[levels[-1][-1]].overlaps(paths.values[n]):
                levels[-1].append(n)
            else:
                levels.append([n])
        heights = [value - paths.values[here] for value in paths.values]
    found = outcome(here, levels, indices, paths.ends)
    if found.tied:
        levels = [part for level in levels for part in (
            _by_value(points, level, well.value) if found.passes[0] in level else [level])]
        found = outcome(here, levels, indices, paths.ends)
    stopped = found.stopped
    reason = "" if stopped is None else NOT_ISOLATED if indices[stopped] is None else NO_PATH
    return replace(well, points=points, heights=heights, found=found, reason=reason)


def _by_value(points: Sequence[RelativeEquilibrium], level: list[int],
              value: Callable[[RelativeEquilibrium], Expr]) -> list[list[int]]:
    """Classes of equal V, exactly, of points that balls do not tell apart; the lowest first."""
    def compared(a: int, b: int) -> int:
        return proved_sign(evaluate(value(points[a]) - value(points[b]), {}))

    ordered = sorted(level, key=cmp_to_key(compared))
    parts = [ordered[:1]]
    for before, n in pairwise(ordered):
        parts.append([n]) if compared(before, n) else parts[-1].append(n)
    return parts
