"""Conditions of permanent rotations that are too long to be written out: in names, decided at numbers."""
import json
from fractions import Fraction

import heavy_exact
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from rotation_families import JETS, LINEAR, QUADRATIC, ROTOR
from sympy import Rational, sympify

import gyrostat as gs
from gyrostat.printing.formats.json_data import json_text, report_data
from gyrostat.printing.formats.text import text
from gyrostat.printing.results.document import conditions_blocks

ENTRIES = [[gs.symbol(f"I{min(i, j)}{max(i, j)}") for j in (1, 2, 3)] for i in (1, 2, 3)]
TURN = [[Fraction(x, 3) for x in row] for row in ((2, -1, 2), (2, 2, -1), (-1, 2, 2))]
NUMBERS = st.fractions(-4, 4, max_denominator=9)
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS)
MOMENTS = st.tuples(*[st.fractions("1/4", 9, max_denominator=9)] * 3)


def analyzed(U, direction, **body):
    scene = gs.assemble(gs.Gyrostat(**body), gs.general_potential(U))
    return gs.analyze(gs.permanent_rotation(scene, direction))


@pytest.fixture(scope="module")
def any_tensor():
    """A tensor of six letters, a rotor of three, any direction, U = c·k."""
    return analyzed(LINEAR, gs.stereographic(), inertia=ENTRIES, gyrostatic_momentum=ROTOR)


@pytest.fixture(scope="module")
def curved():
    """One body in any field of second degree, any direction."""
    return analyzed(QUADRATIC, gs.stereographic(), inertia=(3, 5, 4), gyrostatic_momentum=(1, "-1/2", 2))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def turned(v):
    return [dot(row, v) for row in TURN]


def direction(u):
    whole = 1 + u[0] ** 2 + u[1] ** 2
    return [2 * u[0] / whole, 2 * u[1] / whole, 2 / whole - 1]


def decided(t, s, p, q):
    """By the signs alone: the rung of a verdict, and what is lost under damping."""
    rung = "second variation" if t > 0 < s else "spectrum" if min(p, q, p * p - 4 * q) < 0 else ""
    return rung, None if t > 0 < s else 1 if s < 0 else 2 if t < 0 < s else 0


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(moments=MOMENTS, rotor=VECTORS, u=st.tuples(NUMBERS, NUMBERS), omega=NUMBERS, sigma=NUMBERS,
       on=st.booleans())
def test_the_names_are_the_invariants_of_a_tensor_of_six_letters(any_tensor, moments, rotor, u, omega, sigma,
                                                                 on):
    """t, s, p and q of a turned body are those of the body by an oracle in fractions; on t = 0 too."""
    assume(len(set(moments)) == 3)                             # a body of revolution is recognised at numbers
    k, inverse = direction(u), list(zip(*TURN))
    place = [dot(row, k) for row in inverse]                   # in the principal axes
    own = [dot(row, rotor) for row in inverse]

    def oracle(sigma):
        c = [omega**2 * i * x + omega * l + sigma * x for i, x, l in zip(moments, place, own)]
        return heavy_exact.decided(moments, own, c, [[Fraction(0)] * 3] * 3, omega, place)

    if on:                                                     # t is affine in sigma, of slope −2
        sigma += oracle(sigma)[3] / 2
    p, q, s, t = oracle(sigma)
    assert t == 0 or not on
    tensor = [turned([i * x for i, x in zip(moments, row)]) for row in TURN]
    values = {f"I{i + 1}{j + 1}": tensor[i][j] for i in range(3) for j in range(i, 3)}
    values |= dict(zip(("l1", "l2", "l3", "u1", "u2", "omega", "sigma"), (*rotor, *u, omega, sigma)))
    found = any_tensor.verdict(values)
    margins = {str(name): value for name, value in found.margins}
    assert all(margins.get(name, x) == Rational(x) for name, x in zip("tspq", (t, s, p, q)))
    rung, growing = decided(t, s, p, q)
    assert (found.rung.value == rung) if rung else not found.rung.by_condition
    damped = any_tensor.verdict(values, damped=True)
    assert damped.growing == 0 if growing is None else growing == 0 or damped.growing == growing


