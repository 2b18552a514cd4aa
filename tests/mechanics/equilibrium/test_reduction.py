"""The motion of k3 by itself.

The function g is compared with the Euler-Poisson field, its expansion with polynomial arithmetic.
"""
from fractions import Fraction
from math import factorial

import oracle
import pytest
from draw import moments, numbers, tilts
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational, S, cancel, cos, sin, sqrt

import gyrostat as gs
from gyrostat.errors import ArgumentError, ScopeError
from gyrostat.mechanics.classical import lagrangian as lagrange
from gyrostat.mechanics.equilibrium.reduced_series import expansion
from gyrostat.mechanics.equilibrium.reduction import reduce
from gyrostat.notation import jet_name
from gyrostat.stability.criteria.linearization import linearize

ORDER = 8
k3, energy, p_phi, p_psi, omega = map(gs.symbol, ("k3", "energy", "p_phi", "p_psi", "omega"))
POLYNOMIAL = sum(gs.symbol(f"a{n}") * k3**n for n in range(1, 7))
potentials = st.lists(numbers, min_size=6, max_size=6)
directions = st.tuples(numbers, numbers).map(lambda a: [2 * a[0] / (1 + a[0] ** 2 + a[1] ** 2),
                                                        2 * a[1] / (1 + a[0] ** 2 + a[1] ** 2),
                                                        (1 - a[0] ** 2 - a[1] ** 2)
                                                        / (1 + a[0] ** 2 + a[1] ** 2)])


def at(expression, **numbers):
    """The expression at numbers, as a Fraction."""
    value = expression.xreplace({gs.symbol(name): Rational(x.numerator, x.denominator)
                                 for name, x in numbers.items()})
    return Fraction(int(value.p), int(value.q))


def derivative(potential, n, z):
    """U^(n)(z) of U = a1 z + a2 z² + …"""
    return sum(a * Fraction(factorial(i), factorial(i - n)) * z ** (i - n)
               for i, a in enumerate(potential, 1) if i >= n)


