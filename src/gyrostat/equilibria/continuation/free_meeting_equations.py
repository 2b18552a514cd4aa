"""Equations in rotor and abs(M) for the places at which permanent rotations of a free gyrostat meet."""
from collections.abc import Iterator
from itertools import combinations

from sympy import Add, Expr, ImmutableMatrix, Matrix, Mul, S, eye

from ...mechanics.scenes.body import Gyrostat
from ...notation import symbol
from ..finders.free import NU
from ..finders.rate_level_tilt import LENGTH

MOMENTUM = tuple(symbol(f"M{n}") for n in (1, 2, 3))
Locus = tuple[str, tuple[Expr, ...], Expr]


def loci_of_rotations(body: Gyrostat) -> Iterator[Locus]:
    """Yield (kind, what vanishes there, ν) for every kind.

    With l on a principal axis or in a principal plane it is in I, l and M = abs(M) alone. In the plane of the
    axes i and j a fold is on the evolute of an ellipse, an astroid in I_j l_i and I_i l_j, and a pitchfork
    with ν = 1/I_k on an ellipse, l_i²/(1 − I_i/I_k)² + l_j²/(1 − I_j/I_k)² = M². A fold elsewhere is given by
    its M and ν.

    References
    ----------
    Cayley, On the centro-surface of an ellipsoid, Collected Papers VIII, no. 520; derived.
    """
    carried, empty = _by_moment(body)
    if len(carried) > 2:
        yield "fold", _parametrised(body), NU
    for (i, li), (j, lj) in combinations(carried.items(), 2) if len(carried) == 2 else ():
        first, second, third = j**2 * li, i**2 * lj, (i - j) ** 2 * LENGTH**2
        yield "fold", ((first + second - third) ** 3 + 27 * first * second * third,), NU
    for k, axes in empty.items() if len(carried) < 3 and carried else ():
        whole = Mul(*((k - i) ** 2 for i in carried))
        off = Add(*(k**2 * square * whole / (k - i) ** 2 for i, square in carried.items()))
        yield "pitchfork" if axes == 1 else "circle leaves an axis", (off - LENGTH**2 * whole,), 1 / k


def _by_moment(body: Gyrostat) -> tuple[dict[Expr, Expr], dict[Expr, int]]:
    """Return the sum of l² for each moment whose axes carry l, and how many axes each other moment has.

    Any full tensor counts as general.
    """
    if isinstance(body.inertia, ImmutableMatrix):
        return dict.fromkeys(MOMENTUM, S.One), {}
    squares: dict[Expr, Expr] = {}
    for moment, rotor in zip(body.moments, body.gyrostatic_momentum):
        squares[moment] = squares.get(moment, S.Zero) + rotor**2
    return ({moment: square for moment, square in squares.items() if square},
            {moment: body.moments.count(moment) for moment, square in squares.items() if not square})


def _parametrised(body: Gyrostat) -> tuple[Expr, ...]:
    """Return M·adj(1 − ν I) I M, which is det(I) Δ; l − (1 − ν I) M; and the length of M."""
    M, turned = Matrix(MOMENTUM), eye(3) - NU * body.tensor
    left = Matrix(body.gyrostatic_momentum) - turned * M
    return (M.dot(turned.adjugate() * body.tensor * M), *left, M.dot(M) - LENGTH**2)
