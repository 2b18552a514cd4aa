"""Finds as numbers where permanent rotations of a free gyrostat meet: folds, pitchforks, circles."""
from collections.abc import Iterable, Iterator

from sympy import Expr, Matrix, Symbol, eye, pi

from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.solving.plane_curves import PlaneCurve
from ...errors import ScopeError
from ...mechanics.scenes.body import Gyrostat
from ..finders.free import NU
from ..finders.rate_level_tilt import without_pi
from .pencil_branches import Pencil, meetings


def rotation_curve(body: Gyrostat, radius: Expr, free: Symbol) -> PlaneCurve:
    """Return the curve abs(adj(1 − ν I) l)² = radius² det(1 − ν I)² over a free name.

    The ν of every rotation lies on it. If l has no part along a principal axis, ν = 1/I is on it for every
    value, rotation or not.
    """
    above, below = rotation_pencil(body, radius).fraction
    inside, size, _ = without_pi(above, radius)
    try:
        return PlaneCurve(inside.dot(inside) - size**2 * below**2, NU, free, ends=())
    except ScopeError:
        if not any(x.has(pi) for x in (*body.gyrostatic_momentum, radius)):
            raise
    rotor = ", ".join(map(str, body.gyrostatic_momentum))
    raise ScopeError(f"l = ({rotor}) and M = {radius}: if only one of them contains pi (a rate in rpm does), "
                     "the values at which rotations meet are not found; give M as a multiple of pi too, "
                     "20*pi, or round l to decimals")


def rotation_pencil(body: Gyrostat, radius: Expr) -> Pencil:
    """Return the pencil of (1 − ν I) M = l."""
    return Pencil(eye(3), -body.tensor, Matrix(body.gyrostatic_momentum), radius, NU)


def rotations_meet(body: Gyrostat, radius: Expr, free: Symbol, double: Iterable[tuple[Expr, Expr]]
                   ) -> Iterator[tuple[str, Expr, Expr, tuple[Expr, ...]]]:
    """Yield (kind, value, ν, M) for every place, by the double points (value, ν) of the curve; complete.

    Parameters
    ----------
    body : Gyrostat
        with numbers for all but the free name
    radius : Expr
        abs(M), in numbers and the free name
    free : Symbol
    double : iterable of pairs

    References
    ----------
    Derived.
    """
    for value, nu in double:
        at = Point({free: value})
        if all(proved_sign(evaluate(x, at)) == 1 for x in (*body.positive, radius)):
            for kind, M in meetings(rotation_pencil(body, radius).at(at), nu):
                yield kind, value, nu, M
