"""Moves k3 between two turning points by elliptic functions of a variable u, in which time is smooth.

It is smooth however close other roots of g lie.
"""
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from flint import acb, arb

from ..._cached import cached_property
from ..elliptic import Landen, argument, jacobi, jacobi_ball, landen, means, quarter_period, raised
from ..periods import double
from .turning_points import Roots


class Squares(NamedTuple):
    """The products c², s² and s c of the angle of a nutation, and its rate in u."""

    cosine: Any
    sine: Any
    mixed: Any
    turn: Any


@dataclass(frozen=True)
class Nutation:
    """The motion z = c² lower + s² upper with s² + c² = 1, where s : c is a ratio of elliptic functions of u.

    They are such that dz/√abs(q(z)) is scale · du for a quartic q. The roots of q are the turning points and
    the two other roots of g nearest to them: neighbours on the real line, or a conjugate pair. If q is all of
    g, u is proportional to time; if not, g/q is smooth.

    Parameters
    ----------
    roots : Roots
    kind : str
        "neighbours", from the lower end; "neighbours above", from the upper end; "pair"; "passage" from one
        double root to another
    complement : arb
        m1 of the elliptic functions
    ratio : arb
        the factor of s : c in them
    scale : arb
        the factor of du
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
        """The u from one turning point to the other; None if one of them is not reached."""
        return None if any(self.roots.double) else quarter_period(self.complement)

    @cached_property
    def _steps(self) -> list[tuple[arb, arb]]:
        return means(self.complement) if self.complement != 0 else []

    @cached_property
    def _doubles(self) -> tuple[float, float]:
        return double(self.complement), double(self.ratio)

    @cached_property
    def landen(self) -> Landen | None:
        """The steps of the elliptic functions in doubles; None for hyperbolic functions."""
        return None if self._doubles[0] == 0 else landen(self._doubles[0])

    def shape(self, u: arb) -> tuple[arb, arb, arb]:
        """Return s, c, and d(atan(s/c))/du."""
        if self.kind == "passage":
            half = u.tanh()
            s, c = ((1 + half) / 2).sqrt(), ((1 - half) / 2).sqrt()
            return s, c, s * c
        s, c, turn = self._sides(*jacobi_ball(u, self.complement, self._steps), self.complement, self.ratio)
        square = s * s + c * c
        return s / square.sqrt(), c / square.sqrt(), turn / square

    def squares(self, u: Any, half: Any) -> Squares:
        """Return c², s² and s c, and d(atan(s/c))/du, in doubles.

        Parameters
        ----------
        u : float or array
            abs(u) ≤ K
        half : pair of floats or arrays
            cosine and sine of π u/2K, if there are landen steps

        Returns
        -------
        Squares
        """
        if self.kind == "passage":
            end, middle = np.tanh(u), 0.5 / np.cosh(np.clip(u, -710, 710))
            return Squares((1 - end) / 2, (1 + end) / 2, middle, middle)
        m1, ratio = self._doubles
        sn, cn, dn = jacobi(u, m1) if self.landen is None else raised(half[0], half[1], self.landen)
        s, c, turn = self._sides(sn, cn, dn, m1, ratio)
        cosine, sine = c * c, s * s
        scale = 1 / (cosine + sine)
        return Squares(cosine * scale, sine * scale, s * c * scale, turn * scale)

    def _sides(self, sn: Any, cn: Any, dn: Any, m1: Any, ratio: Any) -> tuple[Any, Any, Any]:
        """Return s and c up to a common factor, and the rate of their angle times its square."""
        if self.kind == "pair":
            square = cn * cn
            return ratio * sn * dn, cn, ratio * (square * square + m1 * sn * sn * (1 + square))
        if self.kind == "neighbours above":
            return cn, -ratio * sn, ratio * dn
        return ratio * sn, cn, ratio * dn

    def start(self, s: arb, c: arb) -> arb:
        """Return the u at which sin and cos of the angle are s and c, c ≥ 0."""
        if self.kind == "passage":
            return (s / c).log()
        if self.kind == "neighbours above":
            return -argument(c / self.ratio, abs(s), self.complement) * (1 if s >= 0 else -1)
        side, y = (-1 if s < 0 else 1), abs(s) / self.ratio
        if self.kind == "pair":
            return side * argument(2 * y * c, c * c - y * y, self.complement) / 2
        return side * argument(y, c, self.complement)

    def quartic(self, z: arb, double: bool) -> arb:
        """Return abs(q(z)); at a double root, half of its second derivative."""
        value, left = arb(1), 2 if double else 0
        for x in (acb(self.roots.lower), acb(self.roots.upper), *self.used):
            if left and x.overlaps(acb(z)):
                left -= 1
            else:
                value *= abs(z - x)
        return value


def nutation(roots: Roots) -> Nutation:
    """Return the elliptic functions that suit the roots.

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
    """Return the size of the ellipse through x with foci at the turning points, less that of the least.

    It is 0 between the turning points, and next to one of them about twice the distance from it.
    """
    return (abs(x - lower) + abs(x - upper) - (upper - lower)).mid()


def _without(roots: Roots, used: tuple[acb, ...]) -> list[tuple[acb, int]]:
    """Return the other roots, each of those used counted once less."""
    rest = []
    for x, m in roots.others:
        left = m - sum(x.overlaps(y) for y in used)
        rest += [(x, left)] if left else []
    return rest
