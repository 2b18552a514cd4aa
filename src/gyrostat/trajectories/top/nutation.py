"""k3 between two turning points as elliptic functions of a variable u in which time is smooth, however close
other roots of g lie.
"""
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from flint import acb, arb

from ..elliptic import argument, jacobi, jacobi_ball, means, quarter_period
from ..periods import double
from .turning_points import Roots


@dataclass(frozen=True)
class Nutation:
    """z = c² lower + s² upper, s² + c² = 1, with (s .

    C) elliptic functions of u, so that dz/√abs(q(z)) is scale · du for a quartic q.

    The roots of q are the turning points and the two other roots of g nearest to them: neighbours on the real
    line, or a conjugate pair. Where q is all of g, u is proportional to time; elsewhere g/q is smooth.

    Parameters
    ----------
    roots : Roots
    kind : str
        "neighbours", from the lower end; "neighbours above", from the upper end; "pair"; "passage" from one
        double root to another
    complement : arb
        m1 of the elliptic functions
    ratio : arb
        of s to c in them
    scale : arb
    used : tuple of acb
        the roots of q beside the turning points
    rest : list of (acb, int)
        the roots of g that are not those of q
    """

    roots: Roots
    kind: str
    complement: arb
    ratio: arb
    scale: arb
    used: tuple[acb, ...]
    rest: list[tuple[acb, int]]

    @property
    def quarter(self) -> arb | None:
        """u from one turning point to the other; None where one of them is not reached."""
        return None if any(self.roots.double) else quarter_period(self.complement)

    @cached_property
    def _steps(self) -> list[tuple[arb, arb]]:
        return means(self.complement) if self.complement != 0 else []

    def shape(self, u: Any) -> tuple[Any, Any, Any]:
        """s, c, and d(atan(s/c))/du; of an array in doubles, of an arb in balls."""
        balls = isinstance(u, arb)
        m1, ratio = (self.complement, self.ratio) if balls else (double(self.complement), double(self.ratio))
        root: Callable[[Any], Any] = arb.sqrt if balls else np.sqrt
        if self.kind == "passage":
            half = u.tanh() if balls else np.tanh(u)
            s, c = root((1 + half) / 2), root((1 - half) / 2)
            return s, c, s * c
        sn, cn, dn = jacobi_ball(u, m1, self._steps) if balls else jacobi(u, m1)
        if self.kind == "pair":
            s, c, turn = ratio * sn * dn, cn, ratio * (cn * cn * cn * cn + m1 * sn * sn * (1 + cn * cn))
        else:
            s, c, turn = ratio * sn, cn, ratio * dn
        square = s * s + c * c
        s, c = s / root(square), c / root(square)
        return (c, -s, turn / square) if self.kind == "neighbours above" else (s, c, turn / square)

    def start(self, s: arb, c: arb) -> arb:
        """u where sin and cos of the angle are s and c, c ≥ 0."""
        if self.kind == "passage":
            return (s / c).log()
        if self.kind == "neighbours above":
            return -argument(c / self.ratio, abs(s), self.complement) * (1 if s >= 0 else -1)
        side, y = (-1 if s < 0 else 1), abs(s) / self.ratio
        if self.kind == "pair":
            return side * argument(2 * y * c, c * c - y * y, self.complement) / 2
        return side * argument(y, c, self.complement)

    def quartic(self, z: arb, double: bool) -> arb:
        """abs(q(z)); at a double root, half of its second derivative."""
        value, left = arb(1), 2 if double else 0
        for x in (acb(self.roots.lower), acb(self.roots.upper), *self.used):
            if left and x.overlaps(acb(z)):
                left -= 1
            else:
                value *= abs(z - x)
        return value


def nutation(roots: Roots) -> Nutation:
    """The elliptic functions that suit the roots.

    References
    ----------
    Byrd & Friedman, Handbook of Elliptic Integrals, 2nd ed. (1971), 256 and 259.
    """
    lower, upper, width = roots.lower, roots.upper, roots.upper - roots.lower
    if all(roots.double):
        return Nutation(roots, "passage", arb(0), arb(1), 2 / width, (acb(lower), acb(upper)), roots.others)
    real = [x.real for x, m in roots.others for _ in range(m) if x.imag == 0]
    pairs = [x for x, m in roots.others for _ in range(m) if x.imag > 0]
    nearest = min([*real, *pairs], key=lambda x: _distance(x, lower, upper), default=None)
    if isinstance(nearest, acb) and not any(roots.double):
        A, B = abs(upper - nearest), abs(lower - nearest)
        complement = ((A + B) ** 2 - width**2) / (4 * A * B)
        used = nearest, nearest.conjugate()
        return Nutation(roots, "pair", complement, (B / A).sqrt(), 2 / (A * B).sqrt(), used,
                        _without(roots, used))
    below, above = [x for x in real if x < lower], [x for x in real if x > upper]
    before = lower if roots.double[0] else max(below, key=arb.mid, default=None)
    after = upper if roots.double[1] else min(above, key=arb.mid, default=None)
    if before is None and len(above) > 1:                  # the line closes at infinity
        before = max(above, key=arb.mid)
    if after is None and len(below) > 1:
        after = min(below, key=arb.mid)
    first = abs((lower - before) / (upper - before)) if before is not None else arb(1)
    last = abs((after - upper) / (after - lower)) if after is not None else arb(1)
    scale = 2 / ((abs(upper - before) if before is not None else arb(1))
                 * (abs(after - lower) if after is not None else arb(1))).sqrt()
    used = tuple(acb(x) for x in (before, after) if x is not None)
    complement = arb(0) if any(roots.double) else first * last
    kind, ratio = ("neighbours above", last.sqrt()) if roots.double[0] else ("neighbours", first.sqrt())
    return Nutation(roots, kind, complement, ratio, scale, used, _without(roots, used))


def _distance(x: arb | acb, lower: arb, upper: arb) -> arb:
    """The size of the ellipse with foci at the turning points through x, less that of the least.

    What is left next to them.
    """
    return (abs(x - lower) + abs(x - upper) - (upper - lower)).mid()


def _without(roots: Roots, used: tuple[acb, ...]) -> list[tuple[acb, int]]:
    """The other roots, each of those used counted once less."""
    rest = []
    for x, m in roots.others:
        left = m - sum(x.overlaps(y) for y in used)
        rest += [(x, left)] if left else []
    return rest
