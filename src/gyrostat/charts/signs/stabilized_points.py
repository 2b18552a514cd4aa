"""Decides points that gyroscopic forces alone stabilise together: D4 in arrays of balls.

It is Birkhoff's normal form of the fourth degree, computed for all points at once.
"""
import operator
from collections.abc import Callable, Mapping, Sequence
from functools import partial, reduce
from typing import Any

import numpy as np
from sympy import Expr, Rational, Symbol

from ...algebra.enclosures.arithmetic import Arithmetic, in_arithmetic
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.rings.series import Series, composed
from ...mechanics.scenes.potential import DIRECTIONS
from ...notation import jet
from ...stability.normal_forms.birkhoff import Modes, characteristic, linear_motion, modes, normalised, twist
from ...stability.normal_forms.local_motion import data_of
from ...stability.normal_forms.orbit_chart import energy_on_orbit
from ...stability.normal_forms.windows import resonance_margin, resonances_up_to
from ...stability.report.report import Report
from ..grids import Grid
from .ball_arrays import BallArray, near

Number = Callable[[Expr], BallArray]


def held(report: Report, grid: Grid) -> Array:
    """Return the sign of D4, if no resonance to order 4 holds, and no eigenvalue is real or 0.

    A point is stable if it is not 0. It is 0 if that is not proved in doubles.

    Parameters
    ----------
    report : Report
        of a body in a field
    grid : Grid
        with one axis

    Returns
    -------
    array of int8, shape of the grid
    """
    return twists(report, {s: leaf(grid, s) for s in grid.values}, max(grid.shape))[0].sign()


def twists(report: Report, given: Mapping[Symbol, BallArray], count: int) -> tuple[BallArray, BallArray]:
    """Return D4 and the margin of 1:2, over all numbers of the balls.

    D4 is known where no resonance to order 4 holds, the margin where no eigenvalue is real or 0; elsewhere
    the radius is infinite. D4 has poles only where that margin is 0.
    """
    eq = report.equilibrium
    potential = eq.system.potential
    found = [BallArray(np.zeros(count), np.full(count, np.inf)) for _ in range(2)]
    if potential is None or potential.coupled:
        return found[0], found[1]
    if not potential.given or not potential.expression.is_rational_function(*DIRECTIONS):
        return found[0], found[1]
    names = dict(given)
    try:
        for name, value in eq.relations:
            if not jet(name.name):
                names[name] = _evaluated(eq.insert(value), names)
        inverse, rotor, pi, k, _ = ([_evaluated(x, names) for x in part] for part in data_of(eq))
        _evaluated(potential.expression, names | dict.fromkeys(DIRECTIONS, BallArray(1.0)))
    except (NotImplementedError, KeyError):
        return found[0], found[1]
    shape = (count,)
    spread = [BallArray(np.broadcast_to(x.middle, shape), np.broadcast_to(x.radius, shape))
              for x in (*inverse, *rotor, *pi, *k)]
    smallest = np.argmin([abs(x.middle) for x in spread[-3:]], axis=0)
    for upright in range(3):
        at = np.flatnonzero(smallest == upright)
        if at.size:
            here = {s: _cut(x, at, shape) for s, x in names.items()}
            numbers = [_cut(x, at, shape) for x in spread]
            for whole, part in zip(found, _twists(numbers, potential.expression, here, upright)):
                whole.middle[at], whole.radius[at] = part.middle, part.radius
    return found[0], found[1]


def _twists(numbers: list[BallArray], U: Expr, names: dict[Symbol, BallArray],
            upright: int) -> list[BallArray]:
    """Return the same at points that have the same axis farthest from k."""
    inverse = [numbers[3 * i:3 * i + 3] for i in range(3)]
    rotor, pi, k = (numbers[n:n + 3] for n in (9, 12, 15))
    momentum = [x + y for x, y in zip(pi, rotor)]

    def field(places: Any) -> Series:
        return composed(U, dict(zip(DIRECTIONS, places)), lambda x: _evaluated(x, names))

    with np.errstate(all="ignore"):
        parts = energy_on_orbit(inverse, rotor, k, momentum, field, upright, 4)
        A = linear_motion(parts[2])
        p, q = characteristic(A)
        discriminant = p**2 - 4 * q
        proved = p.positive() & q.positive() & discriminant.positive()
        double = resonance_margin(p, q, 1, 2).where(proved)
        for pair in resonances_up_to(4):                   # Arnold's theorem asks for none of them
            proved = proved & resonance_margin(p, q, *pair).excludes_zero()
        unknown = double.where(np.zeros_like(proved))
        if not proved.any():
            return [unknown, double]
        root = discriminant.sqrt()
        square = (p + root) * 0.5
        values = square.sqrt().turned(), (q / square).sqrt().turned()
        try:
            found: Modes = modes(A, p, values)
        except ZeroDivisionError:
            return [unknown, double]
        return [twist(normalised(parts, found)[4], found).real.where(proved), double]


def leaf(grid: Grid, name: Symbol) -> BallArray:
    """Return the numbers of a name as balls, doubles or near doubles."""
    return near(np.asarray(grid.values[name], float).ravel(), name not in grid.exact)


def _cut(x: BallArray, at: Array, shape: tuple[int, ...]) -> BallArray:
    """Return the balls of some points."""
    if x.middle.size == 1 and shape != (1,):
        return x
    return BallArray(x.middle[at], x.radius[at])


def _evaluated(expression: Expr, names: dict[Symbol, BallArray]) -> BallArray:
    """Return a fraction of polynomials in names, with constants of any kind, in balls."""
    def leaf(node: Expr) -> BallArray:
        if isinstance(node, Symbol):
            return names[node]
        if node.free_symbols:
            return NotImplemented
        value = float(ball(node, 128).mid())
        return near(value, node == Rational(value))

    def power(base: BallArray, exponent: Rational) -> BallArray:
        if not exponent.is_Integer:
            raise NotImplementedError
        return base**int(exponent) if exponent > 0 else 1 / base**-int(exponent)

    def function(node: Expr, parts: Sequence[BallArray]) -> BallArray:
        raise NotImplementedError

    return in_arithmetic(expression, Arithmetic(leaf, partial(reduce, operator.add),
                                                partial(reduce, operator.mul), power, function))
