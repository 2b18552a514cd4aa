"""Reads formulas of published files: the whitelist grammar with vectors and functions of the motion."""
import re
from collections.abc import Container, Mapping, Sequence
from functools import reduce
from operator import add
from typing import Any

from sympy import Expr, ImmutableMatrix, MatrixBase, Rational
from sympy.matrices.exceptions import MatrixError

from ..algebra.text.bounded_parts import FUNCTIONS, Cost, Part, enclosure, of_expression
from ..algebra.text.grammar import Parser
from ..errors import ExpressionError, GyrostatError, ValuesError, brief

SIDE = 12


class Formula(Parser):
    """Parses a formula: its names come from a scene, and a function may take several arguments."""

    TOKEN = re.compile(Parser.TOKEN.pattern.replace("-+*/()", "-+*/(),"), re.ASCII)
    # of an entry: a tensor in Euler angles has some thousands
    TERMS = 10_000
    HINT = "allowed are names, numbers, + - * / ^ , and parentheses; matrices are lists of texts"

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
            bracket = "; B is the matrix of the bracket here" if base.value == self.names.get("B") else ""
            self.fail(f"a vector or matrix is raised to the power {exponent}",
                      f"matrices have the powers 2 and 3, and inverse(…){bracket}")
        if (
            abs(exponent) > 12
            and isinstance(base.value, Expr)
            and not (base.value.is_Symbol or base.value.is_number)
        ):
            self.fail(f"an expression is raised to the power {exponent}",
                      "powers of names and numbers go up to 100, those of others to 12")
        return super().power(base, exponent)

    def call(self, token: str) -> Part:
        function = self.names.get(token)
        if token in FUNCTIONS or function is None or isinstance(function, (Expr, MatrixBase, Part)):
            if token not in FUNCTIONS:
                offered = [n for n in self.names if self.is_function(n)]
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

    def is_function(self, name: str) -> bool:
        """Return whether a name of the scene stands for a function; one that cannot be derived does not."""
        try:
            value = self.names[name]
        except GyrostatError:
            return False
        return callable(value) and not isinstance(value, (Expr, MatrixBase, Part))

    def arguments(self) -> list[Part]:
        """Return the arguments between the parentheses of a function."""
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
    """Return the bounds of an expression; for a matrix, the largest of each among its entries."""
    costs = [of_expression(entry) for entry in (value if isinstance(value, MatrixBase) else [value])]
    return Cost(*map(max, zip(*costs)))


def read(printed: Any, names: Mapping[str, Any]) -> Any:
    """Read a printed text, or list of texts, as an expression, vector or matrix.

    Parameters
    ----------
    printed : str or (nested) list of str
    names : mapping
        what each name of the scene stands for: Expr, matrix or function

    Raises
    ------
    ExpressionError
        a text is outside the grammar or has an unknown name, or shapes do not fit

    Examples
    --------
    >>> import gyrostat as gs
    >>> read(["2*a", "1"], {"a": gs.symbol("a")}).T
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


def unknown_names(text: str, known: Container[str]) -> list[str]:
    """Return the names in a text that are neither known nor functions of the grammar.

    A text that cannot be cut into tokens has none: it is refused when it is read.

    Examples
    --------
    >>> unknown_names("sqrt(a) + mass*b", {"a", "b"})
    ['mass']
    """
    try:
        tokens = Formula(text, {}).tokens
    except ExpressionError:
        return []
    return [token for kind, token in tokens
            if kind == "name" and token not in known and token not in FUNCTIONS]


def part_of(printed: Any, names: Mapping[str, Any]) -> Part:
    """Read one text with its bounds, so that an abbreviation costs as much as what it is short for."""
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


def decimal(printed: str) -> tuple[Expr, Expr]:
    """Return a printed decimal and half a unit in its last place.

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


