"""One equilibrium of a gyrostat satellite in a circular orbit, and what is decided of it."""
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

from flint import acb, acb_poly, arb
from sympy import Expr, Float

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.solving.real_fields import BITS, FieldNumbers
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.families.circular_orbit import orbital_rate, resting_at
from ...mechanics.scenes.system import System
from ...notation import Stored
from ...stability.criteria.number_notes import noted
from ...stability.damping.secular import KEEPS, lost
from ...stability.decision import Decision, Rung, settled, undecided
from ...stability.report.report import Report
from ...stability.theorems.two_directions import HELD, on_curve
from .orbital_invariants import invariants, unreached

PRECISION, DIGITS = BITS, 30                               # bits that decide; digits of a rate
TIGHT = arb("1e-60")                                       # of its square, over ω0²
LEAST = settled(True, "the energy has a minimum: K is positive definite", Rung.SECOND_VARIATION)
ODD = settled(False, "K has an odd number of negative squares: an eigenvalue has a positive real part",
              Rung.SPECTRUM, "spectral")
LEAVES = settled(False, "K has two negative squares, and the gyroscopic forces do not hold it: an eigenvalue "
                 "has a positive real part", Rung.SPECTRUM, "spectral")
OPEN = undecided(HELD)


@dataclass(frozen=True, repr=False)
class OrbitalEquilibrium(Shown, Stored):
    """A satellite at rest in the frame of its circular orbit, ω = ω0 n.

    Parameters
    ----------
    scene : System
        at its numbers
    normal, vertical : sequence of Expr, shape (3,)
        n and r in body axes, exact
    locus : str
        "" for a point, else the curve of equilibria to which it belongs, in words; of a body of revolution
        the circle, and the verdict is modulo the turn about its axis

    Examples
    --------
    >>> import gyrostat as gs
    >>> satellite = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, 0, 0)), gs.circular_orbit(1))
    >>> found = gs.relative_equilibria(satellite, {})
    >>> len(found), sum(e.decision.verdict is gs.Verdict.STABLE for e in found)
    (24, 4)
    """

    scene: System
    normal: Sequence[Expr]
    vertical: Sequence[Expr]
    locus: str = ""

    @cached_property
    def n(self) -> tuple[Expr, ...]:
        """The normal of the orbit in body axes."""
        return tuple(self.normal)

    @cached_property
    def r(self) -> tuple[Expr, ...]:
        """The vertical, outwards, in body axes."""
        return tuple(self.vertical)

    @property
    def t(self) -> tuple[Expr, ...]:
        """n × r, along the velocity."""
        return tuple(evaluate(x, {}) for x in cross(self.n, self.r))

    @cached_property
    def point(self) -> tuple[Expr, ...]:
        """π = ω0 In, n and r, in the coordinates of the scene."""
        return tuple(evaluate(x, {}) for x in resting_at(self.scene, self.n, self.r))

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The same as a claimed point, for a report."""
        return equilibrium(self.scene, self.point, label="equilibrium in orbit")

    @cached_property
    def decision(self) -> Decision:
        """The verdict; of a body of revolution modulo the turn about its axis."""
        return noted(self._decided(), self.scene)

    def _decided(self) -> Decision:
        if self.scene.linear_integrals:
            return Report(self.equilibrium).verdict({})
        trace_, second, whole, *spectrum = self.signs
        if self.locus:                                     # K is degenerate along the curve
            found = LEAVES if -1 in spectrum else on_curve(self.equilibrium, {})
            return undecided(self.locus) if found is None else found
        if whole == -1:
            return ODD
        if trace_ == second == whole == 1:
            return LEAST
        if whole == 1 and None not in (trace_, second):    # two negative squares
            if -1 in spectrum:
                return LEAVES
            if spectrum == [1, 1, 1, 1]:
                return OPEN
        return Report(self.equilibrium).verdict({})

    @cached_property
    def itself(self) -> Decision | None:
        """What holds of the point where the decision is modulo the flow of an integral; else None."""
        return Report(self.equilibrium).itself({}) if self.decision.modulo else None

    @cached_property
    def damped(self) -> Decision:
        """The verdict under internal damping."""
        return noted(self._decided_under_damping(), self.scene)

    def _decided_under_damping(self) -> Decision:
        if self.scene.linear_integrals:
            return Report(self.equilibrium).verdict({}, damped=True)
        trace_, second, whole, *_ = self.signs
        if None in (trace_, second, whole) or not whole or not self._reached:
            return Report(self.equilibrium).verdict({}, damped=True)
        left = [s for s in (1, trace_, second, whole) if s]
        growing = sum(a != b for a, b in zip(left, left[1:]))
        return lost(growing) if growing else KEEPS

    @cached_property
    def signs(self) -> tuple[int | None, ...]:
        """Of e1, e2, e3 of K, then of c2, c1, c0 and the discriminant of the sextic; None is not proved."""
        for precision in doubled(PRECISION):
            with own_precision(precision):
                found = [1 if x > 0 else -1 if x < 0 else None for x in self._enclosed(precision)]
            if self.locus or None not in found[:3]:
                break
        if None in found[:3] and not self.locus:
            exact = invariants(self.scene.body.tensor.tolist(), self.scene.body.gyrostatic_momentum, self.n,
                               self.r, orbital_rate(self.scene))
            found = [proved_sign(evaluate(x, {})) if s is None else s for s, x in zip(found, exact)]
        return tuple(found)

    @property
    def frequencies(self) -> tuple[Expr, ...]:
        """Of the librations, in increasing order, to 30 digits [1/T]."""
        with own_precision(2 * PRECISION):
            found = [(-root.real).sqrt() for root in self._squares if root.real < 0 and root.imag.contains(0)]
            return tuple(_decimal(x) for x in sorted(found, key=lambda x: float(x.mid())))

    @property
    def growth_rate(self) -> Expr | None:
        """The largest real part of an eigenvalue [1/T]; None where there is none that is positive."""
        with own_precision(2 * PRECISION):
            rates = [x.sqrt().real for x in self._squares if not (x.real < 0 and x.imag.contains(0))]
            largest = max((x for x in rates if x > 0), key=lambda x: float(x.mid()), default=None)
            return None if largest is None else _decimal(largest)

    @cached_property
    def _squares(self) -> list[acb]:
        """λ², the roots of the sextic's cubic; but one that is 0, where K is singular."""
        found = list[acb]()
        for precision in doubled(2 * PRECISION):
            with own_precision(precision), suppress(ValueError):       # two roots are closer than that
                found = self._squares_at(precision)
                if all(x.rel_accuracy_bits() > 4 * DIGITS for x in found):
                    break
        return found

    def _squares_at(self, precision: int) -> list[acb]:
        a, b, c, gap = self._enclosed(precision)[3:]
        d = ball(self.scene.body.tensor.det(method="berkowitz"), precision)
        tight = TIGHT * ball(orbital_rate(self.scene), precision) ** 2
        if self.locus or self.signs[2] == 0:
            if (a**2 - 4 * b * d).contains(0):
                return [acb(-a / (2 * d))] * 2
            return list(acb_poly([b, a, d]).roots(tight))
        if not gap.contains(0):
            return list(acb_poly([c, b, a, d]).roots(tight))
        if (apart := a**2 - 3 * b * d).contains(0):
            return [acb(-a / (3 * d))] * 3
        double = (9 * d * c - a * b) / (2 * apart)
        return [acb(x) for x in (double, double, -a / d - 2 * double)]

    def _enclosed(self, precision: int) -> tuple[arb, ...]:
        """The invariants in balls."""
        body, rate = self.scene.body, ball(orbital_rate(self.scene), precision)
        *tensor, rotor, n, r = (balls(x, precision) for x in (
            *body.tensor.tolist(), body.gyrostatic_momentum, self.normal, self.vertical))
        return invariants(tensor, rotor, n, r, rate)

    @property
    def _reached(self) -> bool:
        """Whether internal damping reaches every motion: t·In and n·In − r·Ir do not both vanish."""
        rows = self.scene.body.tensor.tolist()
        for precision in doubled(PRECISION):
            with own_precision(precision):
                found = unreached([balls(row, precision) for row in rows], balls(self.normal, precision),
                                  balls(self.vertical, precision))
                if any(not x.contains(0) for x in found):
                    return True
        return any(proved_sign(evaluate(x, {})) for x in unreached(rows, self.n, self.r))


def balls(numbers: Sequence[Expr], precision: int) -> list[arb]:
    """Enclosures, of numbers in a field without their expressions."""
    if isinstance(numbers, FieldNumbers):
        return numbers.balls(precision)
    return [ball(x, precision) for x in numbers]


def _decimal(x: arb) -> Expr:
    return Float(x.mid().str(DIGITS, radius=False), DIGITS)
