"""The named fields against the attraction of point masses, Kirchhoff's equations and formulas derived by
hand.
"""
from fractions import Fraction

import numpy as np
import oracle
import pytest
from draw import moments, nonzero, numbers, tilts
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import Integer, Rational, Symbol, cancel, diff, expand, symbols

import gyrostat as gs
from gyrostat.notation import NOTATION
from gyrostat.printing.formats.article import to_latex

k3, m0, m1, I1, I3, l, pi3, r, p0 = map(gs.symbol, ("k3", "m0", "m1", "I1", "I3", "l", "pi3_0", "r", "p0"))
J3, J4, mass1, mass3 = map(gs.symbol, ("J3", "J4", "mass1", "mass3"))
FIELDS = [gs.uniform_field(), gs.newtonian_field(2), gs.newtonian_field(4), gs.ideal_fluid()]


def exact(values):
    """Names to SymPy rationals."""
    return {gs.symbol(name): Rational(v.numerator, v.denominator) for name, v in values.items()}


def margin(field, make):
    """The one margin of the sufficient condition of a family."""
    ((condition,),) = gs.analyze(make(gs.assemble(gs.symmetric_gyrostat(), field))).sufficient.alternatives
    assert condition.strict and condition.degenerate == ()
    return condition.margin


def test_orders_one_and_two():
    """U⁽¹⁾ and U⁽²⁾ of Vera & Viguera (2003), §3; m1 has the sign that VV2003 gives it."""
    assert gs.uniform_field() == gs.newtonian_field(1) == gs.axial_potential(m0 * k3)
    assert gs.newtonian_field(2).expression == m0 * k3 + m1 / 2 * (I3 - I1) * k3**2
    assert not gs.uniform_field().revolution and gs.newtonian_field(2).revolution


def inverse_distance(c, d, order):
    """Taylor coefficients in e, to the order given, of (1 + 2 c e + d e²)^(−½), by the binomial series."""
    total, power, binomial = [Fraction(0)] * (order + 1), [Fraction(1)] + [Fraction(0)] * order, Fraction(1)
    for n in range(order + 1):
        total = [a + binomial * b for a, b in zip(total, power)]
        power = [(2 * c * power[i - 1] if i >= 1 else 0) + (d * power[i - 2] if i >= 2 else 0)
                 for i in range(order + 1)]
        binomial *= (Fraction(-1, 2) - n) / (n + 1)
    return total


# a hexagon of equal masses in the plane x3 = height: the cosines of its corners, which are alike about axis 3
# to order 5
HEXAGON = [Fraction(c, 2) for c in (2, 1, -1, -2, -1, 1)]
rings = st.lists(st.tuples(moments, moments, numbers), min_size=1, max_size=3)


@pytest.mark.slow
@given(rings=rings, g=moments, distance=moments, k=tilts)
@settings(max_examples=15)
def test_each_order_is_a_term_of_the_attraction(rings, g, distance, k):
    """−G M ∫ dm/abs(x − X), X = −r k, G M = g r², of hexagons about axis 3.

    Its terms in 1/r are U⁽ⁿ⁾ − U⁽ⁿ⁻¹⁾ for n = 1, …, 5.
    """
    masses = [(m, a, a * c, z) for m, a, z in rings for c in HEXAGON]

    def terms(k1, k3):                                 # x·k needs no x2 where k2 = 0
        rows = [inverse_distance(x * k1 + z * k3, a * a + z * z, 5) for _, a, x, z in masses]
        return [-g * distance * sum(m * row[n] for (m, *_), row in zip(masses, rows)) / distance**n
                for n in range(6)]

    total = lambda f: sum(m * f(a * a, z) for m, a, _, z in masses)  # noqa: E731
    values = exact({
        "m0": g * total(lambda s, z: z), "m1": 3 * g / distance, "r": distance,
        "I1": total(lambda s, z: s / 2 + z * z), "I3": total(lambda s, z: s),
        "J3": total(lambda s, z: z**3 - 3 * z * s / 2),
        "J4": total(lambda s, z: z**4 - 3 * z**2 * s + 3 * s**2 / 8),
        "J5": total(lambda s, z: z**5 - 5 * z**3 * s + 15 * z * s**2 / 8)})
    U = [Integer(0), *(gs.newtonian_field(n).expression.xreplace(values) for n in range(1, 6))]
    for n, (theirs, level) in enumerate(zip(terms(*k), terms(Fraction(1), Fraction(0)))):
        if n:
            ours = (U[n] - U[n - 1]).xreplace(exact({"k3": k[1]}))
            assert ours == exact({"term": theirs - level})[gs.symbol("term")], n


