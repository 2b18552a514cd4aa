"""Describes scenes with two directions, or a coupling β, and an equilibrium at rest in their frame."""
from collections.abc import Sequence
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Symbol

from ...algebra.rings.readable import readable
from ...mechanics.scenes.coupled import CoupledPotential
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...registry import Letters
from ...stability.criteria.orientation_form import orientation_form
from ...stability.criteria.sextic import factors_in_squares
from ...stability.report.report import Report
from ...typesetting import typeset
from ..blocks import Block, Display, Heading, Word, equations, listed, sentence
from ..letters import letter, letters_of, word

_MOTION = ("⟨vector_I⟩ θ̈ + ⟨g⟩ × θ̇ + ⟨K⟩ θ = 0",
           r"⟨vector_I⟩\ddot\theta + ⟨g⟩\times\dot\theta + ⟨K⟩\theta = 0")
_FREE = ("⟨vector_M_dot⟩ = ⟨vector_M⟩ × ⟨vector_omega⟩", r"⟨vector_M_dot⟩ = ⟨vector_M⟩\times⟨vector_omega⟩")
_IN_FIELD = (" + ⟨vector_k⟩ × ∇⟨U⟩,  ⟨vector_k_dot⟩ = ⟨vector_k⟩ × ⟨vector_omega⟩",
             r" + ⟨vector_k⟩\times\nabla ⟨U⟩,\quad ⟨vector_k_dot⟩ = ⟨vector_k⟩\times⟨vector_omega⟩")


def casimirs(letters: Letters) -> tuple[Word, ...]:
    """The names of the Casimirs in a field."""
    return tuple(letter(letters, f"C{n}") for n in (1, 2, 3))


def space_of(scene: System) -> str:
    """The name of the space."""
    if scene.potential is None or len(scene.potential.directions) == 1:
        return f"{'e' if scene.potential else 'so'}(3)*"
    return "the dual of so(3) with two directions, each in R³"


def coupling(scene: System) -> tuple[Any, ...]:
    """Write the coupling β of the energy, if there is one."""
    if not isinstance(scene.potential, CoupledPotential) or not any(scene.potential.drift):
        return ()
    letters = letters_of(scene)
    energy = word(letters, "⟨beta⟩·(⟨vector_M⟩ − ⟨vector_l⟩)", r"⟨beta⟩\cdot(⟨vector_M⟩ - ⟨vector_l⟩)")
    return ", with the energy ", energy, " of ", letter(letters, "beta"), " = (", *listed(
        scene.potential.drift), ")"


def held_blocks(scene: System) -> list[Block]:
    """Write the values of the Casimirs."""
    if not isinstance(scene.potential, CoupledPotential) or not scene.potential.held:
        return []
    names = dict(zip(scene.space.casimirs, casimirs(letters_of(scene))))
    pairs = [(names[casimir], value) for casimir, value in scene.potential.held if casimir in names]
    return [sentence("In this scene ", *equations(pairs), ".")]


def motion_form(scene: System) -> Word:
    """Write the equations of motion in vectors; the momentum is M = Iω + l, as π is a number too."""
    letters = letters_of(scene)
    if not scene.coupled or not scene.potential:
        forms = zip(_FREE, _IN_FIELD if scene.potential else ("", ""))
        return word(letters, *(free + field for free, field in forms))
    vectors = [f"⟨vector_{a}⟩" for a in scene.potential.directions]
    rates = [f"⟨vector_{a}_dot⟩" for a in scene.potential.directions]
    torques = " + ".join(f"{a} × ∂⟨h⟩/∂{a}" for a in vectors)
    turning = ",  ".join(f"{rate} = {a} × ⟨vector_omega⟩" for rate, a in zip(rates, vectors))
    latex = " + ".join(rf"{a}\times\partial ⟨h⟩/\partial {a}" for a in vectors)
    turned = r",\quad ".join(rf"{rate} = {a}\times⟨vector_omega⟩" for rate, a in zip(rates, vectors))
    return word(letters, f"{_FREE[0]} + {torques},  {turning},  ⟨vector_omega⟩ = ∂⟨h⟩/∂⟨vector_M⟩",
                rf"{_FREE[1]} + {latex},\quad {turned},\quad "
                r"⟨vector_omega⟩ = \partial ⟨h⟩/\partial ⟨vector_M⟩")


