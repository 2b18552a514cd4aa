"""Says by the table of names which names an expression may have, and which letters the print takes."""
import re
from collections.abc import Collection, Iterable, Sequence
from itertools import chain, count
from types import MappingProxyType

from sympy import Expr, Symbol

from .errors import GyrostatError
from .notation import REGISTRY, Use, jet
from .typesetting import GREEK, look, typeset

_ENTRIES = MappingProxyType({entry.name: entry for entry in REGISTRY if entry.use is not Use.PRINTED})
_PRINTED = MappingProxyType({entry.name: entry for entry in REGISTRY if entry.use is Use.PRINTED})
INTERNAL = frozenset({"nu1", "nu2", "nu3", "lamda"})   # names that a derivation introduces itself
AUTONOMOUS = ("the criteria are for autonomous fields and bodies, which do not change with it: write a "
              "constant in place of what changes")
_ADMITTED = frozenset({None, Use.BODY, Use.FIELD, Use.LEVEL})
_NUMBER = re.compile(r"[₀-₉]+")
_PLACE = re.compile(r"⟨(\w+)⟩")
_IN_PROSE = re.compile(r"\b(?:C[123]|D[46]?|K|U)\b")


def use_of(name: str) -> Use | None:
    """Return what a name is for; None for a parameter of the user, which may stand anywhere in a scene.

    Examples
    --------
    >>> use_of("l").name, use_of("theta_dot").name, use_of("h")
    ('ROTOR', 'MOTION', None)
    """
    if jet(name) or name.endswith(("_dot", "_ddot")):
        return Use.MOTION
    return _ENTRIES[name].use if name in _ENTRIES else None


def refused(symbols: Iterable[Symbol], *also: Use) -> list[str]:
    """Return the names that an expression of a scene may not depend on, the time before others.

    Parameters
    ----------
    symbols : iterable of Symbol
    also : Use
        what may stand there beside moments and parameters: the rotor in a rotor

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> refused(map(symbol, ("l", "I1", "t", "h")))
    ['t', 'l']
    >>> refused([symbol("l")], Use.ROTOR)
    []
    """
    taken = sorted(s.name for s in symbols if use_of(s.name) not in _ADMITTED.union(also))
    return sorted(taken, key=lambda name: use_of(name) is not Use.TIME)


def free_letters(names: Iterable[str], taken: Collection[str]) -> dict[str, str]:
    """Return a letter for each parameter that cannot have its name.

    Parameters
    ----------
    names : iterable of str
    taken : collection of str
        other names of the expression

    Examples
    --------
    >>> free_letters(["l", "omega"], {"L", "g"})
    {'l': 'a', 'omega': 'Omega'}
    """
    found: dict[str, str] = {}
    for name in names:
        own = _ENTRIES[name].instead.split() if name in _ENTRIES else []
        letters = chain(own, "abcdefgh", (f"a{n}" for n in count(1)))
        found[name] = next(x for x in letters if x not in taken and x not in found.values())
    return found


def why_refused(names: Sequence[str], taken: Collection[str]) -> str:
    """Return what the refused names are, two of them at most, and what to write in their place.

    Examples
    --------
    >>> what, todo = why_refused(["l"], ["l", "M"]).split(": ")
    >>> what
    'l, the gyrostatic momentum of the rotor'
    >>> todo
    'for a number of your own write another letter, such as L'
    """
    if use_of(names[0]) is Use.TIME:
        return f"{names[0]}, the time: {AUTONOMOUS}"
    letters = free_letters(names[:2], taken)
    return f"{what_they_are(names)}: for a number of your own write another letter, such as " + " and ".join(
        letters.values())


def check_names(expressions: Iterable[Expr], what: str, error: type[GyrostatError], *also: Use) -> None:
    """Refuse expressions of a scene that depend on a name that may not stand there.

    Parameters
    ----------
    expressions : iterable of Expr
    what : str
        what they are, in the message
    error : type
        what is raised
    also : Use
        what may stand there too

    Examples
    --------
    >>> from gyrostat.errors import BodyError
    >>> from gyrostat.notation import symbol
    >>> check_names([symbol("t")], "the rotor", BodyError)  # doctest: +NORMALIZE_WHITESPACE
    Traceback (most recent call last):
    gyrostat.errors.BodyError: the rotor depends on t, the time: the criteria
    are for autonomous fields and bodies, which do not change with it: write
    a constant in place of what changes
    """
    found = set[Symbol]().union(*(e.free_symbols for e in expressions))
    if names := refused(found, *also):
        raise error(f"{what} depends on {why_refused(names, [s.name for s in found])}")


