"""Writes an exact number as text, as str does, but reads the polynomial of a root once for all its places."""
from functools import lru_cache

from sympy import CRootOf, Expr, Rational
from sympy.printing.str import StrPrinter

from ...algebra.enclosures.balls import accurate

LONGEST = 60                                           # characters of an exact number that is not asked for
DIGITS, BITS = 17, 80                                  # of the decimal in its place


class _Printer(StrPrinter):
    def _print_ComplexRootOf(self, root: CRootOf) -> str:
        return _root(root)


@lru_cache(maxsize=64)
def _root(root: CRootOf) -> str:
    return str(root)


def exact_text(number: Expr) -> str:
    """Return the text of a number: a sum in a field of degree 24 has 23 places with the same root.

    Examples
    --------
    >>> from sympy import CRootOf, Symbol
    >>> x = Symbol("x")
    >>> exact_text(1 - CRootOf(x**3 - x - 1, 0) ** 2)
    '1 - CRootOf(x**3 - x - 1, 0)**2'
    """
    if isinstance(number, Rational):                       # the printer takes longer than a verdict
        return str(number.p) if number.q == 1 else f"{number.p}/{number.q}"
    text: str = _Printer().doprint(number)
    return text


def short_text(number: Expr) -> str:
    """Return the text of a number if it has at most 60 characters, otherwise its first 17 digits.

    Examples
    --------
    >>> from sympy import CRootOf, Symbol, sqrt
    >>> x = Symbol("x")
    >>> root = CRootOf(x**9 - 3*x**7 - 12*x**5 + 6*x**4 - 87*x**2 - 1, 0)
    >>> short_text(sqrt(2) / 2), short_text(sqrt(2) * root)
    ('sqrt(2)/2', '-2.8516457153309254')
    """
    text = exact_text(number)
    if len(text) <= LONGEST or not (near := accurate(number, BITS)).is_finite():
        return text
    return str(near.mid().str(DIGITS, radius=False))
