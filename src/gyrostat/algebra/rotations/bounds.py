"""A bound for the number of critical points of a quartic form off N = 0, by linear algebra modulo a prime.

The six quartics of the critical points, times monomials, span J in degree D. Functionals on forms f of degree
D − 2 that are φ(N f), with φ zero on J, see no zero on N = 0.
"""
from collections.abc import Sequence
from itertools import islice
from typing import NamedTuple

from flint import nmod_mat

from .quartic_forms import QuarticForm, at_infinity, minors, monomials, multiples

PRIMES = (2305843009213693951, 2305843009213693921, 2305843009213693907, 2305843009213693723,
          2305843009213693693, 2305843009213693669, 2305843009213693613)
TRIES = 2                                              # primes for each form
# pairs of linear forms, which no symmetry of a satellite prefers
LINES = ((331, -709, 523, 117), (-829, 257, 131, 503)), ((-419, 613, 887, -239), (571, 911, -173, 397))
Line = tuple[int, int, int, int]
DEGREE = 8                                             # of the multiples: enough for 40 zeros


class Bound(NamedTuple):
    """At most so many zeros off N = 0, counted with multiplicity, and what to solve for them.

    Parameters
    ----------
    lines : (Line, Line)
        two linear forms, the second of which vanishes at no zero
    beyond : bool
        whether zeros on N = 0 are left out
    rows, solved : sequence of int
        rows of J, and columns, of a square matrix that is invertible
    free : sequence of int
        columns of the others: those with which the functionals begin, as many as the bound
    lower : sequence of int
        as many monomials such that no combination of functionals vanishes on them, times the second form
    """

    lines: tuple[Line, Line]
    beyond: bool
    rows: Sequence[int]
    solved: Sequence[int]
    free: Sequence[int]
    lower: Sequence[int]

    @property
    def most(self) -> int:
        """The bound."""
        return len(self.free)


def bounded(form: QuarticForm, lines: tuple[Line, Line]) -> Bound | None:
    """Return a bound for the number of critical points with N ≠ 0; None if none is proved.

    Modulo a prime the functionals have the rank m = rk(J + N) − rk J. Over ℚ it is at most m: J has no lower
    rank there, and J + N the same. If they are independent on ℓ f, too, for a linear form ℓ, then nothing is
    left modulo ℓ: it vanishes at no zero, and there are at most m.

    References
    ----------
    Derived in docs/explanation/derivations/satellite.md, section 10.
    """
    known = at_infinity(form, PRIMES)
    several = ((p, form.modulo(p)) for p in (PRIMES if known is None else known))
    tried = islice(((p, f) for p, f in several if f is not None), TRIES)
    found = (_modulo(multiples(minors(f), DEGREE, 4), p, lines, known is not None) for p, f in tried)
    return next((bound for bound in found if bound is not None), None)


def _modulo(matrix: Sequence[Sequence[int]], p: int, lines: tuple[Line, Line], beyond: bool) -> Bound | None:
    reduced, rank = _reduced(matrix, p)
    solved = _pivots(reduced, rank)
    free = sorted(set(range(len(matrix[0]))) - set(solved))
    functionals = [[0] * len(free) for _ in matrix[0]]
    for place, column in enumerate(free):
        functionals[column][place] = 1
    for n, column in enumerate(solved):
        functionals[column] = [-int(reduced[n, f]) for f in free]
    degree = DEGREE
    if beyond:
        functionals, degree = times_norm(functionals, degree), degree - 2
        kept = _pivots(*_reduced(functionals, p))
        free, functionals = [free[n] for n in kept], [[row[n] for n in kept] for row in functionals]
    lower, independent = _reduced(_transposed(times_line(functionals, degree, lines[1])), p)
    if independent < len(free):
        return None
    rows = _pivots(*_reduced(_transposed(matrix), p))
    return Bound(lines, beyond, rows, solved, free, _pivots(lower, independent))


def times_norm(functionals: Sequence[Sequence], degree: int) -> list[list]:
    """Return the values φ(N f) for monomials f, by those φ(f) for the monomials of a degree, in rows."""
    places = monomials(degree)
    found = []
    for a, b, c, d in monomials(degree - 2):
        four = (functionals[places[e]] for e in ((a + 2, b, c, d), (a, b + 2, c, d), (a, b, c + 2, d),
                                                 (a, b, c, d + 2)))
        found.append([w + x + y + z for w, x, y, z in zip(*four)])
    return found


def times_line(functionals: Sequence[Sequence], degree: int, line: Sequence[int],
               lower: Sequence[int] | None = None) -> list[list]:
    """Return the values φ(ℓ f) for monomials f, or for some of them."""
    places, several = monomials(degree), list(monomials(degree - 1))
    h, i, j, k = line
    found = []
    for n in range(len(several)) if lower is None else lower:
        a, b, c, d = several[n]
        four = (functionals[places[e]] for e in ((a + 1, b, c, d), (a, b + 1, c, d), (a, b, c + 1, d),
                                                 (a, b, c, d + 1)))
        found.append([h * w + i * x + j * y + k * z for w, x, y, z in zip(*four)])
    return found


def _reduced(rows: Sequence[Sequence[int]], p: int) -> tuple[nmod_mat, int]:
    return nmod_mat(len(rows), len(rows[0]), [x % p for row in rows for x in row], p).rref()


def _pivots(reduced: nmod_mat, rank: int) -> list[int]:
    found, column = [], 0
    for n in range(rank):
        while not int(reduced[n, column]):
            column += 1
        found.append(column)
    return found


def _transposed(rows: Sequence[Sequence[int]]) -> list[list[int]]:
    return [list(column) for column in zip(*rows)]
