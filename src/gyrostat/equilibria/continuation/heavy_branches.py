"""Branches of the permanent rotations of a body in a field at a rate, over a range of a name."""
import math
from collections.abc import Iterator, Mapping
from typing import Any

from flint import arb, fmpq_mpoly, fmpq_poly
from sympy import Add, Expr, Float, Matrix, Rational, S, eye

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import Point
from ...algebra.reals.number_fields import at_root, common_divisor, in_one
from ...algebra.rings.polynomials import by_degree
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import in_order, real_roots, roots_of_factor
from ...errors import ScopeError
from ...mechanics.scenes.system import System, names_of_scene
from ...notation import symbol
from ...stability.criteria.amended_form import dot
from ...stability.decision import Verdict
from ..finders.heavy import OMEGA, SIGMA, heavy_forms
from ..finders.heavy_form import HeavyForm, data_at
from ..finders.heavy_polynomials import degree_in_k
from .following import Pieces
from .heavy_changes import changes
from .mark import Mark
from .pencil_branches import PRECISION, Pencil, PencilBranches, meetings
from .pieces import Piece
from .stations_at_rate import admissible, numbers_beside, within


class HeavyBranches(PencilBranches):
    """The Curve of a body in U = c·k + k·Qk/2 at a rate, cut where two rotations meet.

    With ∇U = omega M + sigma k, the values of sigma between two stations are simple and in a fixed order, and
    neither the second variation nor the spectrum changes a sign.
    """

    def __init__(self, scene: System, name: str, low: Expr, high: Expr, values: Mapping[str, Any]):
        needed = {s.name for s in names_of_scene(scene)} | {"omega"}
        numbers = numbers_beside(scene, name, values, needed, "permanent rotations")
        admissible(scene.body.positive, numbers, free := symbol(name), low, high)
        if (degree := degree_in_k(scene, "at a rate omega")) > 2:
            raise ScopeError(f"U has degree {degree} in k: branches of rotations are computed if it has "
                             "degree 1 or 2; relative_equilibria finds the rotations at each value")
        self.scene, self.name, self.values, self.ends = scene, name, values, (low, high)
        data = data_at(scene, (S.Zero,) * 3)
        inertia, rotor, linear, curved = (Matrix(part).xreplace(numbers) for part in data)
        self.body = inertia, rotor, curved, (omega := numbers.get(OMEGA, OMEGA))
        self.pencil = Pencil(omega**2 * inertia - curved, eye(3), linear - omega * rotor, S.One, SIGMA)
        above, below = self.pencil.fraction
        self.curve = PlaneCurve(above.dot(above) - below**2, SIGMA, free, ends=())
        if not self.curve.rational:
            raise ScopeError("a number is not rational, and branches of rotations are computed at "
                             "rational numbers: round it to decimals")

    @cached_property
    def met(self) -> dict[Expr, list[Expr]]:
        """The values at which two rotations may meet, and the sigma of these."""
        found: dict[Expr, list[Expr]] = {}
        for t, sigma in _double_points(self.curve, *self.ends):
            found.setdefault(t, []).append(sigma)
        return found

    @cached_property
    def changed(self) -> dict[Expr, str]:
        """The values at which the stability of a rotation may change, and the kind of the change."""
        return {t: kind for t, kind in changes(self.curve, self.pencil, *self.body)
                if t not in self.met and within(t, *self.ends)}

    @cached_property
    def stations(self) -> list[Expr]:
        """The values at which rotations meet, and those at which the stability of one may change."""
        return in_order([*self.met, *self.changed])

    def between(self, low: Expr, high: Expr) -> list[Piece]:
        """Return the pieces between two stations, in the order of sigma."""
        return sorted(super().between(low, high), key=_sigma)

    def through(self, station: Expr, before: Pieces, after: Pieces) -> Iterator[tuple[int, int]]:
        """Yield which pieces go on as which: all of them, if none meet.

        Pieces are joined by sigma, and by k if two have one sigma.
        """
        if station not in self.met:
            for i, one in enumerate(before):
                yield i, min(range(len(after)), key=lambda j: _apart(one, after[j]))

    def marks(self, station: Expr, before: Pieces | None, after: Pieces | None) -> Iterator[Mark]:
        """Yield what meets at a station, or what changes there."""
        if station in self.changed:
            if before is not None and after is not None:
                for i, j in self.through(station, before, after):
                    if before[i].verdict is not after[j].verdict:
                        k = _components(before[i])
                        yield Mark(self.changed[station], self.name, station, k[2], k=k, changes=True)
            return
        at = Point({self.curve.t: station})
        here = [place for sigma in self.met[station] for place in meetings(self.pencil.at(at), sigma)]
        if len(here) == 1 and before is not None and after is not None and len(before) == len(after):
            here = [("crossing", k) for kind, k in here if kind == "fold"]     # none appears, none vanishes
        for kind, k in here:
            yield Mark(kind, self.name, station, k[2], k=k)

    def forms(self, t: Rational) -> list[HeavyForm]:
        """Return every rotation at a value, from the upright one down."""
        return heavy_forms(self.scene, {**self.values, self.name: t})

    def x(self, form: HeavyForm) -> arb:
        """Return the sigma of a rotation."""
        k, data, omega = form.in_balls(PRECISION)
        return dot(k, data.gradient) - omega * dot(k, [omega * dot(row, k) + l
                                                       for row, l in zip(data.inertia, data.rotor)])

    def piece(self, label: str, parameter: Array, verdict: Verdict, x: Array, y: Array) -> Piece:
        """Return a piece with k and sigma."""
        return Piece(label, parameter, verdict, k3=y[:, 2], k=y, sigma=x)


def _sigma(piece: Piece, end: int = 0) -> float:
    assert piece.sigma is not None
    return float(piece.sigma[end])


def _apart(before: Piece, after: Piece) -> tuple[float, float]:
    """Return how far the end of a piece is from the beginning of another, in sigma, then in k."""
    assert before.k is not None and after.k is not None
    return abs(_sigma(before, -1) - _sigma(after)), math.dist(before.k[-1], after.k[0])


def _components(piece: Piece) -> tuple[Expr, ...]:
    assert piece.k is not None
    return tuple(map(Float, piece.k[-1].tolist()))


def _double_points(curve: PlaneCurve, low: Expr, high: Expr) -> list[tuple[Expr, Expr]]:
    """Return (t, sigma) for every double point over the range.

    The t are roots of resultants, the sigma common roots there, from a common divisor over the field of t.
    """
    x, t = curve.place
    found: list[tuple[Expr, Expr]] = []

    def by_sigma(F: fmpq_mpoly) -> list[fmpq_poly]:
        return [in_one(c, t) for c in by_degree(F, x, curve.degree(F, 0))]

    for n, F in enumerate(curve.components):
        for G in (F.derivative(x), *curve.components[n + 1:]):
            if not curve.degree(G, 0):
                continue
            resultant = in_one(F.resultant(G, F.context().names()[x]), t)
            for factor, _ in resultant.factor()[1]:
                if not (roots := [r for r in roots_of_factor(factor) if within(r, low, high)]):
                    continue
                shared = common_divisor(by_sigma(F), by_sigma(G), factor)
                for root in roots:
                    both = Add(*(at_root(c, root) * SIGMA**n for n, c in enumerate(shared)))
                    one = [-at_root(shared[0], root)] if len(shared) == 2 else real_roots(both, SIGMA) or []
                    found += [(root, sigma) for sigma in one]
    return list(dict.fromkeys(found))
