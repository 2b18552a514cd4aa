"""The rate of an orbit by height, period or radius: Kepler's third law, at constants of other sources."""
import math

import pytest
from commands import run

import gyrostat as gs
from gyrostat.errors import GyrostatError, PotentialError
from gyrostat.mechanics.families.circular_orbit import orbital_rate
from gyrostat.mechanics.families.scene_tables import SceneTable

# in km³/s² and km, of other sources: fact sheets of NASA, WGS 84, DE430
SHEETS = {"earth": (398600.0, 6378.137), "moon": (4902.800066, 1738.1), "mars": (42828.0, 3396.2)}


def rate(**orbit):
    """The rate that the library finds, in rad/s."""
    return float(orbital_rate(gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(**orbit))))


@pytest.mark.parametrize("body", SHEETS)
@pytest.mark.parametrize("height", [100, 500, 35786])
def test_a_height_gives_the_rate_of_kepler(body, height):
    """ω² a³ = mu; the constants of two sources differ by less than a part in 10³."""
    mu, radius = SHEETS[body]
    ours = rate(height=f"{height} km", body=body)
    assert ours == pytest.approx(math.sqrt(mu / (radius + height)**3), rel=1e-3)
    assert body != "earth" or rate(height=f"{height * 1000} m") == ours


def test_the_constants_are_the_published_ones():
    """IERS Conventions (2010), table 1.1; gm_de440.tpc; Archinal et al. (2018), tables 4 and 5."""
    printed = {"earth": (3.986004418e14, 6378136.6), "moon": (4.9028001184575496e12, 1737.4e3),
               "mars": (4.282837362069909e13, 3396.19e3)}
    for body, (mu, radius) in printed.items():
        low, high = math.sqrt(mu / (radius + 1)**3), math.sqrt(mu / 9e6**3)
        assert rate(height="1 m", body=body.title()) == pytest.approx(low, rel=1e-14)      # of doubles
        assert rate(radius="9000 km", body=body) == pytest.approx(high, rel=1e-14)


def test_a_period_and_a_mean_motion():
    """A turn in 95 minutes, and 15.5 turns a day."""
    assert rate(period="95 min") == pytest.approx(2 * math.pi / 5700, rel=1e-15)
    assert rate(rate="15.5 rev/day") == pytest.approx(2 * math.pi * 15.5 / 86400, rel=1e-15)


@pytest.mark.parametrize("orbit", [
    {"height": 500}, {"height": "500"}, {"height": "-1 km"}, {"height": "0 km"}, {"body": "moon"},
    {"height": "1 km", "body": "sun"}, {"period": "95 min", "height": "500 km"}, {"mu": 1}, {"radius": 1},
    {"period": "95 min", "rate": 1}, {"body": "moon", "mu": 1, "radius": 1}, {"body": "moon", "period": 1},
    {"height": gs.symbol("h")}], ids=str)
def test_more_or_less_than_one_rate_is_refused(orbit):
    """And a height without a unit: it stands beside the radius of the Earth."""
    with pytest.raises(PotentialError) as refused:
        gs.circular_orbit(**orbit)
    assert len(str(refused.value)) <= 300


@pytest.mark.parametrize("potential", ["f*v1", "f*k1", "f"])
def test_what_acts_beside_the_gravity_gradient_is_along_directions_of_the_orbit(potential):
    """A refusal says in which names a torque is written."""
    with pytest.raises(PotentialError, match="r3, the vertical, and t1, t2, t3, along") as refused:
        gs.circular_orbit(1, potential=potential)
    assert len(str(refused.value)) <= 300


@pytest.mark.parametrize(("text", "table"), [
    ("height=500 km", {"height": "500 km"}),
    ("height=100 km body=moon", {"height": "100 km", "body": "moon"}),
    ("period = 95 min", {"period": "95 min"}), ("0.0011 rad/s", {"rate": "0.0011 rad/s"}),
    ("mu=398600.4418 km^3/s^2,radius=6878 km", {"mu": "398600.4418 km^3/s^2", "radius": "6878 km"}),
    ("mu=398600.4418 km^3/s^2 radius=6878 km", {"mu": "398600.4418 km^3/s^2", "radius": "6878 km"})])
def test_the_text_of_an_option_is_the_table_of_a_file(text, table):
    """And both are the arguments of the function."""
    body = {"inertia": "60, 70, 35 kg m^2", "gyrostatic_momentum": [0, 0, 0]}
    scenes = [SceneTable(body | {"orbit": given}).system for given in (text, table)]
    in_python = gs.assemble(gs.Gyrostat("60, 70, 35 kg m^2", (0, 0, 0)), gs.circular_orbit(**table))
    assert {orbital_rate(scene) for scene in scenes} == {orbital_rate(in_python)}


@pytest.mark.parametrize("text", ["height=500", "height=500 km height=3 km", "altitude=500 km", "height=",
                                  "height=500 kg", "period=95 km", "body=moon", "height=1=2 km"])
def test_an_orbit_that_is_none_is_refused(capsys, text):
    """In a sentence."""
    status, out, err = run(capsys, "--orbit", text, "--inertia", "60, 70, 35 kg m^2", verb="conditions")
    assert status == 2 and not out and 20 < len(err) < 320


def test_a_number_without_a_unit_is_not_mixed_with_a_height():
    """The radius of the Earth has a unit."""
    with pytest.raises(GyrostatError, match="orbit height = '500 km' has a unit and inertia = '60' has none"):
        _ = SceneTable({"inertia": [60, 70, 35], "orbit": "height=500 km"}).body
