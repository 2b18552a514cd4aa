"""Encloses expressions on many boxes at once: by natural extension, and by the mean value form."""
import math
from collections.abc import Mapping
from functools import lru_cache

import numpy as np
from flint import arb
from sympy import Expr, Pow, Rational, Symbol, diff

from ...algebra.enclosures.precision import own_precision
from ..programs.straightline import program_of
from .intervals import PRECISION, Enclosure, bounds_of, enclosed, outward

Box = Mapping[Symbol, Enclosure]
# Functions that are monotone between two points of their domain; all others are enclosed as balls.
_SLOPES = dict.fromkeys("exp log sinh tanh asin atan asinh acosh atanh".split(), 1) | {"acos": -1}
_FUNCTIONS = {*_SLOPES, "sin", "cos", "tan", "cosh"}


def enclosure(expression: Expr, box: Box) -> Enclosure:
    """Return bounds of an expression on each box, by one evaluation in the arithmetic of enclosures.

    Parameters
    ----------
    expression : Expr
        in the symbols of box, and functions of them
    box : mapping of Symbol to Enclosure
        all of one shape

    Returns
    -------
    Enclosure

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> x = symbol("x")
    >>> two = Enclosure(np.array([-1.0, 2.0]), np.array([1.0, 3.0]))
    >>> bounds = enclosure(x**2 - 2, {x: two})
    >>> bounds.low.round(3).tolist(), bounds.high.round(3).tolist()
    ([-2.0, 2.0], [-1.0, 7.0])
    """
    axes = {name: frozenset((place,)) for place, name in enumerate(box)}

    def leaf(node: Expr) -> Enclosure:
        if isinstance(node, Symbol):
            return box[node]
        return _function(node, box) if node.free_symbols else enclosed(node)

    with np.errstate(all="ignore"):
        return program_of(expression, axes).run(leaf, enclosed)[-1]


def sharpened(expression: Expr, natural: Enclosure, box: Box,
              slopes: Mapping[Symbol, Enclosure]) -> Enclosure:
    """Return the natural enclosure and the mean value form together.

    f(x) = f(c) + Σ ∂f/∂xᵢ(ξ) (xᵢ − cᵢ) with c and ξ in the box, if f is defined on the whole box. The excess
    of this form falls with the square of the width of the box, that of the natural enclosure with the width.

    References
    ----------
    Moore, Kearfott & Cloud, Introduction to Interval Analysis (2009), chapter 6.
    """
    middle = {}
    for name, sides in box.items():
        point = np.clip(sides.low / 2 + sides.high / 2, sides.low, sides.high)
        middle[name] = Enclosure(point, point)
    mean = enclosure(expression, middle)
    with np.errstate(all="ignore"):
        for name, slope in slopes.items():
            mean = mean + slope * (box[name] - middle[name])
    return natural & mean.where(np.isfinite(natural.low) & np.isfinite(natural.high))


@lru_cache(maxsize=1024)
def derivative(expression: Expr, name: Symbol) -> Expr:
    """Return the derivative by a name, derived once."""
    return diff(expression, name)


def _function(node: Expr, box: Box) -> Enclosure:
    """Return the enclosure of a function, whose argument is enclosed first."""
    if isinstance(node, Pow) and isinstance(node.exp, Rational):
        return _power(enclosure(node.base, box), int(node.exp.p), int(node.exp.q))
    name = type(node).__name__
    if name not in _FUNCTIONS or len(node.args) != 1:
        return Enclosure(np.asarray(-np.inf), np.asarray(np.inf))
    return _each(name, enclosure(node.args[0], box))


def _power(base: Enclosure, p: int, q: int) -> Enclosure:
    """Return the enclosure of the power p of the root q."""
    if q == 2:
        root = outward(np.sqrt(base.low), np.sqrt(base.high))
        base = Enclosure(np.maximum(root.low, 0), root.high).where(base.low >= 0)
    elif q > 2:
        base = _each(str(q), base)
    result = base
    for bit in f"{abs(p):b}"[1:]:
        result = result * result
        result = result * base if bit == "1" else result
    return result if p > 0 else result.reciprocal()


def _each(name: str, argument: Enclosure) -> Enclosure:
    """Return the enclosure of a function on arrays, computed once for each interval that occurs."""
    both = np.empty(argument.low.shape, complex)
    both.real, both.imag = argument.low, argument.high
    distinct, place = np.unique(both, return_inverse=True)
    values = np.array([_at(name, float(z.real), float(z.imag))
                       for z in distinct]).reshape(-1, 2)[place.reshape(both.shape)]
    return Enclosure(values[..., 0], values[..., 1])


@lru_cache(maxsize=2**16)
def _at(name: str, low: float, high: float) -> tuple[float, float]:
    """Return bounds of a function on one interval.

    They come from its ends if it is monotone, else from the ball that contains the interval.
    """
    if not (math.isfinite(low) and math.isfinite(high)):
        return -np.inf, np.inf
    with own_precision(PRECISION):
        a, b = arb(low), arb(high)
        if name.isdigit():
            return bounds_of(a.root(int(name)), b.root(int(name)))
        slope = _SLOPES.get(name, 0)
        a, b = (a, b) if slope > 0 else (b, a) if slope < 0 else (a.union(b),) * 2
        return bounds_of(getattr(a, name)(), getattr(b, name)())
