"""Circles of attitudes, where the amended potential does not change as the body turns, or the frame."""
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sympy import Add, Expr, Rational, S

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import adjugate, cross
from ...algebra.rotations.by_axis import critical_on_sphere
from ...algebra.rotations.quartic_forms import QuarticForm
from ...algebra.rotations.symmetries import Turning, on_sphere
from ...algebra.text.numbers import shown
from ...errors import ScopeError
from ...mechanics.equilibrium.recognition import UNITS, direction_along, turned_up, unit
from ...mechanics.scenes.system import System
from ...stability.criteria.amended_form import dot, trace
from ...stability.damping.secular import KEEPS, lost
from ...stability.decision import Decision, Rung, settled
from ...stability.form import PRECISION
from ...stability.notion import Notion
from .orbital_form import OrbitalForm

AXES, DIGITS = "tnr", 12
# the precessions by the components of the axis along t, n, r that vanish
PRECESSIONS = ((0, 2), "cylindrical"), ((2,), "hyperbolic"), ((0,), "conical")
ON_SET = settled(True, "the energy is least on a circle or torus of equilibria, and K is positive across it",
                 Rung.LEAST_ON_SET, locus="the set of equilibria to which it belongs")
MINIMUM = settled(True, "the energy has a minimum across the turn about the axis", Rung.SECOND_VARIATION)
GROWS = settled(False, "an eigenvalue of the motion of the axis has a positive real part", Rung.SPECTRUM,
                Notion.SPECTRAL)


def on_circle(form: OrbitalForm, along: Sequence[Expr]) -> OrbitalForm:
    """Return an attitude as one of a circle about an axis of the body, with the equations of the circle."""
    direction = next(direction_along(along))
    c, t = unit(direction), cross(form.n, form.r)
    z = [evaluate(Add(*(x * y for x, y in zip(a, c))), {}) for a in (t, form.n, form.r)]
    return settled_as_set(replace(form, locus=about_axis(direction, z)), 1)


def about_axis(direction: Sequence[Expr], z: Sequence[Expr]) -> str:
    """Return the name of a circle about an axis of the body, and its equations."""
    zeros = [n for n, x in enumerate(z) if proved_sign(x) == 0]
    name = next((name for places, name in PRECESSIONS if {*places} <= {*zeros}), "")
    kind = f", {name} precession" if name else ""
    if tuple(direction) in UNITS:
        place = UNITS.index(tuple(direction)) + 1
        axis, names = f"axis {place}", [f"{a}{place}" for a in AXES]
    else:
        axis, names = f"the axis c along ({', '.join(map(str, direction))})", [f"c·{a}" for a in AXES]
    return f"a circle of equilibria about {axis}{kind}, {_equations(names[1:], z[1:])}"


def _equations(names: Sequence[str], values: Sequence[Expr]) -> str:
    return " and ".join(f"{name} {'=' if isinstance(x, Rational) else '≈'} {shown(x, DIGITS)}"
                        for name, x in zip(names, values))


def settled_as_set(form: OrbitalForm, size: int) -> OrbitalForm:
    """Return an attitude on a set that a turn carries through, with whether the energy is least on it.

    It is if K is positive across the set; along it K is the same but for the turn.
    """
    least = all(sign == 1 for sign in form.signs[:3 - size])
    return replace(form, as_set=ON_SET) if least else form


def circles_of(scene: System, form: QuarticForm, turnings: Sequence[Turning]) -> list[OrbitalForm] | None:
    """Return an attitude of each circle, or torus, of critical points that a symmetry leaves.

    None if more than one irrational factor stands in the potential.

    Raises
    ------
    ScopeError
        body and frame turn together; or the potential is constant
    """
    if len(turnings) == 6:
        raise ScopeError("the potential is the same in every attitude, and nothing turns the satellite: it "
                         "rests in each; give one, steady_motion(scene, n, r)")
    single = [t for t in turnings if not (any(t.body) and any(t.frame))]
    if not single:
        c, e = (", ".join(map(str, v)) for v in turnings[0])
        raise ScopeError("the attitudes lie on curves: the potential stays the same if the body turns about "
                         f"({c}) and the frame t, n, r about ({e}) together; give an attitude, "
                         "steady_motion(scene, n, r)")
    turning = single[0]
    if (f := on_sphere(form, turning)) is None or not isinstance(f.scale**2, Rational):
        return None
    of_body = any(turning.body)
    direction = tuple(map(S, turning.body if of_body else turning.frame))
    forms = []
    for found in critical_on_sphere(f, turned_up(unit(direction)), of_body):
        z = found.vector
        locus = _torus(turnings, z) if found.size == 2 else _circle(direction, of_body, z)
        forms.append(settled_as_set(OrbitalForm(scene, found.normal, found.vertical, locus), found.size))
    return forms


def _circle(direction: Sequence[Expr], of_body: bool, u: Sequence[Expr]) -> str:
    if of_body:
        return about_axis(direction, u)
    name = AXES[UNITS.index(tuple(direction))] if tuple(direction) in UNITS else "e"
    e = "" if name != "e" else f", e = ({', '.join(map(str, direction))}) in t, n, r"
    return f"a circle of equilibria about {name}{e}, {_equations([f'{name}{i}' for i in (1, 2, 3)], u)}"


def _torus(turnings: Sequence[Turning], z: Sequence[Expr]) -> str:
    c, e = (", ".join(map(str, v)) for v in (turnings[0].body, turnings[1].frame))
    height = evaluate(Add(*(x * y for x, y in zip(z, unit(tuple(map(S, turnings[1].frame)))))), {})
    return (f"a torus of equilibria, turned about ({c}) in the body and ({e}) in t, n, r: the cosine of "
            f"their angle is {shown(height, DIGITS)}")


def decided_modulo_turn(form: OrbitalForm, damped: bool = False) -> Decision | None:
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
        first, second, gyroscopic = trace(H), trace(adjugate(H)), dot(g, c)
        middle = A * first + gyroscopic * gyroscopic       # by a product: ** 2 of a ball about 0 is nan
        found = None
        if damped:
            found = _under_damping(form, first, second)
        elif first > 0 and second > 0:
            found = MINIMUM
        elif second < 0 or middle < 0 or middle * middle < 4 * A * A * second:
            found = GROWS
    return None if found is None or others else replace(found, modulo=(integral,))


def _under_damping(form: OrbitalForm, first: Any, second: Any) -> Decision | None:
    if first > 0 and second > 0:
        return KEEPS
    if not form.reached or not (second < 0 or second > 0 and first < 0):
        return None
    return lost(1 if second < 0 else 2)
