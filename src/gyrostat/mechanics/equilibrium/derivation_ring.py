"""Keeps one polynomial ring for an equilibrium, in which all that holds there is derived."""
from collections.abc import Iterable

from sympy import Expr, ImmutableMatrix, Symbol

from ...algebra.rings.matrices import applied
from ...algebra.solving.margins import Signs
from ...notation import symbol
from .derived_once import once
from .equilibrium import Equilibrium

# with more of them, the order of factors and of roots depends on the ring
GENERATORS, ROOTS = 10, 1


def signs_over(eq: Equilibrium, expressions: Iterable[Expr]) -> Signs:
    """Return signs on the family, in its one ring if that holds the expressions, else in their own."""
    expressions = list(expressions)
    shared = _shared(eq)
    return shared if shared and shared.ring.holds(expressions) else Signs.over(expressions, eq.domain)


def rows_at_point(eq: Equilibrium, matrix: ImmutableMatrix) -> list[list[Expr]]:
    """Return the entries of a matrix, each at the equilibrium; they are placed there once."""
    placed = _placed(eq)
    if matrix not in placed:
        placed[matrix] = [[entry if entry.is_Number else eq.at_point(entry) for entry in row]
                          for row in matrix.tolist()]
    return placed[matrix]


@once
def _placed(eq: Equilibrium) -> dict[ImmutableMatrix, list[list[Expr]]]:
    return {}


@once
def positive(eq: Equilibrium) -> tuple[Expr, ...]:
    """Return what is positive at every equilibrium: k·Ik, if there is a field of one direction."""
    k = () if eq.system.coupled else eq.point[3:]
    return (eq.at_point(*applied([applied(eq.system.body.tensor.tolist(), k)], k)),) if k else ()


@once
def _shared(eq: Equilibrium) -> Signs | None:
    """Return signs in a ring of the body, the point, the jet of U there and a free multiplier.

    None if that ring would have too many generators.
    """
    body, potential = eq.system.body, eq.system.potential
    if eq.system.coupled:                                  # its names are those of the energy
        names = sorted(eq.system.hamiltonian.free_symbols - set(eq.system.space.coordinates), key=str)
        signs = Signs.over([*eq.point, *map(eq.insert, names)], eq.domain)
        return signs if len(signs.ring.generators) <= 2 * GENERATORS else None
    slopes = [d for d in potential.gradient() if isinstance(d, Symbol)] if potential else []
    jet = [*slopes, *(d for slope in slopes for d in potential.following(slope))] if potential else []
    held = [eq.at_point(e) for e in (*body.entries, *body.gyrostatic_momentum, *jet)]
    signs = Signs.over([*eq.point, *held, symbol("nu1")], eq.domain)
    few = len(signs.ring.generators) <= GENERATORS and len(signs.ring.squares) <= ROOTS
    return signs if few else None
