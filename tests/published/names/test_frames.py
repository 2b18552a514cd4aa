"""Published statements on satellites, bodies in two fields and vehicles."""
from dataclasses import replace

import pytest
from published.written_sources import BY_KEY, status, written

import gyrostat as gs
from gyrostat.errors import PublishedError
from gyrostat.mechanics.families.scene_tables import SceneTable
from gyrostat.published import check
from gyrostat.published.checks.findings import outcome_of

POINTING = 'orbit = "omega0"\nequilibrium = "earth-pointing"\n'
COUNTED = 'inertia = ["1", "5/4", "8/5"]\ngyrostatic_momentum = ["0", "l", "0"]\norbit = "1"\n'
DRAG = POINTING + 'potential = "a*t1"\n'
FIELDS = 'directions = ["k", "e"]\npotential = "-a*k1 - b*e2"\n'
RESTING = FIELDS + 'point = ["0", "0", "0", "1", "0", "0", "0", "1", "0"]\n'
VEHICLE = 'vehicle = { mass = ["mass1", "mass2", "mass3"], weight = ["0", "0", "m0"] }\n'
RISING = VEHICLE + 'point = ["0", "0", "0", "0", "0", "p0", "0", "0", "1"]\n'

# of a kind of scene or claim each: what is true, and what is not
SAID = [
    (POINTING, "sufficient for stability", "I2 > I1 > I3", "condition", "confirmed"),
    (POINTING, "sufficient for stability", "I2 > I3 > I1", "condition", "misprint"),
    (POINTING, "necessary and sufficient for spectral stability", "I2 > I1 > I3", "condition", "misprint"),
    (POINTING, "c2", "omega0**2", "identity", "misprint"),
    ('orbit = { mu = "mu", radius = "R" }\nequilibrium = "earth-pointing"\n', "entry(stiffness, 2, 2)",
     "3*mu/R**3*(I1 - I3)", "identity", "confirmed"),
    (POINTING + 'rotors = [{ axis = [3, 0, 0], axial = "J", momentum = "0" }]\nlumped = true\n',
     "entry(stiffness, 2, 2)", "3*omega0**2*(I1 - I3 - J)", "identity", "misprint"),
    (DRAG, "sufficient for stability", "I2 > I3 and omega0**2*(I2 - I1) > a and I1 > I3", "condition",
     "misprint"),
    ('orbit = "omega0"\n', "dt(vector_r)", "cross(vector_r, vector_omega)", "identity", "misprint"),
    (FIELDS, "dt(h)", "0", "identity", "confirmed"),
    (RESTING, "sufficient for stability", "a > 0 and b > 0 and a + b > 0", "condition", "confirmed"),
    (RESTING, "sufficient for stability", "a > 0 and a + b > 0", "condition", "misprint"),
    (RISING, "sufficient for stability under internal damping",
     "m0 > p0**2*(1/mass3 - 1/mass1) and m0 > p0**2*(1/mass3 - 1/mass2)", "condition", "confirmed"),
    (RISING, "sufficient for stability", "m0 > p0**2*(1/mass3 - 1/mass1)", "condition", "misprint"),
    (VEHICLE, "dt(vector_p)", "cross(vector_omega, vector_p)", "identity", "misprint")]


@pytest.mark.few(1)
@pytest.mark.parametrize(("scene", "quantity", "printed", "kind", "expected"), SAID)
def test_what_is_said_of_two_directions(tmp_path, scene, quantity, printed, kind, expected):
    """Confirmed, or refuted from the equations of motion."""
    assert status(tmp_path, scene, quantity, printed, kind) == expected


@pytest.mark.few(1)
@pytest.mark.parametrize(("printed", "expected"), [("24", "confirmed"), ("20", "misprint")])
def test_a_count_is_searched_for(tmp_path, printed, expected):
    """What is counted is what a search ends at."""
    assert status(tmp_path, COUNTED, "equilibria", printed, "count", at='{ l = "1/20" }') == expected


@pytest.mark.few(1)
@pytest.mark.parametrize(("printed", "expected"), [("12", "misprint"), ("16", "confirmed")])
def test_a_count_under_other_torques_is_searched_for(tmp_path, printed, expected):
    """Under drag, with a magnet and beside an asteroid: the search and the list end at the same number."""
    torques = COUNTED + 'potential = "a*t1 - B*n2 + c*r1*r2"\n'
    assert status(tmp_path, torques, "equilibria", printed, "count",
                  at='{ l = "1/10", a = "1/20", B = "1/4", c = "1/8" }') == expected


@pytest.mark.slow
def test_a_curve_of_equilibria_has_no_count():
    """At l² = 4 ω0² (I1 − I2) (I3 − I2) the printed count fails: the equilibria are not isolated."""
    outcome = outcome_of(BY_KEY["satellites", "one-axis-degenerate"])
    assert outcome.agrees is False and "curve" in outcome.counterexample.derived
    assert str(dict(outcome.counterexample.values)["l"].evalf(9)) == "0.848528137"


