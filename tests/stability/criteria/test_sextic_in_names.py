"""Conditions of satellites that are too long to be written out: in names, against fractions."""
import json
from fractions import Fraction
from itertools import combinations_with_replacement, product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational
from two_directions import Scene, cross, dot, second_variation, sextic, stable_spectrum

import gyrostat as gs
from gyrostat.charts import verdicts
from gyrostat.printing.formats.json_data import json_text, report_data
from gyrostat.printing.formats.text import text
from gyrostat.printing.results.document import conditions_blocks, report_blocks

ENTRIES = [[gs.symbol(f"I{min(i, j)}{max(i, j)}") for j in (1, 2, 3)] for i in (1, 2, 3)]
NUMBERS = st.fractions(-3, 3, max_denominator=6)
PRODUCTS = st.fractions(-1, 1, max_denominator=6)
MOMENTS = st.tuples(*[st.fractions(2, 5, max_denominator=6)] * 3)


def pointing(tensor, spin="l"):
    """A satellite that points to the Earth, n along axis 2, r along axis 3, its rotor as it has to be."""
    orbit = gs.circular_orbit()
    body = gs.earth_pointing_gyrostat(gs.Gyrostat(tensor, (0, gs.symbol(spin), 0)), orbit)
    return gs.analyze(gs.earth_pointing(gs.assemble(body, orbit)))


def with_products(*products):
    """A tensor of names with some of the products of inertia."""
    return [[x if i == j or f"{min(i, j)}{max(i, j)}" in products else 0 for j, x in enumerate(row, 1)]
            for i, row in enumerate(ENTRIES, 1)]


@pytest.fixture(scope="module")
def satellite():
    """With two products of inertia: its Δ has 1771 terms."""
    return pointing(with_products("12", "23"))


@pytest.fixture(scope="module")
def two_fields():
    """Six letters of a tensor, three of a rotor, at rest in a field of two directions with 13 letters."""
    k1, k2, k3, e1, e2, e3 = map(gs.symbol, ("k1", "k2", "k3", "e1", "e2", "e3"))
    c = [gs.symbol(f"c{n}") for n in range(13)]
    squares = (x * y for x, y in combinations_with_replacement((k2, e1, k3, e3), 2))
    U = c[0] * k1 + c[1] * e2 + c[2] * (k2 + e1) + sum(x * y for x, y in zip(c[3:], squares))
    rotor = tuple(map(gs.symbol, ("l1", "l2", "l3")))
    scene = gs.assemble(gs.Gyrostat(ENTRIES, rotor), gs.coupled_potential(U))
    return gs.analyze(gs.steady_motion(scene, (1, 0, 0), (0, 1, 0)))


def inverse(I):
    """Of a symmetric matrix."""
    rows = cross(I[1], I[2]), cross(I[2], I[0]), cross(I[0], I[1])
    return [[x / dot(I[0], rows[0]) for x in row] for row in rows]


def in_fractions(moments, products, spin, rate):
    """The satellite in the oracle, its state, and its numbers by name."""
    (one, two, three), (p, q) = moments, products
    I = [[one, p, 0], [p, two, q], [0, q, three]]
    rotor, zero = [-rate * p, spin, -4 * rate * q], Fraction(0)
    B = [[-rate if i == j else zero for j in range(6)] for i in range(3)]
    S = [[3 * rate**2 * I[i - 3][j - 3] if min(i, j) > 2 else zero for j in range(6)] for i in range(6)]
    scene = Scene(inverse(I), rotor, B, S, [*(-rate * x for x in rotor), zero, zero, zero])
    values = dict(zip(("I11", "I22", "I33", "I12", "I23", "l", "omega0"), (*moments, p, q, spin, rate)))
    return scene, [*(rate * Fraction(x) for x in I[1]), *map(Fraction, (0, 1, 0, 0, 0, 1))], values


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(moments=MOMENTS, products=st.tuples(PRODUCTS, PRODUCTS), spin=NUMBERS,
       rate=st.fractions("1/6", 2, max_denominator=6), singular=st.booleans())
def test_the_names_are_the_coefficients_of_the_sextic(satellite, moments, products, spin, rate, singular):
    """a, b, c, Δ and both verdicts are those of nine coordinates in fractions; where K is singular, too."""
    if singular:                                               # K33 = 0 beside K23 = 0
        products, spin = (products[0], Fraction(0)), rate * (moments[0] - moments[1])
    scene, state, values = in_fractions(moments, products, spin, rate)
    assert not any(scene.field(state))
    a, b, c = sextic(scene, state)
    plus, minus, null = second_variation(scene, state)
    assert null or not singular
    found, damped = satellite.verdict(values), satellite.verdict(values, damped=True)
    discriminant = a**2 * b**2 - 4 * b**3 - 4 * a**3 * c + 18 * a * b * c - 27 * c**2
    named = dict(zip(found.names, (value for _, value in found.margins)))
    assert all(named.get(name, x) == Rational(x) for name, x in zip("abcΔ", (a, b, c, discriminant)))
    name = "STABLE" if plus == 6 else "UNDECIDED" if stable_spectrum(a, b, c) else "UNSTABLE"
    assert found.verdict.name == name and (plus == 6 or {"a", "b", "c"} & named.keys())
    assert damped.growing == minus or null or damped.verdict.name == "UNDECIDED"


