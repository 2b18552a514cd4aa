"""D4 as a rational function of names: at numbers that of a normal form, and of another algorithm."""
import json
import random
from math import prod

import pytest
from commands import run
from normal_form import energy, rational, twists
from slow import sampled
from sympy import Poly, Rational, Symbol, cancel, sign, sqrt
from window_families import FAMILIES, I1, I2, I3, l, m0

import gyrostat as gs


def drawn(report, rng):
    """Numbers of every name at which the equilibrium oscillates without a resonance to order 4."""
    while True:
        values = {name: Rational(rng.randint(1 if name.startswith("I") else -12, 12), rng.randint(1, 4))
                  for name in report.required}
        try:
            return values, report.normal_form(values)
        except gs.errors.ScopeError:
            pass


def known(window, values):
    """D4 and the others with numbers in the place of names."""
    numbers = {gs.symbol(name): x for name, x in values.items()}
    return [x.xreplace(numbers) for x in (window.D4, window.margin, window.p, window.q)]


@pytest.mark.few(1)
@pytest.mark.parametrize("family", FAMILIES)
def test_at_numbers_it_is_that_of_the_normal_form(family, full):
    """Its margin has its sign, p and q are those of the eigenvalues."""
    rng = random.Random(family)
    report = gs.analyze(FAMILIES[family]())
    window = report.window()
    for _ in range(sampled(60, full, 4)):
        values, form = drawn(report, rng)
        D4, margin, p, q = known(window, values)
        assert D4 == form.twists[0]
        assert sign(margin) == sign(D4)
        w1, w2 = (omega**2 for omega in form.frequencies)
        assert (w1 + w2 - p).expand() == 0 and ((w1 * w2).expand() - q).expand() == 0
        for m, n, resonance in window.resonances:
            at = resonance.xreplace({gs.symbol(name): x for name, x in values.items()})
            assert (at == 0) == ((m, n) in form.resonances)


@pytest.mark.slow
def test_that_of_a_heavy_top_is_that_of_another_algorithm():
    """Of E1, 103 terms in its margin, at random moments and rates; no other is in the library's chart."""
    report = gs.analyze(FAMILIES["E1"]())
    window = report.window()
    assert len(window.margin.args) == 103 and not window.zeros
    rng = random.Random(7)
    for _ in range(5):
        values, _ = drawn(report, rng)
        moments = [values[name] for name in ("I1", "I2", "I3")]
        inverse = [[1 / moments[i] if i == j else Rational(0) for j in range(3)] for i in range(3)]
        parts = energy(inverse, [Rational(0)] * 3, [Rational(n) for n in (0, 0, 1)],
                       [Rational(0), Rational(0), values["pi3_0"]], {(0, 0, 1): values["m0"]}, 4)
        assert twists(parts)[0] == rational(known(window, values)[0])


@pytest.mark.slow
def test_the_denominator_of_a_heavy_top():
    """D4 = N/(16 I1 I2 I3 a1 a2 I1² I2² (p² − 4q)), a_i = (I3 − I_i) W − m0, N of degree 5 in W = omega²."""
    report, W = gs.analyze(FAMILIES["E1"]()), Symbol("W")
    window = report.window()
    p, q, D4 = (x.xreplace({gs.symbol("pi3_0"): I3 * sqrt(W)}) for x in (window.p, window.q, window.D4))
    below = 16 * I1 * I2 * I3 * (I1 * I2)**2 * prod((I3 - x) * W - m0 for x in (I1, I2)) * (p**2 - 4 * q)
    N = cancel(D4 * below)
    assert N.is_polynomial() and len(Poly(N, W, I1, I2, I3, m0).terms()) == 103 and Poly(N, W).degree() == 5


def test_the_one_of_the_shared_numbers():
    """I = (5, 4, 3), m0 = 1: 400 (p² − 4q) = 324 W² − 636 W + 1, and D4 > 0 by its five signs, W = omega²."""
    report = gs.analyze(FAMILIES["E1"]())
    window = report.window({"I1": 5, "I2": 4, "I3": 3, "m0": 1})
    W = Symbol("W")
    spin = {gs.symbol("pi3_0"): 3 * sqrt(W)}
    p, q, D4 = (x.xreplace(spin) for x in (window.p, window.q, window.D4))
    assert (400 * (p**2 - 4 * q) - (324 * W**2 - 636 * W + 1)).expand() == 0
    margin = 7776 * W**5 + 7524 * W**4 + 37868 * W**3 + 49189 * W**2 + 17810 * W + 14
    ratio = (D4 * q * (p**2 - 4 * q) / margin).simplify()
    assert ratio.is_Rational and ratio > 0
    assert (window.margin, window.zeros) == (1, ())
    third = window.resonances[1][2].xreplace(spin)
    assert min(abs(float(root) - 26.9974117614041) for root in third.as_poly(W).nroots()) < 1e-10


