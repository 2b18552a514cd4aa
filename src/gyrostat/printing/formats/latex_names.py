"""Gives the LaTeX of every name in a document: that of the notation, or the symbol of a paper."""
import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from ...errors import ExpressionError, ValuesError, brief
from ...notation import NOTATION, REGISTRY, Use, jet
from ...stability.criteria.numbers_asked import unknown
from ...typesetting import PLACE, typeset

# what may stand in a document beside the notation and a user's parameters
LETTERS = frozenset(f"{entry.name.rstrip('_*')}{number}" for entry in REGISTRY if entry.use is Use.PRINTED
                    for number in ("", "1", "2", "3")) | {"sigma"}
LONGEST = 60                                           # characters of a symbol
_GREEK = (r"\\(?:(?:var)?(?:epsilon|theta|rho|sigma|phi|kappa|pi)|alpha|beta|gamma|delta|zeta|eta|iota|lambda"
          r"|mu|nu|xi|tau|upsilon|chi|psi|omega|Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Upsilon|Phi|Psi|Omega|ell)"
          r"(?![A-Za-z])")
_INNER = rf"(?:[A-Za-z0-9,+* -]|{_GREEK}|\\mathrm\{{[A-Za-z0-9 ]+\}})+"
_STYLED = r"\\(?:mathrm|mathit|mathbf|mathsf|mathcal|boldsymbol)"
_LETTER = rf"(?:[A-Za-z]|{_GREEK}|{_STYLED}\{{{_INNER}\}})"
_ACCENT = r"\\(?:bar|hat|tilde|vec|dot|ddot)"
_BASE = rf"(?:{_LETTER}|{_ACCENT}\{{{_LETTER}\}}|{_ACCENT}(?: +[A-Za-z]| *{_GREEK}))"
_SCRIPT = rf"(?:[A-Za-z0-9+*]|{_GREEK}|\{{{_INNER}\}})"
# compiled when it is asked for, as it takes 5 ms
_SYMBOL = rf"{_BASE}(?:'*(?:_{_SCRIPT})?(?:\^{_SCRIPT})?|\^{_SCRIPT}_{_SCRIPT}|_{_SCRIPT}'+)"
_LABEL = re.compile(r"[A-Za-z][A-Za-z0-9:.-]*")


@dataclass
class Names:
    """The symbols of a document, and which names occur in it.

    Parameters
    ----------
    renamed : mapping of str to str
        the LaTeX of names that a paper writes otherwise, one symbol each
    """

    renamed: Mapping[str, str] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        taken: dict[str, str] = {}
        for name, symbol in self.renamed.items():
            checked(name, symbol)
            if (other := taken.setdefault(_bare(symbol), name)) != name:
                raise ValuesError(f"{other} and {name} would both be {symbol}: give one of them another "
                                  "symbol")

    def of(self, name: str, at: object = None) -> str:
        """The LaTeX of a name; derivatives of U take their argument from at, x_dot is the rate of x."""
        self.used.add(name)
        if name in self.renamed:
            return self.renamed[name]
        if derivative := jet(name):
            potential, shown = self.of("U"), typeset(name, at)
            if derivative[1]:
                return shown.removesuffix("U") + potential
            k3 = self.of("k3") if shown.endswith("(k_3)") else ""
            return (f"{{{potential}}}" if raised(potential) else potential) + (
                shown.removeprefix("U").replace("(k_3)", f"({k3})"))
        if (rated := name.removesuffix("_dot")) != name and (
                rated in {*self.renamed, *NOTATION} or rated.startswith(("vector_", "bold_"))):
            latex = self.of(rated)
            base = re.split("[_^']", latex)[0]         # the dot stands on the letter
            return rf"\dot{{{base}}}{latex.removeprefix(base)}"
        if name.startswith("vector_"):
            return typeset(name.removeprefix("vector_"))
        if name.startswith("bold_"):
            vector = "vector_" + name.removeprefix("bold_")
            return self.renamed.get(vector) or rf"\boldsymbol{{{self.of(vector)}}}"
        return typeset(name, at)

    def fill(self, template: str) -> str:
        """LaTeX with the symbols of the names that stand in it, as in ⟨I1⟩^2."""
        def shown(match: re.Match[str]) -> str:
            latex = self.of(match[1])
            if match[2] == "^" and raised(latex):
                return rf"\left({latex}\right)^"
            if (match[2] == "_" and "_" in latex) or (match[2] == "'" and raised(latex)):
                latex = f"{{{latex}}}"
            return latex + match[2]
        return PLACE.sub(shown, template)

    def check(self, whole: bool = False) -> None:
        """Refuse symbols that two names have; in a whole document also names that do not occur.

        Raises
        ------
        ValuesError
            a symbol was given that another name has already
        """
        shown: dict[str, str] = {}
        for name in sorted(n for n in self.used if not n.endswith("_dot")):
            other = shown.setdefault(_bare(self.of(name)), name)
            if other != name and not {name, other}.isdisjoint(self.renamed):
                raise ValuesError(f"{other} and {name} would both be {self.of(name)}: give one of them "
                                  "another symbol")
        known = {*self.used, *NOTATION, *LETTERS}
        for name in self.renamed if whole else ():
            if name not in known:
                raise ValuesError(unknown(name, sorted(n for n in self.used if not n.endswith("_dot")),
                                          "the document"))


@dataclass(frozen=True)
class Paper:
    """How LaTeX stands in a paper.

    Parameters
    ----------
    symbols : mapping of str to str
        the LaTeX of names that it writes otherwise
    label : str
        what the labels of equations and tables begin with
    fragment : bool
        no document of its own
    """

    symbols: Mapping[str, str] = field(default_factory=dict)
    label: str = "gyrostat"
    fragment: bool = False

    def __post_init__(self) -> None:
        if len(self.label) > LONGEST or not _LABEL.fullmatch(self.label):
            raise ExpressionError(f"{brief(self.label)} is no label: write letters, digits, and : . - "
                                  "between them, as in top:upright")

    def labelled(self, *parts: str) -> str:
        r"""The \label of a result."""
        return rf"\label{{{':'.join([self.label, *parts]).replace(' ', '-')}}}"


PLAIN = Paper()


def raised(latex: str) -> bool:
    """Whether a symbol has to be closed before it is raised to a power."""
    return "^" in latex or "'" in latex


def checked(name: str, symbol: str) -> None:
    """Refuse what is not one symbol.

    Raises
    ------
    ExpressionError
        another command than letters, accents and scripts need, an expression, or more than 60 characters
    """
    if not isinstance(symbol, str) or len(symbol) > LONGEST or not re.fullmatch(_SYMBOL, symbol):
        raise ExpressionError(f"{brief(symbol)} for {brief(str(name))[1:-1]} is not one symbol: "
                              "write a letter, plain, "
                              r"Greek or in \mathrm{}, \mathcal{}, \mathbf{}, with an accent such as \bar{}, "
                              r"primes and scripts: A, \sigma, I_{xx}, \bar{m}_1")


def _bare(symbol: str) -> str:
    """A symbol without what changes nothing of how it looks."""
    return re.sub(r"[{} ]", "", symbol)
