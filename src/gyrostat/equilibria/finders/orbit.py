"""Finds every equilibrium of a gyrostat satellite in a circular orbit: closed forms, or zeros on a sphere."""
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Rational, S, sqrt

from ..._lazy import loaded
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.solving.real_fields import FieldNumbers
from ...algebra.solving.sphere_zeros import zeros_on_sphere
from ...errors import ScopeError, ValuesError
from ...mechanics.families.circular_orbit import NORMAL, VERTICAL, by_gradient_alone
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import symbol
from .one_torque import SIDES, in_principal_axes, one_torque
from .orbital_form import OrbitalForm
from .rate_level_tilt import exact_point

N, R = (tuple(symbol(f"{x}{i}") for i in (1, 2, 3)) for x in (NORMAL, VERTICAL))
ANY_FIELD = "equilibria.finders.orbit_torques:attitude_forms"
ORDER = "equilibria.finders.orbit_torques:by_energy"


def orbit_forms(scene: System, values: Mapping[str, Any]) -> list[OrbitalForm]:
    """Return all equilibria of a satellite in orbit, as relative_equilibria says.

    n and r are unit vectors at right angles with t·Ir = 0, t·(ω0 In + l) = 0 and r·(4 ω0 In + l) = 0. If l is
    along a principal axis they are in closed form. Else, with c = r × Ir and r·l ≠ 0, r lies on a cubic and a
    quartic, and n = (Ir − (r·Ir) r)/b, b = −r·l/(4 ω0); with r·l = 0 it is along a principal axis, and n
    turns about it. Derived in docs/explanation/derivations/satellite.md, section 7.
    """
    needed = {s.name for s in names_of_scene(scene)}
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
    here = at_numbers(scene, dict(numbers))
    if (torque := one_torque(here)) is None:
        return loaded(ANY_FIELD)(here)
    if (placed := in_principal_axes(here, torque)) is not None:
        along, axis = [i for i, x in enumerate(placed.along) if x != 0], placed.axis_of_symmetry
        forms = None
        if axis is not None and along in ([], [axis]):
            forms = list(placed.circles(axis))
        elif len(along) < 2:
            forms = list(placed.points((along or [0])[0]))
        if forms is not None:
            return forms if by_gradient_alone(here) else loaded(ORDER)(here, forms)
    if torque.axis != 1 or (found := _direction(here, [-x for x in torque.vector])) is None:
        return loaded(ANY_FIELD)(here)
    direction, scale = found
    if placed is not None and placed.rows is None:
        return [*_tilted(here, direction, scale), *_principal(here, direction, scale, axis)]
    turned = here.body.tensor * ImmutableMatrix(direction)
    across = ImmutableMatrix([direction, list(turned), list(here.body.tensor * turned)]).det()
    return list(_tilted(here, direction, scale)) if across else loaded(ANY_FIELD)(here)


def _direction(scene: System, rotor: Sequence[Expr]) -> tuple[list[Expr], Expr] | None:
    """Return the rotor over ω0 as a rational vector and a factor, 1 or the root of a rational number.

    None if it is none, or a moment is not rational.
    """
    scale = next((x for x in rotor if x != 0), S.One)
    if isinstance(scale, Rational):
        scale = S.One
    direction, numbers = [evaluate(x / scale, {}) for x in rotor], scene.body.entries
    if not all(isinstance(x, Rational) for x in (*numbers, *direction, evaluate(scale**2, {}))):
        return None
    return direction, scale


def _tilted(scene: System, l: Sequence[Expr], scale: Expr) -> Iterator[OrbitalForm]:
    """Yield the attitudes with r along no principal axis; the rotor is ω0 scale l."""
    I, level = scene.body.tensor, Add(*(x * y for x, y in zip(l, R)))
    along = list(I * ImmutableMatrix(R))
    c = cross(R, along)
    cubic = Add(*(x * (4 * y - scale**2 * level * z) for x, y, z in zip(c, I * ImmutableMatrix(along), l)))
    quartic = scale**2 * level**2 - 16 * Add(*(x**2 for x in c))
    mean = Add(*(x * y for x, y in zip(along, R)))
    normal = [-4 * (a * Add(*(x**2 for x in R)) - mean * x) for a, x in zip(along, R)]
    yield from (OrbitalForm(scene, place[3:].over(scale), place[:3])
                for place in _finite([cubic, quartic], R, level, normal))


def _finite(polynomials: Sequence[Expr], k: Sequence[Expr], but: Expr = S.One, over_it: Sequence[Expr] = ()
            ) -> list[FieldNumbers]:
    """Return the zeros on the sphere; refuse curves of them."""
    zeros = zeros_on_sphere(polynomials, k, but, over_it)
    if zeros is None or zeros.curves:
        curve = zeros and f", {zeros.curves[0].expression(k)} = 0" or ""
        raise ScopeError(f"the equilibria lie on curves{curve}: give an attitude, steady_motion(scene, n, r)")
    return zeros.points


def _principal(scene: System, l: Sequence[Expr], scale: Expr, axis: int | None
               ) -> Iterator[OrbitalForm]:
    """Yield the attitudes with r along a principal axis across l: n on a circle, t·(ω0 In + l) = 0.

    If the scale is a root, its square is taken, and one of two opposite n has the right sign.
    """
    verticals = [[S.One if i == k else S.Zero for i in range(3)] for k in range(3) if l[k] == 0]
    if axis is not None:                                   # any axis across that of symmetry is principal
        first, second = ((axis + n) % 3 for n in (1, 2))
        verticals = [v for v in verticals if v[axis]]
        verticals.append([l[second] if i == first else -l[first] if i == second else S.Zero
                          for i in range(3)])
    for v in verticals:
        t, length = cross(N, v), sqrt(Add(*(x**2 for x in v)))
        own = Add(*(moment * x * y for moment, x, y in zip(scene.body.moments, N, t)))
        given = Add(*(x * y for x, y in zip(l, t)))
        held = own + given if scale == 1 else own**2 - scale**2 * given**2
        for n in _finite([held, Add(*(x * y for x, y in zip(v, N)))], N):
            if scale == 1 or proved_sign(evaluate(own * given * scale, dict(zip(N, n)))) != 1:
                for side in SIDES:
                    yield OrbitalForm(scene, n, tuple(side * x / length for x in v))
