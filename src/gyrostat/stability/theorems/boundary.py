"""Decides a body of revolution between the two criteria, by the reduced motion of its tilt.

The first coefficient of I1² k̇3² = g(k3) that does not vanish decides.
"""
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any

from sympy import Expr, Mul, Rational, S, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import sign
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.margins import Signs
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.reduced_series import powers_of_distance
from ...notation import Stored, jet, symbol
from ..criteria.conditions import Condition
from ..criteria.truth import sign_at
from ..decision import Decision, settled, undecided
from ..decision import Rung as Decided

# power of x up to which the ladder of a transcendental U goes: it has no last rung
HIGHEST = 24


@dataclass(frozen=True)
class Rung:
    """The coefficient of one power of x in g, where all lower ones vanish.

    Parameters
    ----------
    power : int or Rational
        a fraction at a pole at which U has such powers
    condition : Condition
        that the coefficient is negative, margin > 0
    escapes : bool
        whether the power is odd and k3 may move both ways: then g > 0 on one side, and the equilibrium is
        unstable whatever the sign
    """

    power: int | Rational
    condition: Condition
    escapes: bool

    def stable(self, sign: Any) -> Any:
        """Tell whether the equilibrium is stable, by the sign of the condition, one or an array, not 0."""
        return (sign > 0) & (not self.escapes)


