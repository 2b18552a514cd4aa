"""Zeros of an expression in one name, and where it changes its sign: exact, or enclosed by bisection."""
from fractions import Fraction
from itertools import pairwise

from sympy import Expr, Rational, Symbol

from ...errors import ScopeError
from ..enclosures.balls import ball, interval
from ..enclosures.rationals import to_sympy
from ..reals.exact import evaluate, sign_of_constant
from .roots import real_roots
from .stations import between

# of the range, where a zero of a transcendental margin is looked for
FINEST, BITS = Fraction(1, 2**48), 192


def inner(a: Expr, b: Expr) -> Rational:
    """Return a fraction between two exact numbers."""
    return to_sympy(between(a, b))


def changes_of_sign(expression: Expr, free: Symbol, low: Expr, high: Expr) -> list[Expr]:
    """Return where an expression in one name changes its sign, strictly between two numbers, complete."""
    cuts = [low, *zeros_inside(expression, free, low, high), high]
    signs = [sign_of_constant(evaluate(expression, {free: inner(a, b)})) for a, b in pairwise(cuts)]
    return [zero for zero, before, after in zip(cuts[1:], signs, signs[1:]) if before != after]


def zeros_inside(expression: Expr, free: Symbol, low: Expr, high: Expr) -> list[Expr]:
    """Return the zeros between two numbers; none if the name does not occur."""
    return zeros_of(expression, free, low, high) if expression.has(free) else []


def zeros_of(expression: Expr, free: Symbol, low: Expr, high: Expr) -> list[Expr]:
    """Return the zeros of an expression in one name between two numbers.

    They are exact if it is rational in the name, else within 2⁻⁴⁸ of the range, by enclosures.
    """
    try:
        return real_roots(expression, free, low, high) or []
    except ScopeError:
        start, end = Fraction(low), Fraction(high)
        slope = expression.diff(free)
        return list(map(to_sympy, _enclosed(expression, slope, free, start, end, (end - start) * FINEST)))


def _enclosed(f: Expr, slope: Expr, free: Symbol, a: Fraction, b: Fraction,
              finest: Fraction) -> list[Fraction]:
    """Return every zero, by bisection with balls.

    There is none where the ball of the expression excludes 0, and at most one where that of the slope does:
    then the signs at the ends tell.
    """
    found: list[Fraction] = []
    waiting = [(a, b)]
    while waiting:
        a, b = waiting.pop()
        here = {free: interval(a, b)}
        if not ball(f, BITS, here).contains(0):
            continue
        middle = (a + b) / 2
        if b - a < finest:
            if not found or abs(found[-1] - middle) > 4 * finest:
                found.append(middle)
            continue
        inner = ball(slope, BITS, here)
        if inner.is_finite() and not inner.contains(0) and _sign(f, free, a) * _sign(f, free, b) > 0:
            continue
        waiting += [(a, middle), (middle, b)]
    return sorted(found)


def _sign(f: Expr, free: Symbol, x: Fraction) -> int:
    return sign_of_constant(evaluate(f, {free: to_sympy(x)})) or 0
