"""The tokens of a text: numbers, names, operators and parentheses."""
import re
from typing import NoReturn

from ..errors import ExpressionError, brief

LENGTH = 5000
_TOKEN = re.compile(r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z][A-Za-z0-9_]*)"
                    r"|(?P<sign>\*\*|[-+*/()]))", re.ASCII)


class Scanner:
    """The tokens of a text, and the place of the next one."""

    TOKEN = _TOKEN
    HINT = "allowed are names, numbers, + - * / ** and parentheses"

    def __init__(self, text: str):
        self.text, self.place = text, 0
        if len(text) > LENGTH:
            raise ExpressionError(f"an expression of {len(text)} characters is longer than the {LENGTH} "
                                  "allowed: shorten it")
        self.tokens = self._scan()

    def _scan(self) -> list[tuple[str, str]]:
        tokens, place, end = [], 0, len(self.text.rstrip())
        while place < end:
            match = self.TOKEN.match(self.text, place)
            if match is None:
                rest = self.text[place:].lstrip()
                hint = "write ** for powers" if rest[0] == "^" else self.HINT
                if comma := re.search(r"(\d+),(\d+)\Z",
                                      self.text[:place] + re.match(r",?\d*", rest)[0]):  # type: ignore[index]
                    hint = f"write a decimal point, {comma[1]}.{comma[2]}"
                self.fail(f"{rest[:12]!r} at character {len(self.text) - len(rest) + 1} is not part of the "
                          "grammar", hint)
            tokens.append((str(match.lastgroup), match[str(match.lastgroup)]))
            place = match.end()
        return tokens

    def fail(self, why: str, todo: str) -> NoReturn:
        raise ExpressionError(f"cannot read {brief(self.text)}: {why}; {todo}") from None

    def peek(self) -> str:
        return self.tokens[self.place][1] if self.place < len(self.tokens) else ""

    def take(self, *wanted: str) -> str:
        if (token := self.peek()) and token in wanted:
            self.place += 1
            return token
        return ""
