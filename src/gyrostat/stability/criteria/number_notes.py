"""Says what is unusual about the numbers of a scene or a state, each time in a sentence.

Such numbers are no error, but they should not be overlooked.
"""
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from sympy import Add, Expr, ImmutableMatrix, Poly, Rational, S, Symbol, eye, sqrt

from ...algebra.enclosures.balls import ball
from ...algebra.reals.exact import Point, evaluate, sign, sign_of_constant
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.coupled import CoupledPotential
from ...mechanics.scenes.system import System
from ...notation import components
from ..decision import Decision

K = components("k")
# |k|² changes by no more if the three components of a unit vector are rounded to doubles
ROUNDED = Rational(1, 2**51)


def scene_note(scene: System, numbers: Mapping[Symbol, Expr]) -> str:
    """Return what is unusual about a scene at numbers, as far as they are given; "" if nothing is.

    The inertia comes first, then the field.
    """
    return ". ".join(filter(None, (inertia_note(scene.body, numbers), gradient_note(scene, numbers))))


def noted(decision: Decision, scene: System) -> Decision:
    """Return a decision about a scene of numbers, with what is unusual about them."""
    note = scene_note(scene, {})
    return replace(decision, note=note) if note else decision


def state_note(scene: System, state: Sequence[Expr]) -> str:
    """Return what is unusual about a scene of numbers and a state of it."""
    return ". ".join(filter(None, (scene_note(scene, {}), directions_note(scene, state))))


def inertia_note(body: Gyrostat, numbers: Mapping[Symbol, Expr]) -> str:
    """Return a sentence if the moments break the triangle inequality: those of a rigid body do not."""
    if not _names(body.entries) <= numbers.keys():
        return ""
    if any(sign(excess, numbers) == -1 for excess in _excesses(body)):
        if isinstance(body.inertia, ImmutableMatrix):
            return ("no rigid body has this inertia tensor: a principal moment exceeds the sum of the others "
                    "(a body in a fluid may)")
        moments = [evaluate(m, numbers) for m in body.moments]
        return (f"no rigid body has the moments {', '.join(map(str, moments))}: one exceeds the sum of the "
                "others (a body in a fluid may)")
    return ""


def directions_note(scene: System, state: Sequence[Expr]) -> str:
    """Return a sentence if the directions have other lengths, or another angle, than the scene gives them."""
    if not isinstance(scene.potential, CoupledPotential):
        return length_note(state[3:])
    at = dict(zip(scene.space.coordinates, state))
    for casimir, value in scene.potential.held:
        if not _rounded((found := casimir.xreplace(at)) - value):
            return f"{casimir} = {ball(found, 128).mid().str(12, radius=False)}, and has to be {value}"
    return ""


def length_note(k: Sequence[Expr]) -> str:
    """Return a sentence if k is no unit vector, even if its components are rounded ones."""
    excess = Add(*(x**2 for x in k), -1)
    if not k or _rounded(excess):
        return ""
    length = ball(sqrt(excess + 1), 128).mid().str(12, radius=False)
    return (f"|k| = {length}, not 1: k is meant to be a direction, a unit vector; with another length every "
            "torque is larger or smaller")


def _rounded(excess: Expr) -> bool:
    """Tell whether an excess is not proved to be more than numbers rounded to doubles leave."""
    return sign_of_constant(excess - ROUNDED) != 1 and sign_of_constant(-excess - ROUNDED) != 1


def gradient_note(scene: System, numbers: Mapping[Symbol, Expr]) -> str:
    """Return a sentence if U is c k·Ik, c > 0, up to a constant on abs(k) = 1.

    That is the potential of a satellite, in a field that is fixed in space.

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), 8.1: U = (3/2) n² k·Ik, k towards the centre of the Earth.
    """
    if scene.potential is None or not scene.potential.given or scene.coupled:
        return ""
    form = _form(scene.potential.expression)
    if form is None or isinstance(scene.body.inertia, ImmutableMatrix):
        return ""
    others, first, second = form
    expressions = (*others, first, second, *scene.body.moments)
    if not _names(expressions) <= numbers.keys():
        return ""
    point = numbers if isinstance(numbers, Point) else Point(numbers)
    if any(sign_of_constant(evaluate(e, point)) != 0 for e in others):
        return ""
    a, b, I1, I2, I3 = (evaluate(e, point) for e in expressions[len(others):])
    wanted = [sign_of_constant(x) for x in (I1 - I3, I2 - I3)]
    if None in wanted or not any(wanted) or [sign_of_constant(x) for x in (a, b)] != wanted:
        return ""
    if sign_of_constant((a * (I2 - I3) - b * (I1 - I3)).expand()) != 0:
        return ""
    return ("U is c k·Ik, the potential of the gravity gradient; k is here a direction fixed in space, not "
            "the local vertical of an orbit, which turns: this is not the satellite in its orbit; "
            "circular_orbit has that one")


@lru_cache(maxsize=64)
def _form(U: Expr) -> tuple[tuple[Expr, ...], Expr, Expr] | None:
    """Return U on abs(k) = 1 as a constant + a k1² + b k2² + others: the other coefficients, a and b.

    The others have to vanish. None if U is not of this form.
    """
    if not U.is_polynomial(*K):
        return None
    reduced: dict[tuple[int, ...], Expr] = {}
    for (i, j, n), c in Poly(U, *K).terms():               # k3² = 1 − k1² − k2²
        square = Poly((1 - K[0] ** 2 - K[1] ** 2) ** (n // 2), *K)
        for (p, q, _), d in square.terms():
            place = (i + p, j + q, n % 2)
            reduced[place] = reduced.get(place, S.Zero) + c * d
    first, second = (reduced.pop(place, S.Zero) for place in ((2, 0, 0), (0, 2, 0)))
    reduced.pop((0, 0, 0), None)
    if first == second == 0:
        return None
    return tuple(c for c in reduced.values() if c.expand() != 0), first, second


@lru_cache(maxsize=256)
def _names(expressions: tuple[Expr, ...]) -> frozenset[Symbol]:
    return frozenset(s for e in expressions for s in e.free_symbols)


@lru_cache(maxsize=256)
def _excesses(body: Gyrostat) -> tuple[Expr, ...]:
    """Return by how much each moment falls short of the sum of the others.

    For a tensor, return what is not negative if none exceeds it: tr I/2 − I is the matrix of the second
    moments, with the eigenvalues (I2 + I3 − I1)/2, …, of which at most one is negative.
    """
    if isinstance(body.inertia, ImmutableMatrix):
        second = body.tensor.trace() * ImmutableMatrix(eye(3)) / 2 - body.tensor
        return second.adjugate().trace(), second.det(method="berkowitz")
    return tuple(Add(*body.moments) - 2 * m for m in dict.fromkeys(body.moments))
