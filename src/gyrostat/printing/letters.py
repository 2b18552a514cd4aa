"""Chooses the letters of a document: those of the table of names, or others if the scene has them."""
from collections.abc import Iterable
from functools import lru_cache

from sympy import Expr

from ..mechanics.scenes.system import System, names_of_scene
from ..registry import Letters
from .blocks import Word


def letters_of(scene: System) -> Letters:
    """The letters of a document about a scene."""
    return _letters(frozenset(s.name for s in names_of_scene(scene)),
                    scene.potential.directions if scene.potential else ())


def letters_in(expressions: Iterable[Expr]) -> Letters:
    """The letters of a document about formulas alone, for which there is no scene."""
    return _letters(frozenset(s.name for e in expressions for s in e.free_symbols), ("k",))


@lru_cache(maxsize=256)                                # a document asks often for those of one scene
def _letters(names: frozenset[str], directions: tuple[str, ...]) -> Letters:
    return Letters(sorted(names), directions)


def word(letters: Letters, text: str, latex: str) -> Word:
    """A word whose letters stand in ⟨ ⟩ in both templates.

    Examples
    --------
    >>> word(Letters(["h"]), "⟨h⟩ = ⟨h⟩₀", "⟨h⟩ = ⟨h⟩_0")
    Word(text='E = E₀', latex='⟨E⟩ = ⟨E⟩_0')
    """
    return Word(letters.text(text), letters.latex(latex))


def letter(letters: Letters, name: str) -> Word:
    """One letter as a word."""
    return word(letters, f"⟨{name}⟩", f"⟨{name}⟩")
