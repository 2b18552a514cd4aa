"""Converts rational numbers between Python, SymPy and python-flint; a double counts as the fraction it is."""
from fractions import Fraction

from flint import fmpq
from sympy import Rational


def to_flint(number: Rational | Fraction | float) -> fmpq:
    """Return a rational number as python-flint's fmpq.

    Examples
    --------
    >>> to_flint(Rational(3, 4)) + to_flint(Fraction(1, 8)) + to_flint(0.125)
    1
    """
    if isinstance(number, Rational):
        return fmpq(number.p, number.q)
    return fmpq(*number.as_integer_ratio())


def to_sympy(number: fmpq | Fraction | float) -> Rational:
    """Return a rational number as SymPy's Rational.

    SymPy takes the numbers of python-flint only if it computes with python-flint itself.

    Examples
    --------
    >>> to_sympy(fmpq(6, 8)), to_sympy(0.5)
    (3/4, 1/2)
    """
    if isinstance(number, fmpq):
        return Rational.from_coprime_ints(int(number.p), int(number.q))
    return Rational.from_coprime_ints(*map(int, number.as_integer_ratio()))
