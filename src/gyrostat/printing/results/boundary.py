"""Writes what decides between the two criteria: the ladder of coefficients of the reduced motion."""
from itertools import islice
from typing import Any

from sympy import Expr, Mul, Rational

from ...algebra.rings.readable import readable
from ...mechanics.equilibrium.reduction import ENERGY, K3, P, V, reduce
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...registry import Letters
from ...stability.report.report import Report
from ...stability.theorems.boundary import HIGHEST, Boundary, Rung
from ...typesetting import SUBSCRIPTS, SUPERSCRIPTS
from ..blocks import Block, Display, Word, modulo_flow, sentence
from ..letters import letters_of, word

# rungs shown of a ladder without an end, of one with an end
FEW, SEVERAL = 3, 6
_BETWEEN = "if the necessary condition holds and the sufficient one does not, "


def boundary_blocks(report: Report) -> list[Block]:
    """Say what decides if the necessary condition holds and the sufficient one does not.

    The ladder, if there is one.
    """
    if not undecided(report):
        return []
    boundary, eq = report.boundary, report.equilibrium
    if boundary is None and report.between:
        return [sentence(_BETWEEN.capitalize(),
                         "the energy on the momentum sphere decides to fourth order, at given numbers.")]
    if boundary is None:
        return [sentence(_BETWEEN.capitalize(), "neither decides; a verdict at given numbers may.")]
    between = _BETWEEN.capitalize()
    if report.recognised:
        between = f"The scene is {report.recognised.sentence}; with that axis as the third, {_BETWEEN}"
        eq = boundary.equilibrium
    letters = letters_of(eq.system)
    g, distance = letters.of("g"), symbol(letters.of("x"))
    levels = {ENERGY: symbol(letters.of("h")), V: symbol(letters.of("C1")),
              P: eq.system.space.coordinates[2] + eq.system.body.gyrostatic_momentum[2]}
    levels |= {name: value for name, value in eq.relations if not value.free_symbols and name != K3}
    blocks: list[Block] = [
        sentence(between, "the reduced motion of ", K3, " decides, which on the level of the equilibrium is ",
                 squared_rate(eq.system), " = ", symbol(g), " with"),
        Display(symbol(g), reduce(eq.system).square().xreplace(levels), label="reduced")]
    series = _series(letters, boundary)
    place: tuple[Any, ...] = (distance, " is the deviation of ", K3, " and has either sign")
    if boundary.pole:
        place = (K3, " = ", eq.at * (1 - distance), ", ", word(letters, "⟨x⟩ ≥ 0", r"⟨x⟩ \geq 0"))
    rungs, more = ladder(boundary)
    if not rungs:
        return [*blocks, sentence("At equality ", series, ", where ", *place,
                                  ". All coefficients are 0, and the equilibrium is unstable.")]
    cn = word(letters, "⟨c_⟩ₙ", "⟨c_⟩_n")
    return [*blocks, sentence("At equality ", series, ", where ", *place, ". The first coefficient ", cn,
                              " that is not 0 decides. Up to positive factors:"),
            *(rung_display(rung, letters) for rung in rungs),
            sentence(*_outcome(boundary, rungs, more, report.sufficient.modulo))]


def _series(letters: Letters, boundary: Boundary) -> Word:
    """Write g by its powers; at a pole they are fractions if U has such powers."""
    near = boundary.equilibrium.near_pole
    if near is None or near.smooth:
        return word(letters, "⟨g⟩ = ⟨c3⟩ ⟨x⟩³ + ⟨c4⟩ ⟨x⟩⁴ + …",
                    r"⟨g⟩ = ⟨c_⟩_3 ⟨x⟩^3 + ⟨c_⟩_4 ⟨x⟩^4 + \dots")
    first, second = (2 + Rational(n, near.order) for n in (1, 2))
    return word(letters, f"⟨g⟩ = Σ ⟨c_⟩ₚ ⟨x⟩ᵖ, p = {first}, {second}, …",
                rf"⟨g⟩ = \sum ⟨c_⟩_p ⟨x⟩^p,\ p = {first}, {second}, \dots")


def squared_rate(scene: System) -> Expr:
    """Write I1² k̇3² in the names of the body."""
    return scene.body.moments[0] ** 2 * symbol("k3_dot") ** 2


def undecided(report: Report) -> bool:
    """Whether the two criteria leave anything open."""
    return () not in report.sufficient.alternatives and report.necessary.alternatives != ()


def ladder(boundary: Boundary) -> tuple[list[Rung], bool]:
    """Choose the rungs to show, and tell whether more may follow.

    Rungs that vanish together with the ones before are left out.
    """
    rungs: list[Rung] = []
    for rung in islice(boundary.rungs(), FEW if boundary.last is None else SEVERAL):
        margin = rung.condition.margin
        if margin == 0 or any(margin in (r.condition.margin, -r.condition.margin)
                              and not r.condition.degenerate for r in rungs):
            continue
        rungs.append(rung)
        if margin.is_number and not rung.condition.degenerate:
            return rungs, False
    return rungs, True


def rung_display(rung: Rung, letters: Letters) -> Display:
    """Write −c ∝ what has its sign: the margin with its even factors."""
    condition, sub = rung.condition, str(rung.power).translate(SUBSCRIPTS)
    value = Mul(condition.margin, *(factor**2 for factor in condition.degenerate))
    name = word(letters, f"−⟨c_⟩{sub}", f"-⟨c_⟩_{{{rung.power}}}")
    return Display(name, readable(value), condition.at, "∝", f"c{rung.power}")


def _outcome(boundary: Boundary, rungs: list[Rung], more: bool, modulo: tuple[Expr, ...]) -> list[Any]:
    """Say what each sign means, and what comes after the rungs shown."""
    parts: list[Any] = []
    odd, even = any(r.escapes for r in rungs), any(not r.escapes for r in rungs)
    positive, negative = (word(letters_of(boundary.equilibrium.system), f"−⟨c_⟩ₙ {sign} 0",
                               f"-⟨c_⟩_n {sign} 0") for sign in "><")
    if boundary.pole:
        parts += ["If ", positive, ", the equilibrium is Lyapunov stable (supercritical); if ", negative,
                  ", it is unstable (subcritical)."]
    if odd and not boundary.pole:
        parts.append("If n is odd, the equilibrium is unstable." + (" " if even else ""))
    if even and not boundary.pole:
        flow = (" ", *modulo_flow(modulo)) if modulo else ()
        parts += [f"If n is even, {'it' if odd else 'the equilibrium'} is Lyapunov stable", *flow, " if ",
                  positive, " and unstable if ", negative, "."]
    end = boundary.last or HIGHEST
    if more and (boundary.last is None or end > 2 + SEVERAL):
        potential = boundary.equilibrium.system.potential
        if potential is not None and potential.given:
            power_of_x = word(letters_of(boundary.equilibrium.system),
                              f"⟨x⟩{str(end).translate(SUPERSCRIPTS)}", f"⟨x⟩^{{{end}}}")
            parts += [" The ladder goes on up to ", power_of_x, "."]
        else:
            parts.append(" The ladder goes on to any order.")
    if more and boundary.last:
        parts += [" If all are 0, ", K3, " may stay at each value nearby, and the equilibrium is unstable."]
    return parts
