"""gyrostat conditions --solve-for the speed of a wheel in orbit: sentences, LaTeX, data."""
import json

from commands import run

SHEET = ("--orbit", "height=500 km", "--inertia", "[[62.1,1.3,0],[1.3,71.4,0],[0,0,38.2]] kg m^2")
WHEEL = ("--wheel", "axis=0,1,0 inertia=0.02 kg m^2 speed=s", "--solve-for", "s")


def test_the_speed_of_a_wheel_is_a_sentence_with_a_decimal_and_a_unit(capsys):
    """First; numbers without units have none; an open orbit is solved in its name as before."""
    _, out, _ = run(capsys, *SHEET, *WHEEL, verb="conditions")
    answer = out.split("\n")[2]
    assert answer.startswith("  Stable for a wheel speed above −") and answer.endswith(" rpm.")
    assert "if other wheels carry besides the momentum (−0.00143882, 0, 0) N m s" in " ".join(out.split())
    plain = ("--orbit", "1", "--inertia", "1,7/10,4/5", "--wheel", "axis=0,1,0 inertia=1/100 speed=s",
             "--solve-for", "s")
    _, out, _ = run(capsys, *plain, verb="conditions")
    assert "Stable for s above 40.\n" in out and "rpm" not in out
    _, out, _ = run(capsys, *plain, "--orbit", "omega0", verb="conditions")
    assert "Stable by the second variation" in out


def test_the_speed_of_a_wheel_as_latex_and_data(capsys):
    """Exact ends, what others carry, and the turn; the attitude is that of --pointing."""
    _, out, _ = run(capsys, *SHEET, *WHEEL, "--format", "latex", "--fragment", verb="conditions")
    assert r"Stable for a wheel speed above $-" in out
    _, out, _ = run(capsys, *SHEET, *WHEEL, "--format", "json", verb="conditions")
    (found,) = json.loads(out)["equilibria"]
    assert [part["meaning"] for part in found["parts"]] == ["stable", "unstable", "undecided"]
    assert found["turn"] == "0" and found["carried"][1:] == ["0", "0"] and found["only"] is None
    _, out, _ = run(capsys, *SHEET, *WHEEL, "--pointing", "1,3,2", "--format", "json", verb="conditions")
    (found,) = json.loads(out)["equilibria"]
    assert found["turn"] == "atan(26/93)/2" and found["only"] == "0"
