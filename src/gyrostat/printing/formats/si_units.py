"""The units of SI in which the numbers of named quantities are printed."""
from ...notation import NOTATION, units
from ...typesetting import SUPERSCRIPTS

RATE = "rad/s"
_SPECIAL = {"1": "", "s-1": RATE}


def unit_of(name: str) -> str:
    """The unit of the quantity of that name; "" for a pure number, and for a parameter of the user.

    Examples
    --------
    >>> unit_of("pi3"), unit_of("omega"), unit_of("k3"), unit_of("a")
    ('kg m² s⁻¹', 'rad/s', '', '')
    """
    if name == "growth_rate":
        return "1/s"                                       # no angle grows
    entry = NOTATION.get(name)
    if entry is None:
        return ""
    unit = units(*entry.dimension, entry.length)
    return _SPECIAL.get(unit, unit.translate(SUPERSCRIPTS))
