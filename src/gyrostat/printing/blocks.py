"""Headings, sentences and displayed formulas, before any typesetting."""
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
    """Texts, which are prose, and formulas, in the order in which they are read."""

    parts: tuple[Any, ...]
    at: Any = None


@dataclass(frozen=True)
class Display:
    """name = value: an expression, a matrix, or the two sides of a comparison."""

    name: Any
    value: Any
    at: Any = None
    relation: str = "="
    label: str = ""


@dataclass(frozen=True)
class Rows:
    """What symbols are: on the left formulas and texts of each, on the right its meaning."""

    rows: tuple[tuple[tuple[Any, ...], tuple[Any, ...]], ...]
    title: str = "Symbols and assumptions"
    label: str = "symbols"


Block = Heading | Sentence | Display | Rows


def rate_of(name: str) -> Word:
    """The rate of a component, π̇₁ of pi1."""
    letter = "π" if name[:-1] == "pi" else name[:-1]
    return Word(f"{letter}̇{'₀₁₂₃'[int(name[-1])]}", f"⟨{name}_dot⟩")


def sentence(*parts: Any, at: Any = None) -> Sentence:
    """A sentence of texts and formulas; texts that follow one another are one."""
    found: list[Any] = []
    for part in parts:
        if isinstance(part, str) and found and isinstance(found[-1], str):
            found[-1] += part
        else:
            found.append(part)
    return Sentence(tuple(found), at)


def prose(text: str) -> Sentence:
    """A text as it is, as a sentence."""
    return sentence(text if text.endswith((".", "…")) else f"{text}.")


def joined(between: str, clauses: Iterable[Sequence[Any]]) -> tuple[Any, ...]:
    """Clauses, each of texts and formulas, with a text between them."""
    found: list[Any] = []
    for n, clause in enumerate(clauses):
        if n > 0:
            found.append(between)
        found += clause
    return tuple(found)


def listed(formulas: Iterable[Any]) -> tuple[Any, ...]:
    """Formulas with commas between them."""
    return joined(", ", [(formula,) for formula in formulas])


def equations(pairs: Iterable[tuple[Any, Any]]) -> tuple[Any, ...]:
    """name = value, with commas between them."""
    return joined(", ", [(name, " = ", value) for name, value in pairs])


def modulo_flow(integrals: Iterable[Any]) -> tuple[Any, ...]:
    """Of which integrals the flow is divided out; nothing where of none."""
    found = listed(integrals)
    return ("modulo the flow of ", *found) if found else ()
