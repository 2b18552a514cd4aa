"""gyrostat decide as CSV, JSON and LaTeX: read again, and compared with the list in Python."""
import csv
import io
import json
from fractions import Fraction

import pytest
from commands import decide
from sympy import Poly, Rational, Symbol, parse_expr

import gyrostat as gs

BODY = ["--inertia", "1,2,3", "--gyrostatic-momentum", "0,0,1/2"]
TORQUE_FREE = ["--potential", "none", *BODY, "--momentum", "2"]
HEAVY = ["--potential", "k1 + k2", *BODY, "--set", "omega=2"]
TOP = ["--potential", "k3", "--inertia", "1,1,3/2", "--gyrostatic-momentum", "0,0,0", "--set", "omega=2"]
SATELLITE = ["--orbit", "1", "--inertia", "1,5/4,8/5", "--gyrostatic-momentum", "3,2,1"]       # 8 attitudes
ASKED = {"free": TORQUE_FREE, "heavy": HEAVY, "top": TOP, "satellite": SATELLITE}


def listed(name):
    """The same list in Python."""
    scene, asked = {
        "free": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/2"))), {"M": 2}),
        "heavy": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/2")), gs.general_potential("k1 + k2")),
                  {"omega": 2}),
        "top": (gs.assemble(gs.Gyrostat((1, 1, "3/2"), (0, 0, 0)), gs.axial_potential("k3")), {"omega": 2}),
        "satellite": (gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (3, 2, 1)), gs.circular_orbit(1)), {})}[name]
    return gs.relative_equilibria(scene, asked)


@pytest.mark.parametrize("name", ASKED)
def test_csv_read_again_is_the_table_of_the_list(capsys, tmp_path, name):
    """To the last bit, by --format and by the suffix of --output; one line for each, whatever the text."""
    _, out, err = decide(capsys, *ASKED[name], "--format", "csv")
    file = tmp_path / "eq.csv"
    assert decide(capsys, *ASKED[name], "--output", str(file)) == (0, "", "") and not err
    assert file.read_text(encoding="utf-8") == out
    rows, wanted = list(csv.DictReader(io.StringIO(out))), gs.table(listed(name))
    assert list(rows[0]) == list(wanted[0]) and len(rows) == len(wanted) == out.count("\n") - 1
    for row, one in zip(rows, wanted):
        for key, value in one.items():
            read = row[key] if isinstance(value, str) else None if row[key] == "" else type(value)(row[key])
            assert read == value, key


@pytest.mark.parametrize("name", ASKED)
def test_json_has_the_numbers_of_the_table(capsys, name):
    """Place, attitude, frequencies and verdicts, each a plain number."""
    _, out, _ = decide(capsys, *ASKED[name], "--format", "json")
    for e, row in zip(json.loads(out)["equilibria"], gs.table(listed(name)), strict=True):
        assert e["number"] == row["number"] and e["place"] == {key: row[key] for key in e["place"]}
        assert [e["decision"]["verdict"], e["damped_decision"]["verdict"]] == [row["verdict"], row["damped"]]
        assert e["frequencies"] == [row[f"frequency_{n}"] for n in range(1, len(e["frequencies"]) + 1)]
        assert e["growth_rate"] == row["growth_rate"] and e["doubling_time"] == row["doubling_time"]
        assert (e["attitude"] is None) == (name != "satellite") and "exact" not in e
        for key in ("roll_deg", "pitch_deg", "yaw_deg") if e["attitude"] else ():
            assert e["attitude"][key] == row[key]
            assert e["attitude"]["scalar_last"] == [row[f"q_{x}"] for x in "xyzw"]
            assert sum(e["attitude"]["rotation"], []) == [row[f"{x}{n}"] for x in "tnr" for n in (1, 2, 3)]


def test_eight_attitudes_are_20_kilobytes_of_json(capsys):
    """At most, with numbers in a field of degree 24."""
    _, out, _ = decide(capsys, *SATELLITE, "--format", "json")
    assert len(json.loads(out)["equilibria"]) == 8 and len(out.encode()) < 20_000


