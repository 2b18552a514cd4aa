"""Says what decides a permanent rotation of a free body or gyrostat, and in which words."""
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from sympy import Add, Expr, S, sqrt

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.reals.exact import evaluate
from ...algebra.rings.matrices import adjugate
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.amended_form import dot, trace
from ...stability.decision import Decision, Rung, settled
from ...stability.form import PRECISION, Form, Invariants
from ...stability.notion import Notion
from ...stability.theorems.momentum_sphere import DRIFTS, extremum

ANYWHERE = settled(True, "M is constant in the body: all moments are equal, and there is no rotor",
                   Rung.SECOND_VARIATION)
AT_REST = settled(True, "M = 0 is the whole orbit", Rung.WHOLE_ORBIT)


@dataclass(frozen=True)
class FreeForm(Form):
    """A rotation about an axis fixed in body and space: the energy on the sphere of M = I ω + l.

    With ω = ν M, D = I⁻¹ − ν and Δ = M·adj(D) M the invariants, times abs(M)², are tr D abs(M)² − M·DM and Δ;
    the eigenvalues are ±√−Δ.

    Parameters
    ----------
    scene : System
        at given numbers
    M : tuple of Expr, shape (3,)
        exact [M L²/T]
    nu : Expr or None
        ν [1/(M L²)]; None if M = 0
    circle : tuple of Expr, shape (3,), or None
        along the axis about which the point may be turned: a circle of equilibria; (0, 0, 0) for any axis
    """

    LEAST = settled(True, "the energy is an extremum on the momentum sphere", Rung.SECOND_VARIATION)
    ODD = settled(False, "the energy is a saddle on the momentum sphere: an eigenvalue has a positive real "
                  "part", Rung.SPECTRUM, Notion.SPECTRAL)
    greatest = True
    label = "permanent rotation"
    scene: System
    M: tuple[Expr, ...]
    nu: Expr | None
    circle: tuple[Expr, ...] | None = None

    @property
    def described(self) -> tuple[tuple[str | Expr, Any], ...]:
        """The momentum M, which tells it from others."""
        return (("M", self.M),)

    @property
    def placed(self) -> Sequence[tuple[Sequence[str], Sequence[Expr | None]]]:
        """The components of π, by name."""
        return [(("pi1", "pi2", "pi3"), self.point)]

    @property
    def point(self) -> tuple[Expr, ...]:
        """The point π = M − l."""
        return tuple(m - l for m, l in zip(self.M, self.scene.body.gyrostatic_momentum))

    @property
    def rates(self) -> dict[str, Expr]:
        """The rate about M, negative if it is against M."""
        if self.nu is None:
            return {}
        return {"omega": evaluate(self.nu * sqrt(Add(*(m**2 for m in self.M))), {})}

    @property
    def rational(self) -> bool:
        """True: the spectrum is solved exactly, it is that of one number, Δ."""
        return True

    reached = True

    def invariants(self, precision: int | None) -> Invariants:
        """Return the invariants of the second variation and of the spectrum.

        In principal axes Δ = M₁² d₂ d₃ + M₂² d₃ d₁ + M₃² d₁ d₂ with dᵢ = 1/Iᵢ − ν.
        """
        if self.nu is None:
            return Invariants((S.Zero, S.Zero), (S.One, S.Zero))
        rows, M, nu = ((self.scene.body.inverse.tolist(), self.M, self.nu) if precision is None
                       else self.enclosed if precision == PRECISION else self._balls(precision))
        D = [[x - nu if i == j else x for j, x in enumerate(row)] for i, row in enumerate(rows)]
        along, across = ([dot(row, M) for row in matrix] for matrix in (D, adjugate(D)))
        curvature = dot(M, across)
        return Invariants((trace(D) * dot(M, M) - dot(M, along), curvature), (1, curvature))

    @cached_property
    def enclosed(self) -> tuple[list[list[Any]], list[Any], Any]:
        """The matrix I⁻¹, M and ν in balls, with the precision that decides."""
        return self._balls(PRECISION)

    def _balls(self, precision: int) -> tuple[list[list[Any]], list[Any], Any]:
        rows = [[ball(x, precision) for x in row] for row in self.scene.body.inverse.tolist()]
        assert self.nu is not None
        return rows, [ball(m, precision) for m in self.M], ball(self.nu, precision)

    def known(self) -> Decision | None:
        """Return the decision at M = 0, on a circle and on the whole sphere."""
        if self.nu is None:
            return AT_REST
        if self.circle is None:
            return None
        return on_circle(self.circle) if any(self.circle) else ANYWHERE

    def known_damped(self) -> Decision | None:
        """Return the decision under damping at M = 0."""
        return replace(AT_REST, notion=Notion.SECULAR, growing=0) if self.nu is None else None

    def known_point(self) -> Decision | None:
        """Return the decision on the point of a circle: others drift along it."""
        return settled(False, DRIFTS, Rung.DRIFT)

    def degenerate(self) -> Decision | None:
        """Return the decision by terms of the fourth order."""
        assert self.nu is not None
        return extremum(self.scene.body, self.M, self.nu).decision


def on_circle(axis: tuple[Expr, ...]) -> Decision:
    """Return the decision on a circle of rotations about an axis, modulo the turns about it."""
    along = Add(*(x * symbol(f"pi{n}") for n, x in enumerate(axis, 1)))
    return settled(True, "the momentum along the axis of the circle is conserved, and on its level nothing "
                   "else moves", Rung.SECOND_VARIATION, modulo=(along,))
