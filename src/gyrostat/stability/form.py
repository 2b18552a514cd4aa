"""Form: the second variation at a relative equilibrium and its spectrum, for every kind of scene."""
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
    """What decides, in balls or exact.

    Parameters
    ----------
    form : sequence
        e1, …, em: the elementary symmetric functions of the eigenvalues of the second variation
    spectrum : sequence
        the coefficients of the characteristic polynomial in λ², that of the highest power, positive, first
    """

    form: Sequence[Any]
    spectrum: Sequence[Any]


class Form(Stored):
    """The second variation of the energy at a relative equilibrium, and the spectrum of the motion near it.

    A finder says for its kind of scene where the equilibrium lies, what the invariants are, in balls and
    exactly, and the words of the reasons; signs, index, frequencies and growth rate follow here.

    The index is the number of sign changes in 1, e1, …, em, which counts the negative eigenvalues of a
    symmetric matrix that is not singular. Under damping that reaches every motion as many modes grow.

    References
    ----------
    Chetaev, The Stability of Motion (1961), §§26-30; Descartes' rule, exact where all roots are real.
    """

    LEAST: ClassVar[Decision]                              # it is definite
    ODD: ClassVar[Decision]                                # the index is odd
    LEAVES: ClassVar[Decision]                             # it is even, and the spectrum grows
    greatest: ClassVar[bool] = False                       # whether a maximum proves as a minimum does
    label: str
    scene: System

    @property
    def locus(self) -> str:
        """The set of equilibria of which it is a point, in words; "" of a point alone."""
        if self.curve is not None:
            return f"a curve, {self.curve} = 0"
        if self.circle is None or not any(self.circle):
            return "" if self.circle is None else "the whole sphere"
        if self.circle.count(S.Zero) == 2:
            return f"the circle about axis {next(n for n, x in enumerate(self.circle, 1) if x != 0)}"
        return f"the circle about the axis along ({', '.join(map(str, self.circle))})"

    @property
    def circle(self) -> tuple[Expr, ...] | None:
        """Along the axis about which the point may be turned, (0, 0, 0) for any; None of no circle."""
        return None

    @property
    def curve(self) -> Expr | None:
        """Of a set that is no circle a polynomial that vanishes on it."""
        return None

    @property
    def singular(self) -> bool:
        """Whether the second variation is known to be degenerate: on a set of equilibria."""
        return bool(self.locus)

    @property
    def heading(self) -> str:
        """What a document calls it."""
        return f"{self.label}s on {self.locus}" if self.locus else self.label

    @property
    def at(self) -> Expr:
        """What k3 is in conditions of it: a number at a pole."""
        return symbol("k3")

    @property
    def described(self) -> tuple[tuple[str | Expr, Any], ...]:
        """The same as place for a sentence: letters with vectors, names with numbers, None for every number.
        """
        raise NotImplementedError

    @property
    def turns(self) -> bool:
        """Whether ω turns in the body, as in a regular precession."""
        return False

    @property
    def rational(self) -> bool:
        """Whether the spectrum is solved exactly."""
        return False

    @property
    def place(self) -> dict[str, Expr | None]:
        """What tells it from others of its scene, by name: what describes it, vectors by components."""
        found: dict[str, Expr | None] = {}
        for name, value in self.described:
            found |= ({f"{name}{n}": x for n, x in enumerate(value, 1)} if isinstance(name, str)
                      else {str(name): value})
        return found

    @property
    def point(self) -> tuple[Expr, ...]:
        """In the coordinates of the scene."""
        raise NotImplementedError

    @property
    def directions(self) -> tuple[tuple[Expr, ...], ...]:
        """The unit vectors in the body, if any."""
        return tuple(self.point[n:n + 3] for n in range(3, len(self.point), 3))

    @property
    def rates(self) -> dict[str, Expr]:
        """Of the rotation, by name [1/T]."""
        raise NotImplementedError

    @property
    def reached(self) -> bool:
        """Whether internal damping reaches every motion near it."""
        raise NotImplementedError

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """As a claimed point."""
        return equilibrium(self.scene, self.point, label=self.label)

    def known(self) -> Decision | None:
        """The decision where the invariants are not asked, as on a set of equilibria; else None."""
        return None

    def known_damped(self) -> Decision | None:
        """The same under internal damping."""
        return None

    def known_point(self) -> Decision | None:
        """The same of the point, where the decision is modulo a flow."""
        return None

    def held(self) -> Decision | None:
        """The decision where the index is even, not 0, and the spectrum does not grow; None: as a report."""
        return None

    def degenerate(self) -> Decision | None:
        """The decision where a sign is 0, or not proved; None: as a report."""
        return None

    def invariants(self, precision: int | None) -> Invariants:
        """In balls of a precision; None: exact."""
        raise NotImplementedError

    @cached_property
    def signs(self) -> Signs:
        """Of e1, …, em; None is not proved."""
        return self._proved(lambda found: found.form)

    @cached_property
    def spectral_signs(self) -> Signs:
        """Of what has to be positive for every λ² to be negative, but for the sign of em."""
        return self._proved(lambda found: conditions(found.spectrum))

    def _proved(self, values: Callable[[Invariants], Sequence[Any]]) -> Signs:
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
        """The number of negative squares; None where the form is degenerate, or a sign is not proved."""
        if None in self.signs or not self.signs[-1]:
            return None
        return sign_changes(self.signs)

    @property
    def frequencies(self) -> tuple[Expr, ...]:
        """Of the small motions on the coadjoint orbit, in increasing order [1/T].

        Exact where the spectrum has rational coefficients and at most two roots; else to 30 digits.
        """
        return self._rates[0]

    @property
    def growth_rate(self) -> Expr | None:
        """The largest real part of an eigenvalue [1/T]; None where there is none that is positive."""
        return self._rates[1]

    @cached_property
    def _rates(self) -> tuple[tuple[Expr, ...], Expr | None]:
        """Of the roots λ² of the spectrum, without one that is 0."""
        whole = self.signs[-1]
        if self.rational:
            top, *spectrum = self.invariants(None).spectrum
            return exact_rates([x / top for x in spectrum], whole, self.spectral_signs)
        return rates_in_balls(lambda precision: list(self.invariants(precision).spectrum), bool(whole))
