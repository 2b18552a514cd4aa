"""Criteria: the printed inequalities, and what must not be dropped."""
from fractions import Fraction

import oracle
import pytest
from draw import moments, numbers
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import ImmutableMatrix, Poly, Rational, cancel, cos, diag, exp, expand, symbols

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.notation import NOTATION
from gyrostat.stability.criteria.conditions import Condition, Criterion, independent
from gyrostat.stability.criteria.linearization import Linearization
from gyrostat.stability.criteria.truth import holds

I1, I2, I3, l, pi3, w3, dU, d2U, k3, omega, m0, m1 = map(gs.symbol, (
    "I1", "I2", "I3", "l", "pi3_0", "omega3_0", "dU", "d2U", "k3", "omega", "m0", "m1"))
P = pi3 + l


def single(criterion):
    """The only condition of a criterion."""
    ((condition,),) = criterion.alternatives
    return condition


def R(value):
    return Rational(Fraction(value).numerator, Fraction(value).denominator)


@pytest.mark.parametrize(("report", "s"), [("e1", 1), ("e2", -1)])
def test_vertical_conditions(report, s, request):
    """VV2003 §4: necessary (π3 + l)² ≥ ±4 I1 U'(±1), sufficient the strict one; nothing else is left."""
    report = request.getfixturevalue(report)
    for criterion, strict in ((report.necessary, False), (report.sufficient, True)):
        condition = single(criterion)
        assert condition.margin == expand(P**2 - 4 * s * I1 * dU) and condition.strict == strict
        assert condition.degenerate == () and condition.at == s and criterion.modulo == ()


def test_inclined_conditions(e3):
    """p ≥ 0 and p > 0 modulo the spin, p as printed in VV2003 §5 with U' from the relation.

    The Casimirs alone say nothing.
    """
    a = ((I1 - I3) * omega * k3 - l) / I1
    slope = omega * l - omega**2 * k3 * (I1 - I3)
    p = I1 * (1 - k3**2) * d2U - 2 * I1 * k3 * slope + I1**2 * (omega**2 + a**2)
    assert single(e3.necessary).margin == single(e3.sufficient).margin == expand(p)
    assert not single(e3.necessary).strict and single(e3.sufficient).strict
    assert e3.sufficient.modulo == e3.necessary.modulo == (gs.symbol("pi3"),)
    assert e3.casimirs_only.alternatives == ()


@pytest.mark.parametrize(("make", "s"), [(gs.upright, 1), (gs.hanging, -1)])
def test_casimirs_alone_prove_less(scene, make, s):
    """P ω3 − I1 ω3² > s U1 (Holm, Marsden, Ratiu & Weinstein 1985, for general U)."""
    report = gs.analyze(make(scene, spin="omega3_0"))
    assert single(report.casimirs_only).margin == expand((I3 * w3 + l) * w3 - I1 * w3**2 - s * dU)
    assert report.casimirs_only != report.sufficient


def test_rumiantsev_and_cavas_viguera():
    """(I3 ω + l)² > 4 I1 m0 and (I3 ω + l)² > 4 I1 (m0 − m1 (I1 − I3)), as quoted in VV2003 §1."""
    for field, right in ((gs.uniform_field(), m0), (gs.newtonian_field(2), m0 - m1 * (I1 - I3))):
        report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), field), spin="omega3_0"))
        assert single(report.sufficient).margin == expand((I3 * w3 + l) ** 2 - 4 * I1 * right)


def test_the_general_test_stays_available(e1):
    """p, q, p² − 4q of E1 with the even factors that VV2003's discriminant (2a + b)² (b² + 4dc) has."""
    p, q, discriminant = gs.derivation.spectral_criterion(e1.linearization).alternatives[0]
    even = I3 * P - 2 * I1 * pi3                        # −(2a + b) I1 I3
    assert [c.source for c in (p, q, discriminant)] == ["p", "q", "p² − 4q"]
    assert discriminant.margin == expand(P**2 - 4 * I1 * dU)
    assert len(discriminant.degenerate) == 1 and cancel(discriminant.degenerate[0] / even) in (1, -1)
    assert q.margin == 1 and len(q.degenerate) == 1
    assert p.degenerate == () and expand(2 * p.margin - even**2 - I3**2 * (P**2 - 4 * I1 * dU)) == 0


@given(I1_=moments, I3_=moments, l_=numbers, spin=numbers, u=numbers, degenerate=st.booleans(),
       boundary=st.booleans())
