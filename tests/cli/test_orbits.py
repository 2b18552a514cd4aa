"""A satellite in orbit on the command line: each verb answers, or says in a sentence what does."""
import csv
import json
import re

import pytest
from commands import run

FILE = """
[scene.pole]
inertia = [60, 32, 35]
gyrostatic_momentum = [0, 0, 0]
orbit = "omega0"
values = { omega0 = 0.0011 }
equilibrium = "earth-pointing"
release = ["1 deg", 0, 0]

[scene.leo]
inertia = ["60 kg m^2", "70 kg m^2", "35 kg m^2"]
orbit = { mu = "398600.4418 km^3/s^2", radius = "6778 km" }
equilibrium = "earth-pointing"

[scene.all]
orbit = 1
inertia = [1, "5/4", "8/5"]
gyrostatic_momentum = ["3/10", "1/5", "1/10"]

[scene.wheels]
inertia = ["60 kg m^2", "52 kg m^2", "35 kg m^2"]
rotors = [{ axis = [0, 1, 0], axial = "0.0005 kg m^2", rate = "600 rpm" }]
lumped = true
orbit = { mu = "398600.4418 km^3/s^2", radius = "6778 km" }
equilibrium = "earth-pointing"

[scene.free]
inertia = [60, 70, 35]
rotors = [{ axis = [1, 0, 0], axial = 5, momentum = 0 }]
lumped = true
orbit = 1
equilibrium = "earth-pointing"
"""
BODY = ("--orbit", "1", "--inertia", "60,32,35", "--gyrostatic-momentum", "0,0,0")


@pytest.fixture
def file(tmp_path):
    """The file of scenes."""
    path = tmp_path / "orbits.toml"
    path.write_text(FILE)
    return str(path)


def test_a_body_in_the_region_of_debra_and_delp(capsys, file):
    """Spectrally stable, open, destroyed by damping: two growing modes."""
    _, out, _ = run(capsys, "--scene", f"{file}#pole", "--format", "json", verb="decide")
    (found,) = json.loads(out)["equilibria"]
    assert found["label"] == "Earth-pointing" and found["decision"]["verdict"] == "UNDECIDED"
    assert found["damped_decision"]["verdict"] == "UNSTABLE"
    _, out, _ = run(capsys, "--scene", f"{file}#pole", verb="decide")
    assert "no theorem decides with three degrees of freedom" in " ".join(out.split())
    assert "2 growing modes" in out


def test_the_report_has_the_frequencies_squared(capsys):
    """(60, 32, 35) about roll, pitch and yaw, rate 1: x = −16/25, −1/4, and −75/32 of pitch."""
    _, out, _ = run(capsys, *BODY, "--format", "json")
    (equilibrium,) = json.loads(out)["equilibria"][:1]
    assert equilibrium["stiffness"] == [["-12", "0", "0"], ["0", "75", "0"], ["0", "0", "-28"]]


@pytest.mark.parametrize(("axes", "moments"), [
    ("1,2,3", "60,32,35"), ("2,1,3", "32,60,35"), ("3,-1,2", "32,35,60"), ("-1,-2,3", "60,32,35")])
def test_the_axes_of_roll_pitch_and_yaw(capsys, axes, moments):
    """The same satellite in other body axes; its rotor is along that of pitch."""
    _, out, _ = run(capsys, "--orbit", "1", "--inertia", moments, "--pointing", axes, "--equilibrium",
                    "earth-pointing",
                    "--set", "l=0", "--format", "json", verb="decide")
    (found,) = json.loads(out)["equilibria"]
    assert found["damped_decision"]["growing"] == 2
    assert found["frequencies"] == pytest.approx([1 / 2, 4 / 5, (75 / 32)**0.5], rel=1e-15)


@pytest.mark.slow
def test_all_attitudes(capsys, file):
    """16 of that gyrostat, 2 of them stable."""
    _, out, _ = run(capsys, "--scene", f"{file}#all", "--format", "json", verb="decide")
    found = json.loads(out)["equilibria"]
    assert len(found) == 16 and sum(e["decision"]["verdict"] == "STABLE" for e in found) == 2
    assert list(found[0]["place"]) == ["n1", "n2", "n3", "r1", "r2", "r3"]
    assert len(found[0]["frequencies"]) + 3 * (found[0]["growth_rate"] is not None) >= 3


def test_a_symmetric_satellite(capsys):
    """Its precessions by name, and all that the numbers name."""
    disc = ("--orbit", "omega0", "--inertia", "I1,I1,I3", "--gyrostatic-momentum", "0,0,l")
    _, out, _ = run(capsys, *disc, verb="conditions")
    assert out.index("Cylindrical: ") < out.index("Hyperbolic: ") < out.index("Conical: ")
    _, out, _ = run(capsys, *disc, "--equilibrium", "conical", "--set", "I1=1", "I3=8/5", "omega0=1",
                    "n3=3/4", verb="decide")

    assert "Lyapunov stable modulo the flow of π₃" in out
    assert "destroyed by internal damping: 2 growing" in out


