"""Tangent space of the coadjoint orbit, and the symplectic slice inside it, as kernels of differentials."""
from collections.abc import Sequence

from sympy import Expr, ImmutableMatrix, S

from ...algebra.rings.matrices import applied, immutable, null_space, row_reduce
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.margins import Signs
from ...arguments import checked
from ...errors import SingularOrbitError
from .derivation_ring import rows_at_point, signs_over
from .derived_once import once
from .equilibrium import Equilibrium
from .parallel_directions import parallel


def differentials(eq: Equilibrium, functions: Sequence[Expr]) -> list[list[Expr]]:
    """Return dF at the equilibrium, one row for each function."""
    return [[entry for (entry,) in rows_at_point(eq, eq.system.space.gradient(f))] for f in functions]


@checked
@once
def orbit_tangent(eq: Equilibrium) -> ImmutableMatrix:
    """Return a basis of the tangent space of the coadjoint orbit, T = {δx : dC(δx) = 0}.

    On e(3)* these are δπ·k + M·δk = 0 and δk·k = 0. The free coordinates of the basis form a diagonal.

    Parameters
    ----------
    eq : Equilibrium

    Returns
    -------
    ImmutableMatrix, shape (n, n - r)
        one column for each vector; r Casimirs

    Raises
    ------
    SingularOrbitError
        the differentials of the Casimirs are dependent there

    References
    ----------
    Vera & Viguera (2003), §4.1.1; derived in docs/explanation/derivations/conditions.md, section 3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.derivation.orbit_tangent(gs.upright(top)).T
    Matrix([
    [1, 0, 0, 0, 0, 0],
    [0, 1, 0, 0, 0, 0],
    [0, 0, 0, 1, 0, 0],
    [0, 0, 0, 0, 1, 0]])
    """
    return _kernel(eq, regular_differentials(eq))


@once
def regular_differentials(eq: Equilibrium) -> tuple[list[Expr], ...]:
    """Return dC of the Casimirs, proved independent somewhere on the family."""
    casimirs = eq.system.space.casimirs
    rows = differentials(eq, casimirs)
    if (rank := _rank(eq, rows)) < len(casimirs):
        raise SingularOrbitError(
            f"{eq.label} lies on a singular coadjoint orbit: the differentials of "
            f"{', '.join(map(str, casimirs))} have rank {rank}, "
            f"not {len(casimirs)}. {_remedy(eq)}")
    return tuple(rows)


def _remedy(eq: Equilibrium) -> str:
    """Return why the orbit is singular, and what to do."""
    directions = eq.system.potential.directions if eq.system.potential else ()
    if parallel(eq):
        return (f"The directions {' and '.join(directions)} are parallel there: use analyze(eq), or "
                "parallel_directions(eq), the scene of the motions in which they stay so.")
    return ("The energy-Casimir test does not apply there; choose a point with "
            + (f"{directions[0]} ≠ 0." if directions else "M ≠ 0."))


@once
def critical_integrals(eq: Equilibrium) -> tuple[tuple[Expr, ...], tuple[Expr, ...]]:
    """Return the linear integrals whose differentials depend on those of the Casimirs, and the others."""
    rows = list(regular_differentials(eq))
    critical, moving = [], []
    for integral in eq.system.linear_integrals:
        row = differentials(eq, (integral,))
        if _rank(eq, rows + row) > len(rows):
            moving.append(integral)
            rows += row
        else:
            critical.append(integral)
    return tuple(critical), tuple(moving)


def is_critical(eq: Equilibrium, function: Expr) -> bool:
    """Tell whether the differential of a function depends on those of the Casimirs there."""
    rows = list(regular_differentials(eq))
    return _rank(eq, rows + differentials(eq, (function,))) == len(rows)


@checked
def symplectic_slice(eq: Equilibrium) -> ImmutableMatrix:
    """Return a basis of the symplectic slice.

    That is the tangent space of the level set of Casimirs and integrals, modulo the flows of the integrals.
    At E1 and E2 it is the whole tangent space of the orbit; at E3 it has dimension 2: dπ3(δx) = 0, modulo the
    rotation about the axis of the body.

    Parameters
    ----------
    eq : Equilibrium

    Returns
    -------
    ImmutableMatrix, shape (n, m)
        one column for each vector

    Raises
    ------
    SingularOrbitError
        the differentials of the Casimirs are dependent there

    References
    ----------
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59; Ortega & Ratiu, Nonlinearity 12 (1999)
    693-720; at E3 derived in docs/explanation/derivations/conditions.md, section 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> for eq in (gs.upright(top), gs.inclined(top)):
    ...     print(gs.derivation.symplectic_slice(eq).shape)
    (6, 4)
    (6, 2)
    """
    return slice_and_symmetries(eq)[0]


