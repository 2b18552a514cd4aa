"""Verdicts at resonances, where an eigenvalue is 0 and where D4 = 0, met on purpose at rational points."""
import random
from fractions import Fraction as F

import pytest
from exceptional_rotations import (
    QUARTICS,
    along_the_valley,
    degenerate,
    in_a_window,
    in_resonance,
    plain_fraction,
    terms,
    with_form,
    without_the_cubic_term,
    without_twist,
)
from normal_form import decimal, energy, field_of, on_the_torus, removed, resonant, sign_of_the_faster, twists
from slow import sampled
from sympy import Rational, sqrt

import gyrostat as gs

STABLE, UNSTABLE, UNDECIDED = gs.Verdict.STABLE, gs.Verdict.UNSTABLE, gs.Verdict.UNDECIDED
ON_LEVEL = "Lyapunov (Arnold-Moser)", "on its level of C1"


def decided(rotation):
    return gs.analyze(rotation.equilibrium()).verdict({})


def irrational(rotation):
    """The verdict of the motion that is faster by √2."""
    eq, root = rotation.equilibrium(), sqrt(2)
    body, potential = eq.system.body, eq.system.potential
    fast = gs.Gyrostat(rotation.tensor, tuple(root * l for l in body.gyrostatic_momentum))
    scene = gs.assemble(fast, gs.general_potential(2 * potential.expression))
    return gs.analyze(gs.equilibrium(scene, (*(root * x for x in eq.point[:3]), *eq.point[3:]))).verdict({})


def one_to_two(rng):
    """Unstable unless the cubic terms can be removed."""
    given, K = in_resonance(rng, 1, 2)
    rotation = with_form(*given, K, *terms(rng))
    parts = energy(*rotation.parts, 3)
    assert removed(parts[2], parts[3], []) is None
    decision = decided(rotation)
    assert decision.verdict is UNSTABLE and decision.notion == "Lyapunov"
    assert "b of z1 z2² is not 0 (Markeev)" in decision.reason


def one_to_two_without_b(rng):
    """Stable, the cubic terms being chosen so; no symmetry makes b = 0."""
    given, K = in_resonance(rng, 1, 2)
    rotation = with_form(*given, K, *without_the_cubic_term(rng, given, K))
    parts = energy(*rotation.parts, 4)
    assert removed(parts[2], parts[3], []) is not None and len(parts[3].to_dict()) > 5
    D4 = on_the_torus(parts, resonant(parts)[4])[0]
    decision = decided(rotation)
    assert decision.verdict is STABLE and (decision.notion, decision.scope) == ON_LEVEL
    said = float(decision.reason.split("b = 0, D4 = ")[1].split()[0])
    assert said == pytest.approx(D4, rel=1e-4)


def one_to_three(rng):
    """By D4 and R on the torus where h2 vanishes, in doubles."""
    given, K = in_resonance(rng, 1, 3)
    rotation = with_form(*given, K, *terms(rng))
    parts = energy(*rotation.parts, 4)
    D4, R = on_the_torus(parts, resonant(parts)[4])
    decision = decided(rotation)
    stable = abs(D4) > R
    assert decision.verdict is (STABLE if stable else UNSTABLE)
    assert (decision.notion, decision.scope) == (ON_LEVEL if stable else ("Lyapunov", ""))
    words = decision.reason.split("|D4| = ")[1].split()
    assert [float(words[0]), float(words[-1])] == pytest.approx([abs(D4), R], rel=1e-4)


def one_to_one(rng):
    """ε𝒜 changes its sign where D4 (ω1 + ω2) does close by, at a term of U of degree 4."""
    given, K = in_resonance(rng, 1, 1)
    rest = [term for term in terms(rng) if term[0] != QUARTICS[0]]
    steps = F(1, 10**9), -F(1, 10**9)
    elliptic = []
    for step in steps:
        near = [[K[0][0] * (1 + step), K[0][1]], K[1]]
        found = [energy(*with_form(*given, near, *rest, (QUARTICS[0], F(n))).parts, 4) for n in (0, 1)]
        _, p, q = field_of(found[0][2])
        if p * p > 4 * q:
            elliptic.append(found)
    ((without, with_one),) = elliptic
    start, end = (plain_fraction(twists(parts)[0]) for parts in (without, with_one))
    middle = start / (start - end)
    for c in (middle * F(99, 100), middle * F(101, 100)):
        stable = (start + c * (end - start) > 0) is sign_of_the_faster(without)
        decision = decided(with_form(*given, K, *rest, (QUARTICS[0], c)))
        assert decision.verdict is (STABLE if stable else UNSTABLE)
        assert (decision.notion, decision.scope) == (ON_LEVEL if stable else ("Lyapunov", ""))
        assert "(Sokolskii)" in decision.reason


def eigenvalue_0(rng, degree):
    """By the leading term of the amended potential along its valley."""
    given, K, above = degenerate(rng, degree)
    check_degenerate(with_form(*given, K, *above), degree)


def check_degenerate(rotation, degree):
    e, a3, a4 = along_the_valley(rotation)
    assert (a3 == 0) is (degree == 4) and e and a4
    decision = decided(rotation)
    stable = degree == 4 and a4 * e > 0
    assert decision.verdict is (STABLE if stable else UNSTABLE)
    if stable:
        assert ("Sokolskii" if e < 0 else "Lagrange-Dirichlet") in decision.reason
        assert (decision.notion, decision.scope) == ("Lyapunov", "on its level of C1" if e < 0 else "")


