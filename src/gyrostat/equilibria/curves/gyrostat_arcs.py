"""The arcs of the curve of the permanent rotations of a gyrostat in a field, and the verdicts along them."""
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from sympy import Expr, Rational, Symbol, oo

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import plain, proved_sign
from ...algebra.solving.plane_branches import Span, Strand, strands
from ...algebra.solving.roots import between
from ...algebra.text.numbers import exact_number
from ...arguments import checked
from ...errors import ValuesError
from ...mechanics.scenes.system import System
from ...notation import Stored
from ...stability.normal_forms.windows import along_stretch
from ..finders.heavy import OMEGA
from ..finders.heavy_form import HeavyForm
from ..relative_equilibrium import RelativeEquilibrium
from .rate_curves import RateCurve, rate_curves
from .staude_arcs import End, Piece


@dataclass(frozen=True, repr=False)
class GyrostatArc(Shown, Stored):
    """An arc of the curve of the permanent rotations of a gyrostat: one direction k at each rate omega.

    It goes on from where two rotations of one rate become one to the next such place, or to omega → ±∞.

    Parameters
    ----------
    curve : RateCurve
    strand : Strand
        which root of its equation, between which values of omega

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> arcs = gs.staude_cone(gs.assemble(gs.Gyrostat((1, 2, 3), (0, "1/2", 1)), U)).arcs({})
    >>> [(str(arc.low.evalf(6)), arc.high, arc.pieces[0].decision.verdict.name) for arc in arcs][4:6]
    [('0.946191', oo, 'STABLE'), ('-oo', oo, 'STABLE')]
    >>> arcs[5].rotation(0).directions[0]
    (-sqrt(3)/3, -sqrt(3)/3, -sqrt(3)/3)
    """

    curve: RateCurve
    strand: Strand

    @property
    def parameter(self) -> Symbol:
        """omega."""
        return OMEGA

    @property
    def scene(self) -> System:
        """At its numbers."""
        return self.curve.scene

    @property
    def low(self) -> Expr:
        """The rate at its beginning, −oo where it has none [1/T]."""
        return self.strand.spans[0].low

    @property
    def high(self) -> Expr:
        """The rate at its end, oo where it has none [1/T]."""
        return self.strand.spans[-1].high

    def rotation(self, at: Any) -> RelativeEquilibrium:
        """The permanent rotation of a rate, exact.

        Parameters
        ----------
        at : number
            omega, rational, between low and high

        Returns
        -------
        RelativeEquilibrium

        Raises
        ------
        ValuesError
            the rate is not rational, or not that of a rotation of the arc
        """
        if not isinstance(at := exact_number(at, "omega"), Rational):
            raise ValuesError(f"omega = {at}: give a rational rate, at which the rotation is found exactly")
        span = self._span(at)
        return RelativeEquilibrium(self._among_others(span, at) if at == span.high
                                   else self.curve.at(span.place, at))

    @checked
    def near(self, omega: Fraction) -> tuple[tuple[float, ...], float]:
        """k, and sigma of ∇U = omega² Ik + omega l + sigma k, in doubles.

        Parameters
        ----------
        omega : Fraction
            between low and high

        Returns
        -------
        tuple
        """
        at = Rational(omega.numerator, omega.denominator)
        span = self._span(at)
        if at != span.high:
            return self.curve.near(span.place, omega)
        rotation = self._among_others(span, at)
        return tuple(map(float, rotation.k)), float(self.curve.sigma(rotation))

    def _span(self, at: Rational) -> Span:
        """In which a rate lies, or at whose end, inside the arc."""
        for span in self.strand.spans:
            if _lies(at, span) or at == span.high != self.high:
                return span
        raise ValuesError(f"omega = {at}, and the arc goes from {self.low.evalf(6)} to {self.high.evalf(6)}: "
                          "give a rate between")

    def _among_others(self, span: Span, at: Expr) -> HeavyForm:
        """Where roots meet: two rotations of one sigma have k_i of two signs, each that of its branch."""
        found = self.curve.all_at(at)
        level = found[span.place][0]
        signs = [proved_sign(x) for x in self.curve.at(span.place, between(span.low, span.high)).k]
        return next(rotation for sigma, rotation in found if proved_sign(sigma - level) == 0
                    and all(proved_sign(x) in (0, sign) for x, sign in zip(rotation.k, signs)))

    @cached_property
    def circles(self) -> tuple[RelativeEquilibrium, ...]:
        """Where it crosses a circle of rotations of one rate: of a body with equal moments."""
        met = [self._among_others(span, span.high) for span in self.strand.spans[:-1]
               if span.high in self.curve.through]
        return tuple(RelativeEquilibrium(form) for form in met if form.circle is not None)

    @cached_property
    def ends(self) -> tuple[End, End]:
        """Where omega goes to low and to high: two rotations become one, or a principal axis, omega → ±∞."""
        first, last = self.strand.spans[0], self.strand.spans[-1]
        return (self._end(first.low, self.strand.first, first.place),
                self._end(last.high, self.strand.last, last.place))

    def _end(self, at: Expr, root: Expr | None, place: int) -> End:
        k = self.curve.far(place, at) if root is None else self.curve.directed(at, root)
        return End(tuple(map(plain, k)), at)

    @cached_property
    def boundaries(self) -> tuple[Expr, ...]:
        """The rates at which the verdict changes, exact: the amended potential or the spectrum does."""
        return tuple(piece.low for piece in self.pieces[1:])

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The parts of one verdict each, in the order of omega; but for single rates inside them."""
        pieces: list[Piece] = []
        for span in self.strand.spans:
            inside = [x for x in self.curve.critical if _lies(x, span)]
            for low, high in pairwise([span.low, *inside, span.high]):
                decision = along_stretch(
                    RelativeEquilibrium(self.curve.at(span.place, between(low, high))).decision)
                if pieces and pieces[-1].decision == decision:
                    low = pieces.pop().low
                pieces.append(Piece(low, high, decision))
        return tuple(pieces)


def gyrostat_arcs(scene: System, c: Sequence[Expr]) -> Iterator[GyrostatArc]:
    """Every admissible arc of a body with a rotor in U = c·k, at numbers."""
    for curve, known in rate_curves(scene, c):
        for strand in strands(curve.equation, curve.unknown, OMEGA, known):
            yield GyrostatArc(curve, strand)


def _lies(x: Expr, span: Span) -> bool:
    """Whether a number lies inside a span."""
    return (span.low == -oo or proved_sign(x - span.low) == 1) and (
        span.high == oo or proved_sign(span.high - x) == 1)
