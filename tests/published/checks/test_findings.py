"""Published formulas: statuses, and counterexamples that confirm themselves."""
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import bench_verify
import numpy as np
import oracle
import pytest
from published.read_again import is_shown
from published.written_sources import BY_KEY, LONG, written
from sympy import Expr

import gyrostat
from gyrostat.published import SOURCES, check, load
from gyrostat.published.checks.findings import _finding, outcome_of
from gyrostat.published.latex import latex

HERE, PAGES = Path(gyrostat.__file__).parent / "published", Path(__file__).parents[3]


@pytest.fixture(scope="module")
def found():
    """The findings of every source, but for the long ones."""
    return {name: [_finding(load(name), s) for s in load(name).statements if (name, s.key) not in LONG]
            for name in SOURCES}


@pytest.mark.slow
@pytest.mark.parametrize("source", SOURCES)
def test_every_status_is_the_expected_one(source, found):
    """What is computed is what expected.toml says, statement by statement."""
    assert {f.statement.key: f.status for f in found[source]} == {
        f.statement.key: f.expected for f in found[source]
    }


def test_no_status_is_stored_with_a_statement():
    """The files hold what is printed; a status is computed."""
    for source in SOURCES:
        text = (HERE / f"{source}.toml").read_text(encoding="utf-8")
        assert not any(f'"{word}"' in text or f"\n{word}" in text
                       for word in ("confirmed", "misprint", "status"))


def shows_what_is_right(finding):
    """A counterexample in numbers, with its confirmation, and the derived or corrected formula."""
    c = finding.outcome.counterexample
    assert c and c.values and c.confirmation and c.printed != c.derived
    assert finding.outcome.corrected is not None or finding.outcome.derived is not None
    assert all(isinstance(value, Expr) and not value.free_symbols for _, value in c.values)


def read_again(finding):
    """Whether its counterexample is one by its JSON, at which what is corrected does not fail."""
    s = finding.statement
    assert s.corrected is None or s.kind == "solution" or not is_shown(finding, s.corrected), s.key
    return is_shown(finding)


@pytest.mark.slow
def test_every_misprint_has_a_counterexample(found):
    """Values at which printed and derived differ, and a confirmation; every formula says what is right."""
    wrong = [f for rows in found.values() for f in rows if f.status == "misprint"]
    # and one that is long
    assert len(wrong) == 38
    for f in wrong:
        shows_what_is_right(f)


@pytest.mark.slow
def test_every_counterexample_is_read_again(found):
    """Both sides, or what is true of the point, from the JSON output.

    What is corrected does not fail there.
    """
    read = {f.statement.key: read_again(f) for rows in found.values() for f in rows if f.status == "misprint"}
    # numpy counts its squares below
    assert {key for key, answer in read.items() if not answer} == {"E3-semidefinite"}


@pytest.mark.slow
@pytest.mark.parametrize(("source", "key"), sorted(LONG))
def test_a_long_statement(source, key):
    """The same of those that take longest."""
    finding = _finding(load(source), BY_KEY[source, key])
    assert finding.status == finding.expected
    if finding.status == "misprint":
        shows_what_is_right(finding)
        assert read_again(finding)


@pytest.mark.slow
def test_every_unchecked_statement_says_why(found):
    """Nothing is left open without a reason."""
    assert all(f.statement.note for rows in found.values() for f in rows if f.status == "unchecked")


@pytest.mark.slow
@pytest.mark.parametrize(("key", "entry"), [("E3-b", (0, 2)), ("E3-c", (1, 2)), ("E3-matrix", (3, 5))])
def test_entries_of_the_inclined_matrix_against_the_oracle(key, entry, found):
    """The differenced Euler-Poisson field has the derived entry at the counterexample, not the printed one.
    """
    (f,) = (f for f in found["VV2003"] if f.statement.key == key)
    v = {name: Fraction(str(value)) for name, value in f.outcome.counterexample.values}
    x, field = oracle.inclined(v["I1"], v["I3"], v["l"], v["omega"], (v["k1"], v["k2"], v["k3"]), Fraction(0))
    theirs = oracle.jacobian(field, x)[entry]
    assert (
        theirs
        == Fraction(str(f.outcome.counterexample.derived))
        != Fraction(str(f.outcome.counterexample.printed))
    )


@pytest.mark.slow
def test_tilt_at_k3_zero_against_the_oracle(found):
    """Where the printed necessary condition for k3 = 0 fails, the field has no growing mode."""
    (f,) = (f for f in found["VV2003"] if f.statement.key == "k3-zero-necessary")
    v = {name: Fraction(str(value)) for name, value in f.outcome.counterexample.values}
    x, field = oracle.inclined(v["I1"], v["I3"], v["l"], v["omega"], (v["k1"], v["k2"], Fraction(0)),
                               v["d2U"])
    assert v["l"]**4 + v["m0"]**2 * v["I1"]**2 - v["d2U"] * v["l"]**2 * v["I1"] < 0
    assert not oracle.growth(field, x)


