"""Names the kinds of bifurcation of relative equilibria, and tells which one is at a place of a curve."""
from sympy import Expr

from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.stations import Place
from ...mechanics.families.family import Family
from ...mechanics.families.named_families import E3, POLES

KINDS = {
    "E3 leaves E1": "at a fixed rotor and rate about the vertical; E1 is stable on both sides",
    "E3 leaves E2": "at a fixed rotor and rate about the vertical; E2 is stable on both sides",
    "fold at fixed rate": "two E3 meet at a fixed rotor and rate about the vertical; stability does not "
                          "change there",
    "precessions leave E1": "the boundary of E1, on the levels of E1; Report.boundary decides whether they "
                            "are stable",
    "precessions leave E2": "the boundary of E2, on the levels of E2; Report.boundary decides whether they "
                            "are stable",
    "fold on a level": "two precessions meet on a level of both momenta; one is stable, the other is not",
    "fold": "two permanent rotations meet: of one the energy is an extremum, of the other a saddle",
    "pitchfork": "two permanent rotations on either side of a principal plane meet one in it",
    "circle leaves an axis": "a circle of permanent rotations about an axis shrinks to a rotation about it",
}
AT_RATE, ON_LEVEL = "at fixed rate", "on a level"


def tilt_leaves(family: Family) -> str:
    """Return the kind of bifurcation at a fixed rate at which tilts come from a pole."""
    return f"{E3.label} leaves {family.label}"


def precessions_leave(family: Family) -> str:
    """Return the kind of bifurcation on the levels of a pole at which precessions come from it."""
    return f"precessions leave {family.label}"


def kind_of(place: Place, kinds: str) -> str:
    """Return the name of what happens at a place of a curve, by the branches that come to it.

    The curve is that of E3, or of the precessions of a level.
    """
    few, many = sorted((len(place.left), len(place.right)))
    if place.x**2 == 1:
        return tilt_leaves(POLES[int(place.x)]) if many else ""
    if few == many == 1:                                   # one branch passes
        return ""
    if many == 0:
        return f"isolated {kinds}"
    if few == 0:
        return f"fold {kinds}"
    return f"pitchfork {kinds}" if few == 1 else f"crossing {kinds}"


def defined(curve: PlaneCurve, t: Expr, x: Expr) -> bool:
    """Tell whether U' is finite at a point."""
    return all(curve.sign(pole, t, x) != 0 for pole in curve.poles)
