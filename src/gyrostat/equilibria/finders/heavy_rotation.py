"""One permanent rotation of any body in a field, and what is decided of it."""
from dataclasses import dataclass, replace

from flint import arb
from sympy import Expr, Float, Matrix, Rational, S, sqrt

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.system import System
from ...notation import Stored
from ...stability.criteria.amended_form import AmendedForm, amended_form
from ...stability.criteria.number_notes import noted
from ...stability.damping.secular import KEEPS, lost
from ...stability.decision import Decision, Rung, settled, undecided
from ...stability.normal_forms.local_motion import LocalMotion
from ...stability.normal_forms.windows import decide_window
from ...stability.report.report import Report
from ...stability.theorems.momentum_sphere import circle_in_words
from .heavy_data import Data, data_at, unreached

PRECISION = 128                                            # bits that decide
DIGITS = 80                                                # of frequencies, half of which may cancel
LEAST = settled(True, "the amended potential has a minimum", Rung.SECOND_VARIATION)
SADDLE = settled(False, "the amended potential has a saddle: an eigenvalue has a positive real part",
                 Rung.SPECTRUM, "spectral")
LEAVES = settled(False, "the amended potential has a maximum, and the gyroscopic forces do not hold it: an "
                 "eigenvalue has a positive real part", Rung.SPECTRUM, "spectral")
ACROSS = settled(False, "the rotation lies on a curve of rotations, and an eigenvalue has a positive "
                 "real part", Rung.SPECTRUM, "spectral")
ALONG = undecided("the rotation lies on a curve of rotations, along which the amended potential does not "
                  "change")


