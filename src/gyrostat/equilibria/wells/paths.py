"""Certified paths down from a critical point: V is below its value there on all of the path, in balls."""
from collections.abc import Sequence
from typing import Any

import numpy as np
from flint import arb, arb_series

from ...algebra.enclosures.precision import own_precision
from ..relative_equilibrium import RelativeEquilibrium
from .in_balls import BITS
from .landscape import Landscape

DEEPEST = 14                                           # halvings of a segment
STEPS, LONGEST = 4000, 0.05                            # of a descent; rad
ASIDE = 2e-3                                           # rad, out of a plane of symmetry
SAMPLES = np.linspace(0, 1, 41)[:, None]


class Paths:
    """Descents in a landscape; what is found in doubles is proved in balls.

    Parameters
    ----------
    landscape : Landscape
    indices : sequence of int or None
        of each critical point the number of directions down; None if it is degenerate
    """

    def __init__(self, landscape: Landscape, indices: Sequence[int | None]) -> None:
        self.landscape, self.indices = landscape, indices
        self.places = landscape.places
        self.near = np.array([[float(c.mid()) for c in place] for place in self.places])
        self.minima = [n for n, index in enumerate(indices) if index == 0]
        with own_precision(BITS):
            self.values = [landscape.value(place) for place in self.places]
        self.size = max(abs(float(v.mid())) for v in self.values) or 1.0

    def above(self, rotation: RelativeEquilibrium) -> list[arb]:
        """Return V of each critical point above that of one of them [M L²/T²]."""
        with own_precision(BITS):
            here = self.values[self.landscape.number(rotation)]
            return [value - here for value in self.values]

    def ends(self, n: int) -> list[int] | None:
        """Return the minima at the ends of paths down from a critical point; None if one is not found.

        Of index 1 there are two ways; of a higher one, one, and others are tried if it is not proved.
        """
        with own_precision(BITS):
            downward = self._downward(n)
            if self.indices[n] == 1:
                found = [self._path(n, sign * downward[0]) for sign in (1, -1)]
                return None if None in found else [end for end in found if end is not None]
            ways = [*downward, *(-u for u in downward), downward.sum(axis=0)]
            end = next((end for u in ways if (end := self._path(n, u)) is not None), None)
            return None if end is None else [end]

    def _downward(self, n: int) -> Any:
        """Directions down, in doubles: eigenvectors of the second variation across the point."""
        x = self.near[n]
        across = np.linalg.svd(x[None])[2][1:]
        step = 1e-4

        def V(move: Any) -> float:
            return float(self.landscape.floats(x + step * move))

        second = np.array([[V(a + b) - V(a - b) - V(b - a) + V(-a - b) for b in across] for a in across])
        return (np.linalg.eigh(second)[1].T @ across)[:self.indices[n] or 1]

    def _path(self, n: int, u: Any) -> int | None:
        """A minimum that a proved path from a point, first along u, reaches."""
        place, level = self.places[n], self.values[n]
        if (t := self._first(place, u)) is None:
            return None
        return self._descend([p + t * arb(float(c)) for p, c in zip(place, u)], level)

    def down(self, place: Sequence[arb], level: arb) -> int | None:
        """Return the minimum at the end of a proved path from a place, below a level; None: not found."""
        with own_precision(BITS):
            return self._descend(place, level)

    def _descend(self, place: Sequence[arb], level: arb) -> int | None:
        y, trail = np.array([float(c.mid()) for c in place]), [place]
        below = float(level.mid()) - 1e-9 * self.size
        rng = np.random.default_rng(len(y))
        for _ in range(STEPS):
            y = y / np.linalg.norm(y)
            trail.append([arb(float(c)) for c in y])
            for m, sign in self._ahead(y):
                straight = y + SAMPLES * (sign * self.near[m] - y)
                if np.max(self.landscape.floats(straight)) < below:
                    chain = [*trail, [int(sign) * c for c in self.places[m]]]
                    if all(self._below(a, b, level) for a, b in zip(chain, chain[1:])):
                        return m
            moved = self._down(y)
            if moved is None:                              # on a plane of symmetry, or at another saddle
                moved = y + ASIDE * rng.normal(size=len(y))
                if not self.landscape.floats(moved) < below:
                    continue
            y = moved
        return None

    def _first(self, place: list[arb], u: Any) -> float | None:
        """How far V falls from a critical point: its slope is 0 there, and it is concave up to there."""
        t = 0.2
        while t > 1e-6:
            bend = self._series(place, [arb(float(c)) for c in u], arb(t / 2, t / 2), 2)[2]
            if bend < 0:
                return t
            t /= 2
        return None

    def _ahead(self, y: Any) -> list[tuple[int, float]]:
        """The three minima that are nearest, with the sign of the quaternion that is."""
        near = [(self.near[m] @ y, m) for m in self.minima]
        signed = [(abs(c), m, np.sign(c)) if self.landscape.attitudes else (c, m, 1.0) for c, m in near]
        return [(m, sign) for c, m, sign in sorted(signed, reverse=True)[:3] if c > -0.5 and sign]

    def _down(self, y: Any) -> Any:
        """A step down the gradient; None where there is none to be seen."""
        moves = 1e-6 * np.eye(len(y))
        up, low = self.landscape.floats(y + moves), self.landscape.floats(y - moves)
        slope = (up - low) / 2e-6
        slope -= y * (slope @ y)
        steep, here = np.linalg.norm(slope), self.landscape.floats(y)
        length = LONGEST if steep > 1e-6 * self.size else 0
        while length > 1e-9:
            moved = y - length * slope / steep
            if self.landscape.floats(moved) < here - 0.1 * length * steep:
                return moved
            length /= 2
        return None

    def _series(self, place: Sequence[arb], u: Sequence[arb], t: arb, order: int) -> Any:
        """Of V along a line the power series about t."""
        at = arb_series([t, 1], order + 1)
        try:
            return self.landscape.value([p + c * at for p, c in zip(place, u)])
        except ValueError:                                 # a divisor may be 0: nothing is known
            return [arb("nan")] * (order + 1)

    def _below(self, a: Sequence[arb], b: Sequence[arb], level: arb, low: float = 0.0, high: float = 1.0,
               depth: int = 0) -> bool:
        """Whether V is below a level on a segment, by mean values on its halves."""
        line, middle = [q - p for p, q in zip(a, b)], (low + high) / 2
        here = self.landscape.value([p + middle * c for p, c in zip(a, line)])
        if not here < level:
            return False
        half = (high - low) / 2
        slope = self._series(a, line, arb(middle, half), 1)[1]
        if here + slope * arb(0, half) < level:
            return True
        return depth < DEEPEST and self._below(a, b, level, low, middle, depth + 1) \
            and self._below(a, b, level, middle, high, depth + 1)
