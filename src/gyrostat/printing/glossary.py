"""Finds the terms of the glossary that a document uses, and says in one line each what they mean."""
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from .blocks import Block, Display, Heading, Rows, Sentence, Word, sentence

WHERE = "docs/reference/glossary.md"


@dataclass(frozen=True)
class Term:
    """A term: its meaning in two sentences, its formula and its source, as glossary.toml has them."""

    name: str
    meaning: str
    more: str
    formula: str
    source: str
    seen: str = ""

    def used(self, text: str) -> bool:
        """Whether a text uses the term."""
        return bool(self.seen and re.search(rf"(?<!\w)(?:{self.seen})(?!\w)", text, re.IGNORECASE))


@cache
def glossary() -> Mapping[str, tuple[Term, ...]]:
    """The terms of stability, and those of the motion.

    Examples
    --------
    >>> glossary()["stability"][0].meaning
    'Motions that start near the equilibrium stay near it for all time.'
    """
    text = files(__package__).joinpath("glossary.toml").read_text(encoding="utf-8")
    return {part: tuple(Term(**entry) for entry in entries) for part, entries in tomllib.loads(text).items()}


def term_blocks(blocks: Iterable[Block]) -> list[Block]:
    """The terms that blocks use, in one line each, and where the glossary is."""
    text = "\n".join(_texts(blocks))
    rows = tuple(((term.name,), (term.meaning,)) for terms in glossary().values() for term in terms
                 if term.used(text))
    if not rows:
        return []
    return [Rows(rows, "Terms", "terms"), sentence(f"The glossary has formulas and sources: {WHERE}.")]


def _texts(parts: Iterable[Any]) -> Iterator[str]:
    """The words in blocks: of titles, sentences and names."""
    for part in parts:
        if isinstance(part, str):
            yield part
        elif isinstance(part, Word):
            yield part.text
        elif isinstance(part, Heading):
            yield part.title
        elif isinstance(part, Sentence):
            yield "".join(_texts(part.parts))
        elif isinstance(part, Display):
            yield from _texts((part.name,))
