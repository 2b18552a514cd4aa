"""Turns a report into headings, sentences and displayed formulas."""
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sympy import Expr, ImmutableMatrix, Pow, S, Symbol

from ..._lazy import loaded
from ...algebra.rings.readable import entries, readable, split
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.relations import affine
from ...mechanics.families.named_families import FAMILIES
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.linearization import Linearization
from ...stability.criteria.orientation_form import rests_in_frame
from ...stability.report.report import Report
from ..blocks import Block, Display, Heading, Word, equations, joined, listed, sentence
from ..glossary import term_blocks
from ..letters import letter, letters_of, word
from ..nomenclature import occurring, symbol_rows
from .boundary import boundary_blocks
from .inequalities import (
    criterion_blocks,
    existence,
    implied_blocks,
    integral_blocks,
    polynomial_of,
    short_blocks,
)
from .rotations import (
    definition_blocks,
    family_blocks,
    relation_blocks,
    slope,
    tilt_blocks,
    title_of,
)
from .scene import scene_blocks
from .two_directions import casimirs, frame_blocks, frame_definitions, parallel_blocks

# characters of a formula that does not go into a sentence
LONG = 70


def whole_blocks(scene: System, found: Sequence[Block]) -> list[Block]:
    """Write a scene, what its symbols are, what is found of it, and what the terms mean that it uses."""
    blocks = scene_blocks(scene)
    return [*blocks, symbol_rows(scene, occurring([*blocks, *found])), *found,
            *term_blocks([*blocks, *found])]


def conditions_blocks(report: Report) -> list[Block]:
    """Write the conditions of one equilibrium, without their derivation."""
    eq = report.equilibrium
    domains = [existence(d, eq.at) for d in eq.existence() if d.free_symbols]
    exists: list[Block] = [sentence("It exists if:"), *domains] if domains else []
    found: list[Block] = loaded("printing.decimals:with_decimals")([
            Heading(title_of(eq)), *tilt_blocks(eq), *family_blocks(eq), *exists,
            *criterion_blocks("Necessary", report.necessary, eq.at, "necessary"),
            *short_blocks(report), *criterion_blocks("Sufficient", report.sufficient, eq.at, "sufficient"),
            *integral_blocks(report),
            *boundary_blocks(report),
            *criterion_blocks("Under internal damping", report.damped, eq.at, "damped"),
            *definition_blocks(report), *frame_definitions(report), *implied_blocks(report)])
    return found


def report_blocks(report: Report) -> list[Block]:
    """Write one equilibrium: point, linearisation, polynomial, second variation, criteria."""
    eq = report.equilibrium
    blocks: list[Block] = [Heading(title_of(eq), label=eq.label), *point_blocks(eq),
                           *parallel_blocks(report)]
    if rests_in_frame(eq):
        blocks += [*frame_blocks(report), *(_second_variation(report) if eq.system.linear_integrals else ())]
    elif report.closed is not None:
        blocks += [Heading("Second variation and characteristic polynomial", 2), *definition_blocks(report)]
    else:
        blocks += [*_linearization(report), *_second_variation(report)]
    modulo = ""
    if report.sufficient.modulo:
        modulo = " Modulo the flow of an integral this is the theorem of Ortega & Ratiu 1999."
    blocks += [Heading("Conditions", 2), sentence(
        "Necessary: if a spectral condition fails, an eigenvalue has a positive real part, and the "
        "equilibrium is unstable (Lyapunov 1892). Sufficient: if the second variation is definite, the "
        f"equilibrium is Lyapunov stable (Holm, Marsden, Ratiu & Weinstein 1985).{modulo}")]
    blocks += [*criterion_blocks("Necessary (spectral)", report.necessary, eq.at, "necessary"),
               *short_blocks(report),
               *criterion_blocks("Sufficient (formal, hence Lyapunov)", report.sufficient, eq.at,
                                 "sufficient"), *integral_blocks(report)]
    if report.casimirs_only != report.sufficient:
        blocks += criterion_blocks("What the Casimirs alone would prove", report.casimirs_only, eq.at,
                                   "casimirs-alone")
    blocks += boundary_blocks(report)
    if report.boundary is not None and not report.boundary.pole:
        blocks += loaded("printing.results.drift:drift_blocks")(report)
    blocks += criterion_blocks("Under internal damping (secular)", report.damped, eq.at, "damped")
    return [*blocks, sentence(
        "Internal damping takes energy and keeps the Casimirs, as sloshing fuel or a nutation damper does; "
        "friction at a support is not of this kind. If the condition holds, the equilibrium is stable with "
        "damping and without. If it fails, the equilibrium is unstable with damping, except perhaps at "
        "equality, or if the damping does not reach every motion (Bloch, Krishnaprasad, Marsden & Ratiu "
        "1994)."), *implied_blocks(report)]


