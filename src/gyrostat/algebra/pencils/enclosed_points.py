"""Points of a sphere that a symmetric pencil of matrices takes to a given vector, in balls.

Where numbers have no common field, or one of high degree, resultants take minutes and balls milliseconds.
"""
from collections.abc import Sequence
from typing import Any

from flint import arb, arb_poly
from sympy import Expr, Matrix, S, Symbol

from ..enclosures.balls import ball
from ..enclosures.precision import doubled, own_precision
from ..rings.enclosed_roots import simple_roots
from ..rings.matrices import adjugate
from ..solving.real_fields import BITS, FieldNumbers, RealNumbers


class SimplePoints(RealNumbers):
    """The points x with pencil(ν) x = vector and abs(x) = radius, if all are proved to be simple.

    Where a component of x occurs in no other equation, it is 0, or its own entry of the pencil is. Else ν is
    a root of abs(adj(pencil) vector)² − radius² det(pencil)²; if all its roots are simple, the determinant
    vanishes at none of them, and there are no other points.

    Parameters
    ----------
    pencil : Matrix, shape (3, 3)
        symmetric, affine in nu; of full rank for large nu
    vector : Matrix, shape (3, 1)
        real numbers
    radius : Expr
        positive
    nu : Symbol

    Examples
    --------
    >>> from sympy import diag, eye, pi
    >>> nu = Symbol("nu")
    >>> points = SimplePoints(diag(1, 2, pi) + nu * eye(3), Matrix([1, 0, 2]), S.One, nu)
    >>> [round(float(x.mid()), 6) for x in points.values()[0]]
    [-5.200789, -0.238051, 0.0, -0.971253]
    """

    def __init__(self, pencil: Matrix, vector: Matrix, radius: Expr, nu: Symbol):
        self._given = pencil, vector, radius, nu
        self._start, self._slope = pencil.xreplace({nu: S.Zero}), pencil.diff(nu)
        self._vector, self._radius = vector, radius
        self._values: dict[int, list[list[arb]]] = {}

    def __reduce__(self) -> tuple[Any, ...]:
        return SimplePoints, self._given                   # python-flint's balls are not pickled

    @property
    def lists(self) -> list[FieldNumbers]:
        """The numbers ν and x of each point; there are none if the points are not proved to be simple."""
        return [FieldNumbers(self, n, [(place, S.One) for place in range(4)])
                for n in range(len(self.values()))]

    def values(self, precision: int = BITS) -> list[list[arb]]:
        """Return enclosures of ν and x at each point."""
        if precision not in self._values:
            found = None
            for bits in doubled(precision):
                with own_precision(2 * bits):
                    found = found or self._within([0, 1, 2], bits)
            self._values[precision] = found or []
        return self._values[precision]

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether a number is an integer; others are not known to be fractions."""
        return self.values()[root][place].is_integer()

    def expression(self, root: int, place: int) -> Expr:
        """Return an integer, or an enclosed number."""
        value = self.values()[root][place]
        return S(int(value.unique_fmpz())) if value.is_integer() else super().expression(root, place)

    def _within(self, axes: list[int], bits: int) -> list[list[arb]] | None:
        """Return the points in the span of some axes, which no others meet; None if they are not told."""
        n = next((n for n in axes if not self._vector[n] and self._alone(n)), None)
        if n is None:
            return self._at_roots(axes, bits) if axes else []
        others = [m for m in axes if m != n]
        inside, across = self._within(others, bits), self._across(n, others, bits)
        return None if inside is None or across is None else inside + across

    def _alone(self, n: int) -> bool:
        return not any(self._start[n, m] or self._slope[n, m] for m in range(3) if m != n)

    def _at_roots(self, axes: list[int], bits: int) -> list[list[arb]] | None:
        above, below = self._by_adjugate(axes, arb_poly([0, 1]), 2 * bits)
        size = ball(self._radius, 2 * bits)
        roots = simple_roots(sum((x * x for x in above), -size**2 * below * below), bits)
        found = [[root, *(x(root) / below(root) for x in above)] for root in roots or ()]
        return found if all(x.is_finite() for row in found for x in row) and roots is not None else None

    def _across(self, n: int, others: list[int], bits: int) -> list[list[arb]] | None:
        """Return the points at which the entry n of the pencil is 0."""
        alike = [m for m in others if self._alone(m) and self._slope[m, m] == self._slope[n, n]
                 and self._start[m, m] == self._start[n, n]]
        if alike:                                          # a circle, or a part of the vector in the kernel
            return None if any(ball(self._vector[m], 2 * bits).contains(0) for m in alike) else []
        root = -ball(self._start[n, n], 2 * bits) / ball(self._slope[n, n], 2 * bits)
        above, below = self._by_adjugate(others, root, 2 * bits)
        x = [y / below for y in above]
        square = ball(self._radius, 2 * bits)**2 - sum((y * y for y in x), arb(0))
        if square < 0:
            return []
        ways = [square.sqrt(), -square.sqrt()] if square > 0 else []
        return [[root, *(t if m == n else x[m] for m in range(3))] for t in ways] or None

    def _by_adjugate(self, axes: list[int], at: Any, precision: int) -> tuple[list[Any], Any]:
        """Return adj(pencil) vector and det(pencil), those of some axes, at a number or as polynomials."""
        rows = [[at * ball(self._slope[i, j], precision) + ball(self._start[i, j], precision)
                 if i in axes and j in axes else at * 0 + int(i == j) for j in range(3)] for i in range(3)]
        minors = adjugate(rows)
        b = [ball(x, precision) for x in self._vector]
        return [_dot(row, b) for row in minors], _dot(rows[0], [row[0] for row in minors])


def _dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
