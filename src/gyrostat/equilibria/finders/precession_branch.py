"""One relative equilibrium of a body of revolution, in the axes of its scene."""
from dataclasses import dataclass, replace

from sympy import Expr, ImmutableMatrix, S, sqrt

from ..._display import Shown
from ...mechanics.equilibrium.recognition import Recognition
from ...mechanics.equilibrium.reduction import K3
from ...mechanics.scenes.functions_on_sphere import lowest
from ...notation import Stored
from ...stability.decision import Decision

# the label of a regular precession that is none of E3
PRECESSION = "precession"


@dataclass(frozen=True, repr=False)
class Branch(Shown, Stored):
    """One relative equilibrium: ω = omega k + sigma e3.

    Parameters
    ----------
    label : str
        "E1", "E2", "E3" (sigma = 0), or "precession": a periodic orbit of the Lie-Poisson field, E3 of the
        body whose rotor carries l + I3 sigma
    k3 : Expr or None
        None: every k3 between −1 and 1
    omega : Expr or None
        rate about the vertical [1/T]; None: every rate
    sigma : Expr or None
        rate about the axis of the body on top of it [1/T]; None where it varies along a continuum
    pi3 : Expr or None
        axial momentum of the locked body [M L²/T]
    decision : Decision
        E3 and precessions: modulo the spin
    itself : Decision or None
        of an E3, what holds for the point itself
    along : Expr
        what k3 is in the coordinates of the scene; sigma, pi3 are along that axis as well
    point : tuple of Expr or None
        in the coordinates of a scene that was recognised; None of any other, and of a continuum
    damped : Decision or None
        under internal damping; None of a precession, in which ω turns in the body: no equilibrium there

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> found = gs.relative_equilibria(top, {"I1": 2, "I3": 1, "l": 0, "m0": 3, "omega": 2})
    >>> [(branch.label, branch.k3, branch.decision.verdict.name) for branch in found]
    [('E1', 1, 'UNSTABLE'), ('E3', -3/4, 'STABLE'), ('E2', -1, 'STABLE')]
    """

    label: str
    k3: Expr | None
    omega: Expr | None
    sigma: Expr | None
    pi3: Expr | None
    decision: Decision
    itself: Decision | None = None
    along: Expr = K3
    point: tuple[Expr, ...] | None = None
    damped: Decision | None = None


def in_axes_of(found: Recognition, branch: Branch) -> Branch:
    """A branch of the standard scene in the axes of the scene that was recognised.

    Its margins, in the names of the standard one, go.
    """
    point = None
    if branch.k3 is not None and branch.omega is not None and branch.pi3 is not None:
        k1 = S.Zero if branch.k3**2 == 1 else sqrt(1 - branch.k3**2)
        pi = found.standard.body.moments[0] * branch.omega * k1, S.Zero, branch.pi3
        point = tuple(x for v in (pi, (k1, S.Zero, branch.k3)) for x in found.rotation.T * ImmutableMatrix(v))
    along = lowest(sum((x * k for x, k in zip(found.axis, found.scene.space.coordinates[3:])), S.Zero))
    decision, itself, damped = (None if d is None else _decision(found, d)
                                for d in (branch.decision, branch.itself, branch.damped))
    assert decision is not None
    return replace(branch, decision=decision, itself=itself, along=along, point=point, damped=damped)


def _decision(found: Recognition, decision: Decision) -> Decision:
    return replace(decision, modulo=decision.modulo and (found.modulo,),
                   reason=f"{found.sentence}: {found.worded(decision.reason)}",
                   margins=())
