"""Vectors and tensors with one unit, and settings in a text: each spelling is that of single texts."""
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.algebra.text.tensors import rows_of, settings_in
from gyrostat.errors import BodyError, ExpressionError, GyrostatError

numbers = st.fractions(min_value=-9, max_value=9, max_denominator=99).map(str)
UNITS = {"kg m^2": 1, "g mm²": Fraction(1, 10**9), "kg·m²": 1}


@given(st.lists(numbers, min_size=9, max_size=9), st.sampled_from(sorted(UNITS)))
def test_one_unit_is_that_of_every_entry(texts, unit):
    """In brackets, between semicolons, and blanks in brackets, as they are printed by other programs."""
    rows = [texts[:3], texts[3:6], texts[6:]]
    commas, blanks = [", ".join(row) for row in rows], [" ".join(row) for row in rows]
    spelled = ["[[" + "], [".join(commas) + f"]] {unit}",
               f"[{'; '.join(blanks)}]{unit}", f"{';'.join(commas)} {unit}",
               f"[[{']  ['.join(blanks)}]] {unit}"]
    wanted = [[Fraction(x) * UNITS[unit] for x in row] for row in rows]
    for text in spelled:
        found = [[Fraction(str(exact_number(x, "inertia"))) for x in row] for row in rows_of(text)]
        assert found == wanted, text


@given(st.lists(numbers, min_size=3, max_size=3))
def test_a_unit_after_the_last_of_three_is_that_of_all(texts):
    """Unless another one has a unit, too: then each needs its own."""
    alone = rows_of(", ".join(texts) + " N m s")
    assert [exact_number(x, "l") for x in alone] == [exact_number(x) for x in texts]
    assert rows_of(f"{texts[0]} N m s, {texts[1]}, {texts[2]} N m s")[1] == texts[1]


def test_an_expression_has_its_unit_too():
    """2*pi kg m^2 is read in parentheses."""
    assert gs.Gyrostat("[2*pi, 6, 5] kg m^2", (0, 0, 0)).moments[0] == 2 * gs.Gyrostat(
        ("pi", 6, 5), (0, 0, 0)).moments[0]


@pytest.mark.parametrize("text", ["[[1,2,3],[4,5,6]x]", "[1,2,3", "[[1,2],[2,3]] kg m^2", "[] kg m^2",
                                  "1,2 kg m^2", "[[1,0,0],[0,1,0],[0,0]] kg m^2", "1,2,3 kg",
                                  "[1,2,3] furlong", "", ",,"])
def test_what_is_no_body_is_refused(text):
    """In a sentence."""
    with pytest.raises(GyrostatError) as refused:
        gs.Gyrostat(text, (0, 0, 0))
    assert len(str(refused.value)) <= 300


def test_products_of_inertia_have_one_of_two_signs():
    """Of point masses: Σ m xy is printed as it is, and stands in the tensor with a minus."""
    points = [(2, (1, 0, 2)), (1, (-1, 3, 1)), (3, (0, 1, -1)), (1, (2, 1, 0))]
    integrals = [[sum(m * x[i] * x[j] for m, x in points) for j in range(3)] for i in range(3)]
    trace = sum(integrals[i][i] for i in range(3))
    printed = [[trace - integrals[i][i] if i == j else integrals[i][j] for j in range(3)] for i in range(3)]
    body = gs.Gyrostat(printed, (0, 0, 0), products="positive")
    turning = (1, 2, -1)                                # energy of the points, from their velocities
    cross = [tuple(turning[(i + 1) % 3] * x[(i + 2) % 3] - turning[(i + 2) % 3] * x[(i + 1) % 3]
                   for i in range(3)) for _, x in points]
    twice = sum(m * sum(v**2 for v in u) for (m, _), u in zip(points, cross))
    assert sum(body.tensor[i, j] * turning[i] * turning[j] for i in range(3) for j in range(3)) == twice
    assert gs.Gyrostat(body.tensor, (0, 0, 0)) == body != gs.Gyrostat(printed, (0, 0, 0))
    with pytest.raises(BodyError, match="∫ xy dm"):
        gs.Gyrostat(printed, (0, 0, 0), products="cad")
    assert gs.gyrostat_with_rotors(printed, [], lumped=True, products="positive") == body


@pytest.mark.parametrize(("text", "values"), [
    ("a=1 b=2", {"a": "1", "b": "2"}), ("a=1,b=2", {"a": "1", "b": "2"}), ("a=", {"a": ""}),
    ("a = 1 , b = 2,", {"a": "1", "b": "2"}),
    ("axis=0,0,1 speed=3 rad/s", {"axis": "0,0,1", "speed": "3 rad/s"}),
    ("a=1 a=2", None), ("1", None), ("", None), ("3 a=1", None), ("a=1=2", None), ("=", None)])
def test_settings_are_read_by_their_names(text, values):
    """Blanks or commas stand between them."""
    assert settings_in(text) == values


def test_brackets_that_are_none_are_said():
    """With the form to write."""
    with pytest.raises(ExpressionError, match="write \\[\\[1, 0, 0\\]"):
        rows_of("[1, [2], 3]")