@once
def slice_and_symmetries(eq: Equilibrium) -> tuple[ImmutableMatrix, tuple[Expr, ...]]:
    """Return the symplectic slice, and the integrals whose flow was divided out."""
    _, moving = critical_integrals(eq)
    if not moving:
        return orbit_tangent(eq), ()
    gradients, flows = differentials(eq, moving), _flows(eq, moving)
    tangent = _isotropy(eq, gradients, flows) if len(moving) > 1 else [[S.One]]
    along = [applied(zip(*flows), vector) for vector in tangent]
    symmetries = tuple(applied(tangent, moving))
    return _kernel(eq, [*regular_differentials(eq), *gradients, *_gauges(eq, along)]), symmetries


def _isotropy(eq: Equilibrium, gradients: Sequence[Sequence[Expr]],
              flows: Sequence[Sequence[Expr]]) -> list[list[Expr]]:
    """Return the combinations of integrals whose flows are tangent to the level of all of them.

    They are those that their brackets annihilate: the isotropy algebra of the value of the momentum map.
    """
    ring, _, rows = _polynomials(eq, [*gradients, *flows])
    count = len(flows)
    brackets = [[ring.reduce(sum((x * y for x, y in zip(gradient, flow)), ring.zero))
                 for flow in rows[count:]] for gradient in rows[:count]]
    found = []
    for _, vector in null_space(ring, brackets, lambda j, entry: (not entry.is_constant(), len(entry),
                                                                      -j), count):
        first = next(filter(None, vector))
        found.append([ring.expression(-x if first.leading_coefficient() < 0 else x) for x in vector])
    return found


@once
def orbit_modulo_symmetries(eq: Equilibrium) -> tuple[ImmutableMatrix, tuple[Expr, ...]]:
    """Return a basis of the tangent space of the orbit modulo the flows of the integrals, none held.

    The integrals whose flow was divided out come second: one coordinate that each moves is held.
    """
    _, moving = critical_integrals(eq)
    if not moving:
        return orbit_tangent(eq), ()
    return _kernel(eq, [*regular_differentials(eq), *_gauges(eq, _flows(eq, moving))]), moving


def _flows(eq: Equilibrium, integrals: Sequence[Expr]) -> list[list[Expr]]:
    """Return the Hamiltonian field of each integral at the equilibrium."""
    space = eq.system.space
    fields = [applied(space.tensor.tolist(), space.gradient(F).flat()) for F in integrals]
    return [[eq.at_point(rate) for rate in field] for field in fields]


def _gauges(eq: Equilibrium, flows: Sequence[Sequence[Expr]]) -> list[list[Expr]]:
    """Return the coordinates to be held, one for each flow, as rows.

    If there are any, those are taken that a flow moves everywhere on the family.
    """
    if not flows:
        return []
    ring, signs, rows = _polynomials(eq, flows)
    size = len(flows[0])
    held = row_reduce(ring, rows, lambda j, entry: (not signs.nonzero(entry), len(entry), -j), size)
    return [[S.One if j == column else S.Zero for j in range(size)] for column, _ in held]


def _polynomials(eq: Equilibrium, rows: Sequence[Sequence[Expr]]) -> tuple[Ring, Signs, list]:
    signs = signs_over(eq, [entry for row in rows for entry in row])
    return signs.ring, signs, [signs.ring.matrix([row])[0][0] for row in rows]


def _kernel(eq: Equilibrium, rows: Sequence[Sequence[Expr]]) -> ImmutableMatrix:
    """Return a basis of the common kernel; pivots that vanish nowhere on the family are preferred."""
    ring, signs, polynomials = _polynomials(eq, rows)
    size = len(eq.system.space.coordinates)
    basis = null_space(ring, polynomials, lambda j, entry: (not signs.nonzero(entry), len(entry),
                                                            entry.total_degree(), -j), size)
    return immutable([[ring.expression(vector[i]) for _, vector in basis] for i in range(size)], len(basis))


def _rank(eq: Equilibrium, rows: Sequence[Sequence[Expr]]) -> int:
    ring, _, polynomials = _polynomials(eq, rows)
    return len(row_reduce(ring, polynomials, lambda j, entry: len(entry), len(rows[0])))
