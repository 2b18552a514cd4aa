"""gyrostat conditions --solve-for the speed of a wheel in orbit: sentences, LaTeX, data."""
import json

import pytest
from commands import run
from sympy import Matrix, cancel, symbols, sympify

SHEET = ("--orbit", "height=500 km", "--inertia", "[[62.1,1.3,0],[1.3,71.4,0],[0,0,38.2]] kg m^2")
WHEEL = ("--wheel", "axis=0,1,0 inertia=0.02 kg m^2 speed=s", "--solve-for", "s")


@pytest.mark.slow
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
    for given, unit in (("speed=s", "rad/s"), ("momentum=s", "kg m² s⁻¹")):
        asked = ("--potential", "f*t1", "--set", "f=0.00001 N m", "--solve-for", "s",
                 "--wheel", f"axis=0,1,0 inertia=0.02 kg m^2 {given}")
        _, out, _ = run(capsys, *SHEET[:2], "--inertia", "62,71,38 kg m^2", *asked, verb="conditions")
        assert f"\n  s is in {unit}." in out
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


def test_a_tensor_with_products_has_conditions_with_the_momentum_that_holds_it(capsys):
    """In names, against K of the tensor; without that momentum the refusal says in short what to do."""
    tensor = ("--orbit", "1", "--inertia", "[[I1,I12,0],[I12,I2,I23],[0,I23,I3]]")
    _, out, _ = run(capsys, *tensor, "--gyrostatic-momentum", "held", "--format", "json", verb="conditions")
    (found, _) = json.loads(out)["equilibria"]
    margins = [sympify(c["margin"]) for c in found["damped"]["any_of"][0]["all_of"]]
    I1, I2, I3, u, v, l = symbols("I1 I2 I3 I12 I23 l")
    K = Matrix([[4 * (I2 - I3) + l, -3 * u, 0], [-3 * u, 3 * (I1 - I3), 3 * v], [0, 3 * v, I2 - I1 + l]])
    for margin, minor in zip(margins, (K[0, 0], K[:2, :2].det(), K.det()), strict=True):
        ratio = cancel(minor / margin)
        assert ratio.is_number and ratio > 0
    for inertia, why in (("[[3,1,0],[1,4,0],[0,0,2]]", "give the momentum held"),
                         ("[[3,1/7,1/3],[1/7,4,1/9],[1/3,1/9,2]]", "turn the body about the normal")):
        sheet = ("--orbit", "height=500 km", "--inertia", f"{inertia} kg m^2")
        status, out, err = run(capsys, *sheet, verb="conditions")
        assert status == 2 and not out and why in err and len(" ".join(err.split())) <= 310
    status, _, err = run(capsys, "--potential", "k3", "--gyrostatic-momentum", "held", verb="conditions")
    assert status == 2 and "in no orbit" in err
