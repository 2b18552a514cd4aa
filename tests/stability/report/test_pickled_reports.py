"""A pickled report carries what its verdicts need, if that is derived: a worker derives nothing again."""
import pickle

import pytest
from rotation_families import LINEAR, ROTOR

import gyrostat as gs
from gyrostat.stability.damping import secular
from gyrostat.stability.report import derived_parts

TENSOR = [[gs.symbol(f"I{min(i, j)}{max(i, j)}") for j in (1, 2, 3)] for i in (1, 2, 3)]
ROTATING = {"I11": 3, "I12": 1, "I13": 0, "I22": 4, "I23": -1, "I33": 5, "l1": 1, "l2": 0, "l3": 2,
            "u1": 1, "u2": 2, "omega": 2, "sigma": -30}


def rotation(U, *direction, **body):
    return gs.permanent_rotation(gs.assemble(gs.Gyrostat(**body), gs.general_potential(U)), *direction)


def pointing():
    body = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
    return gs.earth_pointing(gs.assemble(body, gs.circular_orbit()))


CASES = {
    "E1": (lambda: gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())),
           {"I1": 1, "I3": "1/2", "l": 2, "pi3_0": 1, "dU": 2}),
    "a satellite": (pointing, {"I1": "5/4", "I2": "8/5", "I3": 1, "omega0": 1, "l": "1/10"}),
    "a tensor in any direction": (lambda: rotation(LINEAR, gs.stereographic(), inertia=TENSOR,
                                                   gyrostatic_momentum=ROTOR), ROTATING),
    "k1, k2, k3": (lambda: rotation(LINEAR, gyrostatic_momentum=ROTOR),
                   {"I1": 3, "I2": 4, "I3": 5, "l1": 0, "l2": 0, "l3": 1, "k1": "1/3", "k2": "2/3",
                    "k3": "2/3", "omega": -1, "sigma": -20})}


@pytest.mark.few(2)
@pytest.mark.parametrize("case", CASES)
def test_a_pickled_report_decides_without_deriving(case, monkeypatch):
    """Both verdicts, equal to those of the original; the pickle stays small."""
    make, values = CASES[case]
    report = gs.analyze(make())
    wanted = report.verdict(values), report.verdict(values, damped=True)
    fresh = pickle.loads(pickle.dumps(gs.analyze(make())))
    text = pickle.dumps(report)
    for verb in ("linearize", "second_variation", "in_names", "formal_criterion", "spectral_criterion"):
        monkeypatch.setattr(derived_parts, verb, None)
    for verb in ("in_names", "secular_variation", "secular_criterion"):
        monkeypatch.setattr(secular, verb, None)
    again = pickle.loads(text)
    assert (again.verdict(values), again.verdict(values, damped=True)) == wanted
    assert len(text) < 12_000 and again == report
    monkeypatch.undo()
    assert fresh.verdict(values) == wanted[0]                  # what was not derived is derived there


@pytest.mark.slow
def test_a_decision_between_the_criteria_is_the_same_from_a_pickle():
    """There theorems derive what they need once more."""
    values = {"I1": 3, "I2": 4, "I3": 5, "l1": -1, "l2": 2, "l3": -1}
    values |= {"omega": -1, "sigma": -2, "u1": 1, "u2": 2}
    report = gs.analyze(rotation(LINEAR, gs.stereographic(), gyrostatic_momentum=ROTOR))
    found = report.verdict(values)
    assert "gyroscopic forces stabilise it; D4 = " in found.reason
    assert pickle.loads(pickle.dumps(report)).verdict(values) == found
