"""How LaTeX is asked for: --symbols, --label, --fragment."""
import argparse

from ...algebra.text.inputs import is_name
from ...errors import ValuesError, brief
from ...printing.formats.latex_names import Paper


def paper_of(given: argparse.Namespace) -> Paper:
    """What a paper has of its own."""
    symbols: dict[str, str] = {}
    for setting in given.symbols:
        name, equals, symbol = setting.partition("=")
        if not equals or not is_name(name):
            raise ValuesError(f"--symbols {brief(setting)[1:-1]} is not NAME=LATEX: write, for example, "
                              "--symbols I1=A 'l=\\sigma'")
        if name in symbols:
            raise ValuesError(f"--symbols gives {name} twice: give it once")
        symbols[name] = symbol
    return Paper(symbols, given.label or "gyrostat", given.fragment)
