"""Interval arithmetic on arrays: enclosures of expressions on many boxes at once.

It is rounded outward after every operation.
"""
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from flint import arb
from sympy import Expr, Pow, Rational, Symbol, diff

from ..algebra.balls import ball
from ..algebra.double_double import two_sum
from ..algebra.exact import sign_of_constant
from ..algebra.floats import Array
from ..algebra.precision import own_precision
from .straightline import program_of

# bits of the enclosures that are rounded to float64
PRECISION = 64
# Functions that are monotone between two points of their domain; all others are enclosed as balls.
_SLOPES = dict.fromkeys("exp log sinh tanh asin atan asinh acosh atanh".split(), 1) | {"acos": -1}
_FUNCTIONS = {*_SLOPES, "sin", "cos", "tan", "cosh"}


@dataclass(frozen=True, eq=False)
class Enclosure:
    """Bounds of a quantity, an entry for each box; (−∞, ∞) where nothing is known, never NaN.

    Parameters
    ----------
    low, high : array, shape (boxes,) or ()
    """

    low: Array
    high: Array

    @cached_property
    def short(self) -> Array:
        """Whether both ends are numbers of single precision: their products are exact in double precision."""
        low, high = np.asarray(self.low), np.asarray(self.high)
        return (low.astype(np.float32) == low) & (high.astype(np.float32) == high)

    def __and__(self, other: "Enclosure") -> "Enclosure":
        """What two enclosures of one quantity say together."""
        return Enclosure(np.maximum(self.low, other.low), np.minimum(self.high, other.high))


Box = Mapping[Symbol, Enclosure]


def _outward(low: Array, high: Array, low_exact: Array | bool = False,
             high_exact: Array | bool = False) -> Enclosure:
    """Bounds that were rounded to nearest, moved by one float unless they are exact.

    The whole line where an operation was undefined.
    """
    low, high = (
        np.where(low_exact, low, np.nextafter(low, -np.inf)),
        np.where(high_exact, high, np.nextafter(high, np.inf)),
    )
    return Enclosure(np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high))


def _sum(a: Array, b: Array) -> tuple[Array, Array]:
    """a + b, and whether it is exact: its error, which Knuth's two-sum gives, is 0.

    NaN where it overflows.
    """
    total, error = two_sum(a, b)
    return total, error == 0


class Outward:
    """The arithmetic of enclosures, for straight-line programs.

    Exact where a sum, or a product of short numbers, is exact.

    Examples
    --------
    >>> third = enclosed(Rational(1, 3))
    >>> one = Outward.multiply(enclosed(Rational(3)), third)
    >>> bool(one.low < 1 < one.high)
    True
    """

    @staticmethod
    def add(a: Enclosure, b: Enclosure) -> Enclosure:
        (low, low_exact), (high, high_exact) = _sum(a.low, b.low), _sum(a.high, b.high)
        return _outward(low, high, low_exact, high_exact)

    @staticmethod
    def subtract(a: Enclosure, b: Enclosure) -> Enclosure:
        return Outward.add(a, Outward.negative(b))

    @staticmethod
    def negative(a: Enclosure) -> Enclosure:
        return Enclosure(-a.high, -a.low)

    @staticmethod
    def multiply(a: Enclosure, b: Enclosure) -> Enclosure:
        """The product; of one and the same quantity the square, which is not negative."""
        exact = a.short & b.short
        if a is b:
            one, other = a.low * a.low, a.high * a.high
            square = _outward(np.minimum(one, other), np.maximum(one, other), exact, exact)
            return Enclosure(np.where((a.low > 0) | (a.high < 0), np.maximum(square.low, 0), 0.0),
                             square.high)
        products = a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high
        low, high = (bound(bound(*products[:2]), bound(*products[2:])) for bound in (np.minimum, np.maximum))
        return _outward(low, high, exact, exact)

    @staticmethod
    def reciprocal(a: Enclosure) -> Enclosure:
        """1/x, the whole line where 0 is not excluded."""
        inverse = _outward(1 / a.high, 1 / a.low)
        apart = (a.low > 0) | (a.high < 0)
        return Enclosure(np.where(apart, inverse.low, -np.inf), np.where(apart, inverse.high, np.inf))


def enclosure(expression: Expr, box: Box) -> Enclosure:
    """Bounds of an expression on each box, by one evaluation in the arithmetic of enclosures.

    Parameters
    ----------
    expression : Expr
        in the symbols of box, and functions of them
    box : mapping of Symbol to Enclosure
        all of one shape

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> x = symbol("x")
    >>> bounds = enclosure(x**2 - 2, {x: Enclosure(np.array([-1.0, 2.0]), np.array([1.0, 3.0]))})
    >>> bounds.low.round(3).tolist(), bounds.high.round(3).tolist()
    ([-2.0, 2.0], [-1.0, 7.0])
    """
    axes = {name: frozenset((place,)) for place, name in enumerate(box)}

    def leaf(node: Expr) -> Enclosure:
        return (
            box[node]
            if isinstance(node, Symbol)
            else _function(node, box)
            if node.free_symbols
            else enclosed(node)
        )

    with np.errstate(all="ignore"):
        return program_of(expression, axes).run(leaf, enclosed, Outward)[-1]


