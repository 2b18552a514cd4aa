"""Reads quantities with units, as 120 kg m^2 or 3000 rpm: exact numbers in SI, their dimensions checked.

quantity := sum [unit (('*' | '/')? unit)*]
unit     := name ['**' integer]

A unit stands after a number; in the grammar of expressions no name does.
"""
from collections.abc import Iterable
from functools import lru_cache
from types import MappingProxyType
from typing import Any, NamedTuple

from sympy import Expr, Integer, Mul, Pow, Rational, S, pi

from ...errors import ExpressionError, ValuesError, brief
from ...notation import NOTATION, Use
from ...registry import free_letters, use_of
from .grammar import Parser
from .scanner import numeral

POWER, FACTORS = 9, 8                                  # of a unit, and of units, at most


class Dimension(NamedTuple):
    """The powers of mass, length and time in a quantity."""

    mass: int
    length: int
    time: int

    def __str__(self) -> str:
        """Return the unit in SI; an angle is a pure number."""
        return " ".join(f"{name}^{power}" if power != 1 else name
                        for name, power in zip(("kg", "m", "s"), self) if power) or "rad, or none"


NONE = Dimension(0, 0, 0)
_MASS, _LENGTH, _TIME, _RATE = (Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1),
                                Dimension(0, 0, -1))
_INERTIA, _MOMENTUM, _TORQUE = Dimension(1, 2, 0), Dimension(1, 2, -1), Dimension(1, 2, -2)
_FORCE = Dimension(1, 1, -2)
# of what is not in the table of notation
_BESIDE = MappingProxyType({
    "inertia": _INERTIA, "gyrostatic_momentum": _MOMENTUM, "axial": _INERTIA, "transverse": _INERTIA,
    "rate": _RATE, "momentum": _MOMENTUM, "M": _MOMENTUM, "C1": _MOMENTUM,
    "energy": _TORQUE, "axis": NONE, "orbit rate": _RATE, "orbit mu": Dimension(0, 3, -2),
    "orbit radius": _LENGTH, "angle of roll": NONE, "angle of pitch": NONE, "angle of yaw": NONE,
    "direction": NONE, "resolution": NONE, "sizes": NONE, "l/(I_pitch ω0)": NONE, "t": _TIME,
    "transverse rate": _RATE, "axial rate": _RATE, "--transverse": _RATE, "--axial": _RATE, "mass": _MASS,
    "coupling": Dimension(1, 1, 0), "--energy": _TORQUE, "--momentum": _MOMENTUM, "--until": _TIME,
    "--step": _TIME})
_FOOT, _POUND, _GRAVITY = Rational("0.3048"), Rational("0.45359237"), Rational("9.80665")
# for each its SI number, exact, its dimension, and whether it takes the prefixes of SI
_UNITS: dict[str, tuple[Expr, Dimension, bool]] = {
    "g": (Rational(1, 1000), _MASS, True), "m": (S.One, _LENGTH, True), "s": (S.One, _TIME, True),
    "rad": (S.One, NONE, True), "N": (S.One, _FORCE, True), "J": (S.One, _TORQUE, True),
    "W": (S.One, Dimension(1, 2, -3), True), "Nm": (S.One, _TORQUE, True), "Nms": (S.One, _MOMENTUM, True),
    "min": (Integer(60), _TIME, False), "h": (Integer(3600), _TIME, False),
    "deg": (pi / 180, NONE, False), "arcmin": (pi / 10800, NONE, False), "arcsec": (pi / 648000, NONE, False),
    "rev": (2 * pi, NONE, False), "rpm": (pi / 30, _RATE, False),
    "in": (_FOOT / 12, _LENGTH, False), "ft": (_FOOT, _LENGTH, False), "lb": (_POUND, _MASS, False),
    "lbf": (_POUND * _GRAVITY, _FORCE, False), "slug": (_POUND * _GRAVITY / _FOOT, _MASS, False)}
_WORDS = {"gram": "g", "kilogram": "kg", "meter": "m", "metre": "m", "second": "s", "radian": "rad",
          "newton": "N", "joule": "J", "watt": "W", "minute": "min", "hour": "h", "degree": "deg",
          "arcminute": "arcmin", "arcsecond": "arcsec", "turn": "rev", "revolution": "rev",
          "revolutions_per_minute": "rpm", "foot": "ft", "inch": "in", "pound": "lb", "pound_mass": "lb",
          "lbm": "lb", "pound_force": "lbf", "force_pound": "lbf"}
_PREFIXES = {"n": -9, "u": -6, "m": -3, "c": -2, "k": 3, "M": 6, "G": 9}


@lru_cache(maxsize=512)
def dimension_of(name: str) -> Dimension | None:
    """Return the dimension of a name; None for a parameter of the user, which may be anything."""
    entry = NOTATION.get(name)
    if entry is None:
        return _BESIDE.get(name, _BESIDE.get(name.partition(" of ")[0]))       # inertia of a named body
    energy, rate = entry.dimension
    return Dimension(energy, 2 * energy + entry.length, -rate)


def unit(name: str) -> tuple[Expr, Dimension] | None:
    """Return a unit in SI, exactly, and its dimension; None if there is none of that name.

    Examples
    --------
    >>> unit("mm")[0], unit("rpm")[0], unit("furlong")
    (1/1000, pi/30, None)
    """
    name = _WORDS.get(name, name)
    if name in _UNITS:
        return _UNITS[name][:2]
    size, dimension, prefixed = _UNITS.get(name[1:], (S.One, NONE, False))
    power = _PREFIXES.get(name[:1])
    return (size * Pow(Integer(10), power), dimension) if prefixed and power is not None else None


