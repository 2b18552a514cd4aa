"""Signs on a grid: each is proved, whatever the scale, by floats where they suffice and exactly where they do
not.
"""
import math
from fractions import Fraction

import numpy as np
import pytest
from charts.grid_signs import exactly, signs_of
from hypothesis import given
from hypothesis import strategies as st
from sympy import Integer, Rational, cos, log, sin

import gyrostat as gs
from gyrostat.charts.grids import grid_of
from gyrostat.charts.programs.rounding import error_bound
from gyrostat.charts.programs.straightline import program_of
from gyrostat.charts.signs import grid_signs as arraysigns
from gyrostat.charts.signs.grid_signs import UNKNOWN, ArraySigns

x, y, z, b = map(gs.symbol, ("x", "y", "z", "b"))
BACKENDS = ["numpy", "numba"]
mantissas = st.integers(-2**53, 2**53)
floats = st.one_of(
    st.builds(lambda m, e: math.ldexp(m, e - 53), mantissas, st.integers(-3, 3)),
    st.integers(-4, 4).map(float),
    st.builds(lambda m, e: math.ldexp(m, e - 53), mantissas, st.integers(-1074, 1020)),
    st.sampled_from([0.0, -0.0, 1.0, 5e-324, -5e-324, 1e200, -1e200, 1.7e308, 1e-200, 2.0**-1022]))
POLYNOMIALS = [x * y - z, (x + y) ** 2 - 4 * z, x**2 + y**2 - z**2, x - y, x, (x - y) ** 3 * z, x * y * z,
               3 * x - Rational(1, 3) * y + z,
               x**8 - y**7 * z, Integer(0) * x + 5, Integer(-3), x**2 * (y + z) ** 2,
               10**20 * x - (10**20 + 1) * y]


@given(expression=st.sampled_from(POLYNOMIALS),
       columns=st.lists(st.tuples(floats, floats, floats), min_size=1, max_size=6))
def test_signs_at_doubles_are_exact(expression, columns):
    """At doubles of every size, mixed, the sign is that of rational arithmetic; zero is found."""
    values = dict(zip("xyz", map(np.array, zip(*columns))))
    assert (signs_of(expression, values) == exactly(expression, values)).all()


@given(expression=st.sampled_from(POLYNOMIALS[:5]), data=st.data(), points=st.integers(1, 30))
def test_signs_on_grids_are_exact(expression, data, points):
    """The same along three axes, in blocks of 1 to 30 points, each as large as the expression varies."""
    values = {name: np.array(data.draw(st.lists(floats, min_size=1, max_size=4))).reshape(shape)
              for name, shape in zip("xyz", [(-1, 1, 1), (-1, 1), (-1,)])}
    grid = grid_of(values)
    found, truth = ArraySigns(expression, grid), exactly(expression, values).reshape(grid.merged)
    for tile in grid.blocks(points):
        for block in tile:
            with np.errstate(all="ignore"):
                here = np.broadcast_to(found(block), truth[block].shape[-2:])
            assert (here == truth[block].reshape(here.shape)).all()


@pytest.mark.slow
def test_backends_agree():
    """Numba gives the signs that NumPy gives."""
    source = np.random.default_rng(1)
    values = {"x": source.integers(-4, 5, (30, 1)) / 4, "y": source.integers(-4, 5, 40) / 4,
              "z": source.integers(0, 9, (30, 40)) / 16}
    for expression in POLYNOMIALS[:4]:
        assert (signs_of(expression, values, "numba", 300) == exactly(expression, values)).all()


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("side", [1, -1])
def test_signs_next_to_zero(backend, side):
    """At the doubles about a zero, nearly all numbers positive or nearly all negative, where what floats say
    is wrong as often as right.
    """
    source = np.random.default_rng(11)
    u, v = side * source.uniform(0.5, 1, 60), side * source.uniform(0.5, 1, 60)
    u[0] = v[0] = -side * 2.0**-20                     # the largest of them says nothing of their size
    ulps = np.arange(-3, 4)[:, None] * 2.0**-53
    for expression, near in ((x * y - z, u * v), ((x + y) ** 2 - 4 * z, (u + v) ** 2 / 4),
                             (x**3 * y - x * z, u * u * v),
                             ((x - y) * (x + y) - z, (u - v) * (u + v))):
        values = {"x": u, "y": v, "z": near + ulps * abs(near)}
        assert (signs_of(expression, values, backend, 10**4) == exactly(expression, values)).all()
    constant = np.full(40, side * 0.7)
    values = {"x": constant, "y": side * source.uniform(-1, 1, 40)[:, None],
              "z": 0.7 * source.uniform(-1, 1, 40)}
    assert (signs_of(x * y - z, values, backend, 10**4) == exactly(x * y - z, values)).all()


