"""The misprints among findings as a table of errata in LaTeX."""
import re
from collections.abc import Iterable
from itertools import groupby
from typing import Any

from sympy import Expr, Symbol

from ..article import preamble
from ..conditions import Criterion
from ..latex import Printer, formula
from ..notation import symbol
from . import Finding, source_of
from .language import form
from .listing import as_text, number, place, rows

_VECTORS = {"vector_pi": r"\boldsymbol{\pi}", "vector_k": r"\mathbf{k}", "vector_l": r"\boldsymbol{l}",
            "vector_omega": r"\boldsymbol{\omega}",
            "vector_M": r"\mathbf{M}", "vector_A": r"\mathbf{A}", "vector_r": r"\mathbf{r}", "vector_m": r"\mathbf{m}",
            "vector_z": r"\hat{\mathbf{z}}", "delta_pi": r"\delta\boldsymbol{\pi}", "delta_k": r"\delta\mathbf{k}",
            "axis_1": r"\hat{\mathbf{e}}_1", "axis_2": r"\hat{\mathbf{e}}_2", "axis_3": r"\hat{\mathbf{e}}_3", "tensor": r"\mathbf{I}",
            "axis_vertical": r"\hat{\mathbf{z}}", "axis_nodes": r"\hat{\mathbf{e}}_2'", "delta": "dt", "jacobian": "J",
            "linearization": "A", "tensor_torque": r"\boldsymbol{\tau}", "torque": r"\boldsymbol{\tau}"}
_FUNCTIONS = {"cross": r"{} \times {}", "dot": r"{} \cdot {}", "dt": r"\frac{{d}}{{dt}} {}", "entry": r"{}_{{{}{}}}",
              "transpose": r"{}^{{T}}", "inverse": r"{}^{{-1}}", "variation": r"\delta {}", "gradient_pi": r"\nabla_{{\pi}} {}",
              "gradient_k": r"\nabla_{{k}} {}", "abs": r"\left|{}\right|", "bracket": r"\{{ {}, {} \}}"}


class _Published(Printer):
    """The printed form, with vectors and the functions of the motion."""

    def _print_Symbol(self, expr: Symbol, style: str = "plain") -> str:
        return _VECTORS.get(expr.name) or super()._print_Symbol(expr)

    def _print_AppliedUndef(self, expr: Any) -> str:
        template = _FUNCTIONS.get(str(expr.func))
        parts = [self._factor(a) if template and len(expr.args) < 3 else self._print(a) for a in expr.args]
        return template.format(*parts) if template else super()._print_AppliedUndef(expr)


def _latex(printed: Any, at: Any) -> str:
    """A printed text, or texts, in LaTeX: a formula, comparisons, or words."""
    if isinstance(printed, list):
        entries = "$, $".join(_latex(entry, at) for entry in printed)      # so that lines may end at the commas
        return rf"\bigl({entries}\bigr)"
    words = []
    for part in re.split(r"\band\b", printed):
        pieces = re.split(r"\s*(<=|>=|<|>)\s*", part.strip())
        try:
            sides = [_Published(at).doprint(form(piece)) for piece in pieces[::2]]
        except ValueError:                                 # a verdict in words
            return rf"\text{{{_tex(printed)}}}"
        relations = [{"<=": r"\leq", ">=": r"\geq"}.get(sign, sign) for sign in pieces[1::2]]
        words.append(" ".join(x for pair in zip(sides, [*relations, ""]) for x in pair).strip())
    return r" \text{ and } ".join(words)


def latex(findings: Iterable[Finding], fragment: bool = False) -> str:
    """A table of errata: where, what is printed, what is derived, a counterexample."""
    body = []
    for _, group in groupby((f for f in findings if f.status == "misprint"), key=lambda f: f.statement.source):
        found = list(group)
        source = source_of(found[0])
        title = rf"\rule{{0pt}}{{3ex}}\textbf{{{_tex(source.name)}}}: {_tex(source.title)}"
        body += [rf"\multicolumn{{3}}{{@{{}}p{{0.96\textwidth}}@{{}}}}{{{title}}}\\[1ex]"]
        body += [_erratum(f) for f in found]
    table = "\n".join((
        r"\begingroup\small\setlength{\LTleft}{0pt}\setlength{\LTright}{0pt}\setlength{\emergencystretch}{3em}", r"\begin{longtable}{@{}"
        r">{\raggedright\arraybackslash}p{0.19\textwidth}>{\raggedright\arraybackslash}p{0.42\textwidth}"
        r">{\raggedright\arraybackslash}p{0.31\textwidth}@{}}", r"\textbf{Where} & \textbf{Printed, and derived} & "
        r"\textbf{Counterexample}\\ \hline \endhead", *body, r"\end{longtable}\endgroup", ""))
    return table if fragment else preamble("Errata", ("longtable", "array")) + table + "\\end{document}\n"


def _erratum(f: Finding) -> str:
    at, lines = place(f), list[str]()
    for entry, printed, right in rows(f):
        label, whole = f"{entry}: " if entry else "", printed == f.statement.printed
        lines += [f"{'' if whole else label}printed ${_latex(printed, at)}$"] if not whole or not lines else []
        lines.append(f"{label}right {_right(right, at, f)}")
    if f.statement.note:
        lines.append(rf"\emph{{{_tex(f.statement.note)}}}")
    example = ""
    if c := f.outcome.counterexample:
        values = ", ".join(f"${Printer().doprint(symbol(n)) if n.isidentifier() else n} = {formula(v)}$" for n, v in c.values)
        example = f"{values}: printed {_value(c.printed)}, derived {_value(c.derived)}; {_tex(c.confirmation)}"
    shown = r" \newline ".join(lines)
    return rf"{_tex(f.statement.where)} & {shown} & {example} \\[1ex]"


def _right(value: Any, at: Any, f: Finding) -> str:
    if isinstance(value, (str, list)):
        return f"${_latex(value, at)}$" if f.outcome.corrected is not None else _tex(as_text(value))
    return f"${formula(value)}$" if isinstance(value, Criterion) else f"${_Published(at).doprint(value)}$"


def _value(value: Any) -> str:
    return f"${formula(value)}$" if isinstance(value, Expr) and value.is_Rational else _tex(number(value))


_UNICODE = dict(zip("−′″²³⁴⁻¹⁰₀₁₂₃≥≤≠×·Σ√±πωΩφψθλνσδτεαμκΦ∇∂§ẑê", (f"${x}$" for x in (
    r"-|\prime|\prime\prime|^2|^3|^4|^-|^1|^0|_0|_1|_2|_3|\geq|\leq|\neq|\times|\cdot|\Sigma|\surd|\pm|\pi|\omega|\Omega|\varphi|\psi|"
    r"\theta|\lambda|\nu|\sigma|\delta|\tau|\varepsilon|\alpha|\mu|\kappa|\Phi|\nabla|\partial|\text{\S}|\hat z|\hat e").split("|"))))
_SPECIAL = {"_": r"\_", "&": r"\&", "%": r"\%", "#": r"\#", "^": r"\^{}", "<": "$<$", ">": "$>$", "|": "$|$"}


def _tex(words: str) -> str:
    """Words in LaTeX: special characters, and the Unicode of formulas in prose."""
    dotted = words.replace("ψ̇", "\0").replace("φ̇", "\1")
    shown = "".join(_UNICODE.get(c, _SPECIAL.get(c, c)) for c in dotted)
    return shown.replace("\0", r"$\dot\psi$").replace("\1", r"$\dot\varphi$").replace("$$", "")