class _Quantity(Parser):
    """A number, or a quantity if a unit stands after it."""

    HINT = Parser.HINT + ", and units after a number, 120 kg m^2"

    def quantity(self) -> tuple[Expr, Dimension | None]:
        """Return the expression in SI, and the dimension of what has a unit."""
        value = self.sum().value
        if not self.peek():
            return value, None
        if self.tokens[self.place][0] != "name" or value.free_symbols:
            self.fail(f"{self.peek()!r} comes where an operator or the end should be",
                      "write * between factors, and check the parentheses; a unit stands after a number")
        factor, dimension = self.units()
        return Mul(value, factor), dimension

    def units(self) -> tuple[Expr, Dimension]:
        """Parse a product of units, each a power; a name after another one is a factor."""
        factor, powers, sign = S.One, [0, 0, 0], 1
        for _ in range(FACTORS):
            size, dimension = self.unit()
            power = sign * (self.exponent() if self.take("**") else 1)
            factor *= Pow(size, power)
            powers = [p + power * d for p, d in zip(powers, dimension)]
            if not self.peek():
                return factor, Dimension(*powers)
            sign = -1 if self.take("/") else 1
            if sign == 1:
                self.take("*")
        self.fail(f"it has more than {FACTORS} units", "write it in fewer")

    def unit(self) -> tuple[Expr, Dimension]:
        kind, name = self.tokens[self.place]
        found = unit(name) if kind == "name" else None
        if found is None:
            self.fail(f"{name!r} is no unit" if name else "it ends too early",
                      f"the units are {', '.join(_UNITS)}, kg and others with prefixes; write * between "
                      "factors that are none")
        self.place += 1
        return found

    def exponent(self) -> int:
        """Parse a whole number, or one in parentheses."""
        wrapped, sign = self.take("("), -1 if self.take("-") else 1
        kind, token = self.tokens[self.place]
        if kind != "number" or not token.isdecimal() or int(token[:4]) > POWER:
            self.fail(f"the power {token!r} of a unit is no whole number up to {POWER}", "write m^2")
        self.place += 1
        if wrapped and not self.take(")"):
            self.fail("a parenthesis is open", "close it")
        return sign * int(token)


@lru_cache(maxsize=256)
def _units_in(text: str) -> tuple[Expr, Dimension | None] | None:
    """Return the product of units that a text is, and its dimension; None if it is none."""
    try:
        return _Quantity(f"1 {text}").quantity()
    except ExpressionError:
        return None


# whoever checks that units are not mixed reads all texts, which are read once more as numbers
@lru_cache(maxsize=256)
def quantity(text: str) -> tuple[Expr, Dimension | None]:
    """Return the expression that a text stands for, in SI if it has a unit, and its dimension.

    Parameters
    ----------
    text : str
        in the grammar of expressions; a number, not an expression in names, may have a unit

    Returns
    -------
    (Expr, Dimension or None)
        None where there is no unit

    Raises
    ------
    ExpressionError
        anything outside the grammar, or a unit that is not known

    Examples
    --------
    >>> quantity("3000 rpm")[0], quantity("1 lb")[0]
    (100*pi, 45359237/100000000)
    >>> print(*quantity("120 kg m^2/s"))
    120 kg m^2 s^-1
    """
    if (plain := numeral(text)) is not None:
        number, after = plain
        if not after:
            return number, None
        if (units := _units_in(after)) is not None:
            factor, dimension = units
            return number * factor, dimension
    return _Quantity(text).quantity()


def in_si(value: Any, name: str) -> tuple[Expr, bool]:
    """Return the number that a text stands for under a name, and whether it has a unit.

    Parameters
    ----------
    value : str
    name : str
        of the table of notation, or of an argument; any other name may be a number of anything

    Raises
    ------
    ValuesError
        the unit is one of something else
    """
    number, dimension = quantity(value)
    if dimension is None:
        return number, False
    if (wanted := dimension_of(name)) not in (None, dimension):
        what = f"{name} ({NOTATION[name].meaning})" if name in NOTATION else name
        free = free_letters([name], {name})[name]
        own = (f", or write another letter for a number of your own, such as {free}"
               if use_of(name) in (Use.FIELD, Use.LEVEL) else "")
        raise ValuesError(f"{name} = {brief(value)[1:-1]} is a number of {dimension}, but {what} is one of "
                          f"{wanted}: give it in a unit of that kind{own}")
    return number, True


def text_of(value: Any) -> Any:
    """Return the quantity of a library of units, as pint's, as a text, and anything else as it is."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return f"{value.magnitude} {value.units:~C}"
    return value


def not_mixed(entries: Iterable[tuple[str, Any]]) -> None:
    """Refuse quantities beside bare numbers; 0 has any unit, a pure number has none.

    Parameters
    ----------
    entries : iterable of (name, value)
        as they are given

    Raises
    ------
    ValuesError
        some have a unit, and some that should have one have none
    """
    given = [(name, text_of(value)) for name, value in entries]
    if not any(isinstance(value, str) for _, value in given):
        return
    known = [(name, value, *(quantity(value) if isinstance(value, str) else (value, None)))
             for name, value in given if dimension_of(name) not in (None, NONE)]
    named = next((f"{name} = {brief(value)}" for name, value, _, unit in known if unit), None)
    if named is None:
        return
    bare = next((f"{name} = {brief(value)}" for name, value, number, unit in known
                 if not unit and not getattr(number, "shape", ()) and number != 0
                 and not getattr(number, "free_symbols", None)), None)
    if bare:
        raise ValuesError(f"{named} has a unit and {bare} has none: give every number its unit, or none")
