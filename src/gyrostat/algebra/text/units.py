"""Units that quantities may have: their sizes in SI, exactly, and their dimensions."""
from typing import NamedTuple

from sympy import Expr, Integer, Pow, Rational, S, pi


class Dimension(NamedTuple):
    """The powers of mass, length and time in a quantity, and of an angle, if a unit names one."""

    mass: int
    length: int
    time: int
    angle: int = 0

    def __str__(self) -> str:
        """Return the unit in SI."""
        return " ".join(f"{name}^{power}" if power != 1 else name
                        for name, power in zip(("kg", "m", "s", "rad"), self) if power) or "1"

    def fits(self, wanted: "Dimension") -> bool:
        """Tell whether a quantity of this dimension is one of another.

        An angle is a pure number, so that each 1/s may be a rad/s: 3 N m s is 3 kg m^2 rad/s. But no moment
        of inertia is in kg m^2 deg, and no period in min/rev.

        Examples
        --------
        >>> Dimension(0, 0, -1, 1).fits(RATE), Dimension(0, 0, 1, -1).fits(TIME), ANGLE.fits(NONE)
        (True, False, False)
        """
        return self[:3] == wanted[:3] and wanted.angle <= self.angle <= max(wanted.angle, -wanted.time)


NONE, ANGLE = Dimension(0, 0, 0), Dimension(0, 0, 0, 1)
MASS, LENGTH, TIME = Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1)
RATE = Dimension(0, 0, -1)
INERTIA, MOMENTUM, TORQUE = Dimension(1, 2, 0), Dimension(1, 2, -1), Dimension(1, 2, -2)
FORCE = Dimension(1, 1, -2)
_FOOT, _POUND, _GRAVITY = Rational("0.3048"), Rational("0.45359237"), Rational("9.80665")
# for each its SI number, exact, its dimension, and whether it takes the prefixes of SI
UNITS: dict[str, tuple[Expr, Dimension, bool]] = {
    "g": (Rational(1, 1000), MASS, True), "m": (S.One, LENGTH, True), "s": (S.One, TIME, True),
    "rad": (S.One, ANGLE, True), "N": (S.One, FORCE, True), "J": (S.One, TORQUE, True),
    "W": (S.One, Dimension(1, 2, -3), True), "Nm": (S.One, TORQUE, True), "Nms": (S.One, MOMENTUM, True),
    "min": (Integer(60), TIME, False), "h": (Integer(3600), TIME, False),
    "day": (Integer(86400), TIME, False), "deg": (pi / 180, ANGLE, False),
    "arcmin": (pi / 10800, ANGLE, False), "arcsec": (pi / 648000, ANGLE, False),
    "rev": (2 * pi, ANGLE, False), "rpm": (pi / 30, RATE._replace(angle=1), False),
    "in": (_FOOT / 12, LENGTH, False), "ft": (_FOOT, LENGTH, False), "lb": (_POUND, MASS, False),
    "lbf": (_POUND * _GRAVITY, FORCE, False), "slug": (_POUND * _GRAVITY / _FOOT, MASS, False)}
_WORDS = {"gram": "g", "kilogram": "kg", "meter": "m", "metre": "m", "second": "s", "radian": "rad",
          "newton": "N", "joule": "J", "watt": "W", "minute": "min", "hour": "h", "degree": "deg",
          "arcminute": "arcmin", "arcsecond": "arcsec", "turn": "rev", "revolution": "rev",
          "revolutions_per_minute": "rpm", "foot": "ft", "inch": "in", "pound": "lb", "pound_mass": "lb",
          "lbm": "lb", "pound_force": "lbf", "force_pound": "lbf"}
_PREFIXES = {"n": -9, "u": -6, "m": -3, "c": -2, "k": 3, "M": 6, "G": 9}


def unit(name: str) -> tuple[Expr, Dimension] | None:
    """Return a unit in SI, exactly, and its dimension; None if there is none of that name.

    Examples
    --------
    >>> unit("mm")[0], unit("rpm")[0], unit("furlong")
    (1/1000, pi/30, None)
    """
    name = _WORDS.get(name, name)
    if name in UNITS:
        return UNITS[name][:2]
    size, dimension, prefixed = UNITS.get(name[1:], (S.One, NONE, False))
    power = _PREFIXES.get(name[:1])
    return (size * Pow(Integer(10), power), dimension) if prefixed and power is not None else None
