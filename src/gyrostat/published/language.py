"""The formulas of published files.

The whitelist grammar with vectors, functions of the motion and comparisons.
"""
import re
from collections import ChainMap
from collections.abc import Mapping, Sequence
from functools import reduce
from operator import add
from typing import Any

from sympy import Abs, Expr, ImmutableMatrix, MatrixBase, Rational, nan, oo, zoo
from sympy.matrices.exceptions import MatrixError

from ..algebra.exact import sign_of_constant
from ..algebra.grammar import Parser
from ..algebra.parts import FUNCTIONS, Cost, Part, enclosure, of_expression
from ..errors import ExpressionError, GyrostatError, ValuesError, brief

SIDE, COMPARISONS = 12, 30
_COMPARISON = re.compile(r"\s*(<=|>=|<|>)\s*")


class Formula(Parser):
    """Names come from a scene; a function may be one of its functions and take several arguments."""

    TOKEN = re.compile(Parser.TOKEN.pattern.replace("-+*/()", "-+*/(),"), re.ASCII)
    # of an entry: a tensor in Euler angles has some thousands
    TERMS = 10_000
    HINT = "allowed are names, numbers, + - * / ** , and parentheses; matrices are lists of texts"

    def __init__(self, text: str, names: Mapping[str, Any]):
        self.names = names
        super().__init__(text)

    def named(self, token: str) -> Part:
        if token in FUNCTIONS or token not in self.names:
            return super().named(token) if token in FUNCTIONS else self.fail(
                f"{token} is not a name of this scene", "its names are " + ", ".join(sorted(self.names)))
        value = self.names[token]
        if isinstance(value, Part):                        # an abbreviation costs what it stands for
            return value
        if callable(value) and not isinstance(value, (Expr, MatrixBase)):
            self.fail(f"the function {token} has no argument", f"write {token}(...)")
        return self.bounded(value, _cost(value), 0, None)

    def total(self, values: Sequence[Any]) -> Any:
        return (
            reduce(add, values)
            if any(isinstance(value, MatrixBase) for value in values)
            else super().total(values)
        )

    def power(self, base: Part, exponent: Rational) -> Part:
        if isinstance(base.value, MatrixBase) and exponent not in (2, 3):
            self.fail(f"a vector or matrix is raised to the power {exponent}",
                      "matrices have the powers 2 and 3, and inverse(…)")
        if (
            abs(exponent) > 12
            and isinstance(base.value, Expr)
            and not (base.value.is_Symbol or base.value.is_number)
        ):
            self.fail(f"an expression is raised to the power {exponent}",
                      "those of names and numbers go up to 100, others to 12")
        return super().power(base, exponent)

    def call(self, token: str) -> Part:
        function = self.names.get(token)
        if token in FUNCTIONS or function is None or isinstance(function, (Expr, MatrixBase, Part)):
            if token not in FUNCTIONS:
                offered = [n for n, v in self.names.items() if callable(v)
                           and not isinstance(v, (Expr, MatrixBase, Part))]
                self.fail(f"{token} is not a function of this scene",
                          self.guess(token, sorted({*offered, *FUNCTIONS})))
            (inner, *others) = self.arguments()
            if others or isinstance(inner.value, MatrixBase):
                self.fail(f"{token} takes one number", "check its argument")
            return self.apply(token, inner)
        arguments = self.arguments()
        if token in ("sn", "cn", "dn", "polhode_period") and any(
            isinstance(part.value, MatrixBase) for part in arguments
        ):
            self.fail(f"{token} takes numbers", "check its arguments")
        value = function(*(part.value for part in arguments))
        nesting = max(part.nesting for part in arguments) + (token in ("sn", "cn", "dn"))
        return self.bounded(value, _cost(value), nesting, None)

    def arguments(self) -> list[Part]:
        """What stands between the parentheses of a function."""
        self.take("(")
        found = [self.sum()]
        while self.take(","):
            found.append(self.sum())
        if not self.take(")"):
            self.fail("a closing parenthesis is missing", "close what you opened")
        self.called("write it as several formulas")
        return found

    def bounded(self, value: Any, cost: Cost, nesting: int, ball: Any) -> Part:
        if isinstance(value, MatrixBase):
            value, cost = ImmutableMatrix(value), _cost(value)
        elif ball is None and isinstance(value, Expr) and value.is_number:
            ball = enclosure(value)
        return super().bounded(value, cost, nesting, ball)


def _cost(value: Any) -> Cost:
    """The largest of the entries of a matrix, or of an expression."""
    costs = [of_expression(entry) for entry in (value if isinstance(value, MatrixBase) else [value])]
    return Cost(*map(max, zip(*costs)))


