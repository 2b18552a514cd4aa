"""Codes of two criteria over a grid: by one loop for all margins, and by the signs of each."""
import operator
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational

import gyrostat as gs
from gyrostat.charts.codes import STABLE, UNSTABLE
from gyrostat.charts.grids import grid_of
from gyrostat.charts.programs import kernels
from gyrostat.charts.signs.criteria_codes import OPEN, CriteriaCodes
from gyrostat.stability.criteria.conditions import Condition, Criterion
from gyrostat.stability.criteria.truth import truth
from gyrostat.stability.notion import Notion

x, y, a = map(gs.symbol, ("x", "y", "a"))
MARGINS = (x + y - 1, x**2 - y, x * y + 2, y - 3 * x, x - y, x, 1 + x**2, (x - 1)**2 - y)
FACTORS = (x - y, y - 1, x * y)
FEW = [-2.0, -1.0, 0.0, 0.5, 1.0, 2.0, 3.0]
conjunctions = st.lists(st.tuples(st.sampled_from(MARGINS), st.lists(st.sampled_from(FACTORS), max_size=2)),
                        max_size=3)
disjunctions = st.lists(conjunctions, max_size=2)


def criterion(notion, alternatives):
    return Criterion(notion, tuple(
        tuple(Condition(margin, notion is Notion.FORMAL, "", tuple(factors), Rational(1))
              for margin, factors in conditions) for conditions in alternatives))


def codes_of(sufficient, necessary, values, backend, named=None):
    grid = grid_of(values)
    found, out = CriteriaCodes(sufficient, necessary, grid, backend, named), np.full(grid.merged, 9, np.int8)
    with np.errstate(all="ignore"):
        decided = found(grid.whole, out)
    assert decided == bool((abs(out) == 1).all())
    return out.reshape(grid.shape)


def exactly(sufficient, necessary, here):
    def compare(expression, relation):
        return relation(expression.subs(here), 0) == True  # noqa: E712

    if truth(sufficient, compare, all, any):
        return STABLE
    return OPEN if truth(necessary, compare, all, any) else UNSTABLE


@pytest.mark.slow
@given(sufficient=disjunctions, necessary=disjunctions)
def test_codes_are_what_the_criteria_say(sufficient, necessary):
    """At every point, on the zeros of margins and of even factors, too."""
    pair = criterion(Notion.FORMAL, sufficient), criterion(Notion.SPECTRAL, necessary)
    found = codes_of(*pair, {"x": np.array(FEW)[:, None], "y": np.array(FEW)}, "numpy")
    assert found.tolist() == [[exactly(*pair, {x: Rational(u), y: Rational(v)}) for v in FEW] for u in FEW]


@pytest.mark.slow
@pytest.mark.parametrize(("sufficient", "necessary"), [
    ([[(x + y - 1, (x - y,)), (x * y + 2, ())]], [[(x**2 - y, ()), (x + y - 1, (x - y,))]]),
    ([[(x, ())], [(x - y, (y - 1,))]], [[(y - 3 * x, (x * y,))], [(x, ()), (x - y, ())]]),
    ([[]], []), ([], [[(x - y, (x * y, y - 1))]]), ([[(x - y, ())]], [[(x - y, ())]])])
def test_one_loop_says_the_same(sufficient, necessary):
    """With alternatives, even factors, and margins that both criteria have."""
    pair = criterion(Notion.FORMAL, sufficient), criterion(Notion.SPECTRAL, necessary)
    found = codes_of(*pair, {"x": np.array(FEW)[:, None], "y": np.array(FEW)}, "numba")
    assert found.tolist() == [[exactly(*pair, {x: Rational(u), y: Rational(v)}) for v in FEW] for u in FEW]


@pytest.mark.slow
def test_doubles_decide_in_one_loop(monkeypatch):
    """Beside the zeros no sign of a single margin is asked; the second stage is done where it has to be."""
    pair = criterion(Notion.FORMAL, [[(x + y - 1, ())]]), criterion(Notion.SPECTRAL, [[(x**2 - y, ())]])
    values = {"x": np.linspace(-2, 2, 41)[:, None] + 1 / 64, "y": np.linspace(-2, 2, 700) + 1 / 128}
    expected = codes_of(*pair, values, "numpy")
    monkeypatch.setattr(CriteriaCodes, "_by_signs", None)
    found = codes_of(*pair, values, "numba")
    assert (found == expected).all() and {STABLE, UNSTABLE, OPEN} == set(np.unique(found))
    monkeypatch.setattr(kernels, "RUN", 13)
    assert (codes_of(*pair, values, "numba") == expected).all()


@pytest.mark.slow
def test_a_number_that_is_not_finite_proves_nothing():
    """Its code is UNKNOWN by every way."""
    pair = criterion(Notion.FORMAL, [[(x + y - 1, ())]]), criterion(Notion.SPECTRAL, [[(x - y, ())]])
    values = {"x": np.array([[np.nan], [np.inf], [3.0]]), "y": np.array([0.0, 1.0])}
    grid = grid_of(values, finite=False)
    for backend in ("numpy", "numba"):
        out = np.empty(grid.merged, np.int8)
        with np.errstate(all="ignore"):
            CriteriaCodes(*pair, grid, backend)(grid.whole, out)
        assert out.tolist() == [[2, 2], [2, 2], [1, 1]]


class Named:
    """a = (x − y)/(1 + x²)"""

    def values(self, number):
        return {a: number((x - y) / (1 + x**2))}


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", ["numpy", "numba"])
def test_named_numbers_decide_like_what_they_name(backend):
    """With doubles, with fractions that are no doubles, and with numbers that are not rational."""
    named = Named()
    pair = criterion(Notion.FORMAL, [[(a, ())]]), criterion(Notion.SPECTRAL, [[(a + x - y, ())]])
    written = criterion(Notion.FORMAL, [[(x - y, ())]]), criterion(Notion.SPECTRAL, [[(x - y, ())]])
    third, near = Fraction(1, 3), 1 / 3
    for some in (FEW, [third, near, Fraction(near) + Fraction(1, 2**80)]):
        values = {"x": np.array(some, dtype=None if some is FEW else object)[:, None],
                  "y": np.array(some, dtype=None if some is FEW else object)}
        found = codes_of(*pair, values, backend, named)
        assert (found == codes_of(*written, values, backend)).all()
        assert found.tolist() == [[operator.gt(u, v) - operator.lt(u, v) for v in some] for u in some]
