"""Numbers in columns: those in a field look as the same numbers written out do."""
import pytest
from flint import fmpq_poly
from sympy import Integer, Rational, S, pi, sqrt

import gyrostat as gs
from gyrostat.algebra.solving.real_fields import Conjugates, FieldNumbers
from gyrostat.printing.cells import in_a_cell, in_cells


def test_a_cell_is_narrow():
    """In a column no exact form but that of a short fraction."""
    shown = [in_a_cell(v) for v in (Rational(1, 3), Rational(-123, 4567), sqrt(2), 10**9 * pi, Integer(-1))]
    assert shown == ["1/3", "−0.02693", "1.414", "3.142·10⁹", "−1"]
    assert in_cells([Rational(1, 3), None, sqrt(2)]) == ["1/3", "any", "1.414"]


@pytest.mark.parametrize("polynomial", [[-3, 2], [-2, 0, 1], [-2, 0, 0, 1], [1, -3, 0, 1], [-3, 0, 0, 0, 1]])
def test_cells_of_a_field_are_those_of_the_numbers(polynomial):
    """Of degree 1 to 4; some quotients are fractions, short ones and 1000001/3, and one is 0."""
    root, one = fmpq_poly([0, 1]), fmpq_poly([1])
    tops = [fmpq_poly([0]), root, 2 * root, root**2, root**2 / 3 * 1000001, one, root + one]
    numbers = Conjugates(fmpq_poly(polynomial), tops, root)
    for n in range(len(numbers.exact)):
        for factor in (S.One, Rational(-1, 3), sqrt(2)):
            values = FieldNumbers(numbers, n, [(place, factor) for place in range(len(tops))])
            assert in_cells(values) == [in_a_cell(x) for x in values]


def test_cells_of_a_satellite_are_those_of_the_numbers():
    """Of degree 24."""
    body = gs.Gyrostat((1, "5/4", "8/5"), ("3/10", "1/5", "1/10"))
    found = gs.relative_equilibria(gs.assemble(body, gs.circular_orbit(1)), {})
    for _, numbers in found[3].form.placed:
        assert isinstance(numbers, FieldNumbers) and in_cells(numbers) == [in_a_cell(x) for x in numbers]
