"""The rate of a circular orbit: given, or by its period, its radius, or its height above a celestial body."""
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from sympy import Expr, Rational, pi, sqrt

from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.numbers import exact_expression, shown
from ...algebra.text.quantities import has_unit
from ...errors import PotentialError, brief
from ...notation import components, symbol
from ...registry import check_names

RATE = symbol("omega0")
KINDS = ("rate", "period", "height", "radius")         # one of these is given


class CelestialBody(NamedTuple):
    """A body that has satellites: its gravitational parameter, and the radius above which heights are."""

    mu: Expr
    radius: Expr


# m³/s² and m. Earth: IERS Conventions (2010), table 1.1, the equatorial radius. Moon and Mars: mu of JPL's
# DE440 (Park et al., Astron. J. 161 (2021) 105; gm_de440.tpc), of Mars without its moons; radii of the IAU
# working group on cartographic coordinates (Archinal et al., Celest. Mech. Dyn. Astron. 130 (2018) 22), the
# mean one of the Moon, the equatorial one of Mars.
CELESTIAL: Mapping[str, CelestialBody] = MappingProxyType({
    "earth": CelestialBody(Rational("398600.4418e9"), Rational("6378136.6")),
    "moon": CelestialBody(Rational("4902.8001184575496e9"), Rational("1737400")),
    "mars": CelestialBody(Rational("42828.37362069909e9"), Rational("3396190"))})


def rate_of_orbit(rate: Any, mu: Any, radius: Any, height: Any, period: Any, body: Any) -> Expr:
    """Return ω0, proved positive if it is a number.

    Raises
    ------
    PotentialError
        more or less than one rate is given, or what is given is not positive
    """
    texts = {"rate": rate, "period": period, "height": height, "mu": mu, "radius": radius}
    given = {name: _positive(name, x) for name, x in texts.items() if x is not None}
    around = _celestial(body)
    if around is not None and "mu" not in given and "radius" in given:
        given["mu"] = around.mu
    asked = [name for name in KINDS if name in given]
    if len(asked) > 1 and asked != ["rate", "radius"]:
        raise PotentialError(f"{' and '.join(asked)} of the orbit are both given: leave out one of the two")
    if ("mu" in given) != ("radius" in given):
        alone = "mu" if "mu" in given else "radius"
        raise PotentialError(f"{alone} is given alone: an orbit has a rate, a period, a height, or mu and "
                             "radius; give mu and radius, or body=\"earth\" and radius")
    if around is not None and (mu is not None or not {"height", "radius"} & given.keys()):
        raise PotentialError(f"body = {body} is given with {', '.join(given) or 'nothing else'}: give it "
                             "with a height, or with a radius")
    if "height" in given:
        if not has_unit(height):
            raise PotentialError(f"height = {brief(height)} has no unit: write the height above the equator "
                                 "with its unit, '500 km'")
        earth = around or CELESTIAL["earth"]
        return sqrt(earth.mu / (earth.radius + given["height"]) ** 3)
    if "period" in given:
        return 2 * pi / given["period"]
    if "radius" not in given:
        return given.get("rate", RATE)
    found = sqrt(given["mu"] / given["radius"] ** 3)
    if "rate" in given and sign_of_constant(given["rate"] - found) != 0:
        raise PotentialError(f"rate = {shown(given['rate'])}, but mu and radius give "
                             f"{shown(found)}: leave one of them out")
    return found


def _celestial(name: Any) -> CelestialBody | None:
    """Return the body of a name."""
    if name is None:
        return None
    if not isinstance(name, str) or name.strip().lower() not in CELESTIAL:
        raise PotentialError(f"body = {brief(name)}: give {', '.join(CELESTIAL)}, or mu and radius")
    return CELESTIAL[name.strip().lower()]


def _positive(name: str, given: Any) -> Expr:
    """Return a positive number, or an expression in names."""
    value = exact_expression(given, f"orbit {name}")
    directions = sorted(map(str, value.free_symbols & {*components("n"), *components("r")}))
    check_names([value], f"{name} = {shown(value)}", PotentialError)
    if directions:
        raise PotentialError(f"{name} = {shown(value)} depends on {', '.join(directions)}, a direction "
                             "that moves: give a number or another name")
    if value.is_nonpositive or not value.free_symbols and sign_of_constant(value) != 1:
        raise PotentialError(f"{name} = {shown(value)}: the {name} of a circular orbit is positive; give "
                             "a positive number")
    return value
