"""Says what decides a permanent rotation of any body in a field, and in which words."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from flint import arb
from sympy import Expr, Matrix, Rational, S, zeros

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.solving.real_fields import FieldNumbers, RealNumbers, are_fractions, balls
from ...mechanics.equilibrium.near_pole import near_pole, refuse_rough
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.amended_form import amended_form, dot
from ...stability.decision import Decision, Rung, settled, undecided
from ...stability.form import PRECISION, Form, Invariants
from ...stability.normal_forms.local_motion import LocalMotion
from ...stability.normal_forms.windows import decide_window, resonance_margins
from ...stability.notion import Notion
from ...stability.spectrum import Signs
from .heavy_polynomials import DIRECTION

LABEL = "permanent rotation"
ACROSS = settled(False, "the rotation lies on a curve of rotations, and an eigenvalue has a positive "
                 "real part", Rung.SPECTRUM, Notion.SPECTRAL)
ALONG = undecided("the rotation lies on a curve of rotations, and its second variation is degenerate")


class Data(NamedTuple):
    """The numbers of body and field in a direction: inertia, rotor, ∇U and D²U; exact, or in balls."""

    inertia: list[list[Any]]
    rotor: list[Any]
    gradient: list[Any]
    hessian: list[list[Any]]


@dataclass(frozen=True)
class HeavyForm(Form):
    """A permanent rotation ω = omega k, k fixed in body and space: the amended potential across k.

    What decides is in docs/explanation/derivations/amended-potential.md, section 5.

    Parameters
    ----------
    scene : System
        at given numbers
    k : sequence of Expr, shape (3,)
        exact
    omega : Expr
        [1/T]
    circle : tuple of Expr, shape (3,), or None
        along the axis about which k may be turned, (0, 0, 0) for any axis: a continuum of equilibria
    curve : Expr or None
        for a continuum that is no circle a polynomial in k1, k2, k3 that vanishes on it, with abs(k) = 1
    label : str
    """

    LEAST = settled(True, "the amended potential has a minimum", Rung.SECOND_VARIATION)
    ODD = settled(False, "the amended potential has a saddle: an eigenvalue has a positive real part",
                  Rung.SPECTRUM, Notion.SPECTRAL)
    LEAVES = settled(False, "the amended potential has a maximum, and gyroscopic forces do not stabilise "
                     "it: an eigenvalue has a positive real part", Rung.SPECTRUM, Notion.SPECTRAL)
    scene: System
    k: Sequence[Expr]
    omega: Expr
    circle: tuple[Expr, ...] | None = None
    curve: Expr | None = None
    label: str = LABEL

    @property
    def described(self) -> tuple[tuple[str | Expr, Any], ...]:
        """The direction k and omega, which tell it from others."""
        return ("k", self.k), (symbol("omega"), self.omega)

    @cached_property
    def point(self) -> tuple[Expr, ...]:
        """The point π = omega Ik and k."""
        along = self.scene.body.tensor * Matrix(tuple(self.k))
        return (*(evaluate(self.omega * x, {}) for x in along), *self.k)

    @property
    def directions(self) -> tuple[tuple[Expr, ...], ...]:
        """The direction k."""
        return (tuple(self.k),)

    @property
    def rates(self) -> dict[str, Expr]:
        """The rate about k."""
        return {"omega": self.omega}

    @property
    def heading(self) -> str:
        """The words for it; on a curve that is no circle they say that it is one of those on the curve.

        A circle has one verdict, but for single points; on another curve the verdict is that of one rotation.
        """
        return super().heading if self.curve is None else f"{self.label}, one of those on {self.locus}"

    @property
    def singular(self) -> bool:
        """Whether the second variation is known to be degenerate: on a curve that is no circle.

        Along a circle of rotations of one rate C1 changes, so that the form need not be degenerate there.
        """
        return self.curve is not None

    @property
    def rational(self) -> bool:
        """Whether the spectrum is solved exactly: k and omega are rational."""
        return isinstance(self.omega, Rational) and are_fractions(self.k)

    def invariants(self, precision: int | None) -> Invariants:
        """Return trace and determinant of the second variation across k, and λ⁴ + p λ² + q."""
        k, data, omega = (self.k, self._data, self.omega) if precision is None else self.in_balls(precision)
        trace, determinant, p, q = amended_form(*data, k, omega)
        return Invariants((trace, determinant), (1, p, q))

    @cached_property
    def _data(self) -> Data:
        return data_at(self.scene, self.k)

    def in_balls(self, precision: int) -> tuple[list[Any], Data, Any]:
        """Return k, the data of the scene there, and omega in balls."""
        k = balls(self.k, precision)
        if isinstance(self.k, FieldNumbers):
            data, at = data_along(self.scene), dict(zip(DIRECTION, k))
        else:
            data, at = self._data, {}
        inertia, rotor, gradient, curved = data
        rows = [[[ball(e, precision, at) for e in row] for row in matrix] for matrix in (inertia, curved)]
        vectors = [[ball(e, precision, at) for e in vector] for vector in (rotor, gradient)]
        return k, Data(rows[0], vectors[0], vectors[1], rows[1]), ball(self.omega, precision)

    @cached_property
    def resonance_signs(self) -> Signs:
        """The signs of what is 0 if the frequencies are as 1 to 2, and as 1 to 3."""
        return self._proved(lambda found: [x for _, _, x in resonance_margins(*found.spectrum[1:])])

    def known(self) -> Decision | None:
        """Return the decision on a curve that is no circle, if the second variation is degenerate there."""
        if self.curve is None or self.signs[-1]:
            return None
        return ACROSS if self.spectral_signs[0] == -1 else ALONG

    def known_damped(self) -> Decision | None:
        """Return the decision under damping there, which is UNDECIDED."""
        return None if self.curve is None or self.signs[-1] else ALONG

    def held(self) -> Decision | None:
        """Return the decision by normal forms, if gyroscopic forces alone stabilise the rotation."""
        if self.scene.given_integrals:
            return None
        body, U = self.scene.body, self.scene.potential
        assert U is not None
        momentum = FieldNumbers(_Momentum(self), 0, [(n, S.One) for n in range(3)])
        return decide_window(LocalMotion(tuple(map(tuple, body.inverse.tolist())),
                                         tuple(body.gyrostatic_momentum), self.k, momentum, U.expression,
                                         self._coefficients))

    def _coefficients(self) -> tuple[Expr, Expr]:
        """Return p and q, exact."""
        _, p, q = self.invariants(None).spectrum
        return evaluate(p, {}), evaluate(q, {})

    @property
    def reached(self) -> bool:
        """Whether damping reaches every motion: M × k and the second variation of U across k are not both 0.

        With M × k = 0 the torque is 0 too, since ∇U × k = omega M × k.
        """
        for precision in doubled(PRECISION):
            with own_precision(precision):
                k, data, omega = self.in_balls(precision)
                if not all(x.contains(0) for x in unreached(*data, k, omega)):
                    return True
        return any(proved_sign(evaluate(x, {})) for x in unreached(*self._data, self.k, self.omega))


class _Momentum(RealNumbers):
    """The momentum M = omega Ik + l of a rotation, in balls, or as expressions."""

    def __init__(self, form: HeavyForm):
        self.form = form

    def values(self, precision: int) -> list[list[arb]]:
        """Return the enclosures of M."""
        with own_precision(precision):
            k, data, omega = self.form.in_balls(precision)
            return [[omega * dot(row, k) + l for row, l in zip(data.inertia, data.rotor)]]

    def expression(self, root: int, place: int) -> Expr:
        """Return a component of M."""
        return evaluate(self.form.point[place] + self.form.scene.body.gyrostatic_momentum[place], {})

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether M is rational, for a rational tensor and a rational rotor: k and omega are."""
        return self.form.rational


