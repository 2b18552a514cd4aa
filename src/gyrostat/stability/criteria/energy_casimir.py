"""The energy-Casimir method (Arnold): multipliers, and the second variation on the symplectic slice."""
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, ImmutableMatrix, S, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.rings.matrices import blocks, determinant, immutable, multiply, row_reduce
from ...arguments import checked
from ...mechanics.equilibrium.coadjoint_orbit import (
    critical_integrals,
    differentials,
    orbit_modulo_symmetries,
    orbit_tangent,
    slice_and_symmetries,
)
from ...mechanics.equilibrium.derivation_ring import rows_at_point, signs_over
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...notation import Stored, symbol


@dataclass(frozen=True, repr=False)
class SecondVariation(Shown, Stored):
    """D²(h + ν·F) on the symplectic slice, F the Casimirs and the integrals that are critical there.

    From secular_variation, F are the Casimirs, and the space is the orbit modulo the flows of the integrals.

    Parameters
    ----------
    equilibrium : Equilibrium
    basis : ImmutableMatrix, shape (n, m)
        its columns span the slice
    matrix : ImmutableMatrix, shape (m, m)
        symmetric, in that basis
    multipliers : tuple of (F, ν)
    free : tuple of Symbol
        multipliers that the first variation leaves free
    modulo : tuple of Expr
        integrals whose flow is divided out

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> variation = gs.derivation.second_variation(gs.inclined(top))
    >>> variation.minors[0], variation.modulo
    (1/I1, (pi3,))
    """

    equilibrium: Equilibrium
    basis: ImmutableMatrix
    matrix: ImmutableMatrix
    multipliers: tuple[tuple[Expr, Expr], ...]
    free: tuple[Symbol, ...]
    modulo: tuple[Expr, ...]

    @cached_property
    def minors(self) -> tuple[Expr, ...]:
        """The leading principal minors, of order 1 to m.

        The form is positive definite if all are positive, negative definite if their signs are −, +, −, …
        """
        ring = signs_over(self.equilibrium, self.matrix.flat()).ring
        rows, bottom = ring.matrix(self.matrix.tolist())
        return tuple(ring.quotient(determinant(ring, [row[:n] for row in rows[:n]]), bottom**n)
                     for n in range(1, len(rows) + 1))

    @cached_property
    def block_minors(self) -> tuple[tuple[int, Expr], ...]:
        """The leading principal minors of each block of the matrix, with their orders."""
        ring = signs_over(self.equilibrium, self.matrix.flat()).ring
        rows, bottom = ring.matrix(self.matrix.tolist())
        return tuple((n, ring.quotient(determinant(ring, [[rows[i][j] for j in block[:n]]
                                                          for i in block[:n]]), bottom**n))
                     for block in blocks(rows) for n in range(1, len(block) + 1))


@checked
def multipliers(eq: Equilibrium, functions: Sequence[Expr]) -> tuple[Expr, ...]:
    """Return the ν with ∇h + Σ νⱼ ∇Fⱼ = 0 at the equilibrium.

    Those left free are the symbols nu1, nu2, … of their functions. The last functions are determined first:
    if an integral is critical, the multiplier of the first Casimir is free.

    Parameters
    ----------
    eq : Equilibrium
    functions : sequence of Expr
        Casimirs, then integrals

    Returns
    -------
    tuple of Expr
        one for each function

    References
    ----------
    Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.derivation.multipliers(gs.upright(top), top.space.casimirs)
    (-pi3_0/I3, (-I3*dU/2 + l*pi3_0/2 + pi3_0**2/2)/I3)
    """
    columns = differentials(eq, functions)
    energy = eq.energy_gradient
    signs = signs_over(eq, [*(entry for column in columns for entry in column), *energy])
    ring = signs.ring
    rows = [ring.matrix([row])[0][0] for row in zip(*columns, energy)]
    # pivots: the last functions first, of their entries one that vanishes nowhere, and then a short one
    solved = dict(row_reduce(ring, rows, lambda j, entry: (-j, not signs.nonzero(entry), len(entry)),
                             len(functions)))
    free = [j for j in range(len(functions)) if j not in solved]
    values: dict[int, Expr] = {j: symbol(f"nu{j + 1}") for j in free}
    for j, row in solved.items():
        values[j] = ring.quotient(-row[-1], row[j]) - sum((ring.quotient(row[f], row[j]) * values[f]
                                                           for f in free), S.Zero)
    return tuple(values[j] for j in range(len(functions)))


