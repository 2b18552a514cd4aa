"""Truncated power series in four variables over any ring of numbers: fractions, balls, algebraic numbers."""
import operator
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import lru_cache, reduce
from math import factorial, prod
from typing import Any

from flint import ctx
from sympy import Add, Expr, Mul, Pow, S, Symbol

from ..enclosures.balls import ball

Part = dict[int, Any]                                  # of one degree: coefficients by exponents, 4 bits each
X = Symbol("x", real=True)


class Series:
    """A power series by its homogeneous parts of degree 0 to n; what is above n is dropped.

    Parameters
    ----------
    parts : sequence of dict
        coefficients by exponents, 1 << 4 j for variable j

    Examples
    --------
    >>> from flint import fmpq
    >>> x = variable(0, 2, fmpq(1, 2))
    >>> (x * x).parts
    [{0: 1/4}, {1: 1}, {2: 1}]
    """

    __slots__ = ("parts",)

    def __init__(self, parts: Sequence[Part]):
        self.parts = parts

    def __add__(self, other: "Series") -> "Series":
        return Series([added(dict(a), b) for a, b in zip(self.parts, other.parts)])

    def __sub__(self, other: "Series") -> "Series":
        return self + other.scaled(-1)

    def __mul__(self, other: "Series") -> "Series":
        found: list[Part] = [{} for _ in self.parts]
        for i, a in enumerate(self.parts):
            for j, b in enumerate(other.parts[:len(found) - i]):
                added(found[i + j], product(a, b))
        return Series(found)

    def scaled(self, number: Any) -> "Series":
        """Return the product with a number."""
        return Series([{e: c * number for e, c in part.items()} for part in self.parts])

    def shifted(self, number: Any) -> "Series":
        """Return the sum with a number."""
        return Series([added({0: number}, self.parts[0]), *self.parts[1:]])

    def of(self, coefficients: Sequence[Any]) -> "Series":
        """Return Σ coefficients[n] δⁿ by Horner's rule, where δ is this series without its constant."""
        step, found = Series([{}, *self.parts[1:]]), Series([{} for _ in self.parts])
        for c in reversed(coefficients):
            found = (found * step).shifted(c)
        return found


def variable(place: int, degree: int, start: Any) -> Series:
    """Return start + y, where y is one of the variables."""
    return powers(place, [start, start**0, *[0] * (degree - 1)])


def powers(place: int, coefficients: Sequence[Any]) -> Series:
    """Return Σ coefficients[n] yⁿ, where y is one of the variables."""
    return Series([{} if is_zero(c) and n else {n << 4 * place: c} for n, c in enumerate(coefficients)])


def added(a: Part, b: Part) -> Part:
    """Add the second part to the first, in place, and return it."""
    for e, c in b.items():
        a[e] = a[e] + c if e in a else c
    return a


def is_zero(x: Any) -> bool:
    """Tell whether a number is exactly 0; a ball about 0 is not."""
    return bool(x == 0)


def product(a: Part, b: Part, wanted: Collection[int] | None = None) -> Part:
    """Return the product of two parts, or its wanted terms alone."""
    found: Part = {}
    for e, c in a.items():
        for f, d in b.items():
            if e + f in found:
                found[e + f] += c * d
            elif wanted is None or e + f in wanted:
                found[e + f] = c * d
    return found


def substituted(part: Part, forms: Sequence[Part], wanted: Collection[int] | None = None) -> Part:
    """Insert linear forms for the variables of a part, and return all terms, or the wanted ones alone."""
    if not forms:
        return part
    groups: dict[int, Part] = {}                       # by the exponent of the first variable
    for e, c in part.items():
        groups.setdefault(e & 15, {})[e >> 4] = c
    found: Part = {}
    power: Part = {}
    for exponent in range(max(groups, default=0) + 1):
        if exponent:
            power = product(power, forms[0]) if power else forms[0]
        if group := groups.get(exponent):
            inner = substituted(group, forms[1:], None if power else wanted)
            added(found, product(inner, power, wanted) if power else inner)
    return found


def composed(expression: Expr, places: Mapping[Symbol, Series], number: Callable[[Expr], Any]) -> Series:
    """Expand an expression with series in the place of some symbols.

    Parameters
    ----------
    expression : Expr
        its functions and roots are expanded in balls
    places : mapping of Symbol to Series
    number : callable
        turns an expression in the other symbols into a number of the ring
    """
    if expression in places:
        return places[expression]
    degree = len(next(iter(places.values())).parts) - 1
    inner = [composed(part, places, number) for part in expression.args if part.free_symbols & places.keys()]
    if not inner:
        return Series([{0: number(expression)}, *({} for _ in range(degree))])
    rest = [part for part in expression.args if not part.free_symbols & places.keys()]
    if isinstance(expression, Add):
        return reduce(operator.add, inner).shifted(number(Add(*rest)))
    if isinstance(expression, Mul):
        return prod(inner[1:], start=inner[0]).scaled(number(Mul(*rest)))
    if isinstance(expression, Pow) and expression.exp.is_Integer and expression.exp > 0:
        return prod(inner * (int(expression.exp) - 1), start=inner[0])
    start = inner[0].parts[0].get(0, number(S.Zero))
    if isinstance(expression, Pow) and expression.exp.is_Integer:
        inverse = inner[0].of([(-1) ** n / start ** (n + 1) for n in range(degree + 1)])
        return prod([inverse] * (-int(expression.exp) - 1), start=inverse)
    argument = expression.base if isinstance(expression, Pow) else expression.args[0]
    slopes = _derivatives(expression.xreplace({argument: X}), degree)
    return inner[0].of([ball(slope, ctx.prec, {X: start}) / factorial(n) for n, slope in enumerate(slopes)])


@lru_cache(maxsize=64)
def _derivatives(function: Expr, degree: int) -> list[Expr]:
    """Return a function of X and its derivatives up to a degree."""
    found = [function]
    for _ in range(degree):
        found.append(found[-1].diff(X))
    return found
