"""Proves the turning points: the roots of g between which a body of revolution in U(k3) nutates.

Roots of a polynomial g are isolated at once; those of another function by bisection, and both by Newton's
method in balls.
"""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb, arb, arb_poly, ctx, fmpq, fmpq_poly
from sympy import sqrt

from ...algebra.rings.enclosed_roots import divided_by_root
from ...algebra.solving.root_numbers import refuse_close, refuse_touching
from ...errors import AccuracyError, ScopeError
from .level import Level, enclosed
from .profiles import Profile

FOLLOWED = 24                                              # coefficients of a polynomial that stands for g
# a root that is so many times closer than the interval is long is not known well from it
CLOSE = 50
KNOWN = 64                                                 # bits of g from which such a polynomial is made


@dataclass(frozen=True)
class Roots:
    """The real line around a motion: lower ≤ k3 ≤ upper, and the other roots of g.

    Parameters
    ----------
    lower, upper : arb
    double : (bool, bool)
        whether they are double roots, which are approached and not reached
    others : list of (acb, int)
        the other roots with multiplicity; if g is no polynomial, they are approximate and not all
    leading : arb or None
        the leading coefficient of a polynomial g
    """

    lower: arb
    upper: arb
    double: tuple[bool, bool]
    others: list[tuple[acb, int]]
    leading: arb | None


def roots_of(level: Level) -> Roots:
    """Return the roots of g between which k3 moves and those around, at the precision of flint.ctx.

    Raises
    ------
    ScopeError
        the motion approaches a root of third or higher order, so slowly that no exponential describes it
    AccuracyError
        two roots are not told apart at this precision
    """
    if level.polynomial is None:
        found, ends = _of_function(level)
    else:
        found = _of_polynomial(level, level.polynomial)
        ends = _ends(level, found)
    (lower, m), (upper, n) = ends
    if max(m, n) > 2:
        raise ScopeError(f"k3 approaches a root of order {max(m, n)} of g: its motion is neither periodic "
                         "nor exponential")
    others = [(x, k) for x, k in found if not (x.imag == 0
                                               and (x.real.overlaps(lower) or x.real.overlaps(upper)))]
    highest = next((c for c in reversed(level.polynomial or ()) if c != 0), None)
    return Roots(lower, upper, (m == 2, n == 2), others, None if highest is None else enclosed(highest))


def _ends(level: Level, found: Sequence[tuple[acb, int]]) -> list[tuple[arb, int]]:
    """Return the two of all roots between which the motion is."""
    z = enclosed(level.height)
    at_start = level.direction == 0
    ends: list[tuple[arb, int]] = []
    for side in (-1, 1):
        if at_start and level.turn == -side:
            ends.append((z, 1))
            continue
        beyond = [(x.real, m) for x, m in found if x.imag == 0 and not x.real.overlaps(z)
                  and (x.real > z) == (side > 0)]
        near = [x for x, _ in found if x.imag == 0 and x.real.overlaps(z)]
        if not beyond or len(near) > at_start:
            raise AccuracyError(f"the turning points around k3 = {level.height} are not told apart")
        ends.append(min(beyond, key=lambda pair: abs(pair[0] - z).mid()))
    return ends


def _of_polynomial(level: Level, g: Sequence[Any]) -> list[tuple[acb, int]]:
    """Return all roots with their multiplicities."""
    if isinstance(g[0], fmpq):
        whole = fmpq_poly(g).numer()
        refuse_close(whole)
        refuse_touching(whole)
        return [(acb(x), m) for x, m in fmpq_poly(g).complex_roots()]
    left, poles = [enclosed(c) for c in g], []
    for side, m in zip((-1, 1), level.contact):
        pole = side * enclosed(level.square_radius).sqrt()
        poles += [(acb(pole), m)] if m else []
        for _ in range(m):
            left = divided_by_root(left, pole)
    return poles + [(x, 1) for x in _simple(arb_poly(left))]


def _simple(polynomial: arb_poly) -> list[acb]:
    """Return the simple roots of a polynomial, by Newton's method in balls.

    The imaginary part of real ones is exactly 0.
    """
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


def _of_function(level: Level) -> tuple[list[tuple[acb, int]], list[tuple[arb, int]]]:
    """Return other roots, approximately; and the turning points."""
    g, ends = Profile(level), list[tuple[arb, int]]()
    for side, m in zip((-1, 1), level.contact):
        if level.direction == 0 and level.turn == -side:
            ends.append((enclosed(level.height), 1))
        elif (root := _first(level, g, side, m)) is not None:
            ends.append((root, 1))
        else:
            ends.append((side * g.radius, m))
    if not ends[0][0] < ends[1][0]:
        raise AccuracyError(f"the turning points around k3 = {level.height} are not told apart")
    return [(x, 1) for x in _around(g, ends)], ends


