"""The least value of a function on a circle of directions, proved in balls by halving arcs."""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush

from flint import arb, arb_series

ENOUGH = 80                                            # bits of a least value
ARCS, MOST, ROUNDS = 16, 1000, 6                       # of a circle; halvings; rounds of Newton's method


@dataclass(frozen=True)
class Circle:
    """The directions at an angle from k0: middle + a cos φ + b sin φ."""

    middle: Sequence[arb]
    a: Sequence[arb]
    b: Sequence[arb]

    @classmethod
    def round(cls, k0: Sequence[arb], angle: arb) -> "Circle":
        """Return the circle of an angle, from a unit vector."""
        n = min(range(3), key=lambda i: abs(float(k0[i].mid())))
        across = [(i == n) - k0[n] * x for i, x in enumerate(k0)]
        scale = angle.sin() / sum((x * x for x in across), arb(0)).sqrt()
        a = [scale * x for x in across]
        b = [k0[1] * a[2] - k0[2] * a[1], k0[2] * a[0] - k0[0] * a[2], k0[0] * a[1] - k0[1] * a[0]]
        return cls([angle.cos() * x for x in k0], a, b)

    def at(self, phi: arb) -> list[arb_series]:
        """Return the power series of k at φ, of order 2, of which a ball encloses those at its points."""
        c, s = phi.cos(), phi.sin()
        cosine, sine = arb_series([c, -s, -c / 2], 3), arb_series([s, c, -s / 2], 3)
        return [m + a * cosine + b * sine for m, a, b in zip(self.middle, self.a, self.b)]


def least(f: Callable[[arb], arb_series]) -> arb:
    """Enclose the least value of a function with the period 2π, from its power series of order 2.

    The arc of the lowest bound is halved until the bound is near a value. After 1000 halvings the bound is
    what it is: so where the function is constant.

    Parameters
    ----------
    f : callable
        of a ball, within which the last coefficient encloses those at its points

    Examples
    --------
    >>> least(lambda x: arb_series([x.cos(), -x.sin(), -x.cos() / 2], 3)).contains(-1)
    True
    """
    ends = [7 * n / ARCS for n in range(ARCS + 1)]         # 7 > 2π
    waiting, high = [], arb("inf")
    for arc in zip(ends, ends[1:]):
        low, value = _bounds(f, *arc)
        high = min(high, value)
        waiting.append((low, *arc))
    heapify(waiting)
    for _ in range(MOST):
        low, start, end = waiting[0]
        if high - low < abs(high) * arb(2) ** -ENOUGH:
            break
        heappop(waiting)
        middle = (start + end) / 2
        for arc in ((start, middle), (middle, end)):
            low, value = _bounds(f, *arc)
            high = min(high, value)
            heappush(waiting, (low, *arc))
    return waiting[0][0].union(high)


def _bounds(f: Callable[[arb], arb_series], start: float, end: float) -> tuple[arb, arb]:
    """Return a lower bound on an arc, and a value there, rounded up."""
    over = f(arb(start).union(arb(end)))
    place, curvature = (start + end) / 2, (2 * over[2]).lower()
    if curvature > 0:
        for _ in range(ROUNDS):
            near = f(arb(place))
            step = float(near[1].mid()) / (2 * float(near[2].mid()))
            place = min(max(place - step, start), end)
    here = f(arb(place))
    value, slope, back, on = here[0], here[1], arb(start) - arb(place), arb(end) - arb(place)
    if curvature > 0:                                      # f is above its tangents, and above parabolas
        low = max((value - slope**2 / (2 * curvature)).lower(),
                  (value + min(arb(0), (slope * back).lower(), (slope * on).lower())).lower())
    else:
        radius = max(-back, on)
        low = (value - abs(slope) * radius + curvature * radius**2 / 2).lower()
    return max(low, over[0].lower()), value.upper()
