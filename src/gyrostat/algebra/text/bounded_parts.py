"""Parts of a text: an expression each, with bounds on what it would cost to expand or evaluate it."""
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from typing import Any, NamedTuple

import sympy
from flint import arb
from sympy import Add, Expr, I, Mul, Pow, Rational, S, Symbol, cot, tan

from ..enclosures.arithmetic import Arithmetic, in_arithmetic
from ..enclosures.balls import NOTHING, Enclosed, ball
from ..rings.subexpressions import occurring
from . import magnitudes

FUNCTIONS: dict[str, Callable[[Expr], Expr]] = {
    name: getattr(sympy, name) for name in ("sqrt", *magnitudes.FUNCTIONS)}
TERMS, DEGREE, BITS, NESTING = 1000, 100, 4000, 4
HYPERBOLIC, PARTIAL = ("sinh", "cosh", "tanh"), 8
_EXPONENTIAL, _LOGARITHMIC = ("exp", "sinh", "cosh"), ("log", "asinh", "acosh")
_SOMEWHERE = ("log", "asin", "acos", "acosh", "atanh")
_INVERSE = tuple(FUNCTIONS[name] for name in ("asin", "acos", "atan", "asinh", "acosh", "atanh"))
_FOREIGN = (I, S.NaN, S.ComplexInfinity, S.Infinity, S.NegativeInfinity, sympy.Mod, sympy.floor,
            sympy.ceiling, sympy.re, sympy.im, sympy.arg, sympy.sign, sympy.conjugate, sympy.Piecewise,
            sympy.AccumBounds)


class Cost(NamedTuple):
    """Bounds on an expression once it is expanded.

    size: log₂ of its value if no symbol exceeds 1. partial: terms or degree of what is made of functions that
    are real only somewhere, as log(k3); SymPy looks for the real and imaginary parts of these, which takes
    its time.
    """

    terms: int = 1
    degree: int = 0
    bits: int = 1
    size: float = 0.0
    partial: int = 0

    def fits(self, terms: int) -> bool:
        """Tell whether it is within the limits."""
        return self.terms <= terms and self.degree <= DEGREE and self.bits <= BITS


@dataclass(frozen=True)
class Part:
    """A part of a text that has been parsed.

    Parameters
    ----------
    value : Expr
        or a matrix, in languages that have them
    cost : Cost
    nesting : int
        functions and roots inside one another
    ball : arb or None
        an enclosure, of a constant
    """

    value: Any
    cost: Cost = Cost()
    nesting: int = 0
    ball: arb | None = None

    @property
    def doubtful(self) -> bool:
        """Whether it is a constant that its enclosure does not tell from 0."""
        return self.ball is not None and self.value != 0 and 0 in self.ball


def constant(value: Rational) -> Part:
    """Return the part of a rational number."""
    return Part(value, of_number(value), 0, ball(value, magnitudes.PRECISION))


def of_number(value: Rational) -> Cost:
    """Return the bounds of a rational number."""
    top, bottom = int(value.p).bit_length(), int(value.q).bit_length()
    return Cost(bits=max(top, bottom, 1), size=top - bottom + 1)


def of_sum(costs: Sequence[Cost]) -> Cost:
    """Return the bounds of a sum."""
    return _joined(Cost(sum(c.terms for c in costs), max(c.degree for c in costs),
                        max(c.bits for c in costs) + len(costs).bit_length(),
                        max(c.size for c in costs) + math.log2(len(costs))), max(c.partial for c in costs))


def of_product(costs: Sequence[Cost]) -> Cost:
    """Return the bounds of a product."""
    return _joined(Cost(math.prod(c.terms for c in costs), sum(c.degree for c in costs),
                        sum(c.bits for c in costs), sum(c.size for c in costs)),
                   max(c.partial for c in costs))


def of_power(base: Cost, exponent: Rational) -> Cost:
    """Return the bounds of a rational power."""
    times, root = abs(int(exponent.p)), int(exponent.q)
    if base.terms == 1:
        terms = 1
    elif base.terms > 20 * TERMS or times > DEGREE:
        terms = 10**9
    else:
        terms = math.comb(times + base.terms - 1, times)
    bits = base.bits * max(times, 1)
    cost = Cost(terms, base.degree * times, bits, base.size * times / root if exponent.p > 0 else bits)
    return _joined(cost, max(base.partial, int(root > 1 and base.degree > 0)))


