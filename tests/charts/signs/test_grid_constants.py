"""Numbers that are the same at all points, put into a long margin: a polynomial of the same sign."""
import random

import numpy as np
import pytest
from rotation_families import LINEAR
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign
from gyrostat.charts.grids import grid_of
from gyrostat.charts.programs.straightline import Writer, _program, program_of
from gyrostat.charts.signs.grid_constants import LONG, with_constants

U1, U2, OMEGA, SIGMA = map(gs.symbol, ("u1", "u2", "omega", "sigma"))


@pytest.fixture(scope="module")
def margins():
    scene = gs.assemble(gs.Gyrostat((3, 2, "5/2"), (Rational(1, 3), Rational(1, 5), Rational(1, 2))),
                        gs.general_potential(LINEAR))
    report = gs.analyze(gs.permanent_rotation(scene, gs.stereographic())).written_out
    return [c.margin for criterion in (report.sufficient, report.necessary)
            for c in criterion.alternatives[0]]


@pytest.mark.slow
@pytest.mark.parametrize("numbers", [{"omega": "1/3", "sigma": "-1/10"}, {"omega": 0.3, "sigma": -0.1},
                                     {"omega": 1e-9, "sigma": "7/3"}, {"omega": sqrt(2), "sigma": 3}])
def test_the_sign_is_the_same(margins, numbers):
    """Of rationals, doubles and one that is neither and stays a name; at points on a boundary 0."""
    rng, grid = random.Random("constants"), grid_of({**numbers, "u1": np.zeros(2), "u2": np.zeros((2, 1))})
    exact = {gs.symbol(name): grid.exact[gs.symbol(name)].item() if gs.symbol(name) in grid.exact
             else Rational(*grid.values[gs.symbol(name)].item().as_integer_ratio()) for name in numbers}
    seen, changed = set(), 0
    for margin in margins:
        short = with_constants(margin, grid)
        changed += short is not margin
        if short is not margin:
            left = {OMEGA} if numbers["omega"] == sqrt(2) else set()
            assert short.free_symbols & {OMEGA, SIGMA} == left & margin.free_symbols
        for _ in range(8):
            place = {u: Rational(rng.randint(-9, 9), rng.randint(1, 5)) for u in (U1, U2)}
            found = sign(short, exact | place)
            assert found == sign(margin, exact | place)
            seen.add(found)
    assert {-1, 1} <= seen and changed >= 3


def test_a_short_margin_stays_as_it_is():
    """And a long one where nothing is the same at all points."""
    x, y = gs.symbol("x"), gs.symbol("y")
    grid = grid_of({"x": 2, "y": np.zeros(3)})
    assert with_constants(margin := (x + y)**2 - x, grid) is margin
    long = sum(x**n * y**(n % 7) for n in range(LONG + 2))
    assert with_constants(long, grid).free_symbols == {y}
    assert with_constants(long, grid_of({"x": np.zeros(3), "y": np.zeros((2, 1))})) is long


def test_coefficients_that_are_too_long_are_left():
    """Of doubles to high powers, beyond the range of doubles."""
    x, y = gs.symbol("x"), gs.symbol("y")
    long = sum(x**n * y**n for n in range(LONG + 2)) - 1
    assert with_constants(long, grid_of({"x": 0.3, "y": np.zeros(3)})) is long
    assert with_constants(long, grid_of({"x": "3/10", "y": np.zeros(3)})).free_symbols == {y}


@pytest.mark.slow
def test_a_sum_is_folded_as_if_all_pairs_were_compared(margins, monkeypatch):
    """Step by step the same program."""
    axes = {U2: frozenset({0}), U1: frozenset({1})}
    short = with_constants(margins[0], grid_of({"omega": 1, "sigma": -2, "u1": np.zeros(2)}))
    ours = program_of(short, axes)
    monkeypatch.setattr(Writer, "_candidates", lambda self, terms: range(len(terms)))
    _program.cache_clear()
    assert program_of(short, axes) == ours
