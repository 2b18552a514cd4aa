"""Sets names in LaTeX and in Unicode: those of the table, and a user's parameters."""
import re
from types import MappingProxyType
from typing import Any

from .notation import NOTATION, jet


def typeset(name: str, at: Any = None, style: str = "latex") -> str:
    """Return a name as it is printed; derivatives of U take their argument from `at`."""
    if order_axes := jet(name):
        return _typeset_jet(*order_axes, at, style)
    if entry := NOTATION.get(name):
        return entry.latex if style == "latex" else entry.text
    return _typeset_parameter(name, style)


def _typeset_jet(order: int, axes: str, at: Any, style: str) -> str:
    latex = style == "latex"
    if axes:
        return rf"\partial_{{{axes}}} U" if latex else "∂" + axes.translate(str.maketrans("123", "₁₂₃")) + "U"
    if order <= 3:
        primes = "'" * order if latex else "′″‴"[order - 1]
    else:
        primes = f"^{{({order})}}" if latex else "⁽" + str(order).translate(SUPERSCRIPTS) + "⁾"
    argument = "k3" if at is None else str(at).replace("-", "-" if latex else "−")
    return f"U{primes}({typeset(argument, style=style) if argument == 'k3' else argument})"


SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
GREEK = MappingProxyType({
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η",
    "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ",
    "sigma": "σ", "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Phi": "Φ",
    "Psi": "Ψ", "Omega": "Ω"})
# a letter or a word, its number, with or without _, and a subscript
_NAME = re.compile(r"([A-Za-z]+?)(?:_?(\d+))?(?:_([A-Za-z][A-Za-z0-9]*))?")

PLACE = re.compile(r"⟨(\w+)⟩([\^_']?)")                   # of a name in a template, and a script after it


def _typeset_parameter(name: str, style: str) -> str:
    """Return a user's parameter: a letter or Greek name with subscripts, a word upright, else as it is."""
    latex = style == "latex"
    if rate := re.fullmatch(r"(\w+)_(d?dot)", name):        # a rate: one dot, or two in phi_ddot
        inner = _typeset_parameter(rate[1], style)
        dots = "\u0307" if rate[2] == "dot" else "\u0308"
        return rf"\{rate[2]}{{{inner}}}" if latex else f"{inner[0]}{dots}{inner[1:]}"
    if name.startswith("delta_") and len(name) > 6 and not name[6:].isdecimal():          # a variation
        return (r"\delta " if latex else "δ") + typeset(name[6:], style=style)
    word, digits, below = match.groups("") if (match := _NAME.fullmatch(name)) else ("", "", "")
    single = word in GREEK or len(word) == 1
    # m_0 is not the m0 of the table
    if not word or (below and not single) or (digits and f"_{digits}" in name and word + digits in NOTATION):
        return r"\mathrm{" + name.replace("_", r"\_") + "}" if latex else name
    if below and below.rstrip("0123456789") in GREEK:
        below = _typeset_parameter(below, style)
    if not latex:
        return GREEK.get(word, word) + digits.translate(SUBSCRIPTS) + (f"_{below}" if below else "")
    shown = "\\" + word if word in GREEK else word if single else rf"\mathrm{{{word}}}"
    subscripts = ",".join(filter(None, (digits, below)))
    return f"{shown}_{{{subscripts}}}" if subscripts else shown


def look(name: str) -> str:
    """Return what print shows for a letter of its own: vector_k, bold_k, the rate vector_k_dot, a name.

    Examples
    --------
    >>> look("vector_k"), look("bold_k"), look("pi3_dot"), look("C1")
    ('k', '𝐤', 'π̇₃', 'C₁')
    """
    if name.endswith("_dot"):
        shown = look(name.removesuffix("_dot"))
        return f"{shown[0]}\u0307{shown[1:]}"
    if name.startswith("vector_"):
        return typeset(name.removeprefix("vector_"), style="text")
    if name.startswith("bold_"):
        return "".join(map(_bold, typeset(name.removeprefix("bold_"), style="text")))
    return typeset(name, style="text")


def _bold(letter: str) -> str:
    """Return a Latin or Greek letter in bold, anything else as it is."""
    for first, last, bold in (("A", "Z", "𝐀"), ("a", "z", "𝐚"), ("α", "ω", "𝛂")):
        if first <= letter <= last:
            return chr(ord(bold) + ord(letter) - ord(first))
    return letter


def placed(template: str) -> set[str]:
    """Return the names that stand in a template."""
    return {name.removesuffix("_dot") for name, _ in PLACE.findall(template)}
