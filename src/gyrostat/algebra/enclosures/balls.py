"""Ball arithmetic: enclosures of expressions to any precision, and the fractions that describe them."""
import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType

import sympy
from flint import arb, ctx
from sympy import Add, CRootOf, Expr, Float, Mul, Pow, Rational, Symbol

from .algebraic import real_root
from .precision import own_precision
from .rationals import to_flint

FARTHEST = 8192                                        # bits at which a number is told from 0
NOTHING: Mapping[Symbol, arb] = MappingProxyType({})
FUNCTIONS: dict[str, Callable[[arb], arb]] = {name: getattr(arb, name) for name in (
    "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh",
    "atanh")}


class Enclosed(Expr):
    """A real constant that computes its own enclosure."""

    is_commutative = is_real = is_number = True

    def enclosed(self, precision: int) -> arb:
        """Return an enclosure that is computed with so many bits."""
        raise NotImplementedError

    def _eval_evalf(self, prec: int) -> Float:
        middle = finite_ball(self, prec + 16).mid()
        return Float(middle.str(int(prec * 0.302) + 4, radius=False), precision=prec)


def ball(expression: Expr, precision: int, values: Mapping[Symbol, arb] = NOTHING) -> arb:
    """Enclose a real expression in ball arithmetic; the ball is not finite if it may be undefined.

    Parameters
    ----------
    expression : Expr
    precision : int
        bits
    values : mapping of Symbol to arb
        enclosures of its symbols
    """
    with own_precision(precision):
        return +_ball(expression, values)


def finite_ball(number: Expr, precision: int) -> arb:
    """Enclose an exact number at this precision, or at a higher one if roots are not isolated at this one.

    The precision is doubled until the ball is finite, or 8192 bits are reached.
    """
    while not (enclosure := ball(number, precision)).is_finite() and precision < FARTHEST:
        precision *= 2
    return enclosure


def is_undefined(value: Expr) -> bool:
    """Tell whether an expression is known not to be a finite real number.

    A ball answers for a constant, because SymPy may take seconds for an algebraic number.

    Examples
    --------
    >>> root = sympy.CRootOf(sympy.symbols("x") ** 5 - 2, 0)
    >>> [is_undefined(x) for x in (1 / root, sympy.sqrt(1 - root))]
    [False, True]
    """
    if not value.free_symbols and ball(value, 64).is_finite():
        return False
    return value.is_finite is False or value.is_real is False or value.has(sympy.nan)


def accurate(number: Expr, bits: int) -> arb:
    """Enclose an exact number to so many significant bits; return 0 if it cannot be told from 0.

    The precision is doubled until it is enough, or 8192 bits are reached.

    Examples
    --------
    >>> accurate(sympy.sqrt(10**80 + 1) - 10**40, 60).str(5, radius=False)
    '5.0000e-41'
    """
    precision = max(128, 2 * bits)
    while (enclosure := ball(number, precision)).rel_accuracy_bits() < bits and precision < FARTHEST:
        precision *= 2
    return arb(0) if enclosure.is_finite() and enclosure.contains(0) else enclosure


def _ball(node: Expr, values: Mapping[Symbol, arb]) -> arb:
    if isinstance(node, Symbol):
        return values[node]
    if isinstance(node, Rational):
        return arb(to_flint(node))
    if isinstance(node, Add):
        return sum((_ball(part, values) for part in node.args), arb(0))
    if isinstance(node, Mul):
        result = arb(1)
        for part in node.args:
            result *= _ball(part, values)
        return result
    if isinstance(node, Pow) and isinstance(node.exp, Rational):
        if not values and node.exp.q > 1:
            return _constant(node, ctx.prec)
        return _power(node, values)
    if node is sympy.pi or node is sympy.E:
        return arb.pi() if node is sympy.pi else arb(1).exp()
    if isinstance(node, CRootOf):
        return real_root(node, ctx.prec)
    if isinstance(node, Enclosed):
        return node.enclosed(ctx.prec)
    if type(node).__name__ in FUNCTIONS and len(node.args) == 1:
        return _function(node, values) if values else _constant(node, ctx.prec)
    return arb("nan")


@lru_cache(maxsize=256)
def _constant(node: Expr, precision: int) -> arb:
    """Enclose a root or a function of constants, once for each precision, which has to be the current one."""
    return _power(node, NOTHING) if isinstance(node, Pow) else _function(node, NOTHING)


def _function(node: Expr, values: Mapping[Symbol, arb]) -> arb:
    return FUNCTIONS[type(node).__name__](_ball(node.args[0], values))


def _power(node: Pow, values: Mapping[Symbol, arb]) -> arb:
    base, n = _root(_ball(node.base, values), int(node.exp.q)), int(node.exp.p)
    # a product, since ** gives no finite power of a ball that contains 0
    return math.prod([base] * n, start=arb(1)) if 0 < n <= 64 else base**n


def _root(base: arb, n: int) -> arb:
    if n == 1:
        return base
    if n == 2:
        return base.sqrt()
    return base.root(n) if base > 0 else arb("nan")


def interval(low: Fraction, high: Fraction | None = None) -> arb:
    """Return a ball that contains all numbers between two, at the precision that is set."""
    return arb(to_flint(low)).union(arb(to_flint(low if high is None else high)))


def dyadic(enclosure: arb, small: Fraction) -> Fraction | None:
    """Return a dyadic fraction near an enclosed number, within `small`; None if the ball is too wide."""
    if not enclosure.is_finite() or fraction_of(enclosure.rad()) > small / 2:
        return None
    n = max(2, small.denominator.bit_length() - small.numerator.bit_length() + 3)
    return Fraction(round(fraction_of(enclosure.mid()) * 2**n), 2**n)


def fraction_of(exact: arb) -> Fraction:
    """Return the number that a ball of radius 0 stands for, exactly."""
    mantissa, exponent = exact.man_exp()
    return int(mantissa) * Fraction(2) ** int(exponent)


def ends(enclosure: arb) -> tuple[Fraction, Fraction]:
    """Return the lower and the upper end of a ball, exactly; those of python-flint are rounded.

    Examples
    --------
    >>> ends(interval(Fraction(10**30), Fraction(10**30 + 1)))[1] > 10**30
    True
    """
    middle, radius = fraction_of(enclosure.mid()), fraction_of(enclosure.rad())
    return middle - radius, middle + radius