@checked
def augmented_hessian(eq: Equilibrium, functions: Sequence[Expr]) -> ImmutableMatrix:
    """Return D²(h + Σ νⱼ Fⱼ) at the equilibrium, ν its multipliers.

    Parameters
    ----------
    eq : Equilibrium
    functions : sequence of Expr
        Casimirs, then integrals

    Returns
    -------
    ImmutableMatrix, shape (n, n)

    References
    ----------
    As of `multipliers`; derived in docs/explanation/derivations/conditions.md, sections 5 and 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> casimirs = scene.space.casimirs
    >>> gs.derivation.augmented_hessian(gs.upright(scene), casimirs)[0, 3]
    -pi3_0/I3
    """
    return ImmutableMatrix(_augmented(eq, zip(functions, multipliers(eq, functions))))


def _augmented(eq: Equilibrium, with_multipliers: Iterable[tuple[Expr, Expr]]) -> list[list[Expr]]:
    total = rows_at_point(eq, eq.system.energy_hessian)
    for function, nu in with_multipliers:
        hessian = rows_at_point(eq, eq.system.space.hessian(function))
        total = [[a + nu * b if b else a for a, b in zip(*rows)] for rows in zip(total, hessian)]
    return total


@checked
def second_variation(eq: Equilibrium, integrals: bool = True) -> SecondVariation:
    """Return the second variation of the augmented Hamiltonian at an equilibrium, on the symplectic slice.

    Parameters
    ----------
    eq : Equilibrium
    integrals : bool
        whether the integrals of the scene are used beside the Casimirs: one that is critical on the orbit
        adds a free multiplier, any other is held fixed and its flow divided out

    Returns
    -------
    SecondVariation

    Raises
    ------
    SingularOrbitError
        the differentials of the Casimirs are dependent there

    References
    ----------
    Vera & Viguera (2003), §4.1.2; with momentum maps Simo, Lewis & Marsden (1991), Ortega & Ratiu (1999).

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> variation = gs.derivation.second_variation(gs.inclined(top))
    >>> variation.matrix.shape, variation.modulo
    ((2, 2), (pi3,))
    """
    if not integrals:
        return restricted(eq, (orbit_tangent(eq), ()), eq.system.space.casimirs)
    functions = eq.system.space.casimirs + critical_integrals(eq)[0]
    return restricted(eq, slice_and_symmetries(eq), functions)


@checked
def secular_variation(eq: Equilibrium) -> SecondVariation:
    """Return the second variation with the Casimirs alone, modulo the flows of the integrals.

    Parameters
    ----------
    eq : Equilibrium

    Returns
    -------
    SecondVariation
        without free multipliers

    References
    ----------
    Bloch, Krishnaprasad, Marsden & Ratiu, Ann. Inst. H. Poincaré Anal. Non Linéaire 11 (1994) 37-90.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> variation = gs.derivation.secular_variation(gs.inclined(top))
    >>> variation.matrix.shape, variation.modulo
    ((3, 3), (pi3,))
    """
    return restricted(eq, orbit_modulo_symmetries(eq), eq.system.space.casimirs)


def restricted(eq: Equilibrium, slice_: tuple[ImmutableMatrix, tuple[Expr, ...]],
               functions: tuple[Expr, ...]) -> SecondVariation:
    """Return the second variation with given Casimirs and integrals, on a slice modulo its symmetries."""
    (basis, symmetries), nu = slice_, multipliers(eq, functions)
    ring, form, bottom = form_on(eq, basis, zip(functions, nu))
    matrix = immutable([[ring.quotient(entry, bottom) for entry in row] for row in form], basis.cols)
    free = tuple(value for j, value in enumerate(nu, 1) if value == symbol(f"nu{j}"))
    return SecondVariation(eq, basis, matrix, tuple(zip(functions, nu)), free, symmetries)


def form_on(eq: Equilibrium, basis: ImmutableMatrix, with_multipliers: Iterable[tuple[Expr, Expr]]) -> Any:
    """Return the second variation on the columns of a basis: a ring, polynomials, and their denominator."""
    form, vectors = _augmented(eq, with_multipliers), basis.tolist()
    ring = signs_over(eq, [entry for row in (*form, *vectors) for entry in row]).ring
    (rows, bottom), (columns, _) = ring.matrix(form), ring.matrix(vectors)
    across = [list(column) for column in zip(*columns)]
    return ring, multiply(ring, across, multiply(ring, rows, columns)) if basis.cols else [], bottom
