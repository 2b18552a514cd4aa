"""An expression in another arithmetic, node by node: floats, functions of a point, enclosures, bounds."""
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from sympy import Add, Expr, Mul, Pow, Rational


class Arithmetic(NamedTuple):
    """What an expression is written in.

    Parameters
    ----------
    leaf : callable
        what stands for a symbol or a number; NotImplemented for what has to be taken apart
    sum, product : callable
        of a sequence
    power : callable
        of a base and a rational exponent
    function : callable
        of the node and what stands for its arguments; other powers are functions, too
    """

    leaf: Callable[[Expr], Any]
    sum: Callable[[Sequence[Any]], Any]
    product: Callable[[Sequence[Any]], Any]
    power: Callable[[Any, Rational], Any]
    function: Callable[[Expr, Sequence[Any]], Any]


def in_arithmetic(node: Expr, arithmetic: Arithmetic) -> Any:
    """What an expression is in an arithmetic.

    Examples
    --------
    >>> import math
    >>> from sympy import Symbol
    >>> numbers = {Symbol("x"): 2, Symbol("y"): 3}
    >>> leaf = lambda node: int(node) if node.is_Number else numbers.get(node, NotImplemented)
    >>> function = lambda node, parts: getattr(math, node.func.__name__)(*parts)
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
