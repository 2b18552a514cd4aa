"""Circles of attitudes, where the amended potential does not change as the body turns, or the frame."""
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from flint import arb
from sympy import Add, Expr, ImmutableMatrix, Matrix, Rational, S, eye, sqrt

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.rotations.quartic_forms import QuarticForm
from ...algebra.rotations.symmetries import OnSphere, Turning, on_sphere
from ...algebra.solving.real_fields import FieldNumbers, RealNumbers
from ...algebra.solving.sphere_zeros import zeros_on_sphere
from ...algebra.text.numbers import shown
from ...errors import ScopeError
from ...mechanics.equilibrium.recognition import UNITS, direction_along, turned_up
from ...notation import symbol
from ...stability.decision import Rung, settled
from .orbital_form import OrbitalForm

K = tuple(symbol(f"k{n}") for n in (1, 2, 3))
AXES, DIGITS = "tnr", 12
# the precessions by the components of the axis along t, n, r that vanish
PRECESSIONS = ((0, 2), "cylindrical"), ((2,), "hyperbolic"), ((0,), "conical")
ON_SET = settled(True, "the energy is least on a circle or torus of equilibria, and K is positive across it",
                 Rung.LEAST_ON_SET, locus="the set of equilibria to which it belongs")
ENTRIES = [(i, j) for i in range(3) for j in range(i, 3)]
PLACES = {pair: n for n, pair in enumerate(ENTRIES, 3)}


class Placed(NamedTuple):
    """The normal and the vertical of an attitude, and the set on which it lies, in words."""

    normal: Sequence[Expr]
    vertical: Sequence[Expr]
    locus: str
    size: int


def on_circle(form: OrbitalForm, along: Sequence[Expr]) -> OrbitalForm:
    """Return an attitude as one of a circle about an axis of the body, with the equations of the circle."""
    direction = next(direction_along(along))
    length = sqrt(Add(*(x**2 for x in direction)))
    t = cross(form.n, form.r)
    z = [evaluate(Add(*(x * y for x, y in zip(a, direction))) / length, {}) for a in (t, form.n, form.r)]
    return settled_as_set(replace(form, locus=about_axis(direction, z)), 1)


def about_axis(direction: Sequence[Expr], z: Sequence[Expr]) -> str:
    """Return the name of a circle about an axis of the body, and its equations."""
    zeros = [n for n, x in enumerate(z) if proved_sign(x) == 0]
    name = next((name for places, name in PRECESSIONS if {*places} <= {*zeros}), "")
    kind = f", {name} precession" if name else ""
    if tuple(direction) in UNITS:
        place = UNITS.index(tuple(direction)) + 1
        axis, names = f"axis {place}", [f"{a}{place}" for a in AXES]
    else:
        axis, names = f"the axis c along ({', '.join(map(str, direction))})", [f"c·{a}" for a in AXES]
    return f"a circle of equilibria about {axis}{kind}, {_equations(names[1:], z[1:])}"


def _equations(names: Sequence[str], values: Sequence[Expr]) -> str:
    return " and ".join(f"{name} {'=' if isinstance(x, Rational) else '≈'} {shown(x, DIGITS)}"
                        for name, x in zip(names, values))


def settled_as_set(form: OrbitalForm, size: int) -> OrbitalForm:
    """Return an attitude on a set that a turn carries through, with whether the energy is least on it.

    It is if K is positive across the set; along it K is the same but for the turn.
    """
    least = all(sign == 1 for sign in form.signs[:3 - size])
    return replace(form, as_set=ON_SET) if least else form


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


def circles_of(form: QuarticForm, turnings: Sequence[Turning]) -> list[Placed] | None:
    """Return an attitude of each circle, or torus, of critical points that a symmetry leaves.

    None if more than one irrational factor stands in the potential.

    Raises
    ------
    ScopeError
        body and frame turn together; or the potential is constant
    """
    if len(turnings) == 6:
        raise ScopeError("the potential is the same in every attitude, and nothing turns the satellite: it "
                         "rests in each; give one, steady_motion(scene, n, r)")
    single = [t for t in turnings if not (any(t.body) and any(t.frame))]
    if not single:
        c, e = (", ".join(map(str, v)) for v in turnings[0])
        raise ScopeError("the attitudes lie on curves: the potential stays the same if the body turns about "
                         f"({c}) and the frame t, n, r about ({e}) together; give an attitude, "
                         "steady_motion(scene, n, r)")
    turning = single[0]
    if (f := on_sphere(form, turning)) is None or not isinstance(f.scale**2, Rational):
        return None
    return [*_placed(f, turning, turnings)]