def test_jets():
    """Of U(k3) unspecified: dU and d2U, at E1."""
    eq = gs.upright(gs.assemble(gs.Gyrostat((I1, I2, I3), (0, 0, l)), gs.axial_potential()))
    window = gs.analyze(eq).window({"I1": 5, "I2": 4, "I3": 3, "l": 1, "pi3_0": 6})
    assert {s.name for s in window.D4.free_symbols} == {"dU", "d2U"} and window.at == 1
    form = gs.analyze(eq).normal_form({"I1": 5, "I2": 4, "I3": 3, "l": 1, "pi3_0": 6, "dU": 1, "d2U": -2,
                                       "d3U": 7, "d4U": 5})
    assert known(window, {"dU": Rational(1), "d2U": Rational(-2)})[0] == form.twists[0]


@pytest.mark.parametrize("values, said", [
    ({"m0": sqrt(2)}, "rational"), ({"I1": -1}, "positive"), ({"x": 1}, "no parameter x")])
def test_what_is_refused(values, said):
    report = gs.analyze(FAMILIES["E1"]())
    with pytest.raises(gs.errors.GyrostatError, match=said):
        report.window(values)


def test_a_free_body_has_none():
    report = gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0))), 3))
    with pytest.raises(gs.errors.ScopeError, match="free body"):
        report.window()


def test_too_many_names_off_symmetry_are_refused():
    eq = gs.permanent_rotation(gs.assemble(gs.Gyrostat((3, 5, 4), (0, 0, 0)), gs.general_potential()),
                               ("2/3", "1/3", "2/3"))
    with pytest.raises(gs.errors.ScopeError, match="all but 3 of them"):
        gs.analyze(eq).window()


def test_the_command_line_prints_it_where_a_name_is_open(capsys):
    """The rational function, factored, the polynomials of the resonances and its sign; as JSON the same."""
    top = ("--inertia", "5,4,3", "--potential", "m0*k3", "--gyrostatic-momentum", "0,0,0",
           "--equilibrium", "E1", "--set", "m0=1", "--normal-form", "4")
    _, said, _ = run(capsys, *top, verb="decide")
    assert "26 (π₃⁰)⁴ − 771 (π₃⁰)² − 396 ≠ 0" in said and "and if D₄ ≠ 0, which is positive there:" in said
    assert "/(960 ((π₃⁰)² + 9) (2 (π₃⁰)² + 9) (12 (π₃⁰)⁴ − 212 (π₃⁰)² + 3))" in said
    _, said, _ = run(capsys, *top, "--format", "json", verb="decide")
    data = json.loads(said)
    window = gs.analyze(FAMILIES["E1"]()).window({"I1": 5, "I2": 4, "I3": 3, "m0": 1})
    assert data["D4"] == str(window.D4) and data["resonances"][0]["frequencies"] == [1, 2]
    assert r"D_{4} = \frac{" in window._repr_latex_()


@pytest.mark.slow
def test_conditions_with_their_windows(capsys):
    """N has the sign of D4 at E2, whose product is printed; a body of revolution has no window."""
    body = ("--potential", "m0*k3", "--gyrostatic-momentum", "0,0,0", "--set", "m0=1", "--windows")
    _, said, _ = run(capsys, "--inertia", "5,4,3", *body, verb="conditions")
    assert "D₄ = N/P" in said and "P = 960 (9 − (π₃⁰)²) (9 − 2 (π₃⁰)²) (12 (π₃⁰)⁴ + 212 (π₃⁰)² + 3)" in said
    assert "E2, between its two conditions" in said and "1442610 (π₃⁰)² − 10206" in said
    _, said, _ = run(capsys, "--inertia", "5,4,3", *body, "--format", "json", verb="conditions")
    data = json.loads(said)["windows"]
    assert data.keys() == {"E1", "E2"} and data["E1"]["margin"] == "1"
    _, said, _ = run(capsys, "--inertia", "5,4,3", *body, "--format", "latex", verb="conditions")
    assert r"D_{4} = \frac{N}{P}" in said
    assert "D₄ = N/P" in str(gs.analyze(FAMILIES["E1"]()).window())
    _, said, _ = run(capsys, "--inertia", "5,5,3", *body, verb="conditions")
    assert "D₄" not in said
