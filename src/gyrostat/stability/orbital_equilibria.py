"""Every equilibrium of a gyrostat satellite in a circular orbit."""
from collections.abc import Iterator, Mapping
from typing import Any

from sympy import Add, Matrix, S, expand

from ..algebra.exact import evaluate, proved_sign
from ..algebra.matrices import cross
from ..algebra.sphere_zeros import zeros_on_sphere
from ..errors import ScopeError, ValuesError
from ..mechanics.circular_orbit import NORMAL, VERTICAL, by_gradient_alone, orbital_rate
from ..mechanics.system import System, at_numbers, names_of_scene
from ..notation import symbol
from .asked import exact_point
from .orbital_equilibrium import OrbitalEquilibrium

N, R = (tuple(symbol(f"{x}{i}") for i in (1, 2, 3)) for x in (NORMAL, VERTICAL))
CURVE = "a closed curve of equilibria, (l·r)² = 16 ω0² abs(r × Ir)²"


def orbital_equilibria(scene: System, values: Mapping[str, Any]) -> list[OrbitalEquilibrium]:
    """All of them, as relative_equilibria says.

    n and r are unit vectors at right angles with t·Ir = 0, t·(ω0 In + l) = 0 and r·(4 ω0 In + l) = 0. With
    c = r × Ir and r·l ≠ 0, r lies on a cubic and a quartic, and n = (Ir − (r·Ir) r)/b, b = −r·l/(4 ω0); with
    r·l = 0 it is along a principal axis, and n turns about it.
    """
    if not by_gradient_alone(scene):
        raise ScopeError("another field acts beside the gravity gradient, or a rotor is free, for which no "
                         "complete list is proved: give an attitude, steady_motion(scene, n, r)")
    needed = {s.name for s in names_of_scene(scene)}
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
    here = at_numbers(scene, dict(numbers))
    moments = here.body.moments
    if any(proved_sign(moments[i] - moments[i - 1]) == 0 for i in range(3)):
        raise ScopeError(f"the satellite has equal moments, {', '.join(map(str, moments))}: its equilibria "
                         "are not isolated; those with the rotor along its axis are orbital_precession")
    return [*_tilted(here), *_principal(here)]


def _tilted(scene: System) -> Iterator[OrbitalEquilibrium]:
    """Where r is along no principal axis."""
    I, rate = scene.body.moments, orbital_rate(scene)
    l = [evaluate(x / rate, {}) for x in scene.body.gyrostatic_momentum]
    if not any(l):
        return
    along = [moment * x for moment, x in zip(I, R)]
    c, level = cross(R, along), Add(*(x * y for x, y in zip(l, R)))
    cubic = expand(4 * (I[1] - I[0]) * (I[2] - I[0]) * (I[2] - I[1]) * R[0] * R[1] * R[2]
                   - level * Add(*(x * y for x, y in zip(l, c))))
    quartic = expand(level**2 - 16 * Add(*(x**2 for x in c)))
    mean = Add(*(x * y for x, y in zip(along, R)))
    normal = [expand(-4 * (a * Add(*(x**2 for x in R)) - mean * x)) for a, x in zip(along, R)]
    found = zeros_on_sphere([cubic, quartic], R, level, normal)
    if found is not None:
        yield from (OrbitalEquilibrium(scene, place[3:], place[:3]) for place in found)
        return
    for x in R:                                            # where the curve meets the principal planes
        yield from (OrbitalEquilibrium(scene, place[3:], place[:3], CURVE)
                    for place in zeros_on_sphere([quartic, x], R, level, normal) or ())


def _principal(scene: System) -> Iterator[OrbitalEquilibrium]:
    """Where r is along a principal axis across l: n on a circle, t·(ω0 In + l) = 0."""
    rate, l = orbital_rate(scene), scene.body.gyrostatic_momentum
    for axis in range(3):
        if l[axis]:
            continue
        for side in (S.One, S.NegativeOne):
            r = tuple(side if i == axis else S.Zero for i in range(3))
            held = [rate * moment * x + y for moment, x, y in zip(scene.body.moments, N, l)]
            across = expand(Matrix(cross(N, r)).dot(Matrix(held)))
            for n in zeros_on_sphere([across, N[axis]], N) or ():
                yield OrbitalEquilibrium(scene, n, r)
