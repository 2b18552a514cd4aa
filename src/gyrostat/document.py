"""A report as a sequence of headings, sentences and displayed formulas, before any typesetting."""
from dataclasses import dataclass
from typing import Any

from sympy import Expr, ImmutableMatrix, Pow, S, Symbol

from .conditions import Condition, Criterion
from .equilibria import Equilibrium
from .linearization import rational_root, square_root
from .notation import jet, symbol
from .presentation import entries, inequality, readable, split
from .stability import Decision, Report
from .system import System


@dataclass(frozen=True)
class Word:
    """A name in both typesettings, such as π̇₁ and \\dot\\pi_1."""

    text: str
    latex: str


@dataclass(frozen=True)
class Heading:
    """The title of a part."""

    title: str
    level: int = 1


@dataclass(frozen=True)
class Sentence:
    """Prose with {} where formulas stand."""

    template: str
    parts: tuple[Any, ...] = ()
    at: Any = None


@dataclass(frozen=True)
class Display:
    """name = value: an expression, a matrix, or the two sides of a comparison."""

    name: Any
    value: Any
    at: Any = None
    relation: str = "="


Block = Heading | Sentence | Display
DOT = {f"{x}{i}": Word(f"{g}̇{'₀₁₂₃'[i]}", rf"\dot{{{t}}}_{i}") for x, g, t in (("pi", "π", r"\pi"), ("k", "k", "k")) for i in (1, 2, 3)}
_ABOUT = {"E1": "spinning about the upward vertical", "E2": "spinning about the downward vertical",
          "E3": "precessing about the vertical, inclined", "E3 at rest": "tilted, without rotation"}


def scene_blocks(scene: System) -> list[Block]:
    """Body, field, bracket, equations of motion and integrals."""
    body, space, potential = scene.body, scene.space, scene.potential
    field = "e(3)*" if potential else "so(3)*"
    blocks: list[Block] = [Heading("Scene"), Sentence(
        "Principal moments ({}, {}, {}), gyrostatic momentum l = ({}, {}, {}), M = {} + l" + (", potential U = {}." if potential else ", no field."),
        (*body.inertia, *body.gyrostatic_momentum, Word("π", r"\pi"), *([potential.expression] if potential else [])))]
    blocks += [Sentence(f"Poisson tensor on {field}, " + "{{F, G}} = ∇F·B∇G; the Jacobi identity holds for all coordinates."),
               Display(Word("B", "B"), space.tensor)]
    names = (Word("C₁", "C_1"), Word("C₂", "C_2")) if potential else (Word("C", "C"),)
    blocks += [Sentence("Casimirs and Hamiltonian:"), *(Display(n, c) for n, c in zip(names, space.casimirs)),
               Display(Word("h", "h"), scene.hamiltonian)]
    vector = Word("π̇ = M × ω + k × ∇U,  k̇ = k × ω", r"\dot\pi = M\times\omega + k\times\nabla U,\quad \dot k = k\times\omega") if potential \
        else Word("π̇ = M × ω", r"\dot\pi = M\times\omega")
    blocks += [Sentence("Equations of motion, {}:", (vector,)),
               *(Display(DOT[str(x)], rate) for x, rate in zip(space.coordinates, scene.vector_field()))]
    if scene.integrals:
        blocks.append(Sentence("Integral found, {{F, h}} = 0: F = " + ", ".join(["{}"] * len(scene.integrals)) + ".", scene.integrals))
    return blocks


def report_blocks(report: Report) -> list[Block]:
    """One equilibrium: point, linearisation, polynomial, second variation, criteria."""
    eq = report.equilibrium
    blocks: list[Block] = [Heading(f"{eq.label}: {_ABOUT[eq.label]}" if eq.label in _ABOUT else eq.label), *_point(eq)]
    blocks += _linearization(report)
    blocks += _second_variation(report)
    blocks += [Heading("Conditions", 2), *criterion_blocks("Necessary (spectral)", report.necessary, eq.at),
               *criterion_blocks("Sufficient (formal, hence Lyapunov)", report.sufficient, eq.at)]
    if report.casimirs_only != report.sufficient:
        blocks += criterion_blocks("What the Casimirs alone would prove", report.casimirs_only, eq.at)
    return [*blocks, Sentence("Between the two, on the boundary, nothing is claimed.")]


