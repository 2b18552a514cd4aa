"""The sign of an expression at exact numbers: by rational arithmetic, or by proved enclosures and a separation bound."""
import math
import threading
from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

import sympy
from flint import arb, ctx, fmpq, fmpq_mpoly, fmpz_poly
from sympy import Add, CRootOf, Dummy, Expr, Mul, Pow, Rational, Symbol

from .algebra import Ring

LIMIT, ALGEBRAIC_LIMIT = 4096, 2**20                   # bits; a sign that is not proved by then is not known
ONE_AT_A_TIME = threading.RLock()                      # the precision of python-flint is one for the whole process
NOTHING: Mapping[Symbol, arb] = MappingProxyType({})
_FUNCTIONS = {name: getattr(arb, name) for name in (
    "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh")}


def sign(expression: Expr, values: Mapping[Symbol, Expr]) -> int | None:
    """Sign of an expression at a point: exact, or None where it cannot be proved.

    Exact for rational numbers and for algebraic ones written with roots, zero included. With transcendental functions the precision of
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


class Point(dict[Symbol, Expr]):
    """Exact numbers by symbol, the rational ones ready for polynomial arithmetic."""

    def __init__(self, numbers: Mapping[Symbol, Expr]):
        super().__init__(numbers)
        self.rational = {s: fmpq(int(x.p), int(x.q)) for s, x in self.items() if isinstance(x, Rational)}


def evaluate(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """The exact value: a Rational where all numbers are rational and the expression is a fraction of polynomials."""
    given = values if isinstance(values, Point) else Point(values)
    fraction = compiled(expression)
    if fraction is None or not all(s in given.rational for s in fraction[0]):
        return _inserted(expression, values).doit()
    symbols, top, bottom = fraction
    point = [given.rational[s] for s in symbols]
    value = top(*point)
    if bottom is not None:
        below = bottom(*point)
        if below == 0:
            return sympy.nan
        value /= below
    return Rational(int(value.p), int(value.q))


def _inserted(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """Numbers in the place of symbols, but not of the variable inside the root of a polynomial, which may be one of ours."""
    roots = {root: Dummy() for root in expression.atoms(CRootOf)}
    placed = expression.xreplace(roots).xreplace(dict(values))
    return placed.xreplace({dummy: root for root, dummy in roots.items()})


@lru_cache(maxsize=4096)
def compiled(expression: Expr) -> tuple[tuple[Symbol, ...], fmpq_mpoly, fmpq_mpoly | None] | None:
    """The expression as a fraction of polynomials in its symbols, None where it is none; a denominator 1 is left out."""
    ring = Ring([expression])
    if not all(isinstance(g, Symbol) for g in ring.generators):
        return None
    top, bottom = ring.fraction(expression)
    return ring.generators, top, None if bottom.is_one() else bottom


def sign_of_constant(constant: Expr) -> int | None:
    """Sign of a constant, by enclosures of doubled precision; an algebraic number below its separation bound is 0."""
    if isinstance(constant, Rational):
        return (constant.p > 0) - (constant.p < 0)
    if constant is sympy.nan:
        return None
    separation, precision = _separation(constant), 64
    while precision <= (LIMIT if separation is None else min(4 * separation + 256, ALGEBRAIC_LIMIT)):
        enclosure = ball(constant, precision)
        if enclosure > 0 or enclosure < 0:
            return 1 if enclosure > 0 else -1
        if separation is not None and abs(enclosure) < arb(2) ** -separation:
            return 0
        precision *= 2
    return None


def is_algebraic(constant: Expr) -> bool:
    """Whether a constant is written with rationals, + − × ÷, roots and roots of polynomials; SymPy does not know it of all of them."""
    return _conjugates(constant) is not None


def _separation(constant: Expr) -> int | None:
    """n such that the constant, if it is not 0, is at least 2⁻ⁿ in size; None for a transcendental one.

    Of an expression in rationals, + − × ÷ and roots: |E| ≥ 1/(u^(D−1) l), where u and l bound the conjugates of its numerator
    and denominator and D is the product of the degrees of its distinct roots.

    Source
    ------
    Burnikel, Fleischer, Mehlhorn & Schirra, Algorithmica 27 (2000) 87-99.
    """
    roots = {Pow(p.base, Rational(1, p.exp.q)) for p in constant.atoms(Pow) if isinstance(p.exp, Rational) and not p.exp.is_Integer}
    degree = math.prod([int(r.exp.q) for r in roots] + [r.poly.degree() for r in constant.atoms(CRootOf)])
    bounds = _conjugates(constant)
    return None if bounds is None else math.ceil(((degree - 1) * bounds[0] + bounds[1]) * (1 + 1e-9)) + 2


def _conjugates(node: Expr) -> tuple[float, float] | None:
    """log₂ of u and l, each at least 0; None where the expression is not of that form."""
    if isinstance(node, Rational):
        return math.log2(abs(int(node.p)) or 1), math.log2(int(node.q))
    if isinstance(node, CRootOf):
        coefficients = [abs(int(c)) for c in _polynomial(node).coeffs()]
        return math.log2(coefficients[-1] + max(coefficients)), math.log2(coefficients[-1])
    parts = [_conjugates(part) for part in (node.args if isinstance(node, (Add, Mul)) else node.args[:1])]
    if not parts or None in parts:
        return None
    given = [part for part in parts if part]
    if isinstance(node, Mul):
        return sum(u for u, _ in given), sum(low for _, low in given)
    if isinstance(node, Add):
        (u, low), *rest = given
        for v, m in rest:
            u, low = max(u + m, low + v) + 1, low + m
        return u, low
    if not isinstance(node, Pow) or not isinstance(node.exp, Rational):
        return None
    (u, low), n, k = given[0], abs(int(node.exp.p)), int(node.exp.q)
    u, low = ((u + (k - 1) * low) / k, low) if u >= low else (u, ((k - 1) * u + low) / k)
    return (n * u, n * low) if node.exp > 0 else (n * low, n * u)


def ball(expression: Expr, precision: int, values: Mapping[Symbol, arb] = NOTHING) -> arb:
    """Enclosure of a real expression in ball arithmetic of the precision given (not finite where it is undefined).

    Parameters
    ----------
    expression : Expr
    precision : int                       bits
    values : mapping of Symbol to arb     enclosures of its symbols
    """
    with ONE_AT_A_TIME, ctx.workprec(precision):
        return +_ball(expression, values)


def _ball(node: Expr, values: Mapping[Symbol, arb]) -> arb:
    if isinstance(node, Symbol):
        return values[node]
    if isinstance(node, Rational):
        return arb(fmpq(int(node.p), int(node.q)))
    if isinstance(node, Add):
        return sum((_ball(part, values) for part in node.args), arb(0))
    if isinstance(node, Mul):
        result = arb(1)
        for part in node.args:
            result *= _ball(part, values)
        return result
    if isinstance(node, Pow) and isinstance(node.exp, Rational):
        base, n = _root(_ball(node.base, values), int(node.exp.q)), int(node.exp.p)
        return math.prod([base] * n, start=arb(1)) if 0 < n <= 64 else base**n     # ** has no power of a ball that contains 0
    if node is sympy.pi or node is sympy.E:
        return arb.pi() if node is sympy.pi else arb(1).exp()
    if isinstance(node, CRootOf):
        return _enclosure(node, ctx.prec)
    name = type(node).__name__
    if name in _FUNCTIONS and len(node.args) == 1:
        return _FUNCTIONS[name](_ball(node.args[0], values))
    return arb("nan")


@lru_cache(maxsize=256)
def _enclosure(root: CRootOf, precision: int) -> arb:
    real = sorted((x.real for x, _ in _polynomial(root).complex_roots() if x.imag == 0), key=arb.mid)
    return real[root.index] if root.index < len(real) else arb("nan")          # the real ones come first, in order


@lru_cache(maxsize=256)
def _polynomial(root: CRootOf) -> fmpz_poly:
    return fmpz_poly([int(c) for c in reversed(root.poly.clear_denoms(convert=True)[1].all_coeffs())])


def _root(base: arb, n: int) -> arb:
    return base if n == 1 else base.sqrt() if n == 2 else base.root(n) if base > 0 else arb("nan")
