"""Rational numbers of Python, of SymPy and of python-flint, made into each other; a double is one of them."""
from fractions import Fraction

from flint import fmpq
from sympy import Rational


def to_flint(number: Rational | Fraction | float) -> fmpq:
    """A rational number for python-flint.

    Examples
    --------
    >>> to_flint(Rational(3, 4)) + to_flint(Fraction(1, 8)) + to_flint(0.125)
    1
    """
    if isinstance(number, Rational):
        return fmpq(number.p, number.q)
    return fmpq(*number.as_integer_ratio())


def to_sympy(number: fmpq | Fraction | float) -> Rational:
    """A rational number for SymPy, which takes those of python-flint only where it computes with them itself.

    Examples
    --------
    >>> to_sympy(fmpq(6, 8)), to_sympy(0.5)
    (3/4, 1/2)
    """
    if isinstance(number, fmpq):
        return Rational(int(number.p), int(number.q))
    return Rational(*number.as_integer_ratio())
