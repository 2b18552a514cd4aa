"""Internal damping: whether an equilibrium stays stable when the body loses energy inside.

Fuel that sloshes, a nutation damper, joints that give: they take energy, keep the Casimirs, and leave a body
that turns like a rigid one alone. What is stable then is a minimum of the energy on the orbit.
"""
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from sympy import Add, Expr, Matrix, S, Symbol, eye

from ..algebra.exact import Point, evaluate, sign_of_constant
from ..algebra.margins import Signs
from ..algebra.matrices import characteristic, cross
from ..algebra.polynomials import lowest_terms
from ..kept import cached_property
from ..mechanics.derivation import signs_over
from ..mechanics.equilibria import Equilibrium
from ..mechanics.liepoisson import hat
from ..mechanics.once import once
from ..mechanics.standard import seen, seen_at
from ..notation import symbol
from .conditions import Condition, Criterion, independent
from .criteria import across, of_stiffness, positive, secular_criterion
from .energy_casimir import SecondVariation, secular_variation
from .minima import least_at
from .truth import holds, sign_at
from .values import names_needed

Growing = tuple[bool | None, str, int | None]              # stable, why, and the number of growing modes
KEPT = "damping takes energy, which has a strict minimum on the orbit"
LOST = "damping takes energy, which is not least on the orbit: it is lost"
OUT_OF_REACH = "the damping does not reach every motion: a linear motion of k goes on without a torque"
NO_SPIN = "the damping does not reach every motion: from rest the body may turn about its axis without end"
NO_SIGN = "a margin has no proved sign"


