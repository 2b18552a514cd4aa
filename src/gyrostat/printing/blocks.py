"""Holds headings, sentences and displayed formulas before they are typeset."""
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Word:
    r"""A name in both typesettings, such as π̇₁ and ⟨pi1_dot⟩, in LaTeX the names of symbols in ⟨ ⟩."""

    text: str
    latex: str


@dataclass(frozen=True)
class Number:
    """What a number is written as, its exact form and its decimal for example, one after the other."""

    parts: tuple[Any, ...]


@dataclass(frozen=True)
class Heading:
    """The title of a part."""

    title: str
    level: int = 1
    label: str = ""


@dataclass(frozen=True)
class Sentence:
    """A sentence: texts, which are prose, and formulas, in the order in which they are read."""

    parts: tuple[Any, ...]
    at: Any = None


@dataclass(frozen=True)
class Display:
    """A displayed formula, name = value: an expression, a matrix, or the two sides of a comparison."""

    name: Any
    value: Any
    at: Any = None
    relation: str = "="
    label: str = ""


@dataclass(frozen=True)
class Rows:
    """A list of meanings: on the left a symbol or a term, on the right what it is."""

    rows: tuple[tuple[tuple[Any, ...], tuple[Any, ...]], ...]
    title: str = "Symbols and assumptions"
    label: str = "symbols"


Block = Heading | Sentence | Display | Rows


def rate_of(name: str) -> Word:
    """Write the rate of a component, π̇₁ for pi1."""
    letter = "π" if name[:-1] == "pi" else name[:-1]
    return Word(f"{letter}̇{'₀₁₂₃'[int(name[-1])]}", f"⟨{name}_dot⟩")


def sentence(*parts: Any, at: Any = None) -> Sentence:
    """Make a sentence of texts and formulas; neighbouring texts are joined."""
    found: list[Any] = []
    for part in parts:
        if isinstance(part, str) and found and isinstance(found[-1], str):
            found[-1] += part
        else:
            found.append(part)
    return Sentence(tuple(found), at)


def prose(text: str) -> Sentence:
    """Make a sentence of a text, with a full stop if it has none."""
    return sentence(text if text.endswith((".", "…")) else f"{text}.")


def joined(between: str, clauses: Iterable[Sequence[Any]]) -> tuple[Any, ...]:
    """Join clauses, each of texts and formulas, by a text between them."""
    found: list[Any] = []
    for n, clause in enumerate(clauses):
        if n > 0:
            found.append(between)
        found += clause
    return tuple(found)


def listed(formulas: Iterable[Any]) -> tuple[Any, ...]:
    """List formulas with commas between them."""
    return joined(", ", [(formula,) for formula in formulas])


def equations(pairs: Iterable[tuple[Any, Any]]) -> tuple[Any, ...]:
    """List equations, name = value, with commas between them."""
    return joined(", ", [(name, " = ", value) for name, value in pairs])


def modulo_flow(integrals: Iterable[Any]) -> tuple[Any, ...]:
    """Say of which integrals the flow is divided out; nothing if there are none."""
    found = listed(integrals)
    return ("modulo the flow of ", *found) if found else ()
