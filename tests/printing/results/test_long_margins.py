"""Long margins of a decision are shown by their names, and kept whole in JSON."""
import json

import pytest
from commands import decide, run

BODY = ["--inertia", "I1,I2,I3", "--gyrostatic-momentum", "a1,a2,a3", "--potential",
        "(4*I1*w^2+6*a1*w+4*s0)*k1/6+(2*I2*w^2+6*a2*w+2*s0)*k2/6+(4*I3*w^2+6*a3*w+4*s0)*k3/6",
        "--point", "2*I1*w/3,I2*w/3,2*I3*w/3,2/3,1/3,2/3",
        "--set", "w=-1", "I1=3", "I2=5", "I3=4", "a1=1", "a2=0", "a3=2"]


@pytest.mark.slow
@pytest.mark.parametrize("sigma, said, shown", [
    (-4, "unstable", {"t": 42, "s": -12, "p": 1402, "p² − 4q": 1974244}),
    (-40, "Lyapunov stable", {"t": 7170, "s": 129804})])
def test_long_margins_are_named_with_their_values(capsys, sigma, said, shown):
    status, text, _ = decide(capsys, *BODY, f"s0={sigma}")
    assert (status, f"Verdict: {said}" in text, len(text) < 700) == (0, True, True)
    lines = [line.strip() for line in text.splitlines()]
    assert [line.replace("−", "-") for line in lines if line.startswith("margin")] == [
        f"margin of {x} = {v}".replace("−", "-") for x, v in shown.items()]
    assert "Here t and s are the trace and the determinant" in text
    found = json.loads(decide(capsys, *BODY, f"s0={sigma}", "--format", "json")[1])
    margins = found["equilibria"][0]["decision"]["margins"]
    assert list(margins.values()) == [str(v) for v in shown.values()] and min(map(len, margins)) > 200


@pytest.mark.slow
def test_in_latex(capsys):
    text = run(capsys, *BODY, "s0=-4", "--format", "latex")[1]
    assert r"\text{margin of }p^2 - 4q = 1974244" in text


def test_short_margins_are_written_out(capsys):
    spin = ["--inertia", "3,5,4", "--gyrostatic-momentum", "0,0,0", "--potential", "m0*k3",
            "--point", "0,0,4*w,0,0,1", "--set", "w=3", "m0=1"]
    text = decide(capsys, *spin)[1]
    assert "−m₀ − w² = −10" in text and "margin of" not in text
