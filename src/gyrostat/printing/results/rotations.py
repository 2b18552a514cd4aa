"""What is said of a family of permanent rotations: of its names, and of those in which its conditions are."""
from sympy import S

from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.unit_vectors import in_any_direction
from ...notation import symbol
from ...stability.report.report import Report
from ..blocks import Block, Display, sentence
from ..letters import letter, letters_of, word
from .inequalities import polynomial_of

OMEGA, SIGMA = symbol("omega"), symbol("sigma")
_EQUATION = ("∇⟨U⟩ = ω² ⟨vector_I⟩ ⟨vector_k⟩ + ω ⟨vector_l⟩ + σ ⟨vector_k⟩",
             r"\nabla ⟨U⟩ = ⟨omega⟩^2 ⟨vector_I⟩ ⟨vector_k⟩ + ⟨omega⟩ ⟨vector_l⟩ + ⟨sigma⟩ ⟨vector_k⟩")
_AMENDED = ("⟨U⟩ + (⟨C1⟩ − ⟨vector_l⟩·⟨vector_k⟩)²/(2 ⟨vector_k⟩·⟨vector_I⟩⟨vector_k⟩)",
            r"⟨U⟩ + (⟨C1⟩ - ⟨vector_l⟩\cdot ⟨vector_k⟩)^2/(2\, ⟨vector_k⟩\cdot ⟨vector_I⟩ ⟨vector_k⟩)")


def family_blocks(eq: Equilibrium) -> list[Block]:
    """What its rate and its multiplier are, and that k is a unit vector."""
    if not {OMEGA, SIGMA} <= set[object]().union(*(value.free_symbols for _, value in eq.relations)):
        return []
    letters = letters_of(eq.system)
    k, unit = letter(letters, "vector_k"), word(letters, "|⟨vector_k⟩| = 1", "|⟨vector_k⟩| = 1")
    equation = word(letters, *_EQUATION)
    blocks: list[Block] = [sentence("The body turns about ", k, " at the rate ", OMEGA, ", ", equation, "; ",
                                    SIGMA, " is the multiplier of ", unit, ".")]
    if in_any_direction(eq):
        blocks.append(Display(sum((x**2 for x in eq.point[3:]), S.Zero), S.One, label="unit"))
    return blocks


def definition_blocks(report: Report) -> list[Block]:
    """The names in which the conditions in any direction are written; nothing of another report."""
    if report.closed is None:
        return []
    letters, own = letters_of(report.equilibrium.system), report.closed.named
    return [sentence("Here ", letter(letters, "K"), " is the second variation of the amended potential ",
                     word(letters, *_AMENDED), ", ", own.trace, " and ", own.determinant, " its trace and "
                     "determinant on the plane across ", letter(letters, "vector_k"), "; ",
                     letter(letters, "A"), " is the inertia and ", own.G, " the gyroscopic term of the "
                     "motion near it, of characteristic polynomial ", polynomial_of(letters),
                     " (Simo, Lewis & Marsden 1991):"),
            *(Display(name, value, report.equilibrium.at, label="definition")
              for name, value in report.closed.definitions)]
