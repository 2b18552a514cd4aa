"""Turning points: between which roots of g a body of revolution in U(k3) nutates, proved."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb, arb, arb_poly, ctx, fmpq, fmpq_poly
from sympy import sqrt

from .errors import AccuracyError, ScopeError
from .levels import Level, enclosed
from .profiles import Profile

FOLLOWED = 24                                              # coefficients of a polynomial that stands for g
KNOWN = 64                                                 # bits of g from which they come


@dataclass(frozen=True)
class Roots:
    """The real line around a motion: lower ≤ k3 ≤ upper, and the other roots of g.

    Parameters
    ----------
    lower, upper : arb
    double : (bool, bool)                 whether they are double roots, which are approached and not reached
    others : list of (acb, int)           with multiplicity; where g is no polynomial, approximately and not all
    leading : arb or None                 coefficient of a polynomial g
    """

    lower: arb
    upper: arb
    double: tuple[bool, bool]
    others: list[tuple[acb, int]]
    leading: arb | None


def roots_of(level: Level) -> Roots:
    """The roots of g between which k3 moves and those around, at the precision of the moment (flint.ctx).

    Raises
    ------
    ScopeError        the motion approaches a root of third or higher order, so slowly that no exponential describes it
    AccuracyError     two roots are not told apart at this precision
    """
    found = _of_function(level) if level.polynomial is None else _of_polynomial(level, level.polynomial)
    z = enclosed(level.height)
    at_start = level.direction == 0
    ends: list[tuple[arb, int]] = []
    for side in (-1, 1):
        if at_start and level.turn == -side:
            ends.append((z, 1))
            continue
        beyond = [(x.real, m) for x, m in found if x.imag == 0 and not x.real.overlaps(z) and (x.real > z) == (side > 0)]
        near = [x for x, _ in found if x.imag == 0 and x.real.overlaps(z)]
        if not beyond or len(near) > at_start:
            raise AccuracyError(f"the turning points around k3 = {level.height} are not told apart")
        ends.append(min(beyond, key=lambda pair: abs(pair[0] - z).mid()))
    (lower, m), (upper, n) = ends
    if max(m, n) > 2:
        raise ScopeError(f"k3 approaches a root of order {max(m, n)} of g: its motion is neither periodic nor exponential")
    others = [(x, k) for x, k in found if not (x.imag == 0 and (x.real.overlaps(lower) or x.real.overlaps(upper)))]
    leading = None if level.polynomial is None else enclosed(next(c for c in reversed(level.polynomial) if c != 0))
    return Roots(lower, upper, (m == 2, n == 2), others, leading)


def _of_polynomial(level: Level, g: Sequence[Any]) -> list[tuple[acb, int]]:
    """All roots with their multiplicities."""
    if isinstance(g[0], fmpq):
        return [(acb(x), m) for x, m in fmpq_poly(g).complex_roots()]
    left, poles = [enclosed(c) for c in g], []
    for side, m in zip((-1, 1), level.contact):
        if m:
            poles.append((acb(side * enclosed(level.square_radius).sqrt()), m))
        for _ in range(m):
            left = _divided(left, side * enclosed(level.square_radius).sqrt())
    return poles + [(x, 1) for x in _simple(arb_poly(left))]


def _divided(coefficients: list[arb], root: arb) -> list[arb]:
    """The quotient by x − root, by Horner's rule."""
    quotient = [coefficients[-1]]
    for c in coefficients[-2:0:-1]:
        quotient.append(c + quotient[-1] * root)
    return quotient[::-1]


