"""Attitudes of a satellite along a parameter: where their number changes, and what each is between."""
from fractions import Fraction as F
from itertools import pairwise
from random import Random

import numpy as np
import pytest
from attitude_search import search, torque
from sympy import Rational, pi, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

L = gs.symbol("l")
BODY = (1, F(5, 4), F(8, 5))
SINGULAR = "singular form"


def satellite(moments, rotor=(0, 0, 0), rate=1, **field):
    """A scene in a circular orbit."""
    return gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(rate, **field))


def oracle_of(moments, rotor=(0, 0, 0), drag=(0, 0, 0)):
    """The matrix and the vector of V = (3 r·Ir − n·In)/2 − l·n + a·t for the oracle, ω0 = 1."""
    matrix, tensor = np.zeros((9, 9)), np.diag([float(x) for x in moments])
    matrix[3:6, 3:6], matrix[6:, 6:] = -tensor, 3 * tensor
    return matrix, np.array([*map(float, drag), *(-float(x) for x in rotor), 0, 0, 0])


def counts(marks):
    """Every value and the numbers before and after it."""
    return [*dict.fromkeys((F(str(mark.value)) if mark.value.is_Rational else mark.value, mark.numbers)
                           for mark in marks)]


def by_closed_form(borders):
    """Value and numbers if four attitudes vanish at each of four values: 24, 20, 16, 12, 8."""
    return [(x, (24 - 4 * n, 20 - 4 * n)) for n, x in enumerate(sorted(borders))]


def moments(draw):
    """Three different ones."""
    return draw.sample([F(n, 12) for n in range(12, 25)], 3)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_with_a_rotor_along_an_axis(seed):
    """8 + 4 for each of abs(I1 − I2), abs(I3 − I2), and four times these, that is greater than l / ω0.

    Sarychev, Mirer & Degtyarev (2004). At l² = 4 (I1 − I2)(I3 − I2) a closed curve joins tilted attitudes,
    and no number changes.
    """
    I = moments(Random(seed))
    borders = [k * abs(I[n] - I[1]) for n in (0, 2) for k in (1, 4)]
    assert len(set(borders)) == 4
    marks = gs.continuation(satellite(I, (0, L, 0)), "l", (0, 5), {}).marks
    changed = [mark for mark in marks if mark.kind != SINGULAR]
    assert counts(changed) == by_closed_form(borders)
    assert {mark.kind for mark in changed} == {"pitchfork"}
    for mark in changed:                                   # the tilted ones have come to n along axis 2
        assert abs(float(mark.n[1])) == 1 and {abs(float(x)) for x in mark.r} == {0, 1}


@pytest.mark.slow
def test_where_a_closed_curve_of_attitudes_passes():
    """At l² = 4 (I1 − I2)(I3 − I2) their number stays, and stability goes from one family to the other."""
    found = gs.continuation(satellite((F(3, 2), F(9, 10), F(6, 5)), (0, L, 0)), "l", (F(7, 10), 1), {})
    assert {(mark.kind, str(mark.value**2), mark.numbers, mark.changes) for mark in found.marks} == {
        (SINGULAR, "18/25", (16, 16), True)}
    assert len(found.marks) == 8


@pytest.mark.slow
def test_a_dipole_along_the_normal_acts_as_a_rotor():
    """U = b n1 has the marks of l1 = −b; where the closed curve passes, none is left out."""
    dipole = gs.continuation(satellite(BODY, potential="b*n1"), "b", (F(3, 5), 1), {}).marks
    rotor = gs.continuation(satellite(BODY, (gs.symbol("b"), 0, 0)), "b", (F(3, 5), 1), {}).marks
    assert len(dipole) == len(rotor) == 8 and {mark.value**2 for mark in dipole} == {Rational(3, 5)}
    assert {(*mark.n, *mark.r) for mark in dipole} == {(-mark.n[0], -mark.n[1], -mark.n[2], *mark.r)
                                                       for mark in rotor}


