"""The equations of the places at which relative equilibria meet.

For a body of revolution E3 leaves E1 or E2, and tilts meet; for a free gyrostat permanent rotations do.
"""
from contextlib import suppress
from dataclasses import dataclass

from sympy import Expr, Integer, S, Symbol, expand

from ..._display import Shown
from ...algebra.reals.exact import Point
from ...arguments import checked
from ...errors import EquilibriumError, ValuesError
from ...mechanics.equilibrium.reduced_series import powers_of_distance
from ...mechanics.equilibrium.reduction import K3, OMEGA, P, reduce
from ...mechanics.families.named_families import POLES
from ...mechanics.scenes.coupled import in_one_direction
from ...mechanics.scenes.system import System
from ...notation import Stored, jet, symbol
from ..finders.rate_level_tilt import MARKED, require_revolution
from .bifurcation_kinds import precessions_leave, tilt_leaves
from .free_meeting_equations import loci_of_rotations


@dataclass(frozen=True, repr=False)
class Bifurcation(Shown, Stored):
    """The equations of one kind of bifurcation.

    Parameters
    ----------
    kind : str
        a key of KINDS, which says what happens there
    equations : tuple of Expr
        vanish there; omega is the rate about the vertical, p_psi is π3 + l; for a free gyrostat M is the
        length of (M1, M2, M3)
    at : Expr
        the k3 at which derivatives of U are taken; for a free gyrostat ν, ω = ν M

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> first = gs.bifurcations(top)[0]
    >>> first.kind, first.equations
    ('E3 leaves E1', (I1*omega**2 - I3*omega**2 + dU - l*omega,))
    """

    kind: str
    equations: tuple[Expr, ...]
    at: Expr


@checked
def bifurcations(scene: System) -> tuple[Bifurcation, ...]:
    """Return the bifurcations of the relative equilibria of a scene, as equations.

    For a free gyrostat with l on a principal axis or in a principal plane they are in closed form; for any
    other one M and ν are parameters.

    Parameters
    ----------
    scene : System
        a body of revolution in U(k3), or any body without a field

    Returns
    -------
    tuple of Bifurcation
        each with what vanishes there, in the names of the scene and the derivatives of U, or M

    Raises
    ------
    ScopeError
        the body is not of revolution, or U is not U(k3)

    References
    ----------
    Lewis, Ratiu, Simo & Marsden, Nonlinearity 5 (1992) 1-48, for the heavy top; Cayley, On the centro-surface
    of an ellipsoid, for free gyrostats; else derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> for b in gs.bifurcations(top)[:5]:
    ...     print(b.kind)
    ...     for equation in b.equations:
    ...         print("   ", equation)
    E3 leaves E1
        I1*omega**2 - I3*omega**2 + dU - l*omega
    E3 leaves E2
        -I1*omega**2 + I3*omega**2 + dU - l*omega
    fold at fixed rate
        I1*k3*omega**2 - I3*k3*omega**2 + dU - l*omega
        I1*omega**2 - I3*omega**2 + d2U
    precessions leave E1
        4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2
    precessions leave E2
        -4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    >>> for b in gs.bifurcations(free):
    ...     print(b.kind, *b.equations, b.at, sep=": ")
    pitchfork: -4*M**2 + l**2: 1
    pitchfork: -M**2 + 4*l**2: 1/2
    """
    in_one_direction(scene.potential, "bifurcations")
    if scene.potential is None:
        return tuple(Bifurcation(*row) for row in loci_of_rotations(scene.body))
    require_revolution(scene, MARKED)
    relation, motion = relation_at_rate(scene), reduce(scene)
    slope = relation.diff(K3) + symbol("d2U")
    found: list[tuple[str, tuple[Expr, ...], Expr]] = [
        *((tilt_leaves(family), (relation.xreplace({K3: S(s)}),), S(s)) for s, family in POLES.items()),
        ("fold at fixed rate", (relation, slope), K3)]
    for family in POLES.values():
        with suppress(EquilibriumError):                   # U is infinite at the pole
            eq = family.of(scene)
            found.append((precessions_leave(family), (powers_of_distance(eq, 2)[Integer(2)],), eq.at))
    found.append(("fold on a level", (motion.precession(), motion.restoring()), K3))
    return tuple(Bifurcation(*row) for row in found)


def insert(scene: System, expression: Expr, at: Expr, numbers: Point, allowed: set[Symbol],
           what: str) -> Expr:
    """Insert the derivatives of U at a k3, and numbers for all names but those allowed."""
    assert scene.potential is not None
    jets = {d: scene.potential.value(d).xreplace({K3: at}) for d in expression.free_symbols if jet(d.name)}
    placed = expression.xreplace(jets).xreplace(numbers)
    if missing := sorted(s.name for s in placed.free_symbols - allowed):
        raise ValuesError(f"{what} needs {', '.join(missing)}: give a number for each")
    return placed


def relation_at_rate(scene: System) -> Expr:
    """Return U' − ω l + ω² k3 (I1 − I3), which vanishes for the precession without spin about the axis."""
    total = scene.body.moments[2] * OMEGA * K3 + scene.body.gyrostatic_momentum[2]
    return expand(reduce(scene).precession().xreplace({P: total}))
