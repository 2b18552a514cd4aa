"""Attitudes in the gravity gradient beside one vector along one axis of the orbit, in closed form."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sympy import Expr, ImmutableMatrix, Rational, S, eye, sqrt

from ..._lazy import loaded
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.text.numbers import shown
from ...errors import ScopeError
from ...mechanics.families.circular_orbit import by_gradient_alone, orbital_rate
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.system import System
from ...stability.decision import Decision
from ...stability.theorems.two_directions import ON_CURVE
from .orbital_form import OrbitalForm

NAMES, WEIGHTS = "tnr", (0, -1, 3)                     # V = ½ ω0² Σ weight a·Ia + v·e
OTHERS = ((1, 2), (0, 2), (0, 1))                      # the two axes across each
SIDES = S.One, S.NegativeOne
DIGITS = 12
Vector = tuple[Expr, Expr, Expr]
Kept = Sequence[Expr]


class Torque(NamedTuple):
    """A vector v along an axis e of the orbit, 0, 1, 2 for t, n, r: V = ½ ω0² (3 r·Ir − n·In + 2 v·e)."""

    axis: int
    vector: Kept


def one_torque(scene: System) -> Torque | None:
    """Return what acts beside the gravity gradient if it is one vector along one axis of the orbit.

    That of a rotor and a dipole along the normal is v = −l/ω0 − μ/ω0². None if something else acts.
    """
    if by_gradient_alone(scene):
        return Torque(1, [evaluate(-x / orbital_rate(scene), {}) for x in scene.body.gyrostatic_momentum])
    I, square = scene.body.tensor, orbital_rate(scene) ** 2
    linear = [[S.Zero] * 3 for _ in NAMES]
    pairs = {(a, b): [[S.Zero] * 3 for _ in range(3)] for a, b in ((0, 0), (0, 1), (1, 1))}
    for exponents, c in loaded("equilibria.finders.amended_orbit:amended_terms")(scene).items():
        places = [i for i, e in enumerate(exponents) for _ in range(e)]
        if len(places) > 2:
            return None
        (a, i), *rest = (divmod(place, 3) for place in places)
        if not rest:
            linear[1 + a][i] += c / square
            continue
        (b, j), = rest
        pairs[a, b][i][j] += c / square / (1 if a != b else 2)
        if a == b:
            pairs[a, b][j][i] += c / square / 2
    mixed = pairs.pop((0, 1))
    for (a, _), matrix in pairs.items():
        rest = ImmutableMatrix(matrix) - Rational(WEIGHTS[1 + a], 2) * I
        if not _is_scalar(rest):
            return None
    for i in range(3):                                     # t = n × r
        j, k = (i + 1) % 3, (i + 2) % 3
        linear[0][i] = (mixed[j][k] - mixed[k][j]) / 2
    if not _is_scalar(ImmutableMatrix(mixed) + ImmutableMatrix(mixed).T):
        return None
    vectors = [[evaluate(x, {}) for x in vector] for vector in linear]
    acting = [n for n, vector in enumerate(vectors) if any(map(proved_sign, vector))]
    return None if len(acting) > 1 else Torque((acting or [1])[0], vectors[(acting or [1])[0]])


def _is_scalar(matrix: ImmutableMatrix) -> bool:
    """Whether a matrix is a multiple of 1."""
    rest = matrix - matrix[0, 0] * eye(3)
    return all(proved_sign(evaluate(x, {})) == 0 for x in rest)


@dataclass(frozen=True)
class InPrincipalAxes:
    """A satellite under one torque along a principal axis, or one of symmetry: all attitudes are known.

    Let v be along the axis j, and f and g the other axes of the orbit, p and q their weights less that of e.
    With I' = I − I_j attitudes are where f·I'g = 0, p f·I'e = v f_j, q g·I'e = v g_j. Either e is along the
    axis j, or f or g is along another axis i or k, or v² = pq (I_i − I_j)(I_k − I_j): then a closed curve
    joins those that are tilted, p f·I'f = q g·I'g = −v·e. Derived in
    docs/explanation/derivations/satellite.md, section 9.

    Parameters
    ----------
    scene : System
    torque : Torque
    moments : sequence of Expr
        principal moments, in the order of the rows
    rows : ImmutableMatrix or None
        principal axes in body axes; None if these are principal
    """

    scene: System
    torque: Torque
    moments: Kept
    rows: ImmutableMatrix | None

    @property
    def along(self) -> list[Expr]:
        """The components of the vector along principal axes."""
        v = self.torque.vector
        if self.rows is None:
            return list(v)
        return [evaluate(x, {}) for x in self.rows * ImmutableMatrix(v)]

    @property
    def axis_of_symmetry(self) -> int | None:
        """The axis whose moment the other two do not share; None if all are different."""
        same = [i for i in range(3) if proved_sign(self.moments[i - 1] - self.moments[i - 2]) == 0]
        return None if not same else next((i for i in (2, 0, 1) if self.along[i] != 0), 2) if len(
            same) == 3 else same[0]

    def _weights(self) -> tuple[Expr, Expr]:
        """Return p and q."""
        e = self.torque.axis
        p, q = (S(WEIGHTS[n] - WEIGHTS[e]) for n in OTHERS[e])
        return p, q

    def _form(self, e: Mapping[int, Expr], g: Mapping[int, Expr], locus: str = "",
              as_set: Decision | None = None) -> OrbitalForm:
        """Return the attitude with the axes e and g of the orbit at given components."""
        first, second = (tuple(v.get(i, S.Zero) for i in range(3)) for v in (e, g))
        n, r = ((tuple(cross(second, first)), second), (first, second), (second, first))[self.torque.axis]
        return OrbitalForm(self.scene, self._in_body(n), self._in_body(r), locus, as_set)

    def _in_body(self, vector: Kept) -> Vector:
        first, second, third = vector
        if self.rows is not None:
            first, second, third = (evaluate(x, {}) for x in self.rows.T * ImmutableMatrix(vector))
        return first, second, third

    def points(self, axis: int) -> Iterator[OrbitalForm]:
        """Yield the attitudes if the vector is along an axis that is none of symmetry; complete."""
        v, (p, q) = self.along[axis], self._weights()
        others = [i for i in range(3) if i != axis]
        beyond = {i: self.moments[i] - self.moments[axis] for i in others}
        a, b = beyond.values()
        curve = bool(proved_sign(v)) and proved_sign(v**2 - p * q * a * b) == 0
        locus = self._curve(axis) if curve else ""
        apart = proved_sign(p * a - q * b) and proved_sign(p * b - q * a)
        as_set = ON_CURVE if curve and p * q > 0 and proved_sign(p * a) == 1 and apart else None
        for i, k in (others, others[::-1]):
            for up in SIDES:
                for side in SIDES:
                    on_it = all(proved_sign(v * side + x) == 0 for x in (p * beyond[i], q * beyond[k]))
                    yield self._form({axis: side}, {k: up}, locus if on_it else "")
                for high, across in _tilts(-v, p * beyond[i]):
                    yield self._form({axis: high, i: across}, {k: up}, locus, as_set)
                for high, across in _tilts(-v, q * beyond[k]):
                    last = {axis: -up * across, k: up * high}
                    yield self._form({axis: high, k: across}, last, locus, as_set)

    def _curve(self, axis: int) -> str:
        """Return the equations of the closed curve."""
        e, (p, q) = self.torque.axis, self._weights()
        name, (f, g) = NAMES[e], (NAMES[n] for n in OTHERS[e])
        own = f"I{axis + 1}" if self.rows is None else shown(self.moments[axis], DIGITS)
        first, second = (f"ω0² ({x}·I{x} − {own})" for x in (f, g))
        if by_gradient_alone(self.scene):
            left, first, second = f"l·{name}", first.replace("²", ""), second.replace("²", "")
        else:
            square = orbital_rate(self.scene) ** 2
            v = ", ".join(shown(evaluate(-x * square, {}), DIGITS) for x in self.torque.vector)
            left = f"({v})·{name}"
        first, second = (x if n == 1 else f"{n} {x}".replace("-1 ", "−").replace("-", "−")
                         for n, x in ((p, first), (q, second)))
        return f"a closed curve of equilibria, {f}·I{g} = 0 and {left} = {first} = {second}"

    def circles(self, axis: int) -> Iterator[OrbitalForm]:
        """Yield a point of each circle of a body of revolution with the vector along its axis; complete."""
        v, (p, q) = self.along[axis], self._weights()
        i, k = (n for n in range(3) if n != axis)
        beyond = self.moments[i] - self.moments[axis]
        direction = self._in_body(tuple(S(int(n == axis)) for n in range(3)))
        on_circle = loaded("equilibria.finders.circles_of_attitudes:on_circle")
        for side in SIDES:
            yield on_circle(self._form({axis: side}, {i: S.One}), direction)
            for high, across in _tilts(-v, p * beyond)[:1]:
                yield on_circle(self._form({axis: high, i: across}, {k: side}), direction)
            for high, across in _tilts(-v, q * beyond)[:1]:
                last = {axis: side * across, i: -side * high}
                yield on_circle(self._form({axis: high, i: across}, last), direction)


def _tilts(v: Expr, beyond: Expr) -> list[tuple[Expr, Expr]]:
    """Return the component v/beyond of a unit vector and that across, of either sign; [] if there is none."""
    if proved_sign(beyond**2 - v**2) != 1:
        return []
    high = evaluate(v / beyond, {})
    across = evaluate(sqrt(1 - high**2), {})
    return [(high, across), (high, -across)]


def in_principal_axes(scene: System, torque: Torque) -> InPrincipalAxes | None:
    """Return the satellite in axes in which its tensor is diagonal, if the vector is along one of them.

    If the tensor is diagonal in its own axes, the vector may be any. None if a cubic decides.
    """
    body, v = scene.body, ImmutableMatrix(torque.vector)
    acts, turned = any(torque.vector), body.tensor * v
    if _is_scalar(body.tensor):
        if not acts:
            raise ScopeError(f"the three moments are {body.tensor[0, 0]}, and nothing turns the satellite: "
                             "it rests in every attitude; give one, steady_motion(scene, n, r)")
        place = next((n for n in range(3) if sum(map(bool, torque.vector)) == 1 and torque.vector[n]), None)
        turned_up = loaded("mechanics.equilibrium.recognition:turned_up")
        rows = None if place is not None else turned_up(tuple(v / sqrt(v.dot(v))))
        return InPrincipalAxes(scene, torque, [body.tensor[0, 0]] * 3, rows)
    if not isinstance(body.inertia, ImmutableMatrix):
        return InPrincipalAxes(scene, torque, body.moments, None)
    if any(proved_sign(evaluate(x, {})) for x in v.cross(turned)):
        return None
    if not acts and not list(loaded("mechanics.equilibrium.recognition:axes_of_tensor")(body.inertia)):
        return None                                        # three different moments, roots of a cubic
    turned_body = loaded("mechanics.scenes.principal_axes:principal_axes")
    principal, rows = turned_body(Gyrostat(body.inertia, (0, 0, 0)))
    return InPrincipalAxes(scene, torque, principal.moments, rows)
