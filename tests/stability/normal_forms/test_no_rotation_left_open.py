"""Linearly stable permanent rotations of asymmetric bodies: not one is left open."""
import random
from itertools import islice

import pytest
from slow import sampled
from window_scenes import drawn

import gyrostat as gs


def linearly_stable(rng, quadratic, rotor):
    """In directions at random, the eigenvalues imaginary and none of them 0."""
    while True:
        rotation, p, q, _ = drawn(rng, quadratic, True, rotor)
        if rotation.field and p > 0 and q > 0 and p * p > 4 * q:
            yield rotation


@pytest.mark.slow
@pytest.mark.parametrize("quadratic", [False, True])
@pytest.mark.parametrize("rotor", [False, True])
def test_none_is_left_open(quadratic, rotor, full):
    """5000 of each kind: the second variation decides most, D4 or D6 the others."""
    rotations, windows = linearly_stable(random.Random(f"open {quadratic} {rotor}"), quadratic, rotor), 0
    for rotation in islice(rotations, sampled(5000, full, 60)):
        decision = gs.analyze(rotation.equilibrium()).verdict({})
        assert decision.verdict is gs.Verdict.STABLE
        windows += "(Arnold)" in decision.reason
    assert windows