def _placed(f: OnSphere, turning: Turning, turnings: Sequence[Turning]) -> Iterator[Placed]:
    """Yield an attitude for each critical point of a function on the sphere, or circle of them.

    With u = R e3 the rotation R is (e3 + u)(e3 + u)ᵀ/(1 + u3) − 1, symmetric; if u = −e3 it turns about e1.
    """
    of_body = any(turning.body)
    direction = tuple(map(S, turning.body if of_body else turning.frame))
    turn = turned_up(tuple(x / sqrt(Add(*(y**2 for y in direction))) for x in direction))
    vector, below = ImmutableMatrix(K) + ImmutableMatrix([0, 0, 1]), K[2] + 1
    tops = [vector[i] * vector[j] - int(i == j) * below for i, j in ENTRIES]
    equations, wrong = _critical(f)
    zeros = zeros_on_sphere(equations, K, below, tops)
    assert zeros is not None                               # it is not constant
    for u in zeros.points:
        if not wrong(u[:3]):
            rows = _rows(turn, of_body)
            numbers = FieldNumbers(Combined(u, rows), 0, [(n, S.One) for n in range(6)])
            yield Placed(numbers[:3], numbers[3:], _circle(direction, of_body, u[:3]), 1)
    for curve in zeros.curves:
        for sample in curve.samples:
            if not wrong(sample):
                height = Add(*(x * y for x, y in zip(sample, turnings[1].frame)))
                yield _at(sample, turn, of_body, _torus(turnings, height), 2)
    south = (S.Zero, S.Zero, S.NegativeOne)
    if not any(proved_sign(x.xreplace(dict(zip(K, south)))) for x in equations) and not wrong(south):
        yield _at(south, turn, of_body, _circle(direction, of_body, south), 1)


def _critical(f: OnSphere) -> tuple[list[Expr], Callable[[Sequence[Expr]], bool]]:
    """Return equations of critical points, and what tells those that are none.

    u × (2Qu + s b) = 0. With an irrational s, u, Qu and b are in a plane and abs(2 u × Qu) = s abs(u × b); of
    u and −u one is a solution.
    """
    u = ImmutableMatrix(K)
    bent, given = 2 * u.cross(f.quadratic * u), u.cross(f.linear)
    if isinstance(f.scale, Rational) or not any(f.linear):
        return [*(bent + f.scale * given)], lambda _: False
    plane = u.dot((f.quadratic * u).cross(f.linear))
    level = bent.dot(bent) - f.scale**2 * given.dot(given)
    side = f.scale * bent.dot(given)
    return [plane, level], lambda at: proved_sign(evaluate(side, dict(zip(K, at)))) == 1


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


def _at(u: Sequence[Expr], turn: ImmutableMatrix, of_body: bool, locus: str, size: int) -> Placed:
    """Return the attitude of a vector that is given in expressions."""
    vector = Matrix(u) + Matrix([0, 0, 1])
    R = (vector * vector.T / vector[2] - eye(3) if proved_sign(vector[2]) else Matrix.diag(1, -1, -1))
    R = R * turn if of_body else turn.T * R
    n, r = ([evaluate(x, {}) for x in R.row(a)] for a in (1, 2))
    return Placed(n, r, locus, size)


def _circle(direction: Sequence[Expr], of_body: bool, u: Sequence[Expr]) -> str:
    if of_body:
        return about_axis(direction, u)
    name = AXES[UNITS.index(tuple(direction))] if tuple(direction) in UNITS else "e"
    e = "" if name != "e" else f", e = ({', '.join(map(str, direction))}) in t, n, r"
    return f"a circle of equilibria about {name}{e}, {_equations([f'{name}{i}' for i in (1, 2, 3)], u)}"


def _torus(turnings: Sequence[Turning], height: Expr) -> str:
    c, e = (", ".join(map(str, v)) for v in (turnings[0].body, turnings[1].frame))
    length = sqrt(Add(*(x**2 for x in turnings[1].frame)))
    return (f"a torus of equilibria, turned about ({c}) in the body and ({e}) in t, n, r: the cosine of "
            f"their angle is {shown(evaluate(height / length, {}), DIGITS)}")
