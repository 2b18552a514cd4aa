"""Typesets a printed text in LaTeX, its terms and factors in the order in which they are printed."""
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any

from sympy import Rational

from ..algebra.text.bounded_parts import FUNCTIONS, Part
from ..algebra.text.spelling import RELATIONS
from ..errors import ExpressionError
from ..printing.formats.latex_names import Names
from ..printing.formats.prose import words
from .language import Formula

_NAMES = {"vector_pi": r"\boldsymbol{\pi}", "vector_k": r"\mathbf{k}", "vector_l": r"\boldsymbol{l}",
          "vector_omega": r"\boldsymbol{\omega}", "vector_M": r"\mathbf{M}", "vector_A": r"\mathbf{A}",
          "vector_r": r"\mathbf{r}",
          "vector_m": r"\mathbf{m}", "vector_z": r"\hat{\mathbf{z}}", "delta_pi": r"\delta\boldsymbol{\pi}",
          "delta_k": r"\delta\mathbf{k}", "axis_1": r"\hat{\mathbf{e}}_1", "axis_2": r"\hat{\mathbf{e}}_2",
          "axis_3": r"\hat{\mathbf{e}}_3",
          "axis_vertical": r"\hat{\mathbf{z}}", "axis_nodes": r"\hat{\mathbf{e}}_2'",
          "tensor": r"\mathbf{I}", "delta": "dt",
          "jacobian": "J", "linearization": "A", "tensor_torque": r"\boldsymbol{\tau}",
          "torque": r"\boldsymbol{\tau}",
          "polynomial": r"\chi"}
_FUNCTIONS = {"cross": r"{} \times {}", "dot": r"{} \cdot {}", "dt": r"\tfrac{{d}}{{dt}} {}",
              "entry": r"{}_{{{}{}}}",
              "transpose": r"{}^{{T}}", "inverse": r"{}^{{-1}}", "variation": r"\delta {}",
              "gradient_pi": r"\nabla_{{\pi}} {}",
              "gradient_k": r"\nabla_{{k}} {}", "bracket": r"\{{ {}, {} \}}", "abs": r"\left|{}\right|"}


@dataclass(frozen=True)
class _Tex:
    """The LaTeX of a part: a sum needs parentheses in a product; a divisor has its text in `under`."""

    text: str
    sum: bool = False
    under: str | None = None
    negated: "_Tex | None" = None

    def closed(self) -> str:
        return rf"\left({self.text}\right)" if self.sum else self.text

    def __add__(self, other: "_Tex") -> "_Tex":
        return _Tex(f"{self.text} - {other.text[1:].lstrip()}" if other.text.startswith("-")
                    else f"{self.text} + {other.text}", True)

    def __mul__(self, other: "_Tex") -> "_Tex":
        if self.negated:
            return -(self.negated * other)
        return _Tex(rf"\frac{{{self.text}}}{{{other.under}}}" if other.under
                    else f"{self.closed()} {other.closed()}")

    def __neg__(self) -> "_Tex":
        return _Tex(f"- {self.closed()}", True, negated=self)

    def __pow__(self, exponent: Rational) -> "_Tex":
        return _Tex("", under=self.text)                   # only a division raises to a number


class _Typesetter(Formula):
    def __init__(self, text: str, names: Names, at: Any):
        self.symbols, self.at = names, at
        super().__init__(text, {})

    def factor(self) -> Part:
        self.deeper()
        if sign := self.take("+", "-"):
            part = self.factor()
            base = part if sign == "+" else Part(-part.value)
        else:
            base = self.atom()
            if self.take("**"):
                simple = not base.value.sum and re.fullmatch(r"[\w\\]+(_\{?\w+\}?)?", base.value.text)
                inner = base.value.text if simple else rf"\left({base.value.text}\right)"
                base = Part(_Tex(f"{inner}^{{{self.factor().value.text}}}"))
        self.depth -= 1
        return base

    def total(self, values: Sequence[Any]) -> Any:
        return reduce(add, values)

    def number(self, token: str) -> Part:
        return Part(_Tex(token))

    def named(self, token: str) -> Part:
        if token in self.symbols.renamed:
            return Part(_Tex(self.symbols.of(token, self.at)))
        return Part(_Tex(r"\pi" if token == "pi" else _NAMES.get(token) or self.symbols.of(token, self.at)))

    def call(self, token: str) -> Part:
        arguments = [part.value for part in self.arguments()]
        if template := _FUNCTIONS.get(token):
            plain = token in ("abs", "bracket", "entry")
            return Part(_Tex(template.format(*(a.text if plain else a.closed() for a in arguments)),
                             token in ("cross", "dot")))
        inner = ", ".join(a.text for a in arguments)
        if token == "sqrt":
            return Part(_Tex(rf"\sqrt{{{inner}}}"))
        name = rf"\{token}" if token in FUNCTIONS else rf"\operatorname{{{token}}}"
        return Part(_Tex(rf"{name}\left({inner}\right)"))


def formula_of(printed: str, names: Names, at: Any = None) -> str:
    r"""Return the LaTeX of a printed text: an expression, or comparisons joined by "and".

    Raises
    ------
    ExpressionError
        the text is neither, for example a verdict in words

    Examples
    --------
    >>> print(formula_of("omega**2*I1/2 - k3*dU > 0", Names({"I1": "A"}), at=1))
    \frac{\omega^{2} A}{2} - k_3 U'(1) > 0
    """
    words = []
    for part in re.split(r"\band\b", printed.translate(RELATIONS)):
        pieces = re.split(r"\s*(<=|>=|<|>)\s*", part.strip())
        sides = [_Typesetter(piece, names, at).whole().value.text for piece in pieces[::2]]
        relations = [{"<=": r"\leq", ">=": r"\geq"}.get(sign, sign) for sign in pieces[1::2]]
        words.append(" ".join(x for pair in zip(sides, [*relations, ""]) for x in pair).strip())
    return r" \text{ and } ".join(words)


def printed_latex(printed: Any, names: Names, at: Any = None) -> str:
    """Return LaTeX, for mathematical mode, of a printed text or texts: formulas, comparisons, or words."""
    if isinstance(printed, list):
        # so that lines may end at the commas
        entries = "$, $".join(printed_latex(entry, names, at) for entry in printed)
        return rf"\bigl({entries}\bigr)"
    try:
        return formula_of(printed, names, at)
    except ExpressionError:                                # a verdict in words
        return rf"\text{{{words(printed)}}}"
