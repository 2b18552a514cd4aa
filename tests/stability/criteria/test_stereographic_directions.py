"""Permanent rotations in directions by stereographic coordinates."""
import random
from fractions import Fraction

import pytest
from rotation_families import LINEAR, ROTOR, drawn, family
from slow import sampled

import gyrostat as gs


@pytest.mark.slow
@pytest.mark.parametrize("body", [{"inertia": (3, 5, 4), "gyrostatic_momentum": (1, "-1/2", 2)},
                                  pytest.param({"gyrostatic_momentum": ROTOR}, marks=pytest.mark.slow)])
def test_stereographic_coordinates_have_the_same_verdicts(body, full):
    """The conditions in u1 and u2, expanded, against those by definitions; damped too."""
    rng, verdicts = random.Random("u1 u2"), set()
    any_direction = family(LINEAR, **body)
    eq = gs.permanent_rotation(any_direction.equilibrium.system, gs.stereographic())
    report = gs.analyze(eq)
    for _ in range(sampled(2000, full, 60)):
        numbers = {name: x for name, x in drawn(rng, False)[0].items() if name in any_direction.required}
        place = {f"u{n}": Fraction(rng.randint(-9, 9), rng.randint(2, 7)) for n in (1, 2)}
        at = {gs.symbol(name): x for name, x in place.items()}
        k = dict(zip(("k1", "k2", "k3"), (x.subs(at) for x in gs.stereographic())))
        own = {name: x for name, x in numbers.items() if name not in k}
        for damped in (False, True):
            theirs = any_direction.verdict(own | k, damped=damped)
            ours = report.verdict(own | place, damped=damped)
            assert (ours.verdict, ours.growing) == (theirs.verdict, theirs.growing)
        verdicts.add(any_direction.verdict(own | k).verdict.name)
    assert verdicts >= {"STABLE", "UNSTABLE"}
