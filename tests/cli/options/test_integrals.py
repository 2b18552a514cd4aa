"""--integral, and integrals of a scene file: text, LaTeX, JSON, a motion."""
import json

import pytest
from commands import decide, run

SCENE = ["--inertia", "2,2,1", "--gyrostatic-momentum", "0,0,0", "--potential", "m0*k1", "--set", "m0=5/13"]
POINT = ["--point", "10/13,0,12/13,5/13,0,12/13"]
F = "(M1^2 - M2^2 - 4*m0*k1)^2 + (2*M1*M2 - 4*m0*k2)^2"
FILE = f"""
[scene.kowalevski]
inertia = [2, 2, 1]
potential = "m0*k1"
integrals = ["{F}"]
point = ["10/13", 0, "12/13", "5/13", 0, "12/13"]
values = {{ m0 = "5/13" }}
"""


@pytest.mark.slow
def test_what_an_integral_proves(capsys, tmp_path):
    """The Casimirs leave it to Arnold's theorem; the integral proves it, by an option and by a file."""
    _, without, _ = decide(capsys, *SCENE, *POINT)
    assert "Arnold-Moser" in without
    status, out, err = decide(capsys, *SCENE, *POINT, "--integral", F)
    assert (status, err) == (0, "")
    assert "Reason (Lyapunov): the second variation of h − F1 is definite" in out
    (tmp_path / "s.toml").write_text(FILE)
    assert decide(capsys, "--scene", str(tmp_path / "s.toml"))[1] == out
    _, data, _ = decide(capsys, "--scene", str(tmp_path / "s.toml"), "--format", "json")
    (found,) = json.loads(data)["equilibria"]
    assert found["decision"]["notion"] == "Lyapunov" and "F1 is definite" in found["decision"]["reason"]
    assert "Certificate: h + (−1) ((π₁² − π₂² − 20 k₁/13)² + (2 π₁ π₂ − 20 k₂/13)²)" in out
    assert found["decision"]["certificate"] == {
        "(-20*k2/13 + 2*pi1*pi2)**2 + (-20*k1/13 + pi1**2 - pi2**2)**2": "-1"}


@pytest.mark.slow
def test_conditions_with_it(capsys):
    """α is eliminated; what the conditions are then is said, and the values of one name are found."""
    m = "(5/13*w^2 - 5/12*w*s)"
    F = (f"(M1^2 - M2^2 - 4*{m}*k1)^2 + (2*M1*M2 - 4*{m}*k2)^2 + 8*s*(M3 - 2*s)*(M1^2 + M2^2)"
         f" - 32*s*{m}*M1*k3")
    scene = ["--inertia", "2,2,1", "--gyrostatic-momentum", "0,0,s", "--potential", f"{m}*k1", "--point",
             "10/13*w,0,12/13*w,5/13,0,12/13", "--integral", F]
    status, out, err = run(capsys, *scene, verb="conditions")
    assert (status, err) == (0, "")
    assert "and 13 s + 12 w ≠ 0" in out and "α is eliminated" in out
    _, out, _ = run(capsys, *scene, "--set", "w=1", "--solve-for", "s", verb="conditions")
    assert "−12/13 < s < −25/156 or −25/156 < s < 47/78 or s ≥ 12/13" in out


@pytest.mark.slow
def test_printed_with_the_scene(capsys):
    """In words, set in LaTeX, as data; where it is conserved on a level only, that level."""
    _, out, _ = run(capsys, *SCENE, *POINT, "--integral", F)
    assert ("An integral was given, with {F, h} = 0:\n"
            "    F₁ = (π₁² − π₂² − 4 m₀ k₁)² + (2 π₁ π₂ − 4 m₀ k₂)²\n") in out
    _, out, _ = run(capsys, *SCENE, *POINT, "--integral", F, "--format", "latex")
    assert r"F_{1} = \left(\pi_1^{2} - \pi_2^{2} - 4 m_0 k_1\right)^{2}" in out
    _, out, _ = run(capsys, *SCENE, *POINT, "--integral", F, "--format", "json")
    (shown,) = json.loads(out)["integrals"]
    assert shown == "(-4*k2*m0 + 2*pi1*pi2)**2 + (-4*k1*m0 + pi1**2 - pi2**2)**2"
    level = ["--inertia", "4,4,1", "--gyrostatic-momentum", "0,0,0", "--potential", "k1",
             "--point", "0,0,0,1,0,0"]
    _, out, _ = run(capsys, *level, "--integral", "M3*(M1^2 + M2^2) - 4*M1*k3")
    assert "An integral was given, with {F, h} = 0 if C₁ = 0:" in out


@pytest.mark.slow
def test_monitored_and_refused(capsys):
    """A motion takes it; what is no integral is refused in one line."""
    state = ["--state", "1,1/2,2,0,3/5,4/5", "--until", "1", "--count", "2"]
    status, out, _ = run(capsys, *SCENE, *state, "--integral", F, verb="motion")
    assert status == 0 and out
    status, out, err = decide(capsys, *SCENE, *POINT, "--integral", "M1^2")
    assert (status, out) == (2, "") and err.count("\n") == 1
    assert "pi1**2 is not an integral: its bracket with the Hamiltonian is pi1*pi2*pi3, not 0" in err
