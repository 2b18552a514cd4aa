"""Decides points that gyroscopic forces alone stabilise together: the sign of D4 in arrays of balls.

D4 by averages is recorded once for an equilibrium, and repeated at all points.
"""
import operator
from collections.abc import Mapping, Sequence
from functools import partial, reduce
from typing import Any, NamedTuple

import numpy as np
from flint import fmpq
from sympy import Expr, Rational, Symbol

from ..._cached import cached_property
from ...algebra.enclosures.arithmetic import Arithmetic, in_arithmetic
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.rings.series import Series, composed
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.potential import DIRECTIONS
from ...notation import jet
from ...stability.normal_forms.d4_by_averages import averages
from ...stability.normal_forms.local_motion import data_of
from ...stability.normal_forms.orbit_chart import energy_on_orbit
from ...stability.normal_forms.windows import resonance_margins
from ...stability.report.report import Report
from ..grids import Grid
from .ball_arrays import BallArray, near
from .computation import Computation
from .recorded import Recorded, Recording


class Twists(NamedTuple):
    """Signs at points: 1 or −1 if proved, else 0.

    Parameters
    ----------
    D4 : array of int8
        0 if a resonance to order 4, or a real eigenvalue or 0, is not excluded
    double : array of int8
        the sign of the margin of 1:2, at which D4 has a pole; 0 if a real eigenvalue or 0 is not excluded
    """

    D4: Array
    double: Array


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
    return twists(report, {s: leaf(grid, s) for s in grid.values}, max(grid.shape)).D4


def twists(report: Report, given: Mapping[Symbol, BallArray], count: int) -> Twists:
    """Return the signs of D4 and of the margin of 1:2, over all numbers of the balls."""
    found = Twists(*np.zeros((2, count), np.int8))
    for at, computation, balls in _parted(report.equilibrium, given, count):
        p, q, discriminant, double, triple, product = computation.balls(balls, len(at))
        oscillates = p.positive() & q.positive() & discriminant.positive()
        found.double[at] = double.sign() * oscillates
        found.D4[at] = product.sign() * found.double[at] * triple.excludes_zero()
    return found


def twist_times_pole(report: Report, given: Mapping[Symbol, BallArray], count: int) -> Array:
    """Return a positive multiple of D4 times the margin of 1:2, which has no pole, in doubles; or NaN."""
    found = np.full(count, np.nan)
    for at, computation, balls in _parted(report.equilibrium, given, count):
        found[at] = computation.doubles({s: x.middle for s, x in balls.items()})[-1]
    return found


def _parted(eq: Equilibrium, given: Mapping[Symbol, BallArray],
            count: int) -> list[tuple[Array, Computation, dict[Expr, BallArray]]]:
    """Return the points that have the same axis farthest from k, what to compute there, and their numbers.

    There are none if D4 is no fraction of polynomials in the names that are given.
    """
    recorded = _D4(eq)
    if recorded.directions is None:
        return []
    if (numbers := _numbers(recorded.directions, given)) is None:
        return []
    k = recorded.directions.doubles({s: x.middle for s, x in numbers.items()})
    smallest = np.argmin(np.abs([np.broadcast_to(x, count) for x in k]), axis=0)
    found = []
    for upright in range(3):
        at = np.flatnonzero(smallest == upright)
        if at.size and (numbers := _numbers(computation := recorded.about(upright), given)) is not None:
            found.append((at, computation, {s: _cut(x, at) for s, x in numbers.items()}))
    return found


def _numbers(computation: Computation, given: Mapping[Symbol, BallArray]) -> dict[Expr, BallArray] | None:
    """Return the balls of the names and constants that are read; None if a name has none."""
    constants = {x: near(np.array([float(ball(x, 128).mid())]), False)
                 for x in computation.leaves if not x.free_symbols}
    known: dict[Expr, BallArray] = {**given, **constants}
    return {x: known[x] for x in computation.leaves} if computation.leaves <= known.keys() else None


