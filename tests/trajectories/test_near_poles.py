"""Motions that start next to a pole, or next to what is hard, against Taylor series to 40 digits.

Equilibria that confirm their verdict.
"""
import random
import sys
from fractions import Fraction as F
from pathlib import Path

import pytest
from slow import slow
from sympy import Rational, exp

import gyrostat as gs
from gyrostat.errors import AccuracyError
from gyrostat.stability.decision import Verdict
from gyrostat.trajectories import confirm, confirmation, motion

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


@pytest.fixture(scope="module")
def campaign():
    sys.path.insert(0, str(BENCHMARKS))
    try:
        import near_poles
    finally:
        sys.path.remove(str(BENCHMARKS))
    return near_poles


def beside(e, l, momentum):
    """(e/3, e/5, π3) at 2 e from the upper pole."""
    e = F(e)
    return l, (e / 3, e / 5, F(momentum), 2 * e / (1 + e * e), F(0), (1 - e * e) / (1 + e * e))


FOUND = {"exponential": ([("exp", F(-1), F(1))], F(1), F(1), *beside("1e-8", F(0), 1)),
         "rational": ([("power", F(1), F(2), -1)], F(1), F(1), *beside("1e-14", F(0), "5/2")),
         "almost at rest in a growing field": (
             [("exp", F(3, 2), F(-3, 8))], F(29, 8), F(1, 8), F(-1, 4),
             (F(-13, 80000), F(-1, 20000), F(-9, 4), F(-100000, 1300000013), F(240000, 1300000013),
              F(99999999, 100000001))),
         "falling": ([("power", F(-1, 4), F(2), -1)], F(5, 2), F(13, 10), *beside("1e-6", F(3, 4), "7/4"))}


@pytest.mark.parametrize("name", ["exponential", "falling", *slow(("rational",),
                                                                     ("almost at rest in a growing field",))])
def test_starts_at_which_g_cancels(campaign, name):
    """Fields that are no polynomial, 10⁻⁴ to 10⁻¹⁴ from a pole: three periods to 10⁻¹³, by quadrature."""
    off, route = campaign.deviation_of(FOUND[name])
    assert off < 1e-13 and route == "quadrature"


def test_digits_next_to_a_pole(campaign):
    """The same to 30 digits.

    The period too, which is a little less than that of the linearised field at the pole.
    """
    off, _ = campaign.deviation_of(FOUND["exponential"], precision=30)
    assert off < 1e-28


def test_a_start_beyond_every_double(campaign):
    """10⁻⁶⁰ from the pole, where 1 − k3 is no double and the other root is nearer still."""
    off, _ = campaign.deviation_of(([("exp", F(2), F(-3, 4))], F(13, 4), F(11, 4),
                                    *beside("1e-60", F(9, 8), "1/8")))
    assert off < 1e-13


def test_digits_that_a_late_time_has_cost():
    """So late that the digits asked for are not known: an error, not wrong digits."""
    top = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.axial_potential(lambda z: z))
    moving = motion(top, ("1/3", 0, 1, "3/5", 0, "4/5"), precision=20)
    assert moving("1e20")[5] < 1
    with pytest.raises(AccuracyError, match="not known to 20 digits"):
        moving("1e60")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["exponential", "rational", "trigonometric", "polynomial", "singular",
                                  "root", "scaled", "at the pole",
                                  "through a pole", "near a steady precession", "near a separatrix"])
def test_random_starts(campaign, kind):
    """Every one is answered, to 10⁻¹³.

    Where U is infinite 10⁻³ beyond the pole, which magnifies the rounding of a momentum, to 5·10⁻¹³.
    """
    rng = random.Random(f"tests {kind}")
    for _ in range(10):
        off, _ = campaign.deviation_of(campaign.FAMILIES[kind](rng, kind))
        assert off < (5e-13 if kind in ("singular", "through a pole") else 1e-13)


SIZES = [F(1, 10**d) for d in (3, 5, 7)]


def test_an_equilibrium_in_an_exponential_field(monkeypatch):
    """U = −(5/4) exp(5 k3/4), upright: stable, and the motions next to the pole show it."""
    monkeypatch.setattr(confirmation, "TURNS", confirmation.TURNS[:1])
    upright = gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                     gs.axial_potential(lambda z: -Rational(5, 4) * exp(5 * z / 4))))
    found = confirm(gs.analyze(upright), {"I1": "2.9", "I3": "0.9", "l": "0.75", "pi3_0": "-2.75"}, SIZES)
    assert found.decision.verdict is Verdict.STABLE
    assert found.agrees
    assert found.why == ""
    assert abs(found.slope - 1) < 1e-2


def test_what_is_not_followed_is_said(monkeypatch):
    """A motion that is not followed is no error: the answer is None, and why."""
    def refused(scene, state):
        raise AccuracyError("too close to a separatrix")

    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    monkeypatch.setattr(confirmation, "motion", refused)
    found = confirm(top, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 3}, SIZES)
    assert found.agrees is None
    assert found.sizes == ()
    assert "size 1e-03 a motion is not followed: too close to a separatrix" in found.why


@pytest.mark.slow
def test_random_equilibria(campaign):
    """E1, E2, E3 in random fields, on their boundaries, free gyrostats, general ones.

    Agreed with, or said why not.
    """
    assert campaign.confirmations("tests", 15, SIZES)
