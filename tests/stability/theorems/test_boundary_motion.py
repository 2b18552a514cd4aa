"""The boundary theorem against the motion: how far k3 goes from a boundary point that is moved by ε.

Turning points are proved enclosures of the roots of g.
"""
from functools import cache

import numpy as np
import pytest
from flint import fmpq
from stability.moved_points import CASES, DEGREE, KINDS, NAMED, REACH, cases, excursion, names, plain, roots

import gyrostat as gs
from gyrostat.stability.decision import Verdict

SMALL = tuple(fmpq(1, 10**d) for d in (12, 14))
STABLE, UNSTABLE = ([kind for kind in KINDS if kind[1] == verdict] for verdict in ("STABLE", "UNSTABLE"))


@cache
def excursions(kind, level=False):
    """Of every case, at every ε."""
    steps = NAMED + (SMALL if kind in STABLE else SMALL[:1])
    return [[excursion(case, eps, level)[0] for eps in steps] for case in cases(*kind)[::3 if level else 1]]


def exponent(family, n, level):
    """α with excursion ~ ε^α: the state is moved by ε, and g by what follows.

    E1, E2: g = −O(ε⁴) + O(ε²) y + (P² − P'²) y² + c y^(n+2). Where P² changes by ε, that balances c yⁿ: α =
    1/n. Where it does not, or by ε² only (P = 0), ε² y balances c y^(n+2): α = 2/(n + 1). E3: e, v, P change
    by ε, but g = I1² ż² = O(ε²) where the motion starts, at y = O(ε); hence g = O(ε²) + O(ε) y + … + c
    y^(n+2): α = 1/(n + 1). With v and P kept, e changes by ε²: α = 2/(n + 2).
    """
    if family == "inclined":
        return 2 / (n + 2) if level else 1 / (n + 1)
    return 2 / (n + 1) if level else 1 / n


@pytest.mark.parametrize("kind", KINDS, ids=names)
def test_boundary_points_are_what_they_are_built_to_be(kind):
    """g = c y^(n+2) + … exactly, c of the sign wanted.

    Nothing else vanishes or takes over for abs(y) ≤ 1/4; P = 0 = U' occurs.
    """
    family, verdict, n = kind
    zero = 0
    for case in cases(*kind):
        g = case.reduced(case.state)
        assert g[:n + 2] == [0] * (n + 2) and g[n + 2] == case.first != 0
        held = case.first < 0 and (family != "inclined" or n % 2 == 0)
        assert held == (verdict == "STABLE")
        assert sum(abs(c) * REACH**j for j, c in enumerate(g[n + 3:], 1)) <= abs(case.first) / 2
        P, slope = case.integrals(case.state)[2], sum(i * a * case.state[5] ** (i - 1)
                                                      for i, a in enumerate(case.potential) if i)
        assert family == "inclined" or (P == 0) == (slope == 0)
        zero += P == 0
    assert len(cases(*kind)) == CASES and zero == (0 if family == "inclined" else CASES // 5)


@cache
def report(family):
    """Of a family in U = a1 z + … + a6 z⁶."""
    k3 = gs.symbol("k3")
    potential = gs.axial_potential(sum(gs.symbol(f"a{i}") * k3**i for i in range(1, DEGREE + 1)))
    return gs.analyze(getattr(gs, family)(gs.assemble(gs.symmetric_gyrostat(), potential)))


@pytest.mark.few(2)
@pytest.mark.parametrize("kind", KINDS, ids=names)
def test_verdict_is_what_the_motion_does(kind):
    """STABLE exactly where the excursion from a point moved by ε = 10⁻¹² has become small, UNSTABLE where it
    has not.
    """
    for case, far in zip(cases(*kind), excursions(kind)):
        # ε^(1/5) = 0.004 against 1/4
        motion = Verdict.STABLE if far[len(NAMED)] < 0.05 else Verdict.UNSTABLE
        assert report(kind[0]).verdict(case.values()).verdict is motion is Verdict[kind[1]]


@pytest.mark.few(2)
@pytest.mark.parametrize("level", [False, True], ids=["generic", "level"])
@pytest.mark.parametrize("kind", STABLE, ids=names)
def test_excursion_from_a_stable_point_has_the_exponent(kind, level):
    """abs(k3 − z0) ~ ε^(1/n), and ε^(2/(n+1)) with P kept or P = 0, at E1 and E2.

    At E3 it is ~ ε^(1/(n+1)), and ε^(2/(n+2)) with v and P kept.
    """
    family, _, n = kind
    for case, far in zip(cases(*kind)[::3 if level else 1], excursions(kind, level)):
        same = level or (family != "inclined" and case.integrals(case.state)[2] == 0)
        alpha = exponent(family, n, same)
        slopes = [np.log(a / b) / np.log(plain(p / q))
                  for a, b, p, q in zip(far, far[1:], NAMED + SMALL, (NAMED + SMALL)[1:])]
        # next terms are smaller by ε^(1/5) or more: a few hundredths in the slope at 10⁻⁴, below 10⁻³ at
        # 10⁻¹⁴
        assert abs(slopes[1] - alpha) < 0.05 and abs(slopes[-1] - alpha) < 1e-3
        assert min(range(1, 9), key=lambda j: abs(slopes[1] - exponent(family, j, same))) == n  # noqa: B023


@pytest.mark.few(2)
@pytest.mark.parametrize("kind", UNSTABLE, ids=names)
def test_excursion_from_an_unstable_point_is_of_order_one(kind):
    """abs(k3 − z0) > 1/4 for every ε, and tends to the next root of the unperturbed g on a side where g > 0.
    """
    for case, far in zip(cases(*kind), excursions(kind)):
        real = [float(r) for r in roots(case.reduced(case.state))[0]]
        sides = [min(r for r in real if r > 0)] if case.first > 0 else []
        if case.family == "inclined" and case.first * (-1) ** kind[2] > 0:
            sides.append(min(-r for r in real if r < 0))
        assert min(far + sides) > plain(REACH)
        # ε = 10⁻¹² over the slope of g there
        assert min(abs(far[-1] / y - 1) for y in sides) < 1e-9
