"""gyrostat plot well: the picture of the library, of the equilibrium with a number in the list."""
import numpy as np
import pytest

import gyrostat as gs
from gyrostat import plotting
from gyrostat.cli.parser import main

FREE = ["--potential", "none", "--inertia", "1,2,3", "--gyrostatic-momentum", "0,0,1/4", "--set", "M=2"]
TOP = ["--potential", "k3^4 - k3^2/2", "--inertia", "2,2,1", "--gyrostatic-momentum", "0,0,0", "--set",
       "C1=1/10", "pi3_0=1/2"]
BALL = ["--potential", "none", "--inertia", "1,1,1", "--gyrostatic-momentum", "0,0,0", "--set", "M=1"]


def listed(asked):
    if asked is FREE:
        return gs.relative_equilibria(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/4"))), {"M": 2})
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.axial_potential("k3^4 - k3^2/2"))
    return gs.relative_equilibria(scene, {"C1": "1/10", "pi3_0": "1/2"})


@pytest.fixture
def figures(monkeypatch):
    """The figures that are saved."""
    found = []
    monkeypatch.setattr("gyrostat.cli.options.picture_options.save_picture",
                        lambda figure, *form: found.append(figure))
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("asked", "number"), [(FREE, None), (FREE, 6), (TOP, 3)])
def test_the_picture_is_that_of_the_library(capsys, figures, asked, number):
    """The same lines and the same title; without a number, that of the first that has a well."""
    picked = [] if number is None else ["--number", str(number)]
    assert main(["plot", "well", *asked, *picked, "--output", "x.png"]) == 0
    assert capsys.readouterr() == ("", "")
    [ax] = figures[0].axes
    rotations = listed(asked)
    one = rotations[number - 1] if number else next(e for e in rotations if e.well.barrier is not None)
    new = type(figures[0])().add_subplot(
        projection="3d", elev=ax.elev, azim=ax.azim) if asked is FREE else type(figures[0])().subplots()
    ours = plotting.draw_well(one, new)
    assert ours.get_title().replace("\n", " ") == ax.get_title().replace("\n", " ")
    assert len(ours.lines) == len(ax.lines) and len(ours.collections) == len(ax.collections)
    for mine, theirs in zip(ours.lines, ax.lines):
        data = [x.get_data_3d() if asked is FREE else x.get_data() for x in (mine, theirs)]
        np.testing.assert_array_equal(*map(np.array, data))


@pytest.mark.parametrize(("options", "why"), [
    ([*FREE, "--number", "7"], "--number is 7, and the list has 6: give one of those that gyrostat decide"),
    ([*FREE, "--number", "3"], "there is no well to draw: it is not stable"),
    ([*BALL], "no well of these equilibria is known")])
def test_what_cannot_be_drawn(capsys, options, why):
    """A number that there is none of, one that is unstable, a body that is at rest everywhere."""
    assert main(["plot", "well", *options, "--output", "x.png"]) == 2
    assert why in capsys.readouterr().err
