"""The speeds of a wheel at which an attitude in orbit is stable, and the momentum that must hold it there.

An attitude fixes the momentum of the wheels across the normal n of the orbit, and leaves that along n free.
With λ = l·n/ω0 the question has the tensor alone in it, so that the ends are exact whatever the orbit is.
"""
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from sympy import Expr, ImmutableMatrix, S, Symbol

from .._display import Shown
from ..algebra.reals.exact import Point, proved_sign
from ..algebra.text.numbers import exact_number, shown
from ..algebra.text.quantities import units_in
from ..arguments import checked
from ..errors import EquilibriumError, ScopeError, ValuesError, brief
from ..mechanics.families.circular_orbit import (
    axes_of,
    by_gradient_alone,
    circular_orbit,
    earth_pointing,
    orbital_rate,
)
from ..mechanics.families.held_attitude import NAMES, turned_to_rest
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.functions_on_sphere import lowest
from ..mechanics.scenes.system import System, assemble, names_of_scene
from ..notation import Stored, symbol
from ..stability.report.analysis import analyze
from ..stability.report.report import Report
from .line_decomposition import Cell, cut, joined, stable_at
from .sets import Interval

LEVEL = symbol("l")                                    # l·n/ω0


@dataclass(frozen=True)
class SpeedSets:
    """The values of one name for which a verdict is STABLE, UNSTABLE and UNDECIDED.

    Parameters
    ----------
    stable, unstable, undecided : tuple of Interval
        in increasing order, with exact ends; together they cover every value at which the attitude is held

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((410, 580, 250), (0, gs.symbol("l"), 0))
    >>> speeds = gs.wheel_speeds(gs.assemble(body, gs.circular_orbit(1)), "l", unit="")
    >>> [(x.low, x.high) for x in speeds.damped.unstable]
    [(-oo, -170)]
    """

    stable: tuple[Interval, ...]
    unstable: tuple[Interval, ...]
    undecided: tuple[Interval, ...]


@dataclass(frozen=True, repr=False)
class WheelSpeeds(Shown, Stored):
    """The speeds of a wheel at which an attitude in orbit is stable, without damping and with it.

    Parameters
    ----------
    name : str
    unit : str
        in which speeds are printed; the numbers here are in SI
    undamped, damped : SpeedSets
        of the verdict without internal damping, and with it
    turn : Expr
        the angle by which the body is turned about n, t towards r, so that wheels can hold it; 0 if they can
        as it is [rad]
    carried : (Expr, Expr, Expr)
        the momentum that other wheels must have besides, in body axes [M L²/T]
    only : Expr or None
        the one speed that holds the attitude; None if every speed does

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((410, 580, 250), (0, gs.symbol("l"), 0))
    >>> speeds = gs.wheel_speeds(gs.assemble(body, gs.circular_orbit(1)), "l", unit="")
    >>> speeds.undamped.stable[0].low, speeds.carried, speeds.only
    (-170, (0, 0, 0), None)
    """

    name: str
    unit: str
    undamped: SpeedSets
    damped: SpeedSets
    turn: Expr
    carried: tuple[Expr, ...]
    only: Expr | None


@checked
def wheel_speeds(scene: System, name: str, roll: int = 1, pitch: int = 2, yaw: int = 3, *,
                 directions: Sequence[Sequence[Any]] | None = None, unit: str = "rpm") -> WheelSpeeds:
    """Return the speeds of a wheel at which an attitude in a circular orbit is stable or unstable.

    An attitude n, r, with t = n × r, is held if t·I r = 0, l·t = −ω0 t·I n and l·r = −4 ω0 r·I n; l·n is
    free. If t·I r is not 0, the body is turned about n until it is, by less than 45°. If the axis of the
    wheel is along n, every speed is possible, and what is missing of l·t and l·r is left to other wheels. If
    it is not, one speed at most holds the attitude.

    Parameters
    ----------
    scene : System
        a body in circular_orbit(), whose gyrostatic momentum has one name, that of the speed: of
        gyrostat_with_rotors with rate=gs.symbol("s"); its inertia and its orbit are numbers
    name : str
        of the speed, or of another name in which the momentum is linear
    roll, pitch, yaw : int
        the attitude, as in earth_pointing
    directions : (n, r)
        the attitude in their place: the normal of the orbit and the vertical, unit vectors in body axes, as
        RelativeEquilibrium.directions has them
    unit : str
        in which speeds are printed, "rpm" or another unit of the name; "": the numbers have no unit

    Returns
    -------
    WheelSpeeds
        undamped and damped have the intervals stable, unstable and undecided, with exact ends in SI; turn is
        the angle of the turn, carried the momentum of other wheels, only the one speed that holds it

    Raises
    ------
    ScopeError
        it is no orbit, or another field acts there, or a rotor is free
    EquilibriumError
        no speed of this wheel holds the attitude
    ValuesError
        another name is open, or the momentum is not linear in this one

    References
    ----------
    Derived; Hughes, Spacecraft Attitude Dynamics (1986), chapters 9 and 11.

    Examples
    --------
    >>> import gyrostat as gs
    >>> wheel = gs.Rotor((0, 1, 0), axial="0.01 kg m^2", rate=gs.symbol("s"))
    >>> body = gs.gyrostat_with_rotors("410, 580, 250 kg m^2", [wheel], lumped=True)
    >>> scene = gs.assemble(body, gs.circular_orbit(height="500 km"))
    >>> print(gs.wheel_speeds(scene, "s").undamped.stable[0].low.evalf(6))
    -18.8153
    """
    if not by_gradient_alone(scene):
        raise ScopeError("wheel_speeds is for a satellite in the gravity gradient of a circular orbit, "
                         "without another field and without a free rotor: give circular_orbit(), and the "
                         "rate of each wheel")
    unit_size(unit)
    rate, (still, slope) = orbital_rate(scene), _linear(scene, symbol(name))
    n, r = map(ImmutableMatrix, _attitude(directions) if directions else axes_of(roll, pitch, yaw)[1:])
    attitude = turned_to_rest(scene.body.tensor, n, r)
    along, missing = n.dot(slope), rate * attitude.across - _across(still, n)
    turning = _across(slope, n)
    only = None if _vanishes(turning) else _only(missing, turning)
    report, numbers = _held(), Point(attitude.numbers)

    def sets(damped: bool) -> SpeedSets:
        if only is not None:
            level = n.dot(still + only * slope) / rate
            cells = [(only, only, stable_at(report, LEVEL, level, numbers, damped))]
        else:
            cells = [_in_speeds(cell, n.dot(still), along, rate)
                     for cell in cut(report, LEVEL, numbers, None, None, damped=damped, doubt=True)]
            cells = cells if proved_sign(along) == 1 else cells[::-1]
        return SpeedSets(*(joined(cells, wanted) for wanted in (True, False, None)))

    return WheelSpeeds(name, unit, sets(False), sets(True), attitude.turn,
                       (S.Zero,) * 3 if only is not None else tuple(map(lowest, missing)), only)


