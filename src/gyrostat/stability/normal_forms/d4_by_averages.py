"""D4 of two degrees of freedom without eigenvalues, by averages over the tori of the linear motion.

Every step is a sum or a product, so the numbers may be polynomials.
"""
from collections.abc import Sequence
from itertools import permutations
from math import factorial, prod
from typing import Any, NamedTuple

from ...algebra.rings.series import Part, is_zero
from .birkhoff import Rows, characteristic, linear_motion, multiplied

UNIT: Rows = [[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1], [0, 0, -1, 0]]  # 𝕁, for {y0, y1} = {y2, y3} = 1
ALL = range(4)


class Averages(NamedTuple):
    """The p and q of λ⁴ + p λ² + q, and top and bottom of D4 = top/bottom.

    The bottom is a positive number times q (p² − 4q) if h3 = 0, else q² (p² − 4q) (4p² − 25q).
    """

    p: Any
    q: Any
    top: Any
    bottom: Any


def averages(parts: Sequence[Part]) -> Averages:
    """Return D4 of an energy in four canonical coordinates, {y0, y1} = {y2, y3} = 1.

    On the torus with the actions (ω2, −ω1) let y be the linear motion, y' = A y, A = 𝕁 D²h2. Then D4 =
    <h4(y)> + <∇h3(y)·y₁>/2, where y₁' = A y₁ + 𝕁 ∇h3(y) is the forced motion, of frequencies 0, 2ω1, 2ω2, ω1
    ± ω2. The covariance of mode j is a polynomial in A over ω1² − ω2², the answer to a frequency ν is (A +
    iν)(A² + p − ν²)𝕁 over ν⁴ − pν² + q; all that is not even in ω1, ω2 and symmetric cancels.

    With Mₙ = Aⁿ𝕁, D²h2⁻¹ = −Y/q, Y = M₃ + pM₁, X = pM₃ + (p² − 2q)M₁ and Q = D⁴h4, T = D³h3:

    D4 = (3 Q(X, X) − (p² − 4q) Q(Y, Y))/(32 q (p² − 4q)) + (T:X)·Y(T:X)/(8 q² (p² − 4q))
         − Σ c_ijk θ(Mᵢ, Mⱼ, Mₖ)/(48 q² (p² − 4q)(4p² − 25q)),
    θ(Mᵢ, Mⱼ, Mₖ) = Σ (Mⱼ)_bd tr(Mᵢ T_b Mₖ T_d) for odd i.

    The factor 4p² − 25q comes from ν = 2ω1, 2ω2, ω1 ± ω2, at which ν⁴ − pν² + q vanishes if one frequency is
    twice the other.

    Parameters
    ----------
    parts : sequence of dict
        homogeneous parts of degree 0 to 4, as energy_on_orbit gives them, in numbers or polynomials

    Returns
    -------
    Averages

    References
    ----------
    Lindstedt's series to the second order; Sanders, Verhulst & Murdock, Averaging Methods in Nonlinear
    Dynamical Systems. Derived in docs/explanation/derivations/d4.md, sections 3 to 6.

    Examples
    --------
    >>> from flint import fmpq
    >>> one = fmpq(1)

    The frequencies are ω1 = 1 and ω2 = −2; y0⁴ has the average 3 J1²/2, and J1 = ω2.

    >>> linear = {2: one / 2, 32: one / 2, 512: -one, 8192: -one}
    >>> found = averages([{}, {}, linear, {}, {4: one}])
    >>> found.top / found.bottom
    6
    """
    A = linear_motion(parts[2])
    M = [UNIT]
    for _ in range(3):
        M.append(multiplied(A, M[-1]))
    p, q = characteristic(A)
    discriminant, ratio = p**2 - 4 * q, 4 * p**2 - 25 * q
    X, Y = _sum(p, M[3], p**2 - 2 * q, M[1]), _sum(1, M[3], p, M[1])
    quartic = 3 * _quartic(parts[4], X) - discriminant * _quartic(parts[4], Y)
    if not parts[3]:
        return Averages(p, q, quartic, 32 * q * discriminant)
    T = _third_derivatives(parts[3])
    pulled = [_trace(T[n], X) for n in ALL]
    still = sum(pulled[i] * Y[i][j] * pulled[j] for i in ALL for j in ALL)
    turned = [[multiplied(matrix, T[n]) for n in ALL] for matrix in M]
    # exchanging b and d changes the sign of both factors if j is even, of none if it is odd
    forced = sum(c * sum((1 if b == d else 2) * (M[j][b][d] * _trace(turned[i][b], turned[k][d]))
                         for d in ALL for b in range(d + j % 2) if not is_zero(M[j][b][d]))
                 for (i, j, k), c in _weights(p, q).items())
    top = ratio * (3 * q * quartic + 12 * still) - 2 * forced
    return Averages(p, q, top, 96 * q**2 * discriminant * ratio)


