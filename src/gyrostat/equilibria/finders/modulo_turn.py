"""Decides a satellite modulo the turn about its axis of symmetry, by the motion of the axis, in balls."""
from dataclasses import replace
from typing import Any

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.rings.matrices import adjugate, cross
from ...stability.criteria.amended_form import dot, trace
from ...stability.damping.secular import KEEPS, lost
from ...stability.decision import Decision, Rung, settled
from ...stability.form import PRECISION
from ...stability.notion import Notion
from .orbital_form import OrbitalForm

MINIMUM = settled(True, "the energy has a minimum across the turn about the axis", Rung.SECOND_VARIATION)
GROWS = settled(False, "an eigenvalue of the motion of the axis has a positive real part", Rung.SPECTRUM,
                Notion.SPECTRAL)


def decided(form: OrbitalForm, damped: bool = False) -> Decision | None:
    """Return the decision modulo the turn about the axis, or under damping; None if balls do not decide.

    With the axis c, H = K + C (c × ω0 n)(c × ω0 n)ᵀ across c is the second variation at fixed momentum about
    c, and A² λ⁴ + (A tr H + (g·c)²) λ² + e2(H) the spectrum. At a fixed rotor the second variation is K.
    Derived in docs/explanation/derivations/satellite.md, section 8.
    """
    scene = form.scene
    (integral, *others) = scene.linear_integrals
    with own_precision(PRECISION):
        axis = [ball(x, PRECISION) for x in scene.space.gradient(integral).flat()[:3]]
        length = dot(axis, axis).sqrt()
        c = [x / length for x in axis]
        I, K, g, along = form.motion(PRECISION)
        C = dot(c, [dot(row, c) for row in I])
        A, v = (trace(I) - C) / 2, cross(c, along)
        H = K if damped else [[x + C * a * b for x, b in zip(row, v)] for row, a in zip(K, v)]
        first, second, turn = trace(H), trace(adjugate(H)), dot(g, c) ** 2
        found = None
        if damped:
            found = _under_damping(form, first, second)
        elif first > 0 and second > 0:
            found = MINIMUM
        elif second < 0 or A * first + turn < 0 or (A * first + turn) ** 2 < 4 * A**2 * second:
            found = GROWS
    return None if found is None or others else replace(found, modulo=(integral,))


def _under_damping(form: OrbitalForm, first: Any, second: Any) -> Decision | None:
    if first > 0 and second > 0:
        return KEEPS
    if not form.reached or not (second < 0 or second > 0 and first < 0):
        return None
    return lost(1 if second < 0 else 2)