def _point(eq: Equilibrium) -> list[Block]:
    coordinates = eq.system.space.coordinates
    shown, roots = _named_roots(eq, ImmutableMatrix([eq.point]))
    template = "({}) = ({})".format(", ".join(["{}"] * len(coordinates)), ", ".join(["{}"] * len(coordinates)))
    blocks: list[Block] = [Sentence(template + (", where " + ", ".join("{} = {}" for _ in roots) if roots else ""),
                                    (*coordinates, *shown, *(part for pair in roots for part in pair)), eq.at)]
    if eq.relations:
        blocks.append(Sentence("On the family:"))
        blocks += [Display(name, value if jet(name.name) else readable(value), eq.at) for name, value in eq.relations]
    if eq.domain:
        blocks.append(Sentence("It exists where:"))
        blocks += [Display(*_existence(d), eq.at, relation) for d, relation in zip(eq.existence(), map(_kind, eq.domain))]
    return blocks


def _kind(domain: Expr) -> str:
    return "≠" if isinstance(domain, Pow) and domain.exp == 2 else "<"


def _existence(domain: Expr) -> tuple[Any, Any]:
    """|x| < 1 for 1 − x² > 0, x ≠ 0 for x² > 0."""
    if isinstance(domain, Pow) and domain.exp == 2:
        return readable(domain.base), S.Zero
    root = square_root(1 - domain)
    return abs(readable(root)), S.One


def _named_roots(eq: Equilibrium, matrix: ImmutableMatrix) -> tuple[ImmutableMatrix, list[tuple[Symbol, Expr]]]:
    """Roots among the coordinates of the point are shown under the coordinate's name."""
    roots = {value: x for x, value in zip(eq.system.space.coordinates, eq.point) if isinstance(value, Pow) and value.exp == S.Half}
    return matrix.xreplace(roots), [(x, value) for value, x in roots.items()]


def _linearization(report: Report) -> list[Block]:
    eq, linear = report.equilibrium, report.linearization
    matrix, _ = _named_roots(eq, entries(linear.matrix))
    basis, _ = _named_roots(eq, linear.basis.T)
    blocks: list[Block] = [Heading("Linearisation on the tangent space of the coadjoint orbit", 2),
                           Sentence("Basis, one vector in each row:"), Display(Word("T", "T"), basis, eq.at),
                           Sentence("The linearised field in that basis:"), Display(Word("J", "J"), matrix, eq.at)]
    values = linear.coefficients
    if len(values) == 1:
        q = symbol("q")
        return [*blocks, Sentence("Characteristic polynomial {} with", (Word("λ² + q", r"\lambda^2 + q"),)), Display(q, readable(values[0]), eq.at),
                Sentence("Eigenvalues λ = ±i {}.", (_root(values[0]),), eq.at)]
    (p, q), (a, b) = values, (symbol("p"), symbol("q"))
    return [*blocks, Sentence("Characteristic polynomial {} with", (Word("λ⁴ + p λ² + q", r"\lambda^4 + p\,\lambda^2 + q"),)),
            Display(a, readable(p), eq.at), Display(b, readable(q), eq.at), Display(a**2 - 4 * b, readable(p**2 - 4 * q), eq.at),
            *_eigenvalues(p, q, eq)]


def _eigenvalues(p: Expr, q: Expr, eq: Equilibrium) -> list[Block]:
    if q == 0:
        return [Sentence("Eigenvalues λ = 0, 0, ±i {}.", (_root(p),), eq.at)]
    r = rational_root(q)
    if r is None:
        return []
    return [Sentence("Eigenvalues λ = ±i ({} ± {}).", (split(square_root(p + 2 * r) / 2), _root(p - 2 * r) / 2), eq.at)]


