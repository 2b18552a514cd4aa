"""The energy at each tilt, a function of k3 alone: where it turns or is infinite, and how high it lies."""
from collections.abc import Iterable

from sympy import Expr, Rational, S, oo

from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.polynomials import derivatives
from ...algebra.solving.roots import in_order, real_roots
from ...algebra.solving.stations import between
from ...mechanics.equilibrium.reduction import K3


class Line:
    """V on −1 ≤ k3 ≤ 1.

    Parameters
    ----------
    potential : Expr
        V, rational in k3 with exact numbers

    Attributes
    ----------
    order : list of Expr
        the tilts at which the slope vanishes or V is infinite, and the poles, in increasing order
    """

    def __init__(self, potential: Expr):
        self.potential = potential
        self.slope = derivatives(potential, [K3])[0]
        roots = real_roots(self.slope, K3, S.NegativeOne, S.One)
        self.constant = roots is None
        poles = real_roots(1 / potential, K3) or [] if not potential.is_number else []
        self.infinite = [z for z in poles if proved_sign(1 - z**2) != -1]
        self.inside = roots or []
        self.ends = [s for s in (S.NegativeOne, S.One) if s not in self.infinite]
        self.order = in_order([*self.inside, *self.infinite, *self.ends])

    def height(self, z: Expr) -> Expr:
        """Return V at a tilt."""
        return evaluate(self.potential, {K3: z})

    def rise(self, a: Expr, b: Expr) -> int:
        """Return the sign of V(b) − V(a) for neighbours in the order."""
        middle = between(*in_order([a, b]))
        sign = proved_sign(evaluate(self.slope, {K3: Rational(middle.numerator, middle.denominator)}))
        return sign * proved_sign(b - a)

    def place(self, z: Expr) -> int:
        """Return where a tilt stands in the order."""
        return next(n for n, x in enumerate(self.order) if proved_sign(x - z) == 0)

    def highest(self, z: Expr, step: int, end: Expr) -> Expr:
        """Return the greatest V from a minimum to a tilt; oo if V is infinite on the way."""
        found, n = [self.height(end)], self.place(z) + step
        while proved_sign(end - self.order[n]) == step:
            if (met := self.order[n]) not in self.infinite:
                found.append(self.height(met))
            elif self.rise(self.order[n - step], met) == 1:
                return oo
            else:                                          # V has fallen without bound
                return -lowest(-x for x in found[1:])
            n += step
        return -lowest(-x for x in found)

    def way(self, place: int, step: int) -> list[tuple[Expr, int, int]]:
        """Return, from a place up to where V falls, (k3, sign of the rise to it, sign of that beyond)."""
        found: list[tuple[Expr, int, int]] = []
        end = place + step
        while 0 <= end < len(self.order):
            before, z = self.rise(self.order[end - step], self.order[end]), self.order[end]
            beyond = end + step
            after = self.rise(z, self.order[beyond]) if 0 <= beyond < len(self.order) else 0
            if before != 1 or z in self.infinite:
                return [*found, (z, before, after)] if before != 1 else found
            found.append((z, before, after))
            if after != 1:
                return found
            end = beyond
        return found


def lowest(heights: Iterable[Expr]) -> Expr:
    """Return the least of exact numbers, oo if there is none."""
    found: Expr = oo
    for x in heights:
        if found == oo or proved_sign(found - x) == 1:
            found = x
    return found
