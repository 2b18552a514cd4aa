"""Says in sentences, with decimals and units, at which speeds of a wheel an attitude is stable.

Ends of what is proved are rounded inwards, so that every sentence is true as it stands.
"""
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN
from typing import Any

from sympy import oo, pi

from ...algebra.reals.exact import sign_of_constant
from ...parameters.sets import Interval
from ...parameters.wheel_speeds import SpeedSets, WheelSpeeds, unit_size
from ..blocks import Block, Sentence, joined, listed, sentence
from ..numbers import ALONE, in_sentence, rounded

MORE = 20                                              # digits at most with which two ends are told apart
_KINDS = {"stable": "Stable for ", "unstable": "Unstable for ", "undecided": "Nothing is proved for "}


def speeds_blocks(found: WheelSpeeds) -> list[Block]:
    """Say where it is stable, and where with damping; then what holds the attitude."""
    if found.only is not None:
        speed = _with_unit(in_sentence(found.only / unit_size(found.unit)), found)
        undamped = _at_a_point(found.undamped).capitalize()
        return [sentence(f"{undamped} at the one speed that holds the attitude, ", *speed,
                         f"; with internal damping {_at_a_point(found.damped)}."),
                sentence("No other speed holds it, because the axis of the wheel is not along the normal of "
                         "the orbit."), *_turned(found)]
    damped = joined("; ", [(title.lower(), *_ranges(found, kind, found.damped))
                           for kind, title in _kinds(found.damped)])
    return [*(sentence(title, *_ranges(found, kind, found.undamped), ".")
              for kind, title in _kinds(found.undamped)),
            sentence("With internal damping: ", *damped, "."), *_turned(found), _carried(found)]


def _kinds(sets: SpeedSets) -> list[tuple[str, str]]:
    """Name the sets that are not empty, that of stability always."""
    return [(kind, title) for kind, title in _KINDS.items() if kind == "stable" or getattr(sets, kind)]


def _at_a_point(sets: SpeedSets) -> str:
    return "stable" if sets.stable else "unstable" if sets.unstable else "undecided"


def _ranges(found: WheelSpeeds, kind: str, sets: SpeedSets) -> tuple[Any, ...]:
    """Write a union of intervals: a wheel speed above 3 rpm or between 1 and 2 rpm."""
    intervals, noun = getattr(sets, kind), "wheel speed" if found.unit else found.name
    if not intervals:
        return (f"no {noun}",)
    if intervals[0].low == -oo and intervals[0].high == oo:
        return (f"every {noun}",)
    several = joined(" or ", [_range(i, found, kind != "undecided") for i in intervals])
    return (f"a {noun} " if found.unit else f"{noun} ", *several)


def _range(i: Interval, found: WheelSpeeds, inwards: bool) -> tuple[Any, ...]:
    size = unit_size(found.unit)
    low, high = i.low / size, i.high / size
    if i.low == i.high:
        return ("of exactly ", *_with_unit(in_sentence(low), found))
    up, down = (ROUND_CEILING, ROUND_FLOOR) if inwards else (ROUND_FLOOR, ROUND_CEILING)
    if i.low == -oo:
        return ("below ", *_with_unit(rounded(high, down), found))
    if i.high == oo:
        return ("above ", *_with_unit(rounded(low, up), found))
    digits = ALONE
    while digits < MORE and rounded(low, ROUND_CEILING, digits) == rounded(high, ROUND_FLOOR, digits):
        digits += 1
    return ("between ", rounded(low, up, digits), " and ", *_with_unit(rounded(high, down, digits), found))


def _with_unit(number: Any, found: WheelSpeeds) -> tuple[Any, ...]:
    return (number, f" {found.unit}") if found.unit else (number,)


def _turned(found: WheelSpeeds) -> list[Block]:
    """Say that another attitude is meant than the one that was asked for."""
    if found.turn == 0:
        return []
    angle = rounded(found.turn * 180 / pi, ROUND_HALF_EVEN)
    return [sentence("This is said of the body turned by ", angle, " degrees about the normal of the orbit, "
                     "its axis along the velocity towards the vertical. As it was asked for, wheels do not "
                     "hold it, because the gravity gradient turns it about the normal: t·I r is not 0.")]


def _carried(found: WheelSpeeds) -> Sentence:
    """Say which momentum holds the attitude beside this wheel."""
    if not any(map(sign_of_constant, found.carried)):
        return sentence("Each speed holds the attitude, because the axis of the wheel is along the normal of "
                        "the orbit, and nothing is missing across it.")
    momentum = [rounded(x, ROUND_HALF_EVEN) for x in found.carried]
    unit = " N m s" if found.unit else ""
    return sentence("Each speed holds the attitude if other wheels carry besides the momentum (",
                    *listed(momentum), f"){unit}, in body axes; along the normal of the orbit it is free.")
