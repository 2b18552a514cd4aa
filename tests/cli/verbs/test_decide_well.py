"""gyrostat decide --well: how much a stable equilibrium survives, in words and as data."""
import csv
import io
import json
import math
import shutil
import subprocess

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
    assert well["damped_kick"] == pytest.approx(0.683180011755643, rel=1e-14)
    assert "kick across its axis of less than 0.68318 does" in " ".join(decide(
        capsys, *TOP, "omega=3/2", "--well")[1].split())
    assert well["held_at_every_energy"] is True and well["barrier"] is None and "no pass" in well["reason"]


@pytest.mark.parametrize("asked", [
    pytest.param(SATELLITE, marks=pytest.mark.slow), HEAVY, [*TOP, "omega=3/2"]],
    ids=["orbit", "heavy", "top"])
def test_csv_has_the_columns_of_the_table(capsys, asked):
    """Those of JSON besides, to the last bit; infinite what has no pass."""
    _, out, _ = decide(capsys, *asked, "--well", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    for one, row in zip(csv.DictReader(io.StringIO(decide(capsys, *asked, "--format", "csv")[1])), rows,
                        strict=True):
        assert one.items() <= row.items()
    wells = [e["well"] for e in json.loads(
        decide(capsys, *asked, "--well", "--format", "json")[1])["equilibria"]]
    for row, well in zip(rows, wells, strict=True):
        for name, key in (("barrier", "barrier"), ("escape", "escape"), ("kick", "kick"),
                          ("any_kick", "any_kick"),
                          ("damped_kick", "damped_kick"), ("tilt_deg", "tilt"),
                          ("barrier_at_least", "at_least")):
            number = float(row[name]) if row[name] else None
            assert (None if number == math.inf else number) == well[key], name
        assert (row["barrier"] == "inf") == well["held_at_every_energy"]
        assert row["pass_kind"] == well["kind"] and row["well_reason"] == well["reason"]
        assert row["well_damped"] == ("" if well["damped"] is None else str(well["damped"]))
        assert int(row["passes"] or 0) == len(well["passes"])
        for name, number in (well["passes"] or [{}])[0].items():
            assert float(row[f"pass_{name}"]) == number


def test_latex_says_it_below_the_stable_ones_and_compiles(capsys, tmp_path):
    """The same sentences as in words; a note on the attitude before them ends."""
    path = tmp_path / "wells.tex"
    assert decide(capsys, *SATELLITE, "--well", "--output", str(path)) == (0, "", "")
    written = path.read_text(encoding="ascii")
    assert written.count("Well: 5 up to the pass at roll") == 4
    assert written.count("A kick of less than 18.7082, in whatever direction, does not take it out.") == 4
    assert "Well:" not in decide(capsys, *SATELLITE, "--format", "latex")[1]
    if shutil.which("pdflatex"):
        said = subprocess.run(["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "wells.tex"],
                              cwd=tmp_path, capture_output=True, text=True, check=False)
        assert said.returncode == 0 and "Overfull" not in said.stdout, said.stdout[-2000:]


@pytest.mark.parametrize(("asked", "barrier", "kick"), [
    (["--equilibrium", "axis 3", "--potential", "none", "--inertia", "1,2,3", "--gyrostatic-momentum",
      "0,0,1/4", "--set", "omega3_0=1/4"], 3 / 16, 3 / 4),      # l = 1/4, abs(M) = 1: theory of planes
    (["--equilibrium", "earth-pointing", "--orbit", "1", "--inertia", "60,70,35", "--gyrostatic-momentum",
      "0,5,0"], 45 / 4, math.sqrt(2 * 45 / 4 * 35)),
    (["--point", "0,0,0,0,0,-1", "--potential", "k3", "--inertia", "1,2,3", *STILL], 2, 2)])
def test_one_that_is_named_has_the_well_of_its_list(capsys, asked, barrier, kick):
    """Of a free body 3/16, of a wheel along pitch (D + l)²/(2 D), of a pendulum 2 m0: closed forms."""
    _, out, _ = decide(capsys, *asked, "--well", "--format", "json")
    [found] = json.loads(out)["equilibria"]
    assert found["well"]["barrier"] == pytest.approx(barrier, rel=1e-14) and found["place"] == {}
    assert found["well"]["kick"] == pytest.approx(kick, rel=1e-14)
    assert f"Well: {barrier:.6g} up to the pass" in decide(capsys, *asked, "--well")[1]
    _, out, _ = decide(capsys, *asked, "--well", "--format", "csv")
    assert float(next(csv.DictReader(io.StringIO(out)))["barrier"]) == found["well"]["barrier"]


def test_named_ones_of_a_body_of_revolution(capsys):
    """A sleeping top has no pass; a tilt stands for all turns about the axis; others have the reason."""
    _, out, _ = decide(capsys, "--equilibrium", "E1", *TOP, "omega3_0=3/2", "--well")
    assert "Well: there is no pass: the walls of V hold it at every energy." in out
    _, out, _ = decide(capsys, "--equilibrium", "E3", "--potential", "m0*k3", "--set", "I1=2", "I3=1",
                       "m0=-3", "k3=1/2", "omega=3", "--well")         # l from omega, by elimination
    assert "Well: there is no pass" in out
    _, out, _ = decide(capsys, "--potential", "k3", "--inertia", "1,1,1", *STILL, "--equilibrium", "E1",
                       "--set", "omega3_0=0", "--well", "--format", "json")
    assert "not stable" in json.loads(out)["equilibria"][0]["well"]["reason"]