@pytest.fixture(scope="module")
def polynomial():
    """Gyrostat of revolution in U = a1 k3 + … + a6 k3⁶."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(POLYNOMIAL))


@pytest.fixture(scope="module")
def families(scene):
    """E1, E2, E3 and E3 at rest in an unspecified U, with their expansions."""
    made = {"E1": gs.upright(scene), "E2": gs.hanging(scene), "E3": gs.inclined(scene),
            "rest": gs.static_tilt(scene)}
    return {name: (eq, expansion(eq, ORDER)) for name, eq in made.items()}


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, pi=st.tuples(numbers, numbers, numbers), k=directions,
       potential=potentials)
@settings(max_examples=12)
def test_g_is_the_square_of_the_rate(polynomial, I1, I3, l, pi, k, potential):
    """I1² k̇3² = g(k3) along the Euler-Poisson field, at any point with abs(k) = 1, on the levels of that
    point.
    """
    x = oracle.exact([*pi, *k])
    slope = lambda k: oracle.exact([0, 0, derivative(potential, 1, k[2])])  # noqa: E731
    rate = oracle.field(x, oracle.exact([I1, I1, I3]), oracle.exact([0, 0, l]), slope)[5]
    h = sum(p * p / (2 * moment) for p, moment in zip(pi, (I1, I1, I3))) + derivative(potential, 0, k[2])
    levels = {"energy": h, "p_phi": x[:3].dot(x[3:]) + l * k[2], "p_psi": pi[2] + l, "k3": k[2]}
    values = {"I1": I1, "I3": I3, "l": l} | {f"a{n}": a for n, a in enumerate(potential, 1)} | levels
    assert at(reduce(polynomial).square(), **values) == (I1 * rate) ** 2
    assert at(reduce(polynomial).square(POLYNOMIAL), **values) == (I1 * rate) ** 2


def test_a_potential_may_be_put_in_place_of_another(scene, polynomial):
    """square(U) of the unspecified scene is square() of the scene with U; a U that is 0 is no missing U."""
    assert reduce(scene).square(POLYNOMIAL) == reduce(polynomial).square()
    free = reduce(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(0))).square()
    assert reduce(polynomial).square(S.Zero) == free


def test_moments_and_rotor_may_be_numbers():
    """I = (2, 2, 5), l = 3, U = 7 k3²."""
    motion = reduce(gs.assemble(gs.Gyrostat((2, 2, 5), (0, 0, 3)), gs.axial_potential(7 * k3**2)))
    expected = 4 * (energy - (p_psi - 3) ** 2 / 10 - 7 * k3**2) * (1 - k3**2) - (p_phi - p_psi * k3) ** 2
    assert cancel(motion.square() - expected) == 0


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, pi3=numbers, u1=numbers)
@settings(max_examples=12)
def test_the_second_coefficient_at_a_pole_is_the_discriminant(families, I1, I3, l, pi3, u1):
    """p² − 4q = −4 (π3/I3 − P/(2 I1))² c0/I1², p and q of the 6×6 Euler-Poisson field.

    c0 = −margin of the reports.
    """
    for name, s in (("E1", 1), ("E2", -1)):
        x, f = oracle.vertical(I1, I3, l, pi3, s, u1, Fraction(1))
        _, _, p, _, q, *_ = oracle.characteristic(oracle.jacobian(f, x))
        eq, coefficients = families[name]
        c0 = at(coefficients[2], I1=I1, l=l, pi3_0=pi3, dU=u1)
        assert p * p - 4 * q == -4 * (pi3 / I3 - (pi3 + l) / (2 * I1)) ** 2 * c0 / I1**2


@given(I1=moments, I3=moments, l=numbers, omega=numbers, tilt=tilts, u2=numbers)
@settings(max_examples=12)
def test_the_second_coefficient_at_a_tilt_is_the_spectrum(families, I1, I3, l, omega, tilt, u2):
    """det(λ − J) = λ⁶ + (p/I1²) λ⁴ and g'' = −2 p."""
    x, f = oracle.inclined(I1, I3, l, omega, (tilt[0], 0, tilt[1]), u2)
    polynomial = oracle.characteristic(oracle.jacobian(f, x))
    coefficient = at(families["E3"][1][2], I1=I1, I3=I3, l=l, omega=omega, k3=tilt[1], d2U=u2)
    assert polynomial == [1, 0, -coefficient / I1**2, 0, 0, 0, 0]


def test_the_second_coefficient_is_the_margin(e1, e2, e3, at_rest):
    """−c of x² is the margin of both criteria."""
    for report in (e1, e2, e3, at_rest):
        margins = [c.margin for criterion in (report.necessary, report.sufficient)
                   for a in criterion.alternatives for c in a]
        ratio = [cancel(expansion(report.equilibrium, 2)[2] / margin) for margin in margins]
        assert len(ratio) == 2 and set(ratio) <= {-1, -gs.symbol("I1")}


def test_g_begins_with_the_square(families):
    """An equilibrium is a double root of g.

    On the family, with the relation on U' inserted, nothing is left below x².
    """
    for _, coefficients in families.values():
        assert coefficients[:2] == [0, 0] and len(coefficients) == ORDER + 1 and all(coefficients[2:])


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, spin=numbers, tilt=tilts, potential=potentials)
@settings(max_examples=8)
def test_expansion_is_that_of_the_polynomial(families, I1, I3, l, spin, tilt, potential):
    """At vectors π, k of each family, g as a polynomial in Fractions, expanded about k3.

    The coefficients to x⁸.
    """
    k1, z = tilt
    U = [Fraction(0), *potential]
    balance = spin * l - spin**2 * z * (I1 - I3) - derivative(potential, 1, z)
    # U' is what each tilted family asks for
    lean, still = [0, balance], [0, -derivative(potential, 1, z)]
    for name, x, sigma, more in (("E1", [0, 0, spin, 0, 0, 1], -1, []), ("E2", [0, 0, spin, 0, 0, -1], 1, []),
                                 ("E3", [I1 * spin * k1, 0, I3 * spin * z, k1, 0, z], 1, lean),
                                 ("rest", [0, 0, 0, k1, 0, z], 1, still)):
        x = oracle.exact(x)
        field = [a + (more[n] if n < len(more) else 0) for n, a in enumerate(U)]
        g = oracle.expand(oracle.reduced_motion(I1, *oracle.axial_integrals(x, I1, l, field), field), x[5],
                          sigma)
        jets = {jet_name(n): derivative(field[1:], n, x[5]) for n in range(1, ORDER + 1)}
        values = {"I1": I1, "I3": I3, "l": l, "pi3_0": spin, "omega": spin, "k3": z} | jets
        assert [at(c, **values) for c in families[name][1]] == g + [0] * (ORDER + 1 - len(g))


def test_to_insert_U_first_or_last_is_the_same(polynomial, families):
    """The expansion in U = a1 k3 + … + a6 k3⁶, and that of an unspecified U with its derivatives inserted."""
    made = {"E1": gs.upright(polynomial), "E2": gs.hanging(polynomial), "E3": gs.inclined(polynomial),
            "rest": gs.static_tilt(polynomial)}
    for name, eq in made.items():
        jets = {gs.symbol(jet_name(n)): POLYNOMIAL.diff(k3, n).subs(k3, eq.at) for n in range(1, ORDER + 1)}
        relations = {name: value for name, value in eq.relations if name in map(gs.symbol, ("l", "a1"))}
        for first, plain in zip(expansion(eq, ORDER), families[name][1]):
            assert cancel(eq.insert(first) - plain.subs(jets).subs(relations)) == 0


def test_expansion_at_a_turned_point():
    """k = (2, 3, 6)/7: the spin about the axis does not change g."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    k, slope = [Rational(n, 7) for n in (2, 3, 6)], dict(gs.inclined(scene).relations)[gs.symbol("dU")]
    I1, I3 = gs.symbol("I1"), gs.symbol("I3")
    point = [I1 * omega * k[0], I1 * omega * k[1], I3 * omega * k[2], *k]
    eq = gs.equilibrium(scene, point, relations=(("dU", slope.subs(k3, k[2])),))
    ours, theirs = expansion(eq, 6), expansion(gs.inclined(scene), 6)
    assert ours[2] != 0 and all(cancel(a - b.subs(k3, k[2])) == 0 for a, b in zip(ours, theirs))


