"""Reads quantities with units, as 120 kg m^2 or 3000 rpm: exact numbers in SI, their dimensions checked.

quantity := sum [unit (('*' | '/')? unit)*]
unit     := name ['**' integer]

A unit stands after a number; in the grammar of expressions no name does.
"""
from collections.abc import Iterable
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from sympy import Expr, Mul, Pow, Rational, S

from ...errors import ExpressionError, ValuesError, brief
from ...notation import REGISTRY, Use, jet
from ...registry import free_letters, use_of
from .grammar import Parser
from .scanner import numeral
from .units import ANGLE, INERTIA, LENGTH, MASS, MOMENTUM, NONE, RATE, TIME, TORQUE, UNITS, Dimension, unit

POWER, FACTORS = 9, 8                                  # of a unit, and of units, at most

_TABLE = MappingProxyType({entry.name: entry for entry in REGISTRY if entry.use is not Use.PRINTED})
# of what is not in the table of notation: arguments and options; damping is a torque by a rate
_BESIDE = MappingProxyType({
    "inertia": INERTIA, "gyrostatic_momentum": MOMENTUM, "axial": INERTIA, "transverse": INERTIA,
    "rate": RATE, "momentum": MOMENTUM, "axis": NONE, "orbit rate": RATE, "orbit mu": Dimension(0, 3, -2),
    "orbit radius": LENGTH, "orbit height": LENGTH, "orbit period": TIME, "angle of roll": ANGLE,
    "angle of pitch": ANGLE, "angle of yaw": ANGLE, "direction": NONE, "degrees": NONE,
    "resolution": NONE, "sizes": NONE, "l/(I_pitch ω0)": NONE, "transverse rate": RATE,
    "axial rate": RATE, "--transverse": RATE,
    "--axial": RATE, "mass": MASS, "coupling": Dimension(1, 1, 0), "--energy": TORQUE,
    "--momentum": MOMENTUM, "--until": TIME, "--step": TIME, "--tolerance": NONE, "U": TORQUE, "drift": RATE,
    "torque": TORQUE, "weight": TORQUE,
    "platform_damping": Dimension(1, 2, -1, -1), "rotor_damping": Dimension(1, 2, -1, -1)})


@lru_cache(maxsize=512)
def dimension_of(name: str) -> Dimension | None:
    """Return the dimension of a name; None for a parameter of the user, which may be anything."""
    bare = name.partition("[")[0]                      # of an array: I1[0]
    entry = _TABLE.get(bare)
    if entry is None:
        return TORQUE if jet(bare) else _BESIDE.get(bare.partition(" of ")[0], _BESIDE.get(bare))
    energy, rate = entry.dimension
    return ANGLE if entry.use is Use.ANGLE else Dimension(energy, 2 * energy + entry.length, -rate)


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
        factor, powers, sign = S.One, [0, 0, 0, 0], 1
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
                      f"the units are {', '.join(UNITS)}, kg and others with prefixes; write * between "
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
def units_in(text: str) -> tuple[Expr, Dimension | None] | None:
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
        if (units := units_in(after)) is not None:
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
    wanted = dimension_of(name)
    if wanted is None or wanted != NONE and dimension.fits(wanted):
        return number, True
    given = f"{name} = {brief(value)[1:-1]} is a number of {dimension}, but"
    what = f"{name} ({_TABLE[name].meaning})" if name in _TABLE else name
    if wanted == NONE:
        raise ValuesError(f"{given} {what} is one without a unit: leave the unit out")
    free = free_letters([name], {name})[name]
    own = (f", or write another letter for a number of your own, such as {free}"
           if use_of(name) in (Use.FIELD, Use.LEVEL) else "")
    raise ValuesError(f"{given} {what} is one of {wanted}: give it in a unit of that kind{own}")


def text_of(value: Any) -> Any:
    """Return the quantity of a library of units, as pint's, as a text, and anything else as it is."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return f"{value.magnitude} {value.units:~C}"
    return value


def has_unit(value: Any) -> bool:
    """Tell whether a text, or the quantity of a library, has a unit."""
    text = text_of(value)
    return isinstance(text, str) and quantity(text)[1] is not None


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
    given = [(name, value if isinstance(value, Rational) else text_of(value)) for name, value in entries]
    if not any(isinstance(value, str) for _, value in given):
        return
    known = [(name, value, *(quantity(value) if isinstance(value, str) else (value, None)))
             for name, value in given if dimension_of(name) not in (None, NONE, ANGLE)]
    named = next((f"{name} = {brief(value)}" for name, value, _, unit in known if unit), None)
    if named is None:
        return
    bare = next((f"{name} = {brief(value)}" for name, value, number, unit in known
                 if not unit and not getattr(number, "shape", ()) and number != 0
                 and not getattr(number, "free_symbols", None)), None)
    if bare:
        raise ValuesError(f"{named} has a unit and {bare} has none: give every number its unit, or none")