def point_blocks(eq: Equilibrium) -> list[Block]:
    """Write the point, what holds on its family, and when the family exists."""
    coordinates = eq.system.space.coordinates
    point, roots = _named_roots(eq, ImmutableMatrix([eq.point]))
    place: tuple[Any, ...] = ("(", *listed(coordinates), ") = (", *listed(point), ")")
    if eq.label in FAMILIES:
        place = (*place, f" ({FAMILIES[eq.label].source})")
    if roots:
        place = (*place, ", where ", *equations(roots))
    blocks: list[Block] = [sentence(*place, at=eq.at)]
    potential = eq.system.potential
    if potential and potential.given and potential.axial:
        jets = (symbol("dU"), symbol("d2U")) if eq.domain else (symbol("dU"),)
        values = [readable(potential.value(d).subs(symbol("k3"), eq.at)) for d in jets]
        names = [slope(eq, d) for d in jets]
        blocks.append(sentence("For this potential ", *equations(zip(names, values)), ".", at=eq.at))
    blocks += tilt_blocks(eq) or relation_blocks(eq)
    blocks += family_blocks(eq)
    if open_ones := [d for d in eq.existence() if d.free_symbols]:
        blocks.append(sentence("It exists if:"))
        blocks += [replace(existence(d, eq.at), label="exists") for d in open_ones]
    if (tilt := solved_tilt(eq)) is not None:
        blocks += [sentence("Solved for the tilt this is:"), Display(symbol("k3"), readable(tilt)),
                   sentence("The tilt exists if:"), existence(1 - tilt**2, eq.at)]
    return blocks


def solved_tilt(eq: Equilibrium) -> Expr | None:
    """Solve the relation of a tilted family for k3, if it is affine in k3 and expresses another name.
    """
    potential, slope = eq.system.potential, symbol("dU")
    slopes = [value for name, value in eq.relations if name == slope]
    if not slopes or not potential or not potential.given or "k3" in eq.eliminated:
        return None
    solved = affine(slopes[0] - potential.value(slope), symbol("k3"))
    return solved and solved[0]


def _named_roots(eq: Equilibrium,
                 matrix: ImmutableMatrix) -> tuple[ImmutableMatrix, list[tuple[Symbol, Expr]]]:
    """Replace roots among the coordinates of the point by the names of the coordinates."""
    roots = {value: x for x, value in zip(eq.system.space.coordinates, eq.point) if isinstance(value, Pow)
             and value.exp == S.Half}
    return matrix.xreplace(roots), [(x, value) for value, x in roots.items()]