def test_effective_potential_is_that_of_the_lagrangian(scene, polynomial):
    """V(cos θ) of the bracket is V(θ) of the Lagrangian, and g = 2 I1 (1 − k3²) (energy − V)."""
    c = gs.symbol("c")
    for s in (scene, polynomial, gs.assemble(gs.Gyrostat((2, 2, 5), (0, 0, 3)), gs.uniform_field())):
        motion = reduce(s)
        V, theirs = motion.effective_potential(), lagrange.effective_potential(s.body, s.potential)
        theta = gs.symbol("theta")
        theirs = theirs.subs(cos(theta), c).subs(sin(theta), sqrt(1 - c**2))
        assert cancel(V.subs(k3, c) - theirs) == 0
        assert cancel(motion.square() - 2 * s.body.inertia[0] * (1 - k3**2) * (energy - V)) == 0


def test_critical_points_are_the_precessions(polynomial):
    """V' = 0 ⇔ U' − P W + I1 k3 W² = 0, W = (v − P k3)/(I1 (1 − k3²)) the rate about the vertical."""
    motion = reduce(polynomial)
    W = (p_phi - p_psi * k3) / (gs.symbol("I1") * (1 - k3**2))
    slope = motion.precession().subs(gs.symbol("dU"), POLYNOMIAL.diff(k3)).subs(omega, W)
    assert cancel(motion.effective_potential().diff(k3) - slope) == 0


@given(I1=moments, I3=moments, l=numbers, rate=numbers.filter(bool), tilt=tilts, u1=numbers, more=numbers)
@settings(max_examples=12)
def test_precessions_turn_about_both_axes(scene, I1, I3, l, rate, tilt, u1, more):
    """ω = W k + σ e3: the Euler-Poisson field is −σ times the rotation about axis 3 exactly where
    precession() = 0.
    """
    k1, z = tilt
    P = (u1 + I1 * z * rate**2) / rate
    relation = reduce(scene).precession()
    for total in (P, P + more):
        sigma = (total - l) / I3 - rate * z
        x = oracle.exact([I1 * rate * k1, 0, I3 * (rate * z + sigma), k1, 0, z])
        xdot = oracle.field(x, oracle.exact([I1, I1, I3]), oracle.exact([0, 0, l]),
                            oracle.axial_slope(u1, Fraction(0), z))
        turned = oracle.exact([-x[1], x[0], 0, -x[4], x[3], 0])
        zero = at(relation, I1=I1, k3=z, omega=rate, p_psi=total, dU=u1) == 0
        assert zero == (total == P) == all(xdot == -sigma * turned)


def test_only_a_body_of_revolution_in_an_axial_field_is_reduced(asymmetric, free, scene):
    """Three moments, U(k1, k2, k3), no field, an l off the axis: refused, with what was given."""
    general = gs.assemble(gs.symmetric_gyrostat(), gs.general_potential())
    tilted = gs.assemble(gs.Gyrostat((1, 1, 2), (1, 0, 3)), gs.axial_potential())
    for refused in (asymmetric, general, free, tilted):
        with pytest.raises(ScopeError, match="k3 moves by itself only for a body of revolution"):
            reduce(refused)
    with pytest.raises(ScopeError, match="revolution"):
        expansion(gs.upright(asymmetric), 3)
    with pytest.raises(ArgumentError, match="is an? .*, not a"):
        reduce(gs.upright(scene))


def test_the_field_is_linearised_the_same(scene):
    """The coefficients of linearize are those of the expansion: c2 = −c/I1² at a tilt."""
    eq = gs.inclined(scene)
    assert (
        cancel(
            linearize(eq).coefficients[0].subs(dict(eq.relations))
            + expansion(eq, 2)[2] / gs.symbol("I1") ** 2
        )
        == 0
    )