@lru_cache(maxsize=1)
def _held() -> Report:
    """Return the report of an attitude that wheels hold, of an orbit of rate 1, in the names of its axes."""
    first, second, third, u, v = NAMES
    body = Gyrostat([[first, u, 0], [u, second, v], [0, v, third]], (-u, LEVEL, -4 * v))
    return analyze(earth_pointing(assemble(body, circular_orbit(1))))


def unit_size(unit: str) -> Expr:
    """Return the size of a unit in SI; 1 of ""."""
    found = units_in(unit) if unit else (S.One, None)
    if found is None:
        raise ValuesError(f"unit = {brief(unit)} is no unit: give one of speeds, 'rpm' or 'rad/s', or '' for "
                          "numbers without a unit")
    return found[0]


def _attitude(directions: Sequence[Sequence[Any]]) -> list[ImmutableMatrix]:
    """Return n and r, which must be orthogonal unit vectors."""
    if len(directions) != 2 or any(isinstance(a, str) or len(a) != 3 for a in directions):
        raise ValuesError(f"directions = {brief(directions)}: give the normal of the orbit and the vertical "
                          "in body axes, ((0, 1, 0), (0, 0, 1))")
    n, r = (ImmutableMatrix([exact_number(x, "direction") for x in a]) for a in directions)
    if any(map(proved_sign, (n.dot(n) - 1, r.dot(r) - 1, n.dot(r)))):
        raise ValuesError(f"directions = {brief(directions)} are not orthogonal unit vectors: write them "
                          "with fractions and roots, ((0, 3/5, 4/5), (1, 0, 0))")
    return [n, r]


def _linear(scene: System, x: Symbol) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Return the momentum of the wheels at x = 0, and what it grows by with x."""
    l = ImmutableMatrix(scene.body.gyrostatic_momentum)
    slope = l.diff(x)
    if open_ones := sorted(s.name for s in (names_of_scene(scene) | slope.free_symbols) - {x}):
        raise ValuesError(f"{', '.join(open_ones)} {'is' if len(open_ones) == 1 else 'are'} open beside {x}: "
                          "give a number for each other name")
    if x in scene.body.tensor.free_symbols | orbital_rate(scene).free_symbols | slope.free_symbols:
        raise ValuesError(f"the momentum of the wheels is not linear in {x} alone: give the speed of a wheel "
                          f"that name, Rotor(axis, axial, rate=symbol('{x}'))")
    if _vanishes(slope):
        raise ValuesError(f"no wheel has the speed {brief(x.name)[1:-1]}: give one that name, Rotor(axis, "
                          "axial, rate=symbol('s')), or speed=s in --wheel")
    return l.xreplace({x: S.Zero}), slope


def _across(v: ImmutableMatrix, n: ImmutableMatrix) -> ImmutableMatrix:
    """Return the part of a vector across the unit vector n."""
    return v - n.dot(v) * n


def _vanishes(v: ImmutableMatrix) -> bool:
    """Tell whether a vector is proved to be 0."""
    return not any(map(proved_sign, v))


def _only(missing: ImmutableMatrix, turning: ImmutableMatrix) -> Expr:
    """Return the one speed that gives what is missing across the normal."""
    speed = lowest(turning.dot(missing) / turning.dot(turning))
    if not _vanishes(missing - speed * turning):
        needed = ", ".join(shown(x, 12) for x in missing)
        raise EquilibriumError(f"no speed of this wheel holds the attitude: across the normal of the orbit "
                               f"the wheels need the momentum ({needed}) more, in body axes. Put this wheel "
                               "along the normal; then others carry what is missing across it")
    return speed


def _in_speeds(cell: Cell, still: Expr, along: Expr, rate: Expr) -> Cell:
    """Return a cell of the levels l·n/ω0 as one of speeds."""
    forward = proved_sign(along) == 1
    low, high = ((rate * end - still) / along if end.is_finite else end if forward else -end
                 for end in (cell[0], cell[1]))
    return (low, high, cell[2]) if forward else (high, low, cell[2])