def _weights(p: Any, q: Any) -> dict[tuple[int, int, int], Any]:
    """Return the c_ijk of the sum, derived in docs/explanation/derivations/d4.md, section 6.

    They come from the covariances and the answers at 2ω1, 2ω2, ω1 ± ω2: multiplied out in powers of A below
    A⁴, added over these frequencies, and written in p = ω1² + ω2² and q = ω1² ω2².
    """
    return {(1, 0, 0): 3 * q * (4 * p**6 - 37 * p**4 * q + 123 * p**2 * q**2 - 120 * q**3),
            (3, 0, 0): 3 * p * q * (p**2 - 3 * q) * (4 * p**2 - 25 * q),
            (1, 0, 2): 6 * p * q * (4 * p**4 - 9 * p**2 * q + 8 * q**2),
            (3, 0, 2): 6 * q * (4 * p**4 - 9 * p**2 * q - 10 * q**2),
            (1, 2, 2): 3 * p**2 * q * (4 * p**2 + 11 * q),
            (3, 2, 2): 3 * p * q * (4 * p**2 + 11 * q),
            (1, 1, 1): p * (4 * p**6 - 41 * p**4 * q + 124 * p**2 * q**2 - 6 * q**3),
            (1, 1, 3): 3 * (4 * p**6 - 33 * p**4 * q + 106 * p**2 * q**2 + 10 * q**3),
            (1, 3, 3): 3 * p * (4 * p**4 - 25 * p**2 * q + 108 * q**2),
            (3, 3, 3): 4 * p**4 - 17 * p**2 * q + 130 * q**2}


def _sum(x: Any, first: Rows, y: Any, second: Rows) -> Rows:
    """Return x first + y second."""
    return [[x * a + y * b for a, b in zip(*rows)] for rows in zip(first, second)]


def _trace(a: Rows, b: Rows) -> Any:
    """Return the trace of the product."""
    return sum(a[m][n] * b[n][m] for m in ALL for n in ALL if not (is_zero(a[m][n]) or is_zero(b[n][m])))


def _quartic(part: Part, Z: Rows) -> Any:
    """Return D⁴h4(Z, Z), Z symmetric: each of three pairings of four factors occurs in 8 of 24 orders."""
    total = 0
    for code, x in part.items():
        a, b, c, d = _factors(code)
        total += 8 * x * (Z[a][b] * Z[c][d] + Z[a][c] * Z[b][d] + Z[a][d] * Z[b][c])
    return total


def _third_derivatives(part: Part) -> list[Rows]:
    """Return the tensor D³h3."""
    T: list[Rows] = [[[0] * 4 for _ in ALL] for _ in ALL]
    for code, x in part.items():
        exponents = [code >> 4 * n & 15 for n in ALL]
        for a, b, c in set(permutations(_factors(code))):
            T[a][b][c] = x * prod(map(factorial, exponents))
    return T


def _factors(code: int) -> list[int]:
    """Return the variables of a monomial, each as often as its exponent."""
    return [n for n in ALL for _ in range(code >> 4 * n & 15)]