def sharpened(expression: Expr, natural: Enclosure, box: Box,
              slopes: Mapping[Symbol, Enclosure]) -> Enclosure:
    """The natural enclosure and the mean value form together.

    Its excess falls with the square of the width of the box.

    f(x) = f(c) + Σ ∂f/∂xᵢ(ξ) (xᵢ − cᵢ) with c and ξ in the box, where f is defined on the whole box.
    """
    middle = {}
    for name, sides in box.items():
        point = np.clip(sides.low / 2 + sides.high / 2, sides.low, sides.high)
        middle[name] = Enclosure(point, point)
    mean = enclosure(expression, middle)
    with np.errstate(all="ignore"):
        for name, slope in slopes.items():
            mean = Outward.add(mean, Outward.multiply(slope, Outward.subtract(box[name], middle[name])))
    defined = np.isfinite(natural.low) & np.isfinite(natural.high)
    return natural & Enclosure(np.where(defined, mean.low, -np.inf), np.where(defined, mean.high, np.inf))


@lru_cache(maxsize=1024)
def derivative(expression: Expr, name: Symbol) -> Expr:
    """∂/∂name, derived once."""
    return diff(expression, name)


@lru_cache(maxsize=4096)
def rounded(number: Expr) -> tuple[float, float]:
    """The greatest float that is not above an exact real number and the least that is not below it, infinite
    beyond the range.

    Examples
    --------
    >>> from sympy import S, sqrt
    >>> rounded(S.Half), rounded(sqrt(2)), rounded(Rational(10)**400)
    ((0.5, 0.5), (1.414213562373095, 1.4142135623730951), (1.7976931348623157e+308, inf))
    """
    low, high = _bounds(ball(number, 2 * PRECISION), ball(number, 2 * PRECISION))
    # a few floats at most, unless the number is not known so well
    for _ in range(4):
        if _not_below(number, above := math.nextafter(low, math.inf)):
            low = above
        if _not_below(-number, above := math.nextafter(-high, math.inf)):
            high = -above
    return low + 0.0, high + 0.0                           # 0, not -0


def _not_below(number: Expr, bound: float) -> bool:
    return math.isfinite(bound) and sign_of_constant(number - Rational(*bound.as_integer_ratio())) in (0, 1)


def enclosed(constant: Expr) -> Enclosure:
    """An exact constant, between neighbouring floats."""
    low, high = rounded(constant)
    return Enclosure(np.asarray(low), np.asarray(high))


def _function(node: Expr, box: Box) -> Enclosure:
    """A function of an argument that is enclosed first."""
    if isinstance(node, Pow) and isinstance(node.exp, Rational):
        return _power(enclosure(node.base, box), int(node.exp.p), int(node.exp.q))
    name = type(node).__name__
    if name not in _FUNCTIONS or len(node.args) != 1:
        return Enclosure(np.asarray(-np.inf), np.asarray(np.inf))
    return _each(name, enclosure(node.args[0], box))


def _power(base: Enclosure, p: int, q: int) -> Enclosure:
    """The power p of the root q."""
    if q == 2:
        root = _outward(np.sqrt(base.low), np.sqrt(base.high))
        base = Enclosure(np.where(base.low >= 0, np.maximum(root.low, 0), -np.inf),
                         np.where(base.low >= 0, root.high, np.inf))
    elif q > 2:
        base = _each(str(q), base)
    result = base
    for bit in f"{abs(p):b}"[1:]:
        result = Outward.multiply(result, result)
        result = Outward.multiply(result, base) if bit == "1" else result
    return result if p > 0 else Outward.reciprocal(result)


def _each(name: str, argument: Enclosure) -> Enclosure:
    """A function on arrays, once for each interval that occurs."""
    both = np.empty(argument.low.shape, complex)
    both.real, both.imag = argument.low, argument.high
    distinct, place = np.unique(both, return_inverse=True)
    values = np.array([_at(name, float(z.real), float(z.imag))
                       for z in distinct]).reshape(-1, 2)[place.reshape(both.shape)]
    return Enclosure(values[..., 0], values[..., 1])


@lru_cache(maxsize=2**16)
def _at(name: str, low: float, high: float) -> tuple[float, float]:
    """Bounds of a function on one interval.

    From its ends where it is monotone, else from the ball that contains the interval.
    """
    if not (math.isfinite(low) and math.isfinite(high)):
        return -np.inf, np.inf
    with own_precision(PRECISION):
        a, b = arb(low), arb(high)
        if name.isdigit():
            return _bounds(a.root(int(name)), b.root(int(name)))
        slope = _SLOPES.get(name, 0)
        a, b = (a, b) if slope > 0 else (b, a) if slope < 0 else (a.union(b),) * 2
        return _bounds(getattr(a, name)(), getattr(b, name)())


def _bounds(low: arb, high: arb) -> tuple[float, float]:
    """Floats below one ball and above the other; the whole line where one is not finite."""
    if not (low.is_finite() and high.is_finite()):
        return -np.inf, np.inf
    return math.nextafter(float(low.lower()), -math.inf), math.nextafter(float(high.upper()), math.inf)

