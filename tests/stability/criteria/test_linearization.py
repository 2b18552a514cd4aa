"""The linearised field against the differenced Euler-Poisson equations and the printed matrices, exactly."""
from fractions import Fraction

import mpmath
import numpy as np
import oracle
import pytest
from draw import moments, nonzero, numbers, tilts
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import ImmutableMatrix, Matrix, Poly, Rational, cancel, expand, lambdify, simplify, sqrt

import gyrostat as gs
from gyrostat.errors import SingularOrbitError
from gyrostat.stability.criteria.linearization import LAMBDA

THREE = st.tuples(*[numbers] * 3)


def R(value):
    return Rational(Fraction(value).numerator, Fraction(value).denominator)


def S(**values):
    return {gs.symbol(name): R(value) for name, value in values.items()}


def assert_restriction(jacobian, linear, values=()):
    """J N = N A: the differenced 6×6 field maps the basis as the matrix says, entry by entry."""
    basis, matrix = (Matrix(m.subs(dict(values))) for m in (linear.basis, linear.matrix))
    assert (
        Matrix(jacobian.shape[0], jacobian.shape[1], [R(entry) for entry in jacobian.flatten()]) * basis
        == basis * matrix
    )


@pytest.mark.slow
@pytest.mark.parametrize("s", [1, -1])
@given(I1=moments, I3=moments, l=numbers, pi3=numbers, u1=numbers, u2=numbers)
@settings(max_examples=12)
def test_vertical_polynomial_is_euler_poisson(e1, e2, s, I1, I3, l, pi3, u1, u2):
    """At E1, E2 the 6×6 field has characteristic polynomial λ² (λ⁴ + p λ² + q)."""
    x, f = oracle.vertical(I1, I3, l, pi3, s, u1, u2)
    values = S(I1=I1, I3=I3, l=l, pi3_0=pi3, dU=u1)
    linear = (e1 if s == 1 else e2).linearization
    assert_restriction(oracle.jacobian(f, x), linear, values)
    p, q = (R(c.subs(values)) for c in linear.coefficients)
    assert list(map(R, oracle.characteristic(oracle.jacobian(f, x)))) == [1, 0, p, 0, q, 0, 0]


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, omega=numbers, tilt=tilts, u2=numbers)
@settings(max_examples=15)
def test_inclined_polynomial_is_euler_poisson(e3, I1, I3, l, omega, tilt, u2):
    """At E3 the 6×6 field has characteristic polynomial λ⁴ (λ² + p), at rest included."""
    x, f = oracle.inclined(I1, I3, l, omega, (tilt[0], Fraction(0), tilt[1]), u2)
    assert not any(f(x))
    p, q = e3.linearization.coefficients
    assert q == 0
    values = S(I1=I1, I3=I3, l=l, omega=omega, k3=tilt[1], d2U=u2)
    assert_restriction(oracle.jacobian(f, x), e3.linearization, values)
    p = R(p.subs(values))
    assert list(map(R, oracle.characteristic(oracle.jacobian(f, x)))) == [1, 0, p, 0, 0, 0, 0]


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, tilt=tilts, u2=numbers)
@settings(max_examples=10)
def test_static_polynomial_is_euler_poisson(at_rest, I1, I3, l, tilt, u2):
    """The body at rest at a tilt is E3 with ω = 0."""
    x, f = oracle.inclined(I1, I3, l, Fraction(0), (tilt[0], Fraction(0), tilt[1]), u2)
    values = S(I1=I1, I3=I3, l=l, k3=tilt[1], d2U=u2)
    assert_restriction(oracle.jacobian(f, x), at_rest.linearization, values)
    p = R(at_rest.linearization.coefficients[0].subs(values))
    assert list(map(R, oracle.characteristic(oracle.jacobian(f, x)))) == [1, 0, p, 0, 0, 0, 0]


def unit(a, b):
    n = a * a + b * b + 1
    return [2 * a / n, 2 * b / n, (n - 2) / n]


@pytest.mark.slow
@given(inertia=st.tuples(*[moments] * 3), rotor=THREE, a=numbers, b=numbers, w=numbers, mu=numbers,
       s=st.tuples(*[numbers] * 6))
@settings(max_examples=8)
def test_general_body_at_a_claimed_point(inertia, rotor, a, b, w, mu, s):
    """Three moments, three components of l, a quadratic U(k) with ∇U = w² I k + w l + μ k.

    The polynomial is Euler-Poisson's.
    """
    k, I, l = np.array(unit(a, b), dtype=object), oracle.exact(inertia), oracle.exact(rotor)
    H = np.array([[s[0], s[1], s[2]], [s[1], s[3], s[4]], [s[2], s[4], s[5]]], dtype=object)
    g = w**2 * I * k + w * l + mu * k - H.dot(k)
    point = np.concatenate([w * I * k, k])
    jacobian = oracle.jacobian(lambda x: oracle.field(x, I, l, lambda d: g + H.dot(d)), point)
    U = gs.general_potential(lambda *d: sum(R(c) * x for c, x in zip(g, d))
                             + sum(R(H[i, j]) * d[i] * d[j] for i in range(3) for j in range(3)) / 2)
    eq = gs.equilibrium(gs.assemble(gs.Gyrostat(inertia, rotor), U), list(map(R, point)))
    linear = gs.derivation.linearize(eq)
    assert_restriction(jacobian, linear)
    p, q = linear.coefficients
    assert list(map(R, oracle.characteristic(jacobian))) == [1, 0, p, 0, q, 0, 0]


