"""Says what decides an attitude in which a satellite rests in the frame of its orbit, and in which words."""
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from sympy import Expr, ImmutableMatrix

from ..._cached import cached_property
from ..._lazy import loaded
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import adjugate, cross
from ...algebra.solving.real_fields import FieldNumbers, balls
from ...mechanics.families.circular_orbit import by_gradient_alone, orbital_rate, resting_at
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.amended_form import Rows, dot, trace
from ...stability.decision import Decision, Rung, Verdict, settled, undecided
from ...stability.form import PRECISION, Form, Invariants
from ...stability.notion import Notion
from ...stability.report.report import Report
from ...stability.theorems.two_directions import DEGENERATE, HELD

OPEN = undecided(HELD)
MODULO = "equilibria.finders.circles_of_attitudes:decided_modulo_turn"


@dataclass(frozen=True)
class OrbitalForm(Form):
    """A satellite at rest in the frame of its orbit, ω = ω0 n: the stiffness K of its orientation.

    Parameters
    ----------
    scene : System
        at given numbers
    n, r : sequence of Expr, shape (3,)
        the normal of the orbit and the vertical, outwards, in body axes, exact
    locus : str
        "" for a point, else the curve of equilibria to which it belongs, in words; for a body of revolution
        the circle, and the verdict is modulo the turn about its axis
    as_set : Decision or None
        what is proved of that set: the energy is least on it, and K positive across it
    """

    LEAST = settled(True, "the energy has a minimum: K is positive definite", Rung.SECOND_VARIATION)
    ODD = settled(False, "K has an odd number of negative squares: an eigenvalue has a positive real part",
                  Rung.SPECTRUM, Notion.SPECTRAL)
    LEAVES = settled(False, "K has two negative squares, and gyroscopic forces do not stabilise it: an "
                     "eigenvalue has a positive real part", Rung.SPECTRUM, Notion.SPECTRAL)
    label = "equilibrium in orbit"
    scene: System
    n: Sequence[Expr]
    r: Sequence[Expr]
    locus: str = ""
    as_set: Decision | None = None

    @cached_property
    def directions(self) -> tuple[tuple[Expr, ...], ...]:
        """The directions n and r."""
        return tuple(self.n), tuple(self.r)

    @property
    def heading(self) -> str:
        """The curve of equilibria in words, or the label."""
        return self.locus or self.label

    @property
    def at(self) -> Expr:
        """The symbol of the vertical along axis 3."""
        return symbol("r3")

    @property
    def described(self) -> tuple[tuple[str | Expr, Any], ...]:
        """The directions n and r, which tell it from others."""
        return ("n", self.n), ("r", self.r)

    @cached_property
    def point(self) -> tuple[Expr, ...]:
        """The point π = ω0 In, n and r."""
        return tuple(evaluate(x, {}) for x in resting_at(self.scene, *self.directions))

    @property
    def rates(self) -> dict[str, Expr]:
        """The rate of the orbit."""
        return {"omega0": orbital_rate(self.scene)}

    def invariants(self, precision: int | None) -> Invariants:
        """Return the invariants of K, and the coefficients of the sextic."""
        if not by_gradient_alone(self.scene):
            return of_motion(*self.motion(precision))
        body, rate = self.scene.body, orbital_rate(self.scene)
        given = *body.tensor.tolist(), body.gyrostatic_momentum, self.n, self.r
        if precision is None:
            *tensor, rotor, n, r = given[:4] + self.directions
            return invariants(tensor, rotor, n, r, rate)
        *tensor, rotor, n, r = (balls(x, precision) for x in given)
        return invariants(tensor, rotor, n, r, ball(rate, precision))

    def motion(self, precision: int | None) -> tuple[Rows, Rows, Sequence[Any], Sequence[Any]]:
        """Return I, K, g and ω0 n of I θ̈ + g × θ̇ + K θ = 0, in body axes, in any potential."""
        body, rate = self.scene.body, orbital_rate(self.scene)
        given = *body.tensor.tolist(), body.gyrostatic_momentum, self.n, self.r, [rate]
        *tensor, rotor, n, r, (w,) = given if precision is None else (balls(x, precision) for x in given)
        along = [w * x for x in n]
        g = [trace(tensor) * x - 2 * dot(row, along) - l for x, row, l in zip(along, tensor, rotor)]
        stiffness = loaded("equilibria.finders.amended_orbit:stiffness")(self.scene, n, r, precision)
        return tensor, stiffness, g, along

    def known(self) -> Decision | None:
        """Return the decision of its report if there is an integral, and that on a curve of equilibria.

        Along such a curve K is degenerate.
        """
        if self.scene.linear_integrals:
            quick = isinstance(self.n, FieldNumbers)       # a report at roots of polynomials is slow
            if (found := loaded(MODULO)(self) if quick else None) is None:
                found = Report(self.equilibrium).verdict({})
            return found if self.as_set is None or found.verdict is not Verdict.UNDECIDED else self.as_set
        if not self.locus:
            return None
        if self.as_set is not None:
            return self.as_set
        return self.LEAVES if -1 in self.spectral_signs else undecided(self.locus)

    def known_damped(self) -> Decision | None:
        """Return the decision under damping if there is an integral, or on a set; None if K decides.

        In principal axes and the gravity gradient a report decides what K does not, else it is UNDECIDED: to
        count growing modes exactly takes minutes there.
        """
        principal = by_gradient_alone(self.scene) and not isinstance(self.scene.body.inertia, ImmutableMatrix)
        if self.scene.linear_integrals:
            if principal:
                return Report(self.equilibrium).verdict({}, damped=True)
            if (found := loaded(MODULO)(self, damped=True)) is not None:
                return found
        if self.as_set is not None:
            return replace(self.as_set, notion=Notion.SECULAR, growing=0)
        return undecided(DEGENERATE) if self.index is None and not principal else None

    def held(self) -> Decision:
        """Return UNDECIDED: no theorem decides if gyroscopic forces alone stabilise it."""
        return OPEN

    def degenerate(self) -> Decision | None:
        """Return UNDECIDED if another field acts: no set of equilibria is known there."""
        return None if by_gradient_alone(self.scene) else undecided(DEGENERATE)

    @property
    def reached(self) -> bool:
        """Whether damping reaches every motion: t·In and n·In − r·Ir do not both vanish."""
        for precision in doubled(PRECISION):
            with own_precision(precision):
                if any(not x.contains(0) for x in self._unreached(precision)):
                    return True
        return any(proved_sign(evaluate(x, {})) for x in self._unreached(None))

    def _unreached(self, precision: int | None) -> Sequence[Any]:
        """Return what vanishes if damping does not reach every motion."""
        if not by_gradient_alone(self.scene):
            return left_by_turning(*self.motion(precision))
        given = *self.scene.body.tensor.tolist(), self.n, self.r
        if precision is None:
            *rows, n, r = given[:3] + self.directions
        else:
            *rows, n, r = (balls(x, precision) for x in given)
        return unreached(rows, n, r)


