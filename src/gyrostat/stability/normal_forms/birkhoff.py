"""Brings a Hamiltonian of two degrees of freedom to Birkhoff's normal form, by Lie series.

Numbers are balls, or elements of the field of the eigenvalues, which are imaginary.
"""
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any

from flint import acb, fmpq

from ..._cached import cached_property
from ...algebra.reals.eigenvalues import Element
from ...algebra.rings.series import Part, added, is_zero, substituted

Rows = list[list[Any]]
Mode = tuple[Any, list[Any], Any]                          # an eigenvalue, its vector, the vector's norm
Pairs = Sequence[tuple[int, int, Any]]                     # i, j and {Y_i, Y_j}
ONES = tuple(1 << 4 * n for n in range(4))
Z1, W1, Z2, W2 = ONES                                      # the exponents of a monomial, four bits each


@dataclass(frozen=True)
class Modes:
    """The eigenvectors v_j of the linear motion, y = Σ z_j v_j + w_j v̄_j.

    Parameters
    ----------
    values : tuple, shape (2,)
        λ1, λ2 = iω1, iω2
    vectors : tuple of list, shape (2, 4)
        v1, v2
    norms : tuple, shape (2,)
        N_j = v̄_jᵀ 𝕁 v_j; h = −Σ λ_j N_j z_j w_j + …, and the action is −i N_j z_j w_j
    """

    values: tuple[Any, Any]
    vectors: tuple[list[Any], list[Any]]
    norms: tuple[Any, Any]

    @cached_property
    def forms(self) -> list[Part]:
        """The coordinates y as linear forms in z1, w1, z2, w2."""
        first, second = self.vectors
        return in_columns([first, conjugate(first), second, conjugate(second)])

    @cached_property
    def brackets(self) -> Pairs:
        """The Poisson brackets {z_j, w_j} = −1/N_j."""
        return [(2 * j, 2 * j + 1, -1 / norm) for j, norm in enumerate(self.norms)]

    def oriented(self) -> "Modes":
        """Return the modes of numbers in balls with positive actions −i N_j z_j w_j, ω_j of either sign."""
        found = [(-value, conjugate(vector), -norm) if norm.imag < 0 else (value, vector, norm)
                 for value, vector, norm in zip(self.values, self.vectors, self.norms)]
        return Modes(*zip(*found))


def linear_motion(quadratic: Part) -> Rows:
    """Return the matrix A = 𝕁 D²h of y' = A y."""
    S = [[quadratic.get(a + b, 0) * (2 if a == b else 1) for b in ONES] for a in ONES]
    return [S[1], [-x for x in S[0]], S[3], [-x for x in S[2]]]


def characteristic(A: Rows) -> tuple[Any, Any]:
    """Return p and q of det(λ − A) = λ⁴ + p λ² + q, by the traces of A² and A⁴."""
    square = multiplied(A, A)
    p = sum(square[n][n] for n in range(4)) / -2
    return p, (p**2 - sum(multiplied(square, square)[n][n] for n in range(4)) / 2) / 2


def modes(A: Rows, p: Any, values: tuple[Any, Any]) -> Modes:
    """Return the eigenvectors in the image of the adjugate of λ − A, A³ + λ A² + (λ² + p) A + λ (λ² + p).

    ZeroDivisionError if no vector is proved to be an eigenvector.
    """
    square = multiplied(A, A)
    cube = multiplied(square, A)
    return Modes(*zip(*(_mode(A, square, cube, p, value) for value in values)))


def _mode(A: Rows, square: Rows, cube: Rows, p: Any, value: Any) -> Mode:
    rest = value * value + p
    # a vector is orthogonal to (1, t, t², t³) for three t at most: seven are enough for two pairs
    for t in range(7):
        v = [0 * value] * 4
        for column, factor in enumerate([t**n for n in range(4) if t or not n]):
            for i in range(4):
                v[i] += (cube[i][column] + square[i][column] * value + A[i][column] * rest) * factor
            v[column] += value * rest * factor
        if not_zero(norm := symplectic(conjugate(v), v)):
            return value, v, norm
    raise ZeroDivisionError("no eigenvector is proved not to be 0")


