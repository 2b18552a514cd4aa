"""The one call a newcomer needs."""
from ..mechanics.equilibria import Equilibrium
from .report import Report


def analyze(eq: Equilibrium) -> Report:
    """The stability analysis of an equilibrium.

    Parameters
    ----------
    eq : Equilibrium

    Returns
    -------
    Report
        its parts are derived when they are first asked for

    Examples
    --------
    >>> import gyrostat as gs
    >>> report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
    >>> report.necessary.alternatives[0][0].margin == report.sufficient.alternatives[0][0].margin
    True
    """
    return Report(eq)
