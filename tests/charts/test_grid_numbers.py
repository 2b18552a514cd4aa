"""The numbers of a grid: each kept as what it is, exactly, and what is no number named."""
import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from charts.grid_points import points
from hypothesis import given
from hypothesis import strategies as st
from sympy import Integer, Rational, S, exp, pi, sqrt

import gyrostat as gs
from gyrostat.charts.grids import grid_of
from gyrostat.errors import GyrostatError

a = gs.symbol("a")
EXACT = [(3, 3), (2**53, 2**53), (2**53 + 1, 2**53 + 1), (-2**64 - 1, -2**64 - 1),
         (Fraction(1, 3), Rational(1, 3)),
         (Fraction(3, 4), Rational(3, 4)),
         (Decimal("0.1"), Rational(1, 10)), ("1/3", Rational(1, 3)), ("sqrt(2)", sqrt(2)),
         (sqrt(3) / 2, sqrt(3) / 2), (pi, pi),
         (Integer(7), Integer(7)), (S.Half, S.Half), (0.1, Rational(0.1)),
         (np.float32(0.1), Rational(float(np.float32(0.1)))),
         (np.float16(0.1), Rational(float(np.float16(0.1)))), (np.int8(-3), Integer(-3)),
         (np.uint64(2**64 - 1), Integer(2**64 - 1)),
         (10**400, Integer(10) ** 400), (Fraction(1, 10**400), Rational(1, 10**400)),
         (exp(-1000), exp(-1000)),
         (5e-324, Rational(5e-324)), (-0.0, S.Zero)]


@pytest.mark.parametrize(("value", "exact"), EXACT)
def test_numbers_are_kept_exactly(value, exact):
    """A point has the number that was given, as a double where it is one.

    The double stored is within one rounding, or NaN.
    """
    grids = [grid_of({"a": value}), grid_of({"a": np.array([value, 1], dtype=object)})]
    for grid in grids:
        number = points(grid)[0][a]
        found = Rational(*number.as_integer_ratio()) if isinstance(number, float) else number
        near = float(grid.values[a].flat[0])
        assert found == exact
        assert math.isnan(near) or abs(Rational(near) - exact).evalf(30) <= 2.0**-53 * abs(near)
        assert (a in grid.exact) == (not isinstance(number, float))
        assert math.isfinite(near) or not isinstance(number, float)


@pytest.mark.parametrize("bits", [60, 90, 115, 125, 140, 200])
@pytest.mark.parametrize("sign", [1, -1])
def test_constants_that_cancel_are_near_or_unknown(bits, sign):
    """±(√2 − p/2ⁿ): the double is within two roundings of the number however much cancels, or NaN.

    Never merely close to 0.
    """
    number = sign * (sqrt(2) - Rational(math.isqrt(2 << 2 * bits), 2**bits))
    near = float(grid_of({"a": number}).values[a][0, 0])
    assert math.isnan(near) or abs(Rational(near) - number).evalf(40) <= 2 * 2.0**-53 * abs(near)


doubles = st.floats(allow_nan=False, allow_infinity=False)


@pytest.mark.slow
@given(values=st.lists(st.one_of(doubles, st.fractions(), st.integers(-2**70, 2**70)), min_size=1,
                       max_size=5))
def test_object_arrays_are_read_number_by_number(values):
    """Arrays of Fractions, integers and floats keep each exactly."""
    array = np.empty(len(values), dtype=object)
    array[:] = values
    grid = grid_of({"a": array})
    for n, value in enumerate(values):
        number = points(grid)[n][a]
        assert (
            Fraction(number) if isinstance(number, float) else Fraction(int(number.p), int(number.q))
        ) == Fraction(value)


@pytest.mark.parametrize("dtype", ["i1", "u2", "i4", "i8", "u8", "f2", "f4", "f8", ">f8", ">i4"])
def test_real_types_become_doubles(dtype):
    """Integers and floats of every size and byte order are the doubles that they are."""
    grid = grid_of({"a": np.array([[1, 2], [3, 100]], dtype=dtype)})
    assert not grid.exact and [p[a] for p in points(grid)] == [1.0, 2.0, 3.0, 100.0]