def normalised(parts: Sequence[Part], found: Modes, kept: Collection[int] = ()) -> list[Part]:
    """Return the energy in z and w, in parts of each degree, without the terms that can be removed.

    Each step is exp(ad W), in which {h2, W} takes away the terms of one degree, except those without a rate:
    docs/explanation/derivations/d4.md, sections 3 and 9. Of the last degree only what stays is computed.

    Parameters
    ----------
    parts : sequence of dict
        homogeneous parts of degree 0 to n, in the coordinates y
    found : Modes
    kept : collection of int
        resonant terms, by their exponents
    """
    degree = len(parts) - 1
    wanted = {*kept, *((Z1 + W1) * n + (Z2 + W2) * (degree // 2 - n) for n in range(degree // 2 + 1))}
    h = [substituted(part, found.forms, wanted if n == degree else None) if n > 2 else {}
         for n, part in enumerate(parts)]
    divisors: dict[tuple[int, int], Any] = {}
    for order in range(3, degree):
        gone = {code: c for code, c in h[order].items()
                if not (code in kept or rate(code) == (0, 0) or is_zero(c))}
        for turns in {rate(code) for code in gone} - divisors.keys():
            divisors[turns] = 1 / (found.values[0] * turns[0] + found.values[1] * turns[1])
        W = {code: c * divisors[rate(code)] for code, c in gone.items()}
        # ad W once, twice, …, applied to h2 and to every other part; {h2, W} is known, it is what goes
        chains = [(order, 1, {code: -c for code, c in gone.items()}),
                  *((n, 0, part) for n, part in enumerate(h) if n > 2)]
        h = [dict(part) for part in h]
        for at, times, part in chains:
            while at <= degree:
                if times:
                    added(h[at], {code: c * fmpq(1, factorial(times)) for code, c in part.items()})
                times, at = times + 1, at + order - 2
                if at <= degree:
                    part = bracket(part, W, found.brackets, wanted if at == degree else None)
    return h


def bracket(f: Part, g: Part, pairs: Pairs, wanted: Collection[int] | None = None) -> Part:
    """Return the Poisson bracket {f, g}, or the wanted terms of it."""
    total: Part = {}
    for e, c in f.items():
        for d, x in g.items():
            for i, j, one in pairs:
                factor = (e >> 4 * i & 15) * (d >> 4 * j & 15) - (e >> 4 * j & 15) * (d >> 4 * i & 15)
                code = e + d - ONES[i] - ONES[j]
                if factor and (wanted is None or code in wanted):
                    term = c * x * one * factor
                    total[code] = total[code] + term if code in total else term
    return total


def twist(part: Part, found: Modes) -> Any:
    """Return D of the terms of degree 2m: their value at the actions (ω2, −ω1), where h2 vanishes."""
    first, second = (found.values[1] / found.norms[0], -1 * found.values[0] / found.norms[1])
    total = 0
    for code, c in part.items():
        if not any(rate(code)):
            total = c * first ** (code & 15) * second ** (code >> 8 & 15) + total
    return total


def in_columns(columns: Iterable[Sequence[Any]]) -> list[Part]:
    """Return Σ Y_n columns[n], one linear form for each component."""
    return [{ONES[n]: x for n, x in enumerate(row) if not is_zero(x)} for row in zip(*columns)]


def symplectic(x: Sequence[Any], y: Sequence[Any]) -> Any:
    """Return xᵀ 𝕁 y."""
    return x[0] * y[1] - x[1] * y[0] + x[2] * y[3] - x[3] * y[2]


def conjugate(vector: Sequence[Any]) -> list[Any]:
    """Return the complex conjugate of every component."""
    return [x.conjugate() for x in vector]


def multiplied(a: Rows, b: Rows) -> Rows:
    """Return the product of two matrices."""
    return [[sum(a[i][n] * b[n][j] for n in range(4)) for j in range(4)] for i in range(4)]


def not_zero(x: Any) -> bool:
    """Tell whether a number is proved not to be 0, for all eigenvalues that it may stand for."""
    if isinstance(x, Element):
        return x.invertible()
    return not (x.contains(0) if isinstance(x, acb) else is_zero(x))


def rate(code: int) -> tuple[int, int]:
    """Return how often λ1 and λ2 are in the rate of a monomial."""
    return (code & 15) - (code >> 4 & 15), (code >> 8 & 15) - (code >> 12)


def colliding(A: Rows, p: Any, value: Any, parts: list[Part]) -> Any:
    """Return a number with the sign of ε𝒜 at 1:1; None if no eigenvector is proved not to be 0.

    With v = adj(λ − A)e and u = adj'(λ)e, (A − λ)u = v is a Jordan block. {Y_i, Y_j} is −Ω⁻¹, Ω_ij = v_iᵀ 𝕁
    v_j. The cubic part h3 is removed by W with (λΔ + N) W = h3, N nilpotent, so that the series for its
    inverse ends.
    """
    square = multiplied(A, A)
    cube = multiplied(square, A)
    rest = value * value + p
    for column in range(4):
        v = [cube[i][column] + square[i][column] * value + A[i][column] * rest for i in range(4)]
        v[column] += value * rest
        u = [square[i][column] + A[i][column] * value * 2 for i in range(4)]
        u[column] += value * value * 3 + p
        if not_zero(symplectic(conjugate(v), u)):
            break
    else:
        return None
    # the variables z, w, z', w' belong to v, v̄, u, ū; Ω is inverted by hand
    g, h = symplectic(v, conjugate(u)), symplectic(u, conjugate(v))
    b = symplectic(u, conjugate(u))
    pairs = [(0, 1, -b / (g * h)), (0, 3, 1 / g), (2, 1, 1 / h)]
    forms = in_columns([v, conjugate(v), u, conjugate(u)])
    target = 2 * (ONES[0] + ONES[1])
    cubic = substituted(parts[3], forms)
    W: Part = {}
    term = cubic
    for _ in range(4):
        term = {code: c / (value * sum(rate(code))) for code, c in term.items()}
        added(W, term)
        term = {code: -1 * c for code, c in _nilpotent(term).items()}
    found = substituted(parts[4], forms, {target}).get(target, 0)
    found = bracket(cubic, W, pairs, {target}).get(target, 0) * fmpq(1, 2) + found
    return real(found) * real(symplectic(conjugate(u), v)) * -1


def _nilpotent(part: Part) -> Part:
    """Return z' ∂/∂z + w' ∂/∂w, applied to a part."""
    found: Part = {}
    for code, c in part.items():
        for n in (0, 1):
            if times := code >> 4 * n & 15:
                added(found, {code - ONES[n] + ONES[n + 2]: c * times})
    return found


def real(x: Any) -> Any:
    """Return the real number that an element of the field, a complex ball or a number is."""
    if isinstance(x, Element):
        return x.rational()
    return x.real if isinstance(x, acb) else x
