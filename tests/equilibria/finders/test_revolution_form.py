"""Relative equilibria of bodies of revolution that are not entered in the standard way."""
from fractions import Fraction as F

import numpy as np
import oracle
import pytest
from sympy import lambdify
from turns import OBLIQUE, TURNS, K, rational, scene

import gyrostat as gs
from gyrostat.equilibria.search import relative_equilibria
from gyrostat.errors import ValuesError

FIELD, ROTOR = (F(1), F(-1, 2), F(0), F(2, 3)), F(1, 2)


def standard(I1, I3):
    body = gs.Gyrostat(tuple(map(rational, (I1, I1, I3))), (0, 0, rational(ROTOR)))
    return gs.assemble(body,
                       gs.axial_potential(lambda z: sum(rational(c) * z**n for n, c in enumerate(FIELD, 1))))


def named(name, asked):
    """The names of the standard scene as they are about an axis."""
    axis = "c" if name in OBLIQUE else name[-1]
    return {n.replace("k3", f"k{axis}").replace("pi3", f"pi{axis}"): x for n, x in asked.items()}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["axis 1", "axis 2", "(1, 2, 2)", "(1, 1, 1)"])
@pytest.mark.parametrize("asked", [{"omega": F(3, 2)}, {"pi3_0": 1, "C1": F(3, 2)},
                                   {"k3": F(1, 3), "pi3_0": 6}])
def test_branches_are_those_of_the_standard_scene_and_equilibria_of_the_users(name, asked):
    """As many, with the same decisions.

    Every point turns about the axis at the rate σ and does nothing else, by np.cross.
    """
    I1, I3 = F(2), F(2) if name in OBLIQUE else F(1)
    this, c = scene(name, I1, I3, ROTOR, FIELD, (1, -1, 2)), np.array([float(x) for x in TURNS[name].row(2)])
    theirs = relative_equilibria(standard(I1, I3), asked)
    ours = relative_equilibria(this, named(name, asked))
    assert [(b.label, b.form.k3, b.rates, b.decision.verdict) for b in ours] == [
        (b.label, b.form.k3, b.rates, b.decision.verdict) for b in theirs
    ]
    slope = lambdify(K, [this.potential.expression.diff(k) for k in K])
    assert ours
    for b in ours:
        x = np.array([float(v) for v in b.point])
        rates = oracle.field(x, *(np.array([float(v) for v in y])
                                  for y in (this.body.inertia, this.body.gyrostatic_momentum)),
                             lambda k: np.array(slope(*k)))
        turning = float(b.rates["sigma"]) * np.concatenate([np.cross(x[:3], c), np.cross(x[3:], c)])
        # a few roundings of doubles
        np.testing.assert_allclose(rates, turning, atol=1e-12 * (1 + np.abs(x).max()))
        along, k3 = b.form.described[0]
        assert float(along.subs(dict(zip(K, b.point[3:])))) == pytest.approx(float(k3), abs=1e-14)
        assert b.decision.reason.startswith("recognised as") and "k3" not in b.decision.reason


def test_equality_at_the_numbers_and_names():
    """I2 = I3 at the numbers given.

    The names are those of the axis, others are refused with what there is.
    """
    this = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)),
                       gs.general_potential(gs.symbol("m0") * K[0]))
    top = {"I1": 1, "I2": 2, "I3": 2, "m0": 3}
    found = relative_equilibria(this, top | {"k1": "1/2", "pi1_0": 6})
    assert [str(b.rates["omega"]) for b in found] == ["3 - sqrt(6)", "sqrt(6) + 3"]
    assert all(b.decision.modulo == (gs.symbol("pi1"),) for b in found)
    assert str(found[0]).startswith("precession at k₁ = 1/2")
    with pytest.raises(ValuesError, match="k3"):
        relative_equilibria(this, top | {"k3": "1/2"})
    with pytest.raises(ValuesError, match="k1 and pi1_0"):
        relative_equilibria(this, top)
    with pytest.raises(ValuesError, match="m0"):
        relative_equilibria(this, {"I1": 1, "I2": 2, "I3": 2, "omega": 1})
    assert relative_equilibria(this, top | {"I3": 1, "omega": 1})[0].label == "permanent rotation"
