"""Adds and multiplies power series in z1, w1, z2, w2, cut off at a degree; their numbers are balls."""
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

Monomial = tuple[int, int, int, int]                       # exponents
Series = dict[Monomial, Any]
START: Monomial = (0, 0, 0, 0)
OWN: tuple[Monomial, ...] = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))


def pair(n: int) -> Monomial:
    """Return the monomial of ρ1 = z1 w1 (n = 0), or of ρ2."""
    return (1, 1, 0, 0) if n == 0 else (0, 0, 1, 1)


def pairs(degree: int) -> list[Monomial]:
    """Return the monomials in ρ1 and ρ2 alone that have a degree in z and w."""
    half = degree // 2
    return [(n, n, half - n, half - n) for n in range(half + 1)] if degree % 2 == 0 else []


def of_degree(degree: int) -> Iterator[Monomial]:
    """Yield all monomials of a degree."""
    for a, b, c in product(range(degree + 1), repeat=3):
        if a + b + c <= degree:
            yield a, b, c, degree - a - b - c


def plus(m: Monomial, n: Monomial) -> Monomial:
    """Return the product of two monomials."""
    return m[0] + n[0], m[1] + n[1], m[2] + n[2], m[3] + n[3]


def added(a: Series, b: Series) -> Series:
    """Return the sum of two series."""
    found = dict(a)
    for m, c in b.items():
        found[m] = found[m] + c if m in found else c
    return found


def times(a: Series, b: Series, degree: int) -> Series:
    """Return the product of two series, to a degree."""
    found: Series = {}
    for m, c in a.items():
        left = degree - sum(m)
        for n, d in b.items():
            if sum(n) <= left:
                both = plus(m, n)
                found[both] = found[both] + c * d if both in found else c * d
    return found


def dot(a: Sequence[Series], b: Sequence[Series], degree: int) -> Series:
    """Return the scalar product of two vectors of series, to a degree."""
    found: Series = {}
    for x, y in zip(a, b):
        found = added(found, times(x, y, degree))
    return found


def cross(a: Sequence[Series], b: Sequence[Series], degree: int) -> list[Series]:
    """Return the vector product of two vectors of series, to a degree."""
    def one(i: int, j: int) -> Series:
        return added(times(a[i], b[j], degree), {m: -c for m, c in times(a[j], b[i], degree).items()})

    return [one(1, 2), one(2, 0), one(0, 1)]