@pytest.mark.slow
@pytest.mark.parametrize(("key", "change"), [
    ("Lagrange-damped", {"printed": "I2 > I3"}), ("station-pitch", {"printed": "1.4"}),
    ("DeBra-Delp", {"printed": "kR >= kY and kR*kY >= 0 and 1 + 3*kR + kR*kY >= 5*sqrt(kR*kY)"}),
    ("held-tensor-gyroscopic", {"printed": ["omega0*Itn", "omega0*(Itt + Irr - Inn) - l", "2*omega0*Inr"]}),
    ("held-tensor-point", {"printed": ["omega0*Itt", "omega0*Inn", "omega0*Inr", "0", "1", "0", "0", "0",
                                       "1"]}),
    ("saddle-unstable", {"printed": "stable"}), ("least-stable", {"printed": "unstable"}),
    ("conical-damped", {"printed": "I3 > I1"}), ("hyperbolic-damped", {"printed": "I3 > I1"}),
    ("conical-unstable", {"printed": "stable"}), ("rising-with-spin", {"let": {"I": "I1"}}),
    ("rising-upside-down", {"printed": "m0 > p0**2*(1/mass3 - 1/mass1)"}),
    ("level-stable", {"printed": "m0 > 0 and mass2 > mass1 and m0 > p0**2*(1/mass2 + 1/mass3)"}),
    ("Likins-Roberson-indices", {"printed": ["4", "8", "4", "8"]}), ("drag-16", {"printed": ["16", "2"]}),
    ("drag-pitch-stable", {"printed": "I3 > I1 and I2 > I1"}),
    ("magnet-gyroscopic", {"printed": ["0", "omega0*(I1 + I3 - I2) - B/omega0", "0"]}),
    ("asteroid-intermediate-stable", {"printed": "I2 > I1 > I3"}),
    ("asteroid-other-domain", {"printed": "unstable"})])
def test_a_changed_statement_is_a_misprint(key, change):
    """With a counterexample, or a point that it leaves out."""
    outcome = outcome_of(replace(BY_KEY["satellites", key], **change))
    assert outcome.agrees is False and (outcome.counterexample or outcome.not_sharp)


@pytest.mark.parametrize(("scene", "quantity", "printed", "kind", "message"), [
    ('vehicle = { mass = ["1", "1", "1"] }', "h", "0", "identity", "write mass and weight"),
    ('vehicle = "fast"', "h", "0", "identity", "write mass and weight"),
    (VEHICLE + 'potential = "k3"', "h", "0", "identity", "a vehicle has its weight"),
    ('directions = ["k"]\npotential = "k1"', "h", "0", "identity", "write two names"),
    ('orbit = "-1"', "h", "0", "identity", "is positive"),
    (POINTING, "equilibria", "24", "count", "give the scene an orbit, and no equilibrium"),
    (COUNTED, "maxima", "4", "count", "what is counted is equilibria, index 0"),
    (COUNTED, "equilibria", "many", "count", "give a whole number")])
def test_what_cannot_be_read(tmp_path, scene, quantity, printed, kind, message):
    """One sentence with what to do."""
    with pytest.raises(PublishedError, match=message):
        status(tmp_path, scene, quantity, printed, kind)


def test_moments_are_inserted_once():
    """The moments of a body may be written in I1, I2, I3 in another order."""
    I1, I2, I3 = map(gs.symbol, ("I1", "I2", "I3"))
    scene = gs.assemble(gs.Gyrostat((I2, I1, I3 - I1), (0, 0, 0)), gs.circular_orbit())
    assert scene.potential.gradient()[3:] == tuple(
        3 * gs.symbol("omega0")**2 * I * gs.symbol(f"r{n}") for n, I in ((1, I2), (2, I1), (3, I3 - I1)))


def test_vehicles_are_of_formulas_alone():
    """The scenes of the command line have none."""
    with pytest.raises(PublishedError, match="a scene has no entry vehicle"):
        SceneTable({"vehicle": {}})


def test_a_root_in_a_comparison_is_squared(tmp_path):
    """a ≥ 2√b says a ≥ 0, b ≥ 0 and a² ≥ 4b."""
    (finding,) = check([written(tmp_path, """[source]
name = "mine"
title = "t"
[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
spin = "omega3_0"
[[formula]]
key = "a"
where = "(1)"
quantity = "necessary for stability"
printed = "I3*omega3_0 >= 2*sqrt(I1*m0)"
given = "omega3_0 > 0 and m0 > 0"
kind = "condition"
scene = "top"
""")])
    assert finding.status == "confirmed"
