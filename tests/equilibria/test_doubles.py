"""Numbers of relative equilibria as doubles: each is the one next to the exact number."""
from fractions import Fraction

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import CRootOf, Float, Integer, Rational, Symbol, pi, sqrt

import gyrostat as gs
from gyrostat.algebra.solving import real_fields
from gyrostat.equilibria.doubles import nearest

MOMENTS = Fraction(1), Fraction(5, 4), Fraction(8, 5)
ROTOR = Fraction(3, 10), Fraction(1, 5), Fraction(1, 10)


def satellite(rotor):
    """All attitudes of a gyrostat in a circular orbit."""
    body = gs.Gyrostat(MOMENTS, rotor)
    return gs.relative_equilibria(gs.assemble(body, gs.circular_orbit(2)), {})


def cross(a, b):
    """The cross product."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    """The scalar product."""
    return sum(x * y for x, y in zip(a, b))


def at_rest(rotor, rate):
    """Newton and Euler: n × (ω0² In + ω0 l) = 3 ω0² r × Ir, for unit vectors across each other."""
    I = [mpmath.mpf(x.numerator) / x.denominator for x in MOMENTS]
    l = [mpmath.mpf(x.numerator) / x.denominator for x in rotor]

    def residual(*x):
        n, r = x[:3], x[3:]
        turning = cross(n, [rate**2 * i * a + rate * b for i, a, b in zip(I, n, l)])
        torque = cross(r, [3 * rate**2 * i * a for i, a in zip(I, r)])
        return [*(a - b for a, b in zip(turning, torque)), dot(n, n) - 1, dot(r, r) - 1, dot(n, r)]

    return residual


@pytest.fixture
def unwritten(monkeypatch):
    """No number in a field may be made an expression."""
    def refused(*_):
        raise AssertionError("a number in a field was written out")

    monkeypatch.setattr(real_fields, "at_root", refused)


def test_attitudes_are_the_doubles_next_to_the_zeros_of_the_equations(unwritten):
    """Newton's method with 50 digits from each; with a rotor across no axis n and r have degree 24."""
    found = satellite(ROTOR)
    assert len(found) == 20
    for e in found[::6]:
        t, n, r = e.attitude.matrix
        with mpmath.workdps(50):
            zero = mpmath.findroot(at_rest(ROTOR, 2), [*n, *r], tol=1e-90, maxsteps=30)
            exact = list(zero)
            across = cross(exact[:3], exact[3:])
            assert [float(x) for x in exact] == [*n, *r] and [float(x) for x in across] == list(t)
        assert e.doubles.place == dict(zip(("n1", "n2", "n3", "r1", "r2", "r3"), [*n, *r]))
        assert e.doubles.rates == {"omega0": 2.0}


def test_a_table_writes_no_number_of_a_field_out(unwritten, capsys):
    """It shows four digits, for which enclosures suffice; so does a list to the terminal."""
    from commands import decide
    status, out, err = decide(capsys, "--orbit", "1", "--inertia", "1,5/4,8/5", "--gyrostatic-momentum",
                              "3/10,1/5,1/10")
    assert (status, err) == (0, "") and out.startswith("16 relative equilibria")


SCENES = {
    "a top": (gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.general_potential("k3"), {"omega": 2}),
    "every tilt": (gs.Gyrostat((3, 3, 3), (0, 0, 0)), gs.general_potential("0"), {"omega": 3}),
    "free": (gs.Gyrostat((1, 2, 3), (0, 0, "1/2")), None, {"M": 2}),
    "heavy": (gs.Gyrostat((1, 2, 3), (0, 0, "1/2")), gs.general_potential("k1 + k2"), {"omega": 2}),
    "without a rotor": (gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.circular_orbit(1), {})}


@pytest.mark.parametrize("name", SCENES)
def test_doubles_have_the_names_and_the_values_of_the_exact_numbers(name):
    """Place, rates, frequencies, growth rate; None where every value is taken."""
    body, field, numbers = SCENES[name]
    for e in gs.relative_equilibria(gs.assemble(body, *([] if field is None else [field])), numbers):
        exact = {**e.place, **e.rates}
        doubles = {**e.doubles.place, **e.doubles.rates}
        assert list(doubles) == list(exact)
        exact |= {f"frequency{n}": x for n, x in enumerate(e.frequencies)} | {"growth": e.growth_rate}
        doubles |= {f"frequency{n}": x for n, x in enumerate(e.doubles.frequencies)}
        doubles["growth"] = e.doubles.growth_rate
        for key, x in exact.items():
            assert doubles[key] == (None if x is None else float(mpmath.mpf(str(x.evalf(40)), prec=200))), key


@given(st.fractions(), st.integers(2, 99), st.integers(-40, 40))
def test_the_nearest_double_is_nearer_than_its_neighbours(a, n, power):
    """Of a + √n 10ᵖ, with integers a² = n 10²ᵖ and ties by fractions alone."""
    value = Rational(a.numerator, a.denominator) + sqrt(n) * Integer(10) ** power
    (found,) = nearest([value])
    with mpmath.workdps(400):
        root = mpmath.sqrt(n) * mpmath.mpf(10) ** power
        assert found == float(mpmath.mpf(a.numerator) / a.denominator + root)
    assert nearest([Rational(a.numerator, a.denominator)]) == (float(a),)


def test_hard_numbers():
    """Zero that is not seen to be zero, a tie, what no double can hold, digits that are given."""
    x = Symbol("x")
    root = CRootOf(x**3 - x - 1, 0)
    assert nearest([root**3 - root - 1]) == (0.0,) and str(nearest([-(root**3) + root + 1])[0]) == "0.0"
    assert nearest([Integer(2) ** 53 + 1, Integer(10) ** 400, -pi * Integer(10) ** 400]) == (
        2.0**53, float("inf"), float("-inf"))
    assert nearest([Float("0.1", 30), Rational(1, 10), None]) == (0.1, 0.1, None)