@pytest.mark.few(1)
@pytest.mark.parametrize(("tensor", "long"), [
    (with_products(), False), ([["5/2", gs.symbol("I12"), 0], [gs.symbol("I12"), 3, 0], [0, 0, 2]], True),
    ([["5/2", "1/2", 0], ["1/2", 3, "1/3"], [0, "1/3", 2]], False)])
def test_a_short_sextic_is_written_out(tensor, long):
    """One name beside the rotor and the rate makes Δ longer than 25 terms."""
    report = pointing(tensor)
    names = {s.name for a in report.necessary.alternatives for x in a for s in x.symbols}
    assert (report.closed is not None) is long and (names == {"a", "b", "c"}) is long
    assert (report.written_out is report) is not long


def test_a_satellite_is_printed_in_names(satellite):
    """The text defines each name before it is used, in the report, too; JSON defines a, b, c at numbers."""
    for blocks in conditions_blocks, report_blocks:
        said = text(blocks(satellite))
        assert len(said) < 6000 and "a ≥ 0\n    b ≥ 0\n    c ≥ 0\n" in said
        places = [said.index(f"\n    {name} = ") for name in "K₁₁ K₁₂ K₂₂ K₂₃ K₃₃ g₁ g₂ g₃ a b c".split()]
        assert places == sorted(places) and "λ⁶ + a λ⁴ + b λ² + c" in said and "K₁₃" not in said
    latex = gs.to_latex(satellite.necessary)
    assert len(latex) < 500 and r"\frac{2 a^{3}}{27} - \frac{a b}{3} + c" in latex
    scene, state, values = in_fractions((3, 4, 2), (Fraction(1, 3), Fraction(-1, 2)), Fraction(3, 2), 1)
    data = json.loads(json_text(report_data(satellite)))
    assert data["characteristic_polynomial"] == "a*lamda**4 + b*lamda**2 + c + lamda**6"
    place = {name: Fraction(x) for name, x in values.items()}
    for name, definition in data["definitions"].items():
        place[name] = eval(definition, {}, place)
    assert [place[name] for name in "abc"] == list(sextic(scene, state))


@pytest.mark.slow
def test_long_minors_of_K_are_in_names(two_fields, satellite):
    """Those of two fields are in the entries of K; those of the satellite have at most 25 terms."""
    names = [{s.name for a in criterion.alternatives for x in a for s in x.symbols} for criterion in (
        two_fields.sufficient, two_fields.damped, satellite.sufficient, satellite.damped)]
    entries = {"K11", "K12", "K13", "K22", "K23", "K33"}
    assert names[0] == names[1] == entries and not (names[2] | names[3]) & entries
    values = {s: Fraction(n % 5 + 1, 2) for n, s in enumerate(two_fields.required)}
    values |= {"I11": 9, "I22": 8, "I33": 7, "c0": -40, "c1": -50}
    K = [50 + 2 * values["c12"], values["c2"] - values["c11"], 40 + 2 * values["c10"]]
    assert K[0] * K[2] > K[1]**2
    for damped in (False, True):
        assert two_fields.verdict(values, damped).verdict.name == "STABLE"
        lost = two_fields.verdict(values | {"c1": 10}, damped)
        assert lost.verdict.name == "UNSTABLE" and lost.growing in (None, 1)


def test_arrays_of_satellites_in_names_are_single_verdicts(satellite):
    """By the small matrices, without damping and with it."""
    fixed = {"I11": 2.0, "I22": 2.5, "I33": 1.5, "I23": 0.125, "omega0": 1.0}
    spins, products = [-6.0, -4.0, -1.0, 0.5, 3.0], [-0.5, 0.0, 0.25]
    for damped in (False, True):
        found = verdicts(satellite, {**fixed, "l": [[x] for x in spins], "I12": products}, damped=damped)
        single = [satellite.verdict({**fixed, "l": l, "I12": p}, damped).verdict.name
                  for l, p in product(spins, products)]
        codes = {"STABLE": 1, "UNDECIDED": 0, "UNSTABLE": -1}
        assert [codes[name] for name in single] == [int(x) for row in found.tolist() for x in row]


def test_another_letter_takes_the_place_of_one_that_the_body_has():
    """A moment of the body that is called a."""
    tensor = with_products("12")
    tensor[2][2] = gs.symbol("a")
    report = pointing(tensor)
    names = {s.name for a in report.necessary.alternatives for x in a for s in x.symbols}
    assert len(names) == 3 and {"b", "c"} < names and "a" not in names
    (other,) = names - {"b", "c"}
    assert f"λ⁶ + {other} λ⁴ + b λ² + c" in text(conditions_blocks(report))


@pytest.mark.slow
def test_names_and_polynomials_decide_the_same(satellite):
    """Verdict, rung, reason and growing modes, and the values of a parameter for which it is stable."""
    written = satellite.written_out
    longest = max(len(x.margin.args) for a in written.necessary.alternatives for x in a)
    assert written.closed is None and longest > 1000
    numbers = {"I11": 2, "I22": "5/2", "I33": "3/2", "I12": "1/5", "I23": "1/10", "omega0": 1}
    ours, theirs = (gs.stabilizing_set(report, "l", numbers) for report in (satellite, written))
    assert str(ours) == str(theirs) and "−16.9200…" in str(ours)
    for spin, damped in product(range(-18, 4, 2), (False, True)):
        ours, theirs = (x.verdict({**numbers, "l": spin}, damped) for x in (satellite, written))
        assert (ours.verdict, ours.rung, ours.reason, ours.growing) == (
            theirs.verdict, theirs.rung, theirs.reason, theirs.growing)
