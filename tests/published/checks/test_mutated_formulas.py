"""Published formulas with one sign, index, exponent or relation changed, and claims easy to get wrong."""
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from published.written_sources import BY_KEY, status

from gyrostat.errors import PublishedError
from gyrostat.published.checks.findings import outcome_of

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
    # k3 = 1/2 is of no rational direction
    ("literature", "tilt-lost", {"printed": "unstable"}),
    ("literature", "L6-damped", {"printed": "l + (I3 - I1)*omega3_0 > 0 and l + (I3 - I2)*omega3_0 >= 0"}),
    ("literature", "sleeping-prolate", {"at": {}}),
    ("literature", "Kharlamov-curve", {"printed": "m0*(m0*B**2 + A*D)"}),
    ("literature", "A2-stable", {"printed": "unstable"}),
    # the point is printed in the coordinates
    ("literature", "permanent-rotation", {"printed": ["w*I1*k1", "w*I2*k1", "w*I3*k3", "k1", "k2", "k3"]}),
    ("literature", "A2-s", {"printed": "1.70209339777"}),
    ("EA", "three-rotations", {"printed": ["-sin(theta)*cos(psi)", "sin(theta)*cos(psi)", "cos(theta)"]}),
    ("VV2003", "influence", {"at": {"l": "I1*dU - pi3_0"}}),
]
# among the mutants there are others like them
LATER = {("VV2003", "E3-necessary", "printed"), ("literature", "S13", "printed"),
         ("literature", "F3-solution", "let"), ("N2025", "curves-around-1", "printed")}


@pytest.mark.few(2)
@pytest.mark.parametrize(("source", "key", "change"), [
    pytest.param(s, k, change, id=f"{s}:{k}:{n}", marks=[pytest.mark.slow] * ((s, k, *change) in LATER))
    for n, (s, k, change) in enumerate(MUTANTS)])
def test_a_changed_formula_is_a_misprint(source, key, change):
    """One sign, index, exponent, prime, relation, digit or verdict changed is found, with a counterexample.
    """
    outcome = outcome_of(replace(BY_KEY[source, key], **change))
    assert outcome.agrees is False and (outcome.counterexample or outcome.not_sharp)


@pytest.mark.slow
def test_all_mutants(full):
    """Every one-symbol change of every confirmed formula is reported, or is argued to be as true as the
    original, or to be refuted by nothing; without --full a sample of them.
    """
    script = Path(__file__).parents[3] / "benchmarks" / "mutate_published.py"
    run = subprocess.run([sys.executable, str(script), *["--quick"] * (not full)], capture_output=True,
                         text=True)
    assert run.returncode == 0 and " 0 none of these: " in run.stdout, run.stdout


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


BODY = 'inertia = ["I1", "I1", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\n'
E3 = BODY + 'potential = "m0*k3"\nequilibrium = "E3"'
EXP = BODY + 'potential = "exp(a*k3)"\nequilibrium = "E1"'


@pytest.mark.few(1)
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