def factored(base: Part, root: int) -> int:
    """Return the bits of the number that SymPy factors for a root; 0 if there is no root.

    SymPy writes n**(-1/7) as n**(6/7)/n, and factors n.
    """
    # a value that is only typeset is no Expr: nothing of it is computed
    factors = Mul.make_args(base.value) if isinstance(base.value, Expr) else ()
    order = root * max((part.exp.q for part in factors if isinstance(part, Pow)
                        and isinstance(part.exp, Rational)), default=1)
    bits = base.cost.bits
    if isinstance(base.value, Rational):
        bits = max(map(_without_tens, (base.value.p, base.value.q)))
    return order * bits if order > 1 else 0


def _without_tens(number: int) -> int:
    """Return the bits of a whole number without its factors 2 and 5, which are found at once."""
    for prime in (2, 5):
        while number and number % prime == 0:
            number //= prime
    return number.bit_length()


def factored_by(name: str, argument: Part) -> int:
    """Return the bits of the number that SymPy factors for a function.

    A function of an inverse function is a root of a number twice as long; exp(c*log(r)) is the power r**c.
    """
    found = [8 * argument.cost.bits if argument.value.has(*_INVERSE) else 0]
    for term in Add.make_args(argument.value) if name == "exp" else ():
        c, logarithm = term.as_coeff_Mul()
        r = logarithm.args[0] if isinstance(logarithm, sympy.log) else None
        if isinstance(r, Rational) and not (r.is_prime or (1 / r).is_prime):
            found.append(max(abs(c.p), c.q) * of_number(r).bits)
    return max(found)


def of_function(name: str, argument: Cost) -> Cost:
    """Return the bounds of an elementary function."""
    partial = max(argument.partial, int(name in _SOMEWHERE))
    if name not in _EXPONENTIAL:
        return Cost(1, 1, argument.bits, math.log2(argument.bits + 1) if name in _LOGARITHMIC else 1.0,
                    partial)
    growth = 1.4427 * 2 ** min(max(argument.size, 0.0), 64)                # log₂ e
    return Cost(1, 1, argument.bits + math.ceil(growth), growth, partial)


def _joined(cost: Cost, partial: int) -> Cost:
    return cost._replace(partial=max(partial, cost.terms, cost.degree)) if partial else cost


def of_expression(expression: Expr) -> Cost:
    """Return the bounds of any expression, from its tree."""
    return in_arithmetic(expression, _COSTS)


def _cost_of_leaf(node: Expr) -> Cost:
    if isinstance(node, Rational):
        return of_number(node)
    return Cost(degree=1) if isinstance(node, Symbol) else NotImplemented


def _cost_of_function(node: Expr, costs: Sequence[Cost]) -> Cost:
    return of_function(type(node).__name__, costs[0]) if costs else Cost(bits=3, size=2)      # pi, e


_COSTS = Arithmetic(_cost_of_leaf, of_sum, of_product, of_power, _cost_of_function)


def enclosure(expression: Expr, known: Mapping[Symbol, arb] = NOTHING) -> arb | None:
    """Enclose an expression that has been built.

    None if it has another name, or a function that is not in the grammar.
    """
    def leaf(node: Expr) -> arb | None:
        if isinstance(node, Symbol):
            return known.get(node)
        if isinstance(node, Rational | Enclosed) or node in (S.Pi, S.Exp1):
            return ball(node, magnitudes.PRECISION)
        return NotImplemented

    return in_arithmetic(expression, Arithmetic(leaf, partial(reduce, magnitudes.added),
                                                partial(reduce, magnitudes.multiplied), _raised, _applied))


def _raised(base: arb | None, exponent: Rational) -> arb | None:
    return magnitudes.raised(base, exponent) if max(abs(exponent.p), exponent.q) <= BITS else None


def _applied(node: Expr, arguments: Sequence[arb | None]) -> arb | None:
    name = type(node).__name__
    return magnitudes.applied(name, arguments[0]) if name in magnitudes.FUNCTIONS else None


def immoderate(expression: Expr, known: Mapping[Symbol, arb]) -> Expr | None:
    """Return a function whose argument is above 2⁴⁰⁰⁰ in size; None if there is none.

    Its value would take as many bits of precision.
    """
    for node in occurring(expression, sympy.Function):
        argument = enclosure(node.args[0], known) if type(node).__name__ in magnitudes.FUNCTIONS else None
        if argument is not None and argument.is_finite() and magnitudes.extent(argument)[0] > BITS:
            return node
    return None


def foreign(value: Expr) -> bool:
    """Tell whether SymPy made something that is not real, not finite or not in the grammar."""
    return bool(value.has(*_FOREIGN))


def rewritten(value: Expr) -> Expr:
    """Write an expression in the functions of the grammar: SymPy turns tan(x + π/2) into −cot x."""
    return value.replace(cot, lambda x: 1 / tan(x)) if value.has(cot) else value