def _linearization(report: Report) -> list[Block]:
    eq, linear, letters = report.equilibrium, report.linearization, letters_of(report.equilibrium.system)
    matrix, _ = _named_roots(eq, entries(eq.insert_field(linear.matrix)))
    basis, _ = _named_roots(eq, linear.basis.T)
    blocks: list[Block] = [Heading("Linearisation on the tangent space of the coadjoint orbit", 2),
                           sentence("The basis has one vector in each row:"),
                           Display(letter(letters, "T"), basis, eq.at, label="tangent"),
                           sentence("In this basis the linearised field is (Vera & Viguera 2003, §4.1.1 "
                                    "and §5):"),
                           Display(letter(letters, "J"), matrix, eq.at, label="linearised")]
    values = tuple(map(eq.insert_field, linear.coefficients))
    if len(values) == 1:
        q = symbol(letters.of("q"))
        polynomial = word(letters, "⟨lamda⟩² + ⟨q⟩", r"⟨lamda⟩^2 + ⟨q⟩")
        return [*blocks, sentence("The characteristic polynomial is ", polynomial, " with"),
                Display(q, readable(values[0]), eq.at, label="q"), *_eigenvalues(linear, eq.at)]
    (p, q), (a, b) = values, (symbol(letters.of("p")), symbol(letters.of("q")))
    return [*blocks, sentence("The characteristic polynomial is ", polynomial_of(letters), " with"),
            Display(a, readable(p), eq.at, label="p"), Display(b, readable(q), eq.at, label="q"),
            Display(a**2 - 4 * b, readable(p**2 - 4 * q), eq.at, label="discriminant"),
            *_eigenvalues(linear, eq.at)]


def _eigenvalues(linear: Linearization, at: Any) -> list[Block]:
    letters = letters_of(linear.equilibrium.system)
    parts = linear.frequencies()
    if parts is None:
        return []
    imaginary = word(letters, "±⟨i⟩", r"\pm ⟨i⟩")
    outer, inner = (_readable_roots(linear.equilibrium.insert_field(part)) for part in parts)
    if inner == 0:
        return [sentence("The eigenvalues are ", imaginary, " ", outer, ".", at=at)]
    if inner == outer and len(str(2 * outer)) > LONG:      # p stands above
        root = word(letters, "√⟨p⟩", r"\sqrt{⟨p⟩}")
        return [sentence("The eigenvalues are 0, 0 and ", imaginary, " ", root, ".", at=at)]
    if inner == outer:
        return [sentence("The eigenvalues are 0, 0 and ", imaginary, " ", 2 * outer, ".", at=at)]
    return [sentence("The eigenvalues are ", imaginary, " (", outer, " ", Word("±", r"\pm"), " ", inner, ").",
                     at=at)]


def _readable_roots(expression: Expr) -> Expr:
    """Write radicands in a form that reads well; without roots split over the denominators."""
    roots = [x for x in expression.atoms(Pow) if x.exp == S.Half]
    if not roots:
        return split(expression)
    return expression.xreplace({x: Pow(readable(x.base), x.exp) for x in roots})


def _second_variation(report: Report) -> list[Block]:
    eq, variation = report.equilibrium, report.second_variation
    letters = letters_of(eq.system)
    matrix, _ = _named_roots(eq, ImmutableMatrix(eq.insert_field(variation.matrix).applyfunc(readable)))
    basis, _ = _named_roots(eq, variation.basis.T)
    blocks: list[Block] = [Heading("Second variation on the symplectic slice", 2)]
    functions: list[Any] = [name for name, _ in zip(casimirs(letters), eq.system.space.casimirs)]
    functions += [function for function, _ in variation.multipliers[len(functions):]]
    values = [split(eq.insert_field(nu)) for _, nu in variation.multipliers]
    each = [(nu, " for ", function) for function, nu in zip(functions, values)]
    many, groups = ("The multiplier is ", [[one] for one in each]) if eq.system.coupled else (
        "The multipliers are ", [each])
    blocks += [sentence(many, *joined(", ", group), ".", at=eq.at) for group in groups]
    if variation.free:
        blocks.append(sentence("The first variation leaves ", variation.free[0], " free."))
    if variation.modulo:
        blocks.append(sentence(variation.modulo[0], " keeps its value, and its flow, the spin about the axis "
                               "of the body, is divided out."))
    if not matrix.rows:
        return [*blocks, sentence("The slice is a point.")]
    if variation.basis != report.linearization.basis:
        blocks += [sentence("The basis has one vector in each row:"),
                   Display(letter(letters, "S"), basis, eq.at, label="slice")]
    blocks.append(Display(letter(letters, "H"), matrix, eq.at, label="second-variation"))
    blocks += [Display(letter(letters, f"Delta{n}"), readable(eq.insert_field(minor)), eq.at,
                       label=f"minor{n}")
               for n, minor in enumerate(variation.minors, 1)]
    return blocks
