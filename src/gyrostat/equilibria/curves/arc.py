"""Cuts, decides and names an admissible arc of Staude's cone, or of the curve of a gyrostat."""
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from sympy import Expr, Rational, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.solving.plane_branches import Span, Strand
from ...algebra.solving.roots import between, inside
from ...algebra.text.numbers import exact_number
from ...arguments import checked
from ...errors import ValuesError
from ...mechanics.scenes.system import System
from ...notation import Stored
from ...stability.decision import Decision
from ...stability.normal_forms.windows import between_cuts
from ...stability.spectrum import Signs
from ..finders.heavy import OMEGA
from ..relative_equilibrium import RelativeEquilibrium
from .cone_curves import ConeCurve, End, Near
from .rate_curves import RateCurve


class Piece(NamedTuple):
    """A part of an arc with one verdict, without its ends."""

    low: Expr
    high: Expr
    decision: Decision


@dataclass(frozen=True, repr=False)
class Arc(Shown, Stored):
    """An admissible arc of the curve of the permanent rotations of a body in U = c·k.

    Without a rotor, on Staude's cone, both rates ±omega belong to a direction, and the arc goes on from a
    pole of omega² to the next, or to rest. With one it goes on over omega, from where two rotations of one
    rate become one to the next such place, or to omega → ±∞.

    Parameters
    ----------
    curve : ConeCurve or RateCurve
    strand : Strand
        which branch of the curve, between which values of the parameter

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> arc = gs.staude_cone(scene).arcs({})[0]
    >>> arc.parameter, arc.low, arc.high, arc.k[0]
    (tau, -oo, -3, 1/(omega**2*(tau + 1)))
    >>> last = arc.pieces[-1]
    >>> last.high, last.decision.verdict.name
    (-3, 'STABLE')
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, "1/2", 1)), U)
    >>> arcs = gs.staude_cone(scene).arcs({})
    >>> for arc in arcs[4:6]:
    ...     verdict = arc.pieces[0].decision.verdict.name
    ...     print(arc.low.evalf(6), arc.high, verdict)
    0.946191 oo STABLE
    -oo oo STABLE
    >>> arcs[5].rotation(0).directions[0]
    (-sqrt(3)/3, -sqrt(3)/3, -sqrt(3)/3)
    """

    curve: ConeCurve | RateCurve
    strand: Strand

    @property
    def scene(self) -> System:
        """The scene at given numbers."""
        return self.curve.scene

    @property
    def parameter(self) -> Symbol:
        """The parameter: tau or rho on Staude's cone; with a rotor omega."""
        return self.curve.parameter

    @property
    def both_ways(self) -> bool:
        """Whether −omega is a rate, too, with the same verdict: without a rotor."""
        return self.parameter != OMEGA

    @property
    def low(self) -> Expr:
        """The parameter at its beginning, −oo if it has none."""
        return self.strand.spans[0].low

    @property
    def high(self) -> Expr:
        """The parameter at its end, oo if it has none."""
        return self.strand.spans[-1].high

    @property
    def k(self) -> tuple[Expr, ...]:
        """The unit vector k in the parameter, omega and, with a rotor, sigma or a component of k."""
        return self.curve.k

    @property
    def omega_squared(self) -> Expr:
        """The square of the rate in the parameter [1/T²]."""
        return self.curve.omega_squared

    def rotation(self, at: Any) -> RelativeEquilibrium:
        """Return the permanent rotation at a value, exact; without a rotor that of positive rate.

        Parameters
        ----------
        at : number
            exact, between low and high; with a rotor rational

        Returns
        -------
        RelativeEquilibrium

        Raises
        ------
        ValuesError
            the number is not between low and high, or, with a rotor, not rational
        """
        value = exact_number(at, str(self.parameter))
        return RelativeEquilibrium(self.curve.at(self._span(value), value))

    @checked
    def near(self, at: Fraction) -> Near:
        """Return the permanent rotation at a value of the parameter in doubles.

        Parameters
        ----------
        at : Fraction
            between low and high

        Returns
        -------
        Near
        """
        return self.curve.near(self._span(Rational(at.numerator, at.denominator)), at)

    def _span(self, at: Expr) -> Span:
        """Return the span in which a value lies, or at whose end inside the arc."""
        for span in self.strand.spans:
            if inside([at], span.low, span.high) or at == span.high != self.high:
                return span
        raise ValuesError(f"{self.parameter} = {at}, and the arc goes from {self.low.evalf(6)} to "
                          f"{self.high.evalf(6)}: give a number between")

    @cached_property
    def circles(self) -> tuple[RelativeEquilibrium, ...]:
        """The circles of rotations of one rate that it crosses: if two moments are equal, with a rotor."""
        return tuple(RelativeEquilibrium(form) for span in self.strand.spans[:-1] if span.high in
                     self.curve.through and (form := self.curve.at(span, span.high)).circle is not None)

    @cached_property
    def ends(self) -> tuple[End, End]:
        """The limits for the parameter to low and to high.

        They are a principal axis, omega → ±∞; without a rotor ±c, omega → 0; with one the place where two
        rotations become one.
        """
        first, last = self.strand.spans[0], self.strand.spans[-1]
        return (self.curve.end(first, first.low, self.strand.first, 1),
                self.curve.end(last, last.high, self.strand.last, -1))

    @cached_property
    def folds(self) -> tuple[Expr, ...]:
        """The values at which omega is greatest or least inside the arc: there two rotations become one.

        With a rotor the arc ends at such a place, and there are none inside.
        """
        return tuple(inside(self.curve.folds, self.low, self.high))

    @cached_property
    def boundaries(self) -> tuple[Expr, ...]:
        """The values at which the verdict changes, exact: the amended potential or the spectrum does."""
        return tuple(two.low for one, two in pairwise(self.pieces)
                     if one.decision.reason != two.decision.reason)

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The parts of one verdict each, in the order of the parameter, except for single points inside them.

        A gyroscopically stabilised part is split at resonances and, without a rotor, where D4 is 0; the
        verdict of such a point, and with a rotor of one where D4 is 0, is that of its rotation.
        """
        pieces: list[Piece] = []
        before: tuple[Decision, Signs] | None = None
        for low, high, decision, signs in self._stretches():
            if (decision, signs) == before:
                low = pieces.pop().low
            pieces.append(Piece(low, high, decision))
            before = decision, signs
        return tuple(pieces)

    def _stretches(self) -> Iterator[tuple[Expr, Expr, Decision, Signs]]:
        """Yield what is decided between values at which it may change, with resonance signs in windows."""
        for span in self.strand.spans:
            critical = inside(self.curve.critical, span.low, span.high)
            for low, high in pairwise([span.low, *critical, span.high]):
                decision = RelativeEquilibrium(self.curve.at(span, between(low, high))).decision
                if decision.pointwise:
                    yield from self._window(span, low, high)
                else:
                    yield low, high, decision, ()

    def _window(self, span: Span, low: Expr, high: Expr) -> Iterator[tuple[Expr, Expr, Decision, Signs]]:
        """Yield the parts of a gyroscopically stabilised stretch between cuts.

        It is decided once between two resonances, and, without a rotor, between two zeros of D4.
        """
        signs: Signs = ()
        cuts, twists = self.curve.cuts
        for a, b in pairwise([low, *inside(cuts, low, high), high]):
            form = self.curve.at(span, between(a, b))
            if twists or form.resonance_signs != signs:
                signs = form.resonance_signs
                decision = between_cuts(RelativeEquilibrium(form).decision, twists)
            yield a, b, decision, signs
