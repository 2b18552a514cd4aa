"""Recognises a body of revolution about any axis, and makes the same scene with that axis the third."""
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from math import lcm

from sympy import Expr, ImmutableMatrix, Rational, S, count_ops, eye, sqrt

from ..._cached import cached_property
from ...errors import PotentialError
from ..scenes.body import Gyrostat
from ..scenes.entered_potential import axial_potential
from ..scenes.functions_on_sphere import along_third, lowest, vanishes
from ..scenes.kind import Kind
from ..scenes.lie_poisson import hat
from ..scenes.potential import DIRECTIONS, Potential
from ..scenes.system import System, system_of

Vector = tuple[Expr, ...]
UNITS: tuple[Vector, ...] = ((S.One, S.Zero, S.Zero), (S.Zero, S.One, S.Zero), (S.Zero, S.Zero, S.One))
# rational unit vectors in no special position
PLACES = [tuple(Rational(n, d) for n in row) for *row, d in ((1, 2, 2, 3), (2, 3, 6, 7), (-4, 4, 7, 9),
                                                             (6, 2, -9, 11), (3, -4, 12, 13))]


@dataclass(frozen=True)
class Recognition:
    """A scene that is a body of revolution about an axis c.

    Two equal moments, l along c, and on abs(k)² = 1 a field U(c·k).

    Parameters
    ----------
    scene : System
    direction : tuple of Expr
        along the axis; in integers if that is possible
    standard : System
        the same body in U(k3), its axis the third
    """

    scene: System
    direction: Vector
    standard: System

    @cached_property
    def axis(self) -> Vector:
        """The unit vector c along the axis."""
        return unit(self.direction)

    @cached_property
    def rotation(self) -> ImmutableMatrix:
        """The proper rotation R with R c = e3: x' = R x are the components in the standard scene."""
        return turned_up(self.axis)

    @property
    def modulo(self) -> Expr:
        """The momentum along the axis, whose flow turns the body about it."""
        return lowest(sum((x * p for x, p in zip(self.direction, self.scene.space.coordinates)), S.Zero))

    @property
    def name(self) -> str:
        """The name of the k3 of the standard scene in the axes of the user's."""
        return f"k{UNITS.index(self.direction) + 1}" if self.direction in UNITS else "k·c"

    @property
    def sentence(self) -> str:
        """The sentence that says what was recognised."""
        if self.direction in UNITS:
            return f"recognised as a body of revolution about axis {UNITS.index(self.direction) + 1}"
        along = ", ".join(map(str, self.direction))
        return f"recognised as a body of revolution about the axis c along ({along})"

    def worded(self, reason: str) -> str:
        """Return a reason of the standard scene in the words of the user's axes."""
        return re.sub(r"\bk3\b", self.name, reason)

    def along(self, vector: Sequence[Expr]) -> Expr:
        """Return the component of a vector along the axis."""
        return lowest(sum((x * y for x, y in zip(self.axis, vector)), S.Zero))


@lru_cache(maxsize=64)
def recognise(scene: System, square_radius: Expr = S.One) -> Recognition | None:
    """Recognise a body of revolution in a field along its axis, on abs(k)² = square_radius.

    None is returned if that is not proved.

    Examples
    --------
    >>> import gyrostat as gs
    >>> field = gs.general_potential(lambda k1, k2, k3: k1 - k2**2 - k3**2)
    >>> found = recognise(gs.assemble(gs.Gyrostat((3, 1, 1), (0, 0, 0)), field))
    >>> found.sentence
    'recognised as a body of revolution about axis 1'
    >>> found.standard.potential.expression, found.standard.body.moments
    (k3**2 + k3 - 1, (1, 1, 3))
    """
    if scene.kind is Kind.REVOLUTION:
        return Recognition(scene, UNITS[2], scene)
    if scene.potential is None or scene.kind is not Kind.FIELD or not scene.potential.given:
        return None
    for direction in _directions(scene.body, scene.potential):
        axis = unit(direction)
        rotor = scene.body.gyrostatic_momentum
        if any(not vanishes(x) for x in hat(axis) * ImmutableMatrix(rotor)):
            continue
        U = along_third(scene.potential.expression, turned_up(axis), square_radius)
        if U is None:
            continue
        across, along = _moments_about(scene.body, direction)
        body = Gyrostat((across, across, along),
                        (0, 0, lowest(sum((x * l for x, l in zip(axis, rotor)), S.Zero))))
        try:
            return Recognition(scene, direction, system_of(body, axial_potential(U)))
        except PotentialError:                             # a U such as |k3|, which is not smooth
            continue
    return None


def _directions(body: Gyrostat, potential: Potential) -> Iterator[Vector]:
    """Yield vectors along the axes about which the body may be one of revolution.

    Such an axis is a principal one. If all three moments are equal, it is that of l, or else of the field.
    """
    if isinstance(body.inertia, ImmutableMatrix):
        yield from axes_of_tensor(body.inertia)
        return
    equal = [vanishes(body.moments[place - 2] - body.moments[place - 1]) for place in range(3)]
    yield from (UNITS[place] for place in (2, 0, 1) if equal[place])
    if all(equal):
        free = all(map(vanishes, body.gyrostatic_momentum))
        yield from _of_field(potential) if free else direction_along(body.gyrostatic_momentum)


