"""Finds the well of a relative equilibrium, in whatever kind of scene, or says why there is none."""
from ...algebra.enclosures.precision import own_precision
from ...errors import ScopeError
from ...mechanics.scenes.kind import Kind
from ...stability.decision import Verdict
from ..relative_equilibrium import RelativeEquilibrium
from .in_balls import BITS
from .landscape import landscape_of
from .merge_tree import outcome
from .paths import Paths
from .tilts import tilt_well
from .well import Well

UNSTABLE = "it is not stable: no kick is small enough"
DEGENERATE = "the second variation is degenerate here: that it is stable is known, and no barrier"
HELD = ("the energy has no minimum here: gyroscopic forces hold it, with no bound of the energy, and damping "
        "takes it away")
NO_PATH = "the way down from an equilibrium is not proved: no pass lies below it, what lies above is open"
NOT_ISOLATED = "a degenerate equilibrium lies above: no pass lies below it, what lies above is open"


def well_of(rotation: RelativeEquilibrium) -> Well:
    """Return the well of a relative equilibrium, with a reason if it has none."""
    form = rotation.form
    if rotation.decision.verdict is not Verdict.STABLE:
        return Well(rotation, reason=UNSTABLE if rotation.decision.verdict is Verdict.UNSTABLE else HELD)
    if rotation.scene.kind is Kind.REVOLUTION:
        tilt = tilt_well(rotation)
        return Well(rotation, reason=tilt.reason, line=tilt)
    if form.index is None:
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
    paths = Paths(landscape, indices)
    with own_precision(BITS):
        here = landscape.number(rotation)
        levels: list[list[int]] = []
        for n in sorted(range(len(points)), key=lambda n: float(paths.values[n].mid())):
            if levels and paths.values[levels[-1][-1]].overlaps(paths.values[n]):
                levels[-1].append(n)
            else:
                levels.append([n])
        heights = [value - paths.values[here] for value in paths.values]
    found = outcome(here, levels, indices, paths.ends)
    stopped = found.stopped
    reason = "" if stopped is None else NOT_ISOLATED if indices[stopped] is None else NO_PATH
    return Well(rotation, points, heights, found, reason)