def data_at(scene: System, k: Sequence[Expr]) -> Data:
    """Return the inertia, the rotor, ∇U and D²U of a scene in a direction."""
    U = scene.potential
    assert U is not None
    at = dict(zip(DIRECTION, k))
    if near := near_pole(U, k[2]):
        refuse_rough("a rotation about axis 3", U, near, (), near.positive)
        slope = [S.Zero, S.Zero, near.derivative(1)]
        curved = zeros(3).tolist()                         # across k nothing is asked of the curvature
        return Data(scene.body.tensor.tolist(), list(scene.body.gyrostatic_momentum), slope, curved)
    inertia, rotor, first, second = data_along(scene)
    return Data(inertia, rotor, [evaluate(x, at) for x in first],
                [[evaluate(x, at) for x in row] for row in second])


def data_along(scene: System) -> Data:
    """Return the same in the symbols k1, k2, k3."""
    U = scene.potential
    assert U is not None
    slopes = U.gradient()
    rows = slopes, *(U.following(d) if d else (S.Zero,) * 3 for d in slopes)
    first, *second = ([U.value(d) if d else S.Zero for d in row] for row in rows)
    return Data(scene.body.tensor.tolist(), list(scene.body.gyrostatic_momentum), first, second)


def unreached(inertia: Sequence[Sequence[Any]], rotor: Sequence[Any], gradient: Sequence[Any],
              curved: Sequence[Sequence[Any]], k: Sequence[Any], omega: Any) -> list[Any]:
    """Return M × k, and D²U − k·∇U between vectors across k."""
    M, along = [omega * dot(row, k) + l for row, l in zip(inertia, rotor)], dot(gradient, k)
    rows = [[x - (along if n == m else 0) for m, x in enumerate(row)] for n, row in enumerate(curved)]
    columns = zip(*(cross(row, k) for row in rows))
    return [*cross(M, k), *(x for column in columns for x in cross(column, k))]
