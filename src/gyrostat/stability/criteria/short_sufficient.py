"""Gives a short sufficient condition for a permanent rotation, by a part of K that is diagonal."""
from sympy import Expr, S

from ...algebra.rings.polynomials import lowest_terms
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.kind import Kind
from ..notion import Notion
from .closed_form import closed_form
from .conditions import Criterion, all_positive


def short_sufficient(eq: Equilibrium) -> Criterion | None:
    """Return conditions that suffice for stability, and are short; None if this method gives none.

    Across k, K = N + v vᵀ/J with N = D²U + μ − omega² I and J > 0, so that K is positive if N is. N is
    looked at where it is diagonal: then its entries have to be positive. One of them may be 0 if k has a
    component along its axis, because no vector across k lies on that axis.

    Parameters
    ----------
    eq : Equilibrium
        a permanent rotation of a body in a field of one direction

    Returns
    -------
    Criterion or None
        sufficient, and in general not necessary

    References
    ----------
    Derived in docs/explanation/derivations/amended-potential.md, section 3, which has K.

    Examples
    --------
    >>> import gyrostat as gs
    >>> a, I1, I2, I3 = map(gs.symbol, ("a", "I1", "I2", "I3"))
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> scene = gs.assemble(body, gs.general_potential(lambda k1, k2, k3: a * k3))
    >>> turning = gs.permanent_rotation(scene, (0, 0, 1))
    >>> print(short_sufficient(turning))
    I₁ ω² + σ < 0 and I₂ ω² + σ < 0
    """
    if eq.system.kind is not Kind.FIELD or eq.system.integrals or not any(eq.point[:3]):
        return None
    inertia, _, hessian, k, omega, mu = closed_form(eq).forms
    part = [[lowest_terms(hessian[i][j] - omega**2 * inertia[i][j] + (mu if i == j else 0)) for j in range(3)]
            for i in range(3)]
    if any(part[i][j] != 0 for i in range(3) for j in range(3) if i != j):
        return None
    asked: list[tuple[str, Expr]] = []
    for i in range(3):
        across = any(k[j] != 0 for j in range(3) if j != i)
        if part[i][i] != 0 and across:                     # nothing across k lies on the axis of k itself
            asked.append((f"K{i + 1}{i + 1}", part[i][i]))
        elif across:
            asked.append((f"k{i + 1}", S(k[i]) ** 2))
    if sum(name.startswith("k") for name, _ in asked) > 1:
        return None
    found = all_positive(Notion.FORMAL, asked, eq, eq.domain)
    return found if found.alternatives else None
