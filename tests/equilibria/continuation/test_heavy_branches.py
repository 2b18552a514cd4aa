"""Permanent rotations of a heavy gyrostat followed along a name, against counts and verdicts at values."""
import random

import heavy
import numpy as np
import pytest
from heavy_scenes import drawn, floats, k1, k2, k3, scene_of
from matplotlib.figure import Figure
from slow import sampled
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

BODY = gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l3")))
PLANE = gs.assemble(BODY, gs.general_potential(k1 / 2 + 2 * k3))


def counted(l3):
    """How many rotations at omega = 1 Newton's method finds."""
    return len(heavy.directions(np.diag([1.0, 2, 3]), np.array([0, 0, l3]), np.array([0.5, 0, 2]),
                                np.zeros((3, 3)), 1.0, starts=300))


@pytest.mark.slow
def test_folds_and_a_pitchfork_in_a_plane_of_symmetry():
    """At a fold two appear or vanish, at a pitchfork off the plane; a piece for each, with its verdict."""
    found = gs.continuation(PLANE, "l3", (-4, 4), {"omega": 1})
    met = [mark for mark in found.marks if not mark.changes]
    marks = [(mark.kind, float(mark.value)) for mark in met]
    assert [kind for kind, _ in marks] == ["fold", "pitchfork", "pitchfork", "fold"]
    assert [mark.value for mark in met[1:3]] == [2 - sqrt(3) / 2, 2 + sqrt(3) / 2]
    for kind, value in marks:
        before, after = counted(value - 0.01), counted(value + 0.01)
        assert abs(before - after) == 2, (kind, value)
    for l3 in (-3, 1.6, 2.2, 3.5):
        here = [piece for piece in found.pieces if piece.parameter[0] < l3 < piece.parameter[-1]]
        assert len(here) == counted(l3)
        exact = gs.relative_equilibria(PLANE, {"omega": 1, "l3": l3})
        for piece in here:
            k = [np.interp(l3, piece.parameter, column) for column in piece.k.T]
            near = min(exact, key=lambda r: sum((float(x) - y) ** 2 for x, y in zip(r.directions[0], k)))
            assert np.abs(np.array(k) - [float(x) for x in near.directions[0]]).max() < 0.05
            assert near.decision.verdict is piece.verdict


def folds(rng):
    """Of a random scene over a range of omega; at each the count by Newton's method changes by 2."""
    inertia, rotor, c, Q, _ = drawn(rng, False)
    if not any(c):
        return 0
    found = gs.continuation(scene_of(inertia, rotor, c, Q), "omega", ("1/4", "9/4"), {})
    for mark in found.marks:
        value = float(mark.value)
        others = [abs(value - float(other.value)) for other in found.marks if other is not mark]
        step = min([1e-3, *(gap / 4 for gap in others)])
        if mark.kind == "fold" and step > 1e-6:
            sides = [floats(inertia, rotor, c, Q, value + s * step) for s in (-1, 1)]
            before, after = (len(heavy.directions(*side, starts=600)) for side in sides)
            assert abs(before - after) == 2, (inertia, rotor, c, Q, value)
    for omega in (0.5131, 1.2571, 2.0313):
        here = [piece for piece in found.pieces if piece.parameter[0] < omega < piece.parameter[-1]]
        count = len(heavy.directions(*floats(inertia, rotor, c, Q, omega), starts=400))
        assert len(here) == count or any(abs(float(m.value) - omega) < 1e-3 for m in found.marks)
    return len(found.marks)


@pytest.mark.slow
def test_along_omega(full):
    rng = random.Random("folds")
    count = sampled(60, full, 4)
    assert sum(folds(rng) for _ in range(count)) >= count / 2


@pytest.mark.slow
def test_the_picture():
    ax = gs.plotting.draw_bifurcation_diagram(PLANE, "l3", ("5/2", 3), {"omega": 1},
                                              Figure().subplots())
    names = {text.get_text() for text in (*ax.get_legend().get_texts(), *ax.texts)}
    assert {"unstable", "fold", "pitchfork", "singular form"} <= names
    heights = {}
    for line in ax.lines:                              # marks that nearly coincide have lines of their own
        if line.get_linestyle() == "None":
            heights.setdefault(line.get_marker(), []).extend(line.get_ydata())
    assert np.allclose(heights["P"], -(3**0.5) / 2) and len(heights["o"]) == 2


@pytest.mark.slow
def test_a_pair_that_is_real_at_one_value_alone_is_no_pitchfork():
    """Off the plane k1 = −1, so that k2² = −(2 − l3)²."""
    scene = gs.assemble(BODY, gs.general_potential(k1 + 2 * k3))
    assert not gs.continuation(scene, "l3", ("7/4", "9/4"), {"omega": 1}).marks


def test_what_is_refused():
    body = gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l3")))
    cubic = gs.assemble(body, gs.general_potential(k1**3 + k2))
    with pytest.raises(ScopeError, match="U has degree 3 in k: branches of rotations are computed if"):
        gs.continuation(cubic, "l3", (0, 1), {"omega": 1})
    with pytest.raises(ValuesError, match="need omega"):
        gs.continuation(PLANE, "l3", (0, 1), {})
    with pytest.raises(ValuesError, match="l3 is free, and the value 1 is given for it"):
        gs.continuation(PLANE, "l3", (0, 1), {"omega": 1, "l3": 1})


@pytest.mark.slow
def test_two_changes_closer_than_nodes():
    """Gyroscopic forces hold a rotation over 0.0064 of m, where frequencies meet to where det = 0."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(k1 / 2 + gs.symbol("m") * k3))
    found = gs.continuation(scene, "m", (1, 3), {"omega": 1})
    assert [(mark.kind, mark.changes) for mark in found.marks] == [("frequencies meet", True),
                                                                   ("singular form", True)]
    low, high = (mark.value for mark in found.marks)
    assert (82944 * high**10 - 1029888 * high**8 + 5104512 * high**6 - 13019424 * high**4 + 13397764 * high**2
            - 2460375).equals(0) and 0 < float(high - low) < 0.0064
    for m in ("1.33", "1.338", "1.35"):
        listed = gs.relative_equilibria(scene, {"omega": 1, "m": m})
        followed = [p for p in found.pieces if p.parameter[0] < float(m) < p.parameter[-1]]
        assert sorted(p.verdict.name for p in followed) == sorted(e.decision.verdict.name for e in listed)


@pytest.mark.slow
def test_a_change_of_rotations_on_either_side_of_a_plane():
    """Those with a part along an axis without force and rotor, at 2 omega⁴ = 3."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(k3))
    found = [mark for mark in gs.continuation(scene, "omega", (1, "3/2"), {}).marks if mark.changes]
    assert {mark.kind for mark in found} == {"singular form"}
    assert len({mark.value for mark in found}) == 1 and (2 * found[0].value**4 - 3).equals(0)
    across, side, high = (sqrt(Rational(n, 6)) for n in (2, 5, 4))
    wanted = [(0, across, high), (0, -across, high), (side, 0, high / 2), (-side, 0, high / 2)]
    np.testing.assert_allclose(sorted(map(list, np.array([mark.k for mark in found], float))),
                               sorted(map(list, np.array(wanted, float))), atol=1e-9)
