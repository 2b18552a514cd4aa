"""The admissible arcs of Staude's cone, where omega² is positive, and the verdicts along them."""
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

from sympy import Add, Expr, S, Symbol, oo, sqrt, zeros

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.solving.roots import between, in_order, real_roots
from ...algebra.text.numbers import exact_number
from ...mechanics.scenes.system import System
from ...notation import Stored, symbol
from ...stability.criteria.amended_form import amended_form
from ...stability.criteria.number_notes import noted
from ...stability.decision import Decision
from ...stability.normal_forms.d4_along_family import cuts_in_windows
from ...stability.normal_forms.local_motion import LocalMotion
from ...stability.normal_forms.windows import HELD, between_resonances
from ..finders.heavy_form import HeavyForm
from ..relative_equilibrium import RelativeEquilibrium

TAU, RHO = symbol("tau"), symbol("rho")


class Piece(NamedTuple):
    """A part of an arc, its ends left out, with one verdict."""

    low: Expr
    high: Expr
    decision: Decision


class End(NamedTuple):
    """What an arc goes to: a direction, and the rate there, which may be infinite."""

    k: tuple[Expr, ...]
    omega: Expr


@dataclass(frozen=True, repr=False)
class StaudeArc(Shown, Stored):
    """An admissible arc of Staude's cone: k = n/abs(n) and omega² = abs(n) along a parameter.

    With g = omega² Ik + sigma k and tau = sigma/omega², n_i = c_i/(tau + I_i): the parameter is tau between
    two of the −I_i. Where c_i = 0, k has any component along axis i at tau = −I_i: the parameter is rho, n_i.

    Parameters
    ----------
    scene : System
        at its numbers
    parameter : Symbol
        tau or rho
    low, high : Expr
        the parameter lies between
    n : tuple of Expr, shape (3,)
        in the parameter
    tau : Expr
        sigma/omega²

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> arc = gs.staude_cone(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)).arcs({})[0]
    >>> arc.low, arc.high, arc.n
    (-oo, -3, (1/(tau + 1), 1/(tau + 2), 1/(tau + 3)))
    >>> [(piece.low, piece.high, piece.decision.verdict.name) for piece in arc.pieces][-1][1:]
    (-3, 'STABLE')
    """

    scene: System
    parameter: Symbol
    low: Expr
    high: Expr
    n: tuple[Expr, ...]
    tau: Expr

    @cached_property
    def omega_squared(self) -> Expr:
        """abs(n), in the parameter [1/T²]."""
        return sqrt(_squared(self.n))

    def rotation(self, at: Any) -> RelativeEquilibrium:
        """The permanent rotation at a value of the parameter, exact, of positive rate.

        That of −omega has the same verdict.

        Parameters
        ----------
        at : number
            exact, between low and high

        Returns
        -------
        RelativeEquilibrium
        """
        at = exact_number(at, str(self.parameter))
        n = [evaluate(x, {self.parameter: at}) for x in self.n]
        length = sqrt(_squared(n))
        k = tuple(evaluate(x / length, {}) for x in n)
        return RelativeEquilibrium(HeavyForm(self.scene, k, sqrt(length)))

    @cached_property
    def ends(self) -> tuple[End, End]:
        """Where the parameter goes to low and to high: a principal axis, omega → ∞, or ±c, omega → 0."""
        return self._end(self.low, 1), self._end(self.high, -1)

    def _end(self, at: Expr, side: int) -> End:
        if self.parameter == RHO:
            return End(tuple(-side * x.diff(RHO) for x in self.n), oo)
        c = [x * (TAU + m) for x, m in zip(self.n, self.scene.body.moments)]
        if far := at in (oo, -oo):
            along = [-side * x for x in c]
        else:
            along = [side * x if m == -at else S.Zero for x, m in zip(c, self.scene.body.moments)]
        return End(tuple(x / sqrt(_squared(along)) for x in along), S.Zero if far else oo)

    @cached_property
    def folds(self) -> tuple[Expr, ...]:
        """Where two rotations of one omega become one, exact: omega is greatest or least on the arc."""
        return tuple(real_roots(_squared(self.n).diff(self.parameter), self.parameter, *self._within) or ())

    @cached_property
    def boundaries(self) -> tuple[Expr, ...]:
        """Where the verdict changes, exact: the amended potential or the spectrum does."""
        return tuple(two.low for one, two in pairwise(self.pieces)
                     if one.decision.reason != two.decision.reason)

    @property
    def _within(self) -> tuple[Expr | None, ...]:
        """low and high, None where it goes to ±∞."""
        return tuple(None if end in (oo, -oo) else end for end in (self.low, self.high))

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The parts of one verdict each, in the order of the parameter; but for single points inside them.

        What gyroscopic forces hold is parted at resonances and where D4 is 0; of these points a verdict says.

        The margins k·adj(K)k, p and p² − 4q are powers of omega times rational functions of the parameter:
        their zeros are all that there are.
        """
        body, x = self.scene.body, self.parameter
        moments, scale = body.tensor.tolist(), _squared(self.n)
        gradient = [evaluate((m + self.tau / scale) * y, {}) for m, y in zip(body.moments, self.n)]
        form = amended_form(moments, (S.Zero,) * 3, gradient, zeros(3).tolist(), self.n, S.One)
        margins = form.determinant, form.p, form.p**2 - 4 * form.q
        found = {root for margin in margins for root in real_roots(margin, x, *self._within) or ()}
        pieces: list[Piece] = []
        for low, high in pairwise([self.low, *in_order(list(found)), self.high]):
            decision = self.rotation(between(low, high)).decision
            if decision.pointwise:
                pieces += self._held(low, high)
                continue
            if pieces and pieces[-1].decision == decision:
                low = pieces.pop().low
            pieces.append(Piece(low, high, decision))
        return tuple(pieces)

    def _held(self, low: Expr, high: Expr) -> Iterator[Piece]:
        """The parts of a stretch that gyroscopic forces hold, between resonances and where D4 is 0."""
        cuts = _cuts(self.scene, self.n, self.parameter)
        if cuts is None:
            yield Piece(low, high, noted(HELD, self.scene))
            return
        inside = [x for x in cuts if (low == -oo or proved_sign(x - low) == 1)
                  and (high == oo or proved_sign(high - x) == 1)]
        for a, b in pairwise([low, *inside, high]):
            yield Piece(a, b, noted(between_resonances(self.rotation(between(a, b)).decision), self.scene))


def staude_arcs(scene: System, c: Sequence[Expr]) -> Iterator[StaudeArc]:
    """Every admissible arc of a body without a rotor in U = c·k, at numbers."""
    moments = scene.body.moments
    held = [proved_sign(x) == 0 for x in c]
    n = tuple(S.Zero if zero else x / (TAU + m) for x, m, zero in zip(c, moments, held))
    poles = in_order(list({-m for m, zero in zip(moments, held) if not zero}))
    for low, high in pairwise([-oo, *poles, oo]):
        yield StaudeArc(scene, TAU, low, high, n, TAU)
    for i in range(3):
        if held[i] and -moments[i] not in poles:
            beside = [RHO if m == i else S.Zero if held[m] else c[m] / (moments[m] - moments[i])
                      for m in range(3)]
            yield StaudeArc(scene, RHO, -oo, oo, tuple(beside), -moments[i])


def _squared(v: Sequence[Expr]) -> Expr:
    return Add(*(x**2 for x in v))


@lru_cache(maxsize=4)
def _cuts(scene: System, n: tuple[Expr, ...], x: Symbol) -> list[Expr] | None:
    """Where D4 or the margin of a resonance vanishes, in order, if the numbers are rational.

    With k and M times n/k, which is abs(n), and its square root, h is rational in the parameter.
    """
    U = scene.potential
    assert U is not None
    M = tuple(m * y for m, y in zip(scene.body.moments, n))
    motion = LocalMotion(tuple(map(tuple, scene.body.inverse.tolist())), (S.Zero,) * 3, n, M, U.expression,
                         lambda: (S.Zero, S.Zero), _squared(n))
    return cuts_in_windows(motion, x, None, None)
