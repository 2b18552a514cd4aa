"""Tells whether an equilibrium stays stable if the body loses energy inside, by Kelvin, Tait and Chetaev.

Fuel that sloshes, a nutation damper, joints that give: they take energy, keep the Casimirs, and do not act on
a body that turns like a rigid one. What is stable then is a minimum of the energy on the orbit.
"""
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from itertools import chain
from typing import TYPE_CHECKING

from sympy import Add, Expr, Mul, S, Symbol

from ..._cached import cached_property
from ..._lazy import loaded
from ...algebra.reals.exact import Point, sign, sign_changes
from ...algebra.rings.matrices import blocks, characteristic, cross
from ...algebra.rings.polynomials import lowest_terms
from ...mechanics.equilibrium.derivation_ring import signs_over
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.standard_axes import seen, seen_at
from ...notation import Stored
from ..criteria.conditions import Criterion, independent
from ..criteria.energy_casimir import SecondVariation, secular_variation
from ..criteria.numbers_asked import left_open, names_in, names_needed, names_of_motion
from ..criteria.three_criteria import across, in_names, secular_criterion, stiffness
from ..criteria.truth import holds
from ..decision import Decision, Rung, settled, undecided
from ..notion import Notion

if TYPE_CHECKING:
    from ..criteria.defined_names import DefinedNames

KEPT = "damping takes energy, which has a strict minimum on the orbit"
LOST = "damping takes energy, which has no minimum on the orbit: the equilibrium becomes unstable"
OUT_OF_REACH = ("the damping does not reach every motion: in some motions the body turns at a rate that "
                "stays constant in its axes, and none of the others is proved to grow")
NO_SIGN = "a margin has no proved sign"
KEEPS = settled(True, KEPT, Rung.SECOND_VARIATION, Notion.SECULAR, growing=0)


