"""Splits vectors along the principal axes of any inertia tensor, by its moments, without turning the body."""
from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, ImmutableMatrix, Poly, S, Symbol, eye, invert, rem, sqrt

from ..._cached import cached_property
from ...algebra.reals.exact import evaluate, is_identically_zero, proved_sign
from ...algebra.rings.matrices import adjugate, applied
from ...algebra.rings.polynomials import lowest_terms
from ...algebra.solving.roots import real_roots
from ...mechanics.scenes.body import Gyrostat
from ...notation import symbol

MOMENT = symbol("moment")
UNITS = tuple(tuple(S(int(i == j)) for j in range(3)) for i in range(3))


@dataclass(frozen=True)
class InertiaAxes:
    """The distinct moments of a body at given numbers, and the projections on their axes.

    The projection on the axis of a simple moment m is adj(I − m)/tr adj(I − m), a polynomial of degree 2 in m
    modulo det(I − m); if two moments are equal, that on the axes of m is (I − m')/(m − m').

    Parameters
    ----------
    body : Gyrostat
        at numbers; a tensor may be in any axes

    References
    ----------
    Derived in docs/explanation/derivations/amended-potential.md, section 7.
    """

    body: Gyrostat

    @cached_property
    def moments(self) -> tuple[Expr, ...]:
        """The distinct moments, in the order of the axes, or of size."""
        if not isinstance(self.body.inertia, ImmutableMatrix):
            return tuple(dict.fromkeys(self.body.moments))
        return tuple(real_roots(self._level, MOMENT) or ())

    def part(self, moment: Expr, vector: Sequence[Expr]) -> tuple[Expr, ...]:
        """Return the part of a vector along the axes of a moment, exact.

        The vector may be a polynomial in other names.
        """
        if not isinstance(self.body.inertia, ImmutableMatrix):
            return tuple(x if m == moment else S.Zero for x, m in zip(vector, self.body.moments))
        along = [applied(rows, vector) for rows in self._projections[moment]]
        return tuple(Add(*(x * moment**n for n, x in enumerate(entry))) for entry in zip(*along))

    def is_along(self, moment: Expr, vector: Sequence[Expr]) -> bool:
        """Tell whether a vector, which may depend on other names, has a part along the axes of a moment."""
        along = self.part(moment, vector)
        return is_identically_zero(Add(*(x * y for x, y in zip(along, vector)))) is False

    def values_across(self, moment: Expr, c: Sequence[Expr], l: Sequence[Expr], x: Symbol) -> list[Expr]:
        """Return the value of x, not 0, at which alone c − x l is across the axes of a moment, or none."""
        along = self.part(moment, l)
        level = Add(*((a - x * b) * y for a, b, y in zip(c, l, along)))
        return [at for at in real_roots(level, x) or ()
                if at != 0 and not self.is_along(moment, [a - at * b for a, b in zip(c, l)])]

    def direction(self, moment: Expr, vector: Sequence[Expr]) -> tuple[Expr, ...]:
        """Return that part, which is not 0, divided by its length; its square is the product with the vector.
        """
        along = self.part(moment, vector)
        return tuple(x / sqrt(Add(*(y * z for y, z in zip(along, vector)))) for x in along)

    @cached_property
    def _level(self) -> Expr:
        return (self.body.tensor - MOMENT * eye(3)).det(method="berkowitz").expand()

    @cached_property
    def _projections(self) -> dict[Expr, list[list[list[Expr]]]]:
        """Matrices, the coefficients of 1, m and m² in the projection on the axes of each moment m."""
        if len(self.moments) == 2:
            return {m: [((self.body.tensor - n * eye(3)) / (m - n)).tolist()]
                    for m, n in (self.moments, self.moments[::-1])}
        minors = adjugate((self.body.tensor - MOMENT * eye(3)).tolist())
        scale = invert(Add(*(minors[n][n] for n in range(3))), self._level, MOMENT)
        entries = [[Poly(rem(x * scale, self._level, MOMENT), MOMENT) for x in row] for row in minors]
        common = [[[x.coeff_monomial(MOMENT**n) for x in row] for row in entries] for n in range(3)]
        return dict.fromkeys(self.moments, common)

    def order(self, moment: Expr) -> int:
        """Return how many axes have a moment: 2 for a body of revolution."""
        if not isinstance(self.body.inertia, ImmutableMatrix):
            return self.body.moments.count(moment)
        return 2 if len(self.moments) == 2 and self.body.tensor.trace() - Add(*self.moments) == moment else 1

    def axis(self, moment: Expr) -> tuple[Expr, ...]:
        """Return a vector along the axis of a simple moment; its last component that is not 0 is 1."""
        columns = [self.part(moment, unit) for unit in UNITS]
        n = next(n for n in (2, 1, 0) if proved_sign(columns[n][n]))
        return tuple(evaluate(x / columns[n][n], {}) for x in columns[n])

    def divided(self, vector: Sequence[Expr], unknown: Symbol, factor: Expr) -> tuple[Expr, ...]:
        """Return (unknown + factor I)⁻¹ times a vector, in lowest terms."""
        if not isinstance(self.body.inertia, ImmutableMatrix):
            return tuple(x / (unknown + factor * m) if x else S.Zero
                         for x, m in zip(vector, self.body.moments))
        pencil = (unknown * eye(3) + factor * self.body.tensor).tolist()
        minors = adjugate(pencil)
        below = Add(*(x * y for x, y in zip(pencil[0], minors[0])))
        return tuple(lowest_terms(x / below) for x in applied(minors, vector))
