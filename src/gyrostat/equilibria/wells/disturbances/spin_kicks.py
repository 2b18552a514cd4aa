"""The impulses that a free gyrostat bears, which change its momentum sphere: by planes of separatrices."""
import math
from collections.abc import Sequence
from typing import Any

from flint import arb
from sympy import Matrix

from ....algebra.enclosures.balls import ball
from ....algebra.enclosures.precision import own_precision
from ....algebra.reals.exact import evaluate, sign_of_constant
from ....algebra.rings.matrices import cross
from ....errors import ScopeError
from ...relative_equilibrium import RelativeEquilibrium
from ..in_balls import BITS, dot, form, in_balls, rows_in_balls
from .kicks import below, given_direction, principal_moments

SPHERE = ("a kick changes the momentum sphere of a free body, and the well with it: a bound is known of a "
          "spin about the axis of the greatest or the least moment, with a slow rotor along it alone; ask "
          "for the barrier")


def spin_kick(rotation: RelativeEquilibrium, direction: Sequence[Any] | None) -> float:
    """Return the impulse along u, or of all the least, below which a spin about axis 3 stays in its well.

    With aᵢ = 1/Iᵢ − 1/I3, a1 > a2 > 0, and λ = l/I3 the separatrices of all spheres with abs(M) > abs(λ)/a2
    lie in the planes √(a1 − a2) abs(M1) = √a2 abs(M3 + λ/a2); between them a motion stays in the well of its
    own sphere. From M3 = m they are (m + λ/a2) √(a2/a1) away. On smaller spheres with λ > 0 the pass is at M3
    = −abs(M), where the energy is 2 λ abs(M) higher; a kick against M leads there from M = 0 on. For the axis
    of the least moment, where the energy is greatest, aᵢ and λ have the opposite signs.

    Raises
    ------
    ScopeError
        it is no such spin
    ValuesError
        the direction is none

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 6, for the separatrices of a gyrostat.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/4")))
    >>> spin = next(e for e in gs.relative_equilibria(body, {"M": 1}) if e.momentum == (0, 0, 1))
    >>> round(spin_kick(spin, None), 12)
    0.75
    """
    scene, exact = rotation.scene, list(rotation.momentum)
    rotor, along = list(scene.body.gyrostatic_momentum), list(scene.body.tensor * Matrix(exact))
    if any(_nonzero(x) for v in (rotor, along) for x in cross(v, exact)):
        raise ScopeError(SPHERE)
    with own_precision(BITS):
        M, l, inverse = in_balls(exact), in_balls(rotor), rows_in_balls(scene.body.inverse)
        m, moments = dot(M, M).sqrt(), principal_moments(rotation)
        own = 1 / form(inverse, [x / m for x in M])
        least = rotation.form.index != 0
        sign, others = (-1, moments[1:]) if least else (1, moments[:2])
        if not own.overlaps(moments[0 if least else 2]):
            raise ScopeError(SPHERE)
        steep, flat = sorted((sign * (1 / x - 1 / own) for x in others), key=lambda a: -float(a.mid()))
        rate = sign * dot(l, M) / (m * own)
        if not (flat > 0 and abs(rate) < flat * m and steep > flat):
            raise ScopeError(SPHERE)
        ahead = m + rate / flat
        if direction is None:
            return min(below(ahead * (flat / steep).sqrt()), below(m))
        u = given_direction(direction)
        size = sum((ball(x, BITS)**2 for x in u), arb(0)).sqrt()
        v = [ball(x, BITS) / size for x in u]
        up = dot(v, M) / m
        bend = sign * (form(inverse, v) - 1 / own)             # a1 u1² + a2 u2²
        side = (bend - flat * (1 - up**2)).upper().max(arb(0)).sqrt()
        falls = (side - flat.sqrt() * up).upper()
        found = below(flat.sqrt() * ahead / falls) if falls > 0 else math.inf
        if rate > 0 and bend > 0:
            t = 2 * rate / bend * (up + (1 + bend * m / rate).sqrt())
            if not m**2 + 2 * m * t * up + t**2 > (rate / flat)**2:
                found = min(found, below(t))
        back = up < 0 and not any(_nonzero(x) for x in cross(u, exact))
        return min(found, below(m)) if back else found


def _nonzero(x: Any) -> bool:
    return sign_of_constant(evaluate(x, {})) != 0