@pytest.mark.slow
def test_critical_top_against_the_oracle(found):
    """At equality in Rumiantsev's condition the reduced motion has its maximum at the pole.

    There g = −2 I1 m g z0 x³ < 0.
    """
    (f,) = (f for f in found["VV2003"] if f.statement.key == "Rumiantsev")
    v = {name: Fraction(str(value)) for name, value in f.outcome.counterexample.values}
    P, weight = v["I3"] * v["omega3_0"] + v["l"], v["m"] * v["g"] * v["z0"]
    assert P**2 == 4 * v["I1"] * weight and weight > 0
    for x in (Fraction(1, 10**6), Fraction(1, 2), Fraction(2)):
        z = 1 - x
        g = oracle.reduced(v["I1"], v["l"], v["I3"] * v["omega3_0"], P, weight, weight * z, weight,
                           Fraction(0), z)[0]
        assert g == -2 * v["I1"] * weight * x**3 < 0


@pytest.mark.slow
def test_progress(found):
    """Called once for each statement, with the total of the source."""
    seen = []
    check(["AR"], lambda source, done, total: seen.append((source, done, total)))
    assert seen == [("AR", n, len(found["AR"])) for n in range(1, len(found["AR"]) + 1)]


@pytest.mark.slow
def test_second_variation_at_a_tilt_has_both_signs(found):
    """The form of the Casimirs alone, by numpy at the counterexample.

    Two positive, one zero and one negative eigenvalue.
    """
    (f,) = (f for f in found["VV2003"] if f.statement.key == "E3-semidefinite")
    v = {name: float(value) for name, value in f.outcome.counterexample.values}
    k, omega = np.array([v["k1"], v["k2"], v["k3"]]), v["omega"]
    inertia, rotor = np.array([v["I1"], v["I1"], v["I3"]]), np.array([0, 0, v["l"]])
    form = np.zeros((6, 6))                                                # D²(h − ω M·k + ½ I1 ω² |k|²)
    form[:3, :3], form[:3, 3:], form[3:, :3] = np.diag(1 / inertia), -omega * np.eye(3), -omega * np.eye(3)
    form[3:, 3:] = v["I1"] * omega**2 * np.eye(3) + np.diag([0, 0, v["d2U"]])
    constraints = np.array([[*k, *(inertia * omega * k + rotor)], [0, 0, 0, *k]])
    kernel = np.linalg.svd(constraints)[2][2:].T
    values = np.sort(np.linalg.eigvalsh(kernel.T @ form @ kernel))
    # rounding of eigenvalues of order one
    assert values[0] < -1e-6 and abs(values[1]) < 1e-9 and values[2] > 1e-6


def test_pages_count_the_statements():
    """Those of three collections."""
    counts = [len(load(source).statements) for source in SOURCES]
    page = (PAGES / "docs/reference/published.md").read_text(encoding="utf-8")
    assert f"four sources print, and {sum(counts[4:])} results of the literature beside them, in three" \
        in page


@pytest.mark.slow
def test_the_identities_of_which_the_zero_test_is_timed_vanish():
    """All that are confirmed."""
    formulas = bench_verify.differences()
    assert all(map(bench_verify.vanishes, (entry for formula in formulas for entry in formula)))


@pytest.mark.slow
def test_the_page_is_true(tmp_path, found):
    """Its example of a file is confirmed, and its table counts what is computed."""
    text = (PAGES / "docs/reference/published.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)
    (finding,) = check([written(tmp_path, example)])
    assert finding.status == "confirmed"
    for source, rows in found.items():
        (row,) = (line for line in text.splitlines() if line.startswith("|") and f"`{source}`" in line)
        found_or_long = [f.status for f in rows] + [load(source).expected.get(key, "confirmed")
                                                    for name, key in LONG if name == source]
        counts = map(found_or_long.count, ("confirmed", "misprint", "unchecked"))
        assert list(map(int, re.findall(r"\| (\d+) (?=\|)", row))) == [len(found_or_long), *counts]


def test_the_sources_agree_where_they_print_the_same():
    """Euler's equations as N2025, EA and AR print them are one."""
    rates = [outcome_of(BY_KEY[key]).derived for key in (("N2025", "free-1"), ("AR", "determinant-momenta"))]
    assert (rates[0] - rates[1][0]).expand() == 0


@pytest.mark.slow
def test_errata_of_odd_texts_compile(found):
    """Special characters of LaTeX and letters it does not know are set or replaced."""
    finding = next(f for f in found["AR"] if f.status == "misprint")
    odd = replace(finding, statement=replace(finding.statement,
                                             note="50% of $x_1 & #2 \\foo {~^} \U0001d714"))
    tex = latex([odd])
    assert r"50\% of \$x\_1 \& \#2 \char92 foo \{\char126 \char94 \} (mathematical italic small omega)" in tex
