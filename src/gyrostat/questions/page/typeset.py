"""Typesets the blocks of a document as the page shows them: prose, and formulas in LaTeX."""
from collections.abc import Iterable, Sequence
from typing import Any

from sympy import MatrixBase

from ...mechanics.scenes.system import System
from ...notation import NOTATION, dimension_of, symbol
from ...printing.blocks import Block, Display, Heading, Rows
from ...printing.formats.article import NARROW, inline
from ...printing.formats.latex import display, tex
from ...printing.formats.latex_names import Names
from ...printing.formats.linebreaks import broken, width
from ...printing.nomenclature import symbol_rows
from ...typesetting import typeset as in_text

OWN = {"M": "length of the total angular momentum", "sigma": "multiplier of |k| = 1"}


def named(scene: System, name: str, names: Names) -> dict[str, Any]:
    """A symbol, how it is set, what it is in a scene, whether its numbers are positive, and its dimension."""
    known = NOTATION[name].meaning if name in NOTATION else OWN.get(name, "")
    said = next((said for left, said in symbol_rows(scene, [name]).rows
                 if left in ((symbol(name),), (symbol(name), " > 0"))), (known,))
    dimension = dimension_of(name)
    return {"name": name, "tex": tex(symbol(name), names), "text": in_text(name, style="text"),
            "positive": bool(symbol(name).is_positive), "dimension": dimension and list(dimension),
            "meaning": "".join(map(str, said)) + _not_another(name)}


def _not_another(name: str) -> str:
    """That a visitor's own name is not the one of the notation with other capitals; "" if there is none."""
    other = next((known for known in NOTATION if known.casefold() == name.casefold()), name)
    return f"; not {other}: capitals count in names" if other != name else ""


def typeset(blocks: Iterable[Block]) -> list[dict[str, Any]]:
    """Headings, sentences and displays, their formulas in LaTeX."""
    names = Names()
    return [_block(block, names) for block in blocks]


def _block(block: Block, names: Names) -> dict[str, Any]:
    if isinstance(block, Heading):
        return {"heading": block.title, "level": block.level}
    if isinstance(block, Display):
        return {"display": _lines(block, names)}
    if isinstance(block, Rows):
        return {"title": block.title,
                "rows": [[_parts(cell, None, names) for cell in row] for row in block.rows]}
    return {"sentence": _parts(block.parts, block.at, names)}


def _lines(block: Display, names: Names) -> str:
    """A display, which is broken if it is wider than a column."""
    whole = display(block, names)
    if isinstance(block.value, MatrixBase) or width(whole) <= NARROW:
        return whole
    return r"\begin{aligned} & " + r" \\ & \quad ".join(broken(whole, NARROW)) + r" \end{aligned}"


def _parts(parts: Sequence[Any], at: Any, names: Names) -> list[dict[str, str]]:
    """Prose and formulas."""
    return [{"text": part} if isinstance(part, str) else {"tex": inline(tex(part, names, at))}
            for part in parts]
