"""Reads vectors and tensors as engineers write them, with one unit, and settings NAME=VALUE in a text.

A vector is three entries with commas between them, a tensor three rows in brackets or between semicolons.
"""
import re

from ...errors import ExpressionError, brief
from .quantities import units_in
from .scanner import numeral

_WHOLE = re.compile(r"\s*\[(.*)\]([^\[\],;]*)", re.DOTALL)
_ROW = re.compile(r"\[([^\[\]]*)\]")
_SETTING = re.compile(r"(?:^|[\s,])\s*([A-Za-z_]\w*)\s*=")


def rows_of(text: str) -> list[str] | list[list[str]]:
    """Return the texts of a vector, or of each row of a matrix, every one with its unit.

    A unit that stands after the brackets, or after the last entry alone, is that of all entries. Commas are
    between the entries, or blanks in brackets, and semicolons or brackets between the rows.

    Parameters
    ----------
    text : str
        "62.1, 58, 30 kg m^2", "[[62.1, 1.3, 0], [1.3, 58, 0], [0, 0, 30]] kg m^2", "62,1,0;1,58,0;0,0,30"

    Returns
    -------
    list of str, or of lists of str

    Raises
    ------
    ExpressionError
        the brackets are not those of rows

    Examples
    --------
    >>> rows_of("62.1, 58, 30 kg m^2")
    ['62.1 kg m^2', '58 kg m^2', '30 kg m^2']
    >>> rows_of("[[2, 1], [1, a]]")
    [['2', '1'], ['1', 'a']]
    """
    if (whole := _WHOLE.fullmatch(text)) is None:
        rows = [row.split(",") for row in text.split(";")]
        unit = _only_unit([entry for row in rows for entry in row])
        rows[-1][-1] = rows[-1][-1].strip().removesuffix(unit)
    else:
        inner, unit = whole[1], whole[2].strip()
        if re.sub(r"[\s,;]+", "", _ROW.sub("", inner)) and "[" in inner:
            raise ExpressionError(f"cannot read {brief(text)}: its brackets are not those of rows; write "
                                  "[[1, 0, 0], [0, 2, 0], [0, 0, 3]] and a unit after the last one")
        texts = _ROW.findall(inner) if "[" in inner else inner.split(";")
        rows = [row.split(",") if "," in row else row.split() for row in texts]
    found = [[_with(unit, entry.strip()) for entry in row] for row in rows]
    return found if len(found) > 1 else found[0] if found else []


def _only_unit(entries: list[str]) -> str:
    """Return the unit of the last number, if no other one has a unit."""
    *others, last = (numeral(entry.strip()) for entry in entries)
    alone = last is not None and others and not any(x is None or x[1] for x in others)
    return last[1] if last is not None and alone and units_in(last[1]) else ""


def _with(unit: str, entry: str) -> str:
    """Return an entry with a unit; an expression needs parentheses before it."""
    if not unit:
        return entry
    return f"{entry} {unit}" if numeral(entry) else f"({entry}) {unit}"


def settings_in(text: str) -> dict[str, str] | None:
    """Return the values of a text NAME=VALUE NAME=VALUE by their names; None if it is none.

    Blanks or commas are between them.

    Examples
    --------
    >>> settings_in("axis=0,0,1 inertia=0.01 kg m^2, speed=3000 rpm")
    {'axis': '0,0,1', 'inertia': '0.01 kg m^2', 'speed': '3000 rpm'}
    >>> settings_in("0.0011 rad/s") is settings_in("mu=1, mu=2") is None
    True
    """
    before, *parts = _SETTING.split(text)
    names = parts[::2]
    if not parts or before.strip(" ,\t\n") or len(set(names)) < len(names) or text.count("=") > len(names):
        return None
    return {name: value.strip().rstrip(",").rstrip() for name, value in zip(names, parts[1::2])}