def eigenvalue_0_and_degree_3(rng):
    """Unstable."""
    eigenvalue_0(rng, 3)


def eigenvalue_0_and_degree_4(rng):
    """Stable or unstable."""
    eigenvalue_0(rng, 4)


def eigenvalue_0_at_a_maximum(rng):
    """A strict maximum, held by gyroscopic forces."""
    while True:
        given, K, above = degenerate(rng, 4)
        rotation = with_form(*given, K, *above)
        e, _, a4 = along_the_valley(rotation)
        if e < 0 and a4 < 0:
            return check_degenerate(rotation, 4)


def no_twist(rng):
    """D4 = 0 exactly; D6 decides."""
    given, K = in_a_window(rng)
    rotation = with_form(*given, K, *without_twist(rng, given, K))
    parts = energy(*rotation.parts, 6)
    D4, D6 = twists(parts)
    _, p, q = field_of(parts[2])
    decision = decided(rotation)
    assert D4 == 0 and decision.verdict is STABLE and decision.notion == "Lyapunov (Arnold-Moser)"
    said = float(decision.reason.split("D4 = 0, D6 = ")[1].split(",")[0])
    assert abs(said) == pytest.approx(abs(decimal(D6)) * decimal(q * (p * p - 4 * q))**0.5, rel=1e-4)


COUNTS = {one_to_two: 100, one_to_two_without_b: 30, one_to_three: 100, one_to_one: 50,
          eigenvalue_0_and_degree_3: 30, eigenvalue_0_and_degree_4: 50,
          eigenvalue_0_at_a_maximum: 20, no_twist: 30}


@pytest.mark.few(1)
@pytest.mark.parametrize("check", COUNTS, ids=lambda check: check.__name__)
def test_two_of_a_kind(check):
    """Of every kind."""
    rng = random.Random(check.__name__)
    check(rng)
    check(rng)


@pytest.mark.slow
@pytest.mark.parametrize("check", COUNTS, ids=lambda check: check.__name__)
def test_many_of_a_kind(check, full):
    """460 in all."""
    rng = random.Random(f"{check.__name__} 2")
    for _ in range(sampled(COUNTS[check], full, 5)):
        check(rng)


@pytest.mark.slow
@pytest.mark.parametrize("pair", [(1, 4), (2, 3), (1, 5)], ids=str)
def test_a_resonance_of_the_fifth_or_sixth_order(pair):
    """Nothing to D4; where D4 = 0 it is not decided."""
    rng = random.Random(1)
    given, K = in_resonance(rng, *pair)
    assert "no resonance to order 4" in decided(with_form(*given, K, *terms(rng))).reason
    decision = decided(with_form(*given, K, *without_twist(rng, given, K)))
    assert decision.verdict is UNDECIDED
    assert decision.reason.endswith(f"D4 = 0, and the resonance {pair[0]}:{pair[1]} holds")


@pytest.mark.slow
def test_a_twist_that_is_almost_0():
    """10⁻⁶⁰ and not 0: D4 decides, not D6."""
    rng = random.Random(2)
    given, K = in_a_window(rng)
    above = without_twist(rng, given, K)
    (D4,) = twists(energy(*with_form(*given, K, *above, (QUARTICS[0], F(1))).parts, 4))
    decision = decided(with_form(*given, K, *above, (QUARTICS[0], F(1, 10**60) / plain_fraction(D4))))
    assert "; D4 = 1.00000e-60, no resonance" in decision.reason


def test_a_cubic_term_that_is_enclosed_only():
    """b = 0 at irrational numbers is not proved by balls: UNDECIDED."""
    rng = random.Random(1)
    given, K = in_resonance(rng, 1, 2)
    rotation = with_form(*given, K, *without_the_cubic_term(rng, given, K))
    decision = irrational(rotation)
    assert decision.verdict is UNDECIDED
    assert decision.reason.endswith("resonance 1:2, and what decides it is not proved to differ from 0")


def test_a_resonance_at_irrational_numbers():
    """In balls as in fractions; D4 and R go as the square of the rates."""
    rng = random.Random(1)
    given, K = in_resonance(rng, 1, 3)
    rotation = with_form(*given, K, *terms(rng))
    parts = energy(*rotation.parts, 4)
    words = irrational(rotation).reason.split("|D4| = ")[1].split()
    D4, R = on_the_torus(parts, resonant(parts)[4])
    assert [float(words[0]), float(words[-1])] == pytest.approx([2 * abs(D4), 2 * R], rel=1e-4)


@pytest.mark.parametrize(("sigma", "verdict", "words"), [
    ((156957 - 24 * sqrt(45954705)) / 2161, STABLE, "(1:1, Hamiltonian-Hopf), ε𝒜 > 0"),
    ((-628599 + 15 * sqrt(783844905)) / 75868, UNSTABLE, "resonance 1:2, the coefficient b"),
    ((-654237 + 40 * sqrt(55548705)) / 124559, UNSTABLE, "resonance 1:3, |D4| = 0.127221 < R = 0.170739"),
])
def test_at_a_rational_point_of_an_irrational_field(sigma, verdict, words):
    inertia, k = (3, 5, 4), [Rational(n, 3) for n in (2, 1, 2)]
    scene = gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)), gs.general_potential(
        lambda *x: sum((I + sigma) * a * b for I, a, b in zip(inertia, k, x))))
    decision = gs.analyze(gs.equilibrium(scene, (*(-I * a for I, a in zip(inertia, k)), *k))).verdict({})
    assert decision.verdict is verdict and words in decision.reason
