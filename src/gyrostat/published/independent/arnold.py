"""What confirms a verdict where gyroscopic forces hold a maximum: Arnold's theorem, at rational numbers.

Nothing here uses the normal forms of the library.
"""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Float, Poly

from ..._cached import cached_property
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import sign_of_constant
from ...errors import PublishedError
from ...notation import symbol
from ..names.kinematics import Later
from .counterexample import K, Model
from .oscillations import Motion

BITS, DIGITS = 256, 40


def stability(model: Model) -> tuple[int, str]:
    """As Model.stability, and where that proves nothing, by Arnold's theorem."""
    sign, why = model.stability()
    return (sign, why) if sign else Oscillations(model).stability()


def normal_form_names(model: Model) -> Mapping[str, Any]:
    """Signed frequencies, how they change with the actions, D4 and D6."""
    at = Oscillations(model)
    return {"frequency_1": Later(lambda: _number(at.frequencies[0])),
            "frequency_2": Later(lambda: _number(at.frequencies[1])),
            "birkhoff_20": Later(lambda: _number(at.birkhoff[0])),
            "birkhoff_11": Later(lambda: _number(at.birkhoff[1])),
            "birkhoff_02": Later(lambda: _number(at.birkhoff[2])),
            "D4": Later(lambda: _number(at.twist(4))), "D6": Later(lambda: _number(at.twist(6)))}


def _number(x: Any) -> Expr:
    return Float(x.str(DIGITS, radius=False), DIGITS)


@dataclass(frozen=True)
class Oscillations:
    """Of a model at numbers in a polynomial field, where p, q, p² − 4q > 0."""

    model: Model

    @cached_property
    def coefficients(self) -> tuple[Expr, Expr]:
        """p and q of λ⁴ + p λ² + q."""
        polynomial = Poly(self.model.polynomial, symbol("lamda"))
        return polynomial.coeff_monomial(symbol("lamda") ** 2), polynomial.coeff_monomial(1)

    @cached_property
    def oscillates(self) -> bool:
        """Whether it has two frequencies, in a polynomial field."""
        if len(self.model.coordinates) != 6 or not self.model.U.is_polynomial(*K):
            return False
        p, q = self.coefficients
        return all(x.is_number and sign_of_constant(x) == 1 for x in (p, q, p**2 - 4 * q))

    @property
    def rational(self) -> bool:
        """Whether all numbers are."""
        return all(x.is_Rational for x in (*self.model.point, *self.model.inertia, *self.model.rotor,
                                           *Poly(self.model.U, *K).coeffs()))

    def is_resonant(self, m: int, n: int) -> bool:
        """Whether m Ω1 = n Ω2."""
        p, q = self.coefficients
        return bool((m * n) ** 2 * p**2 == (m**2 + n**2) ** 2 * q)

    def stability(self) -> tuple[int, str]:
        """1 proved stable, −1 unstable, 0 neither; and why."""
        if not self.oscillates or not self.rational:
            return 0, ""
        for ratio in (2, 3):
            if self.is_resonant(1, ratio):
                return self._resonance(ratio)
        for order in (4, 6):
            if any(self.is_resonant(m, order - m) for m in (1, 2)):
                return 0, ""
            if not (D := self.twist(order)).contains(0):
                return 1, (f"gyroscopic forces stabilise it: no resonance to order {order}, and D{order} = "
                           f"{D.str(12, radius=False)}, not 0, from how the frequencies of motions nearby "
                           "change by Newton and Euler's equations: Lyapunov stable (Arnold-Moser)")
        return 0, ""

    def _resonance(self, ratio: int) -> tuple[int, str]:
        """At 1:2 and 1:3, energies of both signs: unstable where the slower oscillation drives the faster.

        At 1:3 by more than the frequencies change.
        """
        with own_precision(BITS):
            motion = Motion(self.model, self.coefficients, ratio, ratio)
            drives = (not motion.driving.contains(0) if ratio == 2
                      else motion.amplitude.real > abs(motion.twists[0]))
            if motion.signs[0] == motion.signs[1] or not drives:
                return 0, ""
        return -1, (f"the frequencies are as 1 to {ratio}, their energies of both signs, and by Newton and "
                    "Euler's equations the slower oscillation drives the faster: unstable (Markeev)")

    def twist(self, order: int) -> Any:
        """D4 or D6 in a ball."""
        with own_precision(BITS):
            return self._motion(order - 1).twists[order // 2 - 2].real

    @cached_property
    def frequencies(self) -> tuple[Any, Any]:
        """The greater first, each with the sign of its energy."""
        with own_precision(BITS):
            motion = self._motion(2)
            first, second = (rate * sign for rate, sign in zip(motion.rates, motion.signs))
            return first, second

    @cached_property
    def birkhoff(self) -> tuple[Any, Any, Any]:
        """Coefficients of J1², J1 J2 and J2²."""
        with own_precision(BITS):
            motion = self._motion(3)
            one, mixed, two = motion.bent
            return one.real, motion.signs[0] * motion.signs[1] * mixed.real, two.real

    def _motion(self, order: int) -> Motion:
        if not self.oscillates:
            raise PublishedError("a normal form by Newton and Euler's equations is one of a polynomial U, "
                                 "where p, q, p² − 4q > 0")
        return Motion(self.model, self.coefficients, order)
