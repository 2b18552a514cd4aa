"""Suggests the option or the verb that was meant, if a word is not known."""
import argparse
import re
import sys
from collections.abc import Iterator
from difflib import get_close_matches
from typing import NoReturn

from .output import fitted

_UNKNOWN = re.compile(r"unrecognized arguments: ([^\s=]+)|invalid choice: '([^']*)'")


class Parser(argparse.ArgumentParser):
    """A parser of argparse that asks "did you mean", if a similar word is known.

    If another verb has the option that was typed, the message says so.
    """

    def error(self, message: str) -> NoReturn:
        """End with status 2, the usage and the message on standard error."""
        unknown = _UNKNOWN.search(message)
        word = (unknown[1] or unknown[2]) if unknown else ""
        alike = [known for known in _words(self) if known.startswith("-") == word.startswith("-")]
        near = "".join(f"; did you mean {known}?" for known in get_close_matches(word, alike, 1))
        if word in alike:
            near = f"; {word} is an option of other verbs, see gyrostat VERB --help"
        self.print_usage(sys.stderr)
        self.exit(2, fitted(f"{self.prog}: error: {message}{near}", "  ") + "\n")


def _words(parser: argparse.ArgumentParser) -> Iterator[str]:
    """The options of a parser and of its verbs, and the verbs."""
    for action in parser._actions:
        yield from action.option_strings
        if isinstance(action.choices, dict):
            for verb, its in action.choices.items():
                yield verb
                yield from _words(its)
