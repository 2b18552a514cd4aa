"""Compares strict conditions by the signs of their factors.

A B > 0 and A > 0 say the same as A > 0 and B > 0.
"""
from collections.abc import Iterable

from sympy import Expr, factor_list

Strict = tuple[Expr, bool, frozenset[Expr]]               # margin > 0, and what does not vanish
Pattern = tuple[frozenset[tuple[frozenset[Expr], int]], frozenset[Expr]]


def sign_pattern(conditions: Iterable[Strict]) -> Pattern | None:
    """Return the signs that products of factors have, and the factors that do not vanish.

    The signs are solved over the integers modulo 2, so that equivalent conditions give one pattern. None if a
    condition is not strict.

    Examples
    --------
    >>> from sympy import symbols
    >>> a, b = symbols("a b")
    >>> none = frozenset()
    >>> sign_pattern([(a, True, none), (a*b, True, none)]) == sign_pattern([(b, True, none), (a, True, none)])
    True
    """
    rows: list[tuple[frozenset[Expr], int]] = []
    nonzero: set[Expr] = set()
    for margin, strict, degenerate in conditions:
        if not strict:
            return None
        constant, powers = factor_list(margin)
        nonzero |= {factor for factor, _ in powers}
        nonzero |= {factor for e in degenerate for factor, _ in factor_list(e)[1]}
        rows.append((frozenset(factor for factor, n in powers if n % 2), 1 if constant > 0 else -1))
    return frozenset(_solved(rows)), frozenset(nonzero)


def _solved(rows: list[tuple[frozenset[Expr], int]]) -> list[tuple[frozenset[Expr], int]]:
    """Return products of rows, with their signs, such that each has a factor that no other has."""
    found: list[tuple[frozenset[Expr], int]] = []
    for factor in sorted({factor for factors, _ in rows for factor in factors}, key=str):
        first = next((row for row in rows if factor in row[0]), None)
        if first is None:
            continue
        rows = [_times(row, first) if factor in row[0] else row for row in rows if row is not first]
        found = [_times(row, first) if factor in row[0] else row for row in found] + [first]
    return found + [row for row in rows if row[1] < 0]    # 1 < 0, where they contradict


def _times(a: tuple[frozenset[Expr], int], b: tuple[frozenset[Expr], int]) -> tuple[frozenset[Expr], int]:
    return a[0] ^ b[0], a[1] * b[1]
