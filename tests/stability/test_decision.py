"""A decision cannot be misread by a program: neither true nor false, equal to its name, with its scope."""
import pickle

import numpy as np
import pytest

import gyrostat as gs
from gyrostat.errors import ArgumentError
from gyrostat.stability.decision import Rung, settled

TOP = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
FAST = TOP.verdict({"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 3})


@pytest.mark.parametrize("asked", [
    lambda: bool(FAST), lambda: bool(FAST.verdict), lambda: not FAST.verdict, lambda: FAST and 1,
    lambda: bool(gs.charts.certify_box(TOP, {"I1": 1, "m0": 1, "l": 0, "pi3_0": (3, 4)}))])
def test_an_answer_is_neither_true_nor_false(asked):
    """UNSTABLE would be true, as every object is."""
    with pytest.raises(ArgumentError, match=r"neither true nor false: .*(STABLE|\.stable)"):
        asked()


def test_a_verdict_is_its_name():
    """Compared with a text that names no verdict it says so; with anything else it differs."""
    assert FAST.verdict == "STABLE" and FAST.verdict != "UNSTABLE" and FAST.verdict is gs.Verdict.STABLE
    assert {gs.Verdict.STABLE: 1}["STABLE"] == 1 and gs.Verdict.STABLE not in (None, 1)
    for wrong in ("stable", "Stable", "LYAPUNOV", ""):
        with pytest.raises(ArgumentError, match="compare with 'STABLE', 'UNSTABLE', 'UNDECIDED'"):
            _ = FAST.verdict == wrong
    assert pickle.loads(pickle.dumps(FAST)).verdict is gs.Verdict.STABLE


def test_a_notion_is_its_words_and_nothing_else():
    """An array, a verdict and None are compared with it as well."""
    assert gs.Notion.SPECTRAL == "spectral" and gs.Notion.SPECTRAL != "formal"
    for other in (np.array(["spectral", "formal"]), FAST.verdict, None, 1):
        assert (gs.Notion.SPECTRAL == other) is False


def test_what_the_name_leaves_out_is_one_attribute_away():
    """The flow, the level, the set."""
    pi3 = gs.symbol("pi3")
    assert FAST.scope == ""
    assert settled(True, "", Rung.SPECTRUM, modulo=(pi3,)).scope == "modulo the flow of pi3"
    assert settled(True, "", Rung.RESONANCE, level=(gs.symbol("C1"),)).scope == "on its level of C1"
    assert settled(True, "", Rung.LEAST_ON_SET, locus="a closed curve").scope == "as a set, a closed curve"
    tilted = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
    decision = tilted.verdict({"I1": 4, "I3": 5, "l": 2, "omega": 1, "k3": 0, "d2U": 0})
    assert decision.scope in str(decision).replace("π₃", "pi3") and decision.stable


def test_nothing_is_decided_without_a_rung():
    """Which has no default: a ladder cannot forget to say what decided."""
    with pytest.raises(TypeError, match="rung"):
        settled(True, "why")
