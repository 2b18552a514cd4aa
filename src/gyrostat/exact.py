"""The sign of an expression at exact numbers: by rational arithmetic, in a number field, or by proved enclosures."""
from collections.abc import Mapping
from functools import lru_cache

import sympy
from flint import arb, ctx, fmpq, fmpq_mpoly
from sympy import Add, Expr, Mul, Pow, Rational, Symbol
from sympy.polys.constructor import construct_domain

from .algebra import Ring

LIMIT = 4096                                           # bits; a sign that is not proved by then is not known
_FUNCTIONS = {name: getattr(arb, name) for name in (
    "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh")}


def sign(expression: Expr, values: Mapping[Symbol, Expr]) -> int | None:
    """Sign of an expression at a point: exact, or None where it cannot be proved.

    Exact for rational and algebraic numbers, zero included. With transcendental functions the precision of
    the enclosure is doubled up to 4096 bits; a value that is zero there without simplifying to 0 stays None.

    Parameters
    ----------
    expression : Expr                     in the symbols of values
    values : mapping of Symbol to Expr    exact numbers

    Returns
    -------
    int or None                           -1, 0, 1; None: not proved, or not a real number there

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> x = symbol("x")
    >>> sign(x**2 - 2, {x: Rational(3, 2)}), sign(x**2 - 2, {x: sympy.sqrt(2)}), sign(sympy.exp(x) - 3, {x: sympy.S.One})
    (1, 0, -1)
    """
    return sign_of_constant(evaluate(expression, values))


def evaluate(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """The exact value: a Rational where all numbers are rational and the expression is a fraction of polynomials."""
    fraction = _fraction(expression)
    if fraction is None or not all(isinstance(values[s], Rational) for s in fraction[0]):
        return expression.xreplace(dict(values)).doit()
    symbols, top, bottom = fraction
    point = [fmpq(int(values[s].p), int(values[s].q)) for s in symbols]
    below = bottom(*point)
    if below == 0:
        return sympy.nan
    value = top(*point) / below
    return Rational(int(value.p), int(value.q))


@lru_cache(maxsize=4096)
def _fraction(expression: Expr) -> tuple[tuple[Symbol, ...], fmpq_mpoly, fmpq_mpoly] | None:
    """The expression as a fraction of polynomials in its symbols, None where it is none."""
    ring = Ring([expression])
    if not all(isinstance(g, Symbol) for g in ring.generators):
        return None
    return (ring.generators, *ring.fraction(expression))


def sign_of_constant(constant: Expr) -> int | None:
    """Sign of a constant, by enclosures of doubled precision; an algebraic number that may be zero is tested in its field."""
    if isinstance(constant, Rational):
        return (constant.p > 0) - (constant.p < 0)
    if constant is sympy.nan:
        return None
    precision, tested = 64, False
    while precision <= LIMIT:
        enclosure = ball(constant, precision)
        if enclosure > 0 or enclosure < 0:
            return 1 if enclosure > 0 else -1
        if not tested and precision >= 256 and constant.is_algebraic:
            tested = True
            if is_algebraic_zero(constant):
                return 0
        precision *= 2
    return None


def is_algebraic_zero(constant: Expr) -> bool:
    """Whether an algebraic number is zero, decided in the number field it generates."""
    expanded = constant.doit().expand()
    if isinstance(expanded, Rational):
        return expanded.p == 0
    field, (element,) = construct_domain([expanded], extension=True)
    return bool(element == field.zero)


def ball(constant: Expr, precision: int) -> arb:
    """Enclosure of a real constant in ball arithmetic of the precision given (not finite where it is undefined)."""
    with ctx.workprec(precision):
        return +_ball(constant)


def _ball(node: Expr) -> arb:
    if isinstance(node, Rational):
        return arb(fmpq(int(node.p), int(node.q)))
    if isinstance(node, Add):
        return sum((_ball(part) for part in node.args), arb(0))
    if isinstance(node, Mul):
        result = arb(1)
        for part in node.args:
            result *= _ball(part)
        return result
    if isinstance(node, Pow) and isinstance(node.exp, Rational):
        return _root(_ball(node.base), int(node.exp.q)) ** int(node.exp.p)
    if node is sympy.pi or node is sympy.E:
        return arb.pi() if node is sympy.pi else arb(1).exp()
    name = type(node).__name__
    if name in _FUNCTIONS and len(node.args) == 1:
        return _FUNCTIONS[name](_ball(node.args[0]))
    return arb("nan")


def _root(base: arb, n: int) -> arb:
    return base if n == 1 else base.sqrt() if n == 2 else base.root(n) if base > 0 else arb("nan")
