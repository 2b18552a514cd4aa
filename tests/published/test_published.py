"""Published formulas: statuses, counterexamples that confirm themselves, mutants, and files of a user's own.
"""
import ast
import re
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import oracle
import pytest
import shown
from sympy import Expr, MatrixBase, Rational

import gyrostat
from gyrostat.errors import ExpressionError, GyrostatError, PublishedError, ValuesError
from gyrostat.notation import symbol
from gyrostat.published import SOURCES, check, independent_names, load
from gyrostat.published.checks import _finding, outcome_of
from gyrostat.published.comparisons import comparisons
from gyrostat.published.errata import latex
from gyrostat.published.language import decimal, read
from gyrostat.published.listing import to_json
from gyrostat.published.readings import Reading
from gyrostat.published.typesetting import formula_of

HERE = Path(gyrostat.__file__).parent / "published"
# in one process, where every source is checked once
CHECKS = pytest.mark.xdist_group("checks")
STATEMENTS = [s for source in SOURCES for s in load(source).statements]
BY_KEY = {(s.source, s.key): s for s in STATEMENTS}


# each takes as long as some hundred others
LONG = {("N2025", key) for key in ("Euler-tensor", "Euler-epsilon", "Euler-tensor-two-dots",
                                   "transport-L")} | {
    ("EA", key) for key in ("4.29", "4.30", "4.31")} | {("literature", "S4-slow")}
# others like them are derived too
ALIKE = {("N2025", key) for key in ("Euler-2", "Euler-3", "dA", "dA-cause", "torque", "transport")} | {
    ("EA", "4.32-2"), ("EA", "4.32-3"), ("AR", "M-rate-1")}


@pytest.fixture(scope="module")
def found():
    """The findings of every source, but for the long ones."""
    return {name: [_finding(load(name), s) for s in load(name).statements if (name, s.key) not in LONG]
            for name in SOURCES}


@pytest.mark.parametrize("source", SOURCES)
@CHECKS
def test_every_status_is_the_expected_one(source, found):
    """What is computed is what expected.toml says, statement by statement."""
    assert {f.statement.key: f.status for f in found[source]} == {
        f.statement.key: f.expected for f in found[source]
    }


@pytest.mark.slow
@pytest.mark.parametrize(("source", "key"), sorted(LONG))
def test_a_long_statement_is_confirmed(source, key):
    """The same of those that take longest."""
    assert outcome_of(BY_KEY[source, key]).agrees is True


def test_no_status_is_stored_with_a_statement():
    """The files hold what is printed; a status is computed."""
    for source in SOURCES:
        text = (HERE / f"{source}.toml").read_text(encoding="utf-8")
        assert not any(f'"{word}"' in text or f"\n{word}" in text
                       for word in ("confirmed", "misprint", "status"))


@CHECKS
def test_every_misprint_has_a_counterexample(found):
    """Values at which printed and derived differ, and a confirmation; every formula says what is right."""
    wrong = [f for rows in found.values() for f in rows if f.status == "misprint"]
    assert len(wrong) == 33
    for f in wrong:
        c = f.outcome.counterexample
        assert c and c.values and c.confirmation and c.printed != c.derived
        assert f.outcome.corrected is not None or f.outcome.derived is not None
        assert all(isinstance(value, Expr) and not value.free_symbols for _, value in c.values)


@CHECKS
def test_every_counterexample_is_read_again(found):
    """Both sides, or what is true of the point, from the JSON output alone.

    What is corrected does not fail there.
    """
    read = {}
    for f in (f for rows in found.values() for f in rows if f.status == "misprint"):
        (data,) = to_json([f])
        s, entry = f.statement, (data["difference"] or [{"entry": None}])[0]["entry"]
        given = {"entry": entry, "let": dict(s.let), "at": dict(s.at), "given": s.given,
                 **{key: data[key] for key in ("quantity", "printed", "kind")}}
        read[s.key] = shown.is_true(given, dict(s.scene.table), data["counterexample"])
        right = {**given, "printed": s.corrected}
        assert (
            s.corrected is None
            or s.kind == "solution"
            or not shown.is_true(right, dict(s.scene.table), data["counterexample"])
        ), s.key
    # numpy counts its squares below
    assert {key for key, answer in read.items() if not answer} == {"E3-semidefinite"}


