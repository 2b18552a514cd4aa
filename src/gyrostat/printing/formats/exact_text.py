"""Writes an exact number as text, as str does, but reads the polynomial of a root once for all its places."""
from functools import lru_cache

from sympy import CRootOf, Expr, Rational
from sympy.printing.str import StrPrinter


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
