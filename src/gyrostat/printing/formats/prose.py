"""Writes prose in ASCII for LaTeX: mathematics between dollar signs, accents as commands."""
import re
from types import MappingProxyType
from unicodedata import name, normalize

from ...typesetting import GREEK, SUBSCRIPTS, SUPERSCRIPTS
from .latex import RELATIONS

_LOW = {chr(low): chr(digit) for digit, low in SUBSCRIPTS.items()}
_HIGH = {chr(high): chr(digit) for digit, high in SUPERSCRIPTS.items()} | {"ᵀ": "T"}
_DOTS = {"\u0307": r"\dot", "\u0308": r"\ddot"}
_SIGNS = MappingProxyType(RELATIONS | {letter: rf"\{word}" for word, letter in GREEK.items()} | {
    "−": "-", "×": r"\times ", "·": r"\cdot ", "⋅": r"\cdot ", "±": r"\pm ", "∇": r"\nabla ",
    "∂": r"\partial ", "√": r"\surd ", "∫": r"\int ", "∞": r"\infty ", "→": r"\to ",
    "←": r"\leftarrow ", "°": r"^{\circ}", "′": "'", "″": "''", "‴": "'''", "𝒜": r"\mathcal{A}",
    "⟨": r"\langle ", "⟩": r"\rangle ", "ϕ": r"\phi", "ϑ": r"\vartheta", "ϵ": r"\epsilon", "µ": r"\mu",
    "<": "<", ">": ">", "|": "|"})
_PROSE = MappingProxyType({
    "\\": r"\char92 ", "^": r"\char94 ", "~": r"\char126 ", **{sign: rf"\{sign}" for sign in "_%#$&{}"},
    "…": r"\ldots ", "§": r"\S", "–": "--", "—": "---", "’": "'", "\u00a0": "~", "ß": r"{\ss}",
    "ø": r"{\o}", "Ø": r"{\O}", "æ": r"{\ae}", "Æ": r"{\AE}", "ł": r"{\l}", "Ł": r"{\L}", "¿": "?`",
    "¡": "!`"})
_ACCENTS = {"\u0300": "`", "\u0301": "'", "\u0302": "^", "\u0303": "~", "\u0304": "=", "\u0306": "u ",
            "\u0307": ".", "\u0308": '"', "\u030a": "r ", "\u030b": "H ", "\u030c": "v ", "\u0327": "c ",
            "\u0328": "k "}
_SIGN, _LOWERED, _RAISED = (f"[{re.escape(''.join(table))}]" for table in (_SIGNS, _LOW, _HIGH))
_DOTTED = rf"(?:[A-Za-z]|{_SIGN})[{''.join(_DOTS)}]"
# a dot on a letter before the letter alone
_TOKEN = re.compile(rf"({_DOTTED})|({_LOWERED}+)|({_RAISED}+)|({_SIGN})")
_MATHEMATICS = re.compile(rf"((?:{_DOTTED}|{_LOWERED}|{_RAISED}|{_SIGN})+)")


def words(text: str) -> str:
    r"""Write prose for LaTeX; an expression in it stands as it is typed.

    Examples
    --------
    >>> words("ω₃⁰ < 5 % of −0.02: Poincaré")
    "$\\omega_{3}^{0}$ $<$ 5 \\% of $-$0.02: Poincar{\\'e}"
    """
    parts = _MATHEMATICS.split(normalize("NFC", text))
    return "".join(f"${_TOKEN.sub(_sign, part).rstrip()}$" if n % 2 else "".join(map(_letter, part))
                   for n, part in enumerate(parts))


def _sign(token: re.Match[str]) -> str:
    dotted, low, high, sign = token.groups()
    if dotted:
        return rf"{_DOTS[dotted[1]]}{{{_SIGNS.get(dotted[0], dotted[0]).rstrip()}}}"
    if low or high:
        table = _LOW if low else _HIGH
        return f"{'_' if low else '^'}{{{''.join(table[c] for c in low or high)}}}"
    return _SIGNS[sign]


def _letter(c: str) -> str:
    """Write a letter or a sign of prose; if it has no command, its name is written."""
    if c.isascii() or c in _PROSE:
        return _PROSE.get(c, c)
    base, accent = (plain := normalize("NFD", c))[0], plain[1:]
    if base.isascii() and accent in _ACCENTS:
        dotless = r"\i" if base == "i" else base
        return rf"{{\{_ACCENTS[accent]}{dotless}}}"
    return f"({name(c, f'U+{ord(c):04X}').lower()})"