@CHECKS
def test_every_unchecked_statement_says_why(found):
    """Nothing is left open without a reason."""
    assert all(f.statement.note for rows in found.values() for f in rows if f.status == "unchecked")


@pytest.mark.parametrize(("key", "entry"), [("E3-b", (0, 2)), ("E3-c", (1, 2)), ("E3-matrix", (3, 5))])
@CHECKS
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


@CHECKS
def test_tilt_at_k3_zero_against_the_oracle(found):
    """Where the printed necessary condition for k3 = 0 fails, the field has no growing mode."""
    (f,) = (f for f in found["VV2003"] if f.statement.key == "k3-zero-necessary")
    v = {name: Fraction(str(value)) for name, value in f.outcome.counterexample.values}
    x, field = oracle.inclined(v["I1"], v["I3"], v["l"], v["omega"], (v["k1"], v["k2"], Fraction(0)),
                               v["d2U"])
    assert v["l"]**4 + v["m0"]**2 * v["I1"]**2 - v["d2U"] * v["l"]**2 * v["I1"] < 0
    assert not oracle.growth(field, x)


@CHECKS
def test_critical_top_against_the_oracle(found):
    """At equality in Rumiantsev's condition the reduced motion has its maximum at the pole.

    G = −2 I1 m g z0 x³ < 0.
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


@pytest.mark.parametrize("statement", [
    pytest.param(s, marks=[pytest.mark.slow] * ((s.source, s.key) in LONG | ALIKE), id=f"{s.source}:{s.key}")
    for s in STATEMENTS if s.kind in ("identity", "family") and "rank" not in str(s.quantity)])
def test_derived_quantities_are_those_of_newton_and_euler(statement):
    """Every quantity the library derives from the bracket, at numbers, by cross products and turns."""
    r = Reading(statement)
    derived = r.finish(read(statement.quantity, r.own))
    entries = list(derived) if isinstance(derived, MatrixBase) else [derived]
    printed = r.finish(read(statement.printed, r.own))
    values = next(v for v in r.points([*entries,
                                       *(printed if isinstance(printed, MatrixBase) else [printed])])
                  if all(e.subs(v).evalf(20).is_Number for e in entries))
    theirs = r.independently(statement.quantity, values)
    for ours, other in zip(entries, theirs if isinstance(theirs, MatrixBase) else [theirs]):
        value = independent_names.number(other, statement.scene, values)
        assert abs((ours.subs(values) - value).evalf(25)) < 1e-15 * (1 + abs(value.evalf(25)))


def test_independent_confirmation_uses_no_derivation():
    """Neither the bracket nor the linearisation nor the criteria stand behind a counterexample."""
    for name in ("independent", "independent_kinematics", "independent_separatrix"):
        tree = ast.parse((HERE / f"{name}.py").read_text(encoding="utf-8"))
        ours = {n.module for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) and n.level}
        assert ours <= {"errors", "algebra.exact", "notation", "scenes", "independent", "kinematics"}


MUTANTS = [
    ("VV2003", "symmetric-pi1", {"printed": "(I1 + I3)/(I1*I3)*pi2*pi3 - l*pi2/I2 + k2*dU"}),
    ("VV2003", "tensor", {"printed": [["0", "pi3"] + ["0"] * 4] + [["0"] * 6] * 5}),
    ("VV2003", "E3-p", {"printed": "I1*(1 - k3**2)*d3U - 2*I1*k3*dU + I1**2*(omega**2 + a**2)"}),
    ("VV2003", "E1-polynomial", {"let": {"a": "pi3_0/I3", "b": "(pi3_0 + l)/I1", "c": "dU", "d": "-1/I1"}}),
    ("VV2003", "E1-necessary", {"printed": "(pi3_0 + l)**2 >= 5*I1*dU"}),
    ("VV2003", "E1-necessary", {"printed": "(pi3_0 + l)**2 > 4*I1*dU"}),
    ("VV2003", "E1-sufficient", {"printed": "(pi3_0 - l)**2 > 4*I1*dU"}),
    ("VV2003", "E1-sufficient", {"printed": "(pi3_0 + l)**2 >= 4*I1*dU"}),
    ("VV2003", "E1-instability", {"printed": "b**2 - 4*d*c < 0"}),
    ("VV2003", "E3-necessary", {"printed": "p > 0"}),
    ("VV2003", "E3", {"printed": ["I1*omega*k1", "I1*omega*k2", "I1*omega*k3", "k1", "k2", "k3"]}),
    ("VV2003", "heavy-existence", {"printed": "abs((omega*l - m0)/(omega**2*(I1 - I3))) < 2"}),
    ("VV2003", "k3-inside", {"printed": "abs(k1) < 1"}),
    ("VV2003", "E3-no-information", {"quantity": "sufficient for stability"}),
    ("VV2003", "E3-relation", {"printed": "dU - omega**2*k3*(I1 - I3) - omega*l"}),
    ("N2025", "symmetric-solution", {"printed": ["A*cos(omega*t)", "-A*sin(omega*t)", "Omega3"]}),
    ("N2025", "curves-around-1", {"printed": "unstable"}), ("AR", "unstable-2", {"printed": "stable"}),
    ("EA", "4.38", {"printed": "1/2*I1*(phi_dot**2*sin(theta) + theta_dot**2) + 1/2*I3*(psi_dot + "
                               "phi_dot*cos(theta))**2"}),
    ("EA", "space-cone-e3", {"printed": "cross(psi_dot*vector_z, R*axis_3)"}),
    ("literature", "F5-y1", {"printed": "-0.705397809522573"}),
    ("literature", "F3-period", {"printed": "22.898647550622"}),
    ("literature", "S4-slow-nutation", {"printed": "2.4954551005"}),
    ("literature", "S8-multiplicity", {"printed": "3"}),
    ("literature", "F3-solution",
     {"printed": ["sqrt(I1)*u/r*cn(n*t, m)", "sqrt(I2)*u/s*sn(n*t, m)", "sqrt(I3)*v/r*cn(n*t, m)"]}),
    # not real
    ("literature", "F3-solution", {"let": {**BY_KEY["literature", "F3-solution"].let, "s": "sqrt(I2 - I3)"}}),
    # not real
    ("literature", "F2", {"let": {**BY_KEY["literature", "F2"].let, "y": "sqrt(1/I2 - 1/I1)"}}),
    ("literature", "F4-stable", {"printed": "(l + (I3 - I1)*omega3_0)*(l + (I3 - I2)*omega3_0) >= 0"}),
    ("literature", "F4-unstable", {"printed": "(l + (I3 - I1)*omega3_0)*(l + (I3 - I2)*omega3_0) <= 0"}),
    ("literature", "S7-Casimirs", {"printed": "l*omega3_0 + (I3 - I1)*omega3_0**2 >= dU"}),
    # mass1 = mass3 and no spin: unstable
    ("literature", "S13", {"printed": "pi3_0**2 >= 4*I1*A"}),
    # l is solved for, dU has l
    ("literature", "S5-frequency", {"printed": "(omega - m0/(I1*omega))**2 + 3*(1 - k3)*m0/I1"}),
    # a parameter P of the scene is hidden
    ("literature", "S4-relation", {"let": {"P": "I3*omega*k3 - l"}}),
    # moments of no body
    ("N2025", "precession", {"let": {"I2": "-I1"}}),
    ("literature", "F1-value-2", {"printed": "0.217732421583"}),
    # r is not real everywhere
    ("literature", "S1-E1", {"let": {**BY_KEY["literature", "S1-E1"].let, "a": "pi3_0/I3 + P/(2*I1)"}}),
    ("literature", "S12-stable", {"printed": "dU + d2U >= 0"}),
    ("literature", "A1-Energy-Casimir", {"printed": "(I3 - I1)*(omega3_0**2 - m1) + l*omega3_0 - m0 > 0"}),
]


# among the mutants there are others like them
LATER = {("VV2003", "E3-necessary"), ("literature", "S13"), ("N2025", "curves-around-1")}


@pytest.mark.parametrize(("source", "key", "change"), [
    pytest.param(s, k, change, id=f"{s}:{k}:{n}", marks=[pytest.mark.slow] * ((s, k) in LATER))
    for n, (s, k, change) in enumerate(MUTANTS)])
def test_a_changed_formula_is_a_misprint(source, key, change):
    """One sign, index, exponent, prime, relation, digit or verdict changed is found, with a counterexample.
    """
    outcome = outcome_of(replace(BY_KEY[source, key], **change))
    assert outcome.agrees is False and (outcome.counterexample or outcome.not_sharp)


@pytest.mark.slow
def test_all_mutants(full):
    """Every one-symbol change of every confirmed formula is reported, or is argued to be as true as the
    original; without --full a sample of them.
    """
    script = Path(__file__).parents[2] / "benchmarks" / "mutate_published.py"
    run = subprocess.run([sys.executable, str(script), *["--quick"] * (not full)], capture_output=True,
                         text=True)
    assert run.returncode == 0 and "kill rate 100.0 %" in run.stdout, run.stdout


@pytest.mark.slow
def test_equality_is_decided():
    """Rumiantsev's condition with ≥: true for m0 > 0, where the heavy top is stable at equality.

    At m0 = 0 = P it is not.
    """
    claim = replace(BY_KEY["literature", "S11-uniform"], printed="(I3*omega3_0 + l)**2 >= 4*I1*m0")
    assert outcome_of(replace(claim, given="m0 > 0")).agrees is True
    wrong = outcome_of(claim)
    assert wrong.agrees is False and dict(wrong.counterexample.values)["m0"] == 0


@pytest.mark.slow
def test_what_is_neither_confirmed_nor_refuted_is_unchecked():
    """At equality the form of an asymmetric body is semidefinite.

    ≥ for > is neither confirmed nor called a misprint.
    """
    claim = BY_KEY["literature", "A1-Energy-Casimir"]
    assert outcome_of(replace(claim, printed=claim.printed.replace(">", ">="))).agrees is None


def test_a_wrong_correction_is_refused():
    """What a misprint is corrected to is checked as if it were printed."""
    with pytest.raises(PublishedError, match="not what is derived"):
        outcome_of(replace(BY_KEY["VV2003", "E3-b"], corrected="(I1 - I3)*omega*k2/I1"))


def test_language():
    """Chains, absolute values, decimals; nothing is evaluated, and shapes have to fit."""
    a = symbol("a")
    assert comparisons("0 < a < 2 and abs(a) < 3", {"a": a}) == [
        (a, True),
        (2, True),
        (2 - a, True),
        (9 - a**2, True),
    ]
    assert decimal("-0.70") == (Rational(-7, 10), Rational(1, 200))
    for text, why in (("__import__('os')", "cannot read"), ("a.real", "grammar"), ("a < ", "too early"),
                      ("b", "not a name"),
                      ("f(a)", "not a"), ("dot", "no argument"), ("dot(a", "parenthesis"),
                      ("dot(a, a)", "do not fit"),
                      ("9**9**9", "exponent")):
        with pytest.raises(ExpressionError, match=why):
            read(text.replace("<", "+"), {"a": a, "dot": lambda x, y: (x.T * y)[0]})
    for text, why in (("a", "as a condition"), ("0 < a > 2", "one way")):
        with pytest.raises(ExpressionError, match=why):
            comparisons(text, {"a": a})
    with pytest.raises(ValuesError, match="decimal"):
        decimal("1,2")
    with pytest.raises(ExpressionError, match="one length"):
        read([["a", "a"], ["a"]], {"a": a})
    with pytest.raises(ExpressionError, match="texts"):
        read([1], {})


GOOD = """
[source]
name = "mine"
title = "A paper"