@pytest.mark.slow
def test_exact_numbers_are_the_one_root_of_their_polynomial_in_an_interval(capsys):
    """Irreducible, by Sturm's theorem; the decimal is the double next to it."""
    _, out, _ = decide(capsys, *SATELLITE, "--format", "json", "--exact")
    x, degrees = Symbol("x"), set()
    for e in json.loads(out)["equilibria"][:2]:
        assert set(e["exact"]) == set(e["place"])
        for name, number in e["exact"].items():
            polynomial = Poly(parse_expr(number["polynomial"]), x)
            low, high = map(Fraction, number["interval"])
            assert polynomial.is_irreducible and polynomial.count_roots(
                *(Rational(end.numerator, end.denominator) for end in (low, high))) == 1
            assert low <= Fraction(e["place"][name]) + Fraction(1, 2**54) and float(low) == pytest.approx(
                e["place"][name], abs=1e-16)
            degrees.add(polynomial.degree())
    assert max(degrees) > 10


@pytest.mark.parametrize(("asked", "said"), [
    ([*TOP, "--exact"], "--exact gives polynomials in JSON"),
    ([*TOP, "--exact", "--format", "csv"], "--exact gives polynomials in JSON"),
    (["--potential", "k1 + k3", "--inertia", "1,2,3", "--gyrostatic-momentum", "0,0,0", "--format", "csv"],
     "a list of arcs is none"),
    (["--potential", "m0*k3", "--equilibrium", "E2", "--inertia", "5,4,3", "--normal-form", "4", "--format",
      "latex"], "a normal form is none")])
def test_what_is_no_table_is_refused(capsys, asked, said):
    """In a line that says what to write."""
    status, out, err = decide(capsys, *asked)
    assert (status, out) == (2, "") and said in " ".join(err.split()) and len(err) < 300


def test_what_cannot_be_answered_has_a_row_with_the_reason(capsys):
    """E3 in a field that is infinite at a pole."""
    _, out, _ = decide(capsys, "--potential", "exp(k3)", "--inertia", "1,1,2", "--gyrostatic-momentum",
                       "0,0,0", "--set", "omega=1", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert [row["label"] for row in rows] == ["E1", "E2", "E3"] and rows[2]["error"] and not rows[0]["error"]


def test_a_latex_table_has_a_row_for_each_and_the_numbers_of_the_list(capsys, tmp_path):
    """Angles, frequencies per orbit and verdicts; a fragment has no preamble. .ci/latex compiles it."""
    file = tmp_path / "eq.tex"
    assert decide(capsys, *SATELLITE, "--output", str(file))[0] == 0
    whole = file.read_text(encoding="ascii")
    _, part, _ = decide(capsys, *SATELLITE, "--format", "latex", "--fragment", "--label", "mine")
    assert whole.startswith("\\documentclass") and "documentclass" not in part
    assert r"\label{mine:equilibria}" in part and r"\label{gyrostat:equilibria}" in whole
    rows = [line.removesuffix(r" \\").split(" & ") for line in part.splitlines() if line[:1].isdecimal()]
    for row, one in zip(rows, gs.table(listed("satellite")), strict=True):
        numbers = [float(cell.replace("$-$", "-")) for cell in row[1:5]]
        wanted = [one["roll_deg"], one["pitch_deg"], one["yaw_deg"], one["frequency_1_per_orbit"]]
        assert all(abs(x - y) < 0.0051 for x, y in zip(numbers[:3], wanted))
        assert abs(numbers[3] / wanted[3] - 1) < 1e-3 and row[-2:] == [one["verdict"].lower(),
                                                                      one["damped"].lower()]


@pytest.mark.parametrize("asked", [[*SATELLITE, "--full"], SATELLITE, [*HEAVY, "--full"]])
def test_no_long_exact_number_is_printed(capsys, asked):
    """No word is longer than 60 characters, although n and r are roots of degree 24."""
    _, out, _ = decide(capsys, *asked)
    assert max(map(len, out.split())) <= 60 and "CRootOf" not in out
    if asked[0] == "--orbit" and "--full" in asked:
        assert out.count("attitude = roll ") == out.count("quaternion (w, x, y, z) = (") == 8
        assert out.count("frequency₁ per orbit = ") >= 2
