"""The stability analysis of one equilibrium, and its verdicts at exact numbers."""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from sympy import Expr

from ..._cached import cached_property
from ..._lazy import loaded
from ...algebra.reals.exact import Point
from ...arguments import checked
from ...errors import require
from ..criteria.conditions import sources
from ..criteria.number_notes import scene_note
from ..criteria.numbers_asked import exact_values, left_open, refuse_any_direction
from ..decision import Decision, undecided, with_margins
from ..ladder import Ladder

if TYPE_CHECKING:
    from ..normal_forms.d4_along_family import Window
    from ..normal_forms.normal_form import NormalForm


@dataclass(frozen=True, repr=False)
class Report(Ladder):
    """The stability analysis of one equilibrium; each part is derived when it is first asked for.

    Parameters
    ----------
    equilibrium : Equilibrium
    expanded : bool
        whether long conditions of permanent rotations are written out; default False: they are in names that
        are defined in turn

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> gs.analyze(gs.upright(top)).required
    ('I1', 'l', 'm0', 'pi3_0')
    """

    @cached_property
    def written_out(self) -> "Report":
        """The report with its conditions written out, polynomials in the names of the family; or itself."""
        return self if self.closed is None else replace(self, expanded=True)

    @property
    def along(self) -> "Report | None":
        """The report of the motions in which two parallel directions stay parallel; else None."""
        return None

    def verdict(self, values: Mapping[str, Any], damped: bool = False) -> Decision:
        """Return the verdict at given numbers, exactly, equality included.

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
            STABLE (Lyapunov, modulo what it says), UNSTABLE, or UNDECIDED: if no theorem of the ladder
            decides, or if the sign of a transcendental margin, or that the point is on the family, is not
            proved

        Raises
        ------
        ValuesError
            names are missing or unknown, a number is not finite, a moment is not positive, or the point is
            not on the family

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> report = gs.analyze(gs.upright(top))
        >>> numbers = {"I1": 1, "I3": "1/2", "l": 2, "pi3_0": 1, "dU": 2}
        >>> report.verdict(numbers).verdict
        <Verdict.STABLE: 'a sufficient condition for stability is proved to hold'>
        >>> free = gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0)))
        >>> spin = gs.analyze(gs.principal_rotation(free, 3))
        >>> spin.verdict({"omega3_0": 1}).verdict.name
        'STABLE'
        >>> spin.verdict({"omega3_0": 1}, damped=True).growing
        2
        """
        if damped is not False and damped is not True:
            require(damped, bool, "damped")
        judge = self.secular if damped else self
        return self._asked(values, judge.compared, judge.decide)

    def _asked(self, values: Mapping[str, Any], names: Sequence[str],
               decide: Callable[[Point, dict[Expr, Expr]], Decision]) -> Decision:
        """Return the decision of a decider at exact numbers, checked against the names that it needs."""
        numbers = exact_values(self.equilibrium, values, names, self.parameters)
        return self._decided(numbers, scene_note(self.equilibrium.system, numbers), decide)

    def _decided(self, numbers: Point, note: str,
                 decide: Callable[[Point, dict[Expr, Expr]], Decision]) -> Decision:
        """Return the decision of a decider at numbers that are checked, with a note on the scene."""
        margins: dict[Expr, Expr] = {}
        found = undecided(numbers.doubt) if numbers.doubt else decide(numbers, margins)
        return with_margins(found, margins, note,
                            sources(self.equilibrium, margins, (self.sufficient, self.necessary)))

    @checked
    def normal_form(self, values: Mapping[str, Any], degree: int = 4) -> "NormalForm":
        """Return Birkhoff's normal form of a body in a field near the equilibrium, on its coadjoint orbit.

        Parameters
        ----------
        values : mapping of name to number
            as in verdict; if U is unspecified, its derivatives up to the degree besides
        degree : int
            4 or 6, the degree in the canonical coordinates

        Returns
        -------
        NormalForm
            the signed frequencies, the coefficients of the actions, D4 and D6, the resonances; exact at
            rational numbers

        Raises
        ------
        ValuesError
            as in verdict
        ScopeError
            a free body; an unstable or degenerate equilibrium, or equal frequencies; a resonance that leaves
            a term which is no function of the actions

        References
        ----------
        Birkhoff, Dynamical Systems (1927), chapter III; Arnold, Sov. Math. Dokl. 2 (1961) 247-249, for D4.

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
        >>> report = gs.analyze(gs.upright(top))
        >>> numbers = {"I1": 1, "I3": 1, "l": 0, "m0": 2, "pi3_0": 3}
        >>> form = report.normal_form(numbers)
        >>> form.twists, form.resonances
        ((12,), ((1, 2),))
        """
        numbers = exact_values(self.equilibrium, values, self.required, self.parameters)
        return loaded("stability.normal_forms.normal_form:normal_form")(self.equilibrium, numbers, degree)

    @checked
    def window(self, values: Mapping[str, Any] | None = None) -> "Window":
        """Return D4 as a rational function of the names that have no number, and the conditions beside it.

        Parameters
        ----------
        values : mapping of name to number
            rational, for any of the names of a verdict; default none

        Returns
        -------
        Window

        Raises
        ------
        ValuesError
            a name is unknown, or a number is not admissible
        ScopeError
            a free body; a field, a point or a number that is not rational; too many names

        References
        ----------
        Arnold, Sov. Math. Dokl. 2 (1961) 247-249, for the theorem; the formula is derived (D4 by averages).

        Examples
        --------
        >>> import gyrostat as gs
        >>> body = gs.Gyrostat((5, 4, 3), (0, 0, 0))
        >>> scene = gs.assemble(body, gs.uniform_field())
        >>> report = gs.analyze(gs.upright(scene))
        >>> report.window({"m0": 1}).q
        (pi3_0**2 + 9)*(2*pi3_0**2 + 9)/1620
        >>> numbers = {"m0": 1, "pi3_0": 9}
        >>> report.window(numbers).D4 == report.normal_form(numbers).twists[0]
        True
        """
        refuse_any_direction(self.equilibrium)
        numbers = exact_values(self.equilibrium, values or {}, (), self.parameters)
        return loaded("stability.normal_forms.d4_along_family:window_of")(self.equilibrium, numbers)

    @checked
    def itself(self, values: Mapping[str, Any]) -> Decision:
        """Return the decision about the point itself, where verdict speaks of it modulo a flow.

        If verdict divides out no flow, the answer is the same. A tilted equilibrium that is stable modulo the
        spin is not Lyapunov stable as a point, with one exception: relative equilibria near it drift along
        its orbit (Drift). The margins have D, which is not 0 if the linearised flow grows too, by a Jordan
        block.

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
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> report = gs.analyze(gs.inclined(top))
        >>> values = {"I1": 4, "I3": 5, "l": 2, "omega": 1, "k3": 0, "d2U": 0}
        >>> report.verdict(values).verdict.name, report.itself(values).verdict.name
        ('STABLE', 'UNSTABLE')
        """
        return self._asked(values, self.compared, self.decide_point)


def both_verdicts(report: Report, values: Mapping[str, Any]) -> tuple[Decision, Decision]:
    """Return the verdict, and that under internal damping, at numbers that are checked once for both.

    The second one may need more names; it is undecided if they are not given.
    """
    eq, secular = report.equilibrium, report.secular
    numbers = exact_values(eq, values, report.compared, report.parameters)
    note = scene_note(eq.system, numbers)
    missing = ", ".join(left_open(secular.compared, numbers))
    damped = (undecided(f"give {missing} to decide") if missing
              else report._decided(numbers, note, secular.decide))
    return report._decided(numbers, note, report.decide), damped
