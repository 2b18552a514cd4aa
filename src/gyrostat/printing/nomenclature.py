"""Lists the symbols that occur in a document, with what they mean and what is assumed of them."""
from collections.abc import Iterable
from typing import Any

from sympy import Add, Basic, Expr, MatrixBase, Pow, Symbol
from sympy.core.function import AppliedUndef

from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.potential import Potential
from ..mechanics.scenes.system import System
from ..notation import NOTATION, dimension_of, jet, order, symbol
from ..typesetting import placed
from .blocks import Display, Rows, Sentence, Word, listed
from .letters import letter, letters_of

Row = tuple[tuple[Any, ...], tuple[Any, ...]]
NONE, ENERGY = (0, 0, 0), (1, 2, 0)                    # powers of [M L²], 1/[T] and [L]
_IN_COUPLED = {"m0", "omega0", "p0", "mass1", "mass2", "mass3"}
K3 = symbol("k3")


def occurring(parts: Iterable[Any]) -> set[str]:
    """Find the names in blocks, formulas and words; U is among them if one of its derivatives is."""
    found: set[str] = set()
    for part in parts:
        if isinstance(part, Sentence):
            found |= occurring(part.parts)
        elif isinstance(part, Display):
            found |= occurring((part.name, part.value))
        elif isinstance(part, Word):
            found |= placed(part.latex)
        elif isinstance(part, Basic | MatrixBase):
            found |= {s.name.removesuffix("_dot") for s in part.free_symbols if isinstance(s, Symbol)}
            found |= {"U"} if part.atoms(AppliedUndef) else set()
    return found | ({"U"} if any(map(jet, found)) else set())


def symbol_rows(scene: System, names: Iterable[str]) -> Rows:
    """Say what U and each of the names is, and the symbols in U."""
    here, body, potential = set(names), scene.body, scene.potential
    if potential:
        here |= occurring([potential.expression])
    rows = [row for row in _body(body) if row[0][0].name in here]
    for group in ("pi1 pi2 pi3", "k1 k2 k3"):
        if shown := [name for name in group.split() if name in here]:
            meaning = NOTATION[shown[0]].meaning.split(", axis")[0]
            axes = _axes([int(name[-1]) for name in shown])
            rows.append((listed(map(symbol, shown)), (f"{meaning}, {axes}",)))
    rows += [((symbol(f"pi{i}_0"),), (f"angular momentum of the locked body, axis {i}, at the equilibrium",))
             for i in (1, 2, 3) if f"pi{i}_0" in here]
    rows += [((symbol(name),), (NOTATION[name].meaning.split(":")[0],))
             for name in ("omega1_0", "omega2_0", "omega3_0", "omega") if name in here]
    if potential:
        rows.append(_potential(potential, letter(letters_of(scene), "U")))
    given = {row[0][0].name for row in rows if isinstance(row[0][0], Symbol)}
    return Rows((*rows, *_parameters(scene, here - given)))


def _body(body: Gyrostat) -> list[Row]:
    """The moments and the rotor of a body, as far as they are symbols."""
    rows: list[Row] = []
    moments = () if isinstance(body.inertia, MatrixBase) else body.moments
    for entries, what in ((moments, "principal moment of inertia"),
                          (body.gyrostatic_momentum, "gyrostatic momentum")):
        for entry in dict.fromkeys(entries):
            if isinstance(entry, Symbol):
                axes = [n for n, other in enumerate(entries, 1) if other == entry]
                positive = (" > 0",) if entry.is_positive else ()
                rows.append(((entry, *positive), (f"{what}, {_axes(axes)}",)))
    return rows


def _axes(axes: list[int]) -> str:
    """Name axes in words: axis 3; axes 1 and 2; axes 1, 2 and 3."""
    *others, last = map(str, axes)
    return f"axes {', '.join(others)} and {last}" if others else f"axis {last}"


def _potential(potential: Potential, U: Word) -> Row:
    if potential.given:
        return (U,), ("potential, ", U, " = ", potential.expression)
    derivatives = Word("∂₁U, ∂₂U", r"\partial_1 ⟨U⟩, \partial_2 ⟨U⟩")
    if potential.axial:
        derivatives = Word("U′, U″", "⟨U⟩', ⟨U⟩''")
    return (potential.expression,), ("potential, any smooth function; ", derivatives,
                                     " and so on are its derivatives")


def _parameters(scene: System, names: set[str]) -> list[Row]:
    """The parameters of U: those of a named field each with its meaning, the user's together."""
    potential = scene.potential
    shown = sorted((s for s in (potential.parameters if potential else ()) if s.name in names),
                   key=lambda s: order(s.name))
    known = [s for s in shown if potential and _as_in_the_table(potential, s)]
    rows: list[Row] = [((s, " > 0") if s.is_positive else (s,), _meaning(s.name)) for s in known]
    others = [s for s in shown if s not in known]
    if others:
        what = "real parameter" if not all(s.is_positive for s in others) else "positive number"
        rows.append((listed(others), (f"{what}s" if others[1:] else f"a {what}",)))
    return rows


def _as_in_the_table(potential: Potential, s: Symbol) -> bool:
    """Whether a name means in U what the table says: then each term with it is an energy."""
    if s.name not in NOTATION or potential.coupled:
        return s.name in _IN_COUPLED
    terms = [term for term in Add.make_args(potential.expression) if s in term.free_symbols]
    gradient = (0, 2, 0)                               # m1 k3² beside moments that are numbers
    return all((found := _dimension(term)) == ENERGY or found == gradient and term.has(K3**2)
               for term in terms)


def _dimension(e: Expr) -> tuple[Any, ...] | None:
    """The dimension as powers of [M L²], 1/[T] and [L]; None if a name is not in the table."""
    if isinstance(e, Symbol):
        return dimension_of(e.name)
    parts = [_dimension(x) for x in e.args]
    if e.is_number or parts and set(parts) == {NONE}:
        return NONE
    if e.is_Add and len(set(parts)) == 1:
        return parts[0]
    if isinstance(e, Pow) and e.exp.is_number and parts[0] is not None:
        return tuple(x * e.exp for x in parts[0])
    known = [part for part in parts if part is not None]
    if e.is_Mul and len(known) == len(parts):
        return tuple(map(sum, zip(*known)))
    return None


def _meaning(name: str) -> tuple[Any, ...]:
    """The meaning of a parameter of the table."""
    if name[0] == "J":
        n = name[1:]
        return Word(f"∫ |x|^{n} P{n}(x₃/|x|) dm", rf"\int |x|^{n} P_{n}(x_3/|x|)\,dm"), " over the body"
    return (NOTATION[name].meaning.split(":")[0],)