def _simple(polynomial: arb_poly) -> list[acb]:
    """The roots of a polynomial without multiple ones, by Newton's method in balls; of the real ones the imaginary part is 0."""
    try:
        isolated = polynomial.complex_roots(tol=arb(2) ** (-ctx.prec // 2), maxprec=8 * ctx.prec)
    except ValueError as error:
        raise AccuracyError(f"the roots of {polynomial} are not told apart") from error
    found, slope = [], polynomial.derivative()
    for x in map(acb, isolated):
        real = x.imag.contains(0)                          # conjugate to itself, for it is isolated
        x = acb(x.real) if real else x
        for _ in range(2):
            middle = acb(x.real.mid(), x.imag.mid())
            x = middle - polynomial(middle) / slope(x)
        found.append(acb(x.real) if real else x)
    return found


def _of_function(level: Level) -> list[tuple[acb, int]]:
    """The turning points, and the roots of a polynomial that follows g closely between them and around."""
    g, z, found = Profile(level), enclosed(level.height), list[tuple[acb, int]]()
    for side, m in zip((-1, 1), level.contact):
        if level.direction == 0 and level.turn == -side:
            found.append((acb(z), 1))
        elif (root := _first(level, g, side, m)) is not None:
            found.append((acb(root), 1))
        else:
            found.append((acb(side * g.radius), m))
    near = _around(g, found)
    for x, m in found:                                     # those that stand for the turning points themselves
        near = sorted(near, key=lambda y: abs(y - x).mid())[m:]
    return found + [(x, 1) for x in near]


def _first(level: Level, g: Profile, side: int, m: int) -> arb | None:
    """The root of g nearest to the start on the way to a pole; None: there is none before the pole, a root itself of order m."""
    def value(x: arb) -> arb:
        return g(x) if m == 0 else g.divided(x, side)

    def slope(x: arb) -> arb:
        return g(x, 1) if m == 0 else g.divided(x, side, 1)

    start, way = enclosed(level.height), enclosed(side * sqrt(level.square_radius) - level.height)
    cells = [(fmpq(0), fmpq(1))]
    while cells:
        low, high = cells.pop()
        x, middle, end = start + way * arb(low).union(arb(high)), start + way * (low + high) / 2, start + way * high
        steep = side * slope(x)                            # > 0: g grows on the way
        positive = value(middle) + side * steep * (x - middle) > 0 or (steep < 0 and value(end) > 0)
        if positive or (low == 0 and level.direction == 0 and steep > 0) or (high == 1 and m == 2 and steep < 0):
            continue
        if steep < 0 and value(end) < 0:
            for _ in range(2 * ctx.prec.bit_length()):
                x = x.intersection(x.mid() - value(arb(x.mid())) / slope(x))
            if x.overlaps(side * g.radius):
                raise AccuracyError(f"a turning point is not told apart from the pole k3 = {side * g.radius}")
            return x
        if high - low < fmpq(1, 2 ** (ctx.prec // 2)):
            raise AccuracyError(f"the turning points around k3 = {level.height} are not told apart")
        cells += [((low + high) / 2, high), (low, (low + high) / 2)]
    return None


def _around(g: Profile, ends: Sequence[tuple[acb, int]]) -> list[acb]:
    """Roots of the polynomial that interpolates g on an interval a little larger, and those next to the turning points."""
    lower, upper = (x.real for x, _ in ends)
    reach = (upper - lower) / 8
    low, high = max(lower - reach, -g.radius, key=arb.mid), min(upper + reach, g.radius, key=arb.mid)
    middle, half = ((low + high) / 2).mid(), ((high - low) / 2).mid()
    nodes = [arb.cos_pi_fmpq(fmpq(2 * j + 1, 2 * FOLLOWED)) for j in range(FOLLOWED)]
    values = [g(middle + half * y) for y in nodes]
    if max(x.rel_accuracy_bits() for x in values) < KNOWN:
        raise AccuracyError(f"g is not known between its roots {lower} and {upper}")
    fitted = arb_poly([0 if c.contains(0) else c.mid() for c in arb_poly.interpolate(nodes, values).coeffs()])
    near = [middle + half * y for y in _simple(fitted)]
    for x, m in ends:
        beyond = x - 2 * g(x.real, 1) / g(x.real, 2)       # of the parabola
        if m == 1 and beyond.is_finite() and 100 * abs(beyond - x) < upper - lower and not any(abs(beyond - y) < abs(y - x) for y in near):
            near.append(beyond)
    return [_sharpened(g, x, lower, upper) for x in near]


def _sharpened(g: Profile, x: acb, lower: arb, upper: arb) -> acb:
    """An approximate root that almost meets another: by the parabola at the extremum of g between the two."""
    end = min(lower, upper, key=lambda y: abs(x - y).mid())
    if not 100 * (abs(x.imag) if x.imag != 0 else abs(x.real - end)) < upper - lower:
        return x
    at = (x.real if x.imag != 0 else (x.real + end) / 2).mid()
    for _ in range(ctx.prec.bit_length()):
        at = (at - g(at, 1) / g(at, 2)).mid()
    offset = acb(-2 * g(at) / g(at, 2)).sqrt()
    if not offset.is_finite():
        return x
    return acb(at) + (offset if (x.imag if x.imag != 0 else x.real - at) > 0 else -offset)