@dataclass(frozen=True)
class Secular:
    """The second variation with the Casimirs alone, and what it says under internal damping.

    Positive definite: stable, asymptotically on its orbit if the damping reaches all motions (is pervasive).
    Not degenerate, not positive, and the damping pervasive: unstable, with as many growing modes as the
    second variation has negative squares (Kelvin, Tait, Chetaev). Damping by all three components of ω
    reaches every motion but in two cases. The body turns about k with M along k, and no torque acts to first
    order, so that k moves by itself: M is that of a free body, and its growing modes are all. Or a body of
    revolution is at rest at a tilt: it may begin to spin about its axis, and nothing stops it.

    Parameters
    ----------
    equilibrium : Equilibrium

    References
    ----------
    Chetaev, The Stability of Motion (1961); Zajac, J. Astronaut. Sci. 11 (1964) 46-49; Bloch, Krishnaprasad,
    Marsden & Ratiu, Ann. Inst. H. Poincaré Anal. Non Linéaire 11 (1994) 37-90.
    """

    equilibrium: Equilibrium

    @cached_property
    def variation(self) -> SecondVariation:
        """With the Casimirs, on the orbit modulo the flows of the integrals."""
        return secular_variation(self.equilibrium)

    @cached_property
    def criterion(self) -> Criterion:
        """It is positive definite; reduced to independent conditions.

        Of a body that is recognised, in the standard axes.
        """
        if known := seen(self.equilibrium):
            return replace(secular_of(known.equilibrium).criterion, modulo=known.modulo)
        return independent(secular_criterion(self.variation), self.equilibrium)

    @cached_property
    def standard(self) -> "Secular":
        """Of the equilibrium in the standard axes, where a body of revolution is recognised."""
        known = seen(self.equilibrium)
        return secular_of(known.equilibrium) if known else self

    @cached_property
    def exceptions(self) -> tuple[tuple[Expr, ...], ...]:
        """Where the criterion is not necessary: where one of the first vanishes the second variation is
        degenerate, or the body is at rest and free to spin; where one of each of the others does, the damping
        does not reach every motion of k. In normal form, () for what vanishes nowhere.
        """
        singular = self._coefficients[-1] if self._coefficients else S.One
        values = (singular * self._rest if self.variation.modulo else singular, *self._torques)
        signs = signs_over(self.equilibrium, values)
        found = [signs.split(*signs.ring.fraction(value)) for value in values]
        groups = [[signs.ring.expression(x) for x in (margin, *even)] for margin, even in found]
        degenerate, *torques = (tuple(e for e in group if e == 0 or e.free_symbols) for group in groups)
        return degenerate, *dict.fromkeys(torques)

    @cached_property
    def required(self) -> tuple[str, ...]:
        """Names that the criterion needs."""
        return names_needed(self.equilibrium, (self.criterion,))

    def decide(self, numbers: Point, margins: dict[Expr, Expr]
               ) -> tuple[bool | None, str, int | None, tuple[Expr, ...]]:
        """Whether it is stable under internal damping at exact numbers, why, how many modes grow, and the
        integrals whose flows are divided out.

        None is for what is not proved.
        """
        known = seen(self.equilibrium) or seen_at(self.equilibrium, numbers)
        if known is None:
            return *self._counted(numbers, margins), self.criterion.modulo
        standard = secular_of(known.equilibrium)
        if missing := ", ".join(name for name in standard.required if symbol(name) not in numbers):
            return None, known.worded(f"give {missing} to decide"), None, known.modulo
        stable, why, growing = standard._counted(numbers, margins)
        return stable, known.worded(why), growing, known.modulo

    def _counted(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Growing:
        """As far as the numbers go: modes may need names that the criterion does not."""
        try:
            return self._decided(numbers, margins)
        except KeyError as lacking:
            if not isinstance(lacking.args[0], Symbol):
                raise
            return None, f"give {lacking.args[0]} to decide", None

    def _decided(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Growing:
        least = holds(self.criterion, numbers, margins)
        if least:
            return True, KEPT, 0
        if least is None:
            return None, NO_SIGN, None
        known = dict(margins)
        blocks = [(times, [sign_at(minor, numbers, known) for minor in block])
                  for block, times in self._minors.items()]
        if all(all(signs) for _, signs in blocks):
            negative = sum(times * _changes(signs) for times, signs in blocks)
        else:
            coefficients = [sign_of_constant(evaluate(c, numbers)) for c in self._coefficients]
            if None in coefficients:
                return None, NO_SIGN, None
            if coefficients and coefficients[-1] == 0:
                return self._degenerate(numbers)
            negative = _changes(coefficients)
        if self._spins(numbers):
            return None, NO_SPIN, None
        if self._free(numbers):
            return self._along(numbers)
        return False, f"{LOST}, {modes(negative)}", negative

    @cached_property
    def _minors(self) -> Counter[tuple[Condition, ...]]:
        """The leading minors of each block, from the first that may be negative on, and how often it occurs;
        where none vanishes, their changes of sign are the negative squares (Jacobi). Across k trace and
        determinant, whose changes are too.
        """
        eq = self.equilibrium
        found = [(n, minor) for _, n, minor in across(self.variation) or of_stiffness(self.variation)
                 ] or self.variation.block_minors
        minors = [(n, eq.insert(minor)) for n, minor in found]
        signs = Signs.over([minor for _, minor in minors], (*eq.existence(), *map(eq.insert, positive(eq))))
        blocks: list[list[Condition]] = []
        for n, minor in minors:
            margin, even = signs.normal_form(minor)
            blocks += [[]] if n == 1 else []
            if blocks[-1] or margin != 1 or even:
                blocks[-1].append(Condition(margin, True, f"minor {n}", even, eq.at))
        return Counter(map(tuple, blocks))

    @cached_property
    def _coefficients(self) -> tuple[Expr, ...]:
        """Of the characteristic polynomial of the second variation, or of its part across k, for −λ."""
        eq, matrix = self.equilibrium, self.variation.matrix
        if found := across(self.variation):
            return tuple(eq.insert(x) for _, _, x in found)
        return characteristic([[eq.insert(entry) for entry in row] for row in matrix.tolist()])

    @cached_property
    def _torques(self) -> tuple[Expr, ...]:
        """What vanishes where k moves by itself: M × k, and the torque to first order in k."""
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

    def _free(self, numbers: Mapping[Symbol, Expr]) -> bool:
        """Whether k moves by itself there, the body turning about it."""
        _, *torques = self.exceptions
        return all(any(sign_of_constant(evaluate(e, numbers)) == 0 for e in torque) for torque in torques)

    def _spins(self, numbers: Mapping[Symbol, Expr]) -> bool:
        """Whether it is at rest and may turn along a symmetry: its rate is constant then to first order."""
        return bool(self.variation.modulo) and sign_of_constant(evaluate(self._rest, numbers)) == 0

    @property
    def _rest(self) -> Expr:
        """|π|², which vanishes at rest."""
        return self.equilibrium.insert(Add(*(x**2 for x in self.equilibrium.point[:3])))

    def _along(self, numbers: Mapping[Symbol, Expr]) -> Growing:
        """Where k moves by itself: of M, as of a free body, M = μ k, ω = w k, on the plane across k."""
        eq = self.equilibrium
        body = eq.system.body.changed(lambda x: evaluate(eq.insert(x), numbers))
        pi, k = (Matrix([evaluate(eq.insert(x), numbers) for x in part])
                 for part in (eq.point[:3], eq.point[3:]))
        mu, rate = k.dot(pi + Matrix(body.gyrostatic_momentum)), k.dot(body.inverse * pi)
        turn = hat(k)
        form = turn.T * (mu**2 * body.inverse - mu * rate * eye(3)) * turn
        growing = _changes([sign_of_constant(evaluate(c, {})) for c in characteristic(form.tolist())])
        if growing:
            return False, f"{LOST}, {modes(growing)}; {OUT_OF_REACH}", growing
        return None, OUT_OF_REACH, None

    def _degenerate(self, numbers: Mapping[Symbol, Expr]) -> Growing:
        """Where the second variation is degenerate beyond the symmetries: whether the energy is least."""
        least, why = least_at(self.equilibrium, numbers)
        if least is None or (not least and (self._free(numbers) or self._spins(numbers))):
            return None, why if least is None else OUT_OF_REACH, None
        return least, f"{KEPT}: {why}" if least else f"{LOST}: {why}", 0 if least else None


@once
def secular_of(eq: Equilibrium) -> Secular:
    """What internal damping makes of an equilibrium, derived once."""
    return Secular(eq)


def _changes(signs: Sequence[int | None]) -> int:
    """Changes of sign, from 1 on: of coefficients, the negative eigenvalues of a symmetric matrix, for
    Descartes' rule is exact where all roots are real.
    """
    left = [1, *filter(None, signs)]
    return sum(a != b for a, b in zip(left, left[1:]))


def modes(count: int) -> str:
    """How many modes grow, in words."""
    return f"{count} growing mode{'' if count == 1 else 's'}"
