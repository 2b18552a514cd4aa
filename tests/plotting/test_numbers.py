"""Numbers beside markers: those of the list that relative_equilibria and gyrostat decide have."""
import re

import numpy as np
import pytest
from drawn_pictures import flat, space

import gyrostat as gs
from gyrostat import plotting
from gyrostat.cli.parser import main

SUM = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
TOP = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: 6 * k3**4 - 5 * k3**2 + k3 / 4))


def numbered(ax):
    """Each number with its place."""
    return {int(text.get_text()): np.array(text.get_position_3d() if ax.name == "3d" else text.xy)
            for text in ax.texts if text.get_text().isdigit()}


def nearest(numbers, places, radius=1.0):
    """Each number is nearer to its own place than 0.2 radii, and on no place of another one."""
    assert numbers.keys() == set(range(1, len(places) + 1))
    for n, where in numbers.items():
        assert np.linalg.norm(where - places[n - 1]) < 0.2 * radius, n
        assert min(np.linalg.norm(where - place) for place in places) > 0.05 * radius, n


def floats(exact):
    return np.array([float(x) for x in exact])


@pytest.mark.slow
def test_on_the_momentum_sphere():
    """M of each rotation, on a sphere of another radius than 1."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/20", "1/10", "1/5")))
    found = gs.relative_equilibria(scene, {"M": 2})
    numbers = numbered(plotting.draw_momentum_sphere(scene, 2, ax=space()))
    assert len(found) == 6
    nearest(numbers, [floats(e.momentum) for e in found], 2.0)


@pytest.mark.slow
@pytest.mark.parametrize("level", ["5/2", 4])
def test_on_the_amended_potential(level):
    """k of each rotation on the level of C1."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), SUM)
    found = gs.relative_equilibria(scene, {"C1": level})
    nearest(numbered(plotting.draw_amended_potential(scene, {"C1": level}, space())),
            [floats(e.directions[0]) for e in found])


@pytest.mark.few(1)
@pytest.mark.parametrize("rotor", [(0, 0, 0), ("3/10", "1/5", "1/10")])
def test_of_attitudes(rotor):
    """The end of the line from r along n."""
    scene = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), rotor), gs.circular_orbit(1))
    found = gs.relative_equilibria(scene, {})
    nearest(numbered(plotting.draw_attitudes(scene, ax=space())),
            [floats(e.form.r) + 0.22 * floats(e.form.n) for e in found])


def test_on_the_effective_potential():
    """θ of each precession on the level, E1 among them."""
    values = {"I1": 1, "I3": "1/2", "l": 0}
    found = gs.relative_equilibria(TOP, {**values, "pi3_0": "1/5", "C1": "1/5"})
    ax = plotting.draw_effective_potential(TOP, {**values, "p_phi": "1/5", "p_psi": "1/5"}, ax=flat())
    numbers = numbered(ax)
    assert len(found) >= 3 and numbers.keys() == set(range(1, len(found) + 1))
    for n, (theta, _) in numbers.items():
        assert np.cos(theta) == pytest.approx(float(found[n - 1].directions[0][2])), n


@pytest.mark.slow
def test_arcs_have_the_numbers_that_decide_prints(capsys):
    """Between the ends that it prints, on the arc."""
    ax = plotting.draw_staude_cone(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), SUM), {}, space())
    assert main(["decide", "--potential", "k1+k2+k3", "--inertia", "1,2,3", "--set", "l=0"]) == 0
    printed = [int(n) for n in re.findall(r"^permanent rotations, arc (\d+)$", capsys.readouterr().out, re.M)]
    numbers = numbered(ax)
    arcs = gs.staude_cone(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), SUM)).arcs({})
    assert sorted(numbers) == printed == list(range(1, len(arcs) + 1))
    for n, arc in enumerate(arcs, 1):
        low, high = (np.clip(float(x), -1e3, 1e3) for x in (arc.low, arc.high))
        tau = low + (high - low) * np.linspace(0, 1, 2001)[1:-1] ** (3 if high > 900 else 1)
        k = (1 / (np.array([1, 2, 3]) + tau[:, None]))
        k /= np.linalg.norm(k, axis=1)[:, None]
        assert min(np.linalg.norm(numbers[n] - side * k, axis=1).min() for side in (1, -1)) < 0.15, n
