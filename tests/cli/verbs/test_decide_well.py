"""gyrostat decide --well: how much a stable equilibrium survives, in words and as data."""
import json

import pytest
from commands import decide

STILL = ["--gyrostatic-momentum=0,0,0"]
SATELLITE = ["--orbit", "1", "--inertia", "60,70,35", *STILL]
HEAVY = ["--potential", "k1 + k2 + k3", "--inertia", "1,2,3", "--gyrostatic-momentum=0,0,1", "--set",
         "C1=5/2"]
TOP = ["--potential", "m0*k3", "--set", "I1=1", "I3=8/5", "l=0", "m0=1"]


def test_a_satellite_in_words(capsys):
    """Of the stable attitudes alone: the pass, turned in yaw, the kick, rounded down, and damping."""
    status, out, err = decide(capsys, *SATELLITE, "--well")
    flat = " ".join(out.split())
    assert (status, err) == (0, "") and flat.count("Well:") == 4
    assert flat.count("Well: 5 up to the pass at roll 0°, pitch 0°, yaw 90°, behind which lies another") == 2
    assert flat.count("A kick of less than 18.7082, in whatever direction, does not take it out.") == 4
    assert flat.count("Turned by less than 15.5013° about whatever axis, and let go at rest") == 4
    assert flat.count("Under internal damping every motion inside comes back.") == 4
    assert "Well:" not in decide(capsys, *SATELLITE)[1]


def test_units(capsys):
    """Joule and newton metre seconds, if the scene has units."""
    _, out, _ = decide(capsys, "--orbit", "0.0011 rad/s", "--inertia", "60 kg m^2,70 kg m^2,35 kg m^2",
                       *STILL, "--well")
    flat = " ".join(out.split())
    assert "Well: 6.05e-06 J up to" in flat and "A kick of less than 0.0205791 N m s, in" in flat


def test_a_heavy_gyrostat_in_words(capsys):
    """Its well closes round a summit; what gyroscopic forces hold has none."""
    flat = " ".join(decide(capsys, *HEAVY, "--well")[1].split())
    assert "Well: 1.8618 up to the pass at k = (−0.674547, 0.720007, −0.163021), over which it closes" in flat
    assert "A kick of less than 2.0288, in whatever direction across k, does" in flat
    assert "Any kick of less than 2.46273 keeps k over its well in the frame that turns with it" in flat
    assert "gyroscopic forces hold it" in flat and flat.count("Any kick") == 1


def test_as_data(capsys):
    """Null where there is none, and for an unstable one the reason."""
    _, out, _ = decide(capsys, *HEAVY, "--well", "--format", "json")
    wells = [e["well"] for e in json.loads(out)["equilibria"]]
    assert [w["kind"] for w in wells] == ["round", "", "", ""]
    assert wells[0]["barrier"] == pytest.approx(1.86180390026476, rel=1e-14) and wells[0]["escape"] is None
    assert wells[0]["damped"] is True and wells[0]["passes"][0]["k1"] == pytest.approx(-0.6745473519636137)
    assert wells[0]["kick"] == pytest.approx(2.02880462166252, rel=1e-14) and wells[0]["beyond"] == []
    assert [w["any_kick"] for w in wells] == [pytest.approx(2.46273204849046, rel=1e-14), None, None, None]
    assert "not stable" in wells[1]["reason"] and "gyroscopic" in wells[2]["reason"]
    _, out, _ = decide(capsys, *TOP, "omega=3/2", "--well", "--format", "json")
    well = json.loads(out)["equilibria"][0]["well"]
    assert well["held_at_every_energy"] is True and well["barrier"] is None and "no pass" in well["reason"]


def test_where_it_is_not_said(capsys):
    """A table has no place for it, and an equilibrium that is named is in no list."""
    status, _, err = decide(capsys, *SATELLITE, "--well", "--format", "csv")
    assert status == 2 and "--well adds to text and JSON" in err
    _, out, _ = decide(capsys, "--equilibrium", "E1", *TOP, "omega3_0=3/2", "--well")
    assert "leave --equilibrium out" in " ".join(out.split())