def read(printed: Any, names: Mapping[str, Any]) -> Any:
    """The expression, vector or matrix that a printed text, or list of texts, stands for.

    Parameters
    ----------
    printed : str or (nested) list of str
    names : mapping
        what each name of the scene stands for: Expr, matrix or function

    Raises
    ------
    ExpressionError
        outside the grammar, an unknown name, or shapes that do not fit

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> read(["2*a", "1"], {"a": symbol("a")}).T
    Matrix([[2*a, 1]])
    """
    if isinstance(printed, list):
        if max(len(printed), *(len(row) for row in printed if isinstance(row, list)), 0) > SIDE:
            raise ExpressionError(f"cannot read a list of {len(printed)} rows: vectors and matrices have "
                                  f"up to {SIDE} rows and columns")
        rows = [[read(entry, names) for entry in row] if isinstance(row, list) else [read(row, names)]
                for row in printed]
        if not rows or any(len(row) != len(rows[0]) for row in rows):
            raise ExpressionError(f"cannot read a list of {len(rows)} rows of lengths "
                                  f"{[len(r) for r in rows]}: rows have one length")
        return ImmutableMatrix(rows)
    return part_of(printed, names).value


def part_of(printed: Any, names: Mapping[str, Any]) -> Part:
    """What one text stands for, with its bounds: so an abbreviation costs as much as what it is short for."""
    if not isinstance(printed, str):
        raise ExpressionError(f"cannot read {brief(printed)}, a {type(printed).__name__}: formulas are "
                              "texts, write \"...\"")
    try:
        return Formula(printed, names).whole()
    except GyrostatError:
        raise
    except (ArithmeticError, AttributeError, IndexError, MatrixError, NotImplementedError, RecursionError,
            TypeError, ValueError) as error:
        raise ExpressionError(f"cannot read {brief(printed)}: vectors, matrices and numbers do not fit "
                              "together there"
                              f"{f' ({brief(str(error))})' if str(error) else ''}") from None


def comparisons(printed: str, names: Mapping[str, Any]) -> list[tuple[Expr, bool]]:
    """The comparisons of a text joined by "and", as (margin, strict): margin > 0, or margin ≥ 0.

    A chain a < b < c says a < b, b < c and a < c; abs(x) < c says c² − x² > 0 and c > 0.

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
                found += [(margin, strict) for margin in _margins(small, large)]
    return found


def holds_as_printed(printed: str, names: Mapping[str, Any]) -> tuple[bool | None, bool]:
    """Whether the comparisons of a text hold where its names are numbers, each as it is read, and whether two
    of its sides are equal.

    None where a side is not a real number, or a sign is not proved.

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
            answers.append(None if known is None else known == (1 if relation[0] == "<" else -1)
                           or (known == 0 and relation[1:] == "="))
    return (None if None in answers else False not in answers), equal


def _is_real(value: Expr) -> bool:
    return not value.free_symbols and value.is_real is not False and not value.has(nan, zoo, oo)


def _chains(printed: str, names: Mapping[str, Any]) -> list[tuple[list[Expr], list[str]]]:
    """The sides and the signs of each chain of comparisons, in the order in which they are printed."""
    found = []
    if len(_COMPARISON.findall(printed)) > COMPARISONS:
        raise ExpressionError(f"cannot read {brief(printed)}: it has more than {COMPARISONS} comparisons")
    for part in re.split(r"\band\b", printed):
        pieces = _COMPARISON.split(part)
        if len(pieces) < 3:
            raise ExpressionError(f"cannot read {brief(part.strip())} as a condition: write left > right, "
                                  "with >, >=, < or <=")
        known = ChainMap({"abs": Abs}, names)  # type: ignore[arg-type]
        sides = [read(piece, known) for piece in pieces[::2]]
        if any(isinstance(side, MatrixBase) for side in sides):
            raise ExpressionError(f"cannot read {brief(part.strip())} as a condition: a vector or matrix "
                                  "is compared")
        signs = pieces[1::2]
        if len({sign[0] for sign in signs}) > 1:
            raise ExpressionError(f"cannot read the chain {brief(part.strip())}: all its signs point one way")
        found.append((sides, signs))
    return found


def _margins(small: Expr, large: Expr) -> list[Expr]:
    if isinstance(small, Abs):
        return [large**2 - small.args[0] ** 2, *([] if large.is_positive else [large])]
    if isinstance(large, Abs) and small.is_nonnegative:
        return [large.args[0] ** 2 - small**2]
    return [large - small]


def decimal(printed: str) -> tuple[Expr, Expr]:
    """A printed decimal and half a unit in its last place.

    Examples
    --------
    >>> decimal("0.28")
    (7/25, 1/200)
    """
    match = re.fullmatch(r"[-+]?\d*\.?(\d*)", printed)
    if match is None or len(printed) > 400 or not any(c.isdigit() for c in printed):
        raise ValuesError(f"{brief(printed)} is not a decimal number: write it with the digits that are "
                          "printed")
    return Rational(printed), Rational(1, 2 * 10 ** len(match[1]))