@dataclass(frozen=True)
class Secular(Stored):
    """The second variation with the Casimirs alone, and what it says under internal damping.

    If it is positive definite, the equilibrium is stable, asymptotically on its orbit if the damping reaches
    all motions (is pervasive). If it is not degenerate and not positive, and the damping pervasive, it is
    unstable, with as many growing modes as the second variation has negative squares (Kelvin, Tait, Chetaev).

    Damping by all three components of ω reaches every motion except in two cases. First, the body turns about
    k with M along k, and no torque acts to first order, so that k moves by itself: M is that of a free body,
    and its growing modes are all. Second, a body of revolution is at rest at a tilt: it may begin to spin
    about its axis, and nothing stops it.

    Parameters
    ----------
    equilibrium : Equilibrium
    expanded : bool
        whether the criterion is written out however long it is; default False

    References
    ----------
    Chetaev, The Stability of Motion (1961); Zajac, J. Astronaut. Sci. 11 (1964) 46-49; Bloch, Krishnaprasad,
    Marsden & Ratiu, Ann. Inst. H. Poincaré Anal. Non Linéaire 11 (1994) 37-90; with a proof in
    docs/explanation/derivations/damping.md, sections 2 and 5.
    """

    equilibrium: Equilibrium
    expanded: bool = False
    _carried = "closed", "criterion", "compared", "required", "counted_by", "_coefficients", "exceptions"

    @cached_property
    def closed(self) -> "DefinedNames | None":
        """The names in which the criterion is written, if it is too long to be written out; else None."""
        return None if self.expanded else in_names(self.equilibrium)

    @cached_property
    def variation(self) -> SecondVariation:
        """The second variation with the Casimirs, on the orbit modulo the flows of the integrals."""
        return secular_variation(self.equilibrium)

    @cached_property
    def criterion(self) -> Criterion:
        """The criterion that it is positive definite, reduced to independent conditions.

        For a body of revolution that is recognised it is in the standard axes.
        """
        if self.closed:
            return self.closed.criterion(Notion.SECULAR)
        if known := seen(self.equilibrium):
            return replace(secular_of(known.equilibrium).criterion, modulo=known.modulo)
        return independent(secular_criterion(self.variation), self.equilibrium)

    @cached_property
    def standard(self) -> "Secular":
        """The second variation under damping in the standard axes, if a body of revolution is recognised."""
        known = seen(self.equilibrium)
        return secular_of(known.equilibrium) if known else self

    @cached_property
    def exceptions(self) -> tuple[tuple[Expr, ...], ...]:
        """The expressions, in normal form, whose zeros are where the criterion is not necessary.

        If one of the first group vanishes, the second variation is degenerate, or the body is at rest and
        free to spin; if one of each of the other groups does, the damping does not reach every motion of k. A
        group is () if it vanishes nowhere.
        """
        singular = Mul(*(block[-1] ** times for block, times in self._coefficients.items()))
        values = (singular * self._rest if self.criterion.modulo else singular, *self._torques)
        signs = signs_over(self.equilibrium, values)
        groups = [(margin, *even) for margin, even in map(signs.normal_form, values)]
        degenerate, *torques = (tuple(e for e in group if e == 0 or e.free_symbols) for group in groups)
        return degenerate, *dict.fromkeys(torques)

    @cached_property
    def compared(self) -> tuple[str, ...]:
        """The names in the criterion: without one of them there is no verdict."""
        return self.closed.required if self.closed else names_needed(self.equilibrium, (self.criterion,))

    @cached_property
    def required(self) -> tuple[str, ...]:
        """The names with which every verdict is answered: if the criterion fails, those of the motion."""
        if () in self.criterion.alternatives:
            return self.compared
        return tuple(sorted({*self.compared, *names_of_motion(self.equilibrium)}))

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision under internal damping at exact numbers, with the number of growing modes."""
        known = seen(self.equilibrium) or seen_at(self.equilibrium, numbers)
        if known is None:
            found, modulo = self._decided(numbers, margins), self.criterion.modulo
            return replace(found, modulo=modulo) if modulo else found
        standard = secular_of(known.equilibrium)
        if missing := left_open(standard.compared, numbers):
            return undecided(known.worded(f"give {', '.join(missing)} to decide"))
        found = standard._decided(numbers, margins)
        return replace(found, reason=known.worded(found.reason), modulo=known.modulo)

    def _decided(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        at = self.closed.with_names(numbers) if self.closed else numbers
        least = holds(self.criterion, at, margins)
        if least:
            return KEEPS
        if least is None:
            return undecided(NO_SIGN)
        if missing := left_open(self.counted_by, numbers):
            return undecided(f"give {', '.join(missing)} to decide")
        counted = [([sign(c, at) for c in block], times)
                   for block, times in self._coefficients.items()]
        if any(None in signs for signs, _ in counted):
            return undecided(NO_SIGN)
        regular = all(signs[-1] for signs, _ in counted)
        negative = sum(times * sign_changes(signs) for signs, times in counted) if regular else None
        reached = not self._exceptional(numbers)
        if negative and reached:
            return lost(negative)
        if missing := left_open(self.required, numbers):
            return undecided(f"give {', '.join(missing)} to decide")
        if (found := loaded("stability.damping.growing_modes:growing_at")(self.equilibrium, numbers)).grows:
            return lost(found.modes)
        return undecided(OUT_OF_REACH) if negative else self._degenerate(numbers, reached)

    @cached_property
    def counted_by(self) -> tuple[str, ...]:
        """The names in what counts negative squares, and in what tells whether the damping reaches all."""
        return self.closed.required if self.closed else names_in(chain(*self._coefficients, *self.exceptions))

    @cached_property
    def _coefficients(self) -> Counter[tuple[Expr, ...]]:
        """The coefficients of the characteristic polynomial of each block for −λ, and how often it occurs.

        The blocks are those of the second variation, or of its part across k, or of K.
        """
        if self.closed:
            return Counter(self.closed.blocks)
        eq, K = self.equilibrium, stiffness(self.variation)
        if found := across(self.variation):
            return Counter([tuple(eq.insert(x) for _, _, x in found)])
        matrix = self.variation.matrix if K is None else K
        rows = [[eq.insert(entry) for entry in row] for row in matrix.tolist()]
        return Counter(characteristic([[rows[i][j] for j in block] for i in block]) for block in blocks(rows))

    @cached_property
    def _torques(self) -> tuple[Expr, ...]:
        """What vanishes if k moves by itself: M × k, and the torque to first order in k."""
        eq = self.equilibrium
        potential = eq.system.potential
        if potential is None:
            return (S.One,)
        pi, k = eq.point[:3], eq.point[3:]
        momentum = [p + l for p, l in zip(pi, eq.system.body.gyrostatic_momentum)]
        slopes = [eq.at_point(d) for d in potential.gradient()]
        curved = [[eq.at_point(d) for d in row] for row in eq.system.energy_hessian.tolist()[3:]]
        curved = [row[3:] for row in curved]
        along = Add(*(d * x for d, x in zip(slopes, k))) / Add(*(x**2 for x in k))
        for n in range(3):
            curved[n][n] -= along
        across = [cross(row, k) for row in curved]
        both = [cross(column, k) for column in zip(*across)]
        found = [*cross(momentum, k), *cross(slopes, k), *(e for row in both for e in row)]
        return tuple(e for x in found if (e := lowest_terms(eq.insert(x))) != 0)

    def _exceptional(self, numbers: Mapping[Symbol, Expr]) -> bool:
        """Tell whether the damping may not reach every motion.

        Either k may move by itself, the body turning about it, or the body is at rest and may turn along a
        symmetry, at a rate that is constant to first order.
        """
        _, *torques = self.exceptions
        if all(any(sign(e, numbers) == 0 for e in torque) for torque in torques):
            return True
        return bool(self.criterion.modulo) and sign(self._rest, numbers) == 0

    @property
    def _rest(self) -> Expr:
        """The square of abs(π), which vanishes at rest."""
        return self.equilibrium.insert(Add(*(x**2 for x in self.equilibrium.point[:3])))

    def _degenerate(self, numbers: Mapping[Symbol, Expr], reached: bool) -> Decision:
        """Return the decision if the second variation is degenerate beyond the symmetries.

        It depends on whether the energy is least by terms of higher order.
        """
        least, why = loaded("stability.theorems.minimum_on_orbit:least_at")(self.equilibrium, numbers)
        if least is None or not least and not reached:
            return undecided(why if least is None else OUT_OF_REACH)
        return (settled(True, f"{KEPT}: {why}", Rung.LEADING_FORM, Notion.SECULAR, growing=0) if least
                else settled(False, f"{LOST}: {why}", Rung.LEADING_FORM, Notion.SECULAR))


secular_of = once(Secular)                                 # derived once for each equilibrium


@cache
def lost(growing: int | None) -> Decision:
    """Return the decision that damping destroys what is not least, with the number of growing modes.

    The number is None if they are not counted.
    """
    how_many = "" if growing is None else f", with {growing} growing mode{'' if growing == 1 else 's'}"
    return settled(False, f"{LOST}{how_many}", Rung.NEGATIVE_SQUARES, Notion.SECULAR, growing=growing)
