"""One permanent rotation of a free body or gyrostat, and what is decided of it."""
from dataclasses import dataclass, replace

from sympy import Add, Expr, ImmutableMatrix, Matrix, Rational, S, eye, sqrt

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import Point, proved_sign
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.system import assemble
from ...notation import Stored, symbol
from ...stability.damping.secular import KEEPS, lost, secular_of
from ...stability.decision import Decision, Rung, settled
from ...stability.theorems.momentum_sphere import DRIFTS, circle_in_words

EXTREMUM = settled(True, "the energy is an extremum on the momentum sphere", Rung.SECOND_VARIATION)
SADDLE = settled(False, "the energy is a saddle on the momentum sphere: an eigenvalue has a positive real "
                 "part", Rung.SPECTRUM, "spectral")
ANYWHERE = settled(True, "M stays where it is: all moments are equal, and there is no rotor",
                   Rung.SECOND_VARIATION)
AT_REST = settled(True, "M = 0 is the whole orbit", Rung.WHOLE_ORBIT)


@dataclass(frozen=True, repr=False)
class PermanentRotation(Shown, Stored):
    """A rotation about an axis fixed in the body and in space: M = I ω + l with ω = ν M.

    Parameters
    ----------
    body : Gyrostat
    momentum : tuple of Expr, shape (3,)
        M, exact [M L²/T]
    nu : Expr or None
        ν [1/(M L²)]; None where M = 0
    decision : Decision
        of a circle, modulo the turns about its axis
    circle : tuple of Expr, shape (3,), or None
        along the axis about which the point may be turned: a circle of equilibria
    sphere : bool
        whether every point of the momentum sphere is an equilibrium

    Examples
    --------
    >>> import gyrostat as gs
    >>> box = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> rotation = gs.relative_equilibria(box, {"M": 1})[2]
    >>> rotation.momentum, rotation.energy, rotation.decision.verdict.name, rotation.growth_rate
    ((0, -1, 0), 1/4, 'UNSTABLE', sqrt(3)/6)
    """

    body: Gyrostat
    momentum: tuple[Expr, ...]
    nu: Expr | None
    decision: Decision
    circle: tuple[Expr, ...] | None = None
    sphere: bool = False

    @cached_property
    def energy(self) -> Expr:
        """½ Σ (M − l)²/I [M L²/T²]."""
        body = self.body
        pi = [m - l for m, l in zip(self.momentum, body.gyrostatic_momentum)]
        if isinstance(body.inertia, ImmutableMatrix):
            return body.kinetic_energy(pi)
        rates = [p / moment for p, moment in zip(pi, body.moments)]
        return Add(*(Rational(1, 2) * moment * rate**2 for moment, rate in zip(body.moments, rates)))

    @cached_property
    def curvature(self) -> Expr:
        """Δ = M·adj(I⁻¹ − ν) M [1/T²]: the eigenvalues are ±√−Δ.

        In principal axes M₁² d₂ d₃ + M₂² d₃ d₁ + M₃² d₁ d₂ with dᵢ = 1/Iᵢ − ν.
        """
        if self.nu is None or self._kind not in (EXTREMUM, SADDLE):
            return S.Zero
        if isinstance(self.body.inertia, ImmutableMatrix):
            M = Matrix(self.momentum)
            return M.dot((self.body.inverse - self.nu * eye(3)).adjugate() * M)
        d = [1 / moment - self.nu for moment in self.body.moments]
        return Add(*(m**2 * d[n - 1] * d[n - 2] for n, m in enumerate(self.momentum)))

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The same as a claimed point, for a report; refused where M = 0, a singular orbit."""
        pi = [m - l for m, l in zip(self.momentum, self.body.gyrostatic_momentum)]
        return equilibrium(assemble(self.body), pi, label="permanent rotation")

    @property
    def itself(self) -> Decision | None:
        """What holds of the point where the decision is modulo turns about an axis; else None."""
        return settled(False, DRIFTS, Rung.DRIFT, note=self.decision.note) if self.circle else None

    @cached_property
    def damped(self) -> Decision:
        """The verdict under internal damping, which keeps M; of a circle, modulo the turns about its axis."""
        return replace(self._decided_under_damping(), note=self.decision.note)

    @property
    def _kind(self) -> Decision:
        """The decision, without what is said of the body."""
        return replace(self.decision, note="")

    def _decided_under_damping(self) -> Decision:
        if self.nu is None:
            return replace(self.decision, notion="secular", growing=0)
        if self._kind not in (EXTREMUM, SADDLE) and not self.circle:
            return secular_of(self.equilibrium).decide(Point({}), {})
        M, D = Matrix(self.momentum), self.body.inverse - self.nu * eye(3)
        rising = proved_sign(D.trace() * M.dot(M) - M.dot(D * M)) == 1
        growing = 1 if self._kind == SADDLE else 0 if rising else 1 if self.circle else 2
        return replace(lost(growing) if growing else KEEPS, modulo=self.decision.modulo)

    @property
    def locus(self) -> str:
        """What it belongs to: "" for a point, else a circle or the sphere of equilibria, in words."""
        if self.sphere:
            return "the whole sphere"
        return "" if self.circle is None else circle_in_words(self.circle)

    @property
    def frequency(self) -> Expr | None:
        """√Δ, of the small motions of M about it in the body [1/T]; None where there are none."""
        return sqrt(self.curvature) if proved_sign(self.curvature) == 1 else None

    @property
    def growth_rate(self) -> Expr | None:
        """√−Δ, of the mode that leaves [1/T]; None where there is none."""
        return sqrt(-self.curvature) if proved_sign(self.curvature) == -1 else None


def on_circle(axis: tuple[Expr, ...]) -> Decision:
    """The decision on a circle of rotations about an axis, modulo the turns about it."""
    along = Add(*(x * symbol(f"pi{n}") for n, x in enumerate(axis, 1)))
    return settled(True, "the momentum along the axis of the circle is conserved, and on its level nothing "
                   "else moves", Rung.SECOND_VARIATION, modulo=(along,))
