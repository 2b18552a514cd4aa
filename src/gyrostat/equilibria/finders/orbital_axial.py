"""Equilibria of a satellite in a circular orbit in closed form: no rotor, or one along a principal axis."""
from collections.abc import Iterator, Mapping

from sympy import Expr, S, sqrt

from ...algebra.reals.exact import evaluate, proved_sign
from ...mechanics.scenes.system import System
from .orbital_form import OrbitalForm

CURVE = "a closed curve of equilibria, (l·r)² = 16 ω0² abs(r × Ir)²"
SIDES = S.One, S.NegativeOne
Vector = tuple[Expr, Expr, Expr]


def along_an_axis(scene: System, axis: int, L: Expr) -> Iterator[OrbitalForm]:
    """With the rotor ω0 L along an axis j that is none of symmetry; complete.

    n along j, r along another axis; or r along k, n in the plane of i and j, n_j = L/(I_i − I_j); or t along
    i, n in the plane of j and k, n_j = L/(4 (I_k − I_j)). Where L² = 4 (I_i − I_j) (I_k − I_j) a closed curve
    joins those that are tilted.
    """
    moments = scene.body.moments
    others = [i for i in range(3) if i != axis]
    beyond = {i: moments[i] - moments[axis] for i in others}
    locus = CURVE if L != 0 and proved_sign(L**2 - 4 * beyond[others[0]] * beyond[others[1]]) == 0 else ""
    for i, k in (others, others[::-1]):
        for up in SIDES:
            for side in SIDES:
                yield OrbitalForm(scene, _vector({axis: side}), _vector({k: up}))
            for high, across in _tilts(L, beyond[i]):
                yield OrbitalForm(scene, _vector({axis: high, i: across}), _vector({k: up}), locus)
            for high, across in _tilts(L, 4 * beyond[k]):
                vertical = _vector({axis: -up * across, k: up * high})
                yield OrbitalForm(scene, _vector({axis: high, k: across}), vertical, locus)


def circles(scene: System, axis: int, L: Expr) -> Iterator[OrbitalForm]:
    """Of a body of revolution with the rotor ω0 L along its axis: the precessions, a point of each circle."""
    i, k = (n for n in range(3) if n != axis)
    beyond = scene.body.moments[i] - scene.body.moments[axis]
    circle = f"a circle of equilibria about axis {axis + 1}, "
    for side in SIDES:
        yield OrbitalForm(scene, _vector({axis: side}), _vector({i: S.One}),
                                 f"{circle}cylindrical precession")
        for high, across in _tilts(L, beyond)[:1]:
            yield OrbitalForm(scene, _vector({axis: high, i: across}), _vector({k: side}),
                                     f"{circle}hyperbolic precession")
        for high, across in _tilts(L, 4 * beyond)[:1]:
            vertical = _vector({axis: side * across, i: -side * high})
            yield OrbitalForm(scene, _vector({axis: high, i: across}), vertical,
                                     f"{circle}conical precession")


def _tilts(L: Expr, beyond: Expr) -> list[tuple[Expr, Expr]]:
    """Of a unit vector with the component L/beyond along an axis, that and the one across, of either sign."""
    if proved_sign(beyond**2 - L**2) != 1:
        return []
    high = evaluate(L / beyond, {})
    across = evaluate(sqrt(1 - high**2), {})
    return [(high, across), (high, -across)]


def _vector(components: Mapping[int, Expr]) -> Vector:
    first, second, third = (components.get(i, S.Zero) for i in range(3))
    return first, second, third
