"""Branches of the permanent rotations of a free gyrostat over a range of a name."""
from collections.abc import Iterator, Mapping
from typing import Any

from flint import arb
from sympy import Expr, Rational

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.solving.roots import in_order
from ...errors import ValuesError
from ...mechanics.scenes.system import System, assemble, at_numbers
from ...notation import symbol
from ...stability.decision import Verdict
from ..finders.free import rotations_on_sphere
from ..finders.free_form import FreeForm
from ..finders.rate_level_tilt import LENGTH, numbers_of_rotations
from .following import Pieces
from .free_meetings import rotation_curve, rotation_pencil, rotations_meet
from .mark import Mark
from .pencil_branches import PRECISION, PencilBranches
from .pieces import Piece
from .stations_at_rate import admissible, within


class FreeBranches(PencilBranches):
    """The Curve of a free gyrostat on a momentum sphere, cut where two values of ν meet.

    Between two such values the values of ν are simple and in a fixed order, and no Δ vanishes.
    """

    def __init__(self, scene: System, name: str, low: Expr, high: Expr, values: Mapping[str, Any]):
        numbers, free = numbers_of_rotations(scene, values, name), symbol(name)
        self.body, self.radius = at_numbers(scene, numbers).body, numbers.get(LENGTH, LENGTH)
        if free == LENGTH and proved_sign(low) != 1:
            raise ValuesError(f"M goes from {low} to {high}, and is the length of the momentum: give a range "
                              "in which it is positive")
        admissible(self.body.positive, numbers, free, low, high)
        self.curve = rotation_curve(self.body, self.radius, free)
        self.pencil = rotation_pencil(self.body, self.radius)
        self.ends = low, high

    @cached_property
    def stations(self) -> list[Expr]:
        """The double points of the curve of ν."""
        return in_order(list({t for t, _ in self.curve.double if within(t, *self.ends)}))

    def through(self, station: Expr, before: Pieces, after: Pieces) -> tuple[()]:
        """Return no pairs: every piece ends at a value at which two values of ν meet."""
        return ()

    def marks(self, station: Expr, before: Pieces | None, after: Pieces | None) -> Iterator[Mark]:
        """Yield what meets at a station."""
        here = [point for point in self.curve.double if point[0] == station]
        for kind, value, nu, M in rotations_meet(self.body, self.radius, self.curve.t, here):
            yield Mark(kind, str(self.curve.t), value, nu=nu, momentum=M)

    def forms(self, t: Rational) -> list[FreeForm]:
        """Return every rotation at a value, in the order of the energy."""
        at = Point({self.curve.t: t})
        return rotations_on_sphere(assemble(self.body.changed(lambda x: evaluate(x, at))),
                                   evaluate(self.radius, at))

    def x(self, form: FreeForm) -> arb:
        """Return the ν of a rotation."""
        return ball(form.nu, PRECISION)

    def piece(self, label: str, parameter: Array, verdict: Verdict, x: Array, y: Array) -> Piece:
        """Return a piece with M and ν."""
        return Piece(label, parameter, verdict, momentum=y, nu=x)
