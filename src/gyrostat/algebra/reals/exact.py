"""The sign of an expression at exact numbers, by fractions, or by balls down to a separation bound."""
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise

import sympy
from flint import arb, fmpq, fmpq_mpoly
from sympy import CRootOf, Derivative, Dummy, Expr, Integer, Rational, Subs, Symbol, radsimp

from ..._lazy import loaded
from ...errors import ScopeError, brief
from ..enclosures.algebraic import is_algebraic, separation
from ..enclosures.balls import ball
from ..enclosures.rationals import to_sympy
from ..rings.polynomials import Ring

# bits: a sign that is not proved by then is not known; the normal form is sooner
LIMIT, ALGEBRAIC_LIMIT, FAR = 4096, 2**20, 2**14


def sign(expression: Expr, values: Mapping[Symbol, Expr]) -> int | None:
    """Return the sign of an expression at a point, exactly; None if it cannot be proved.

    The sign is exact, zero included, for rational numbers and for algebraic ones written with roots and with
    sines and cosines of rational multiples of π. With transcendental numbers the precision of the enclosure
    is doubled up to 4096 bits, and a value is 0 if its normal form is
    (gyrostat.algebra.reals.transcendental). If neither decides, the answer is None.

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
    given = values if isinstance(values, Point) else Point(values)
    if (value := _rational_value(expression, given)) is not None:
        return (value > 0) - (value < 0)
    return sign_of_constant(evaluate(expression, given))


class Point(dict[Symbol, Expr]):
    """Exact numbers by symbol; the rational ones are ready for polynomial arithmetic.

    The attribute doubt says what is not proved about them; it is "" if everything is.
    """

    def __init__(self, numbers: Mapping[Symbol, Expr], doubt: str = ""):
        super().__init__(numbers)
        self.doubt = doubt
        # made for every verdict, hence without a call of to_flint
        self.rational = {s: fmpq(x.p, x.q) for s, x in self.items() if isinstance(x, Rational)}

    def joined(self, more: Iterable[tuple[Symbol, Expr]]) -> "Point":
        """Return the point with the numbers of other symbols besides."""
        found = Point(dict(more), self.doubt)
        found.update(self)
        found.rational.update(self.rational)
        return found

    def rational_at(self, symbols: Sequence[Symbol]) -> list[fmpq] | None:
        """Return the numbers of some symbols; None if one is not given or not rational."""
        try:
            return [self.rational[s] for s in symbols]
        except KeyError:
            return None


def evaluate(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """Return the exact value of an expression at a point.

    It is a Rational if all numbers are rational and the expression is a fraction of polynomials.
    """
    if expression in values:                               # a name
        return values[expression]
    given = values if isinstance(values, Point) else Point(values)
    if (value := _rational_value(expression, given)) is not None:
        return to_sympy(value)
    if (fraction := compiled(expression)) is not None and given.rational_at(fraction[0]) is not None:
        return sympy.nan                                   # it divides by 0
    placed = _inserted(expression, values)
    # only derivatives need doit, which would factor the polynomial of a root once more
    return placed.doit() if fraction is None and placed.has(Derivative, Subs) else placed


def _rational_value(expression: Expr, given: Point) -> fmpq | None:
    """Return the value of a fraction of polynomials at rational numbers.

    None if it is no such fraction, a number is not rational, or it divides by 0.
    """
    fraction = compiled(expression)
    if fraction is None:
        return None
    symbols, top, bottom = fraction
    point = given.rational_at(symbols)
    if point is None or bottom is None:
        return None if point is None else top(*point)
    return top(*point) / below if (below := bottom(*point)) else None


def _inserted(expression: Expr, values: Mapping[Symbol, Expr]) -> Expr:
    """Insert numbers for symbols.

    Nothing is inserted for the variable inside the root of a polynomial, which may be one of our symbols.
    """
    roots = {root: Dummy() for root in expression.atoms(CRootOf)}
    placed = expression.xreplace(roots).xreplace(dict(values))
    return placed.xreplace({dummy: root for root, dummy in roots.items()})


@lru_cache(maxsize=4096)
def compiled(expression: Expr) -> tuple[tuple[Symbol, ...], fmpq_mpoly, fmpq_mpoly | None] | None:
    """Return symbols, numerator and denominator of a fraction of polynomials, None for any other expression.

    The denominator 1 is given as None.
    """
    ring = Ring([expression])
    if not all(isinstance(g, Symbol) for g in ring.generators):
        return None
    top, bottom = ring.fraction(expression)
    return ring.generators, top, None if bottom.is_one() else bottom


def sign_of_constant(constant: Expr) -> int | None:
    """Return the sign of a constant, by enclosures of doubled precision; None if it is not proved.

    The sign 0 is proved by a separation bound, or by the normal form of transcendental numbers.
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
        # the normal form proves 0 where no bound does, or only one that takes too many bits
        far = precision == 256 and (least is None or least > FAR)
        if far and enclosure.is_finite():
            vanishes = loaded("algebra.reals.transcendental:vanishes")
            if vanishes(constant, sign_of_constant):
                return 0
        precision *= 2
    return None


def proved_sign(constant: Expr, refusal: Callable[[], Exception] | None = None) -> int:
    """Return the sign of a constant on which everything after it depends, or raise an error.

    Parameters
    ----------
    constant : Expr
    refusal : callable or None
        makes the error to be raised if the sign is not proved; default: a ScopeError

    Raises
    ------
    ScopeError
        the sign is not proved, and no other error is asked for

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


def rationalised(value: Expr) -> Expr:
    """Return a number with a rational denominator, as polynomial algebra wants it; the rest as it is."""
    return value if value.free_symbols or value.is_Rational else radsimp(value)


def sign_changes(signs: Iterable[int | None]) -> int:
    """Count the changes of sign in 1 and the signs that follow, where 0 and None are skipped.

    By Descartes' rule this is, for the coefficients of det(λ + A), the number of negative eigenvalues of A,
    if all eigenvalues are real.
    """
    return sum(a != b for a, b in pairwise([1, *filter(None, signs)]))


def is_identically_zero(expression: Expr) -> bool | None:
    """Tell whether an expression is 0 at all values of its symbols; None if that is not proved.

    It is if every coefficient of its numerator is 0.
    """
    ring = Ring([expression])
    top = ring.numerator(expression)
    signs = {sign_of_constant(ring.expression(c))
             for c in ring.coefficients(top, expression.free_symbols).values()}
    if signs & {1, -1}:
        return False
    return None if None in signs else True


def plain(constant: Expr) -> Expr:
    """Return 0, 1 or −1 for a constant that is proved to be that number, and any other one as it is."""
    if constant.free_symbols or isinstance(constant, Rational):
        return constant
    if not (near := ball(constant, 64)).is_finite():
        return constant
    found = (Integer(n) for n in (0, 1, -1) if near.contains(n) and sign_of_constant(constant - n) == 0)
    return next(found, constant)