@dataclass(frozen=True, repr=False)
class HeavyRotation(Shown, Stored):
    """A permanent rotation of a body in a field: ω = omega k, k fixed in the body and in space.

    Parameters
    ----------
    scene : System
        at its numbers
    k : tuple of Expr, shape (3,)
        exact
    omega : Expr
        [1/T]
    circle : tuple of Expr, shape (3,), or None
        along the axis about which k may be turned, (0, 0, 0) for any: a continuum of equilibria
    curve : Expr or None
        of a continuum that is no circle a polynomial in k1, k2, k3 that vanishes on it, where abs(k) = 1

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> found = gs.relative_equilibria(scene, {"omega": 2})
    >>> [(f"{float(r.k[0]):.4f}", r.decision.verdict.name) for r in found][:2]
    [('-0.1444', 'STABLE'), ('-0.1965', 'UNSTABLE')]
    >>> [f"{float(x):.4f}" for x in (*found[0].frequencies, found[1].growth_rate)]
    ['1.6331', '1.9588', '0.7830']
    """

    scene: System
    k: tuple[Expr, ...]
    omega: Expr
    circle: tuple[Expr, ...] | None = None
    curve: Expr | None = None

    @cached_property
    def point(self) -> tuple[Expr, ...]:
        """π = omega Ik and k, in the coordinates of the scene."""
        along = self.scene.body.tensor * Matrix(self.k)
        return (*(evaluate(self.omega * x, {}) for x in along), *self.k)

    @property
    def locus(self) -> str:
        """What it belongs to: "" for a point, else a curve or the sphere of equilibria, in words."""
        if self.curve is not None:
            return f"a curve, {self.curve} = 0"
        if self.circle is None:
            return ""
        return circle_in_words(self.circle) if any(self.circle) else "the whole sphere"

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The same as a claimed point, for a report."""
        return equilibrium(self.scene, self.point, label="permanent rotation")

    @cached_property
    def form(self) -> AmendedForm:
        """Trace and determinant of the second variation across k, p and q of λ⁴ + p λ² + q; exact."""
        return amended_form(*self._data, self.k, self.omega)

    @cached_property
    def _data(self) -> Data:
        return data_at(self.scene, self.k)

    @cached_property
    def decision(self) -> Decision:
        """The verdict; of a body that is of revolution modulo the turn about its axis."""
        return noted(self._decided(), self.scene)

    def _decided(self) -> Decision:
        trace, determinant, p, discriminant = self.signs
        if self.curve is not None:
            return ACROSS if p == -1 else ALONG
        if determinant == -1:
            return SADDLE
        if determinant == 1 and trace == 1:
            return LEAST
        if determinant == 1 and trace == -1 and (p == -1 or discriminant == -1):
            return LEAVES
        if determinant == 1 and trace == -1 and p == discriminant == 1 and not self.scene.given_integrals:
            return decide_window(self._motion)
        decision = Report(self.equilibrium).verdict({})
        return replace(decision, pointwise=decision.pointwise or bool(decision.certificate))

    @cached_property
    def itself(self) -> Decision | None:
        """What holds of the point where the decision is modulo the flow of an integral; else None."""
        return noted(Report(self.equilibrium).itself({}), self.scene) if self.decision.modulo else None

    @property
    def _motion(self) -> LocalMotion:
        inertia, U = self.scene.body.inverse.tolist(), self.scene.potential
        assert U is not None
        rotor = self._data.rotor
        momentum = tuple(evaluate(x + l, {}) for x, l in zip(self.point, rotor))
        return LocalMotion(tuple(map(tuple, inertia)), tuple(rotor), self.k, momentum, U.expression,
                           lambda: (evaluate(self.form.p, {}), evaluate(self.form.q, {})))

    @cached_property
    def damped(self) -> Decision:
        """The verdict under internal damping."""
        return noted(self._decided_under_damping(), self.scene)

    def _decided_under_damping(self) -> Decision:
        trace, determinant, *_ = self.signs
        if self.curve is not None:
            return ALONG
        if not (determinant and trace) or not self._reached:
            return Report(self.equilibrium).verdict({}, damped=True)
        growing = 1 if determinant == -1 else 0 if trace == 1 else 2
        return lost(growing) if growing else KEEPS

    @property
    def frequencies(self) -> tuple[Expr, ...]:
        """Of the small motions on the coadjoint orbit, in increasing order [1/T].

        Exact at rational k and omega, else to 30 digits.
        """
        _, determinant, p, discriminant = self.signs
        if discriminant == -1:
            return ()
        half, root = self._halves
        slow = (sqrt(half - root),) * (determinant == p == 1)
        return slow + (sqrt(half + root),) * (determinant == -1 or p == 1)

    @property
    def growth_rate(self) -> Expr | None:
        """The largest real part of an eigenvalue [1/T]; None where there is none that is positive."""
        _, determinant, p, discriminant = self.signs
        half, root = self._halves
        if discriminant == -1:
            return sqrt((sqrt(half**2 + root**2) - half) / 2)
        return sqrt(root - half) if -1 in (determinant, p) else None

    @property
    def _halves(self) -> tuple[Expr, Expr]:
        """p/2 and √abs(p²/4 − q): of −λ² half the sum, and half the distance."""
        form = self.form if all(isinstance(x, Rational) for x in (*self.k, self.omega)) else self._rounded
        return form.p / 2, sqrt(abs(form.p**2 / 4 - form.q)) if self.signs[3] else S.Zero

    @property
    def _rounded(self) -> AmendedForm:
        """The form in decimals."""
        for precision in doubled(4 * PRECISION):
            found = self._enclosed(precision)
            if all(x.rel_accuracy_bits() > 4 * DIGITS for x in found):
                break
        return AmendedForm(*(Float(x.mid().str(DIGITS, radius=False), DIGITS) for x in found))

    def _enclosed(self, precision: int) -> AmendedForm:
        """The form in balls."""
        with own_precision(precision):
            k, data, omega = self._balls(precision)
            return amended_form(*data, k, omega)

    def _balls(self, precision: int) -> tuple[list[arb], Data, arb]:
        """k, what is of the scene there, and omega, in balls."""
        inertia, rotor, gradient, curved = self._data
        rows = [[[ball(e, precision) for e in row] for row in matrix] for matrix in (inertia, curved)]
        k, *vectors = ([ball(e, precision) for e in vector] for vector in (self.k, rotor, gradient))
        return k, Data(rows[0], vectors[0], vectors[1], rows[1]), ball(self.omega, precision)

    @cached_property
    def signs(self) -> tuple[int | None, ...]:
        """Of trace, determinant, p and p² − 4q."""
        for precision in doubled(PRECISION):
            with own_precision(precision):
                trace, determinant, p, q = self._enclosed(precision)
                found = [_sign(x) for x in (trace, determinant, p, p**2 - 4 * q)]
            if self.curve is not None:                     # along it the second variation is 0, and q with it
                return found[0], 0, found[2], found[2] and 1
            if None not in found:
                return tuple(found)
        exact = self.form.trace, self.form.determinant, self.form.p, self.form.p**2 - 4 * self.form.q
        return tuple(proved_sign(evaluate(x, {})) if sign is None else sign for sign, x in zip(found, exact))

    @property
    def _reached(self) -> bool:
        """Whether internal damping reaches every motion: M × k and the second variation of U across k are
        not both 0. With M × k = 0 the torque is 0 too, ∇U × k = omega M × k.
        """
        with own_precision(PRECISION):
            k, (inertia, rotor, gradient, curved), omega = self._balls(PRECISION)
            if not all(x.contains(0) for x in unreached(inertia, rotor, gradient, curved, k, omega)):
                return True
        return any(proved_sign(evaluate(x, {})) for x in unreached(*self._data, self.k, self.omega))


def _sign(x: arb) -> int | None:
    return 1 if x > 0 else -1 if x < 0 else None
