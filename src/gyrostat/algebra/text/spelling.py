"""Translates names and signs as papers and the library print them, π₃⁰, ω, −, ^, into ASCII."""
import re
from unicodedata import name as title

from ...notation import jet_name
from ...typesetting import GREEK, SUBSCRIPTS, SUPERSCRIPTS

# of two words that are printed alike the one in the table of notation; letters that keyboards have twice
_LETTERS = {letter: word for word, letter in GREEK.items()} | {
    "λ": "lamda", "ϕ": "phi", "ϑ": "theta", "ϵ": "epsilon", "µ": "mu"}
_LOWERED = {chr(low): chr(digit) for digit, low in SUBSCRIPTS.items()}
_RAISED = {chr(high): chr(digit) for digit, high in SUPERSCRIPTS.items()}
_GREEK, _LOW, _HIGH = ("".join(table) for table in (_LETTERS, _LOWERED, _RAISED))
_PRIMES = "′″‴"
_DERIVATIVE = rf"U(?:[{_PRIMES}]|⁽[{_HIGH}]{{1,3}}⁾)(?:\(k[3₃]\))?|∂[₁₂₃]{{1,9}}U"
# a superscript 0 marks the value at the equilibrium: of π₃ and ω₃, as they are printed
_AT = rf"(?:(?<=[πω][123₁₂₃])⁰(?![{_HIGH}]))?"
NAME = (rf"(?:{_DERIVATIVE}|(?:[A-Za-z][A-Za-z0-9_]*+|[{_GREEK}])"
        rf"(?:[0-9_{_LOW}]|(?<=_)(?:[{_GREEK}]|[A-Za-z]++))*{_AT})")
RAISED = rf"[{_HIGH}]+"
# each sign that is read beside its own
SIGNS = {"^": "**", "·": "*", "⋅": "*", "−": "-"}
RELATIONS = str.maketrans({"≤": "<=", "≥": ">="})
_DIGITS = str.maketrans("".join(_RAISED), "".join(_RAISED.values()))
_ASCII = str.maketrans({**_LETTERS, **_LOWERED, "⁰": "_0"})


def spelled(text: str) -> str:
    """Return the name that a text is, as it stands in the table of notation; "" if it is none.

    Examples
    --------
    >>> [spelled(text) for text in ("π₃⁰", "I₁", "ω", "U″", "k₃²")]
    ['pi3_0', 'I1', 'omega', 'd2U', '']
    """
    if re.fullmatch(NAME, text) is None:
        return ""
    if not re.fullmatch(_DERIVATIVE, text):
        return text.translate(_ASCII)
    if text[0] == "∂":
        return jet_name(len(text) - 2, text[1:-1].translate(_ASCII))
    if text[1] in _PRIMES:
        return jet_name(_PRIMES.index(text[1]) + 1)
    return jet_name(int(lowered(text[2:text.index("⁾")])))


def names_in(text: str) -> set[str]:
    """Return all that reads as a name in a text, which may be several expressions.

    Examples
    --------
    >>> sorted(names_in("(I₃·ω₃⁰ + l)² > 4*I1*m0"))
    ['I1', 'I3', 'l', 'm0', 'omega3_0']
    """
    return {spelled(name) for name in re.findall(NAME, text)}


def lowered(superscript: str) -> str:
    """Return the digits and the sign of a superscript.

    Examples
    --------
    >>> lowered("⁻¹²")
    '-12'
    """
    return superscript.translate(_DIGITS)


def character(c: str) -> str:
    """Return a character and its name, if it is one of those that look like others.

    Examples
    --------
    >>> character("к")
    "'к' (CYRILLIC SMALL LETTER KA)"
    """
    return repr(c) if c.isascii() else f"{c!r} ({title(c, f'U+{ord(c):04X}')})"