@given(columns=st.lists(st.tuples(floats, floats, floats), min_size=1, max_size=5),
       expression=st.sampled_from(POLYNOMIALS))
def test_one_bound_is_enough_for_all_points(columns, expression):
    """The one bound for a grid is no smaller than that of any of its points, whatever the signs of the
    numbers.
    """
    values = dict(zip("xyz", map(np.array, zip(*columns))))
    grid = grid_of(values)
    each = error_bound(program_of(expression, grid.axes), {gs.symbol(n): abs(v) for n, v in values.items()},
                       {})
    assert (ArraySigns(expression, grid).bound >= each).all()


@pytest.mark.parametrize("backend", BACKENDS)
def test_overflow_proves_nothing(backend):
    """∞ is no sign: x y z − w at factors of which two overflow and the third brings them back below w."""
    for order in ((1e200, 1e200, 1e-200), (1e200, 1e-200, 1e200), (1e-200, 1e200, 1e200)):
        for side in (1.0, -1.0):
            values = dict(zip("xyz", order)) | {"w": np.array([1e300, 1e100]) * side,
                                                "x": np.array([1.0, 1.0]) * order[0] * side}
            assert signs_of(x * y * z - gs.symbol("w"), values, backend).tolist() == [-side, side]


def test_a_rounded_number_is_not_taken_for_an_exact_one():
    """x = 1 + 1.25·2⁻⁵² is stored as 1 + 2⁻⁵².

    (x − y)² − z is positive at z = (1.1·2⁻⁵²)², of the doubles it is negative.
    """
    values = {"x": Fraction(5, 2**54) + 1, "y": np.ones(2), "z": np.array([1.1, 1.3]) ** 2 * 2.0**-104}
    assert signs_of((x - y) ** 2 - z, values).tolist() == [1, -1]


def test_what_cannot_be_proved_is_unknown():
    """Where no sign is proved, at NaN and infinities, and outside the domain of a function, the answer is
    UNKNOWN.
    """
    one = sin(1) ** 2 + cos(1) ** 2
    assert signs_of(x - y, {"x": one, "y": 1.0}) in (0, UNKNOWN)
    assert signs_of(log(x), {"x": np.array([-1.0, 0.0, 2.0])}).tolist() == [UNKNOWN, UNKNOWN, 1]
    assert signs_of(
        x - y, {"x": np.array([math.nan, math.inf, -math.inf, 1.0]), "y": 0.0}, finite=False
    ).tolist() == [UNKNOWN] * 3 + [1]
    assert (
        signs_of(
            x - y, {"x": np.full(3, math.inf), "y": np.array([math.inf, 0, -math.inf])}, finite=False
        ).tolist()
        == [UNKNOWN] * 3
    )


@pytest.mark.slow
def test_no_warning_escapes():
    """Overflow, underflow and ∞ − ∞ on the way are no warning of the caller's."""
    for backend in BACKENDS:
        for expression, u, v in ((x * y - x, 1e200, 1e200), (x - y, math.inf, math.inf),
                                 (x * y, 1e-200, 1e-200), (x * y, 0.0, math.inf)):
            grid = grid_of({"x": np.array([u, 1.0, 2.0]), "y": np.array([v, 3.0, 1.0])}, finite=False)
            with np.errstate(all="raise"):
                ArraySigns(expression, grid, backend)(grid.blocks(10)[0][0])


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_floats_decide_ordinary_grids(monkeypatch, backend):
    """No point of an ordinary grid is decided exactly, with one outlier of 10¹⁴⁰ in it neither."""
    monkeypatch.setattr(arraysigns, "ExactSign", None)
    for outlier in (1.0, 1e140):
        values = {"x": np.append(np.linspace(0.1, 1, 200), outlier)[:, None],
                  "y": np.linspace(0.13, 1.17, 300), "z": 0.12345}
        found = signs_of(x * y - z, values, backend, 10**5)
        assert set(np.unique(found)) == {-1, 1}
    values = {"x": np.array([1e8, 2.0**27])[:, None], "y": -1e8 - np.arange(1, 9) / 64, "z": 1e-3}
    # sums of exact numbers lose no digits
    assert set(np.unique(signs_of((x + y) ** 2 - z, values, backend))) == {-1, 1}


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_filter_that_never_suffices_changes_nothing(monkeypatch, backend):
    """With e = ∞ all points are decided exactly, the same."""
    values = {"x": np.arange(-3, 4.0)[:, None], "y": np.arange(-3, 4.0), "z": 2.0}
    expected = signs_of(x * y - z, values, backend)
    monkeypatch.setattr(arraysigns, "error_bound", lambda *given: np.float64(np.inf))
    assert (signs_of(x * y - z, values, backend) == expected).all()
    assert (expected == exactly(x * y - z, values)).all()
