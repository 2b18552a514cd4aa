"""The record of a motion in which nothing changes but the turn about the vertical, and its decisions."""
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from sympy import Expr

from .._cached import cached_property
from .._display import Shown
from .._lazy import loaded
from ..algebra.reals.exact import evaluate
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.scenes.system import System
from ..notation import Stored
from ..stability.criteria.number_notes import noted
from ..stability.damping.secular import KEEPS, lost
from ..stability.decision import Decision
from ..stability.form import Form
from ..stability.report.report import Report

if TYPE_CHECKING:
    from .attitude_in_orbit import Attitude
    from .doubles import Doubles


@dataclass(frozen=True, repr=False)
class RelativeEquilibrium(Shown, Stored):
    """A motion in which the body turns at a constant rate, in any kind of scene, and what is decided of it.

    Parameters
    ----------
    form : Form
        where it lies, the second variation across its orbit and the spectrum: signs, index, frequencies

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> for e in gs.relative_equilibria(scene, {"omega": 2})[:2]:
    ...     print(e.label, e.decision.verdict.name, e.form.index)
    permanent rotation STABLE 0
    permanent rotation UNSTABLE 1
    >>> body = gs.Gyrostat((1, "5/4", "8/5"), (0, 0, 0))
    >>> satellite = gs.assemble(body, gs.circular_orbit(1))
    >>> found = gs.relative_equilibria(satellite, {})
    >>> len(found), sum(e.decision.stable for e in found)
    (24, 4)
    >>> found[0].doubles.place["r3"], found[0].doubles.rates
    (1.0, {'omega0': 1.0})
    """

    form: Form

    @property
    def label(self) -> str:
        """The label: E1, E2, E3, precession, permanent rotation or equilibrium in orbit."""
        return self.form.label

    @property
    def scene(self) -> System:
        """The scene at given numbers."""
        return self.form.scene

    @property
    def place(self) -> dict[str, Expr | None]:
        """What tells it from others of its scene, by name; None for what takes every value.

        For a body of revolution these are k3, omega, sigma and pi3, in its axis; for a free body π; for
        another body in a field k and omega; for a satellite n and r.
        """
        return self.form.place

    @property
    def point(self) -> tuple[Expr, ...]:
        """The point in the coordinates of the scene; for a set of them, one of its points."""
        return self.form.point

    @property
    def momentum(self) -> tuple[Expr, ...]:
        """The momentum M = π + l, shape (3,) [M L²/T]."""
        return tuple(evaluate(p + l, {}) for p, l in zip(self.point, self.scene.body.gyrostatic_momentum))

    @property
    def directions(self) -> tuple[tuple[Expr, ...], ...]:
        """The unit vectors in the body: k; for a satellite n and r; none for a free body."""
        return self.form.directions

    @cached_property
    def attitude(self) -> "Attitude | None":
        """The attitude of a satellite against t, n, r: roll, pitch, yaw, quaternion, rotation; else None."""
        vectors = [vector for name, vector in self.form.described if name in ("n", "r")]
        return loaded("equilibria.attitude_in_orbit:attitude_of")(*vectors) if vectors else None

    @property
    def doubles(self) -> "Doubles":
        """Place, rates, frequencies and growth rate as the doubles next to the exact numbers.

        They come from enclosures. To turn `place` of a satellite with a rotor into doubles one by one takes a
        hundred times as long, as each is written out first.
        """
        return loaded("equilibria.doubles:Doubles")(self.form)

    @cached_property
    def well(self) -> Any:
        """The well of the energy round it: its barrier and safe kicks, or why there is none."""
        return loaded("equilibria.wells.find_well:well_of")(self)

    @property
    def rates(self) -> dict[str, Expr]:
        """The rates [1/T]: omega about k, or about M; sigma about the axis on top of it; omega0."""
        return self.form.rates

    @property
    def locus(self) -> str:
        """The set of equilibria to which it belongs, in words; "" for a point."""
        return self.form.locus

    @property
    def equilibrium(self) -> Equilibrium:
        """The same as a claimed point, for a report.

        A regular precession is that of the scene whose rotor carries I3 sigma besides. A free body with M = 0
        is refused: its orbit is singular.
        """
        return self.form.equilibrium

    @cached_property
    def energy(self) -> Expr:
        """The Hamiltonian of the scene [M L²/T²]."""
        return evaluate(self.scene.hamiltonian, dict(zip(self.scene.space.coordinates, self.point)))

    @cached_property
    def decision(self) -> Decision:
        """The verdict; for a set, and for a body of revolution, modulo the turn about its axis."""
        return noted(self._decided(), self.scene)

    def _decided(self) -> Decision:
        form = self.form
        if (known := form.known()) is not None:
            return known
        if form.index == 0 or form.greatest and form.index == len(form.signs):
            return form.LEAST
        if form.signs[-1] == -1:
            return form.ODD
        if form.index and -1 in form.spectral_signs:
            return form.LEAVES
        held = form.index and set(form.spectral_signs) == {1}
        if (found := form.held() if held else form.degenerate()) is not None:
            return found
        found = Report(self.equilibrium).verdict({})
        return replace(found, pointwise=found.pointwise or bool(found.certificate))

    @cached_property
    def damped(self) -> Decision | None:
        """The verdict under internal damping; None for a precession, in which ω turns in the body."""
        return None if self.form.turns else noted(self._decided_under_damping(), self.scene)

    def _decided_under_damping(self) -> Decision:
        form = self.form
        if (known := form.known_damped()) is not None:
            return known
        if form.index is None or not form.reached:
            return Report(self.equilibrium).verdict({}, damped=True)
        return lost(form.index) if form.index else KEEPS

    @cached_property
    def itself(self) -> Decision | None:
        """What holds for the point if the decision is modulo the flow of an integral; else None."""
        if self.form.turns or not self.decision.modulo:
            return None
        known = self.form.known_point()
        return noted(Report(self.equilibrium).itself({}) if known is None else known, self.scene)

    @property
    def frequencies(self) -> tuple[Expr, ...]:
        """The frequencies of the small motions, in increasing order [1/T]."""
        return self.form.frequencies

    @property
    def growth_rate(self) -> Expr | None:
        """The largest real part of an eigenvalue [1/T]; None if none is positive."""
        return self.form.growth_rate