def axis_of_satellite(body: Gyrostat) -> tuple[Vector, ImmutableMatrix, Expr, Expr] | None:
    """Return the axis c of a body of revolution, along which l is, R with R c = e3, and its two moments.

    For a sphere c is along l. None if it is none, or names decide.
    """
    if isinstance(body.inertia, ImmutableMatrix):
        found = list(axes_of_tensor(body.inertia))
    else:
        equal = [vanishes(body.moments[place - 2] - body.moments[place - 1]) for place in range(3)]
        found = [UNITS[place] for place in (2, 0, 1) if equal[place]]
        found = [*direction_along(body.gyrostatic_momentum), *found] if all(equal) else found
    l = ImmutableMatrix(body.gyrostatic_momentum)
    along = next((c for c in found if all(map(vanishes, hat(c) * l))), None)
    return None if along is None else (unit(along), turned_up(unit(along)), *_moments_about(body, along))


def axes_of_tensor(tensor: ImmutableMatrix) -> Iterator[Vector]:
    """Yield a vector along c if I = A + (C − A) c cᵀ."""
    yz, zx, xy = tensor[1, 2], tensor[2, 0], tensor[0, 1]
    products = [vanishes(e) for e in (yz, zx, xy)]
    if not any(products):
        across = [tensor[0, 0] - zx * xy / yz, tensor[1, 1] - xy * yz / zx, tensor[2, 2] - yz * zx / xy]
        if vanishes(across[0] - across[1]) and vanishes(across[1] - across[2]):
            yield from direction_along((zx * xy, xy * yz, yz * zx))
    elif products.count(True) == 2:
        n = products.index(False)                          # axis n is principal, and one of those across
        i, j = (n + 1) % 3, (n + 2) % 3
        a, b, c = tensor[i, i] - tensor[n, n], tensor[j, j] - tensor[n, n], tensor[i, j]
        if vanishes(a * b - c**2):
            axis = [S.Zero] * 3
            axis[i], axis[j] = a, c
            yield from direction_along(axis)


def _moments_about(body: Gyrostat, direction: Vector) -> tuple[Expr, Expr]:
    """Return the moments across an axis of revolution and about it, in one spelling each."""
    if isinstance(body.inertia, ImmutableMatrix):
        c = ImmutableMatrix(unit(direction))
        along = lowest(c.dot(body.tensor * c))
        return lowest((body.tensor.trace() - along) / 2), along
    place = UNITS.index(direction) if direction in UNITS else 2
    return min(body.moments[place - 2], body.moments[place - 1], key=count_ops), body.moments[place]


def _of_field(potential: Potential) -> Iterator[Vector]:
    """Yield a vector along the only axis c for which U can be a function of c·k, if there is one.

    If U is a function of c·k, the torque k × ∇U is at right angles to c. Here that is asked at a few
    directions k, with some numbers in the place of the parameters.
    """
    numbers = {s: Rational(7 + 3 * n, 5) for n, s in enumerate(potential.parameters)}
    U = potential.expression.xreplace(numbers)
    slope = ImmutableMatrix([U.diff(k) for k in DIRECTIONS])
    torques = [hat(k) * slope.xreplace(dict(zip(DIRECTIONS, k))) for k in PLACES]
    torques = [torque for torque in torques if all(x.is_finite for x in torque)]
    for first, second in combinations(torques, 2):
        for direction in direction_along(hat(first) * second):
            if all(vanishes(ImmutableMatrix(direction).dot(torque)) for torque in torques):
                yield direction
            return


def direction_along(vector: Sequence[Expr]) -> Iterator[Vector]:
    """Yield a vector along another, its first entry positive, of integers if that is possible.

    Nothing is yielded along 0, or if names decide.
    """
    entries = [lowest(x) for x in vector]
    first = next((x for x in entries if not vanishes(x)), None)
    if first is None:
        return
    ratios = [lowest(x / first) for x in entries]
    if any(x.free_symbols or not x.is_finite for x in ratios):
        return
    scale = lcm(*(int(x.q) for x in ratios)) if all(isinstance(x, Rational) for x in ratios) else 1
    yield tuple(scale * x for x in ratios)


def unit(direction: Vector) -> Vector:
    """Return the unit vector along another."""
    length = sqrt(sum(x**2 for x in direction))
    return tuple(lowest(x / length) for x in direction)


def turned_up(axis: Vector) -> ImmutableMatrix:
    """Return the proper rotation R with R axis = e3.

    If the axis is a coordinate axis, R keeps the axes in their cyclic order; else it turns by the smallest
    angle.
    """
    if axis in UNITS:
        place = UNITS.index(axis)
        return ImmutableMatrix([UNITS[place - 2], UNITS[place - 1], UNITS[place]])
    turn = hat((axis[1], -axis[0], S.Zero))
    return (ImmutableMatrix(eye(3)) + turn + turn * turn / (1 + axis[2])).applyfunc(lowest)
