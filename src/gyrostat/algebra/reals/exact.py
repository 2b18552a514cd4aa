"""The sign of an expression at exact numbers.

By rational arithmetic, or by proved enclosures and a separation bound.
"""
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise

import sympy
from flint import arb, fmpq, fmpq_mpoly
from sympy import CRootOf, Derivative, Dummy, Expr, Integer, Rational, Subs, Symbol

from ..._lazy import loaded
from ...errors import ScopeError, brief
from ..enclosures.algebraic import is_algebraic, separation
from ..enclosures.balls import ball
from ..enclosures.rationals import to_sympy
from ..rings.polynomials import Ring

# bits: a sign that is not proved by then is not known; the normal form is sooner
LIMIT, ALGEBRAIC_LIMIT, FAR = 4096, 2**20, 2**14


def sign(expression: Expr, values: Mapping[Symbol, Expr]) -> int | None:
    """Sign of an expression at a point: exact, or None where it cannot be proved.

    Exact for rational numbers and for algebraic ones written with roots and with sines and cosines of
    rational multiples of π, zero included. With transcendental numbers the precision of the enclosure is
    doubled up to 4096 bits, and a value is 0 if its normal form is
    (gyrostat.algebra.reals.transcendental); what is neither stays None.

    Parameters
    ----------
    expression : Expr
        in the symbols of values
    values : mapping of Symbol to Expr
        exact numbers

    Returns
    -------
    int or None
        -1, 0, 1; None: not proved, or not a real number there

    Examples
    --------
    >>> import gyrostat as gs
    >>> x = gs.symbol("x")
    >>> sign(x**2 - 2, {x: Rational(3, 2)}), sign(x**2 - 2, {x: sympy.sqrt(2)})
    (1, 0)
    >>> sign(sympy.exp(x) - 3, {x: sympy.S.One})
    -1
    """
    return sign_of_constant(evaluate(expression, values))


class Point(dict[Symbol, Expr]):
    """Exact numbers by symbol, the rational ones ready for polynomial arithmetic.

    The attribute doubt says what is not proved of them; it is "" if everything is.
    """

    def __init__(self, numbers: Mapping[Symbol, Expr], doubt: str = ""):
        super().__init__(numbers)
        self.doubt = doubt
        # for each verdict: without the call of to_flint
        self.rational = {s: fmpq(x.p, x.q) for s, x in self.items() if isinstance(x, Rational)}

    def rational_at(self, symbols: Sequence[Symbol]) -> list[fmpq] | None:
        """The numbers of some symbols, None where one is not given or not rational."""
        try:
            return [self.rational[s] for s in symbols]
        except KeyError:
            return None


def evaluate(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """The exact value: a Rational where all numbers are rational and the expression is a fraction of
    polynomials.
    """
    given = values if isinstance(values, Point) else Point(values)
    fraction = compiled(expression)
    point = None if fraction is None else given.rational_at(fraction[0])
    if fraction is None or point is None:
        placed = _inserted(expression, values)
        # doit factors the polynomial of a root once more
        return placed.doit() if fraction is None and placed.has(Derivative, Subs) else placed
    _, top, bottom = fraction
    value = top(*point)
    if bottom is not None:
        below = bottom(*point)
        if below == 0:
            return sympy.nan
        value /= below
    return to_sympy(value)


def _inserted(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """Numbers in the place of symbols, but not of the variable inside the root of a polynomial, which may be
    one of ours.
    """
    roots = {root: Dummy() for root in expression.atoms(CRootOf)}
    placed = expression.xreplace(roots).xreplace(dict(values))
    return placed.xreplace({dummy: root for root, dummy in roots.items()})


@lru_cache(maxsize=4096)
def compiled(expression: Expr) -> tuple[tuple[Symbol, ...], fmpq_mpoly, fmpq_mpoly | None] | None:
    """The expression as a fraction of polynomials in its symbols, None where it is none.

    A denominator 1 is left out.
    """
    ring = Ring([expression])
    if not all(isinstance(g, Symbol) for g in ring.generators):
        return None
    top, bottom = ring.fraction(expression)
    return ring.generators, top, None if bottom.is_one() else bottom


def sign_of_constant(constant: Expr) -> int | None:
    """Sign of a constant, by enclosures of doubled precision.

    0 by a separation bound or by the normal form of transcendental numbers.
    """
    if isinstance(constant, Rational):
        return (constant.p > 0) - (constant.p < 0)
    if constant is sympy.nan:
        return None
    precision, most, least = 64, LIMIT, None               # bits; an algebraic number below 2**-least is 0
    while precision <= most:
        enclosure = ball(constant, precision)
        if enclosure > 0 or enclosure < 0:
            return 1 if enclosure > 0 else -1
        if precision == 64 and (least := separation(constant)) is not None:
            most = min(4 * least + 256, ALGEBRAIC_LIMIT)
        if least is not None and abs(enclosure) < arb(2) ** -least:
            return 0
        far = precision == 256 and (least is None or least > FAR)
        if far and enclosure.is_finite():
            vanishes = loaded("algebra.reals.transcendental:vanishes")
            if vanishes(constant, sign_of_constant):
                return 0
        precision *= 2
    return None


def proved_sign(constant: Expr, refusal: Callable[[], Exception] | None = None) -> int:
    """The sign of a constant on which everything after it depends, or a refusal.

    Parameters
    ----------
    constant : Expr
    refusal : callable or None
        makes the error to be raised where the sign is not proved; None: a ScopeError

    Raises
    ------
    ScopeError
        the sign is not proved, and there is no other refusal

    Examples
    --------
    >>> proved_sign(sympy.sqrt(2) - 1)
    1
    """
    if (found := sign_of_constant(constant)) is not None:
        return found
    if refusal is not None:
        raise refusal()
    raise ScopeError(f"the sign of {brief(constant)} is not proved: " + (
        "write its algebraic numbers in one root" if is_algebraic(constant) else "round to decimals"))


def sign_changes(signs: Iterable[int | None]) -> int:
    """Changes of sign from 1 on: in the coefficients, the number of negative roots if all are real."""
    return sum(a != b for a, b in pairwise([1, *filter(None, signs)]))


def is_identically_zero(expression: Expr) -> bool | None:
    """Whether an expression is 0 at all values of its symbols: every coefficient of its numerator is.

    None where that is not proved.
    """
    ring = Ring([expression])
    top = ring.numerator(expression)
    signs = {sign_of_constant(ring.expression(c))
             for c in ring.coefficients(top, expression.free_symbols).values()}
    if signs & {1, -1}:
        return False
    return None if None in signs else True


def plain(constant: Expr) -> Expr:
    """0, 1 or -1 in place of a constant that is proved to be that number; anything else as it is."""
    if constant.free_symbols or isinstance(constant, Rational):
        return constant
    if not (near := ball(constant, 64)).is_finite():
        return constant
    found = (Integer(n) for n in (0, 1, -1) if near.contains(n) and sign_of_constant(constant - n) == 0)
    return next(found, constant)
