"""Decides at a resonance of the second to the fourth order, at which Arnold's theorem says nothing.

The theorems are those of Sokolskii (1:1) and Markeev (1:2 and 1:3), on the resonant normal form: see
docs/explanation/derivations/d4.md, section 9.
"""
from collections.abc import Iterator
from typing import Any

from flint import acb, arb, fmpq

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.eigenvalues import in_ratio
from ...algebra.rings.series import Part, is_zero, substituted
from ..decision import C1, Decision, Rung, settled, undecided
from ..notion import Notion
from .birkhoff import W1, W2, Z1, Z2, colliding, linear_motion, modes, normalised, not_zero, real, twist
from .local_motion import InBalls, LocalMotion, fraction

PRECISIONS = (128, 512, 2048)                              # bits, one after the other
NOTION = Notion.ARNOLD_MOSER
OPEN = "what decides it is not proved to differ from 0"


def second_order_resonance(motion: LocalMotion) -> Decision:
    """Return the decision at 1:1, p² = 4q, of the Hamiltonian-Hopf bifurcation: stable if ε𝒜 > 0.

    The normal form is ω S + ε abs(q)²/2 + 𝒜 (abs(p)²/2)² + …

    Sokolskii, J. Appl. Math. Mech. 38 (1974) 741-749; Lerman & Markova, Regul. Chaotic Dyn. 14 (2009)
    148-162.
    """
    said = "the frequencies are equal (1:1, Hamiltonian-Hopf)"
    for parts, p, values in _rings(motion, fmpq(2), 1):
        product = colliding(linear_motion(parts[2]), p, values[0], parts)
        if product is None:
            continue                                       # in balls the next precision may prove one
        if sign := sign_of(product):
            stable, compared = sign > 0, "<>"[sign > 0]
            return _settled(stable, f"{said}, ε𝒜 {compared} 0 (Sokolskii)")
        if isinstance(product, fmpq):
            return undecided(f"{said}, and ε𝒜 = 0: terms of higher degree decide")
    if product is None:
        return undecided(f"{said}, and the linear motion is semisimple, or nearly: not decided")
    return undecided(f"{said}, and {OPEN}")


def third_order_resonance(motion: LocalMotion) -> Decision:
    """Return the decision at 1:2, 4p² = 25q: unstable if the coefficient b of z1 z2² is not 0.

    If b = 0, D4 ≠ 0 proves stability.

    Markeev, J. Appl. Math. Mech. 32 (1968) 766-772; Alfriend, Celest. Mech. 1 (1970) 351-359.
    """
    said = "resonance 1:2"
    terms = Z1 + 2 * W2, W1 + 2 * Z2
    for parts, p, values in _rings(motion, fmpq(5), 2):
        found = modes(linear_motion(parts[2]), p, values)
        b = substituted(parts[3], found.forms, terms).get(terms[0], 0)
        if not_zero(b):
            return _settled(False, f"{said}, the coefficient b of z1 z2² is not 0 (Markeev)")
        if is_zero(b):
            D = real(twist(normalised(parts, found, terms)[4], found))
            if sign_of(D):
                return _settled(True, f"{said} with b = 0, D4 = {decimals(D)} is not 0")
            if isinstance(D, fmpq):
                return undecided(f"{said}, b = 0 and D4 = 0: terms of higher degree decide")
    return undecided(f"{said}, and {OPEN}")


def fourth_order_resonance(motion: LocalMotion) -> Decision:
    """Return the decision at 1:3, 9p² = 100q: stable if abs(D4) > R, unstable if less, open at equality.

    On h2 = 0 the normal form is D4 + R cos φ: no direction leaves if it has no zero.

    Markeev, J. Appl. Math. Mech. 32 (1968) 766-772; Cabral & Meyer, Nonlinearity 12 (1999) 1351-1362.
    """
    said = "resonance 1:3"
    terms = Z1 + 3 * W2, W1 + 3 * Z2
    for parts, p, values in _rings(motion, fmpq(10), 3):
        found = modes(linear_motion(parts[2]), p, values)
        quartic = normalised(parts, found, terms)[4]
        r, D = quartic.get(terms[0], 0), real(twist(quartic, found))
        actions = real(values[1] / found.norms[0]), real(values[0] / found.norms[1])
        square = 4 * real(r * r.conjugate()) * abs(actions[0] * actions[1] ** 3) if not is_zero(r) else 0
        if sign := sign_of(D * D - square):
            stable, compared = sign > 0, "<>"[sign > 0]
            why = f"{said}, |D4| = {decimals(abs(D))} {compared} R = {decimals(arb(square).sqrt())}"
            return _settled(stable, why)
        if isinstance(D, fmpq):
            return undecided(f"{said} with |D4| = R: terms of higher degree decide")
    return undecided(f"{said}, and {OPEN}")


LOWEST = {(1, 1): second_order_resonance, (1, 2): third_order_resonance, (1, 3): fourth_order_resonance}


def _settled(stable: bool, why: str) -> Decision:
    """Return STABLE on its level of C1, on which alone the resonance holds, or UNSTABLE."""
    if stable:
        return settled(True, why, Rung.RESONANCE, NOTION, level=(C1,))
    return settled(False, why, Rung.RESONANCE)


def _rings(motion: LocalMotion, squares: fmpq, ratio: int
           ) -> Iterator[tuple[list[Part], Any, tuple[Any, Any]]]:
    """Yield the energy to degree 4, p, and eigenvalues in a ratio, −p = squares λ2².

    They are exact if all numbers are rational, else in balls of more and more bits.
    """
    if motion.rational:
        p = fraction(motion.p)
        yield motion.energy(4, fraction), p, in_ratio(-p / squares, ratio)
        return
    for precision in PRECISIONS:
        with own_precision(precision):
            p = ball(motion.p, precision)
            omega = (p / arb(squares)).sqrt()
            yield motion.energy(4, InBalls(precision)), p, (acb(0, ratio * omega), acb(0, omega))


def sign_of(x: Any) -> int:
    """Return the sign of a fraction or a ball; 0 if it is not proved to be another."""
    return 1 if x > 0 else -1 if x < 0 else 0


def decimals(x: Any) -> str:
    """Return six digits of a fraction or a ball."""
    return str(arb(x).str(6, radius=False))