def invariants(tensor: Sequence[Sequence[Any]], rotor: Sequence[Any], n: Sequence[Any], r: Sequence[Any],
               rate: Any) -> Invariants:
    """Return trace, second invariant and determinant of K; and the sextic, a cubic in λ², times det I.

    The small motions obey I θ̈ + g × θ̇ + K θ = 0. In the basis (t, n, r):

    K = [[4ω0² (I_nn − I_rr) + ω0 l_n, −3ω0² I_tn, 0],
         [., 3ω0² (I_tt − I_rr), 3ω0² I_nr],
         [0, ., ω0² (I_nn − I_tt) + ω0 l_n]],
    g = (−ω0 I_tn, ω0 (I_tt + I_rr − I_nn) − l_n, 2ω0 I_nr).

    The sextic is det(λ² I + λ hat(g) + K). Since det(A + hat(v)) = det A + v·A v for a symmetric A, its
    coefficients of λ⁶, λ⁴, λ² and 1 are det I, tr(adj(I) K) + g·Ig, tr(adj(K) I) + g·Kg and det K. Derived in
    docs/explanation/derivations/satellite.md, sections 4 and 5.

    Parameters
    ----------
    tensor : rows, shape (3, 3)
        numbers, balls or expressions, as rotor, n, r and rate
    rotor, n, r : sequence, shape (3,)
    rate : Any
        ω0

    Returns
    -------
    Invariants
    """
    frame = cross(n, r), n, r
    I = [[dot(a, [dot(row, b) for row in tensor]) for b in frame] for a in frame]
    along, square = dot(rotor, n) * rate, rate**2
    (tt, tn, _), (_, nn, nr), (_, _, rr) = I
    K = [[4 * square * (nn - rr) + along, -3 * square * tn, 0 * square],
         [-3 * square * tn, 3 * square * (tt - rr), 3 * square * nr],
         [0 * square, 3 * square * nr, square * (nn - tt) + along]]
    g = [-rate * tn, rate * (tt + rr - nn) - dot(rotor, n), 2 * rate * nr]
    return of_motion(I, K, g)


def of_motion(I: Rows, K: Rows, g: Sequence[Any], _: Sequence[Any] = ()) -> Invariants:
    """Return the invariants of K, and the coefficients of det(λ² I + λ hat(g) + K)."""
    minors, whole = adjugate(K), dot(K[0], cross(K[1], K[2]))
    d = dot(I[0], cross(I[1], I[2]))
    a = sum((dot(x, y) for x, y in zip(adjugate(I), K)), 0 * whole) + dot(g, [dot(row, g) for row in I])
    b = sum((dot(x, y) for x, y in zip(minors, I)), 0 * whole) + dot(g, [dot(row, g) for row in K])
    return Invariants((trace(K), trace(minors), whole), (d, a, b, whole))


def unreached(tensor: Sequence[Sequence[Any]], n: Sequence[Any], r: Sequence[Any]) -> tuple[Any, Any]:
    """Return t·In and n·In − r·Ir."""
    along, vertical = ([dot(row, a) for row in tensor] for a in (n, r))
    return dot(cross(n, r), along), dot(n, along) - dot(r, vertical)


def left_by_turning(I: Rows, K: Rows, g: Sequence[Any], turning: Sequence[Any]) -> list[Any]:
    """Return (I hat(v)² − hat(g) hat(v) + K) hat(v): the torques on a body turned as v = ω0 n turns.

    Then ω stays, and internal damping does not reach that motion if they vanish.
    """
    hat = [[0 * x for x in turning] for _ in turning]
    (hat[2][1], hat[0][2], hat[1][0]), (hat[1][2], hat[2][0], hat[0][1]) = turning, [-x for x in turning]
    columns = [list(column) for column in zip(*hat)]
    found = []
    for v in columns:                                      # v = hat e
        turned = cross(turning, v)
        inertial = [dot(row, cross(turning, turned)) for row in I]
        found += [a - b + dot(row, v) for a, b, row in zip(inertial, cross(g, turned), K)]
    return found