def _root(expression: Expr) -> Expr:
    """√ of an expression, what is under the root as it reads best."""
    root = square_root(expression)
    return root.xreplace({x: Pow(readable(x.base), x.exp) for x in root.atoms(Pow) if x.exp == S.Half})


def _second_variation(report: Report) -> list[Block]:
    eq, variation = report.equilibrium, report.second_variation
    matrix, _ = _named_roots(eq, ImmutableMatrix(variation.matrix.applyfunc(readable)))
    basis, _ = _named_roots(eq, variation.basis.T)
    blocks: list[Block] = [Heading("Second variation on the symplectic slice", 2)]
    functions = [name for name, _ in zip((Word("C₁", "C_1"), Word("C₂", "C_2")), eq.system.space.casimirs)]
    functions += [function for function, _ in variation.multipliers[len(functions):]]
    blocks.append(Sentence("Multipliers of " + ", ".join("{}: {}" for _ in functions) + ".", tuple(
        part for function, (_, nu) in zip(functions, variation.multipliers) for part in (function, split(nu))), eq.at))
    if variation.free:
        blocks.append(Sentence("The first variation leaves {} free.", variation.free[:1]))
    if variation.modulo:
        blocks.append(Sentence("{} is held fixed, and its flow, the spin about the axis of the body, is divided out.", variation.modulo))
    if not matrix.rows:
        return [*blocks, Sentence("The slice is a point.")]
    if variation.basis != report.linearization.basis:
        blocks += [Sentence("Basis, one vector in each row:"), Display(Word("S", "S"), basis, eq.at)]
    blocks.append(Display(Word("H", "H"), matrix, eq.at))
    blocks += [Display(Word(f"Δ{'₀₁₂₃₄'[n]}", rf"\Delta_{n}"), readable(minor), eq.at) for n, minor in enumerate(variation.minors, 1)]
    return blocks


def criterion_blocks(title: str, criterion: Criterion, at: Any) -> list[Block]:
    """Each alternative as its comparisons."""
    modulo = (", modulo the flow of " + ", ".join(["{}"] * len(criterion.modulo))) if criterion.modulo else ""
    if criterion.alternatives == ():
        return [Sentence(f"{title}: no information, the form is not definite.")]
    if () in criterion.alternatives:
        return [Sentence(f"{title}{modulo}: always.", criterion.modulo)]
    blocks: list[Block] = []
    for n, alternative in enumerate(criterion.alternatives):
        blocks.append(Sentence(f"{title}{modulo}:" if n == 0 else "or", criterion.modulo if n == 0 else ()))
        blocks += [comparison(condition) for condition in alternative]
        blocks += [Sentence("(also where {} = 0)" if not c.strict else "and {} ≠ 0", (readable(e),), at)
                   for c in alternative for e in c.degenerate]
    return blocks


def comparison(condition: Condition) -> Display:
    """The condition as left > right; a negative product alone as product < 0."""
    left, right = inequality(condition)
    if left == 0:
        return Display(right, left, condition.at, "<" if condition.strict else "≤")
    return Display(left, right, condition.at, ">" if condition.strict else "≥")


def decision_blocks(decision: Decision, at: Any) -> list[Block]:
    """The verdict at the numbers given."""
    title = {"Lyapunov": "Lyapunov stable", "spectral": "unstable", "": "undecided"}[decision.notion]
    modulo = " modulo the spin about the axis" if decision.modulo and decision.notion == "Lyapunov" else ""
    values = [Display(readable(margin), value if value.is_Rational else value.evalf(12), at) for margin, value in decision.margins
              if margin.free_symbols]
    notes: list[Block] = [Sentence(f"Note: {decision.note}.")] if decision.note else []
    return [Sentence(f"Verdict: {title}{modulo}; {decision.verdict.value}."), *values, *notes]