def frame_blocks(report: Report) -> list[Block]:
    """Write K, g and the factors of the sextic; or its coefficients in names, if it is long."""
    eq, heading = report.equilibrium, Heading("Linearised motion in the frame of the directions", 2)
    if report.closed is not None:
        return [heading, *frame_definitions(report)]
    form, letters = orientation_form(eq), letters_of(eq.system)
    K, square = letter(letters, "K"), symbol(letters.of("x"))
    blocks: list[Block] = [
        heading,
        sentence("If the body is turned by a small ", Word("θ", r"\theta"), ", it moves by ",
                 word(letters, *_MOTION), " with"),
        Display(K, ImmutableMatrix(form.stiffness.applyfunc(readable)), eq.at, label="K"),
        Display(letter(letters, "g"), ImmutableMatrix([[*map(readable, form.gyroscopic)]]), eq.at, label="g"),
        sentence("The second variation on the coadjoint orbit is the sum of a positive form of the momenta "
                 "and of ", K, ". With ", word(letters, "⟨x⟩ = ⟨lamda⟩²", "⟨x⟩ = ⟨lamda⟩^2"),
                 " the characteristic polynomial has the factors:")]
    for n, (first, *others) in enumerate(dict.fromkeys(factors_in_squares(form.coefficients)), 1):
        blocks.append(Display(letter(letters, f"f{n}"), _polynomial([first, *others], square), eq.at,
                              label=f"factor{n}"))
    return blocks


def frame_definitions(report: Report) -> list[Block]:
    """Define the names in which the conditions of a body at rest are written, if there are any."""
    eq, closed = report.equilibrium, report.closed
    if closed is None or not eq.system.coupled:
        return []
    letters, own = letters_of(eq.system), closed.named
    K, g = letter(letters, "K"), letter(letters, "g")
    return [sentence("Here ", K, " and ", g, " are those of the motion ", word(letters, *_MOTION),
                     " of the body, turned by a small ", Word("θ", r"\theta"), ", and ",
                     *listed(own.coefficients), " the coefficients of its characteristic polynomial ",
                     _sextic(letters, own.coefficients), ". ", K, " is the second variation, beside a "
                     "positive form of the momenta."),
            Display(K, ImmutableMatrix(own.K), eq.at, label="K"),
            Display(g, ImmutableMatrix([own.g]), eq.at, label="g"),
            *(Display(name, value, eq.at, label="definition") for name, value in closed.definitions)]


def parallel_blocks(report: Report) -> list[Block]:
    """Say what the matrices and the conditions are about, if the directions are parallel."""
    if report.along is None:
        return []
    return [sentence("The two directions are parallel at this equilibrium, and the coadjoint orbit is "
                     "singular. Directions that are parallel once stay parallel. The matrices are those of "
                     "such motions; if one of these motions grows, the equilibrium is unstable. The "
                     "sufficient conditions are for all motions. If they fail and none of these motions "
                     "grows, nothing is claimed.")]


def _sextic(letters: Letters, coefficients: Sequence[Symbol]) -> Word:
    """Write λ⁶ + a λ⁴ + b λ² + c."""
    templates = {"text": "{0}⁶ + {1} {0}⁴ + {2} {0}² + {3}",
                 "latex": r"{0}^6 + {1}\,{0}^4 + {2}\,{0}^2 + {3}"}
    names = letters.of("lamda"), *(x.name for x in coefficients)
    return Word(*(template.format(*(typeset(name, style=style) for name in names))
                  for style, template in templates.items()))


def _polynomial(coefficients: list[Expr], square: Symbol) -> Expr:
    size = len(coefficients) - 1
    return Add(*(readable(c) * square ** (size - n) for n, c in enumerate(coefficients)))
