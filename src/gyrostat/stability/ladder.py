"""Decides an equilibrium at exact numbers by a ladder of criteria and theorems: the first that applies.

RUNGS names each with its source.
"""
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from sympy import Expr

from .._lazy import loaded
from ..algebra.reals.exact import Point, sign
from ..mechanics.equilibrium.derived_once import once
from ..mechanics.equilibrium.standard_axes import placed, seen_at
from ..mechanics.scenes.kind import Kind
from .criteria.numbers_asked import left_open
from .criteria.truth import holds
from .decision import Decision, undecided
from .report.derived_parts import Derived
from .standing import THEOREMS, Standing

NORMAL_FORMS = "stability.normal_forms"
DEGREE = 4                                                 # D4 needs the derivatives of U up to this one


@dataclass(frozen=True, repr=False)
class Ladder(Derived):
    """The parts of a report, with the ladder that decides: the first of RUNGS that applies.

    A scene that has more symmetry at the numbers is decided as such, and so is one that another scene
    decides. If the other scene divides out the flow of a symmetry of this one, so does the decision; if that
    flow is no symmetry of this one, the other scene is asked about the point itself.
    """

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision at exact numbers that are checked; verdict checks them.

        Parameters
        ----------
        numbers : Point
            exact
        margins : dict of Expr to Expr
            the margins that are used are entered, with their values

        Returns
        -------
        Decision
        """
        return self._by_rungs(Standing(self, numbers, margins))

    def _by_rungs(self, standing: Standing) -> Decision:
        """Return the decision of the first rung that applies."""
        return next(step for step in RUNGS if step.applies(standing)).decides(standing)

    def decide_point(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision about the point itself, not modulo the flow of an integral.

        Parameters
        ----------
        numbers : Point
            exact
        margins : dict of Expr to Expr
            as in decide

        Returns
        -------
        Decision
        """
        found = self.decide(numbers, margins)
        if not found.modulo or not found.stable:
            return replace(found, modulo=())
        margins.clear()                                    # they proved the decision modulo a flow
        known = self.recognised or seen_at(self.equilibrium, numbers)
        if known:
            drift = loaded(f"{THEOREMS}.drift:Drift")(known.equilibrium).decide(numbers, margins)
            return replace(drift, reason=known.worded(drift.reason))
        if self.boundary:
            return self.drift.decide(numbers, margins)
        return loaded(f"{THEOREMS}.drift:drifts_along")(placed(self.equilibrium, numbers), found)


@dataclass(frozen=True)
class Step:
    """A rung of the ladder: when it applies, and how it decides.

    Parameters
    ----------
    name : str
    source : str
        where the criterion or theorem is published, that it is derived, or that nothing is guessed
    applies, decides : callable
        take a Standing, and say whether it is decided here, and how; a theorem's module is loaded then
    """

    name: str
    source: str
    applies: Callable[[Standing], Any]
    decides: Callable[[Standing], Decision]


def _definite(s: Standing) -> Decision:
    """Return the decision that the second variation is definite, with Casimirs or given integrals."""
    derived = s.derived
    if not s.eq.system.given_integrals or holds(derived.casimirs_only, s.at, {}):
        return derived.stable
    return replace(s.by_integrals, pointwise=False) if s.by_integrals.stable else derived.stable


def _by_another(s: Standing) -> Decision:
    """Return what another scene decides, in the axes of this one."""
    known = s.other
    assert known is not None
    standard = kept(known.equilibrium)
    if missing := left_open(standard.compared, s.numbers):
        return undecided(known.worded(f"give {', '.join(missing)} to decide"))
    found = standard.decide(s.numbers, s.margins)
    return replace(found, reason=known.worded(found.reason), modulo=found.modulo and known.modulo)


def _between(s: Standing) -> Decision:
    """Return what the reduced motion, or the energy on the momentum sphere, decides."""
    decider = s.derived.between
    assert decider is not None
    return s.own(decider.decide(s.numbers, s.margins))


def _in_frame(s: Standing) -> Decision:
    """Return the decision for a body in a field of two directions."""
    decide = loaded(f"{THEOREMS}.two_directions:decide_in_frame")
    return s.own(decide(s.eq, s.numbers, s.degenerate, lambda eq: kept(eq).decide_point(Point({}), {})))


def _window(s: Standing) -> Decision:
    """Return what normal forms decide if gyroscopic forces stabilise a maximum of the amended potential."""
    motion = loaded(f"{NORMAL_FORMS}.local_motion:local_motion")(s.eq, s.numbers, DEGREE)
    if isinstance(motion, list):
        return s.after_integrals(undecided("the amended potential has a maximum, and gyroscopic forces "
                                           f"stabilise it; give {', '.join(motion)} to decide"))
    return s.after_integrals(loaded(f"{NORMAL_FORMS}.windows:decide_window")(motion))


def _without_torque(s: Standing) -> Decision:
    """Return what the free body decides, as the field exerts no torque."""
    decide = loaded(f"{THEOREMS}.no_torque:decide_without_torque")
    return s.after_integrals(decide(s.eq, s.numbers, lambda eq: kept(eq).decide(Point({}), {})))


def _leading(s: Standing) -> Decision:
    """Return what the leading form of the amended potential decides.

    If p > 0, there are two imaginary eigenvalues beside the double eigenvalue 0, as Sokolskii's theorem asks.
    """
    closed = s.derived.closed
    p = closed.named.p if closed else s.eq.insert(s.derived.linearization.coefficients[0])
    amended = loaded(f"{THEOREMS}.amended_expansion:Amended")(s.eq, s.numbers)
    return s.after_integrals(amended.decide(sign(p, s.at) == 1))


# the order matters: a theorem may assume that no rung before it applies, as normal forms do of both criteria
RUNGS = (
    Step("second variation", "Lagrange (1788), Dirichlet (1846); Arnold, J. Mécanique 5 (1966) 29-43",
         lambda s: s.sufficient, _definite),
    Step("spectrum", "Lyapunov (1892)", lambda s: s.necessary is False, lambda s: s.derived.unstable),
    Step("another scene", "derived: a body of revolution about any axis, a satellite's axis",
         lambda s: s.other, _by_another),
    Step("no sign", "nothing is guessed", lambda s: None in (s.sufficient, s.necessary),
         lambda s: undecided("a margin has no proved sign")),
    Step("reduced motion, momentum sphere", "derived; Hughes (1986), chapter 6",
         lambda s: s.derived.between, _between),
    Step("missing names", "nothing is guessed", lambda s: s.missing,
         lambda s: s.own(undecided(f"the point lies between the two criteria; give {s.missing} to decide"))),
    Step("two directions", "derived", lambda s: s.eq.system.coupled, _in_frame),
    Step("fourth order", "derived", lambda s: s.eq.system.kind is Kind.FREE,
         lambda s: s.own(loaded(f"{THEOREMS}.momentum_sphere:extremum_at")(s.eq, s.numbers).decision)),
    Step("integrals", "Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116",
         lambda s: s.eq.system.given_integrals and s.by_integrals.stable, lambda s: s.own(s.by_integrals)),
    Step("normal forms", "Arnold, Sov. Math. Dokl. 2 (1961) 247-249", lambda s: not s.degenerate, _window),
    Step("no torque", "derived: M·k, |M|² and |k|² are conserved",
         lambda s: loaded(f"{THEOREMS}.no_torque:without_torque")(s.eq, s.numbers), _without_torque),
    Step("leading form", "Lagrange, Dirichlet; Chetaev (1934)", lambda s: True, _leading),
)


kept = once(Ladder)                                        # derived once for each equilibrium
