"""What is said of a family of permanent rotations: of its names, and of those in which its conditions are."""
from sympy import S

from ..mechanics.directions import in_any_direction
from ..mechanics.equilibria import Equilibrium
from ..mechanics.permanent_rotation import OMEGA, SIGMA
from ..notation import symbol
from ..stability.report import Report
from ..stability.rotation_report import RotationReport
from .blocks import Block, Display, Word, sentence
from .conditions import POLYNOMIAL

EQUATION = Word("∇U = ω² I k + ω l + σ k",
                r"\nabla ⟨U⟩ = ⟨omega⟩^2 I ⟨vector_k⟩ + ⟨omega⟩ ⟨vector_l⟩ + ⟨sigma⟩ ⟨vector_k⟩")
AMENDED = Word("U + (C₁ − l·k)²/(2 k·Ik)",
               r"⟨U⟩ + (⟨C1⟩ - ⟨vector_l⟩\cdot ⟨vector_k⟩)^2/(2\, ⟨vector_k⟩\cdot I ⟨vector_k⟩)")


def family_blocks(eq: Equilibrium) -> list[Block]:
    """What its rate and its multiplier are, and that k is a unit vector."""
    if not {OMEGA, SIGMA} <= set[object]().union(*(value.free_symbols for _, value in eq.relations)):
        return []
    k, unit = Word("k", "⟨vector_k⟩"), Word("|k| = 1", "|⟨vector_k⟩| = 1")
    blocks: list[Block] = [sentence("The body turns about ", k, " at the rate ", OMEGA, ", ", EQUATION, "; ",
                                    SIGMA, " is the multiplier of ", unit, ".")]
    if in_any_direction(eq):
        blocks.append(Display(sum((x**2 for x in eq.point[3:]), S.Zero), S.One, label="unit"))
    return blocks


def definition_blocks(report: Report) -> list[Block]:
    """The names in which the conditions in any direction are written; nothing of another report."""
    if not isinstance(report, RotationReport):
        return []
    k, trace, determinant = Word("k", "⟨vector_k⟩"), symbol("t"), symbol("s")
    return [sentence("Here K is the second variation of the amended potential ", AMENDED, ", ", trace,
                     " and ", determinant, " its trace and determinant on the plane across ", k, "; A is the "
                     "inertia and ", symbol("G"), " the gyroscopic term of the motion near it, of "
                     "characteristic polynomial ", POLYNOMIAL, " (Simo, Lewis & Marsden 1991):"),
            *(Display(name, value, report.equilibrium.at, label="definition")
              for name, value in report.closed.definitions)]
