"""D4 and D6 of rotations that gyroscopic forces hold, against another chart and another algorithm."""
import random
from dataclasses import replace
from itertools import islice

import pytest
from flint import fmpq
from normal_form import bracket, decimal, directions, energy, field_of, momenta, rational, twists
from slow import sampled
from sympy import Rational
from window_scenes import Rotation, windows

import gyrostat as gs
from gyrostat.stability.decision import settled
from gyrostat.stability.normal_forms.windows import between_cuts

KINDS = {"uniform, at rest in the body": (False, True, False), "uniform, with a rotor": (False,),
         "uniform, a tensor": (False, False), "quadratic": (True,), "quadratic, a tensor": (True, False)}


def test_the_chart_of_the_oracle_keeps_the_brackets():
    """{M_i, M_j} = −M_k, {M_i, k_j} = −k_k to the degree of the expansion, M·k = C1, and abs(k) = 1."""
    level = fmpq(3, 7)
    M, k = momenta(level), directions(8)
    lowest = [sum((x * y for x, y in zip(M, k)), 0) - level, sum((x * x for x in k), 0) - 1]
    for i, j, n in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        assert bracket(M[i], M[j]) == -M[n]
        lowest += [bracket(M[i], k[j]) + k[n], bracket(M[j], k[i]) - k[n], bracket(k[i], k[j])]
    assert min(sum(e) for f in lowest for e in f.to_dict()) >= 8


def check(rotation, degree):
    """The energy has no slope, p and q are the same, D4 and D6 too; Arnold's theorem decides."""
    parts = energy(*rotation.parts, degree)
    assert parts[1] == 0
    report = gs.analyze(rotation.equilibrium())
    _, p, q = field_of(parts[2])
    assert list(map(rational, report.linearization.frequency_coefficients)) == [p, q]
    D4, *rest = twists(parts)
    form = report.normal_form({}, degree)
    assert rational(form.twists[0]) == D4
    for D6 in rest:
        p, q = report.linearization.frequency_coefficients
        ratio = form.twists[1] ** 2 / (q * (p**2 - 4 * q) * Rational(int(D6.p), int(D6.q)) ** 2)
        assert abs(ratio.evalf(40) - 1) < 1e-30
    decision = report.verdict({})
    assert decision.verdict is gs.Verdict.STABLE and decision.notion == "Lyapunov (Arnold-Moser)"
    assert float(decision.reason.split("D4 = ")[1].split(",")[0]) == pytest.approx(decimal(D4), rel=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_window(kind):
    """Of every kind, one of them to degree 6 too."""
    check(next(windows(random.Random(kind), *KINDS[kind])), 6 if kind == "quadratic, a tensor" else 4)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_many_windows(kind, full):
    """120 of every kind, 600 in all; every tenth to degree 6."""
    drawn = windows(random.Random(f"{kind} 2"), *KINDS[kind])
    for n, rotation in enumerate(islice(drawn, sampled(120, full, 10))):
        check(rotation, 4 + 2 * (n % 10 == 9))


def relabelled(rotation):
    """The axes in another cyclic order."""
    order = (2, 0, 1)
    tensor = [[rotation.tensor[i][j] for j in order] for i in order]
    field = {tuple(e[n] for n in order): c for e, c in rotation.field.items()}
    rotor, k = ([vector[n] for n in order] for vector in (rotation.rotor, rotation.k))
    return Rotation(tensor, rotor, k, rotation.omega, field)


def backwards(rotation):
    """The sense of time, the rotor too."""
    return replace(rotation, omega=-rotation.omega, rotor=[-x for x in rotation.rotor])


def scaled(rotation):
    """Twice as fast, a body three times as great: U is twelve times as great."""
    tensor = [[3 * x for x in row] for row in rotation.tensor]
    field = {e: 12 * c for e, c in rotation.field.items()}
    return Rotation(tensor, [6 * x for x in rotation.rotor], rotation.k, 2 * rotation.omega, field)


@pytest.mark.slow
@pytest.mark.parametrize("change, factor", [(relabelled, 1), (backwards, 1), (scaled, Rational(4, 3))])
def test_what_changes_D4(change, factor):
    """Not the names of the axes, not the sense of time; its unit is frequency⁴ by energy."""
    rotation = next(windows(random.Random(3), *KINDS["uniform, a tensor"]))
    before, after = (gs.analyze(r.equilibrium()).normal_form({}).twists[0]
                     for r in (rotation, change(rotation)))
    assert after == factor * before


@pytest.mark.parametrize("rung", [gs.Rung.RESONANCE, gs.Rung.INTEGRAL, gs.Rung.SIXTH_ORDER,
                                  gs.Rung.TWIST_POSITIVE, gs.Rung.TWIST_NEGATIVE])
@pytest.mark.parametrize("twists", [True, False, None])
def test_what_a_point_says_of_its_window(rung, twists):
    """D4 ≠ 0 speaks of all between two cuts, its sign where its zeros are cuts; nothing else does."""
    point = settled(True, "of a point", rung, note="unusual", pointwise=True)
    found = between_cuts(point, twists)
    by_twist = twists is not None and rung in (gs.Rung.TWIST_POSITIVE, gs.Rung.TWIST_NEGATIVE)
    assert found.verdict == ("STABLE" if by_twist else "UNDECIDED")
    assert found.rung is (gs.Rung.NOTHING if not by_twist else rung if twists else gs.Rung.TWIST)
    assert ("except at single points" in found.reason) == (by_twist and not twists)
    assert found.note == "unusual" and not found.pointwise
