"""Degenerate permanent rotations: folds, pitchforks, umbilics; equal moments; the symbolic family."""
import random

import numpy as np
import oracle
import pytest
from equilibria.degenerate_rotations import drawn, exact
from slow import sampled, slow
from small_circle import is_extremum

import gyrostat as gs


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "cases"), [
    ("fold", 2), ("pitchfork", 4), ("umbilic", 2),
    *slow(("fold", 500), ("pitchfork", 500), ("umbilic", 500))])
def test_a_degenerate_rotation_is_stable_where_the_energy_is_an_extremum(kind, cases, full):
    """It is found, with Δ = 0, and decided as 60 digits of the energy say; by Report.verdict too."""
    rnd = random.Random(f"{kind} {cases}")
    seen = set()
    for _ in range(sampled(cases, full, 25)):
        moments, rotor, M, size = drawn(rnd, kind)
        body = gs.Gyrostat(exact(moments), exact(rotor))
        (found,) = [p for p in rotations(body, *exact([size])) if p.momentum == exact(M)]
        verdict = gs.Verdict.of(is_extremum(moments, rotor, M))
        assert found.form.signs[-1] == 0 and not found.frequencies and found.growth_rate is None
        assert found.decision.verdict is verdict
        pi = [m - l for m, l in zip(M, rotor)]
        assert gs.analyze(gs.equilibrium(gs.assemble(body), exact(pi))).verdict({}).verdict is verdict
        seen.add(verdict.name)
    assert seen == ({"STABLE", "UNSTABLE"} if kind == "pitchfork" else {"UNSTABLE"})


def rotations(body, radius):
    """All on a momentum sphere."""
    return gs.relative_equilibria(gs.assemble(body), {"M": radius})


def damped(body, momentum):
    """The verdicts on the rotation without damping and with it."""
    point = [m - l for m, l in zip(momentum, body.gyrostatic_momentum)]
    report = gs.analyze(gs.equilibrium(gs.assemble(body), point))
    return [report.verdict({}, damped=given).verdict.name for given in (False, True)]


@pytest.mark.parametrize("side", [1, -1])
def test_equal_moments_with_the_rotor_across(side):
    """I = (2, 2, 1), ν = 1: M₃ = 0 = d₃ and d₁ = d₂ < 0, a maximum of fourth order."""
    body, momentum = gs.Gyrostat((2, 2, 1), (-3 * side, 0, 0)), (3 * side, 0, 0)
    (found,) = [p for p in rotations(body, 3) if p.momentum == momentum]
    assert found.form.nu == 1 and found.form.signs[-1] == 0 and found.decision.verdict.name == "STABLE"
    assert damped(body, momentum) == ["STABLE", "UNSTABLE"]


@pytest.mark.parametrize("l, momentum, kept", [(1, 2, "STABLE"), (-1, -2, "STABLE"), (-1, 2, "UNSTABLE")])
def test_equal_moments_about_their_axis(l, momentum, kept):
    """d₁ = d₂ = 0: the energy goes with the fourth power of the distance from the axis, and with l M₃."""
    body = gs.Gyrostat((2, 2, 1 if l * momentum > 0 else 3), (0, 0, l))
    (found,) = [p for p in rotations(body, 2) if p.momentum == (0, 0, momentum)]
    assert found.form.signs[-1] == 0 and found.decision.verdict.name == "STABLE"
    assert damped(body, (0, 0, momentum)) == ["STABLE", kept]


def test_the_frequency_is_that_of_the_motion():
    """√Δ and √−Δ are eigenvalues of the field, differenced."""
    body = gs.Gyrostat((1, 2, 3), ("1/10", "1/5", "3/10"))
    I, l = np.array([1.0, 2, 3]), np.array([0.1, 0.2, 0.3])
    for rotation in rotations(body, 1):
        J = oracle.jacobian(lambda x: oracle.free_field(x, I, l),
                            np.array([float(m) for m in rotation.momentum]) - l, 1.0).astype(float)
        values = np.linalg.eigvals(J)
        if not rotation.frequencies:
            assert float(rotation.growth_rate) == pytest.approx(values.real.max(), rel=1e-6)
        else:
            assert rotation.growth_rate is None
            (frequency,) = rotation.frequencies
            assert float(frequency) == pytest.approx(values.imag.max(), rel=1e-6)


def test_the_family_of_all_has_one_margin():
    """l = (1 − ν I) M: Δ > 0 is necessary and sufficient, in (I, M, ν)."""
    I, M = ([gs.symbol(f"{x}{n}") for n in (1, 2, 3)] for x in "IM")
    nu = gs.symbol("nu")
    scene = gs.assemble(gs.Gyrostat(I, [(1 - nu * i) * m for i, m in zip(I, M)]))
    report = gs.analyze(gs.equilibrium(scene, [nu * i * m for i, m in zip(I, M)]))
    ((necessary,),), ((sufficient,),) = report.necessary.alternatives, report.sufficient.alternatives
    d = [1 / i - nu for i in I]
    delta = sum(M[n]**2 * d[n - 1] * d[n - 2] for n in range(3)) * I[0] * I[1] * I[2]
    assert necessary.margin == sufficient.margin == delta.expand()
    assert sufficient.strict and not sufficient.degenerate
