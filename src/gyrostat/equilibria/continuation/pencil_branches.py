"""Follows in doubles the permanent rotations that a pencil has on a sphere over a range, and how they meet.

For a free body the pencil is (1 − ν I) M = l with abs(M) given; for a body in a field it is (omega² I − Q +
sigma) k = c − omega l.
"""
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from flint import arb
from sympy import Expr, Matrix, Rational, S, Symbol

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball, fraction_of
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.rationals import to_sympy
from ...algebra.pencils.exact_points import along_kernel
from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.rings.matrices import adjugate
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.stations import between
from ...stability.decision import Verdict
from ...stability.form import Form
from ..relative_equilibrium import RelativeEquilibrium
from .pieces import Piece

# between two stations, closer together at both; how near the first and the last are to one where some meet
NODES, NEAR = 48, 2**30
PRECISION = 128                                            # bits


class Pencil(NamedTuple):
    """The equations (base + x slope) y = vector, abs(y) = radius; all of them depend on one more name."""

    base: Matrix
    slope: Matrix
    vector: Matrix
    radius: Expr
    x: Symbol

    @property
    def matrix(self) -> Matrix:
        """The matrix base + x slope."""
        return self.base + self.x * self.slope

    def at(self, point: Point) -> "Pencil":
        """Return the pencil with numbers for names."""
        base, slope, vector = (m.applyfunc(lambda e: evaluate(e, point)) for m in self[:3])
        return Pencil(base, slope, vector, evaluate(self.radius, point), self.x)

    @property
    def fraction(self) -> tuple[Matrix, Expr]:
        """The vector adj(matrix) vector and det(matrix), of which y is the quotient."""
        minors = Matrix(adjugate(self.matrix.tolist()))
        return (minors * self.vector).expand(), self.matrix[:, 0].dot(minors[:, 0]).expand()


def meetings(pencil: Pencil, root: Expr) -> Iterator[tuple[str, tuple[Expr, ...]]]:
    """Yield (kind, y) for what meets at a double point x of abs(adj(matrix) vector)² = radius² det(matrix)².

    If det ≠ 0 there, y is one vector, hence a fold. At a pole two solutions y ± s e lie on either side of a
    plane, and meet where s = 0; at a double pole they are a circle.
    """
    above, below = pencil.fraction
    if proved_sign(under := evaluate(below, {pencil.x: root})) != 0:
        yield "fold", tuple(evaluate(y, {pencil.x: root}) / under for y in above)
        return
    here = (pencil.slope.inv() * pencil.matrix).xreplace({pencil.x: root})
    singular = Matrix(adjugate(here.tolist()))
    for _, y, circle in along_kernel(pencil.matrix, above, below, pencil.radius, pencil.x, root):
        if circle is not None:
            yield (("circle at this value alone", y) if any(circle)
                   else ("sphere at this value alone", (S.Zero, S.Zero, pencil.radius)))
        elif not any(proved_sign(evaluate(e, {})) for e in singular):
            yield "circle leaves an axis", y
        elif not any(proved_sign(evaluate(e, {})) for e in singular * Matrix(y)):
            across = here.trace() * pencil.radius**2 - Matrix(y).dot(here * Matrix(y))
            yield "pitchfork" if proved_sign(evaluate(across, {})) else "umbilic", y


