"""The well of a permanent rotation in the frame that turns with it, which bounds every kick."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Matrix

from ...algebra.enclosures.precision import own_precision
from ...algebra.rings.matrices import adjugate
from ...errors import ScopeError
from ...stability.criteria.amended_form import dot, second_variation, trace
from ..finders.heavy_form import HeavyForm
from ..relative_equilibrium import RelativeEquilibrium
from .basin import Basin, filled
from .disturbances.kicks import kick_below
from .in_balls import BITS
from .landscape import turning_landscape
from .paths import Paths

NO_ROTATION = "a frame that turns with it is that of a permanent rotation of a body in a field"
NO_MINIMUM = ("in the frame that turns with it the energy has no strict minimum here: it bounds no kick that "
              "changes C1; ask for those across k, level=True")


@dataclass(frozen=True, repr=False)
class Frame(Basin):
    """The well of V = U − ω² k·Ik/2 − ω l·k round a permanent rotation, at its rate ω, for any C1 = M·k.

    In the frame that turns at this rate about the vertical V is the least energy at k, and V plus the square
    of what turns besides is constant: H − ω C1. So a motion that starts inside with less than the barrier
    keeps k inside for ever, whatever a kick has done to C1. It need not come back under damping: on another
    level of C1 the body may rest elsewhere inside. Its points are the rotations of the rate ω.

    References
    ----------
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59, for H − ω C1.
    """

    def kick(self, direction: Sequence[Any] | None = None) -> float:
        """Return the impulse of a torque below which k stays over this well, rounded down: as Well.kick."""
        if not self.found.passes:
            raise ScopeError(f"no kick is known to be small enough: {self.reason}")
        return kick_below(self.rotation, self.heights[self.found.passes[0]], direction, across=False)

    def value(self, e: RelativeEquilibrium) -> Expr:
        """Return V at a rotation of the rate: the energy less ω C1 [M L²/T²]."""
        return e.energy - self.rotation.rates["omega"] * Matrix(e.momentum).dot(Matrix(e.directions[0]))


def frame_of(rotation: RelativeEquilibrium) -> Frame:
    """Return the well in the frame that turns with a rotation, with a reason if there is none.

    Examples
    --------
    >>> import gyrostat as gs
    >>> field = gs.general_potential("k1 + k2 + k3")
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), field)
    >>> turning = frame_of(gs.relative_equilibria(scene, {"omega": "1/2"})[-1])
    >>> round(turning.barrier_double, 12), round(turning.kick(), 12), turning.kind
    (3.018517807625, 2.457037975948, 'summit')
    """
    if not isinstance(rotation.form, HeavyForm):
        return Frame(rotation, reason=NO_ROTATION)
    if index_at_rate(rotation) != 0:
        return Frame(rotation, reason=NO_MINIMUM)
    try:
        landscape = turning_landscape(rotation)
    except ScopeError as error:
        return Frame(rotation, reason=str(error))
    return filled(Frame(rotation), Paths(landscape, list(map(index_at_rate, landscape.points))))


def index_at_rate(rotation: RelativeEquilibrium) -> int | None:
    """Count the directions in which V falls from a rotation at its rate; None if that is not proved.

    Across k the second variation of V is D²U + μ − ω² I with μ = ω k·(ω Ik + l) − k·∇U, that of the amended
    potential without its square.
    """
    form = rotation.form
    if rotation.locus or not isinstance(form, HeavyForm):
        return None
    with own_precision(BITS):
        k, data, omega = form.in_balls(BITS)
        pull = [omega * (omega * dot(row, k) + l) - f
                for row, l, f in zip(data.inertia, data.rotor, data.gradient)]
        K = second_variation(data.inertia, dot(k, pull), data.hessian, [omega * 0] * 3, 1, omega)
        determinant, across = dot(k, [dot(row, k) for row in adjugate(K)]), trace(K) - dot(k, [
            dot(row, k) for row in K])
        if determinant < 0:
            return 1
        return None if not determinant > 0 or across.contains(0) else 0 if across > 0 else 2