@pytest.mark.parametrize("values", [[2**53 + 1, 1], [-2**53 - 1, 0], [2**63, 5], [2**62 + 1, -2**62 - 1]])
def test_long_integers_are_exact(values):
    """Integers beyond 2⁵³ that are no doubles are kept as they are."""
    grid = grid_of({"a": np.array(values)})
    assert [Fraction(p[a] if isinstance(p[a], float) else str(p[a])) for p in points(grid)] == values


@pytest.mark.slow
@pytest.mark.parametrize(("value", "said"), [
    ([1.0, math.nan], r"a\[1\] = nan is not a finite"),
    ([[1.0, 2.0], [-math.inf, math.nan]], r"a\[1, 0\] = -inf is not a finite"),
    (math.nan, "a = nan"), (np.array(["1", "2"]), "a is an array of <U1"), (True, "a is an array of bool"),
    ([True, False], "a is an array of bool"), (1j, "complex128"), (np.ones(2, dtype=complex), "complex128"),
    (np.longdouble(1), "float"), (np.datetime64("2020"), "datetime64"), (b"1", "S1"),
    ([1, None], r"a\[1\] = None is a NoneType"), (None, "a = None"), ({1: 2}, "a = {1: 2} is a dict"),
    ([Fraction(1), "x"], "a"), ([Fraction(1), math.nan], r"a\[1\] = nan"),
    ([[Fraction(1), 2], [1j, 3]], r"a\[1, 0\] = 1j is a complex"),
    (gs.symbol("q"), "a = q contains"),
    (S.NaN, "a = nan"), (S.Infinity, "a = oo"), (sqrt(-2), "not an exact finite real"),
    (Decimal("NaN"), "a = NaN"),
    (Decimal("sNaN"), "sNaN"),
    ("1/0", "divides by zero"), ("a b", "cannot read"), ([sqrt(2), sqrt(-2)], r"a\[1\]"),
    (object(), "is a object"),
    ([[1, 2], [3]], "a"),
    (np.ones(2, dtype="i4,i4"), "not of real numbers")])
def test_what_is_no_number_is_named(value, said):
    """The first array, and the first of its elements in C order, that is no finite real number is named."""
    with pytest.raises(GyrostatError, match=said):
        grid_of({"a": value})


def test_numbers_that_are_not_finite_may_be_let_through():
    """finite=False keeps NaN and infinities of float arrays."""
    one, nan, inf = (p[a] for p in points(grid_of({"a": [1.0, math.nan, math.inf]}, finite=False)))
    assert one == 1 and math.isnan(nan) and inf == math.inf


def test_numbers_that_are_not_finite_may_be_let_through_among_objects():
    """finite=False keeps them in arrays of objects too."""
    assert math.isnan(float(grid_of({"a": np.array([Fraction(1, 3), math.nan], dtype=object)},
                                    finite=False).values[a][0, 1]))


def test_views_are_read_not_copied():
    """Contiguous arrays of doubles are read in place.

    Strided, transposed and read-only ones are read right.
    """
    base = np.arange(24.0).reshape(4, 6)
    assert np.shares_memory(grid_of({"a": base}).values[a], base)
    base.flags.writeable = False
    for view in (base, base.T, base[::-1, ::2], base[1:3, 1:], np.broadcast_to(base[:, :1], (4, 6))):
        grid = grid_of({"a": view})
        assert [p[a] for p in points(grid)] == view.ravel().tolist()


def test_what_is_broadcast_already_is_not_copied():
    """A view with strides of 0 varies along the axes of its base alone, as np.broadcast_to and
    np.meshgrid(copy=False) give it.
    """
    view = np.broadcast_to(np.arange(1000.0)[:, None], (1000, 1000))
    assert (
        sum(
            x.nbytes
            for x in grid_of(
                {"a": view, "b": np.broadcast_to(np.arange(1000.0), (1000, 1000))}
            ).values.values()
        )
        < 10**6
    )
