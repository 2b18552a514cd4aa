"""Where permanent rotations of a free gyrostat meet, as numbers: folds, pitchforks, circles."""
from collections.abc import Iterator

from sympy import Expr, Matrix, S, Symbol, eye, pi

from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.solving.pencils import along_kernel
from ...algebra.solving.plane_curves import PlaneCurve
from ...errors import ScopeError
from ...mechanics.scenes.body import Gyrostat
from ..finders.free import NU
from ..finders.rate_level_tilt import without_pi

Place = tuple[str, Expr, Expr, tuple[Expr, ...]]


def rotation_curve(body: Gyrostat, radius: Expr, free: Symbol) -> PlaneCurve:
    """abs(adj(1 − ν I) l)² = radius² det(1 − ν I)², on which ν of every rotation lies, over a free name.

    Where l has no part along a principal axis, ν = 1/I is on it for every value, rotation or not.
    """
    above, below = _fraction(body)
    inside, size, _ = without_pi(above, radius)
    try:
        return PlaneCurve(inside.dot(inside) - size**2 * below**2, NU, free, ends=())
    except ScopeError:
        if not any(x.has(pi) for x in (*body.gyrostatic_momentum, radius)):
            raise
    rotor = ", ".join(map(str, body.gyrostatic_momentum))
    raise ScopeError(f"l = ({rotor}) and M = {radius}: with pi in one of them only, as a rate in rpm brings "
                     "it, where rotations meet is not found: give M as a multiple of pi too, 20*pi, or round "
                     "the wheel to decimals")


def places_where_rotations_meet(body: Gyrostat, radius: Expr, free: Symbol) -> Iterator[Place]:
    """(kind, value, ν, M) of every one; complete.

    At a double point of the curve that is no pole M is one vector, hence a fold. At a pole ν = 1/I two
    rotations M ± x e lie on either side of a principal plane, and meet where x = 0; of a double pole they are
    a circle.

    Parameters
    ----------
    body : Gyrostat
        with numbers for all but the free name
    radius : Expr
        abs(M), in numbers and the free name
    free : Symbol

    References
    ----------
    Derived.
    """
    for value, nu in rotation_curve(body, radius, free).double:
        at = Point({free: value})
        if all(proved_sign(evaluate(x, at)) == 1 for x in (*body.positive, radius)):
            for kind, M in _met_at(body_at(body, at), evaluate(radius, at), nu):
                yield kind, value, nu, M


def body_at(body: Gyrostat, at: Point) -> Gyrostat:
    """The body at a value of the free name."""
    return body.changed(lambda x: evaluate(x, at))


def _met_at(body: Gyrostat, radius: Expr, nu: Expr) -> Iterator[tuple[str, tuple[Expr, ...]]]:
    """(kind, M) of what meets at a double point of the curve, at numbers."""
    above, below = _fraction(body)
    under = evaluate(below, {NU: nu})
    turned = eye(3) - NU * body.tensor
    if proved_sign(under) != 0:
        yield "fold", tuple(evaluate(x, {NU: nu}) / under for x in above)
    elif not any(proved_sign(evaluate(x, {NU: nu})) for x in turned):
        if not any(body.gyrostatic_momentum):
            yield "sphere at this value alone", (S.Zero, S.Zero, radius)
    else:
        for _, M, circle in along_kernel(turned, above, below, radius, NU, nu):
            if kind := _kind_at_pole(body, radius, nu, M, circle):
                yield kind, M


def _fraction(body: Gyrostat) -> tuple[Matrix, Expr]:
    """adj(1 − ν I) l and det(1 − ν I): M is the quotient."""
    turned = eye(3) - NU * body.tensor
    return (turned.adjugate() * Matrix(body.gyrostatic_momentum)).expand(), turned.det(
        method="berkowitz").expand()


def _kind_at_pole(body: Gyrostat, radius: Expr, nu: Expr, M: tuple[Expr, ...],
                  circle: tuple[Expr, ...] | None) -> str:
    """What happens at a rotation with ν = 1/I, "" where it is simple."""
    D, momentum = body.inverse - nu * eye(3), Matrix(M)
    if circle is not None:
        return "circle at this value alone"
    if any(proved_sign(evaluate(x, {})) for x in D.adjugate() * momentum):
        return ""
    if not any(proved_sign(evaluate(x, {})) for x in D.adjugate()):
        return "circle leaves an axis"
    across = D.trace() * radius**2 - momentum.dot(D * momentum)
    return "pitchfork" if proved_sign(evaluate(across, {})) else "umbilic"
