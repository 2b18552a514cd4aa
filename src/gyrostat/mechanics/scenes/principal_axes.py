"""Principal axes of a body whose inertia tensor is given in any axes, from adjugates of the tensor."""
from collections.abc import Iterator

from sympy import CRootOf, Expr, ImmutableMatrix, Matrix, eye, radsimp, rem, sqrt

from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.solving.roots import real_roots
from ...arguments import checked
from ...errors import ValuesError
from ...notation import symbol
from .body import Gyrostat
from .lie_poisson import hat

MOMENT = symbol("moment")
UNITS = tuple(eye(3)[:, n] for n in range(3))


@checked
def principal_axes(body: Gyrostat) -> tuple[Gyrostat, ImmutableMatrix]:
    """Return the body in principal axes x' = R x, and the rotation R, exactly.

    The moments increase; if two of them are equal, their axes are the first and the second. A body that is
    given in principal axes stays as it is.

    Parameters
    ----------
    body : Gyrostat
        its tensor in numbers; its rotor in numbers or expressions

    Returns
    -------
    (Gyrostat, ImmutableMatrix)
        moments that are rational, surds or roots of the characteristic polynomial; R of shape (3, 3),
        det R = 1, its rows the principal axes

    Raises
    ------
    ValuesError
        the tensor has names in it
    ScopeError
        its entries are transcendental, and its moments no surds

    References
    ----------
    Goldstein, Classical Mechanics, §5.4.

    Examples
    --------
    >>> import gyrostat as gs
    >>> given = gs.Gyrostat([[3, 1, 0], [1, 3, 0], [0, 0, 5]], (1, 1, 0))
    >>> body, R = gs.mechanics.principal_axes(given)
    >>> body.moments, body.gyrostatic_momentum
    ((2, 4, 5), (0, sqrt(2), 0))
    >>> R
    Matrix([
    [sqrt(2)/2, -sqrt(2)/2, 0],
    [sqrt(2)/2,  sqrt(2)/2, 0],
    [        0,          0, 1]])
    """
    if not isinstance(body.inertia, ImmutableMatrix):
        return body, ImmutableMatrix(eye(3))
    if names := sorted({s.name for e in body.inertia for s in e.free_symbols}):
        raise ValuesError(f"the inertia tensor contains the names {', '.join(names)}: principal axes are "
                          "those of numbers, give a number for each")
    about = body.tensor - MOMENT * eye(3)
    level = about.det(method="berkowitz").expand()
    found = [(moment, axis) for moment in real_roots(level, MOMENT) or ()
             for axis in _axes(about, level, moment)]
    if found[1][0] == found[2][0]:                         # the equal ones first
        found = [*found[1:], found[0]]
    moments, rows = zip(*found)
    R = Matrix(rows)
    if proved_sign(R.det(method="berkowitz")) == -1:
        R[0, :] = -R[0, :]
    turn = ImmutableMatrix(R)
    return body._turned(turn, moments, [_short(x) for x in turn * Matrix(body.gyrostatic_momentum)]), turn


def _axes(about: ImmutableMatrix, level: Expr, moment: Expr) -> Iterator[list[Expr]]:
    """Yield unit vectors along the axes of a moment, which is a root of the level once or twice."""
    def at(x: Expr) -> Expr:
        return evaluate(rem(x, level, MOMENT), {MOMENT: moment})

    if proved_sign(at(level.diff(MOMENT))):
        adjugate = about.adjugate()                        # λ c cᵀ
        n = next(n for n in range(3) if proved_sign(at(adjugate[n, n])))
        yield _unit(adjugate[:, n].applyfunc(at), at(adjugate[n, n] * adjugate.trace()))
        return
    here = about.applyfunc(at)                             # λ c cᵀ, the axes at right angles to c
    n = next(n for n in range(3) if proved_sign(here[n, n]))
    first = next(v for v in (hat(here[:, n]) * e for e in UNITS) if any(map(proved_sign, v)))
    for axis in (first, hat(here[:, n]) * first):
        yield _unit(axis, axis.dot(axis))


def _unit(axis: Matrix, square: Expr) -> list[Expr]:
    """Return the unit vector along an axis of that squared length; its last nonzero entry is positive."""
    side = next(s for x in reversed(axis) if (s := proved_sign(x)))
    return [_short(side * x / sqrt(square)) for x in axis]


def _short(number: Expr) -> Expr:
    """Return a number without roots in its denominator; roots of cubics stay as they are."""
    return number if number.has(CRootOf) or number.free_symbols else radsimp(number)
