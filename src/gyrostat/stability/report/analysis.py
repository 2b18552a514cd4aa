"""Makes the report of an equilibrium, of the kind that it needs: the one call a newcomer needs."""
from ..._lazy import loaded
from ...errors import ArgumentError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.parallel_directions import parallel
from ...mechanics.equilibrium.unit_vectors import in_any_direction
from ...mechanics.scenes.system import System
from .report import Report


def analyze(eq: Equilibrium) -> Report:
    """Return the stability analysis of an equilibrium.

    Parameters
    ----------
    eq : Equilibrium

    Returns
    -------
    Report
        its parts are derived when they are first asked for

    Raises
    ------
    ArgumentError
        a scene is given, or anything else that is no equilibrium

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> report = gs.analyze(gs.inclined(top))
    >>> necessary = report.necessary.alternatives[0][0]
    >>> necessary.margin == report.sufficient.alternatives[0][0].margin
    True
    """
    if isinstance(eq, System):
        raise ArgumentError("the equilibrium is a System, a scene: choose one of its equilibria, "
                            "upright(scene), hanging(scene), inclined(scene), static_tilt(scene), "
                            "principal_rotation(scene, axis) or equilibrium(scene, point)")
    if not isinstance(eq, Equilibrium):
        return Report(eq)                                  # which refuses it
    kind: type[Report] = Report
    if parallel(eq):
        kind = loaded("stability.report.parallel_report:ParallelReport")
    elif in_any_direction(eq):
        kind = loaded("stability.report.rotation_report:RotationReport")
    return kind(eq)
