"""Finds the well of a relative equilibrium, in whatever kind of scene, or says why there is none."""
from ...errors import ScopeError
from ...mechanics.scenes.kind import Kind
from ...stability.decision import Verdict
from ..finders.revolution_form import RevolutionForm
from ..relative_equilibrium import RelativeEquilibrium
from .basin import filled
from .landscape import landscape_of
from .paths import Paths
from .tilts import tilt_well
from .well import Well

UNSTABLE = "it is not stable: no kick is small enough"
UNDECIDED = "it is undecided whether this equilibrium is stable"
DEGENERATE = ("no barrier is found of an equilibrium that is not isolated, or whose second variation is "
              "degenerate")
HELD = ("the energy has no minimum here: gyroscopic forces hold it, with no bound of the energy, and damping "
        "takes it away")


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
    down = [None if e.locus else e.form.index for e in points]
    indices = [len(e.form.signs) - n if turned and n is not None else n for n, e in zip(down, points)]
    return filled(Well(rotation), Paths(landscape, indices))
