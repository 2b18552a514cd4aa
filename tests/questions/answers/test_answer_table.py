"""The table of decide."""
from commands import decide

import gyrostat as gs

TOP = ["--potential", "m0*k3", "--set", "I1=1", "I3=8/5", "l=0", "m0=1", "omega=2"]
WELLS = ["--potential", "k3^4 - k3^2/2", "--set", "I1=2", "I3=1", "l=0", "omega=1/2"]
BODY = ["--potential", "none", "--inertia", "3 kg m^2,2 kg m^2,1 kg m^2", "--gyrostatic-momentum",
        "0,0,0.1 N m s", "--momentum", "2 N m s"]
SATELLITE = ["--orbit", "1", "--inertia", "1,5/4,8/5", "--gyrostatic-momentum", "3/10,1/5,1/10"]


def rows(out):
    """The cells of each row of a table."""
    cells = [line.split() for line in out.split("\n\n")[1].splitlines()]
    return [row for row in cells if row[0].isdecimal()]


def test_the_answer_comes_first(capsys):
    """How many are stable, a row for each, what the words mean, and how to see more."""
    status, out, err = decide(capsys, *TOP)
    assert (status, err) == (0, "") and out.startswith("3 relative equilibria: 3 stable.\n\n#  name ")
    assert rows(out) == [["1", "E1", "1", "2", "0", "stable", "stable"],
                         ["2", "E3", "5/12", "2", "0", *"stable mod π₃ unstable mod π₃".split()],
                         ["3", "E2", "−1", "2", "0", "stable", "stable"]]
    assert "mod π₃: modulo the flow of π₃." in " ".join(out.split()) and "Verdict" not in out
    assert out.endswith("  Details: --full\n")


def test_full_adds_the_details_by_number(capsys):
    """Below the same table."""
    _, short, _ = decide(capsys, *TOP)
    _, out, _ = decide(capsys, *TOP, "--full")
    assert out.startswith(short[:short.index("  Details")]) and "Details: --full" not in out
    assert "\n2  E3\n══" in out and out.count("Verdict: ") == 3 and "k₃ = 5/12\n" in out


def test_one_that_is_named_has_no_table(capsys):
    """Its details are what is asked for, at each of three tilts."""
    _, out, _ = decide(capsys, *WELLS, "--equilibrium", "E3")
    assert out.startswith("E3\n══\n") and "Details: --full" not in out
    assert out.count("E3\n══\n") == 3 and out.count("k₃ = ") == 3


def test_rows_of_a_satellite_are_those_of_the_list(capsys):
    """Angles and verdict of each, in the order of relative_equilibria; a label that all have is said once."""
    _, out, _ = decide(capsys, *SATELLITE)
    body = gs.Gyrostat((1, "5/4", "8/5"), ("3/10", "1/5", "1/10"))
    found = gs.relative_equilibria(gs.assemble(body, gs.circular_orbit(1)), {})
    table = rows(out)
    assert out.startswith(f"{len(found)} relative equilibria (equilibrium in orbit): 2 stable")
    assert len(table) == len(found)
    for n, (row, e) in enumerate(zip(table, found), 1):
        assert row[0] == str(n) and row[4] == e.decision.verdict.name.lower()
        shown = [float(x.replace("−", "-")) for x in row[1:4]]
        angles = e.attitude.roll, e.attitude.pitch, e.attitude.yaw
        assert max(abs(x - y) for x, y in zip(shown, angles)) < 0.0051


def test_at_a_pitch_of_90_degrees_the_row_says_what_is_determined(capsys):
    """Roll and yaw are left out; below the row stands their difference or their sum."""
    _, out, _ = decide(capsys, "--orbit", "1", "--inertia", "60,70,35", "--gyrostatic-momentum", "0,0,0")
    assert out.count("° is determined\n") == 8 and "yaw about r, then by pitch" in " ".join(out.split())
    (fifth,) = (row for row in rows(out) if row[0] == "5")
    assert fifth == ["5", "90.00", "unstable", "unstable"]


def test_columns_have_units_if_the_numbers_have(capsys):
    """Momenta and rates in SI; without units in the input there are none."""
    _, out, _ = decide(capsys, *BODY)
    units = out.splitlines()[3]
    assert units.count("kg m² s⁻¹") == 3 and "rad/s" in units
    _, full, _ = decide(capsys, *BODY, "--full")
    assert "π₃ = 19/10 kg m² s⁻¹\n" in full and "frequency₁ = √111/10 ≈ 1.054 rad/s\n" in full
    assert "growth_rate = √33/10 ≈ 0.5745 1/s\n" in full
    _, bare, _ = decide(capsys, *(x.replace(" kg m^2", "").replace(" N m s", "") for x in BODY))
    assert "rad/s" not in bare and rows(bare) == rows(out)
