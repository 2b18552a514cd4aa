"""Describes relative equilibria, and the amended potential with its critical points."""
from typing import Any

from sympy import Add

from ...algebra.rings.readable import readable
from ...equilibria.curves.amended_potential import AmendedPotential, CriticalPoint
from ...equilibria.finders.rate_level_tilt import C1
from ...equilibria.relative_equilibrium import RelativeEquilibrium
from ...notation import symbol
from ...registry import Letters
from ..blocks import Block, Display, Word, joined, listed, sentence
from ..letters import letters_of, word
from ..numbers import in_sentence

VECTORS = {"k": Word("k", "⟨vector_k⟩"), "M": Word("M", "⟨vector_M⟩"), "n": Word("n", "n"),
           "r": Word("r", "r")}


def relative_equilibrium(found: RelativeEquilibrium) -> list[Block]:
    """Say where an equilibrium lies, for a satellite by its angles too, on which set, and its verdict."""
    turned = "" if found.attitude is None else f", {found.attitude}"
    return [sentence(f"{found.label} at ", *_place(found), turned, _ended(found))]


def critical_point(point: CriticalPoint) -> list[Block]:
    """Say which kind of critical point it is, the value there, and the rotation."""
    kind = "degenerate point" if point.kind == "degenerate" else point.kind
    amended = _amended(letters_of(point.rotation.scene))
    return [sentence(f"{kind} of ", amended, " = ", in_sentence(point.value), " at ", *_place(point.rotation),
                     _ended(point.rotation))]


def amended_potential(amended: AmendedPotential) -> list[Block]:
    """Write U_c = …, with each of its two parts in a form that reads well."""
    U = amended.scene.potential
    assert U is not None
    letters = letters_of(amended.scene)
    value = Add(readable(U.expression), readable(amended.expression - U.expression))
    return [Display(_amended(letters), value.xreplace({C1: symbol(letters.of(C1.name))}))]


def _amended(letters: Letters) -> Word:
    """The letter U_c."""
    return word(letters, "⟨U⟩_c", "⟨U⟩_{c}")


def _place(found: RelativeEquilibrium) -> tuple[Any, ...]:
    """List vectors and names with their numbers, then the name that takes every value."""
    clauses = [(VECTORS[name], " = (", *listed(map(in_sentence, value)), ")") if isinstance(name, str)
               else (name, " = ", in_sentence(value))
               for name, value in found.form.described if value is not None]
    every, value = found.form.described[0]
    return joined(", ", clauses if value is not None else [*clauses, ("every ", every)])


def _ended(found: RelativeEquilibrium) -> str:
    on = f", and on {found.locus}" if found.locus and found.form.described[0][1] is not None else ""
    return f"{on}: {found.decision.verdict.name.lower()}"