def form_across(k, numbers):
    """A basis of the plane across k, its squares of length, and A, G, K without D²U there, in fractions."""
    inertia, rotor, omega, sigma = numbers
    n = min(range(3), key=lambda n: abs(k[n]))
    e = [Fraction(i == n) for i in range(3)]
    one = [k[1] * e[2] - k[2] * e[1], k[2] * e[0] - k[0] * e[2], k[0] * e[1] - k[1] * e[0]]
    two = [k[1] * one[2] - k[2] * one[1], k[2] * one[0] - k[0] * one[2], k[0] * one[1] - k[1] * one[0]]
    along = [i * x for i, x in zip(inertia, k)]
    J, v = dot(k, along), [2 * omega * a + l for a, l in zip(along, rotor)]
    pairs = [(a, b) for a in (one, two) for b in (one, two)]
    A = [sum(i * x * y for i, x, y in zip(inertia, a, b)) - dot(a, along) * dot(b, along) / J
         for a, b in pairs]
    K = [dot(a, v) * dot(b, v) / J - sum((omega**2 * i + sigma) * x * y for i, x, y in zip(inertia, a, b))
         for a, b in pairs]
    return (one, two), dot(one, one), A, dot(v, along) / J - omega * sum(inertia), K


def boundary(kind, k, numbers, a, b):
    """D²U that puts the rotation on t = 0, s = 0 or p² = 4q, or beside the last."""
    basis, size, A, G, K = form_across(k, numbers)             # both vectors have the same length
    low = A[1] / A[0]
    rest = A[3] - low * A[1]
    if kind == "t":
        wanted = a, b, b, -a
    elif kind == "s":
        wanted = a * a, a * b, a * b, b * b
    else:                                                      # tr AK = −α² − β², α = β + G
        first = b + G * size + (a if kind == "near" else 0)
        x, y = -first**2 / A[0], -b * b / rest
        wanted = x + low**2 * y, -low * y, -low * y, y
    gap = [(w - z) / size**2 for w, z in zip(wanted, K)]
    return [[sum(g * basis[n // 2][i] * basis[n % 2][j] for n, g in enumerate(gap)) for j in range(3)]
            for i in range(3)]


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(u=st.tuples(NUMBERS, NUMBERS), omega=NUMBERS, sigma=NUMBERS, a=NUMBERS, b=NUMBERS,
       kind=st.sampled_from("t s d near".split()))
def test_on_the_boundaries_the_small_matrices_say_what_the_polynomials_do(curved, u, omega, sigma, a, b,
                                                                          kind):
    """On t = 0, s = 0 and p² = 4q exactly, and beside; the signs are those of an oracle in fractions."""
    assume(omega != 0 and (kind != "s" or a or b))
    k, body = direction(u), (tuple(map(Fraction, (3, 5, 4))), tuple(map(Fraction, (1, "-1/2", 2))))
    near = Fraction(1, 10**30) if kind == "near" else a
    Q = boundary(kind, k, (*body, omega, sigma), near, b)
    c = [omega**2 * i * x + omega * l + sigma * x - dot(row, k)
         for i, x, l, row in zip(body[0], k, body[1], Q)]
    p, q, s, t = heavy_exact.decided(*body, c, Q, omega, k)
    assert {"t": t, "s": s, "d": p * p - 4 * q, "near": 0}[kind] == 0
    values = {"u1": u[0], "u2": u[1], "omega": omega, "sigma": sigma}
    values |= {f"b{i + 1}{j + 1}": Q[i][j] for i, j in JETS}
    found, rung = curved.verdict(values), decided(t, s, p, q)[0]
    assert (found.rung.value == rung) if rung else not found.rung.by_condition
    if kind != "s":                                            # there theorems decide, from matrices
        written = curved.written_out.verdict(values)
        assert (found.verdict, found.rung, found.reason) == (written.verdict, written.rung, written.reason)


OBLIQUE, PLANE = ("1/3", "2/3", "2/3"), ("sin(a)", "0", "cos(a)")


@pytest.mark.few(1)
@pytest.mark.parametrize(("long", "U", "place", "body"), [
    (False, LINEAR, OBLIQUE, {"gyrostatic_momentum": ROTOR}), (False, LINEAR, PLANE, {}),
    (False, LINEAR, ("0", "0", "1"), {"inertia": ENTRIES, "gyrostatic_momentum": (0, 0, gs.symbol("l"))}),
    (False, LINEAR, gs.stereographic(), {"inertia": (2, 2, 2)}),
    (True, LINEAR, OBLIQUE, {"inertia": ENTRIES}), (True, LINEAR, gs.stereographic(), {}),
    (True, None, OBLIQUE, {"gyrostatic_momentum": ROTOR})])
def test_short_conditions_are_written_out(long, U, place, body):
    """In names if t has more than 25 terms; the damped criterion as the sufficient one."""
    report = analyzed(U, place, **{"gyrostatic_momentum": (0, 0, 0)} | body)
    names = {"t", "s", "p", "q"}
    written = {s.name for criterion in (report.necessary, report.sufficient, report.damped)
               for a in criterion.alternatives for c in a for s in c.symbols}
    assert (report.closed is not None) is long and (written == names if long else not written & names)
    if long:
        assert report.written_out.closed is None and not {
            s.name for a in report.written_out.sufficient.alternatives for c in a for s in c.symbols} & names
        assert report.written_out.damped.alternatives == report.written_out.sufficient.alternatives
    else:
        assert report.written_out is report


def of_degree_two(*names):
    """U = c·k, and a coefficient b_ij for each product of components that is named."""
    k = [gs.symbol(f"k{n}") for n in (1, 2, 3)]
    return LINEAR + sum(gs.symbol(f"b{x}") * k[int(x[0]) - 1] * k[int(x[1]) - 1] for x in names)


def tensor(*products):
    """A tensor of names, with some of the products of inertia."""
    return [[x if i == j or f"{min(i, j)}{max(i, j)}" in products else 0 for j, x in enumerate(row, 1)]
            for i, row in enumerate(ENTRIES, 1)]


def parts(form):
    """How many parts a symmetric matrix has that no entry connects."""
    joined = [{i} for i in range(form.rows)]
    for i in range(form.rows):
        for j in range(i):
            if form[i, j] != 0:
                both = [part for part in joined if i in part or j in part]
                joined = [part for part in joined if part not in both] + [set().union(*both)]
    return len(joined)


@pytest.mark.few(2)
@pytest.mark.parametrize(("splits", "products", "rotor", "U"), [
    (True, ("13",), (1, 0, "l"), ("11", "22", "13")), (False, ("13",), (1, "l", 0), ("11", "22", "13")),
    (False, ("13",), (1, 0, "l"), ("11", "22", "12")), (False, ("12", "13"), (1, 0, "l"), ("11", "22"))])
def test_what_splits_is_written_out_however_long(splits, products, rotor, U):
    """A plane of symmetry of I and U has k and l in it; the blocks are those of the second variation."""
    report = analyzed(of_degree_two(*U), PLANE, inertia=tensor(*products), gyrostatic_momentum=rotor)
    assert (report.closed is None) is splits
    assert (parts(report.written_out.second_variation.matrix) > 1) is splits


@pytest.mark.parametrize(("splits", "along"), [(True, 0), (True, 1), (False, 0)])
def test_a_body_at_rest_splits_if_its_rotor_is_along_k(splits, along):
    """Its momenta are apart from its attitude then; without a rotor, too."""
    k = tuple(map(sympify, gs.stereographic()))
    rotor = [along * gs.symbol("l") * x for x in k] if splits else (1, 0, 0)
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=rotor), gs.general_potential())
    slopes = tuple((gs.symbol(f"dU_{n}"), gs.symbol("sigma") * x) for n, x in enumerate(k, 1))
    report = gs.analyze(gs.Equilibrium("at rest", scene, (*map(sympify, (0, 0, 0)), *k), slopes))
    assert (report.closed is None) is splits
    assert (parts(report.written_out.second_variation.matrix) > 1) is splits


def test_a_tensor_of_six_letters_is_printed_in_names(any_tensor):
    """The text defines each name before it is used; the definitions in JSON are t and s at numbers."""
    said = text(conditions_blocks(any_tensor))
    assert len(said) < 6000 and "t > 0\n    s > 0\n" in said
    places = [said.index(f"\n    {name} = ") for name in "k₁ J v₁ K₁₁ A₁₁ G t s p q".split()]
    assert places == sorted(places)
    data = json.loads(json_text(report_data(any_tensor)))
    values = {"I11": 3, "I12": 1, "I13": 0, "I22": 4, "I23": -1, "I33": 5, "l1": 1, "l2": 0, "l3": 2,
              "u1": 1, "u2": 2, "omega": 2, "sigma": -30}
    place = {name: Fraction(x) for name, x in values.items()}
    for name, definition in data["definitions"].items():
        place[name] = eval(definition, {}, place)
    margins = {str(name): value for name, value in any_tensor.verdict(values).margins}
    assert {name: Rational(place[name]) for name in margins} == margins


@pytest.mark.slow
def test_a_name_is_solved_for_as_in_the_polynomials(curved):
    """The sigma for which a rotation is stable, with algebraic ends: from the names, and written out."""
    numbers = {"u1": "1/2", "u2": "1/3", "omega": 2}
    numbers |= {"b11": 1, "b12": -1, "b13": 0, "b22": 2, "b23": 1, "b33": -3}
    ours, theirs = (gs.stabilizing_set(report, "sigma", numbers) for report in (curved, curved.written_out))
    assert str(ours) == str(theirs) and "−10.9509… or −10.9509… < σ ≤ −10.8722…" in str(ours)
