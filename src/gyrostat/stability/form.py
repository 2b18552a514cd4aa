"""The second variation and the spectrum of a relative equilibrium in numbers, for every kind of scene.

Signs are proved in balls, or exactly; they count the negative squares by Descartes' rule (Chetaev).
"""
from collections.abc import Callable, Sequence
from typing import Any, ClassVar, NamedTuple

from sympy import Expr, S

from .._cached import cached_property
from ..algebra.enclosures.precision import doubled, own_precision
from ..algebra.reals.exact import evaluate, proved_sign, sign_changes
from ..mechanics.equilibrium.claimed_point import equilibrium
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.scenes.system import System
from ..notation import Stored, symbol
from .decision import Decision
from .spectrum import Signs, conditions, exact_rates, rates_in_balls

PRECISION = 128                                            # bits that decide


class Invariants(NamedTuple):
    """The invariants that decide a relative equilibrium, in balls or exact.

    Parameters
    ----------
    form : sequence
        e1, …, em, the elementary symmetric functions of the eigenvalues of the second variation
    spectrum : sequence
        the coefficients of the characteristic polynomial in λ², that of the highest power, positive, first
    """

    form: Sequence[Any]
    spectrum: Sequence[Any]


class Form(Stored):
    """The second variation of the energy at a relative equilibrium, and the spectrum of the motion near it.

    A finder for one kind of scene says where the equilibrium lies, what the invariants are, in balls and
    exactly, and the words of the reasons; signs, index, frequencies and growth rate follow here.

    The index is the number of sign changes in 1, e1, …, em. By Descartes' rule for det(t + Q) it counts the
    negative eigenvalues of a symmetric matrix Q that is not singular. If internal damping reaches every
    motion, as many modes grow (Kelvin, Tait, Chetaev).

    References
    ----------
    Chetaev, The Stability of Motion (1961), §§26-30; Descartes' rule, which is exact if all roots are real.
    """

    LEAST: ClassVar[Decision]                              # if the second variation is definite
    ODD: ClassVar[Decision]                                # if the index is odd: a real eigenvalue grows
    LEAVES: ClassVar[Decision]                             # if it is even, and an eigenvalue grows
    greatest: ClassVar[bool] = False                       # whether a maximum proves stability, too
    label: str
    scene: System

    @property
    def locus(self) -> str:
        """The set of equilibria to which it belongs, in words; "" if it is a single point."""
        if self.curve is not None:
            return f"a curve, {self.curve} = 0"
        if self.circle is None or not any(self.circle):
            return "" if self.circle is None else "the whole sphere"
        if self.circle.count(S.Zero) == 2:
            return f"the circle about axis {next(n for n, x in enumerate(self.circle, 1) if x != 0)}"
        return f"the circle about the axis along ({', '.join(map(str, self.circle))})"

    @property
    def circle(self) -> tuple[Expr, ...] | None:
        """A vector along the axis about which it may be turned, (0, 0, 0) for any axis; else None."""
        return None

    @property
    def curve(self) -> Expr | None:
        """A polynomial that vanishes on its set of equilibria, if that is no circle; else None."""
        return None

    @property
    def singular(self) -> bool:
        """Whether the second variation is known to be degenerate: on a set of equilibria."""
        return bool(self.locus)

    @property
    def heading(self) -> str:
        """What a document calls it: the label, with the set of equilibria if there is one."""
        return f"{self.label}s on {self.locus}" if self.locus else self.label

    @property
    def at(self) -> Expr:
        """The value of k3 in its conditions: a number at a pole, else the symbol."""
        return symbol("k3")

    @property
    def described(self) -> tuple[tuple[str | Expr, Any], ...]:
        """The entries of place for a sentence: letters with vectors, names with numbers.

        None stands for every number.
        """
        raise NotImplementedError

    @property
    def turns(self) -> bool:
        """Whether ω turns in the body, as in a regular precession."""
        return False

    @property
    def rational(self) -> bool:
        """Whether frequencies and growth rate are solved exactly."""
        return False

    @property
    def placed(self) -> Sequence[tuple[Sequence[str], Sequence[Expr | None]]]:
        """The names of what tells it from others of its scene, with their numbers, not yet written out.

        Those of a vector stand together: in the field of a root they are expressions when asked for.
        """
        return [([f"{name}{n}" for n in range(1, len(value) + 1)], value) if isinstance(name, str)
                else ([str(name)], [value]) for name, value in self.described]

    @property
    def place(self) -> dict[str, Expr | None]:
        """What tells it from others of its scene, by name; vectors by their components."""
        return {name: x for names, numbers in self.placed for name, x in zip(names, numbers)}

    @property
    def point(self) -> tuple[Expr, ...]:
        """The point in the coordinates of the scene."""
        raise NotImplementedError

    @property
    def directions(self) -> tuple[tuple[Expr, ...], ...]:
        """The unit vectors in the body, if any."""
        return tuple(self.point[n:n + 3] for n in range(3, len(self.point), 3))

    @property
    def rates(self) -> dict[str, Expr]:
        """The rates of the rotation, by name [1/T]."""
        raise NotImplementedError

    @property
    def reached(self) -> bool:
        """Whether internal damping reaches every motion near it."""
        raise NotImplementedError

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The equilibrium as a point whose equations were checked."""
        return equilibrium(self.scene, self.point, label=self.label)

    def known(self) -> Decision | None:
        """Return the decision if it is known without the invariants, as on a set of equilibria; else None."""
        return None

    def known_damped(self) -> Decision | None:
        """Return the decision under internal damping if it is known without the invariants; else None."""
        return None

    def known_point(self) -> Decision | None:
        """Return what is known about the point, if the decision is modulo a flow; else None."""
        return None

    def held(self) -> Decision | None:
        """Return the decision if the index is even, not 0, and no eigenvalue grows.

        None if the report is to decide.
        """
        return None

    def degenerate(self) -> Decision | None:
        """Return the decision if a sign is 0, or not proved; None if the report is to decide."""
        return None

    def invariants(self, precision: int | None) -> Invariants:
        """Return the invariants in balls of a precision, or exactly if it is None."""
        raise NotImplementedError

    @cached_property
    def signs(self) -> Signs:
        """The signs of e1, …, em; None for one that is not proved."""
        return self._proved(lambda found: found.form)

    @cached_property
    def spectral_signs(self) -> Signs:
        """The signs of what has to be positive, beside em, for every λ² to be negative."""
        return self._proved(lambda found: conditions(found.spectrum))

    def _proved(self, values: Callable[[Invariants], Sequence[Any]]) -> Signs:
        # balls decide nearly always; on a set of equilibria a sign is 0, which no precision can prove
        for precision in doubled(PRECISION):
            with own_precision(precision):
                found = tuple(1 if x > 0 else -1 if x < 0 else None
                              for x in values(self.invariants(precision)))
            if self.singular or None not in found:
                return found
        return tuple(proved_sign(evaluate(x, {})) if sign is None else sign
                     for sign, x in zip(found, values(self.invariants(None))))

    @property
    def index(self) -> int | None:
        """The number of negative squares; None if the form is degenerate, or a sign is not proved."""
        if None in self.signs or not self.signs[-1]:
            return None
        return sign_changes(self.signs)

    @property
    def frequencies(self) -> tuple[Expr, ...]:
        """The frequencies of the small motions on the coadjoint orbit, in increasing order [1/T].

        They are exact if the spectrum has rational coefficients and at most two roots, else they have 30
        digits.
        """
        return self._rates[0]

    @property
    def growth_rate(self) -> Expr | None:
        """The largest real part of an eigenvalue [1/T]; None if none is positive."""
        return self._rates[1]

    @cached_property
    def _rates(self) -> tuple[tuple[Expr, ...], Expr | None]:
        """Frequencies and growth rate, by the roots λ² of the spectrum without one that is 0."""
        whole = self.signs[-1]
        if self.rational:
            top, *spectrum = self.invariants(None).spectrum
            return exact_rates([x / top for x in spectrum], whole, self.spectral_signs)
        return rates_in_balls(lambda precision: list(self.invariants(precision).spectrum), bool(whole))