class PencilBranches(ABC):
    """What its pencil says about a Curve of permanent rotations.

    A kind of scene gives the pencil, the curve of x over the name, its stations, the rotations at a value,
    and what happens at a station.
    """

    pencil: Pencil
    curve: PlaneCurve

    @cached_property
    def changed(self) -> dict[Expr, str]:
        """The stations at which none meet, and what happens there."""
        return {}

    @abstractmethod
    def forms(self, t: Rational) -> Sequence[Form]:
        """Return every rotation at a value, exact."""

    @abstractmethod
    def x(self, form: Any) -> arb:
        """Return the x of a rotation."""

    @abstractmethod
    def piece(self, label: str, parameter: Array, verdict: Verdict, x: Array, y: Array) -> Piece:
        """Return a piece in the words of the scene."""

    def alone(self, station: Expr) -> tuple[()]:
        """Return no isolated rotations."""
        return ()

    def between(self, low: Expr, high: Expr) -> list[Piece]:
        """Return every rotation between two stations as a piece.

        The rotations are exact at one fraction; from there on they are followed in doubles by the order of x.
        The pieces come in the order of the exact ones.
        """
        middle, found = self._at(between(low, high))
        if any(one.decision.pointwise and not one.decision.stable for one in found):  # a resonance
            middle, found = self._at(between(low, to_sympy(middle)))
        nodes = fractions_between(low, high, low not in self.changed, high not in self.changed)
        here = self.curve.roots(middle)
        at = [self.pencil.at(Point({self.curve.t: to_sympy(t)})) for t in nodes]
        base, slope, vectors, radii = (np.array([np.array(part, float) for part in parts])
                                       for parts in list(zip(*at))[:4])
        roots = np.array([[float(root.mid()) for root in self.curve.roots(t, len(here))] for t in nodes])
        parameter = np.array([float(low), *map(float, nodes[1:-1]), float(high)])
        groups: dict[int, list[RelativeEquilibrium]] = {}
        for one in found:
            apart = [abs(root - self.x(one.form)) for root in here]
            groups.setdefault(min(range(len(here)), key=lambda n: float(apart[n].mid())), []).append(one)
        pieces = []
        for n, several in groups.items():
            about = several[0].form.circle
            at_pole = len(several) - 1 if about is None else 2 if any(about) else 3
            turned = base + roots[:, n, None, None] * slope
            for one, y in zip(several, _points(turned, vectors[:, :, 0], radii, at_pole)):
                pieces.append(self.piece(one.label, parameter, one.decision.verdict, roots[:, n], y))
        return pieces

    def _at(self, t: Fraction) -> tuple[Fraction, list[RelativeEquilibrium]]:
        return t, [RelativeEquilibrium(form) for form in self.forms(to_sympy(t))]


def _points(turned: Array, vectors: Array, radii: Array, at_pole: int) -> list[Array]:
    """Return y along a root in doubles; at a pole, up to a triple one, y on either side of what is across."""
    found, along = [], np.zeros(3)
    for matrix, vector, radius in zip(turned, vectors, radii):
        if not at_pole:
            whole = np.linalg.matrix_rank(matrix) == 3     # else y has no part across a plane
            found.append([np.linalg.solve(matrix, vector) if whole else np.linalg.pinv(matrix) @ vector])
            continue
        sizes, axes = np.linalg.eigh(matrix)
        kernel = np.argsort(abs(sizes))[:at_pole]
        others = np.delete(np.arange(3), kernel)
        across = axes[:, others] @ (axes[:, others].T @ vector / sizes[others])
        inside = axes[:, kernel]
        along = inside @ (inside.T @ along) if along.any() else inside[:, 0]
        along = along / np.linalg.norm(along)
        high = np.sqrt(max(radius**2 - across @ across, 0.0)) * along
        found.append([across + high, across - high])
    return list(np.moveaxis(np.array(found), 1, 0))


def fractions_between(a: Expr, b: Expr, first: bool = True, last: bool = True,
                      near: int = NEAR) -> list[Fraction]:
    """Return fractions between two numbers; the outer ones lie beside ends at which rotations may meet."""
    low, high = (fraction_of(ball(t, PRECISION).mid()) for t in (a, b))
    parts = (1 - np.cos(np.pi * np.arange(1, NODES) / NODES)) / 2
    inside = [Fraction(first, near), *map(Fraction, parts.tolist()), 1 - Fraction(last, near)]
    unit = NEAR**2 * max(1, int(1 / (NEAR * (high - low))))
    return [Fraction(round((low + (high - low) * part) * unit), unit) for part in inside]
