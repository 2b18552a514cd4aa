"""The kick that a verdict on the page says an equilibrium survives, from the sentence itself."""
import math

import pytest

import gyrostat as gs

TOP = {"potential": "m0*k3", "inertia": ["I1", "I1", "I3"], "equilibrium": "E1"}
ORBIT = {"orbit": "1", "inertia": ["60", "70", "35"], "gyrostatic_momentum": ["0", "l", "0"],
         "equilibrium": "earth-pointing"}
OUT = "A kick of less than … does not take it out of its well."
FREE = {"inertia": ["1", "2", "3"], "gyrostatic_momentum": ["0", "0", "l"], "equilibrium": "axis 3"}


def said(scene, **values):
    """The number of the sentence, and what it says; None if there is none."""
    blocks = gs.questions.show({**scene, "values": values}, "survived")["blocks"]
    if not blocks:
        return None
    [words] = [[part.get("text") or part["tex"] for part in block["sentence"]] for block in blocks]
    return float(words[1]), words[0] + "…" + words[2]


@pytest.mark.parametrize(("scene", "values", "kick", "kept"), [
    (TOP, {"I1": "1", "I3": "8/5", "m0": "1", "pi3_0": "12/5"}, 0.117064424992385,
     "A kick across the axis of less than … keeps it within 10° of its place."),
    (ORBIT, {"l": "0"}, math.sqrt(350), OUT),
    (ORBIT, {"l": "5"}, math.sqrt(70 * 45 / 4), OUT),
    (FREE, {"l": "1/4", "omega3_0": "1/4"}, 3 / 4, OUT)])
def test_the_kick_is_that_of_the_theory(scene, values, kick, kept):
    """Rounded down, to six digits."""
    number, sentence = said(scene, **values)
    assert kick * (1 - 1e-5) < number <= kick and sentence == kept


@pytest.mark.parametrize(("scene", "values"), [
    (TOP, {"I1": "1", "I3": "8/5", "m0": "1", "pi3_0": "1"}), (ORBIT, {"l": "-11"}),
    ({**TOP, "equilibrium": "E3"}, {"I1": "2", "I3": "1", "m0": "-1", "k3": "1/2", "omega": "3"}),
    ({**ORBIT, "inertia": ["35", "70", "60"]}, {"l": "0"})])
def test_no_kick_is_named_where_none_is_safe_or_known(scene, values):
    """Unstable ones, and one whose formula has a root in it."""
    assert said(scene, **values) is None
