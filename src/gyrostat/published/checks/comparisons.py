"""Reads the printed conditions of published files: comparisons joined by "and"."""
import re
from collections import ChainMap
from collections.abc import Mapping
from itertools import chain, zip_longest
from typing import Any

from sympy import Abs, Expr, MatrixBase, Mul, Pow, S, nan, oo, zoo

from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.spelling import RELATIONS
from ...errors import ExpressionError, brief
from ..language import read

COMPARISONS = 30
NEVER = "never"                                        # in place of a condition: it holds nowhere
_COMPARISON = re.compile(r"\s*(<=|>=|<|>)\s*")
# the relations that hold where right − left has a sign
_HOLDING = {1: ("<", "<="), 0: ("<=", ">="), -1: (">", ">=")}


def comparisons(printed: str, names: Mapping[str, Any]) -> list[tuple[Expr, bool]]:
    """Return the comparisons of a text as (margin, strict): margin > 0, or margin ≥ 0.

    A chain a < b < c says a < b, b < c and a < c; abs(x) < c says c² − x² > 0 and c > 0, √x < c
    that c² − x > 0, c > 0 and x ≥ 0.

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> comparisons("0 < a <= 2", {"a": symbol("a")})
    [(a, True), (2, True), (2 - a, False)]
    """
    found: list[tuple[Expr, bool]] = []
    for sides, signs in _chains(printed, names):
        for i in range(len(sides)):
            for j in range(i + 1, len(sides)):
                small, large = (sides[i], sides[j]) if signs[0][0] == "<" else (sides[j], sides[i])
                strict = not all(sign.endswith("=") for sign in signs[i:j])
                found += _margins(small, large, strict)
    return found


def holds_as_printed(printed: str, names: Mapping[str, Any]) -> tuple[bool | None, bool]:
    """Return whether a printed condition holds at numbers, and whether two of its sides are equal.

    The names stand for numbers, and each comparison is read as it is printed. The first answer is None if a
    side is not a real number, or a sign is not proved.

    Examples
    --------
    >>> from sympy import Integer
    >>> holds_as_printed("0 < a <= 2", {"a": Integer(2)}), holds_as_printed("1/a > 0", {"a": Integer(0)})
    ((True, True), (None, False))
    """
    answers: list[bool | None] = []
    equal = False
    try:
        chains = _chains(printed, names)
    except ExpressionError:                                # where it divides by 0, or is not real
        return None, False
    for sides, signs in chains:
        for left, right, relation in zip(sides, sides[1:], signs):
            known = (
                sign_of_constant((right - left).expand())
                if all(_is_real(side) for side in (left, right))
                else None
            )
            equal = equal or known == 0
            answers.append(None if known is None else relation in _HOLDING[known])
    return (None if None in answers else False not in answers), equal


def _is_real(value: Expr) -> bool:
    return not value.free_symbols and value.is_real is not False and not value.has(nan, zoo, oo)


def sides_of(printed: str) -> list[tuple[list[str], list[str]]]:
    """Return the texts of the sides, and the signs between them, of each chain of a condition."""
    pieces = [_COMPARISON.split(part) for part in re.split(r"\band\b", printed.translate(RELATIONS))]
    return [(split[::2], split[1::2]) for split in pieces]


def _chains(printed: str, names: Mapping[str, Any]) -> list[tuple[list[Expr], list[str]]]:
    """Return the sides and the signs of each chain of comparisons, in the order in which they are printed."""
    found = []
    if len(_COMPARISON.findall(printed.translate(RELATIONS))) > COMPARISONS:
        raise ExpressionError(f"cannot read {brief(printed)}: it has more than {COMPARISONS} comparisons")
    for texts, signs in sides_of(printed):
        part = brief(" ".join(chain.from_iterable(zip_longest(texts, signs, fillvalue=""))).strip())
        if not signs:
            raise ExpressionError(f"cannot read {part} as a condition: write left > right, "
                                  "with >, >=, < or <=")
        known = ChainMap({"abs": Abs}, names)  # type: ignore[arg-type]
        sides = [read(text, known) for text in texts]
        if any(isinstance(side, MatrixBase) for side in sides):
            raise ExpressionError(f"cannot read {part} as a condition: a vector or matrix is compared")
        if len({sign[0] for sign in signs}) > 1:
            raise ExpressionError(f"cannot read the chain {part}: all its signs point one way")
        found.append((sides, signs))
    return found


def _margins(small: Expr, large: Expr, strict: bool) -> list[tuple[Expr, bool]]:
    factor, root = small.as_coeff_Mul()
    if isinstance(small, Abs):
        found = [large**2 - small.args[0] ** 2, *([] if large.is_positive else [large])]
    elif isinstance(large, Abs) and small.is_nonnegative:
        found = [large.args[0] ** 2 - small**2]
    elif factor.is_positive and not root.is_positive and all(
            isinstance(x, Pow) and abs(x.exp) == S.Half for x in Mul.make_args(root)):
        return [(large**2 - small**2, strict), (large, strict), (root**2, False)]
    else:
        found = [large - small]
    return [(margin, strict) for margin in found]
