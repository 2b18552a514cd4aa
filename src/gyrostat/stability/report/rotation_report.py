"""The report of permanent rotations in any direction, by the amended potential in closed form.

No matrix is derived. If trace and determinant of D²U_c across k, p and q do not decide, the rotation at the
numbers is asked.
"""
from dataclasses import replace

from sympy import Expr

from ..._cached import cached_property
from ...algebra.reals.exact import Point, sign, sign_changes
from ...errors import ScopeError
from ...mechanics.equilibrium.standard_axes import placed
from ..criteria.closed_form import closed_form
from ..criteria.conditions import Criterion
from ..criteria.energy_casimir import SecondVariation
from ..criteria.linearization import Linearization
from ..criteria.truth import holds
from ..damping.secular import KEEPS, Secular, lost, secular_of
from ..decision import Decision
from ..standing import Standing
from .report import Report

NO_MATRIX = ("in any direction k1, k2, k3 no matrix is derived, the conditions are in closed form: give a "
             "direction, permanent_rotation(scene, stereographic()), --direction stereographic")


class RotationReport(Report):
    """The report of a family in k1, k2, k3, by trace and determinant of D²U_c across k, by p and q.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> scene = gs.assemble(body, gs.general_potential())
    >>> print(gs.analyze(gs.permanent_rotation(scene)).sufficient)
    t > 0 and s > 0
    """

    @property
    def written_out(self) -> Report:
        """The report itself: in any direction conditions are not written out."""
        return self

    @property
    def linearization(self) -> Linearization:
        """Refuse: a matrix for all directions would have one pivot, which vanishes for some of them."""
        raise ScopeError(NO_MATRIX)

    @property
    def second_variation(self) -> SecondVariation:
        """Refuse, as the linearisation does."""
        raise ScopeError(NO_MATRIX)

    @property
    def casimirs_only(self) -> Criterion:
        """The formal criterion with the Casimirs alone, which is sufficient.

        Given integrals take part at numbers.
        """
        return self.sufficient

    @property
    def boundary(self) -> None:
        """None: between the two criteria the rotation at numbers is asked."""

    @property
    def recognised(self) -> None:
        """None: a body of revolution is recognised at numbers."""

    @property
    def required(self) -> tuple[str, ...]:
        """The names with which every verdict is answered: all of the scene."""
        return self.compared

    @cached_property
    def secular(self) -> "DampedRotation":
        """The second variation under internal damping, and what it decides."""
        return DampedRotation(self.equilibrium)

    def _by_rungs(self, standing: Standing) -> Decision:
        """Return the decision by t and s, then by p and q; else that of the rotation at these numbers."""
        if standing.sufficient or standing.necessary is False:
            return super()._by_rungs(standing)
        numbers = standing.numbers
        found = Report(placed(self.equilibrium, numbers)).decide(numbers, {})
        return replace(found, reason=f"at these numbers {found.reason}",
                       pointwise=found.pointwise or bool(found.certificate))


class DampedRotation(Secular):
    """The second variation of a permanent rotation in any direction, under internal damping."""

    @property
    def required(self) -> tuple[str, ...]:
        """The names with which every verdict is answered: all of the scene."""
        return self.compared

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision by t and s if the damping reaches every motion; else that at these numbers."""
        closed = closed_form(self.equilibrium)
        at = closed.with_names(numbers)
        if holds(self.criterion, at, margins):
            return KEEPS
        # M × k ≠ 0: k does not move by itself, and damping reaches every motion
        trace, determinant = (sign(x, at) for x in (closed.named.trace, closed.named.determinant))
        growing = determinant and sign_changes((trace, determinant))
        if growing and any(sign(x, numbers) for x in closed.momentum_across):
            return lost(growing)
        return secular_of(placed(self.equilibrium, numbers)).decide(numbers, {})
