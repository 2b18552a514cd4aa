"""Confirms by Arnold's theorem, at rational numbers, that gyroscopic forces stabilise a maximum.

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
    """Return what Model.stability proves or, if it proves nothing, what Arnold's theorem proves."""
    sign, why = model.stability()
    return (sign, why) if sign else Oscillations(model).stability()


def normal_form_names(model: Model) -> Mapping[str, Any]:
    """Return the signed frequencies, how they change with the actions, D4 and D6, by their names."""
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
    """The two oscillations of a model at numbers in a polynomial field, if p, q, p² − 4q > 0."""

    model: Model

    @cached_property
    def coefficients(self) -> tuple[Expr, Expr]:
        """p and q of λ⁴ + p λ² + q."""
        polynomial = Poly(self.model.polynomial, symbol("lamda"))
        return polynomial.coeff_monomial(symbol("lamda") ** 2), polynomial.coeff_monomial(1)

    @cached_property
    def oscillates(self) -> bool:
        """Whether the model has two frequencies, and a polynomial field."""
        if len(self.model.coordinates) != 6 or not self.model.U.is_polynomial(*K):
            return False
        p, q = self.coefficients
        return all(x.is_number and sign_of_constant(x) == 1 for x in (p, q, p**2 - 4 * q))

    @property
    def rational(self) -> bool:
        """Whether all numbers of the model are rational."""
        return all(x.is_Rational for x in (*self.model.point, *self.model.inertia, *self.model.rotor,
                                           *Poly(self.model.U, *K).coeffs()))

    def is_resonant(self, m: int, n: int) -> bool:
        """Return whether the frequencies are as m to n, in either order."""
        p, q = self.coefficients
        return bool((m * n) ** 2 * p**2 == (m**2 + n**2) ** 2 * q)

    def stability(self) -> tuple[int, str]:
        """Return 1 if it is proved stable, −1 if unstable, 0 if neither; and why."""
        if not self.oscillates or not self.rational:
            return 0, ""
        for ratio in (2, 3):
            if self.is_resonant(1, ratio):
                return self._resonance(ratio)
        for order in (4, 6):
            if any(self.is_resonant(m, order - m) for m in (1, 2)):
                return 0, ""
            if not (D := self.twist(order)).contains(0):
                return 1, (f"gyroscopic forces stabilise it: there is no resonance to order {order}, and "
                           f"D{order} = {D.str(12, radius=False)} is not 0 (from the frequencies of motions "
                           "nearby, by Newton and Euler's equations): Lyapunov stable (Arnold-Moser)")
        return 0, ""

    def _resonance(self, ratio: int) -> tuple[int, str]:
        """Prove instability at 1:2 or 1:3, if the slower oscillation drives the faster.

        The energies have both signs. At 1:3 the drive has to exceed what the frequencies change.
        """
        with own_precision(BITS):
            motion = Motion(self.model, self.coefficients, ratio, ratio)
            drives = (not motion.driving.contains(0) if ratio == 2
                      else motion.amplitude.real > abs(motion.twists[0]))
            if motion.signs[0] == motion.signs[1] or not drives:
                return 0, ""
        return -1, (f"the frequencies are as 1 to {ratio}, their energies have both signs, and by Newton "
                    "and Euler's equations the slower oscillation drives the faster: unstable (Markeev)")

    def twist(self, order: int) -> Any:
        """Return D4 or D6 in a ball."""
        with own_precision(BITS):
            return self._motion(order - 1).twists[order // 2 - 2].real

    @cached_property
    def frequencies(self) -> tuple[Any, Any]:
        """The two frequencies, the greater first, each with the sign of its energy."""
        with own_precision(BITS):
            motion = self._motion(2)
            first, second = (rate * sign for rate, sign in zip(motion.rates, motion.signs))
            return first, second

    @cached_property
    def birkhoff(self) -> tuple[Any, Any, Any]:
        """The coefficients of J1², J1 J2 and J2²."""
        with own_precision(BITS):
            motion = self._motion(3)
            one, mixed, two = motion.bent
            return one.real, motion.signs[0] * motion.signs[1] * mixed.real, two.real

    def _motion(self, order: int) -> Motion:
        if not self.oscillates:
            raise PublishedError("a normal form by Newton and Euler's equations needs a polynomial U, and "
                                 "p, q, p² − 4q > 0")
        return Motion(self.model, self.coefficients, order)
