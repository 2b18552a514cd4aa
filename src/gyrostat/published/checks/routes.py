"""Says by which derivation and by which comparison a statement was confirmed.

A formula or a condition is compared in exact arithmetic, a decimal to more digits than are printed. Numbers
are drawn, and Newton and Euler's equations are asked, only where a statement is not confirmed.
"""
from collections.abc import Mapping

from ...mechanics.equilibrium.equilibrium import Equilibrium
from ..scenes import Scene

_SPECTRAL = "the spectral criterion: no root of the characteristic polynomial has a positive real part"
_FORMAL = "the formal criterion: the second variation of the energy, with Casimirs and integrals, is definite"
# what the condition of each claim is derived from
CRITERIA: Mapping[str, str] = {
    "necessary for stability": _SPECTRAL,
    "necessary and sufficient for spectral stability": _SPECTRAL,
    "sufficient for stability": _FORMAL,
    "necessary and sufficient for stability": _FORMAL,
    "sufficient for stability, Casimirs alone":
        "the formal criterion with the Casimirs alone: the second variation of the energy is definite",
    "sufficient for stability under internal damping":
        "the secular criterion: the equilibrium is stable, and stays so under internal damping",
    "sufficient for instability": "the spectral criterion, each of its conditions reversed",
    "sufficient for stability on the boundary":
        "the first coefficient of the reduced motion beyond the boundary, of the sign that proves stability",
    "sufficient for instability on the boundary":
        "the first coefficient of the reduced motion beyond the boundary, of the sign that disproves it",
    "existence": "the conditions under which the equilibrium exists",
    "sufficient for periodic motion":
        "the limits of |M|² on the surface of constant energy, without the separatrix"}
SAME_FORM = "both conditions have the same normal form where the claim is made"
SAME_SIGNS = "both conditions fix the same signs of the same factors where the claim is made"
AT_EQUALITY = ("both conditions have the same normal form but for equality, and there the boundary theorem "
               "proves stability")
COUNTED = "the equilibria in the complete list of the library, which is exact, are counted"
HOLDS = "the derived sufficient condition holds wherever the claim is made"
FAILS = "the derived necessary condition fails wherever the claim is made"
ON_BOUNDARY = ("the claim is made on the boundary between the two derived conditions, where the coefficients "
               "of the reduced motion decide")


def of_identity(scene: Scene, has_entries: bool) -> str:
    """Say how two expressions were found to be equal."""
    turning = "angles" in scene.table
    source = "the rotation by three Euler angles" if turning else "the bracket and the Hamiltonian"
    on = " on the family of the equilibrium" if scene.equilibrium else ""
    each = ", entry by entry" if has_entries else ""
    return f"derived from {source}; printed − derived vanishes identically{on}, in exact arithmetic{each}"


def of_point(eq: Equilibrium | None) -> str:
    """Say how a printed point was found to be an equilibrium."""
    on = ", with the relations of the family inserted" if eq and eq.relations else ""
    return f"every component of the field vanishes identically at the printed point{on}, in exact arithmetic"


def of_solution(constants: int) -> str:
    """Say how functions of the time were found to be a solution, with so many constants if it is general."""
    general = (f"; the derivatives by its constants have the rank {constants} at numbers, one for each "
               "equation") if constants else ""
    return f"the functions, put into the equations of motion, satisfy them identically in t{general}"


def of_number(digits: str) -> str:
    """Say how a decimal was found to be right."""
    return f"the derived number, computed to more digits than are printed, rounds to {digits}"


def of_condition(claim: str, comparison: str) -> str:
    """Say what a condition was derived from, and how it was compared."""
    return f"derived from {CRITERIA[claim]}; {comparison}"
