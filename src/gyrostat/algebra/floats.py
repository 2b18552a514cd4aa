"""Expressions in floats: the value of a formula over arrays, in NumPy or any other array namespace."""
from collections.abc import Mapping
from functools import reduce
from math import e, pi
from typing import Any

import sympy
from numpy.typing import NDArray
from sympy import Add, Expr, Mul, Pow, Rational, S, Symbol

Array = NDArray[Any]


def in_floats(node: Expr, xp: Any, arrays: Mapping[Symbol, Any]) -> Any:
    """A symbol, function or constant in the floats of a namespace.

    Functions are those of the namespace, and no better.
    """
    if isinstance(node, Symbol):
        return arrays[node]
    if isinstance(node, (Rational, sympy.CRootOf)) or node in (S.Pi, S.Exp1):
        return xp.asarray({S.Pi: pi, S.Exp1: e}.get(node) or float(node))
    parts = [in_floats(part, xp, arrays) for part in node.args]
    if isinstance(node, (Add, Mul)):
        return reduce(xp.add if isinstance(node, Add) else xp.multiply, parts)
    if isinstance(node, Pow):
        if node.exp == Rational(1, 2):
            return xp.sqrt(parts[0])
        return (getattr(xp, "pow", None) or xp.power)(*parts)                   # NumPy has pow from 2.1 on
    name = type(node).__name__
    function = getattr(xp, name, None) or getattr(xp, name.replace("a", "arc", 1))
    return function(parts[0])
