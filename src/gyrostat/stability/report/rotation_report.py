"""The report of permanent rotations in any direction, by the amended potential in closed form.

No matrix is derived: trace and determinant of D²U_c across k, p and q decide.
"""
from collections.abc import Iterable
from dataclasses import replace

from sympy import Expr

from ..._cached import cached_property
from ...algebra.reals.exact import Point, evaluate, sign_changes, sign_of_constant
from ...errors import ScopeError
from ...mechanics.equilibrium.standard_axes import placed
from ..criteria.closed_form import ClosedForm, closed_form
from ..criteria.conditions import Criterion
from ..criteria.energy_casimir import SecondVariation
from ..criteria.linearization import Linearization
from ..damping.secular import KEEPS, Secular, lost, secular_of
from ..decision import Decision, Rung, settled
from ..ladder import GROWS
from ..notion import Notion
from .derived_parts import DEFINITE
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

    @cached_property
    def closed(self) -> ClosedForm:
        """The names in which the conditions are written."""
        return closed_form(self.equilibrium)

    @property
    def linearization(self) -> Linearization:
        """Refuse: a matrix for all directions would have one pivot, which vanishes for some of them."""
        raise ScopeError(NO_MATRIX)

    @property
    def second_variation(self) -> SecondVariation:
        """Refuse, as the linearisation does."""
        raise ScopeError(NO_MATRIX)

    @cached_property
    def necessary(self) -> Criterion:
        """The spectral criterion p ≥ 0, q ≥ 0, p² − 4q ≥ 0."""
        return self.closed.criterion(Notion.SPECTRAL)

    @cached_property
    def sufficient(self) -> Criterion:
        """The formal criterion t > 0, s > 0: D²U_c is positive definite across k."""
        return self.closed.criterion(Notion.FORMAL)

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

    @cached_property
    def compared(self) -> tuple[str, ...]:
        """The names that a verdict needs."""
        return self.closed.required

    @cached_property
    def required(self) -> tuple[str, ...]:
        """The names with which every verdict is answered: all of the scene."""
        return self.closed.required

    @cached_property
    def secular(self) -> "DampedRotation":
        """The second variation under internal damping, and what it decides."""
        return DampedRotation(self.equilibrium)

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision by t and s, then by p and q; else that of the rotation at these numbers."""
        form, own = self.closed.at(numbers), self.closed.named
        margins |= {own.trace: form.trace, own.determinant: form.determinant}
        if _signs([form.trace, form.determinant]) == [1, 1]:
            return settled(True, DEFINITE, Rung.SECOND_VARIATION)
        necessary = {own.p: form.p, own.q: form.q, own.discriminant: form.p**2 - 4 * form.q}
        margins |= necessary
        if -1 in _signs(necessary.values()):
            return settled(False, GROWS, Rung.SPECTRUM, Notion.SPECTRAL)
        found = Report(placed(self.equilibrium, numbers)).decide(numbers, {})
        return replace(found, reason=f"at these numbers {found.reason}",
                       pointwise=found.pointwise or bool(found.certificate))


class DampedRotation(Secular):
    """The second variation of a permanent rotation in any direction, under internal damping."""

    @cached_property
    def criterion(self) -> Criterion:
        """The secular criterion t > 0, s > 0."""
        return closed_form(self.equilibrium).criterion(Notion.SECULAR)

    @cached_property
    def compared(self) -> tuple[str, ...]:
        """The names that the criterion needs."""
        return closed_form(self.equilibrium).required

    @cached_property
    def required(self) -> tuple[str, ...]:
        """The names with which every verdict is answered: all of the scene."""
        return self.compared

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision by t and s if the damping reaches every motion; else that at these numbers."""
        closed = closed_form(self.equilibrium)
        form = closed.at(numbers)
        margins |= {closed.named.trace: form.trace, closed.named.determinant: form.determinant}
        trace, determinant = _signs([form.trace, form.determinant])
        if trace == determinant == 1:
            return KEEPS
        # M × k ≠ 0: k does not move by itself, and damping reaches every motion
        growing = determinant and sign_changes((trace, determinant))
        if growing and any(_signs([evaluate(x, numbers) for x in closed.momentum_across])):
            return lost(growing)
        return secular_of(placed(self.equilibrium, numbers)).decide(numbers, {})


def _signs(values: Iterable[Expr]) -> list[int | None]:
    return [sign_of_constant(x if x.is_Rational else evaluate(x, {})) for x in values]
