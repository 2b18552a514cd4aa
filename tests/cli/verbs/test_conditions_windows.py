"""conditions --windows of every permanent rotation."""
from commands import run


def test_windows_in_any_direction_ask_for_one(capsys):
    """The conditions are there, and the sentence in the place of a formula."""
    status, out, _ = run(capsys, "--potential", "c1*k1 + c2*k2 + c3*k3", "--windows", "--equilibrium",
                         "permanent-rotation", verb="conditions")
    assert status == 0 and "give a direction by stereographic coordinates" in " ".join(out.split())