[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
"""
FORMULA = ('[[formula]]\nkey = "a"\nwhere = "(1)"\nquantity = "p"\nprinted = "{}"\n'
           'kind = "identity"\nscene = "top"\n')


def written(tmp_path, text):
    path = tmp_path / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(("text", "why"), [
    ("x = [", "is not TOML"), ("[source]\nname = 1", "no \\[source\\]"),
    (GOOD + "[extra]\n", "unknown tables"),
    (GOOD + "[scene.b]\nmass = 1\n", "scene.b: a scene has no entry mass"),
    (GOOD + '[[formula]]\nkey = "a"\n', "a: lacks where"),
    (GOOD + FORMULA.format("p") + "colour = 1\n", "unknown entry colour"),
    (GOOD + FORMULA.format("p").replace('"p"', "1", 1), "is a int"),
    (GOOD + FORMULA.format("p").replace("identity", "guess"), "kind = 'guess'"),
    (GOOD + FORMULA.format("p") * 2, "occur twice"),
    (GOOD + FORMULA.format("p").replace('"top"', '"bottom"'), "scene = 'bottom'"),
    (GOOD + FORMULA.format("p*"), "a: cannot read"),
    (GOOD + FORMULA.format("mass"), "a: cannot read 'mass': mass is not a name of this scene"),
    (GOOD + FORMULA.format("vector_k"), "a: printed is a 3×1 matrix, the quantity a number"),
    (GOOD + FORMULA.format("p > 0").replace("identity", "condition"), "a condition is necessary for"),
    (GOOD + FORMULA.format("p").replace("identity", "statement"), "a statement is about"),
    (GOOD + FORMULA.format("1").replace("identity", "number"), "still contains"),
    (GOOD + FORMULA.format("p").replace("identity", "solution"), "the list omega1"),
    (GOOD + FORMULA.format("p").replace("identity", "equilibrium"), "6 coordinates"),
    (GOOD.replace('["I1", "I1", "I3"]', "[1, 1, 3]") + FORMULA.format("p"),
     "scene.top: inertia = .*in quotation marks"),
    (GOOD.replace('"m0*k3"', "5") + FORMULA.format("p"), "scene.top: potential = 5"),
    ("scene = 5\n" + GOOD.split("[scene")[0], "\\[scene.NAME"),
    (GOOD + FORMULA.format("p").replace("[[formula]]", "[formula]"), "\\[\\[formula\\]\\]"),
    (GOOD + "[expected]\nmisprint = 'a'", "lists of keys"),
    (GOOD + FORMULA.format("p") + 'at = { zz = "1" }\n', "at gives zz"),
    (GOOD + FORMULA.format("p") + 'at = { I1 = "0" }\n', "are positive"),
    (GOOD + FORMULA.format("p") + 'given = "m0 >= 0"\n', "write > or <"),
    (GOOD + FORMULA.format("entry(jacobian, 0, 1)"), "no entry 0, 1"),
    (GOOD + '[expected]\nmisprint = [["a"]]', "lists of keys"),
    (GOOD + FORMULA.format("sn(vector_pi, 1)"), "sn takes numbers"),
    (GOOD + FORMULA.format("sqrt(jacobian)"), "takes one number"),
    (GOOD + FORMULA.format("entry(jacobian**9, 1, 1)"), "powers 2 and 3"),
    (GOOD + FORMULA.format("(p + 1)**100"), "others to 12"),
    (GOOD + FORMULA.format("round").replace('"p"', '"stability"').replace("identity", "statement"),
     "orbitally stable"),
    (GOOD.replace('"E1"', '"E4"') + FORMULA.format("p"), "equilibrium = 'E4'"),
    (GOOD + '[expected]\nmisprint = ["b"]\n', "no such key"),
    (GOOD.replace('"m0*k3"', '"m0*"') + FORMULA.format("p"), "a: cannot read 'm0\\*'")])
def test_bad_files(tmp_path, text, why):
    """A clear error with file and key."""
    path = written(tmp_path, text)
    with pytest.raises(PublishedError, match=why) as error:
        check([path])
    assert str(path) in str(error.value)


def test_no_such_source(tmp_path):
    """Neither a source of ours nor a file."""
    for source in ("VV2004", tmp_path / "missing.toml"):
        with pytest.raises(PublishedError):
            load(source)


def test_a_file_of_ones_own(tmp_path):
    """The same format; a status that differs from the expected one is seen."""
    text = (
        GOOD
        + FORMULA.format("((omega3 - (pi3 + l)/I1)**2)").replace("l)", "0)")
        + '[expected]\nmisprint = ["a"]\n'
    )
    (finding,) = check([written(tmp_path, text)])
    assert (finding.status, finding.expected) == ("misprint", "misprint") and finding.outcome.counterexample
    assert "I1" in dict(finding.outcome.counterexample.values)


@CHECKS
def test_progress(found):
    """Called once for each statement, with the total of the source."""
    seen = []
    check(["AR"], lambda source, done, total: seen.append((source, done, total)))
    assert seen == [("AR", n, len(found["AR"])) for n in range(1, len(found["AR"]) + 1)]


@CHECKS
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


def test_errors_are_of_one_family():
    """except GyrostatError catches what verify refuses."""
    assert issubclass(PublishedError, GyrostatError) and issubclass(PublishedError, ValueError)


@pytest.mark.parametrize("page", ["README.md", "docs/published.md"])
@CHECKS
def test_the_page_is_true(page, tmp_path, found):
    """Its example of a file is confirmed, and its table counts what is computed."""
    text = (Path(__file__).parents[2] / page).read_text(encoding="utf-8")
    (example,) = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)
    (finding,) = check([written(tmp_path, example)])
    assert finding.status == "confirmed"
    for source, rows in found.items():
        (row,) = (line for line in text.splitlines() if line.startswith("|") and f"`{source}`" in line)
        counts = [sum(f.status == status for f in rows) for status in ("confirmed", "misprint", "unchecked")]
        long = sum(name == source for name, _ in LONG)                     # all of them confirmed
        assert list(map(int, re.findall(r"\| (\d+) (?=\|)", row))) == [
            len(rows) + long, counts[0] + long, *counts[1:]]


def test_the_sources_agree_where_they_print_the_same():
    """Euler's equations as N2025, EA and AR print them are one."""
    rates = [outcome_of(BY_KEY[key]).derived for key in (("N2025", "free-1"), ("AR", "determinant-momenta"))]
    assert (rates[0] - rates[1][0]).expand() == 0


@pytest.mark.parametrize(("printed", "tex"), [
    ("-omega2*omega3*(I3 - I1)", r"- \omega_{2} \omega_{3} \left(I_3 - I_1\right)"),
    ("-(a + b)/c**2", r"- \frac{a + b}{c^{2}}"),
    ("z - b - (c + d)", r"z - b - \left(c + d\right)"), ("2*(a/b)**2", r"2 \left(\frac{a}{b}\right)^{2}"),
    ("a*-b", r"a \left(- b\right)"),
    ("1 <= pi3*k3 < 2", r"1 \leq \pi_3 k_3 < 2"),
    ("cross(vector_k, vector_l + vector_k)", r"\mathbf{k} \times \left(\boldsymbol{l} + \mathbf{k}\right)")])
def test_printed_formulas_keep_their_order(printed, tex):
    """The errata show terms and factors as they are printed, not as a computer algebra sorts them."""
    assert formula_of(printed) == tex


CLAIM = """[[formula]]
key = "{key}"
where = "(1)"
quantity = "{quantity}"
printed = "{printed}"
kind = "{kind}"
scene = "s"
"""


def status(tmp_path, scene, quantity, printed, kind="condition", given=""):
    """What check says of one claim in a scene of its own."""
    text = '[source]\nname = "mine"\ntitle = "t"\n[scene.s]\n' + scene + "\n"
    text += CLAIM.format(key="a", quantity=quantity, printed=printed, kind=kind)
    (finding,) = check([written(tmp_path, text + (f'given = "{given}"\n' if given else ""))])
    return finding.status


BODY = 'inertia = ["I1", "I1", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\n'
E3 = BODY + 'potential = "m0*k3"\nequilibrium = "E3"'
EXP = BODY + 'potential = "exp(a*k3)"\nequilibrium = "E1"'


@pytest.mark.parametrize(("scene", "arguments", "expected"), [
    (E3, ("existence", "I1 > 0"), "misprint"), (E3, ("existence", "k3**2 < 1 and omega**2 > 0"), "confirmed"),
    pytest.param(E3, ("stability", "stable", "statement"), "unchecked",
                 marks=pytest.mark.slow),     # stable modulo the spin only
    ('inertia = ["I1", "I2", "I2"]\nequilibrium = "axis 2"', ("stability", "stable", "statement"),
     "unchecked"),
    (EXP, ("sufficient for stability", "(pi3_0 + l)**2 > 4*I1*a*exp(a)"), "confirmed"),
    (EXP, ("sufficient for stability", "(pi3_0 + l)**2 > 4*I1*exp(a)"), "misprint"),
    (EXP, ("necessary and sufficient for stability", "(pi3_0 + l)**2 > 4*I1*a*exp(a)"), "misprint"),
    ('parameters = ["a"]', ("sin(2*a)*sqrt(a - 20)", "2*sin(a)*cos(a)*sqrt(a - 20)", "identity"),
     "unchecked"),     # neither is real there
    ('parameters = ["a"]', ("T", "2*T", "identity", "I1 < I2 and I2 < I1"),
     "unchecked"),          # nothing satisfies what is given
    ('parameters = ["a"]', ("polhode_period(3, 2, 1, 3/10, 1/5, 9/10)", "12.9", "number"), "misprint"),
    ('inertia = ["I1", "I1", "I1"]\nparameters = ["a"]', ("T", "T", "identity"), "confirmed")])
def test_claims_that_are_easy_to_get_wrong(tmp_path, scene, arguments, expected):
    """Existence is not judged where it is assumed; stability modulo a flow is not stability.

    Transcendental fields; empty domains.
    """
    assert status(tmp_path, scene, *arguments) == expected


def test_a_file_with_a_byte_order_mark(tmp_path):
    """As some editors write them."""
    path = tmp_path / "mine.toml"
    path.write_bytes(b"\xef\xbb\xbf" + (GOOD + FORMULA.format("p")).encode())
    assert check([path])[0].status == "confirmed"


@CHECKS
def test_errata_of_odd_texts_compile(found):
    """Special characters of LaTeX and letters it does not know are set or replaced."""
    finding = next(f for f in found["AR"] if f.status == "misprint")
    odd = replace(finding, statement=replace(finding.statement,
                                             note="50% of $x_1 & #2 \\foo {~^} \U0001d714"))
    tex = latex([odd])
    assert r"50\% of \$x\_1 \& \#2 \textbackslash{}foo \{\textasciitilde{}\^{}\} ?" in tex