@pytest.mark.slow
def test_where_the_body_is_one_of_revolution():
    """At I2 = I1 every attitude of a rigid satellite lies on a circle about axis 3, and else there are 24."""
    found = gs.continuation(satellite((1, gs.symbol("I2"), BODY[2])), "I2", (F(3, 4), F(5, 4)), {})
    assert [(mark.kind, mark.value, mark.numbers) for mark in found.marks] == 24 * [(SINGULAR, 1, (24, 24))]
    for side in (0, -1):
        here = [piece for piece in found.pieces if piece.parameter[side] != 1]
        assert sum(piece.verdict.name == "STABLE" for piece in here) == 4


@pytest.mark.slow
def test_drag_along_an_axis():
    """With drag a·t1, s = a / (3 (I1 − I_k)) and a / (I1 − I_k) are sines of tilts: four values."""
    borders = [k * abs(BODY[0] - BODY[n]) for n in (1, 2) for k in (1, 3)]
    found = gs.bifurcation_points(satellite(BODY, potential="a*t1"), "a", {})
    assert counts(mark for mark in found if mark.value > 0) == by_closed_form(borders)
    assert sorted(mark.value for mark in found) == sorted(-mark.value for mark in found)


@pytest.mark.slow
def test_astroids_of_a_rotor_in_a_principal_plane():
    """Folds are at l1^(2/3) + l2^(2/3) = (k abs(I1 − I2))^(2/3) with k = 1 and 4."""
    I, l1 = (F(20), F(25), F(32)), F(3)
    found = gs.continuation(satellite(I, (l1, L, 0)), "l", (0, 30), {})
    folds = sorted({float(mark.value) for mark in found.marks if mark.kind == "fold"})
    expected = [((k * 5) ** (2 / 3) - 3 ** (2 / 3)) ** 1.5 for k in (1, 4)]
    np.testing.assert_allclose(folds, expected, rtol=1e-12)


def numbers_between_are(found, count):
    """Between two values that change the number as many pieces as are counted."""
    changes, end = counts(found.marks), max(piece.parameter[-1] for piece in found.pieces)
    assert len(changes) > 1
    for a, b in pairwise([0.0, *(float(value) for value, _ in changes), end]):
        x = a + (b - a) * 0.37
        assert count(x) == sum(piece.parameter[0] < x < piece.parameter[-1] for piece in found.pieces)


@pytest.mark.slow
@pytest.mark.parametrize(("rotor", "drag", "name"), [
    (("3/20", "l", "7/20"), (0, 0, 0), "l"), ((0, 0, 0), ("a", "1/5", 0), "a")], ids=["rotor", "drag"])
def test_numbers_are_those_of_a_search_on_either_side(rotor, drag, name):
    """Newton's method from many starts, a little before and after a value, and where nothing changes."""
    field = " + ".join(f"({x})*t{n}" for n, x in enumerate(drag, 1)) if any(drag) else 0
    scene = satellite(BODY, [gs.symbol(x) if x == name else x for x in rotor], potential=field)
    found = gs.continuation(scene, name, (0, 1), {})

    def count(x):
        vectors = ([x if y == name else float(F(y)) for y in vector] for vector in (rotor, drag))
        return len(search(*oracle_of(BODY, *vectors), starts=200))

    for value, (before, after) in counts(found.marks)[:2]:
        assert (count(float(value) - 1e-3), count(float(value) + 1e-3)) == (before, after)
    numbers_between_are(found, count)


@pytest.mark.slow
def test_a_wheel_that_runs_free():
    """A wheel of axial moment J along a takes J a aᵀ from I in the kinetic energy alone, and l is h a."""
    J, (matrix, _) = F(1, 4), oracle_of(BODY)
    wheel = gs.Rotor((1, 0, 0), J, momentum=gs.symbol("h"))
    body = gs.gyrostat_with_rotors(BODY, [wheel], lumped=True)
    scene = gs.assemble(body, gs.circular_orbit(1))
    matrix[3, 3] += float(J)
    numbers_between_are(gs.continuation(scene, "h", (0, 1), {}),
                        lambda h: len(search(matrix, np.array([0, 0, 0, -h, 0, 0, 0, 0, 0]), starts=400)))


