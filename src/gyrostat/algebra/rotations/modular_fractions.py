"""Finds fractions by their residues modulo many primes."""
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import islice
from math import isqrt

from flint import fmpz

FIRST = 2**62                                          # primes are taken below it
MOST = 1024                                            # of them
GROWTH = 1.25                                          # of the number of primes between two attempts


def by_residues(residues: Callable[[int], Sequence[int] | None], most: int = MOST) -> list[Fraction] | None:
    """Return the fractions with given residues modulo a prime, once one more prime confirms all of them.

    Parameters
    ----------
    residues : callable
        takes a prime; None if it is not to be used; if it gives more residues, the fractions are those
    most : int
        how many primes are taken

    Returns
    -------
    list of Fraction
        None if they are not found by so many primes
    """
    modulus, count, attempt = 1, 0, 1.0
    whole: list[int] = []
    found: list[Fraction] = []
    for p in islice(_primes(), most):
        if (values := residues(p)) is None:
            continue
        if len(values) > len(whole):
            modulus, count, attempt, whole, found = 1, 0, 1.0, [0] * len(values), []
        if found and all(x.numerator % p == value * x.denominator % p for x, value in zip(found, values)):
            return found
        inverse = pow(modulus, -1, p)
        whole = [x + modulus * ((value - x) * inverse % p) for x, value in zip(whole, values)]
        modulus, found, count = modulus * p, [], count + 1
        if count >= attempt:
            several, attempt = [_fraction(x, modulus) for x in whole], count * GROWTH
            found = [x for x in several if x is not None] if None not in several else []
    return None


def _primes() -> Iterator[int]:
    """Yield primes from large to small."""
    p = FIRST - 1
    while True:
        if fmpz(p).is_prime():
            yield p
        p -= 2


def _fraction(residue: int, modulus: int) -> Fraction | None:
    """Return the fraction with a small numerator and denominator that is a residue; None if there is none."""
    most, above, below, old, new = isqrt(modulus // 2), modulus, residue % modulus, 0, 1
    while below > most:
        quotient, rest = divmod(above, below)
        above, below, old, new = below, rest, new, old - quotient * new
    return Fraction(below, new) if new and abs(new) <= most else None
