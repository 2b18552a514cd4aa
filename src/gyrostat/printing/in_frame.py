"""Two directions, and a coupling β: their scene, and what an equilibrium at rest in their frame has."""
from typing import Any

from sympy import Expr, ImmutableMatrix

from ..algebra.readable import readable
from ..mechanics.coupled import CoupledPotential
from ..mechanics.system import System
from ..notation import symbol, typeset
from ..stability.orientation_form import orientation_form
from ..stability.parallel_report import ParallelReport
from ..stability.report import Report
from ..stability.sextic import factors_in_squares
from .blocks import VECTOR_FORM, Block, Display, Heading, Word, equations, listed, sentence

SQUARE = symbol("x")
MOTION = Word("I θ̈ + g × θ̇ + K θ = 0", r"⟨I⟩\ddot\theta + ⟨g⟩\times\dot\theta + ⟨K⟩\theta = 0")
CASIMIRS = tuple(Word(f"C{sub}", rf"⟨C{n}⟩") for n, sub in enumerate("₁₂₃", 1))


def space_of(scene: System) -> str:
    """The name of the space."""
    if scene.potential is None or len(scene.potential.directions) == 1:
        return f"{'e' if scene.potential else 'so'}(3)*"
    return "the dual of so(3) with two directions, each in R³"


def coupling(scene: System) -> tuple[Any, ...]:
    """β of the energy, where there is one."""
    if not isinstance(scene.potential, CoupledPotential) or not any(scene.potential.drift):
        return ()
    energy, beta = Word("β·π", r"\beta\cdot⟨vector_pi⟩"), Word("β", r"\beta")
    return ", with the energy ", energy, " of ", beta, " = (", *listed(scene.potential.drift), ")"


def held_blocks(scene: System) -> list[Block]:
    """What the Casimirs are."""
    if not isinstance(scene.potential, CoupledPotential) or not scene.potential.held:
        return []
    names = dict(zip(scene.space.casimirs, CASIMIRS))
    pairs = [(names[casimir], value) for casimir, value in scene.potential.held if casimir in names]
    return [sentence("There ", *equations(pairs), ".")]


def vector_form(directions: tuple[str, ...]) -> Word:
    """The equations of motion in vectors."""
    plain = [typeset(a, style="text") for a in directions]
    torques = " + ".join(f"{a} × ∂h/∂{a}" for a in plain)
    turning = ",  ".join(f"{a}̇ = {a} × ω" for a in plain)
    names = [typeset(a) for a in directions]
    latex = " + ".join(rf"{a}\times\partial ⟨h⟩/\partial {a}" for a in names)
    turned = r",\quad ".join(rf"\dot{{{a}}} = {a}\times⟨vector_omega⟩" for a in names)
    return Word(f"π̇ = M × ω + {torques},  {turning},  ω = ∂h/∂π",
                rf"⟨vector_pi_dot⟩ = ⟨vector_M⟩\times⟨vector_omega⟩ + {latex},\quad {turned},\quad "
                r"⟨vector_omega⟩ = \partial ⟨h⟩/\partial ⟨vector_pi⟩")


def motion_form(scene: System) -> Word:
    """The equations of motion of a scene in vectors."""
    if scene.coupled and scene.potential:
        return vector_form(scene.potential.directions)
    return VECTOR_FORM[scene.potential is not None]


def frame_blocks(report: Report) -> list[Block]:
    """K, g and the factors of the sextic."""
    eq = report.equilibrium
    form = orientation_form(eq)
    blocks: list[Block] = [
        Heading("Linearised motion in the frame of the directions", 2),
        sentence("Turned by a small ", Word("θ", r"\theta"), " the body moves by ", MOTION, ", with"),
        Display(Word("K", "⟨K⟩"), ImmutableMatrix(form.stiffness.applyfunc(readable)), eq.at, label="K"),
        Display(Word("g", "⟨g⟩"), ImmutableMatrix([[*map(readable, form.gyroscopic)]]), eq.at, label="g"),
        sentence("The second variation on the coadjoint orbit is a positive form of the momenta beside ",
                 Word("K", "⟨K⟩"), "; with ", Word("x = λ²", r"x = ⟨lamda⟩^2"),
                 " the characteristic polynomial has the factors:")]
    for n, (first, *others) in enumerate(dict.fromkeys(factors_in_squares(form.coefficients)), 1):
        blocks.append(Display(Word(f"f{'₀₁₂₃'[n]}", f"f_{n}"), _polynomial([first, *others]), eq.at,
                              label=f"factor{n}"))
    return blocks


def parallel_blocks(report: Report) -> list[Block]:
    """Where the directions are parallel: of which motions the matrices and the conditions are."""
    if not isinstance(report, ParallelReport):
        return []
    return [sentence("The directions are parallel there, and the coadjoint orbit is singular. Directions "
                     "that are parallel once stay so: the matrices are those of such motions, and what is "
                     "unstable among them is unstable. The sufficient conditions are against all motions; "
                     "nothing is claimed where they fail and none of these motions grows.")]


def _polynomial(coefficients: list[Expr]) -> Expr:
    size = len(coefficients) - 1
    return sum((readable(c) * SQUARE ** (size - n) for n, c in enumerate(coefficients)), symbol("x") * 0)