@once
class _D4:
    """D4 at an equilibrium of a body in one field, recorded in the names that its numbers depend on.

    Parameters
    ----------
    equilibrium : Equilibrium
    """

    def __init__(self, equilibrium: Equilibrium):
        self.equilibrium = equilibrium
        self.recorded: dict[int, Computation] = {}

    @cached_property
    def directions(self) -> Computation | None:
        """Computes k; None if D4 is no fraction of polynomials."""
        potential, recording = self.equilibrium.system.potential, Recording()
        if (potential is None or potential.coupled or not potential.given
                or not potential.expression.is_rational_function(*DIRECTIONS)):
            return None
        try:
            names = _names(self.equilibrium, recording)
            _number(potential.expression, recording, names)
            return recording.computation([_number(x, recording, names) for x in data_of(self.equilibrium)[3]])
        except NotImplementedError:
            return None

    def about(self, upright: int) -> Computation:
        """Return what computes p, q, p² − 4q, the margins of 1:2 and 1:3, and D4 times that of 1:2.

        The last is a positive multiple, if p, q and p² − 4q are positive.
        """
        if upright not in self.recorded:
            eq, recording = self.equilibrium, Recording()
            names, potential = _names(eq, recording), eq.system.potential
            assert potential is not None
            inverse, rotor, pi, k = ([_number(x, recording, names) for x in part] for part in data_of(eq)[:4])

            def field(places: Sequence[Series]) -> Series:
                return composed(potential.expression, dict(zip(DIRECTIONS, places)),
                                lambda x: _number(x, recording, names))

            parts = energy_on_orbit([inverse[3 * i:3 * i + 3] for i in range(3)], rotor, k,
                                    [x + y for x, y in zip(pi, rotor)], field, upright, 4)
            p, q, top, _ = averages(parts)
            (_, _, double), (_, _, triple) = resonance_margins(p, q)
            # the bottom has the sign of the margin of 1:2, but for h3 = 0, where it is positive
            product = top if parts[3] else top * double
            self.recorded[upright] = recording.computation([p, q, p**2 - 4 * q, double, triple, product])
        return self.recorded[upright]


def _names(eq: Equilibrium, recording: Recording) -> dict[Symbol, Recorded]:
    """Return the names that relations express by others, recorded."""
    names: dict[Symbol, Recorded] = {}
    for name, value in eq.relations:
        if not jet(name.name):
            names[name] = _number(eq.insert(value), recording, names)
    return names


def _number(expression: Expr, recording: Recording, names: Mapping[Symbol, Recorded]) -> Recorded:
    """Record a fraction of polynomials in names; a constant that is no fraction is a leaf, too."""
    def leaf(node: Expr) -> Any:
        if isinstance(node, Rational):
            return recording.constant(fmpq(int(node.p), int(node.q)))
        if node.free_symbols and not isinstance(node, Symbol):
            return NotImplemented
        return names[node] if node in names else recording.leaf(node)

    def power(base: Recorded, exponent: Rational) -> Recorded:
        if not exponent.is_Integer:
            raise NotImplementedError
        return base**int(exponent) if exponent > 0 else 1 / base**-int(exponent)

    def function(node: Expr, parts: Sequence[Recorded]) -> Recorded:
        raise NotImplementedError

    return in_arithmetic(expression, Arithmetic(leaf, partial(reduce, operator.add),
                                                partial(reduce, operator.mul), power, function))


def leaf(grid: Grid, name: Symbol) -> BallArray:
    """Return the numbers of a name as balls, doubles or near doubles."""
    return near(np.asarray(grid.values[name], float).ravel(), name not in grid.exact)


def _cut(x: BallArray, at: Array) -> BallArray:
    """Return the balls of some points, or the one of all."""
    return x if x.middle.size == 1 else BallArray(x.middle[at], x.radius[at])
