"""Evaluates expressions in floats, over arrays of NumPy or of any other array namespace."""
from collections.abc import Mapping, Sequence
from functools import partial, reduce
from math import e, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import CRootOf, Expr, Pow, Rational, S, Symbol

from ...arguments import MOST
from ...errors import ValuesError, brief
from .arithmetic import Arithmetic, in_arithmetic

Array = NDArray[Any]


def doubles(given: Any, what: str) -> Array:
    """Return finite doubles from what is given as an array of any shape.

    Raises
    ------
    ValuesError
        an entry is not a number, or not a finite double

    Examples
    --------
    >>> doubles([1, "0.5"], "the times").tolist()
    [1.0, 0.5]
    """
    if not hasattr(given, "dtype") and hasattr(given, "__len__") and len(given) > MOST:
        raise ValuesError(f"{what} = {brief(given)} has {len(given)} entries: give up to {MOST}, or an array")
    try:
        found = np.asarray(given, dtype=float)
    except (TypeError, ValueError, OverflowError, MemoryError) as error:
        raise ValuesError(f"{what} = {brief(given)} cannot be read as doubles ({brief(str(error))[1:-1]}): "
                          "give finite numbers below 1.8e308") from None
    if not np.isfinite(found).all():
        raise ValuesError(f"a number of {what} is not finite: give finite numbers")
    return found


def row(given: Any, what: str) -> Array:
    """Return finite doubles from what is given as a row, shape (n,), n > 0.

    Raises
    ------
    ValuesError
        there are none, or they are not a row; or as for doubles
    """
    found = doubles(given, what)
    if found.ndim != 1 or not found.size:
        raise ValuesError(f"{what}: the shape {found.shape} is not that of a row: give a row of numbers")
    return found


def in_floats(expression: Expr, xp: Any, arrays: Mapping[Symbol, Any]) -> Any:
    """Evaluate an expression in the floats of a namespace, by its own functions and no better.

    Examples
    --------
    >>> import numpy as np
    >>> x = Symbol("x")
    >>> in_floats(x**2 - 1, np, {x: np.array([1.0, 3.0])}).tolist()
    [0.0, 8.0]
    """
    def leaf(node: Expr) -> Any:
        if isinstance(node, Symbol):
            return arrays[node]
        if isinstance(node, (Rational, CRootOf)):
            return xp.asarray(float(node))
        if node is S.Pi or node is S.Exp1:
            return xp.asarray(pi if node is S.Pi else e)
        return NotImplemented

    def power(base: Any, exponent: Any) -> Any:
        return (getattr(xp, "pow", None) or xp.power)(base, exponent)           # NumPy has pow from 2.1 on

    def raised(base: Any, exponent: Rational) -> Any:
        return xp.sqrt(base) if exponent is S.Half else power(base, leaf(exponent))

    def function(node: Expr, parts: Sequence[Any]) -> Any:
        if isinstance(node, Pow):
            return power(*parts)
        name = type(node).__name__
        return (getattr(xp, name, None) or getattr(xp, name.replace("a", "arc", 1)))(parts[0])

    return in_arithmetic(expression, Arithmetic(leaf, partial(reduce, xp.add), partial(reduce, xp.multiply),
                                                raised, function))
