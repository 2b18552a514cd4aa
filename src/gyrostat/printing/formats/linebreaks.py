"""Estimates how wide a formula is in LaTeX, in points, and breaks it so that it fits a line."""
import re

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[{}^_&]|\s+|.", re.DOTALL)
_WIDE = {"\\left": 0.0, "\\right": 0.0, "\\bigl": 1.5, "\\bigr": 1.5, "\\quad": 10.0, "\\;": 2.8, "\\,": 1.7,
         "\\displaystyle": 0.0,
         "\\land": 11.0, "\\lor": 11.0, "\\geq": 13.0, "\\leq": 13.0, "\\neq": 13.0, "\\times": 12.0,
         "\\pm": 12.0, "\\prime": 3.0,
         "\\cdot": 7.0, "\\sin": 14.0, "\\cos": 15.0, "\\text": 0.0, "\\dot": 0.0,
         "\\partial": 6.0, "\\nabla": 9.0}
_PLAIN = {"+": 12.2, "-": 12.2, "=": 13.4, "<": 13.4, ">": 13.4, "(": 4.5, ")": 4.5, ",": 4.5, "'": 3.2,
          "|": 3.0}


def width(tex: str) -> float:
    """Estimate the width in points of a formula at 10 pt, in display style.

    Subscripts, superscripts and nested fractions are smaller.

    Examples
    --------
    >>> round(width("a + b"))
    23
    """
    tokens = _TOKEN.findall(tex)
    total, place = 0.0, 0
    while place < len(tokens):
        total, place = _after(tokens, place, total)
    return total


def _after(tokens: list[str], place: int, total: float) -> tuple[float, int]:
    token = tokens[place]
    if token.isspace() or token in "{}":
        return total, place + 1
    if token in ("^", "_"):
        group, end = _group(tokens, place + 1)
        return total + 0.72 * width(group), end
    if token == "\\frac":
        above, middle = _group(tokens, place + 1)
        below, end = _group(tokens, middle)
        return total + 3 + max(width(above), width(below)), end
    if token == "\\sqrt":
        group, end = _group(tokens, place + 1)
        return total + 9 + width(group), end
    if token == "\\begin":
        return _matrix(tokens, place, total)
    if token in ("\\text", "\\mathrm"):
        group, end = _group(tokens, place + 1)
        return total + 5.0 * len(group), end
    return total + _WIDE.get(token, 6.2 if token.startswith("\\") else _PLAIN.get(token, 5.4)), place + 1


def _group(tokens: list[str], place: int) -> tuple[str, int]:
    """Give the argument that starts at a place, without its braces, and where it ends."""
    while tokens[place].isspace():
        place += 1
    if tokens[place] != "{":
        return tokens[place], place + 1
    depth, end = 1, place + 1
    while depth:
        depth += {"{": 1, "}": -1}.get(tokens[end], 0)
        end += 1
    return "".join(tokens[place + 1:end - 1]), end


def _matrix(tokens: list[str], place: int, total: float) -> tuple[float, int]:
    """Add the width of a pmatrix: its widest entry in each column."""
    _, start = _group(tokens, place + 1)
    end = start + next(i for i, token in enumerate(tokens[start:]) if token == "\\end")
    rows = [row.split("&") for row in re.split(r"\\\\(?:\[\w+\])?", "".join(tokens[start:end]))]
    columns = [max(width(row[j]) for row in rows if j < len(row)) for j in range(max(map(len, rows)))]
    _, after = _group(tokens, end + 1)
    return total + sum(columns) + 10 * len(columns) + 6, after


def broken(tex: str, limit: float) -> list[str]:
    """Break a formula into lines of at most the limit, broken before a + or − outside fractions and roots.

    Parentheses may be opened.
    """
    if width(tex) <= limit:
        return [tex]
    pieces, depth, current = list[str](), 0, ""
    for token in _TOKEN.findall(tex.replace(r"\left(", r"\bigl(").replace(r"\right)", r"\bigr)")):
        depth += {"{": 1, "}": -1}.get(token, 0)
        if (
            token in "+-"
            and not depth
            and current.strip()
            and not current.rstrip().endswith(("(", ",", "=", ">", "<", r"\geq", r"\leq"))
        ):
            pieces.append(current)
            current = ""
        current += token
    lines, line = list[str](), ""
    for piece in (*pieces, current):
        if line and width(line + piece) > limit - (20 if lines else 0):
            lines.append(line)
            line = ""
        line += piece
    return [*lines, line]
