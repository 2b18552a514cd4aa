"""Report: the stability analysis of one equilibrium, and its verdicts at numbers."""
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from sympy import Expr

from ..algebra.exact import Point
from ..errors import require
from ..kept import cached_property
from ..mechanics.equilibria import Equilibrium
from ..mechanics.once import once
from ..mechanics.standard import Seen, seen, seen_at
from ..notation import Stored, symbol
from ..shown import Shown
from .boundary import Boundary, boundary_of
from .conditions import Criterion, independent, sources
from .criteria import formal_criterion, spectral_criterion
from .decision import Between, Decider, Decision, Verdict, settled
from .drift import Drift
from .elementary import Elementary
from .energy_casimir import SecondVariation, second_variation
from .linearization import Linearization, linearize
from .notes import scene_note
from .secular import Secular, secular_of
from .sphere import sphere_of
from .truth import holds
from .values import exact_values, names_accepted, names_needed


@dataclass(frozen=True, repr=False)
class Report(Shown, Stored):
    """The stability analysis of one equilibrium; each part is derived when it is first asked for.

    Parameters
    ----------
    equilibrium : Equilibrium

    Examples
    --------
    >>> import gyrostat as gs
    >>> report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    >>> report.required
    ('I1', 'l', 'm0', 'pi3_0')
    """

    equilibrium: Equilibrium

    def __post_init__(self) -> None:
        require(self.equilibrium, Equilibrium, "the equilibrium")

    @cached_property
    def linearization(self) -> Linearization:
        """The field on the tangent space of the coadjoint orbit."""
        return linearize(self.equilibrium)

    @cached_property
    def second_variation(self) -> SecondVariation:
        """With the Casimirs and the integrals of the scene."""
        return second_variation(self.equilibrium)

    @cached_property
    def necessary(self) -> Criterion:
        """Spectral criterion, reduced; modulo the flows of the sufficient one: a growing mode leaves them."""
        if self.recognised:
            return replace(_kept(self.recognised.equilibrium).necessary, modulo=self.recognised.modulo)
        return replace(independent(spectral_criterion(self.linearization), self.equilibrium),
                       modulo=self.second_variation.modulo)

    @cached_property
    def sufficient(self) -> Criterion:
        """Formal criterion with the Casimirs and the integrals, reduced to independent conditions."""
        if self.recognised:
            return replace(_kept(self.recognised.equilibrium).sufficient, modulo=self.recognised.modulo)
        return independent(formal_criterion(self.second_variation), self.equilibrium)

    @cached_property
    def casimirs_only(self) -> Criterion:
        """Formal criterion with the Casimirs alone, for comparison."""
        if not self.equilibrium.system.integrals:
            return self.sufficient
        return independent(formal_criterion(second_variation(self.equilibrium, integrals=False)),
                           self.equilibrium)

    @cached_property
    def damped(self) -> Criterion:
        """Secular criterion, of positive sign and, unlike casimirs_only, modulo the integrals' flows."""
        return self.secular.criterion

    @cached_property
    def secular(self) -> Secular:
        """What internal damping makes of it."""
        return secular_of(self.equilibrium)

    @cached_property
    def boundary(self) -> Boundary | None:
        """What decides where necessary holds and sufficient does not, for a body of revolution.

        None for other scenes; about another axis than the third, of the equilibrium in the standard scene.
        """
        return boundary_of(self.recognised.equilibrium if self.recognised else self.equilibrium)

    @property
    def between(self) -> Between | None:
        """What decides between the two criteria: the boundary, of a free body the momentum sphere."""
        return self.boundary or sphere_of(self.equilibrium)

    @cached_property
    def recognised(self) -> Seen | None:
        """The equilibrium in the axes of a body of revolution that is not entered in them, else None."""
        return seen(self.equilibrium)

    @cached_property
    def drift(self) -> Drift:
        """What moves near a tilted equilibrium along its orbit under the spin."""
        return Drift(self.recognised.equilibrium if self.recognised else self.equilibrium)

    @cached_property
    def required(self) -> tuple[str, ...]:
        """Names that a verdict needs."""
        return names_needed(self.equilibrium, (self.necessary, self.sufficient))

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Names that a verdict accepts; where U is unspecified, every derivative dU, d2U, … besides."""
        return names_accepted(self.equilibrium, self.required)

    def verdict(self, values: Mapping[str, Any], damped: bool = False) -> Decision:
        """The verdict at a point, exact, equality included.

        Parameters
        ----------
        values : mapping of name to number
            int, Fraction, Decimal, SymPy rational or algebraic number, a string such as "1/2", "0.1",
            "sqrt(3)/2"; a float is the dyadic rational it is
        damped : bool
            whether the body loses energy inside: the secular verdict, with Decision.growing

        Returns
        -------
        Decision
            STABLE (Lyapunov, modulo what it says), UNSTABLE, or UNDECIDED on the boundary and wherever the
            sign of a transcendental margin, or that the point is on the family, is not proved

        Raises
        ------
        ValuesError
            names are missing or unknown, a number is not finite, a moment is not positive, or the point is
            not on the family

        Examples
        --------
        >>> import gyrostat as gs
        >>> report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
        >>> report.verdict({"I1": 1, "I3": "1/2", "l": 2, "pi3_0": 1, "dU": 2}).verdict
        <Verdict.STABLE: 'a sufficient condition for stability is proved to hold'>
        >>> spin = gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0))), 3))
        >>> spin.verdict({"omega3_0": 1}).verdict.name, spin.verdict({"omega3_0": 1}, damped=True).growing
        ('STABLE', 2)
        """
        secular = self.secular if damped else None
        numbers = exact_values(self.equilibrium, values, (secular or self).required, self.parameters)
        margins: dict[Expr, Expr] = {}
        modulo = (self.damped if damped else self.sufficient).modulo
        stable, notion, why, growing = None, "", numbers.doubt, None
        if secular and not numbers.doubt:
            stable, why, growing, modulo = secular.decide(numbers, margins)
            notion = "" if stable is None else "secular"
        elif not numbers.doubt:
            stable, notion, why, modulo = self._decided(numbers, margins)
        return Decision(Verdict.of(stable), notion, modulo, why, tuple(margins.items()),
                        scene_note(self.equilibrium.system, numbers), growing,
                        sources(self.equilibrium, margins, (self.sufficient, self.necessary)))

    def itself(self, values: Mapping[str, Any]) -> Decision:
        """The decision on the point itself, where verdict speaks of it modulo a flow.

        Otherwise the same as verdict. A tilted equilibrium that is stable modulo the spin is not Lyapunov
        stable as a point: relative equilibria near it drift along its orbit (Drift). margins has D, which is
        not 0 where the linearised flow grows too, by a Jordan block.

        Parameters
        ----------
        values : mapping of name to number
            as in verdict

        Returns
        -------
        Decision
            not modulo anything

        Raises
        ------
        ValuesError
            as in verdict

        Examples
        --------
        >>> import gyrostat as gs
        >>> report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
        >>> values = {"I1": 4, "I3": 5, "l": 2, "omega": 1, "k3": 0, "d2U": 0}
        >>> report.verdict(values).verdict.name, report.itself(values).verdict.name
        ('STABLE', 'UNSTABLE')
        """
        decision = self.verdict(values)
        numbers = exact_values(self.equilibrium, values, self.required, self.parameters)
        known = (self.recognised or seen_at(self.equilibrium, numbers)) if decision.modulo else None
        if not decision.modulo or not (known or self.boundary) or decision.verdict is not Verdict.STABLE:
            return replace(decision, modulo=() if decision.verdict is Verdict.UNSTABLE else decision.modulo)
        margins: dict[Expr, Expr] = {}
        stable, why = (Drift(known.equilibrium) if known else self.drift).decide(numbers, margins)
        why = known.worded(why) if known else why
        return Decision(Verdict.of(stable), "" if stable is None else "Lyapunov", (), why,
                        tuple(margins.items()), decision.note)

    def _decided(self, numbers: Point, margins: dict[Expr, Expr]
                 ) -> tuple[bool | None, str, str, tuple[Expr, ...]]:
        """Whether it is stable, the notion, why, and the integrals whose flow is divided out."""
        modulo = self.sufficient.modulo
        sufficient = holds(self.sufficient, numbers, margins)
        if sufficient:
            return True, "Lyapunov", "the second variation is definite on the symplectic slice", modulo
        necessary = holds(self.necessary, numbers, margins)
        if necessary is False:
            return False, "spectral", "an eigenvalue has a positive real part", modulo
        if known := seen_at(self.equilibrium, numbers):
            standard = _kept(known.equilibrium)
            if missing := ", ".join(name for name in standard.required if symbol(name) not in numbers):
                return None, "", known.worded(f"give {missing} to decide"), known.modulo
            stable, notion, why, _ = standard._decided(numbers, margins)
            return stable, notion, known.worded(why), known.modulo
        if None in (sufficient, necessary):
            return None, "", "a margin has no proved sign", modulo
        decider: Decider | None = self.between
        stable, notion, why = (settled(*decider.decide(numbers, margins)) if decider
                               else self._elementary.decide(numbers))
        return stable, notion, self.recognised.worded(why) if self.recognised else why, modulo

    @cached_property
    def _elementary(self) -> Elementary:
        return Elementary(self.equilibrium, self.linearization,
                          lambda momentum: Report(momentum)._decided(Point({}), {})[::2])


@once
def _kept(eq: Equilibrium) -> Report:
    """The report of an equilibrium in the standard axes, derived once."""
    return Report(eq)