def test_reduction_keeps_the_truth(e1, I1_, I3_, l_, spin, u, degenerate, boundary):
    """The three conditions and the one they are reduced to hold at the same points, those with 2a + b = 0
    included.
    """
    if degenerate:
        assume(2 * I1_ != I3_)
        spin = I3_ * l_ / (2 * I1_ - I3_)
    if boundary:
        u = (spin + l_) ** 2 / (4 * I1_)
    values = {I1: R(I1_), I3: R(I3_), l: R(l_), pi3: R(spin), dU: R(u)}
    general = gs.derivation.spectral_criterion(e1.linearization)
    assert holds(general, values, {}) == holds(e1.necessary, values, {}) == (not oracle.growth(*reversed(
        oracle.vertical(I1_, I3_, l_, spin, 1, u, 0))))


def test_free_rotation(free):
    """(l + (I3 − I1) ω)(l + (I3 − I2) ω): > 0 suffices, ≥ 0 is necessary (Hughes, chapter 6).

    Both signs of the form count.
    """
    report = gs.analyze(gs.principal_rotation(free, 3))
    product = expand((l + (I3 - I1) * w3) * (l + (I3 - I2) * w3))
    assert single(report.necessary).margin == single(report.sufficient).margin == product
    plain = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    verdicts = [gs.analyze(gs.principal_rotation(plain, axis)).verdict({f"omega{axis}_0": 1}).verdict.name
                for axis in (1, 2, 3)]
    assert verdicts == ["STABLE", "UNSTABLE", "STABLE"]


def test_what_was_dropped_is_proved(e1, e2):
    """p ≥ 0 follows at E1 and E2 by the identity of the design, p = ½ (2a + b)² + ½ (b² + 4dc), up to (I1
    I3)².
    """
    for report in (e1, e2):
        (proof,) = single(report.necessary).implies
        assert proof.source == "p" and proof.by == single(report.necessary).margin
        assert expand(proof.margin - proof.square - proof.factor * proof.by) == 0
        assert proof.factor.is_positive
        assert cancel(proof.square / (I3 * P - 2 * I1 * pi3) ** 2) == Rational(1, 2)
        p = gs.derivation.spectral_criterion(report.linearization).alternatives[0][0]
        assert proof.margin == p.margin


def test_every_steady_precession_of_the_heavy_top_is_stable():
    """U = m0 k3: p is (I1 ω² − m0 k3)² + m0² (1 − k3²) up to a factor, so both criteria always hold (Lewis et
    al. 1992).
    """
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    assert report.necessary.alternatives == report.sufficient.alternatives == ((),)
    p = report.equilibrium.insert(report.linearization.coefficients[0])
    assert cancel(p * I1**2 * omega**2 - (I1 * omega**2 - m0 * k3) ** 2 - m0**2 * (1 - k3**2)) == 0


def test_the_equatorial_precession_of_the_source():
    """k3 = 0, U = m0 k3 + U1(k3): l⁴ + m0² I1² + U''(0) l² I1 ≥ 0. VV2003 §5 prints −U''(0).

    At I1 = l = m0 = 1, U'' = −3 the
    printed condition holds, and the field has a growing mode.
    """
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
    ours = single(report.necessary).margin.subs({k3: 0, omega: m0 / l})
    assert expand(ours * l**2 - l**4 - m0**2 * I1**2 - d2U * l**2 * I1) == 0
    one = Fraction(1)
    assert oracle.growth(*reversed(oracle.inclined(one, one / 2, one, one, (one, 0 * one, 0 * one),
                                                   -3 * one)))


@pytest.fixture(scope="module")
def turning(asymmetric):
    """E1 of a general body that turns about the vertical."""
    return gs.analyze(gs.upright(asymmetric, spin="omega3_0"))


def test_asymmetric_conditions(turning):
    """Energy-Casimir at E1 of a general body: a1 > 0 and a2 > 0 (Rumiantsev 1961), each by itself."""
    a1, a2 = (expand((I3 - I) * (w3**2 - m1) + l * w3 - m0) for I in (I1, I2))
    (alternative,) = turning.sufficient.alternatives
    assert {c.margin for c in alternative} == {a1, a2}
    assert turning.casimirs_only is turning.sufficient
    assert turning.boundary is None