@pytest.mark.slow
@pytest.mark.parametrize("rotor", [(0, L, 0), (F(1, 5), L, 0)])
def test_pieces_are_attitudes_with_the_index_of_k(rotor):
    """The torque vanishes; without negative squares STABLE, with two UNDECIDED, else UNSTABLE."""
    found = gs.continuation(satellite(BODY, rotor), "l", (0, 1), {})
    verdicts = {0: "STABLE", 1: "UNSTABLE", 2: "UNDECIDED", 3: "UNSTABLE"}
    for piece in found.pieces:
        for n, x in [*enumerate(piece.parameter)][5:-5:12]:
            frame = np.array([[np.cross(piece.n[n], piece.r[n]), piece.n[n], piece.r[n]]])
            whole, slope = torque(frame, *oracle_of(BODY, [x if y == L else y for y in rotor]))
            assert np.abs(whole).max() < 1e-8
            K = np.linalg.eigvalsh(-(slope[0] + slope[0].T) / 2)
            assert piece.verdict.name == verdicts[int((K < 0).sum())]


@pytest.mark.slow
def test_a_moment_and_the_rate():
    """With a fixed rotor, the values of I1 and of ω0 are those of the closed form, solved for them."""
    rotor = (0, F(1, 5), 0)
    found = gs.continuation(satellite((gs.symbol("I1"), 2, 3), rotor), "I1", (F(3, 2), F(5, 2)), {})
    border = {2 + sign * F(1, 5) / k for sign in (-1, 1) for k in (1, 4)}
    assert {value for value, _ in counts(mark for mark in found.marks if mark.kind != SINGULAR)} == border
    rates = gs.bifurcation_points(satellite(BODY, rotor, rate=gs.symbol("omega0")), "omega0", {})
    assert counts(rates) == [(F(1, 5) / x, (8 + 4 * n, 12 + 4 * n)) for n, x in enumerate(
        sorted((k * abs(BODY[n] - BODY[1]) for n in (0, 2) for k in (1, 4)), reverse=True))]


@pytest.mark.slow
def test_an_irrational_rate():
    """With ω0 = √2, as by mu and radius, and a rotor with π: at ω0 times the values for ω0 = 1.

    At each of the two values two pitchforks end six pieces and begin two; the others go on.
    """
    scene = satellite(BODY, (0, gs.symbol("a") * pi, 0), rate="sqrt(2)")
    found = gs.continuation(scene, "a", (F(1, 4), 1), {})
    assert {((mark.value * pi / sqrt(2)).simplify(), mark.numbers) for mark in found.marks} == {
        (1, (16, 12)), (Rational(7, 5), (12, 8))}
    assert len(found.pieces) == 16 + 2 + 2


@pytest.mark.parametrize(("scene", "name", "said"), [
    (satellite(BODY, (0, L, gs.symbol("l3"))), "l", "need l3"),
    (satellite(BODY, (0, L, 0)), "omega", "omega"),
    (satellite(BODY), "l", "all numbers of the scene are given"),
    (satellite(BODY, (1, L, 0), rate="sqrt(2)"), "l", "not rational"),
    (satellite((1, 1, 2), (0, 0, L)), "l", "lie on curves"),
    (satellite(BODY, (0, L, 0), potential="r1**3"), "l", "degree above 2"),
    (satellite(BODY, (0, 0, 0), potential="t1/(1 + a)"), "a", "not polynomial")])
def test_what_is_refused(scene, name, said):
    """In a sentence."""
    with pytest.raises((ScopeError, ValuesError), match=said):
        gs.continuation(scene, name, (F(1, 10), 1), {})
