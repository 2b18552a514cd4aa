"""Describes a family: how it moves, what a tilt satisfies, and the names of permanent rotations."""
from typing import Any

from sympy import S, Symbol

from ...algebra.rings.readable import readable
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.unit_vectors import in_any_direction
from ...mechanics.families.named_families import E3, E3_AT_REST, FAMILIES
from ...notation import jet, symbol
from ...stability.report.report import Report
from ...typesetting import typeset
from ..blocks import Block, Display, Word, sentence
from ..letters import letter, letters_of, word
from .inequalities import polynomial_of

OMEGA, SIGMA = symbol("omega"), symbol("sigma")
TILTED = E3.label, E3_AT_REST.label
_EQUATION = ("∇⟨U⟩ = ω² ⟨vector_I⟩ ⟨vector_k⟩ + ω ⟨vector_l⟩ + σ ⟨vector_k⟩",
             r"\nabla ⟨U⟩ = ⟨omega⟩^2 ⟨vector_I⟩ ⟨vector_k⟩ + ⟨omega⟩ ⟨vector_l⟩ + ⟨sigma⟩ ⟨vector_k⟩")
_AMENDED = ("⟨U⟩ + (⟨C1⟩ − ⟨vector_l⟩·⟨vector_k⟩)²/(2 ⟨vector_k⟩·⟨vector_I⟩⟨vector_k⟩)",
            r"⟨U⟩ + (⟨C1⟩ - ⟨vector_l⟩\cdot ⟨vector_k⟩)^2/(2\, ⟨vector_k⟩\cdot ⟨vector_I⟩ ⟨vector_k⟩)")


def title_of(eq: Equilibrium) -> str:
    """Give the label, and how an equilibrium of this family moves unless the label says so."""
    family = FAMILIES.get(eq.label)
    title = eq.label[0].upper() + eq.label[1:]
    return f"{title}: {family.title}" if family and family.title else title


def tilt_blocks(eq: Equilibrium) -> list[Block]:
    """Say what a tilted equilibrium is: its tilt, its rate, and the relation of both with U and l."""
    if eq.label not in TILTED:
        return []
    rate = (" It turns about the vertical at the rate ", symbol("omega"), ".") if eq.label == E3.label else ()
    return [sentence("The axis of the body is tilted: ", symbol("k3"), " is the cosine of its angle to the "
                     "vertical.", *rate), *relation_blocks(eq)]


def tilt_relations(eq: Equilibrium) -> list[Display]:
    """Write what a tilted equilibrium satisfies: the relation of U, l, the rate and the tilt."""
    return satisfied(eq) if eq.label in TILTED else []


def satisfied(eq: Equilibrium) -> list[Display]:
    """Write the relations of a family, each name by the others."""
    return [Display(slope(eq, name), value if jet(name.name) else readable(value), eq.at, label="relation")
            for name, value in eq.relations]


def relation_blocks(eq: Equilibrium) -> list[Block]:
    """Write what holds on a family: its relations, if there are any."""
    return [sentence("The family satisfies:"), *satisfied(eq)] if eq.relations else []


def slope(eq: Equilibrium, name: Symbol) -> Any:
    """Name a derivative of U; if the scene has a letter U, another letter is taken."""
    letters = letters_of(eq.system)
    if not jet(name.name) or letters.of("U") == "U":
        return name
    shown = [typeset(name.name, eq.at, style).replace("U", typeset(letters.of("U"), style=style))
             for style in ("text", "latex")]
    return Word(*shown)


def family_blocks(eq: Equilibrium) -> list[Block]:
    """Say what the rate and the multiplier of a rotation are, and that k is a unit vector."""
    if not {OMEGA, SIGMA} <= set[object]().union(*(value.free_symbols for _, value in eq.relations)):
        return []
    letters = letters_of(eq.system)
    k, unit = letter(letters, "vector_k"), word(letters, "|⟨vector_k⟩| = 1", "|⟨vector_k⟩| = 1")
    equation = word(letters, *_EQUATION)
    blocks: list[Block] = [sentence("The body turns about ", k, " at the rate ", OMEGA, ", with ", equation,
                                    ", where ", SIGMA, " is the multiplier of ", unit, ".")]
    if in_any_direction(eq):
        blocks.append(Display(sum((x**2 for x in eq.point[3:]), S.Zero), S.One, label="unit"))
    return blocks


def definition_blocks(report: Report) -> list[Block]:
    """Define the names in which the conditions of a rotation are written, if there are any."""
    if report.closed is None or report.equilibrium.system.coupled:
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
