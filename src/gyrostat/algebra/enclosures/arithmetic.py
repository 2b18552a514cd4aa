"""Evaluates an expression in any arithmetic, node by node: floats, functions of a point, balls, bounds."""
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from sympy import Add, Expr, Mul, Pow, Rational


class Arithmetic(NamedTuple):
    """The operations with which an expression is evaluated.

    Parameters
    ----------
    leaf : callable
        the value of a symbol or a number; NotImplemented for a node that has to be taken apart
    sum, product : callable
        of a sequence
    power : callable
        of a base and a rational exponent
    function : callable
        of the node and the values of its arguments; powers with other exponents are functions, too
    """

    leaf: Callable[[Expr], Any]
    sum: Callable[[Sequence[Any]], Any]
    product: Callable[[Sequence[Any]], Any]
    power: Callable[[Any, Rational], Any]
    function: Callable[[Expr, Sequence[Any]], Any]


def in_arithmetic(node: Expr, arithmetic: Arithmetic) -> Any:
    """Return the value of an expression in an arithmetic, by recursion over its tree.

    Examples
    --------
    >>> import math
    >>> from sympy import Integer, Symbol
    >>> numbers = {Symbol("x"): 2, Symbol("y"): 3, Integer(-1): -1}
    >>> leaf = lambda node: numbers.get(node, NotImplemented)
    >>> function = lambda node, parts: getattr(math, str(node.func))(*parts)
    >>> whole = Arithmetic(leaf, sum, math.prod, pow, function)
    >>> in_arithmetic(Symbol("x")**3 * Symbol("y") - 1, whole)
    23
    """
    value = arithmetic.leaf(node)
    if value is not NotImplemented:
        return value
    if isinstance(node, Pow) and isinstance(node.exp, Rational):
        return arithmetic.power(in_arithmetic(node.base, arithmetic), node.exp)
    parts = [in_arithmetic(part, arithmetic) for part in node.args if isinstance(part, Expr)]
    if isinstance(node, Add):
        return arithmetic.sum(parts)
    if isinstance(node, Mul):
        return arithmetic.product(parts)
    return arithmetic.function(node, parts)
