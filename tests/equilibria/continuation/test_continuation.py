"""What is marked along the branches: where stability changes, and where branches meet without a change."""
import numpy as np
import pytest
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.equilibria.continuation.continuation import continuation


def marks(U, ends, values, name="omega"):
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))
    return [(m.kind, m.value, m.k3, m.changes) for m in continuation(scene, name, ends, values).marks]


@pytest.mark.slow
def test_marks_of_the_heavy_top():
    """E1 changes at I3² ω² = 4 I1 m0, E3 leaves it at ω² (I3 − I1) = m0; of a pendulum m0 < 0 it is E2."""
    top = {"I1": 1, "I3": "8/5", "l": 0}
    assert marks(lambda k3: k3, (0, 2), top) == [
        ("precessions leave E1", Rational(5, 4), 1, True), ("E3 leaves E1", sqrt(15) / 3, 1, False)]
    assert marks(lambda k3: -k3, (0, 2), top) == [
        ("precessions leave E2", Rational(5, 4), -1, True), ("E3 leaves E2", sqrt(15) / 3, -1, False)]


@pytest.mark.slow
def test_where_the_field_is_infinite_nothing_changes():
    """U = a/(2 k3 − 1) + k3²: branches come to k3 = 1/2 where a = 0."""
    a = gs.symbol("a")
    found = marks(lambda k3: a / (2 * k3 - 1) + k3**2, ("-1/2", "1/500"),
                  {"I1": 2, "I3": 1, "l": 1, "omega": 1}, "a")
    assert ("U is infinite", 0, Rational(1, 2), False) in found


def test_a_branch_is_followed_closely():
    """k3 = m0/(ω² (I3 − I1)) on E3 of the heavy top without a rotor, in short chords."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3))
    pieces = continuation(scene, "omega", ("1/10", 6), {"I1": 1, "I3": 2, "l": 0}).pieces
    (tilted,) = [piece for piece in pieces if piece.label == "E3"]
    np.testing.assert_allclose(tilted.k3, 1 / tilted.parameter**2, rtol=1e-12)
    assert np.abs(np.diff(tilted.k3)).max() < 0.05
