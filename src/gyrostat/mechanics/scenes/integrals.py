"""Integrals of a scene: finds those linear in π as a kernel, reads and proves any other that is given."""
from collections.abc import Sequence, Set
from functools import lru_cache
from typing import Any

from sympy import Add, Expr, Mul, Symbol

from ...algebra.rings.matrices import null_space, row_reduce
from ...algebra.rings.polynomials import Ring, lowest_terms
from ...algebra.text.grammar import parse
from ...algebra.text.numbers import exact_expression
from ...errors import StructureError
from ...notation import symbol
from .lie_poisson import LiePoisson

LONG = 200                                                 # characters of an expression in a message


def texts_or_expressions(integrals: Any) -> tuple[Expr, ...]:
    """Return the integrals as expressions, texts read by the grammar."""
    return tuple(parse(F) if isinstance(F, str) else exact_expression(F, "an integral") for F in integrals)


def in_coordinates(F: Expr, space: LiePoisson, rotor: Sequence[Expr],
                   parameters: Set[Symbol]) -> Expr:
    """Return F in the coordinates of the space, with M = π + l inserted.

    It is refused if it has other names, or is constant.
    """
    M = {symbol(f"M{i}"): pi + l for i, pi, l in zip((1, 2, 3), space.coordinates, rotor)}
    F = F.xreplace({name: value for name, value in M.items() if name not in parameters})
    known = {*space.coordinates, *parameters}
    if unknown := sorted(s.name for s in F.free_symbols - known):
        own = ", ".join(sorted(s.name for s in parameters)) or "none"
        raise StructureError(f"the integral {_short(F)} names {', '.join(unknown)}, which the scene does not "
                             f"have: write it in {', '.join(map(str, space.coordinates))}, in M1, M2, M3, "
                             f"and in the parameters of the scene, {own}")
    if not any(map(lowest_terms, space.gradient(F).flat())):
        raise StructureError(f"the integral {_short(F)} is a constant: give a function of the coordinates")
    return F


def check_independent(F: Expr, space: LiePoisson, known: Sequence[Expr]) -> None:
    """Refuse a function of the Hamiltonian, the Casimirs and the integrals that are known."""
    rows = [space.gradient(f).flat() for f in (*known, F)]
    ring = Ring([entry for row in rows for entry in row])
    matrix = [ring.matrix([row])[0][0] for row in rows]
    if len(row_reduce(ring, matrix, lambda _, entry: len(entry), len(rows[0]))) < len(rows):
        raise StructureError(f"the integral {_short(F)} is a function of the Hamiltonian, the Casimirs and "
                             "the integrals that are known, and proves nothing that they do not: leave it "
                             "out")


def everywhere(F: Expr, space: LiePoisson, hamiltonian: Expr, coupled: bool = False) -> bool:
    """Tell whether F is an integral on all of |k| = 1; else it is one where C1 = 0, or it is refused.

    In two directions, or with a coupling, it is one on all of the space, or it is refused.
    """
    rate = space.bracket(F, hamiltonian)
    if not rate or not coupled and _vanishes(rate, space):
        return True
    if not coupled and space.coordinates[3:] and _vanishes(_on_zero_level(rate, space), space):
        return False
    where = ", and not 0 where M·k = 0 either" if space.coordinates[3:] and not coupled else ""
    raise StructureError(f"{_short(F)} is not an integral: its bracket with the Hamiltonian is "
                         f"{_short(lowest_terms(rate))}, not 0{where}; check F, and the numbers of the scene")


def _short(expression: Expr) -> str:
    """Return an expression as a message shows it."""
    return text if len(text := str(expression)) <= LONG else f"{text[:LONG - 3]}..."


def _on_zero_level(rate: Expr, space: LiePoisson) -> Expr:
    """Return the rate where C1 = M·k = 0, solved for π1."""
    pi1, k1 = space.coordinates[0], space.coordinates[3]
    return rate.xreplace({pi1: pi1 - space.casimirs[0] / k1})


def _vanishes(rate: Expr, space: LiePoisson) -> bool:
    """Tell whether a rate vanishes identically, on so(3)* or on |k| = 1 in e(3)*."""
    ring = Ring([rate, *space.coordinates])
    top = ring.numerator(rate)
    if space.coordinates[3:]:
        top = ring.reduce(divmod(top, ring.numerator(space.casimirs[1] - 1))[1])
    return not top


@lru_cache(maxsize=64)
def linear_integrals(coordinates: tuple[Symbol, ...], rates: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """Return every combination c·π, c constant, whose rate c·π̇ vanishes identically."""
    ring = Ring([*rates, *coordinates])
    (row,), _ = ring.matrix([list(rates)])
    equations: dict[tuple[int, ...], list[Any]] = {}
    for column, rate in enumerate(row):
        for kind, coefficient in ring.coefficients(rate, set(coordinates)).items():
            equations.setdefault(kind, [ring.zero] * 3)[column] = coefficient
    basis = null_space(ring, list(equations.values()),
                       lambda j, entry: (not entry.is_constant(), len(entry)), 3)
    return tuple(Add(*(Mul(ring.expression(c), p) for c, p in zip(vector, coordinates)))
                 for _, vector in basis)