def _first(level: Level, g: Profile, side: int, m: int) -> arb | None:
    """Return the root of g nearest to the start on the way to a pole.

    It is isolated by bisection, then enclosed by Newton's method. It is None if there is none before the
    pole, a root itself of order m.
    """
    def value(x: arb) -> arb:
        return g(x) if m == 0 else g.divided(x, side)

    def slope(x: arb) -> arb:
        return g(x, 1) if m == 0 else g.divided(x, side, 1)

    start, way = enclosed(level.height), enclosed(side * sqrt(level.square_radius) - level.height)
    cells = [(fmpq(0), fmpq(1))]
    while cells:
        low, high = cells.pop()
        x = start + way * arb(low).union(arb(high))
        middle, end = start + way * (low + high) / 2, start + way * high
        steep = side * slope(x)                            # > 0: g grows on the way
        if value(middle) + side * steep * (x - middle) > 0 or (steep < 0 and value(end) > 0):
            continue                                       # g is positive here
        if low == 0 and level.direction == 0 and steep > 0 or high == 1 and m == 2 and steep < 0:
            continue
        if steep < 0 and value(end) < 0:
            for _ in range(2 * ctx.prec.bit_length()):
                x = x.intersection(x.mid() - value(arb(x.mid())) / slope(x))
            if x.is_finite() and x.overlaps(side * g.radius):
                raise AccuracyError("a turning point is not told apart from the pole k3 = "
                                    f"{float(side * g.radius):g}")
            # the slope keeps its sign in the smaller balls, too
            if x.is_finite():
                return x
        if high - low < fmpq(1, 2 ** (ctx.prec // 2)):
            raise AccuracyError(f"the turning points around k3 = {level.height} are not told apart")
        cells += [((low + high) / 2, high), (low, (low + high) / 2)]
    return None


def _around(g: Profile, ends: Sequence[tuple[arb, int]]) -> list[acb]:
    """Return other roots, approximately.

    They are those of polynomials that interpolate g around the motion, and around what it almost meets.
    """
    (lower, _), (upper, _) = ends
    width = upper - lower
    others = _interpolated(g, lower - width / 8, upper + width / 8)
    # those that stand for the turning points themselves
    for x, m in ends:
        others = sorted(others, key=lambda y: abs(y - x).mid())[m:]
    for x, m in ends:
        beyond = x - 2 * g(x, 1) / g(x, 2)  # the other root of the parabola that touches g there
        if m == 1 and CLOSE * abs(beyond - x) < width:
            others += [] if any(abs(beyond - y) < abs(beyond - x) for y in others) else [acb(beyond)]
        others = _closer(g, x, m, others, width)
    for x in _beside(others, lower, upper):
        others = _closer(g, x, 0, others, CLOSE * _to_an_end(x, lower, upper) / 8)
    return [x for x in others if not (x.imag == 0 and lower < x.real < upper)]


def _beside(others: Sequence[acb], lower: arb, upper: arb) -> list[arb]:
    """Return where a pair is close to the motion, the closest last.

    Real roots in there are none of g: two of them stand for a pair that is closer than is known.
    """
    pairs = sorted((y for y in others if y.imag > 0 and 8 * y.imag < _to_an_end(y.real, lower, upper)),
                   key=lambda y: y.imag.mid(), reverse=True)
    split = sorted((y.real for y in others if y.imag == 0 and lower < y.real < upper), key=arb.mid)
    return [y.real for y in pairs] + [(x + y) / 2 for x, y in zip(split[::2], split[1::2])]


def _to_an_end(x: arb, lower: arb, upper: arb) -> arb:
    """Return the distance to the nearest turning point; negative outside."""
    return min(x - lower, upper - x, key=arb.mid)


def _closer(g: Profile, x: arb, m: int, others: list[acb], width: arb) -> list[acb]:
    """Return the others, those next to x found again.

    They are found on smaller and smaller intervals, until they are as far from it as an interval is long.
    """
    while CLOSE * (least := min((abs(y - x).mid() for y in others), default=width)) < width:
        width = max(8 * least, width / CLOSE, key=arb.mid).mid()
        around = sorted(_interpolated(g, x - width, x + width), key=lambda y: abs(y - x).mid())[m:]
        others = [y for y in others if abs(y - x).mid() > width / 2]
        others += [y for y in around if abs(y - x).mid() <= width / 2]
    return others


def _interpolated(g: Profile, low: arb, high: arb) -> list[acb]:
    """Return roots of the polynomial that interpolates g on an interval, as far as k3 can be there."""
    low, high = max(low, -g.radius, key=arb.mid), min(high, g.radius, key=arb.mid)
    middle, half = ((low + high) / 2).mid(), ((high - low) / 2).mid()
    nodes = [arb.cos_pi_fmpq(fmpq(2 * j + 1, 2 * FOLLOWED)) for j in range(FOLLOWED)]
    values = [g(middle + half * y) for y in nodes]
    if max(x.rel_accuracy_bits() for x in values) < KNOWN:
        raise AccuracyError(f"g is not known between {low} and {high}")
    fitted = arb_poly([0 if c.contains(0) else c.mid() for c in arb_poly.interpolate(nodes, values).coeffs()])
    return [middle + half * y for y in _simple(fitted)]
