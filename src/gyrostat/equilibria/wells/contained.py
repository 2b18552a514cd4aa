"""Whether a state lies in a well: by its energy, and by a proved path down to the minimum."""
from collections.abc import Sequence
from typing import Any

from flint import arb

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.text.numbers import exact_expression
from ...errors import ValuesError
from ...mechanics.scenes.kind import Kind
from ..relative_equilibrium import RelativeEquilibrium
from .in_balls import BITS, dot, form, in_balls, rows_in_balls
from .landscape import quaternion
from .paths import Paths

NEAR = 1e-6                                            # a state of doubles is none of the level exactly


def contained(rotation: RelativeEquilibrium, paths: Paths, height: arb, state: Sequence[Any]) -> bool | None:
    """Tell whether a state lies in the well of a rotation, below a value of V.

    Raises
    ------
    ValuesError
        the state has other coordinates, or is not near the level
    """
    names = rotation.scene.space.coordinates
    if len(state) != len(names):
        raise ValuesError(f"the state has {len(state)} numbers: give {', '.join(map(str, names))}")
    exact = [exact_expression(value, str(name)) for name, value in zip(names, state)]
    return inside(rotation, paths, height, [ball(x, BITS) for x in exact])


def inside(rotation: RelativeEquilibrium, paths: Paths, height: arb, state: list[arb]) -> bool | None:
    """Tell the same of a state in balls."""
    with own_precision(BITS):
        place, excess = _rest(rotation, state)
        energy = paths.landscape.value(place) + excess
        if not energy < height:
            return False if energy >= height else None
    end = paths.down(place, height)
    return None if end is None else end == paths.landscape.number(rotation)


def _rest(rotation: RelativeEquilibrium, x: list[arb]) -> tuple[list[arb], arb]:
    """Where V is asked for, and how much of the energy is above V there."""
    scene, pi = rotation.scene, x[:3]
    rotor, tensor = in_balls(scene.body.gyrostatic_momentum), rows_in_balls(scene.body.tensor)
    M = [a + b for a, b in zip(pi, rotor)]
    if scene.kind is Kind.FREE:
        known = in_balls(rotation.momentum)
        _check("M·M", dot(M, M), dot(known, known), dot(known, known))
        return M, arb(0)
    first, last, one = x[3:6], x[-3:], arb(1)
    along = _unit(first)
    if scene.kind is Kind.ORBIT:
        for name, value, wanted in (("n·n", dot(first, first), one), ("r·r", dot(last, last), one),
                                    ("n·r", dot(first, last), one - 1)):
            _check(name, value, wanted, one)
        up = _unit([b - dot(along, last) * a for a, b in zip(along, last)])
        place, rate, level = quaternion(along, up), ball(rotation.rates["omega0"], BITS), None
    else:
        _check("k·k", dot(first, first), one, one)
        k = in_balls(rotation.directions[0])
        level = ball(rotation.rates["omega"], BITS) * form(tensor, k) + dot(rotor, k)
        _check("C1 = M·k", dot(M, along), level, sum(map(abs, (*M, level)), arb(0)))
        place, rate = along, (level - dot(rotor, along)) / form(tensor, along)
    turning = [p - rate * dot(row, along) for p, row in zip(pi, tensor)]
    if level is not None:
        turning = [a - dot(turning, along) * b for a, b in zip(turning, along)]
    return place, form(rows_in_balls(scene.body.inverse), turning) / 2


def _check(name: str, value: arb, wanted: arb, scale: arb) -> None:
    if not abs(value - wanted) <= NEAR * scale:
        raise ValuesError(f"the state has {name} = {float(value.mid()):.6g}, and here it is "
                          f"{float(wanted.mid()):.6g}: give a state of the level of this equilibrium")


def _unit(vector: list[arb]) -> list[arb]:
    length = dot(vector, vector).sqrt()
    return [c / length for c in vector]
