"""Rotations at which a function of a unit vector is critical, one for each point or circle of the sphere."""
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from flint import arb
from sympy import Add, Expr, ImmutableMatrix, Matrix, Rational, S, eye, symbols

from ..enclosures.balls import ball
from ..enclosures.precision import own_precision
from ..reals.exact import evaluate, proved_sign
from ..rings.matrices import cross
from ..solving.real_fields import BITS, FieldNumbers, RealNumbers, balls
from ..solving.sphere_zeros import zeros_on_sphere
from .symmetries import OnSphere

K = symbols("k1:4", real=True)
UP, DOWN = (S.Zero, S.Zero, S.One), (S.Zero, S.Zero, S.NegativeOne)
ENTRIES = [(i, j) for i in range(3) for j in range(i, 3)]
PLACES = {pair: n for n, pair in enumerate(ENTRIES, 3)}


class OnSet(NamedTuple):
    """A point of a set of critical rotations: n, r and the unit vector there, and the set's dimension."""

    normal: Sequence[Expr]
    vertical: Sequence[Expr]
    vector: Sequence[Expr]
    size: int


class Combined(RealNumbers):
    """Linear combinations of numbers in a field with other exact numbers."""

    def __init__(self, numbers: FieldNumbers, rows: Sequence[Sequence[Expr]]):
        self._numbers, self._rows = numbers, rows

    def values(self, precision: int) -> list[list[arb]]:
        """Return enclosures of the combinations."""
        given = self._numbers.balls(precision)
        with own_precision(precision):
            return [[sum((ball(c, precision) * x for c, x in zip(row, given) if c), arb(0))
                     for row in self._rows]]

    def expression(self, root: int, place: int) -> Expr:
        """Return one of them as an expression."""
        return Add(*(c * self._numbers[n] for n, c in enumerate(self._rows[place]) if c))

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether one of them is a fraction, if it is one of the numbers times a fraction."""
        (n, c), *others = [(n, c) for n, c in enumerate(self._rows[place]) if c] or [(0, S.Zero)]
        return not others and isinstance(c, Rational) and (not c or self._numbers.is_fraction(n))


def critical_on_sphere(f: OnSphere, turn: ImmutableMatrix, of_body: bool) -> Iterator[OnSet]:
    """Yield a rotation for each critical point of a function on the sphere, and for each circle of them.

    With u = R e3 the rotation R is (e3 + u)(e3 + u)ᵀ/(1 + u3) − 1, symmetric; if u = −e3 it turns about e1.

    Parameters
    ----------
    f : OnSphere
        not constant
    turn : ImmutableMatrix, shape (3, 3)
        a rotation of the axis of the symmetry to e3
    of_body : bool
        whether that is an axis of the body
    """
    vector, below = ImmutableMatrix(K) + ImmutableMatrix(UP), K[2] + 1
    tops = [vector[i] * vector[j] - int(i == j) * below for i, j in ENTRIES]
    equations = _equations(f)
    zeros = zeros_on_sphere(equations, K, below, tops)
    assert zeros is not None
    for u in zeros.points:
        if _is_critical(f, u[:3]):
            numbers = FieldNumbers(Combined(u, _rows(turn, of_body)), 0, [(n, S.One) for n in range(6)])
            yield OnSet(numbers[:3], numbers[3:], u[:3], 1)
    for sample in (x for curve in zeros.curves for x in curve.samples):
        if _is_critical(f, sample):
            yield _at(sample, turn, of_body, 2)
    if not any(proved_sign(x.xreplace(dict(zip(K, DOWN)))) for x in equations) and _is_critical(f, DOWN):
        yield _at(DOWN, turn, of_body, 1)


def _equations(f: OnSphere) -> list[Expr]:
    """Return equations of critical points, u × (2Qu + s b) = 0.

    With an irrational s, u, Qu and b are in a plane and abs(2 u × Qu) = s abs(u × b): one of u and −u is one.
    """
    u = ImmutableMatrix(K)
    bent, given = 2 * u.cross(f.quadratic * u), u.cross(f.linear)
    if isinstance(f.scale, Rational) or not any(f.linear):
        return list(bent + f.scale * given)
    return [u.dot((f.quadratic * u).cross(f.linear)), bent.dot(bent) - f.scale**2 * given.dot(given)]


def _is_critical(f: OnSphere, u: Sequence[Expr]) -> bool:
    """Whether u × Qu and s u × b are opposite; a rational s leaves no other solutions."""
    if isinstance(f.scale, Rational):
        return True
    rows, b = f.quadratic.tolist(), list(f.linear)

    def side(u: Sequence[Any], turned: Sequence[Any], given: Sequence[Any]) -> Any:
        return dot(cross(u, turned), cross(u, given))

    with own_precision(BITS):
        near = balls(u, BITS)
        Q, given = [[ball(x, BITS) for x in row] for row in rows], [ball(x, BITS) for x in b]
        value = side(near, [dot(row, near) for row in Q], given)
    if not value.contains(0):
        return bool(value * ball(f.scale, BITS) < 0)
    exact = side(tuple(u), [dot(row, tuple(u)) for row in rows], b)
    return proved_sign(evaluate(exact * f.scale, {})) != 1


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """Return the product of two vectors of numbers of any kind."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _rows(turn: ImmutableMatrix, of_body: bool) -> list[list[Expr]]:
    """Return the entries of n and r as combinations of u and the entries of R."""
    rows = []
    for a in (1, 2):
        for i in range(3):
            row = [S.Zero] * 9
            for n in range(3):
                entry, weight = ((a, n), turn[n, i]) if of_body else ((n, i), turn[n, a])
                row[PLACES[min(entry), max(entry)]] += weight
            rows.append(row)
    return rows


def _at(u: Sequence[Expr], turn: ImmutableMatrix, of_body: bool, size: int) -> OnSet:
    """Return the attitude of a vector that is given in expressions."""
    vector = Matrix(u) + Matrix(UP)
    R = (vector * vector.T / vector[2] - eye(3) if proved_sign(vector[2]) else Matrix.diag(1, -1, -1))
    R = R * turn if of_body else turn.T * R
    n, r = ([evaluate(x, {}) for x in R.row(a)] for a in (1, 2))
    return OnSet(n, r, u, size)