@pytest.mark.parametrize("n", [2, 3, 4, 7, 10])
def test_orders_differ_by_one_legendre_term(n):
    """y = U⁽ⁿ⁾ − U⁽ⁿ⁻¹⁾ + const solves Legendre's equation ((1 − k3²) y')' + n (n + 1) y = 0.

    Its slope y'(1) is aₙ n (n + 1)/2; U = 0 at k3 = 0.
    """
    y = gs.newtonian_field(n).expression - gs.newtonian_field(n - 1).expression
    constant = expand(diff((1 - k3**2) * diff(y, k3), k3) + n * (n + 1) * y)
    assert k3 not in constant.free_symbols and y.subs(k3, 0) == 0 and expand(y) != 0
    if n > 2:
        coefficient = (-1) ** (n + 1) * m1 / 3 * gs.symbol(f"J{n}") / r ** (n - 2)
        assert expand(diff(y, k3).subs(k3, 1) - coefficient * n * (n + 1) / 2) == 0


def test_higher_orders_have_their_parameters():
    """r and J3, …, JN; those of ten and more are real parameters too."""
    assert [str(s) for s in gs.newtonian_field(4).parameters] == ["I1", "I3", "J3", "J4", "m0", "m1", "r"]
    assert "J11" in map(str, gs.newtonian_field(11).parameters)
    assert gs.newtonian_field(Integer(3)) == gs.newtonian_field(np.int64(3)) == gs.newtonian_field(3)


@pytest.mark.parametrize("order", [0, -1, True, 2.0, 2.5, Rational(5, 2), "2", None, Symbol("n")])
def test_orders_are_positive_integers(order):
    """What counts no terms is refused, with what was given and what to give."""
    with pytest.raises(ValueError, match=rf"no order {order!r}: .*give 1, 2, 3") as refused:
        gs.newtonian_field(order)
    assert isinstance(refused.value, gs.errors.GyrostatError)


@pytest.mark.parametrize("field", FIELDS[1:])
def test_fields_of_revolution_refuse_other_bodies(field):
    """Written for I1 = I2: the general body is refused, not silently given a wrong field."""
    with pytest.raises(NotImplementedError, match="I1 = I2"):
        gs.assemble(gs.Gyrostat(), field)


