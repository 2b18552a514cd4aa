"""The level of the integrals on which a body of revolution in U(k3) moves, in exact numbers.

On it g(k3) = I1² k̇3², and whatever the kind of motion depends on is decided exactly.
"""
from dataclasses import dataclass
from functools import lru_cache
from itertools import zip_longest
from typing import Any

from flint import arb, ctx, fmpq
from sympy import Expr, Poly, Rational, S, sqrt, trigsimp

from ..._cached import cached_property
from ...algebra.enclosures.algebraic import is_algebraic
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.rationals import to_flint, to_sympy
from ...algebra.reals.exact import proved_sign
from ...errors import ValuesError
from ...mechanics.scenes.system import System
from ...notation import Stored, symbol

K3 = symbol("k3")


@dataclass(frozen=True)
class Level(Stored):
    """The level of the integrals on which a state moves, in exact numbers.

    g(z) = (abs(p)² + 2 I1 (U(k3) − U(z))) (abs(k)² − z²) − (v − P z)².

    The numbers are fmpq if all of them are rational and U is a polynomial, else expressions.

    Parameters
    ----------
    scene : System
        a body of revolution in U(k3), at given numbers
    state : tuple of six Expr
        exact numbers; abs(k) > 0
    """

    scene: System
    state: tuple[Expr, ...]

    @cached_property
    def numbers(self) -> tuple[Any, ...]:
        """The numbers I1, I3, l, then the state."""
        body = self.scene.body
        given = (body.moments[0], body.moments[2], body.gyrostatic_momentum[2], *self.state)
        rational = self.field is not None and all(isinstance(x, Rational) for x in (*given, *self.field))
        return tuple(map(to_flint, given)) if rational else given

    @cached_property
    def field(self) -> tuple[Expr, ...] | None:
        """The coefficients of U, the constant first; None if it is no polynomial."""
        return coefficients(self.potential)

    @property
    def potential(self) -> Expr:
        """The potential U as a function of k3."""
        return self.scene.potential.expression if self.scene.potential else S.Zero

    @property
    def inertia(self) -> Any:
        """The transverse moment I1."""
        return self.numbers[0]

    @property
    def height(self) -> Any:
        """The value of k3 at the start."""
        return self.numbers[8]

    @cached_property
    def square_radius(self) -> Any:
        """The square of abs(k)."""
        square = sum(x * x for x in self.numbers[6:])
        return square if isinstance(square, fmpq) or is_algebraic(square) else trigsimp(square)

    @cached_property
    def axial(self) -> Any:
        """The axial momentum P = π3 + l."""
        return self.numbers[5] + self.numbers[2]

    @cached_property
    def across(self) -> Any:
        """The square abs(p)² = π1² + π2² at the start."""
        return self.numbers[3] * self.numbers[3] + self.numbers[4] * self.numbers[4]

    @cached_property
    def twist(self) -> Any:
        """The product π1 k1 + π2 k2 at the start, v − P k3."""
        return self.numbers[3] * self.numbers[6] + self.numbers[4] * self.numbers[7]

    @cached_property
    def level(self) -> Any:
        """The level v = M·k."""
        return self.twist + self.axial * self.height

    def _kinetic(self, z: Expr) -> tuple[Expr, Expr]:
        """Return abs(p)² and its derivative at a value of k3."""
        U, I1 = self.potential, expression(self.inertia)
        moved = U.xreplace({K3: expression(self.height)}) - U.xreplace({K3: z})
        return expression(self.across) + 2 * I1 * moved, -2 * I1 * U.diff(K3).xreplace({K3: z})

    @cached_property
    def polynomial(self) -> list[Any] | None:
        """The coefficients of g, the constant first; None if U is no polynomial."""
        if self.field is None:
            return None
        U = [to_flint(c) if isinstance(self.height, fmpq) else c for c in self.field]
        fall = [-2 * self.inertia * c for c in U]
        fall[0] = fall[0] + self.across - sum(c * self.height**n for n, c in enumerate(fall))
        turned = [self.level * self.level, -2 * self.level * self.axial, self.axial * self.axial]
        g = [self.square_radius * a - b for a, b in zip([*fall, 0, 0], [0, 0, *fall])]
        return [a - b for a, b in zip_longest(g, turned, fillvalue=0)]

    @cached_property
    def poles(self) -> tuple[int, int]:
        """The signs of v + P abs(k) and v − P abs(k), 0 if the axis may pass the lower and the upper pole."""
        lower, upper = (self._sign(side * self.axial) for side in (1, -1))
        return lower, upper

    def _sign(self, axial: Any) -> int:
        """Return the sign of v + P abs(k), without the root in abs(k)."""
        first, second = known(self.level), known(axial)
        if first * second >= 0:
            return first or second
        return first * known(self.level * self.level - axial * axial * self.square_radius)

    @cached_property
    def direction(self) -> int:
        """The sign of k̇3 at the start; at rest 0."""
        return known(self.numbers[4] * self.numbers[6] - self.numbers[3] * self.numbers[7])

    @cached_property
    def turn(self) -> int:
        """The sign of k̈3 at the start if k̇3 is 0; 0 on a steady precession."""
        if self.polynomial is None:                        # g′ by the product rule; 2 I1² k̈3 = g′
            _, fall = self._kinetic(self.height)
            return known(fall * (self.square_radius - self.height**2) - 2 * self.height * self.across
                         + 2 * self.axial * self.twist)
        return known(sum(n * c * self.height ** (n - 1) for n, c in enumerate(self.polynomial) if n))

    @cached_property
    def contact(self) -> tuple[int, int]:
        """The multiplicities of −abs(k) and abs(k) as roots of g.

        They are 0, 1, or 2 if the motion is asymptotic to the pole; 3 stands for more.
        """
        lower, upper = (self._multiplicity(sign, side) for sign, side in zip(self.poles, (-1, 1)))
        return lower, upper

    def _multiplicity(self, sign: int, side: int) -> int:
        if sign:
            return 0
        pole = side * sqrt(expression(self.square_radius))
        kinetic, fall = self._kinetic(pole)
        if known(kinetic):
            return 1
        curvature = -4 * pole * fall - 2 * kinetic - 2 * expression(self.axial) ** 2       # g″ at the pole
        return 2 if known(curvature) else 3

    @cached_property
    def at_pole(self) -> int:
        """The sign 1 or −1 if the motion starts at the upper or the lower pole, else 0."""
        return known(self.height) if known(self.square_radius - self.height * self.height) == 0 else 0


@lru_cache(maxsize=64)
def coefficients(U: Expr) -> tuple[Expr, ...] | None:
    """Return the coefficients of a polynomial in k3, the constant first; None if it is none."""
    return tuple(reversed(Poly(U, K3).all_coeffs())) if U.is_polynomial(K3) else None


def expression(number: Any) -> Expr:
    """Return a number of either kind as an expression."""
    return to_sympy(number) if isinstance(number, fmpq) else S(number)


def enclosed(number: Any) -> arb:
    """Return an enclosure at the precision of the moment."""
    return arb(number) if isinstance(number, fmpq) else ball(number, ctx.prec)


def known(constant: Any) -> int:
    """Return the sign of a constant, which has to be proved here.

    Raises
    ------
    ValuesError
        it is not proved: the constant may be 0
    """
    if isinstance(constant, fmpq):
        return (constant > 0) - (constant < 0)
    return proved_sign(constant, lambda: ValuesError(
        f"whether {constant} is 0 is not proved, and the motion depends on it: write the numbers with "
        "rationals and roots"))
