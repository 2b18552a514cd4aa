"""Decides by integrals that the user gives, if the second variation with the Casimirs alone is indefinite.

The method is that of Arnold and of Holm, Marsden, Ratiu & Weinstein: a combination h + Σ α F may have a
definite second variation.
"""
from dataclasses import replace
from typing import Any

from flint import fmpq_mpoly
from sympy import Expr, ImmutableMatrix, S

from ...algebra.reals.exact import Point, evaluate
from ...algebra.rings.matrices import multiply
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.definite_combination import definite_combination
from ...algebra.solving.margins import Signs
from ...errors import EquilibriumError
from ...mechanics.equilibrium.coadjoint_orbit import critical_integrals, is_critical, orbit_tangent
from ...mechanics.equilibrium.derivation_ring import rows_at_point
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.standard_axes import placed
from ...mechanics.scenes.system import names_of_scene
from ..criteria.conditions import Criterion
from ..criteria.energy_casimir import restricted
from ..criteria.linearization import Linearization
from ..criteria.three_criteria import spectral_criterion
from ..decision import C1, Decision, Rung, settled, undecided
from ..notion import Notion


def integral_criterion(linearization: Linearization) -> Criterion:
    """Return the criterion that for some α the second variation of h + α F is definite on the orbit.

    It is sufficient for stability. F is a given integral that is critical there. If p, q and p² − 4q are
    positive, there are two oscillations, and the linearised flow B of F, which commutes with that of h, A, is
    a A + b A³: a suitable α exists iff b ≠ 0, which eliminates α. Points at which one of the three vanishes,
    and integrals that are conserved for C1 = 0 only, are decided by Report.verdict.

    Parameters
    ----------
    linearization : Linearization
        of a body in a field

    Returns
    -------
    Criterion
        of the notion "formal", an alternative for each F

    References
    ----------
    Derived; Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116, for h + α F.
    """
    eq = linearization.equilibrium
    used = [F for F in eq.system.given_integrals if F not in eq.system.level_only and is_critical(eq, F)]
    if not used or critical_integrals(eq)[1] or len(linearization.coefficients) < 2:
        return Criterion(Notion.FORMAL, ())
    p, q, discriminant = (replace(c, strict=True) for c in spectral_criterion(linearization).alternatives[0])
    found = [_where_none(eq, F) for F in used]
    return Criterion(Notion.FORMAL, tuple(
        (p, q, replace(discriminant, degenerate=(*discriminant.degenerate, *factors)))
        for factors in found if factors is not None))


def _where_none(eq: Equilibrium, F: Expr) -> tuple[Expr, ...] | None:
    """Return what vanishes if b = 0: the factors of tr A² tr A³B − tr A⁴ tr AB = 4 b q (p² − 4q).

    None if that is 0 everywhere. The identity follows from tr A² = −2p, tr A⁴ = 2(p² − 2q), tr A⁶ = −2p (p² −
    3q). A and B are the derivatives of both fields in all coordinates. Both map into the tangent space of the
    orbit, so that these traces are those on the orbit.
    """
    space = eq.system.space
    field = space.tensor * space.gradient(F)
    rows = [[[eq.insert_field(entry) for entry in row] for row in rows_at_point(eq, matrix)]
            for matrix in (eq.system.jet_jacobian, field.jacobian(space.coordinates))]
    signs = Signs.over([entry for matrix in rows for row in matrix for entry in row], eq.existence())
    ring = signs.ring
    A, B = (ring.matrix(matrix)[0] for matrix in rows)
    square = multiply(ring, A, A)
    AB = multiply(ring, A, B)
    value = (_trace(ring, square) * _trace(ring, multiply(ring, square, AB))
             - _trace(ring, multiply(ring, square, square)) * _trace(ring, AB))
    value = ring.reduce(value)
    return tuple(map(ring.expression, signs.split(value**2, ring.one)[1])) if value else None


def _trace(ring: Ring, matrix: list[Any]) -> fmpq_mpoly:
    return sum((row[n] for n, row in enumerate(matrix)), ring.zero)


def decide_by_integrals(eq: Equilibrium, numbers: Point) -> Decision:
    """Return STABLE if the second variation of h + Σ α F is definite on the orbit for some α.

    The F are the given integrals that are critical there on the orbit. If none is used, the reason says why,
    or is "".

    References
    ----------
    Arnold, Sov. Math. Dokl. 6 (1965) 331-334; Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116.
    """
    if not eq.system.given_integrals:
        return undecided("")
    if missing := sorted(s.name for s in names_of_scene(eq.system)
                         if evaluate(eq.insert(s), numbers).free_symbols):
        return undecided(f"give {', '.join(missing)} to decide by the integrals")
    try:
        here = placed(eq, numbers)
    except EquilibriumError:                               # the point is not proved to be an equilibrium
        return undecided("")
    if critical_integrals(here)[1]:                        # a flow has to be divided out: not done here
        return undecided("")
    names = {F: f"F{n}" for n, F in enumerate(here.system.integrals, 1)}
    on_level, idle, used = here.system.integrals_at(here.point), list[str](), list[Expr]()
    for F in here.system.integrals:
        if F not in on_level:
            idle.append(f"{names[F]} is conserved where M·k = 0 only")
        elif not is_critical(here, F):
            idle.append(f"{names[F]} is not critical there on the orbit")
        else:
            used.append(F)
    if not used:
        return undecided(", ".join(idle))
    variation = restricted(here, (orbit_tangent(here), ()), (*used, *here.system.space.casimirs))
    others = [ImmutableMatrix(variation.matrix.diff(nu)) for nu in variation.free]
    found = definite_combination(variation.matrix.xreplace(dict.fromkeys(variation.free, S.Zero)), others)
    if found is None:
        tried = "".join(f" + α {names[F]}" for F in used)
        return undecided("; ".join([*idle, f"no h{tried} was found that is definite"]))
    taken = [(F, a) for F, a in zip(used, found) if a]
    terms = "".join(f" {'+' if a > 0 else '−'} {f'{abs(a)} ' if abs(a) != 1 else ''}{names[F]}"
                    for F, a in taken)
    level = (C1,) if any(F in here.system.level_only for F, _ in taken) else ()
    return settled(True, f"the second variation of h{terms} is definite on the orbit, "
                   + ", ".join(f"{names[F]} = {F}" for F, _ in taken), Rung.INTEGRAL, level=level,
                   pointwise=True, certificate=tuple(taken))