def what_they_are(names: Sequence[str]) -> str:
    """Return the first two of some names, each with what it is."""
    return " and ".join(f"{name}, the {_meaning(name)}" for name in names[:2])


def _meaning(name: str) -> str:
    """Return what a name is, in a few words."""
    if name not in _ENTRIES:
        return "derivative of U" if jet(name) else "rate of a coordinate"
    return _ENTRIES[name].meaning.split(":")[0]


class Letters:
    """The letters in which a scene is printed: if the scene has one of them, another takes its place.

    All vectors are bold if one of them looks like a name of the scene.

    Parameters
    ----------
    names : iterable of str
        those of the scene
    directions : iterable of str
        its vectors, beside M, l, ω and I

    Examples
    --------
    >>> letters = Letters(["h", "C1"])
    >>> letters.of("h"), letters.of("g"), letters.of("C2")
    ('E', 'g', 'Z2')
    >>> letters.text("⟨vector_k_dot⟩ = ⟨vector_k⟩ × ω")
    'k̇ = k × ω'
    """

    def __init__(self, names: Iterable[str] = (), directions: Iterable[str] = ()):
        self._looks = {typeset(name, style="text") for name in names
                       if use_of(name) in (None, Use.FIELD, Use.LEVEL)}
        self._chosen = dict[str, str]()
        self._bold = any(typeset(vector, style="text") in self._looks
                         for vector in ("M", "l", "omega", "I", *directions))
        for key, entry in _PRINTED.items():
            if not key.startswith("vector_") and self._has(key):
                self._chosen[key] = self._other(key, entry.instead.split())

    def _has(self, key: str) -> bool:
        """Tell whether a name of the scene looks like a letter of the print, or one of its numbered ones."""
        look = typeset(key.rstrip("_*"), style="text")
        numbered = any(x.startswith(look) and _NUMBER.fullmatch(x[len(look):]) for x in self._looks)
        return numbered and key[-1] in "_*" or look in self._looks and key[-1] != "_"

    def _other(self, key: str, instead: Iterable[str]) -> str:
        """Return a letter that neither the scene nor the print has, with or without numbers as this one."""
        own = key.rstrip("_*")
        kind = key[len(own):]
        ours = {k.rstrip("_*") for k in _PRINTED if "*" in k + kind or k.endswith("_") == (kind == "_")}
        free = (x for x in (*instead, *GREEK) if not self._has(x + kind)
                and x not in ours and x not in self._chosen.values())
        return next(free, own)

    def of(self, name: str) -> str:
        """Return the name that a letter of the print has here.

        Parameters
        ----------
        name : str
            as in the table; C2 for a number of C_, and C_ for that letter alone
        """
        if name.startswith("vector_"):
            return name.replace("vector_", "bold_") if self._bold else name
        letter = name.rstrip("0123456789")
        keys = (f"{letter}_", f"{letter}*") if letter != name else (name, f"{name}*")
        chosen = next((self._chosen[key] for key in keys if key in self._chosen), letter.rstrip("_"))
        return chosen + name[len(letter):]

    def latex(self, template: str) -> str:
        """Return a template of LaTeX with the names that its letters have here, as in ⟨h⟩ = ⟨C1⟩."""
        return _PLACE.sub(lambda place: f"⟨{self._renamed(place[1])}⟩", template)

    def text(self, template: str) -> str:
        """Return a template of Unicode with its letters."""
        return _PLACE.sub(lambda place: look(self._renamed(place[1])), template)

    def prose(self, text: str) -> str:
        """Return a sentence of a decision with its letters: C1, D4, K and the like."""
        def other(name: re.Match[str]) -> str:
            return name[0] if (letter := self.of(name[0])) == name[0] else look(letter)
        return _IN_PROSE.sub(other, text)

    def _renamed(self, name: str) -> str:
        rate = "_dot" if name.endswith("_dot") else ""
        return self.of(name.removesuffix("_dot")) + rate
