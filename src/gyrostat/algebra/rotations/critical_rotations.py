"""All real critical points of a quartic form off N = 0, in balls: proved simple, and proved to be all."""
from collections.abc import Sequence
from itertools import combinations
from typing import Any

from flint import acb, arb, ctx
from sympy import Expr, S

from ..._cached import cached_property
from ...errors import ScopeError
from ..enclosures.precision import doubled, own_precision
from ..solving.real_fields import BITS, FieldNumbers, RealNumbers
from ..solving.root_numbers import DIFFERENT
from .bounds import LINES, Bound, bounded
from .boxes import CriticalEquations, approximated
from .exact_rotations import ExactRotations
from .quartic_forms import QuarticForm

START = 64                                             # bits of the first approximations
GUARD = 32                                             # bits


class RotationZeros(RealNumbers):
    """The real critical points of a quartic form F(q) in balls: n and r at each of them.

    They are approximated, and then proved to be simple zeros, the complex ones too, by Krawczyk's test. If
    they are as many as the bound says, they are all.

    Parameters
    ----------
    form : QuarticForm
    bound : Bound
    """

    def __init__(self, form: QuarticForm, bound: Bound):
        self._form, self._bound, self._equations = form, bound, CriticalEquations(form)
        self._values: dict[int, list[list[arb]]] = {}

    @cached_property
    def isolated(self) -> list[list[acb]] | None:
        """Balls of q with one real zero each; None if not all zeros are proved to be simple."""
        most = 8 if self._form.parts else 4                # where no exact points can be computed after it
        for bits in doubled(START, most * START):
            with own_precision(bits):
                several = approximated(self._form, self._bound)
            with own_precision(2 * bits):
                if (found := self._proved(several)) is not None:
                    return found
        return None

    def _proved(self, several: Sequence[Sequence[acb]]) -> list[list[acb]] | None:
        """Return the boxes of the real zeros, if all zeros are simple."""
        count, ratios, real = 0, [], []
        for q in several:
            size = sum((x * x for x in q), acb(0)).sqrt()
            near = [(x / size).mid() for x in q]
            is_real = all(abs(x.imag) < arb(2) ** (-ctx.prec // 3) for x in near)
            box = self._equations.enclosed([acb(x.real) for x in near] if is_real else near)
            if box is not None and not is_real and all(x.imag.contains(0) for x in box):  # a real one
                is_real, box = True, self._equations.enclosed([acb(x.real) for x in near])
            if box is None or not is_real and self._ratio(box).imag.contains(0):
                return None
            if not is_real and self._ratio(box).imag < 0:  # its conjugate counts twice
                continue
            count += 1 if is_real else 2
            ratios.append(self._ratio(box))
            if is_real:
                real.append(box)
        apart = not any(a.overlaps(b) for a, b in combinations(ratios, 2))
        return real if apart and count == self._bound.most else None

    def _ratio(self, q: Sequence[acb]) -> acb:
        """Return the ratio of the two linear forms."""
        above, below = (sum((c * x for c, x in zip(line, q)), acb(0)) for line in self._bound.lines)
        return above / below

    def __reduce__(self) -> tuple[Any, ...]:
        return RotationZeros, (self._form, self._bound)    # python-flint's balls are not pickled

    def values(self, precision: int = BITS) -> list[list[arb]]:
        """Return enclosures of n and r at each real zero."""
        if precision not in self._values:
            with own_precision(precision + GUARD):
                self._values[precision] = [_directions(self._nearer(box)) for box in self.isolated or ()]
        return self._values[precision]

    def _nearer(self, box: Sequence[acb]) -> Sequence[acb]:
        """Return a narrower box around the zero in a box."""
        found = self._equations.enclosed([acb(x.real.mid()) for x in box])
        inside = found is not None and all(a.contains(b) for a, b in zip(box, found))
        return found if found is not None and inside else box

    @cached_property
    def _algebra(self) -> ExactRotations | None:
        return None if self._form.parts else ExactRotations(self._form.whole, self._bound)

    @property
    def exact(self) -> list[FieldNumbers] | None:
        """The same points in number fields; None if not all of them are proved to be found."""
        return None if self._algebra is None else self._algebra.points

    def expression(self, root: int, place: int) -> Expr:
        """Return one of the numbers of a point as an expression; with an irrational factor it is enclosed."""
        if self._algebra is None:
            return super().expression(root, place)
        return self._same(root)[place]

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether one of the numbers of a point is a fraction; none is if there is a factor."""
        if self._algebra is None or self._algebra.conjugate and self.varies(
                place, range(len(self.isolated or ()))):
            return False
        return self._same(root).is_fraction(place)

    def _same(self, root: int) -> FieldNumbers:
        """Return the exact point that has the same enclosures."""
        for precision in doubled(BITS):
            values = self.values(precision)[root]
            same = [point for point in self.exact or ()
                    if all(a.overlaps(b) for a, b in zip(values, point.balls(precision)))]
            if len(same) == 1:
                return same[0]
        raise ScopeError(DIFFERENT)


def _directions(q: Sequence[acb]) -> list[arb]:
    """Return n and r of a quaternion with N = 1."""
    a, b, c, d = (x.real for x in q)
    return [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b),
            2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d]


def critical_rotations(form: QuarticForm) -> list[FieldNumbers] | None:
    """Return n and r at every real critical point of a quartic form off N = 0, six numbers for each.

    Parameters
    ----------
    form : QuarticForm

    Returns
    -------
    list of FieldNumbers
        None if it is not proved that they are isolated, and all

    Examples
    --------
    >>> from .quartic_forms import QuarticForm, quartic
    >>> gravity = {(0, 0, 0, 2, 0, 0): 3, (0, 0, 0, 0, 2, 0): 6, (0, 0, 0, 0, 0, 2): 12,
    ...            (2, 0, 0, 0, 0, 0): -1, (0, 2, 0, 0, 0, 0): -2, (0, 0, 2, 0, 0, 0): -4}
    >>> len(critical_rotations(QuarticForm(quartic(gravity))))
    24
    """
    for lines in LINES:                                    # the first, unless they happen to meet the points
        if (bound := bounded(form, lines)) is None:
            continue
        zeros = RotationZeros(form, bound)
        if (boxes := zeros.isolated) is not None:
            return [FieldNumbers(zeros, n, [(place, S.One) for place in range(6)]) for n in range(len(boxes))]
        if zeros.exact is not None:
            return zeros.exact
    return None
