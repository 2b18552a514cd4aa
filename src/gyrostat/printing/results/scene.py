"""Describes a scene: body, field, bracket, Casimirs and energy, equations of motion, integrals."""
from typing import Any

from sympy import MatrixBase

from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.system import System
from ..blocks import Block, Display, Heading, listed, rate_of, sentence
from ..letters import letter, letters_of, word
from .two_directions import casimirs, coupling, held_blocks, motion_form, space_of


def scene_blocks(scene: System) -> list[Block]:
    """Describe body, field, bracket, equations of motion and integrals."""
    body, space, potential, letters = scene.body, scene.space, scene.potential, letters_of(scene)
    field: tuple[Any, ...] = ("There is no field.",)
    if potential:
        field = ("The potential is ", potential.expression, *coupling(scene), ".")
    bracket = word(letters, "{⟨F⟩, ⟨G⟩} = ∇⟨F⟩·⟨B⟩∇⟨G⟩",
                   r"\{⟨F⟩, ⟨G⟩\} = \nabla ⟨F⟩\cdot ⟨B⟩\,\nabla ⟨G⟩")
    blocks: list[Block] = [
        Heading("Scene", label="scene"),
        sentence("The body has ", *_inertia(body), " and the gyrostatic momentum ",
                 letter(letters, "vector_l"), " = (", *listed(body.gyrostatic_momentum), "); its angular "
                 "momentum is ", *_momentum(scene), ". ", *field),
        sentence(f"The Poisson tensor on {space_of(scene)}, ", bracket, ", satisfies the Jacobi identity "
                 "(Marsden, Ratiu & Weinstein 1984; with a rotor, Vera & Viguera 2003, §2):"),
        Display(letter(letters, "B"), space.tensor, label="bracket")]
    names = casimirs(letters) if potential else (letter(letters, "C"),)
    blocks += [sentence("The Casimirs and the Hamiltonian are:"),
               *(Display(n, c, label="casimir") for n, c in zip(names, space.casimirs)),
               *held_blocks(scene), Display(letter(letters, "h"), scene.hamiltonian,
                                             label="hamiltonian")]
    vector = motion_form(scene)
    blocks += [sentence("The equations of motion are ", vector, ":"),
               *(Display(rate_of(str(x)), rate, label=f"motion:{x}")
                 for x, rate in zip(space.coordinates, scene.vector_field()))]
    return [*blocks, *_integrals(scene)]


def _integrals(scene: System) -> list[Block]:
    """List the integrals that were found, and those that were given with the level on which they hold."""
    letters = letters_of(scene)
    commutes = word(letters, "{⟨F⟩, ⟨h⟩} = 0", r"\{⟨F⟩, ⟨h⟩\} = 0")
    level = word(letters, "⟨C1⟩ = 0", "⟨C1⟩ = 0")
    blocks: list[Block] = []
    if scene.linear_integrals:
        found = "An integral was found" if len(scene.linear_integrals) == 1 else "Integrals were found"
        blocks.append(sentence(f"{found}, with ", commutes, ": ", *listed(scene.linear_integrals), "."))
    for n, F in enumerate(scene.given_integrals, len(scene.linear_integrals) + 1):
        where = (" if ", level) if F in scene.level_only else ()
        blocks += [sentence("An integral was given, with ", commutes, *where, ":"),
                   Display(letter(letters, f"F{n}"), F, label=f"integral{n}")]
    return blocks


def _momentum(scene: System) -> tuple[Any, ...]:
    """Write M = Iω + l; if the energy has a term that is linear in the momentum, write M by components."""
    letters = letters_of(scene)
    if not scene.coupled:
        return (word(letters, "⟨vector_M⟩ = ⟨vector_I⟩⟨vector_omega⟩ + ⟨vector_l⟩",
                     "⟨vector_M⟩ = ⟨vector_I⟩ ⟨vector_omega⟩ + ⟨vector_l⟩"),)
    parts = [x + l for x, l in zip(scene.space.coordinates, scene.body.gyrostatic_momentum)]
    return letter(letters, "vector_M"), " = (", *listed(parts), ")"


def _inertia(body: Gyrostat) -> tuple[Any, ...]:
    if not isinstance(body.inertia, MatrixBase):
        return "the principal moments (", *listed(body.moments), ")"
    rows = [(*listed(row), "; ") for row in body.inertia.tolist()]
    return "the inertia tensor (", *[part for row in rows for part in row][:-1], ")"
