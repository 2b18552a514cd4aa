"""The direction of a permanent rotation in the table of a scene."""
import json

import pytest
from commands import run

FILE = """
[scene.any]
inertia = [1, 2, 3]
potential = "c1*k1 + c2*k2 + c3*k3"
equilibrium = "permanent-rotation"
direction = {}
values = {{ {}, omega = 2, sigma = -13 }}
"""


@pytest.mark.parametrize("text, option, values", [
    ('"stereographic"', "stereographic", 'u1 = "1/2", u2 = 0'),
    ('["sin(a)", 0, "cos(a)"]', "sin(a),0,cos(a)", "a = 0")])
def test_a_direction_in_a_file_is_that_of_the_option(capsys, tmp_path, text, option, values):
    """The verdict, at the values of the file."""
    path = tmp_path / "scenes.toml"
    path.write_text(FILE.format(text, values))
    _, found, _ = run(capsys, "--scene", str(path), "--format", "json", verb="decide")
    plain = tmp_path / "plain.toml"
    plain.write_text("\n".join(line for line in path.read_text().splitlines()
                               if not line.startswith("direction")))
    _, named, _ = run(capsys, "--scene", str(plain), "--direction", option, "--format", "json", verb="decide")
    assert found == named and json.loads(found)["equilibria"][0]["decision"]["margins"]


def test_what_is_no_direction_is_refused(capsys, tmp_path):
    """Two expressions are none."""
    path = tmp_path / "scenes.toml"
    path.write_text(FILE.format("[1, 0]", "a = 0"))
    status, _, said = run(capsys, "--scene", str(path), verb="decide")
    assert status == 2 and "give three expressions that make a unit vector" in said
