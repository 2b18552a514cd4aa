"""Cuts a text into tokens: numbers, names, operators and parentheses; reads a plain numeral at once."""
import re
from math import gcd
from typing import NoReturn

from sympy import Rational

from ...errors import ExpressionError, brief
from .spelling import NAME, RAISED, SIGNS, character, lowered, spelled

ROOT, PRIMES, DEGREE = "√", "'′″‴’", "°"
_TOKEN = re.compile(rf"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>{NAME}|{DEGREE})"
                    rf"|(?P<raised>{RAISED})|(?P<sign>\*\*|[-+*/(){''.join(SIGNS)}{ROOT}]))", re.ASCII)
# characters of a text: with exponents below 100 numerator and denominator have less than 600 bits, and the
# grammar allows 4000
SHORT = 60
# possessive, so that 5e123 is not read as 5 and a unit e123
_NUMERAL = re.compile(r"\s*+([-+]?)\s*+(?:(\d++)\.?+(\d*+)|\.(\d++))(?:[eE]([-+]?\d{1,2}+))?+"
                      r"(?:\s*+/\s*+(\d++))?+\s*+([A-Za-z°].*+)?", re.ASCII)
Token = tuple[str, str]                                # kind and text
END: Token = ("end", "")


class Scanner:
    """The tokens of a text, and the place of the next one."""

    TOKEN = _TOKEN
    HINT = "allowed are names in Latin and Greek letters, numbers, + - * / ^ and parentheses"

    def __init__(self, text: str):
        self.text, self.place = text, 0
        self.tokens = [*self._plain(self._scan()), END]

    def _scan(self) -> list[Token]:
        tokens, place, end = [], 0, len(self.text.rstrip())
        while place < end:
            match = self.TOKEN.match(self.text, place)
            if match is None:
                rest = self.text[place:].lstrip()
                hint = self.HINT
                if comma := re.search(r"(\d+),(\d+)\Z",
                                      self.text[:place] + re.match(r",?\d*", rest)[0]):  # type: ignore[index]
                    hint = f"write a decimal point, {comma[1]}.{comma[2]}"
                if rest[0] in PRIMES:
                    hint = ("names have no primes: write k1, k2, k3 for the direction γ, γ′, γ″, or a number "
                            "after a letter, b2")
                what = repr(rest[:12]) if rest[0].isascii() else character(rest[0])
                self.fail(f"{what} at character {len(self.text) - len(rest) + 1} is not part of the grammar",
                          hint)
            tokens.append((str(match.lastgroup), match[str(match.lastgroup)]))
            place = match.end()
        return tokens

    def _plain(self, tokens: list[Token]) -> list[Token]:
        """Return the tokens in ASCII: x^2 and x² as x**2, √x as sqrt(x), names as they stand in the table."""
        plain = list[Token]()
        for (_, before), (kind, text), (after, sign) in zip([END, *tokens], tokens, [*tokens[1:], END]):
            if kind == "raised":
                plain += self._raised(text, SIGNS.get(sign) == "**")
            elif text == ROOT:
                if sign != "(" and after not in ("name", "number"):
                    self.fail(f"{ROOT} stands before no name, number or parenthesis", f"write {ROOT}(...)")
                plain.append(("name", "sqrt"))
            elif before == ROOT and text != "(":
                if after == "raised" or sign in ("(", "^", "**"):
                    self.fail(f"what is under {ROOT} is not clear", f"write {ROOT}(...)")
                plain += [("sign", "("), _ascii(kind, text), ("sign", ")")]
            else:
                plain.append(_ascii(kind, text))
        return plain

    def _raised(self, text: str, power: bool) -> list[Token]:
        """Return a superscript as a power."""
        digits = lowered(text)
        if not re.fullmatch("-?[1-9][0-9]*", digits):
            self.fail(f"the superscript {text[:12]} is no exponent",
                      "write π₃⁰ as pi3_0, other powers with ^")
        if power:
            self.fail(f"a power follows the superscript {text[:12]}", "write parentheses")
        minus = [("sign", "-")] if digits[0] == "-" else []
        return [("sign", "**"), ("sign", "("), *minus, ("number", digits.lstrip("-")), ("sign", ")")]

    def fail(self, why: str, todo: str) -> NoReturn:
        raise ExpressionError(f"cannot read {brief(self.text)}: {why}; {todo}") from None

    def peek(self) -> str:
        return self.tokens[self.place][1]

    def take(self, *wanted: str) -> str:
        if (token := self.peek()) and token in wanted:
            self.place += 1
            return token
        return ""


def _ascii(kind: str, text: str) -> Token:
    if text == DEGREE:
        return kind, "deg"
    return kind, spelled(text) if kind == "name" else SIGNS.get(text, text)


def numeral(text: str) -> tuple[Rational, str] | None:
    """Return the number of a numeral, or of a quotient with a whole number, and the letters that follow.

    What follows has not been read. None if the text is longer, is not of this form, or divides by zero.

    Examples
    --------
    >>> numeral("-5/100"), numeral("1.25e-1 kg m^2"), numeral("2*3")
    ((-1/20, ''), (1/8, 'kg m^2'), None)
    """
    if len(text) > SHORT or (found := _NUMERAL.fullmatch(text)) is None:
        return None
    sign, whole, decimals, below_one, exponent, divisor, after = found.groups()
    decimals = below_one or decimals
    top, bottom = int((whole or "") + decimals), int(divisor or 1)
    if bottom == 0:
        return None
    power = int(exponent or 0) - len(decimals)
    if power < 0:
        bottom *= 10**-power
    else:
        top *= 10**power
    common = gcd(top, bottom)
    number = Rational.from_coprime_ints((-top if sign == "-" else top) // common, bottom // common)
    return number, after or ""