@pytest.fixture(scope="module")
def in_fluid():
    """The vector field of a body of revolution in a fluid."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.ideal_fluid()).vector_field()


@pytest.mark.slow
@given(I1_=moments, I3_=moments, l_=numbers, p=moments, across=moments, along=moments,
       pi=st.tuples(numbers, numbers, numbers),
       s=numbers, t=numbers)
@settings(max_examples=15)
def test_kirchhoff(in_fluid, I1_, I3_, l_, p, across, along, pi, s, t):
    """Π̇ = Π × Ω + p × V, ṗ = p × Ω with Ω = J⁻¹(Π − l), V = M⁻¹ p, p = p0 k: the same Π̇ and k̇."""
    k = oracle.exact([2 * s / (1 + s * s + t * t), 2 * t / (1 + s * s + t * t),
                      (s * s + t * t - 1) / (1 + s * s + t * t)])
    assert k.dot(k) == 1
    Omega, V = oracle.exact(pi) / oracle.exact([I1_, I1_, I3_]), p * k / oracle.exact([across, across, along])
    Pi = oracle.exact(pi) + oracle.exact([0, 0, l_])
    theirs = [*(np.cross(Pi, Omega) + np.cross(p * k, V)), *(np.cross(p * k, Omega) / p)]
    values = exact({"I1": I1_, "I3": I3_, "l": l_, "p0": p, "mass1": across, "mass3": along})
    values |= exact({f"pi{i}": x for i, x in enumerate(pi, 1)} | {f"k{i}": x for i, x in enumerate(k, 1)})
    ours = in_fluid.xreplace(values)
    assert [Fraction(int(x.p), int(x.q)) for x in ours] == theirs


def test_upright_and_hanging_in_a_fluid():
    """(Π3 + l)² > 4 I1 p0² (1/mass3 − 1/mass1) at E1 and at E2.

    A prolate body, mass1 > mass3, has to spin.
    """
    for make in (gs.upright, gs.hanging):
        assert margin(gs.ideal_fluid(), make) == expand(mass1 * mass3 * (pi3 + l) ** 2 - 4 * I1 * p0**2
                                                        * (mass1 - mass3))
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.ideal_fluid())))
    at = {"I1": 1, "l": 0, "p0": 1, "mass3": 1, "pi3_0": 1}
    assert report.verdict(at | {"mass1": "4/5"}).verdict is gs.Verdict.STABLE
    assert report.verdict(at | {"mass1": 2}).verdict is gs.Verdict.UNSTABLE
    assert report.verdict(at | {"mass1": 2, "pi3_0": "3/2"}).verdict is gs.Verdict.STABLE
    for name in ("p0", "mass1", "mass3"):
        with pytest.raises(ValueError, match=f"{name} .* must be positive"):
            report.verdict(at | {"mass1": 2} | {name: 0})


@pytest.mark.parametrize(("make", "s"), [(gs.upright, 1), (gs.hanging, -1)])
def test_upright_and_hanging_in_newtonian_fields(make, s):
    """P² > ± 4 I1 U'(±1), Pₙ'(±1) = (±1)ⁿ⁺¹ n (n + 1)/2.

    Slopes 1, 3, 6, 10 of the terms m0, −(m1/3) J2, (m1/3) J3/r, −(m1/3) J4/r².
    """
    square, slope = (pi3 + l) ** 2, s * m0 - m1 * (I1 - I3)
    assert margin(gs.newtonian_field(1), make) == expand(square - 4 * I1 * s * m0)
    assert margin(gs.newtonian_field(2), make) == expand(square - 4 * I1 * slope)
    assert margin(gs.newtonian_field(3), make) == expand(r * square - 4 * I1 * (r * slope + s * 2 * m1 * J3))
    fourth = 3 * r**2 * square - 4 * I1 * (3 * r**2 * slope + s * 6 * r * m1 * J3 - 10 * m1 * J4)
    assert margin(gs.newtonian_field(4), make) == expand(fourth)


@pytest.fixture(scope="module")
def inclined():
    """Margins of E3 in U⁽³⁾ and in a fluid, l eliminated."""
    return margin(gs.newtonian_field(3), gs.inclined), margin(gs.ideal_fluid(), gs.inclined)


@pytest.mark.slow
@given(I1_=moments, I3_=moments, omega=nonzero, k=tilts, a=numbers, b=numbers, c=numbers, d=moments,
       in_fluid=st.booleans())
def test_inclined_in_named_fields(inclined, I1_, I3_, omega, k, a, b, c, d, in_fluid):
    """The margin of E3 in U⁽³⁾ and in a fluid is that of the reduced motion about its double root, times a
    square.
    """
    z = k[1]
    if in_fluid:
        assume(a != 0)
        curvature, values = a * a * (1 / d - 1
                                     / (abs(b) + 1)), {"p0": abs(a), "mass1": abs(b) + 1, "mass3": d}
        slope, square = curvature * z, ((abs(b) + 1) * d * omega) ** 2
    else:
        slope = a + b * (I3_ - I1_) * z + b * c / (3 * d) * (15 * z * z - 3) / 2
        curvature, values = b * (I3_ - I1_) + b * c / (3 * d) * 15 * z, {"m0": a, "m1": b, "J3": c, "r": d}
        square = (2 * d * omega) ** 2
    l_ = (slope + omega**2 * z * (I1_ - I3_)) / omega
    ours = inclined[in_fluid].xreplace(exact(values | {"I1": I1_, "I3": I3_, "omega": omega, "k3": z}))
    assert Fraction(int(ours.p), int(ours.q)) == square * oracle.verdict_inclined_margin(
        I1_, I3_, l_, omega, z, curvature
    )


@pytest.mark.few(1)
@pytest.mark.parametrize(("field", "make"), [
    (gs.ideal_fluid(), gs.upright), (gs.ideal_fluid(), gs.static_tilt), (gs.newtonian_field(4), gs.hanging),
    (gs.newtonian_field(4), gs.static_tilt),
    *slow((gs.ideal_fluid(), gs.hanging), (gs.ideal_fluid(), gs.inclined),
          (gs.newtonian_field(4), gs.upright), (gs.newtonian_field(4), gs.inclined))])
def test_margins_are_homogeneous_in_mass_time_and_length(field, make):
    """Change kilograms, seconds and metres: U and every margin and even factor scale by a power of each."""
    M, T, L = symbols("M T L", positive=True)

    def scale(name):
        (a, b), c = NOTATION[name].dimension, NOTATION[name].length
        return (M * L**2) ** a * T**b * L**c

    def factor(expression):
        return cancel(expression.subs({s: s * scale(s.name) for s in expression.free_symbols},
                                      simultaneous=True) / expression)

    assert factor(field.expression) == M * L**2 * T**2
    report = gs.analyze(make(gs.assemble(gs.symmetric_gyrostat(), field)))
    criteria = (gs.derivation.spectral_criterion(report.linearization), report.necessary, report.sufficient,
                report.casimirs_only)
    conditions = [c for criterion in criteria for alternative in criterion.alternatives for c in alternative]
    assert conditions
    for expression in (e for c in conditions for e in (c.margin, *c.degenerate)):
        assert factor(expression).free_symbols <= {M, T, L}


def test_named_fields_are_typeset():
    """As the sources write them; the masses of a fluid are not the m1 of the Newtonian field."""
    assert str(gs.newtonian_field(3)) == "U = m₀ k₃ + m₁ J₃ (5 k₃³ − 3 k₃)/(6 r) + m₁ k₃² (I₃ − I₁)/2"
    assert to_latex(gs.newtonian_field(3)) == (r"U = m_0 k_3 + \frac{m_1 J_3 \left(5 k_3^{3} - 3 "
                                               r"k_3\right)}{6 r}"
                                               r" + \frac{m_1 k_3^{2} \left(I_3 - I_1\right)}{2}")
    assert str(gs.ideal_fluid()) == "U = p₀² k₃² (1/mass₃ − 1/mass₁)/2"
    assert (
        to_latex(gs.ideal_fluid())
        == r"U = \frac{p_0^{2} k_3^{2} \left(\frac{1}{\bar{m}_3} - \frac{1}{\bar{m}_1}\right)}{2}"
    )