def test_wheels_of_a_file(capsys, file):
    """A driven one holds a body that would turn over; a free one leaves K of roll with all of its moment."""
    _, out, _ = run(capsys, "--scene", f"{file}#wheels", "--format", "json", verb="decide")
    (found,) = json.loads(out)["equilibria"]
    assert found["decision"]["verdict"] == found["damped_decision"]["verdict"] == "STABLE"
    _, out, _ = run(capsys, "--scene", f"{file}#free", "--format", "json")
    (equilibrium,) = json.loads(out)["equilibria"][:1]     # I_n − I_t, 70 − 60, and J more across n
    assert [equilibrium["stiffness"][i][i] for i in range(3)] == ["140", "75", "15"]


def test_which_rotors_hold_it(capsys):
    """Numbers of the theory, to every digit that is shown."""
    _, out, _ = run(capsys, "--orbit", "omega0", "--solve-for", "l", "--set", "I1=1", "I2=7/10", "I3=4/5",
                    "omega0=1",
                    verb="conditions")
    assert "Stable: l > 2/5." in out and "l ≤ −1.41349…" in out and "0.0207629… ≤ l ≤ 3/10" in out


def test_a_batch(capsys, tmp_path):
    """A satellite in each line."""
    lines = tmp_path / "satellites.jsonl"
    lines.write_text('{"I1": 60, "I2": 70, "I3": 35, "l": 0}\n{"I1": 60, "I2": 32, "I3": 35, "l": 0}\n')
    _, out, _ = run(capsys, "--orbit", "1", "--equilibrium", "earth-pointing", "--batch", str(lines),
                    verb="decide")
    assert [json.loads(line)["equilibria"][0]["decision"]["verdict"] for line in out.splitlines()] == [
        "STABLE", "UNDECIDED"]


def test_a_table_of_librations(capsys, file):
    """Roll starts at a degree; n and r of each row are those of its angles."""
    _, out, _ = run(capsys, "--scene", f"{file}#pole", "--until", "10800", "--count", "5", verb="motion")
    rows = list(csv.DictReader(line for line in out.splitlines() if not line.startswith("#")))
    assert float(rows[0]["roll"]) == pytest.approx(0.017453292519943295, abs=1e-15)
    assert float(rows[0]["pitch"]) == float(rows[0]["yaw"]) == 0
    assert float(rows[4]["orbits"]) == pytest.approx(0.0011 * 10800 / 6.283185307179586, rel=1e-14)
    assert "phi" not in rows[0]


@pytest.mark.slow
def test_a_chart_and_its_data(capsys, file, tmp_path):
    """Two names of the body, damped too."""
    import xarray as xr
    for name in ("chart.png", "chart.nc"):
        status, _, _ = run(capsys, "--orbit", "1", "--x", "I2=0.5:1:20", "--y", "l=-1:1:15", "--set",
                           "I1=1", "I3=4/5",
                           "--damped", "--output", str(tmp_path / name), verb="chart")
        assert status == 0
    with xr.open_dataset(tmp_path / "chart.nc") as found:
        code = dict(zip(found.verdict.flag_meanings.split(), found.verdict.flag_values))
        here = found.sel(I2=0.5, l=1.0)
        assert here.verdict == code["unstable"]           # l + 4 (I2 − I3) < 0
        assert found.sel(I2=1.0, l=1.0).verdict == code["stable"]


