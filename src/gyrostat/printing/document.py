"""A report as a sequence of headings, sentences and displayed formulas, before any typesetting."""
from typing import Any

from sympy import Expr, ImmutableMatrix, Pow, S, Symbol

from ..algebra.readable import entries, readable, split
from ..mechanics.equilibria import Equilibrium
from ..mechanics.families import FAMILIES, solved_tilt
from ..mechanics.system import System
from ..notation import jet, symbol
from ..stability.linearization import Linearization
from ..stability.report import Report
from .blocks import (
    DOT,
    VECTOR_FORM,
    Block,
    Display,
    Heading,
    Sentence,
    Word,
    boundary_blocks,
    criterion_blocks,
    drift_blocks,
    existence,
)

IMAGINARY = Word("±i", r"\pm i")
# characters of a formula that does not go into a sentence
LONG = 80


def scene_blocks(scene: System) -> list[Block]:
    """Body, field, bracket, equations of motion and integrals."""
    body, space, potential = scene.body, scene.space, scene.potential
    momentum = Word("l", "l"), *body.gyrostatic_momentum, Word("M = π + l", r"M = \pi + l")
    blocks: list[Block] = [Heading("Scene"), Sentence(
        "Principal moments ({}, {}, {}), gyrostatic momentum {} = ({}, {}, {}), {}"
        + (", potential {}." if potential else ", no field."),
        (*body.inertia, *momentum, *([potential.expression] if potential else [])))]
    bracket = Word("{F, G} = ∇F·B∇G", r"\{F, G\} = \nabla F\cdot B\,\nabla G")
    blocks += [Sentence(f"Poisson tensor on {'e' if potential else 'so'}(3)*, {{}}; the Jacobi identity "
                        "holds (Marsden, Ratiu & "
                        "Weinstein 1984; with a rotor, Vera & Viguera 2003, §2).", (bracket,)),
               Display(Word("B", "B"), space.tensor)]
    names = (Word("C₁", "C_1"), Word("C₂", "C_2")) if potential else (Word("C", "C"),)
    blocks += [Sentence("Casimirs and Hamiltonian:"), *(Display(n, c) for n, c in zip(names, space.casimirs)),
               Display(Word("h", "h"), scene.hamiltonian)]
    vector = VECTOR_FORM[potential is not None]
    blocks += [Sentence("Equations of motion, {}:", (vector,)),
               *(Display(DOT[str(x)], rate) for x, rate in zip(space.coordinates, scene.vector_field()))]
    if scene.integrals:
        found = Word("{F, h} = 0", r"\{F, h\} = 0")
        blocks.append(Sentence("Integral found, {}: " + ", ".join(["{}"] * len(scene.integrals)) + ".",
                               (found, *scene.integrals)))
    return blocks


def report_blocks(report: Report) -> list[Block]:
    """One equilibrium: point, linearisation, polynomial, second variation, criteria."""
    eq = report.equilibrium
    family = FAMILIES.get(eq.label)
    title = f"{eq.label}: {family.title}" if family and family.title else eq.label[0].upper() + eq.label[1:]
    blocks: list[Block] = [Heading(title), *point_blocks(eq)]
    blocks += _linearization(report)
    blocks += _second_variation(report)
    blocks += [Heading("Conditions", 2), Sentence(
        "Necessary: where a spectral condition fails, an eigenvalue has a positive real part, and the "
        "equilibrium is unstable (Lyapunov "
        "1892). Sufficient: where the second variation is definite, the equilibrium is Lyapunov stable "
        "(Holm, Marsden, Ratiu & Weinstein "
        "1985)" + ("; modulo the flow of an integral, Ortega & Ratiu 1999." if report.sufficient.modulo
                   else "."))]
    blocks += [*criterion_blocks("Necessary (spectral)", report.necessary, eq.at),
               *criterion_blocks("Sufficient (formal, hence Lyapunov)", report.sufficient, eq.at)]
    if report.casimirs_only != report.sufficient:
        blocks += criterion_blocks("What the Casimirs alone would prove", report.casimirs_only, eq.at)
    blocks += [*boundary_blocks(report), *drift_blocks(report)]
    return blocks


def point_blocks(eq: Equilibrium) -> list[Block]:
    """The point, what holds on its family, and where the family exists."""
    coordinates = eq.system.space.coordinates
    point, roots = _named_roots(eq, ImmutableMatrix([eq.point]))
    template = "({}) = ({})".format(", ".join(["{}"] * len(coordinates)),
                                    ", ".join(["{}"] * len(coordinates)))
    known = f" ({FAMILIES[eq.label].source})" if eq.label in FAMILIES else ""
    blocks: list[Block] = [Sentence(template + known
                                    + (", where " + ", ".join("{} = {}" for _ in roots) if roots else ""),
                                    (*coordinates, *point, *(part for pair in roots for part in pair)),
                                    eq.at)]
    potential = eq.system.potential
    if potential and potential.given and potential.axial:
        jets = (symbol("dU"), symbol("d2U")) if eq.domain else (symbol("dU"),)
        blocks.append(Sentence("Of this potential: " + ", ".join("{} = {}" for _ in jets) + ".",
                               tuple(x for d in jets
                                     for x in (d, readable(potential.value(d).subs(symbol("k3"), eq.at)))),
                               eq.at))
    if eq.relations:
        blocks.append(Sentence("On the family:"))
        blocks += [Display(name, value if jet(name.name) else readable(value), eq.at)
                   for name, value in eq.relations]
    if open_ones := [d for d in eq.existence() if d.free_symbols]:
        blocks.append(Sentence("It exists where:"))
        blocks += [existence(d, eq.at) for d in open_ones]
    if (tilt := solved_tilt(eq)) is not None:
        blocks += [Sentence("Solved for the tilt:"), Display(symbol("k3"), readable(tilt)),
                   Sentence("which exists where:"), existence(1 - tilt**2, eq.at)]
    return blocks


