"""The picture of the attitudes of a satellite against the rotor: lines, marks and numbers, read back."""
import numpy as np
import pytest
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.plotting import draw_bifurcation_diagram
from gyrostat.plotting.looks import LINES

BODY = (1, "5/4", "8/5")
LOW, HIGH = 0.5, 2.0


@pytest.fixture(scope="module")
def drawn():
    """Along axis 2 between 1/2 and 2, where numbers change at 1 and 7/5."""
    scene = gs.assemble(gs.Gyrostat(BODY, (0, gs.symbol("l"), 0)), gs.circular_orbit(1))
    return draw_bifurcation_diagram(scene, "l", (LOW, HIGH), {}, Figure().subplots())


@pytest.mark.slow
def test_the_numbers_of_attitudes_stand_over_their_parts(drawn):
    """16 up to 1, 12 up to 7/5, then 8."""
    numbers = {text.get_text(): text.xy[0] for text in drawn.texts if text.get_text().isdigit()}
    assert list(numbers) == ["16", "12", "8"]
    np.testing.assert_allclose(list(numbers.values()), [0.75, 1.2, 1.7])


def test_branches_are_the_closed_forms(drawn):
    """n2 is ±1, 20 l/28 on the conical family up to 7/5, and −l on that up to 1; no other curve is there."""
    curves = {"stable": set(), "unstable": set(), "undecided": set()}
    for line in drawn.lines:
        x, y = np.array(line.get_data())
        if len(x) > 10:
            (name,) = (name for name, (color, _) in LINES.items() if line.get_color() == color)
            forms = (x / 1.4, -x, 1 + 0 * x, -1 + 0 * x)
            curve = next(n for n, f in enumerate(forms) if np.abs(f - y).max() < 1e-5)
            curves[name].add(curve)
    assert curves["stable"] == {2} and {0} < curves["unstable"] and 1 in curves["undecided"]


def test_pitchforks_stand_where_families_end(drawn):
    """At (1, −1) and (7/5, 1), each twice."""
    marks = [line for line in drawn.lines if line.get_marker() == "P"]
    places = np.array([np.array(line.get_data()).T for line in marks]).reshape(-1, 2)
    assert {tuple(place) for place in places.round(6).tolist()} == {(1.0, -1.0), (1.4, 1.0)}
    assert drawn.get_ylabel() == "$n_{2}$"
