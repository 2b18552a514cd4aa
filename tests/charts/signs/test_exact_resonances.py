"""Arrays and charts that meet a resonance, or D4 = 0, exactly at a point of theirs."""
import random
from fractions import Fraction as F

import numpy as np
import pytest
from exceptional_rotations import in_a_window, in_resonance, terms, with_form, without_twist
from slow import slow
from sympy import Rational
from window_scenes import UNIT, cross

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF

AT = [F(-1, 16), F(-1, 64), F(0), F(1, 64), F(1, 16)]


def met(kind, rng):
    """A rotation of that kind."""
    if kind == "D4 = 0":
        given, K = in_a_window(rng)
        return with_form(*given, K, *without_twist(rng, given, K))
    given, K = in_resonance(rng, 1, kind)
    return with_form(*given, K, *terms(rng))


def family(rotation):
    """The same equilibrium in a field that bends with s across k, ((x − k)·a)² s; as it was at s = 0."""
    k = rotation.k
    a = next(v for e in UNIT if any(v := cross(k, e)))

    def exact(x):
        return Rational(x.numerator, x.denominator)

    def U(*x):
        plain = sum(exact(c) * x[0]**p * x[1]**q * x[2]**r for (p, q, r), c in rotation.field.items())
        return plain + gs.symbol("s") * sum(exact(w) * (y - exact(z)) for w, y, z in zip(a, x, k))**2

    scene = gs.assemble(gs.Gyrostat(rotation.tensor, tuple(rotation.rotor)), gs.general_potential(U))
    pi = [m - l for m, l in zip(rotation.momentum, rotation.rotor)]
    return gs.analyze(gs.equilibrium(scene, (*pi, *k)))


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "seed"), [(2, 1), *slow(*((kind, seed) for kind in (1, 2, 3, "D4 = 0")
                                                            for seed in (2, 3, 4)))])
def test_arrays(kind, seed):
    """Each verdict is that of the report, at the point itself too."""
    report = family(met(kind, random.Random(f"{kind} {seed}")))
    found = gs.charts.verdicts(report, {"s": np.array(AT, dtype=object)})
    decisions = [report.verdict({"s": s}) for s in AT]
    assert [CODE_OF[d.verdict] for d in decisions] == list(found)
    words = {1: "1:1", 2: "1:2", 3: "1:3", "D4 = 0": "D4 = 0"}[kind]
    assert words in decisions[2].reason or "resonan" in decisions[2].reason