@pytest.mark.slow
@given(inertia=st.tuples(*[moments] * 3), l=numbers, w=nonzero, axis=st.sampled_from([1, 2, 3]))
@settings(max_examples=15)
def test_free_rotation_polynomial(inertia, l, w, axis):
    """On so(3)* the 3×3 field has characteristic polynomial λ (λ² + q)."""
    rotor = [l if i == axis else 0 for i in (1, 2, 3)]
    if inertia[axis - 1] * w + l == 0:
        return
    eq = gs.principal_rotation(gs.assemble(gs.Gyrostat(inertia, rotor)), axis)
    point = oracle.exact([inertia[axis - 1] * w if i == axis else 0 for i in (1, 2, 3)])
    theirs = oracle.characteristic(
        oracle.jacobian(lambda x: oracle.free_field(x, oracle.exact(inertia), oracle.exact(rotor)), point)
    )
    (q,) = gs.derivation.linearize(eq).coefficients
    assert list(map(R, theirs)) == [1, 0, R(q.subs(gs.symbol(f"omega{axis}_0"), R(w))), 0]


def test_matrix_of_the_source(e1):
    """VV2003 §4.1.1: a = π3/I3, b = −(π3 + l)/I1, c = U'(1), d = −1/I1."""
    I1, I3, l, pi3, c = map(gs.symbol, ("I1", "I3", "l", "pi3_0", "dU"))
    a, b, d = pi3 / I3, -(pi3 + l) / I1, -1 / I1
    printed = Matrix([[0, a + b, 0, c], [-a - b, 0, -c, 0], [0, d, 0, a], [-d, 0, -a, 0]])
    assert simplify(e1.linearization.matrix - printed) == Matrix.zeros(4, 4)


def test_asymmetric_polynomial(asymmetric):
    """E1 of a general body: q = a1 a2/(I1 I2), p = [(l + (I3 − I1 − I2) w)² + I1 a1 + I2 a2]/(I1 I2)
    (Grammel; Rumiantsev 1961).
    """
    I1, I2, I3, l, m0, m1, w = map(gs.symbol, ("I1", "I2", "I3", "l", "m0", "m1", "omega3_0"))
    a1, a2 = ((I3 - I) * (w**2 - m1) + l * w - m0 for I in (I1, I2))
    p, q = gs.derivation.linearize(gs.upright(asymmetric, spin="omega3_0")).coefficients
    assert cancel(q - a1 * a2 / (I1 * I2)) == 0
    assert cancel(p - ((l + (I3 - I1 - I2) * w) ** 2 + I1 * a1 + I2 * a2) / (I1 * I2)) == 0


@pytest.mark.parametrize("make", [gs.upright, gs.hanging, gs.inclined, gs.static_tilt])
def test_linearisation_is_bracket_of_the_second_variation(scene, make):
    """J = B · D²(h + ν·C): the left side differentiates the field, the right side the energy."""
    eq = make(scene)
    tensor = eq.at_point(scene.space.tensor)
    right = tensor * gs.derivation.augmented_hessian(eq, scene.space.casimirs)
    assert (eq.at_point(scene.jet_jacobian) - right).applyfunc(simplify) == Matrix.zeros(6, 6)


def test_tangent_space_is_the_kernel_of_the_casimirs(scene):
    """δπ·k + M·δk = 0 and δk·k = 0 for every basis vector of T."""
    for make in (gs.upright, gs.hanging, gs.inclined, gs.static_tilt):
        eq = make(scene)
        basis = gs.derivation.orbit_tangent(eq)
        assert basis.shape == (6, 4) and basis.subs({gs.symbol("k3"): Rational(3, 5)}).rank() == 4
        M = Matrix(eq.point[:3]) + Matrix(scene.body.gyrostatic_momentum)
        k = Matrix(eq.point[3:])
        for j in range(4):
            column = Matrix(basis.col(j))
            assert expand(column[:3, 0].dot(k) + M.dot(column[3:, 0])) == 0
            assert expand(column[3:, 0].dot(k)) == 0