REFUSED = [
    ("decide", ("--equilibrium", "earth-pointing"), "a satellite in orbit, and this body is in no orbit"),
    ("decide", ("--orbit", "1", "--equilibrium", "E1"), "is one of a body in a field fixed in space"),
    ("decide", ("--orbit", "1", "--equilibrium", "axis 1"), "is one of a free body"),
    ("decide", (*BODY, "--potential", "k1*k3"), "a direction fixed in space"),
    ("report", (*BODY, "--potential", "U(k3)"), "unspecified"),
    ("report", ("--potential", "3/2*w^2*(I1*r1^2 + I3*n3^2)"), "--orbit, which has the gravity gradient"),
    ("report", ("--orbit", "0"), "rate = 0"), ("report", ("--orbit", "-1"), "rate = -1"),
    ("report", ("--orbit", "mu=1,radius=0"), "radius = 0"), ("report", ("--orbit", "mu=1"), "is given alone"),
    ("report", ("--orbit", "rate=1,mu=3,radius=2"), "0.612372435696"),
    ("report", ("--orbit", "speed=2"), "give its rate"), ("report", ("--orbit", ""), "give its rate"),
    ("report", ("--orbit", "mu=1,altitude=2"), "height=500 km"),
    ("decide", ("--orbit", "1", "--inertia", "41,1,1;1,58,0;1,0,25", "--gyrostatic-momentum", "0,1,0",
                "--equilibrium", "earth-pointing"), "t·Ir = 1, l·t + ω0 t·In = 1, and each must be 0"),
    ("report", (*BODY, "--equilibrium", "conical"), "moments I1, I1, I3 and rotor 0, 0, l"),
    ("report", ("--orbit", "3 kg"), "rate"), ("report", ("--orbit", "-omega0"), "is positive"),
    ("report", ("--orbit", "n1"), "a direction that moves"),
    ("report", ("--orbit", "mu=k3,radius=1"), "k3, the direction of the field"),
    ("report", ("--orbit", "mu=1,mu=2,radius=3"), "cannot read"),
    ("motion", (*BODY, "--until", "1", "--release", "5 kg,0,0"), "angle of roll"),
    ("report", ("--orbit", "1", "--pointing", "1,1,2"), "in some order"),
    ("report", ("--orbit", "1", "--pointing", "1,2"), "in some order"),
    ("decide", (*BODY, "--equilibrium", "earth-pointing", "--normal-form", "4"), "normal form"),
    ("motion", (*BODY, "--until", "1"), "--release"),
    ("motion", (*BODY, "--until", "1", "--state", "0,0,0"), "9 coordinates"),
    ("motion", (*BODY, "--until", "1", "--release", "0,0"), "2 angles"),
    ("motion", ("--potential", "none", "--set", "I1=1", "I2=2", "I3=2", "l=0", "--until", "1", "--release",
     "0,0,0"),
     "add --orbit"),
    ("motion", (*BODY, "--until", "1", "--release", "0,0,0", "--precision", "20"), "digits")]


@pytest.mark.parametrize(("verb", "arguments", "why"), REFUSED)
def test_refusals(capsys, verb, arguments, why):
    """One sentence, exit 2."""
    status, out, err = run(capsys, *arguments, verb=verb)
    assert status == 2 and not out and why in err and err.count("\n") == 1 and "internal" not in err


@pytest.mark.parametrize(("kind", "more"), [
    ("momentum-sphere", ("--momentum", "1")), ("rotor-set", ("--momentum", "1")), ("staude-cone", ()),
    ("effective-potential", ()), ("energy-momentum", ()), ("amended-potential", ()), ("staude-plane", ())])
def test_pictures_of_other_scenes(capsys, file, tmp_path, kind, more):
    """Each says what it is of."""
    status, _, err = run(capsys, kind, "--scene", f"{file}#leo", *more, "--output", str(tmp_path / "x.png"),
                         verb="plot")

    assert status == 2 and err.count("\n") == 1 and "internal" not in err
    assert "orbit" in err or "direction" in err


@pytest.mark.slow
def test_a_component_of_the_size_of_a_rounding(capsys):
    """n₂ and r₂ are linear in it: the same digits with 10⁻¹⁵ and with 10⁻³⁰, and the same verdicts."""
    shown = []
    for power in (15, 30):
        status, out, _ = run(capsys, "--orbit", "1", "--inertia", "1.1,3/2,2",
                             f"--gyrostatic-momentum=-2,1e-{power},-1/3", "--full", verb="decide")
        assert status == 0 and out.count("Verdict") == 12
        out = out[out.index("\n1  equilibrium"):]
        shown.append((re.sub(r"\d\.\d+…?(·10⁻[⁰¹²³⁴-⁹]+)?", "", out),
                      [float(digits) for digits in re.findall(r"(\d\.\d+)", out)]))
    assert shown[0][0] == shown[1][0]
    assert shown[0][1] == pytest.approx(shown[1][1], rel=1e-4)             # six digits are printed


@pytest.mark.parametrize(("verb", "options"), [
    ("conditions", ["--solve-for", "l", "--set", "I1=8.79e34", "I2=8.82e34", "I3=8.80e34", "omega0=2.66e-6"]),
    ("decide", ["--set", "I1=8.79e34", "I2=8.82e34", "I3=8.80e34", "omega0=2.66e-6", "l=1e25"])])
def test_the_moon_in_si(capsys, verb, options):
    """As in units in which a moment of 10³⁵ kg m² and the rate are near 1, with l in that of the two."""
    shown = []
    for given in (options, [x.replace("e34", "").replace("e-6", "").replace("l=1e25", "l=1e-3")
                            for x in options]):
        status, out, err = run(capsys, "--orbit", "omega0", *given, verb=verb)
        assert status == 0 and not err
        shown.append([line for line in out.splitlines() if "Verdict" in line or "table" in line])
    assert shown[0] == shown[1] and shown[0]