@dataclass(frozen=True, repr=False)
class Boundary(Shown, Stored):
    """The reduced motion that decides if the necessary condition holds with equality: a body in U(k3).

    On the level of the equilibrium I1² k̇3² = g = c₃ x³ + c₄ x⁴ + …, where k3 = ±(1 − x), x ≥ 0, at E1 and E2
    and k3 + x at a tilt. The first coefficient that is not 0 decides. If g < 0 beside the point, k3 stays
    near it: Lyapunov stable, modulo the spin at a tilt. If g > 0 on a side, a motion leaves along it. If all
    vanish, g = 0 and every k3 nearby is a motion: unstable. At a pole at which U(k3) has roots the powers are
    fractions (mechanics.near_pole, which says what is asked of U there).

    Parameters
    ----------
    equilibrium : Equilibrium

    References
    ----------
    Derived in docs/explanation/derivations/boundaries.md, sections 2 to 4. The first rung at E1: Lerman,
    arXiv:dg-ga/9608010; the sleeping top: Cushman & Bates, Global Aspects of Classical Integrable Systems,
    chapter V.
    """

    equilibrium: Equilibrium

    @property
    def pole(self) -> bool:
        """Whether k3 = ±1, at which the tilt grows on one side only."""
        return bool(self.equilibrium.at**2 == 1)

    @cached_property
    def last(self) -> int | None:
        """The power above which no coefficient is new, for a rational U.

        None if U is unspecified or transcendental.
        """
        potential = self.equilibrium.system.potential
        if not potential or not potential.given:
            return None
        k3 = symbol("k3")
        ring = Ring([potential.expression, k3])
        if any(k3 in g.free_symbols for g in ring.generators if g != k3):
            return None
        # g has two degrees more than U, from 1 − k3²: above them no coefficient is new
        place = ring.generators.index(k3)
        return 2 + max(int(part.degrees()[place]) for part in ring.fraction(potential.expression))

    def rungs(self) -> Iterator[Rung]:
        """Yield the ladder from below, each rung derived when it is reached.

        Examples
        --------
        >>> import gyrostat as gs
        >>> from itertools import islice
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> boundary = gs.analyze(gs.upright(top)).boundary
        >>> [rung.condition.margin for rung in islice(boundary.rungs(), 3)]
        [d2U + dU, -3*d2U - 2*d3U, 2*d3U + d4U]
        """
        near, potential = self.equilibrium.near_pole, self.equilibrium.system.potential
        step = 1 if near is None or near.smooth else Rational(1, near.order)
        highest = self.last or (HIGHEST if potential and potential.given else None)
        power = 2 + step
        while highest is None or power <= highest:
            yield self.rung(power)
            power += step

    def decisive(self) -> Iterator[Rung]:
        """Yield the ladder from x² on, which decides whatever the criteria are.

        The coefficient of x² is 0 on the boundary if the criteria are those of g. They can be weaker than g:
        for example if π is fixed, whatever the axis, or if the scene holds numbers whose relations the
        criteria do not see.
        """
        yield self.rung(2)
        yield from self.rungs()

    def rung(self, power: int | Rational) -> Rung:
        """Return the rung of one power of x, from 2 on."""
        if power not in self._known:
            eq, order = self.equilibrium, 5
            while order < power:
                order *= 2
            for exponent, coefficient in powers_of_distance(eq, order).items():
                n = int(exponent) if exponent.is_Integer else exponent
                value = eq.insert(coefficient)
                margin, even = Signs.over([value], eq.existence()).normal_form(-value)
                self._known[n] = Rung(n, Condition(margin, True, f"coefficient of x^{n}", even, eq.at),
                                      not self.pole and n % 2 == 1)
        return self._known[power]

    @cached_property
    def _known(self) -> dict[int | Rational, Rung]:
        """The rungs that have been derived, by their power."""
        return {}

    def ladder(self, limit: int | None = None) -> Iterator[Expr]:
        """Yield what decides, rung by rung: it is stable if the first that is not 0 is positive."""
        for rung in islice(self.rungs(), limit if self.last is None else None):
            value = Mul(rung.condition.margin, *(e**2 for e in rung.condition.degenerate))
            yield -(value**2) if rung.escapes else value

    def expressions(self) -> Iterator[Expr]:
        """Yield the margins and even factors of the ladder, as far as it goes or to its third rung."""
        for rung in islice(self.decisive(), 3 if self.last is None else None):
            yield from (rung.condition.margin, *rung.condition.degenerate)

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Decision:
        """Return the decision at numbers on the boundary.

        Parameters
        ----------
        numbers : mapping of Symbol to Expr
            exact
        margins : dict
            the margins that are used are entered

        Returns
        -------
        Decision
        """
        for rung in self.decisive():
            condition = rung.condition
            if wanted := condition.symbols - numbers.keys():
                missing = ", ".join(sorted(s.name for s in wanted))
                if all(jet(s.name) for s in wanted):
                    return undecided(f"on the boundary, give {missing} to decide")
                return undecided(f"on the boundary, {missing} would decide")
            here = sign_at(condition, numbers, margins)
            if here is None:
                return undecided(f"on the boundary, the coefficient of x^{rung.power} in g has no proved "
                                 "sign")
            if here:
                return self._decided(rung, here)
        if self.last is None:
            return undecided(f"on the boundary, all coefficients of g up to x^{HIGHEST} vanish")
        return settled(False, "on the boundary g vanishes identically: motions leave the point",
                       Decided.REDUCED_MOTION)

    def _decided(self, rung: Rung, sign: int) -> Decision:
        stable = bool(rung.stable(sign))
        kind = (": supercritical" if stable else ": subcritical") if self.pole else ""
        where = "on the boundary " if rung.power > 2 else ""
        compared = "<" if sign > 0 else ">"
        moves = "x stays small" if stable else "a motion leaves along x"
        power = rung.power if isinstance(rung.power, int) else f"({rung.power})"
        return settled(stable, f"{where}g = c x^{power} + … with c {compared} 0, {moves}{kind}",
                       Decided.REDUCED_MOTION)


@once
def boundary_of(eq: Equilibrium) -> Boundary | None:
    """Return the ladder of an equilibrium of a body of revolution with a definite tilt; else None."""
    tilt = S.One - eq.at**2
    if not tilt.free_symbols:
        return None if sign(tilt, {}) is None else Boundary(eq)
    signs = Signs.over([tilt], eq.domain)
    return None if signs.of(signs.ring.numerator(tilt)) is None else Boundary(eq)