def test_characteristic_polynomial_is_that_of_the_matrix(e1, e3, free):
    """The coefficients come from traces; SymPy's determinant agrees at numbers."""
    values = S(I1=2, I3="3/5", l="1/3", pi3_0="-7/4", dU="5/2", omega="2/3", k3="3/5", d2U="-1/7", I2="9/4",
               omega3_0="5/6")
    turning = gs.principal_rotation(free, 3)
    for linear in (e1.linearization, e3.linearization, gs.derivation.linearize(turning)):
        matrix = Matrix(linear.matrix.subs(values))
        theirs = (LAMBDA * Matrix.eye(matrix.rows) - matrix).det()
        assert expand(linear.characteristic_polynomial().subs(values) - theirs) == 0


def test_factors_multiply_to_the_polynomial(e1, e3):
    """At E3 λ² splits off; the factors give the polynomial back up to a factor without λ."""
    assert (LAMBDA, 2) in e3.linearization.factors()
    for linear in (e1.linearization, e3.linearization):
        product = 1
        for factor, n in linear.factors():
            product *= factor**n
        ours = Poly(linear.characteristic_polynomial(), LAMBDA)
        assert simplify(Poly(expand(product), LAMBDA).monic().as_expr() - ours.as_expr()) == 0


@pytest.mark.parametrize("report", ["e1", "e2", "e3", "at_rest"])
def test_eigenvalues_are_the_roots(report, request):
    """The closed forms are the eigenvalues that NumPy finds for the matrix."""
    linear = request.getfixturevalue(report).linearization
    values = {"I1": 2.0, "I3": 0.6, "l": 0.3, "pi3_0": -1.7, "dU": 0.4, "omega": 0.7, "k3": 0.6, "d2U": 0.9}
    names = [gs.symbol(n) for n in values]
    ours = [complex(lambdify(names, root, "mpmath")(*map(mpmath.mpf, values.values())))
            for root in linear.eigenvalues()]
    exact = {gs.symbol(n): Rational(str(v)) for n, v in values.items()}
    theirs = np.linalg.eigvals(np.array(linear.matrix.subs(exact).evalf(30).tolist(), dtype=float))
    # float64 reference; the double zero of E3 is defective, its error is the root of the rounding error
    np.testing.assert_allclose(*(sorted(z, key=lambda z: (round(z.imag, 5), z.real))
                                 for z in (ours, theirs)), atol=1e-7)


@pytest.mark.slow
def test_eigenvalues_where_roots_nest(asymmetric, free):
    """An asymmetric body in a field, and a free one.

    Each closed form is a root, and together they are all (30 digits).
    """
    numbers = S(I1=2, I2="7/5", I3="3/2", l="1/3", omega3_0="5/6", m0="2/7", m1="-1/9")
    for eq in (gs.upright(asymmetric, spin="omega3_0"), gs.principal_rotation(free, 3)):
        linear = gs.derivation.linearize(eq)
        roots = [root.subs(numbers) for root in linear.eigenvalues()]
        polynomial = expand(eq.insert(linear.characteristic_polynomial()).subs(numbers))
        product = 1
        for root in roots:
            product *= LAMBDA - eq.insert(root).subs(numbers)
        assert all(abs(c) < Rational(1, 10**25) for c in Poly(expand(product - polynomial).evalf(30),
                                                              LAMBDA).all_coeffs())


@pytest.mark.slow
def test_sleeping_top_eigenvalues(e1):
    """λ = ±i [ω3 − P/(2 I1) ± √(P² − 4 I1 U1)/(2 I1)], classical."""
    I1, I3, l, pi3, u = map(gs.symbol, ("I1", "I3", "l", "pi3_0", "dU"))
    P = pi3 + l
    for root in e1.linearization.eigenvalues():
        x = expand(root**2)
        assert any(simplify(x + (pi3 / I3 - P / (2 * I1) + s * sqrt(P**2 - 4 * I1 * u) / (2 * I1)) ** 2) == 0
                   for s in (1, -1))


def test_singular_orbits_are_refused(scene):
    """k = 0 is an equilibrium of the bracket on an orbit of lower dimension: an error, with the reason."""
    eq = gs.equilibrium(scene, (0, 0, gs.symbol("p"), 0, 0, 0), label="E0")
    for verb in (gs.derivation.linearize, gs.derivation.second_variation, gs.derivation.orbit_tangent,
                 gs.derivation.symplectic_slice):
        with pytest.raises(SingularOrbitError, match="E0 lies on .*: the differentials of .* rank 1, not 2"):
            verb(eq)
    free = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 2)))
    with pytest.raises(SingularOrbitError, match="M ≠ 0"):
        gs.derivation.linearize(gs.equilibrium(free, (0, 0, -2)))


def test_given_potentials_are_inserted_on_demand():
    """The matrix keeps dU; equilibrium.insert puts U'(1)."""
    eq = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.newtonian_field(2)))
    m0, m1, I1, I3 = map(gs.symbol, ("m0", "m1", "I1", "I3"))
    entry = eq.insert(gs.derivation.linearize(eq).matrix)[0, 3]
    assert isinstance(eq.insert(gs.derivation.linearize(eq).matrix), ImmutableMatrix)
    assert expand(entry - m0 + m1 * (I1 - I3)) == 0
