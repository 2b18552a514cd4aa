"""Eliminates the higher powers of t from two polynomials in t, by pseudo-division."""
from flint import fmpq_mpoly

from .polynomials import by_degree


def linear(F: fmpq_mpoly, G: fmpq_mpoly, place: int) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """Return (a, b) for a combination a t + b of two polynomials in t; (0, 0) if none is found.

    It is a remainder of Euclid's algorithm. Pseudo-division keeps a and b polynomials.
    """
    while G.degrees()[place] > 1 and F.degrees()[place] > 1:
        if F.degrees()[place] < G.degrees()[place]:
            F, G = G, F
        F, G = G, _remainder(F, G, place)
    for f in (G, F):
        if f.degrees()[place] == 1:
            b, a = by_degree(f, place, 1)
            return a, b
    return G * 0, G * 0


def _remainder(F: fmpq_mpoly, G: fmpq_mpoly, place: int) -> fmpq_mpoly:
    """Return the pseudo-remainder of F by G in one generator."""
    n, t = G.degrees()[place], F.context().gens()[place]
    lead = by_degree(G, place, n)[n]
    while F and (m := F.degrees()[place]) >= n:
        F = lead * F - by_degree(F, place, m)[m] * t ** (m - n) * G
    return F
