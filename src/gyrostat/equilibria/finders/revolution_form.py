"""Says what decides a relative equilibrium of a body of revolution in U(k3), in the axes of its scene."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from sympy import Expr, ImmutableMatrix, S, sqrt

from ..._cached import cached_property
from ...algebra.reals.exact import evaluate, proved_sign
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.recognition import Recognition
from ...mechanics.scenes.system import System, assemble
from ...notation import symbol
from ...stability.decision import Decision
from ...stability.form import Form, Invariants
from ...stability.report.report import Report
from .heavy_form import HeavyForm

# the label of a regular precession that is none of E3
PRECESSION = "precession"


@dataclass(frozen=True)
class RevolutionForm(Form):
    """A motion ω = omega k + sigma c, c the axis: E1, E2, E3 (sigma = 0), or a regular precession.

    A precession is a periodic orbit of the Lie-Poisson field, and E3 of the body whose rotor carries l + I3
    sigma. The decision is that of the report of its family at these numbers.

    Parameters
    ----------
    label : str
        "E1", "E2", "E3" or PRECESSION
    found : Recognition
        the scene at given numbers, and the axis
    k3 : Expr
        k·c; for a continuum 0
    omega, sigma : Expr
        rate about the vertical, and about the axis on top of it [1/T]
    pi3 : Expr
        axial momentum of the locked body [M L²/T]
    report : Report
        of the family, in the standard scene
    asked : mapping of name to number
        at which it is asked
    every : str
        what takes every value in a continuum: "k3", or "omega" if the rates vary too; "" if it is none
    """

    label: str
    found: Recognition
    k3: Expr
    omega: Expr
    sigma: Expr
    pi3: Expr
    report: Report
    asked: Mapping[str, Any] = field(hash=False)
    every: str = ""

    @property
    def scene(self) -> System:  # type: ignore[override]
        """The scene at given numbers."""
        return self.found.scene

    @property
    def heading(self) -> str:
        """The label: E1, E2, E3 or a precession."""
        return self.label

    @property
    def at(self) -> Expr:
        """The number k3 at E1 and E2, else its symbol."""
        return self.k3 if self.found.scene is self.found.standard and self.k3**2 == 1 else symbol("k3")

    @property
    def described(self) -> tuple[tuple[str | Expr, Any], ...]:
        """The values of k·c, omega and sigma; None for what takes every value."""
        rates = (None, None) if self.every == "omega" else (self.omega, self.sigma)
        return ((self.found.along(self.scene.space.coordinates[3:]), None if self.every else self.k3),
                *zip((symbol("omega"), symbol("sigma")), rates))

    @property
    def placed(self) -> Sequence[tuple[Sequence[str], Sequence[Expr | None]]]:
        """The values of k3, omega, sigma and pi3; for a scene in other axes its point."""
        _, (_, omega), (_, sigma) = self.described
        if self.found.scene is self.found.standard:
            k3, pi3 = (None, None) if self.every else (self.k3, self.pi3)
            return [(("k3", "omega", "sigma", "pi3"), (k3, omega, sigma, pi3))]
        names = [str(x) for x in self.scene.space.coordinates]
        return [*([] if self.every else [(names, self.point)]), (("omega", "sigma"), (omega, sigma))]

    @cached_property
    def point(self) -> tuple[Expr, ...]:
        """The point π, k with k across axis 2 of the standard scene."""
        k1 = S.Zero if self.k3**2 == 1 else sqrt(1 - self.k3**2)
        pi = self.found.standard.body.moments[0] * self.omega * k1, S.Zero, self.pi3
        return tuple(x for v in (pi, (k1, S.Zero, self.k3))
                     for x in self.found.rotation.T * ImmutableMatrix(v))

    @property
    def rates(self) -> dict[str, Expr]:
        """The rates about the vertical, and about the axis on top of it."""
        return {"omega": self.omega, "sigma": self.sigma}

    @property
    def locus(self) -> str:
        """The words for every tilt, if it is one of a continuum."""
        return f"every {self.found.name} from −1 to 1" if self.every else ""

    @property
    def singular(self) -> bool:
        """Whether the second variation is known to be degenerate: a tilt may be turned about the axis."""
        return self.k3**2 != 1

    @property
    def turns(self) -> bool:
        """Whether it is a regular precession, in which ω turns in the body."""
        return self.label == PRECESSION

    @cached_property
    def _spin(self) -> tuple[Expr, ...]:
        """The momentum I3 sigma along the axis."""
        moment = self.found.standard.body.moments[2]
        return tuple(evaluate(moment * self.sigma * x, {}) for x in self.found.axis)

    @cached_property
    def held_scene(self) -> System:
        """The scene of which it is an equilibrium: its rotor carries I3 sigma besides."""
        if proved_sign(self.sigma) == 0:
            return self.scene
        body = self.scene.body
        rotor = tuple(l + x for l, x in zip(body.gyrostatic_momentum, self._spin))
        return assemble(replace(body, gyrostatic_momentum=rotor), self.scene.potential)

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The same as a claimed point."""
        pi = (p - x for p, x in zip(self.point, self._spin))
        return equilibrium(self.held_scene, (*pi, *self.point[3:]), label=self.label)

    @cached_property
    def _heavy(self) -> HeavyForm:
        """The same as a permanent rotation of a body in a field."""
        return HeavyForm(self.held_scene, self.point[3:], self.omega)

    @property
    def rational(self) -> bool:
        """Whether the spectrum is solved exactly: k and omega are rational."""
        return self._heavy.rational

    @property
    def reached(self) -> bool:
        """Whether damping reaches every motion, as for a permanent rotation of a body in a field."""
        return self._heavy.reached

    def invariants(self, precision: int | None) -> Invariants:
        """Return the invariants, as for a permanent rotation of a body in a field."""
        return self._heavy.invariants(precision)

    def known(self) -> Decision:
        """Return the decision by the report of the family."""
        return self._in_axes(self.report.verdict(self.asked))

    def known_damped(self) -> Decision | None:
        """Return the decision under damping by the report of the family."""
        return self._in_axes(self.report.verdict(self.asked, damped=True))

    def known_point(self) -> Decision | None:
        """Return the decision on the point itself by the report of the family."""
        return self._in_axes(self.report.itself(self.asked))

    def _in_axes(self, decision: Decision) -> Decision:
        """Return a decision in the axes of the scene.

        Its margins, in the names of the standard scene, are left out.
        """
        found = self.found
        if found.scene is found.standard:
            return decision
        return replace(decision, modulo=decision.modulo and (found.modulo,), margins=(),
                       reason=f"{found.sentence}: {found.worded(decision.reason)}")
