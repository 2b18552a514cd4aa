"""Decides a gyroscopically stabilised maximum of the amended potential by Arnold's theorem.

An equilibrium with two degrees of freedom and frequencies without a resonance to order 4 is stable if D4 ≠ 0.
"""
from contextlib import suppress
from dataclasses import replace
from math import gcd
from typing import Any

from flint import fmpq

from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import evaluate, sign_of_constant
from ..decision import Decision, Rung, settled, undecided
from .birkhoff import Modes, normalised, real, twist
from .d4_by_averages import averages
from .local_motion import PRECISION, LocalMotion, fraction
from .resonances import LOWEST, NOTION, PRECISIONS, decimals, sign_of

ROUGH = "U has powers of 1 ∓ k3 there that are not whole, and normal forms ask for more derivatives"
STABILISED = "the amended potential has a maximum, and gyroscopic forces stabilise it; "
HELD = undecided(f"{STABILISED}normal forms decide at given numbers")


def between_cuts(decision: Decision, twists: bool | None) -> Decision:
    """Return what a decision at one point of a window says about all points between two of its resonances.

    If the window is cut at the zeros of D4, too, it holds at each point. If not, it holds at all but single
    ones: D4 is analytic along the window, and not 0 at that point. If the resonances are not known, twists is
    None, and it says nothing about other points.
    """
    if twists is None or decision.rung not in (Rung.TWIST_POSITIVE, Rung.TWIST_NEGATIVE):
        return replace(HELD, note=decision.note)
    rung, but = (decision.rung, "") if twists else (Rung.TWIST, ", except at single points")
    return replace(decision, pointwise=False, rung=rung,
                   reason=f"{STABILISED}D4 is not 0, and there is no resonance to order 4{but} (Arnold)")


def resonance_margin(p: Any, q: Any, first: int, second: int) -> Any:
    """Return (m n)² p² − (m² + n²)² q, which is 0 if the frequencies are as m to n [1/T⁴].

    With ω1/ω2 = m/n, p = ω1² + ω2² and q = ω1² ω2² have p²/q = (m² + n²)²/(m n)²: see
    docs/explanation/derivations/d4.md, section 1.
    """
    return (first * second) ** 2 * p**2 - (first**2 + second**2) ** 2 * q


def resonance_margins(p: Any, q: Any) -> list[tuple[int, int, Any]]:
    """Return m, n and what is 0 if the frequencies are as m to n, which to order 4 are 1 to 2 and 1 to 3."""
    return [(m, n, resonance_margin(p, q, m, n)) for m, n in ((1, 2), (1, 3))]


def resonances_up_to(order: int) -> list[tuple[int, int]]:
    """Return the pairs m ≤ n without a common factor, m + n at most the order."""
    return [(m, n) for total in range(2, order + 1) for m in range(1, total // 2 + 1)
            for n in (total - m,) if gcd(m, n) == 1]


def decide_window(motion: LocalMotion) -> Decision:
    """Return what normal forms decide if gyroscopic forces stabilise a maximum of the amended potential."""
    found = undecided(ROUGH) if motion.rough else _decided(motion)
    return replace(found, pointwise=True, reason=f"{STABILISED}{found.reason}")


def _decided(motion: LocalMotion) -> Decision:
    """Return the decision if the eigenvalues are imaginary, none is 0, and the form has both signs.

    The form is the second variation. Resonances to order 4 are excluded exactly; then D4 ≠ 0 proves
    stability. If D4 = 0 and there is no resonance to order 6, D6 ≠ 0 does.

    References
    ----------
    Arnold, Sov. Math. Dokl. 2 (1961) 247-249; Moser, Mem. Am. Math. Soc. 81 (1968); Meyer, Hall & Offin,
    Introduction to Hamiltonian Dynamical Systems and the N-Body Problem, chapter 13. The order of the tests:
    docs/explanation/derivations/d4.md, sections 1 and 9.
    """
    for pair in resonances_up_to(4):
        holds = _resonant(motion, pair)
        if holds is None:
            return undecided(f"whether the frequencies are in the ratio {pair[0]} to {pair[1]} is not proved")
        if holds:
            return LOWEST[pair](motion)
    for precision in PRECISIONS:
        with own_precision(precision), suppress(ZeroDivisionError):
            parts, found = motion.first if precision == PRECISION else motion.in_balls(4, precision)
            D4 = real(twist(normalised(parts, found)[4], found))
            if sign_of(D4):
                rung = Rung.TWIST_POSITIVE if sign_of(D4) > 0 else Rung.TWIST_NEGATIVE
                return settled(True, f"D4 = {decimals(D4)}, no resonance to order 4, the frequencies are "
                               f"{signed(found)} (Arnold)", rung, NOTION)
        if motion.rational and not _twist(motion):
            break
    return _sixth_order(motion)


def signed(found: Modes) -> str:
    """Return the frequencies as text, each with the sign of its energy."""
    return ", ".join(decimals(value.imag).replace("-", "−") for value in found.values)


def _sixth_order(motion: LocalMotion) -> Decision:
    """Return the decision if D4 is 0, or nearly: D6 ≠ 0 proves stability whether D4 is 0 or not."""
    for pair in resonances_up_to(6)[len(resonances_up_to(4)):]:
        if (sign := _resonant(motion, pair)) is not False:
            what = "is not excluded" if sign is None else "holds"
            return undecided(f"D4 = 0, and the resonance {pair[0]}:{pair[1]} {what}")
    for precision in PRECISIONS:
        with own_precision(precision), suppress(ZeroDivisionError):
            parts, found = motion.in_balls(6, precision)
            if sign_of(D6 := real(twist(normalised(parts, found)[6], found))):
                return settled(True, f"D4 = 0, D6 = {decimals(D6)}, no resonance to order 6, the "
                               f"frequencies are {signed(found)} (Arnold)", Rung.SIXTH_ORDER, NOTION)
    return undecided("D4 and D6 are not proved to differ from 0: terms of higher degree decide")


def _twist(motion: LocalMotion) -> fmpq:
    """Return D4 at rational numbers, a rational number."""
    found = averages(motion.energy(4, fraction))
    return found.top / found.bottom


def _resonant(motion: LocalMotion, pair: tuple[int, int]) -> bool | None:
    """Tell whether the frequencies are in a ratio: by balls, and exactly only if these do not exclude it."""
    for precision in () if motion.rational else PRECISIONS:
        with own_precision(precision), suppress(ZeroDivisionError):
            found = motion.first if precision == PRECISION else motion.in_balls(2, precision)
            first, second = (-real(value**2) for value in found[1].values)
            if sign_of(resonance_margin(first + second, first * second, *pair)):
                return False
    sign = sign_of_constant(evaluate(resonance_margin(motion.p, motion.q, *pair), {}))
    return None if sign is None else sign == 0