@pytest.mark.slow
@given(inertia=st.tuples(*[moments] * 3), l_=numbers, w=numbers, a=numbers, b=numbers)
@settings(max_examples=12)
def test_asymmetric_spectrum_is_euler_poisson(turning, inertia, l_, w, a, b):
    """The three spectral conditions of a general body are violated exactly where the 6×6 field has a growing
    mode.
    """
    x = oracle.exact([0, 0, inertia[2] * w, 0, 0, 1])
    I = oracle.exact(inertia)
    growth = oracle.growth(lambda y: oracle.field(y, I, oracle.exact([0, 0, l_]),
                                                  lambda k: oracle.exact([0, 0, a]) + b * I * k), x)
    values = dict(zip((I1, I2, I3), map(R, inertia))) | {l: R(l_), w3: R(w), m0: R(a), m1: R(b)}
    assert holds(turning.necessary, values, {}) == (not growth)


@pytest.mark.slow
@pytest.mark.parametrize("U", [
    m0 * k3 + m1 * (I3 - I1) * k3**2 / 2, exp(m1 * k3) * m0,
    *slow((m0 * k3,), (k3**4 - 2 * m1 * k3**3 + k3,), (cos(k3) + m0 * k3**2,))])
def test_inserting_first_gives_the_same_margins(U):
    """Analyse then insert U, or insert U (as a general potential, at a claimed point) then analyse.

    Equal margins.
    """
    body = gs.symmetric_gyrostat()
    late, early = gs.assemble(body, gs.axial_potential(U)), gs.assemble(body, gs.general_potential(U))
    for s, make in ((1, gs.upright), (-1, gs.hanging)):
        one, two = gs.analyze(make(late)), gs.analyze(gs.equilibrium(early, (0, 0, pi3, 0, 0, s)))
        for a, b in ((one.necessary, two.necessary), (one.sufficient, two.sufficient),
                     (one.casimirs_only, two.casimirs_only)):
            assert single(a).margin == single(b).margin
    one = gs.inclined(late, eliminate="l")
    two = gs.equilibrium(early, one.point, relations=one.relations[1:], domain=one.domain)
    one, two = gs.analyze(one), gs.analyze(two)
    margins = [[[c.margin for c in a] for a in r.alternatives]
               for r in (one.necessary, two.necessary, one.sufficient, two.sufficient)]
    assert all(m == margins[0] for m in margins) and len(margins[0]) == 1


@pytest.mark.few(1)
@pytest.mark.parametrize("make", [gs.upright, gs.hanging, gs.inclined, gs.static_tilt])
def test_margins_are_homogeneous(scene, make):
    """Change kilograms and seconds: every margin and every even factor scales by a power."""
    M, T = symbols("M T", positive=True)
    report = gs.analyze(make(scene))
    criteria = (gs.derivation.spectral_criterion(report.linearization), report.necessary, report.sufficient,
                report.casimirs_only)
    for condition in (c for criterion in criteria for alternative in criterion.alternatives
                      for c in alternative):
        for expression in (condition.margin, *condition.degenerate):
            scale = {s: s * M ** NOTATION[s.name].dimension[0] * T ** NOTATION[s.name].dimension[1]
                     for s in expression.free_symbols}
            assert cancel(expression.subs(scale, simultaneous=True) / expression).free_symbols <= {M, T}


def test_margins_are_primitive_integer_polynomials(e1, e3):
    """So that equal conditions are equal objects."""
    for report in (e1, e3):
        assert Poly(single(report.necessary).margin).content() == 1


def test_even_factors_survive(e1):
    """The discriminant of E1 alone, without p, keeps its degenerate factor."""
    discriminant = gs.derivation.spectral_criterion(e1.linearization).alternatives[0][2]
    alone = independent(Criterion("spectral", ((discriminant,),)), e1.equilibrium)
    assert single(alone) == discriminant and len(discriminant.degenerate) == 1


def test_independent_is_idempotent(e1):
    """A reduced criterion is its own reduction."""
    assert independent(e1.necessary, e1.equilibrium) == e1.necessary
    assert isinstance(single(e1.necessary), Condition) and isinstance(e1.necessary, Criterion)


def test_four_coefficients_are_refused(e1):
    """λ⁸ + …, of an orbit of dimension 8, has no criterion: no coefficient is dropped in silence."""
    plane = ImmutableMatrix([[0, 1], [-gs.symbol("a"), 0]])
    wider = Linearization(e1.equilibrium, e1.linearization.basis,
                          ImmutableMatrix(diag(e1.linearization.matrix, plane, plane)))
    assert len(wider.coefficients) == 4
    for use in (gs.derivation.spectral_criterion, Linearization.eigenvalues, Linearization.frequencies):
        with pytest.raises(ScopeError, match="degree 8 in lamda, with 4 coefficients"):
            use(wider)