def _named_roots(eq: Equilibrium,
                 matrix: ImmutableMatrix) -> tuple[ImmutableMatrix, list[tuple[Symbol, Expr]]]:
    """Roots among the coordinates of the point are shown under the coordinate's name."""
    roots = {value: x for x, value in zip(eq.system.space.coordinates, eq.point) if isinstance(value, Pow)
             and value.exp == S.Half}
    return matrix.xreplace(roots), [(x, value) for value, x in roots.items()]


def _linearization(report: Report) -> list[Block]:
    eq, linear = report.equilibrium, report.linearization
    matrix, _ = _named_roots(eq, entries(eq.insert_field(linear.matrix)))
    basis, _ = _named_roots(eq, linear.basis.T)
    blocks: list[Block] = [Heading("Linearisation on the tangent space of the coadjoint orbit", 2),
                           Sentence("Basis, one vector in each row:"), Display(Word("T", "T"), basis, eq.at),
                           Sentence("The linearised field in that basis (Vera & Viguera 2003, §4.1.1 and "
                                    "§5):"),
                           Display(Word("J", "J"), matrix, eq.at)]
    values = tuple(map(eq.insert_field, linear.coefficients))
    if len(values) == 1:
        q = symbol("q")
        return [*blocks, Sentence("Characteristic polynomial {} with", (Word("λ² + q", r"\lambda^2 + q"),)),
                Display(q, readable(values[0]), eq.at), *_eigenvalues(linear, eq.at)]
    (p, q), (a, b) = values, (symbol("p"), symbol("q"))
    return [*blocks, Sentence("Characteristic polynomial {} with",
                              (Word("λ⁴ + p λ² + q", r"\lambda^4 + p\,\lambda^2 + q"),)),
            Display(a, readable(p), eq.at), Display(b, readable(q), eq.at),
            Display(a**2 - 4 * b, readable(p**2 - 4 * q), eq.at),
            *_eigenvalues(linear, eq.at)]


def _eigenvalues(linear: Linearization, at: Any) -> list[Block]:
    parts = linear.frequencies()
    if parts is None:
        return []
    outer, inner = (_readable_roots(linear.equilibrium.insert_field(part)) for part in parts)
    if inner == 0:
        return [Sentence("Eigenvalues {} {}.", (IMAGINARY, outer), at)]
    potential = linear.equilibrium.system.potential
    # p stands above
    if inner == outer and potential and potential.given and len(str(2 * outer)) > LONG:
        return [Sentence("Eigenvalues 0, 0 and {} {}.", (IMAGINARY, Word("√p", r"\sqrt{p}")), at)]
    if inner == outer:
        return [Sentence("Eigenvalues 0, 0 and {} {}.", (IMAGINARY, 2 * outer), at)]
    return [Sentence("Eigenvalues {} ({} {} {}).", (IMAGINARY, outer, Word("±", r"\pm"), inner), at)]


def _readable_roots(expression: Expr) -> Expr:
    """What is under roots as it reads best, and an expression without roots as a sum over its denominators.
    """
    roots = [x for x in expression.atoms(Pow) if x.exp == S.Half]
    return (
        expression.xreplace({x: Pow(readable(x.base), x.exp) for x in roots}) if roots else split(expression)
    )


def _second_variation(report: Report) -> list[Block]:
    eq, variation = report.equilibrium, report.second_variation
    matrix, _ = _named_roots(eq, ImmutableMatrix(eq.insert_field(variation.matrix).applyfunc(readable)))
    basis, _ = _named_roots(eq, variation.basis.T)
    blocks: list[Block] = [Heading("Second variation on the symplectic slice", 2)]
    functions = [name for name, _ in zip((Word("C₁", "C_1"), Word("C₂", "C_2")), eq.system.space.casimirs)]
    functions += [function for function, _ in variation.multipliers[len(functions):]]
    blocks.append(Sentence("Multipliers of " + ", ".join("{}: {}" for _ in functions) + ".", tuple(
        part for function, (_, nu) in zip(functions, variation.multipliers)
        for part in (function, split(eq.insert_field(nu)))), eq.at))
    if variation.free:
        blocks.append(Sentence("The first variation leaves {} free.", variation.free[:1]))
    if variation.modulo:
        blocks.append(Sentence("{} is held fixed, and its flow, the spin about the axis of the body, is "
                               "divided out.", variation.modulo))
    if not matrix.rows:
        return [*blocks, Sentence("The slice is a point.")]
    if variation.basis != report.linearization.basis:
        blocks += [Sentence("Basis, one vector in each row:"), Display(Word("S", "S"), basis, eq.at)]
    blocks.append(Display(Word("H", "H"), matrix, eq.at))
    blocks += [Display(Word(f"Δ{'₀₁₂₃₄'[n]}", rf"\Delta_{n}"), readable(eq.insert_field(minor)), eq.at)
               for n, minor in enumerate(variation.minors, 1)]
    return blocks
