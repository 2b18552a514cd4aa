"""Compiled margins: the values of the formula, bit for bit or within the proved bound, whatever the shapes,
blocks and backends.
"""
import math
from fractions import Fraction
from itertools import product

import array_api_strict
import numpy as np
import pytest
from charts.drawn_margins import drawn, shapes, vertical
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, cos, exp, log, sin, sqrt

import gyrostat as gs
from gyrostat.charts.programs.rounding import error_bound
from gyrostat.charts.programs.straightline import program_of
from gyrostat.charts.signs import compiled_margins
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.stability.criteria.conditions import Condition, Criterion

x, y, z, b = map(gs.symbol, ("x", "y", "z", "b"))
BACKENDS = ["numpy", "numba"]
E1_NAMES = ("I1", "dU", "l", "pi3_0")


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("shapes", [((), (), (7,), ()), ((), (), (13, 1), (15,)), ((), (5, 7), (5, 1), (7,)),
                                    ((8,), (8,), (8,), (8,)),
                                    ((3, 1, 1, 1), (4, 1, 1), (5, 1), (6,)),
                                    ((2, 1, 3, 1, 2), (1, 4, 1, 1, 1), (2,), ()),
                                    ((1, 1), (), (1,), (1, 1, 1)), ((), (3, 0), (1,), (3, 1)),
                                    ((), (), (0,), ()), ((), (), (), ())])
def test_values_are_those_of_the_formula(e1, tiny_blocks, backend, shapes):
    """E1: bit for bit the formula in NumPy, in blocks of seven points, for one to five axes, of length 1 and
    0 too.
    """
    values = drawn(E1_NAMES, shapes)
    ((condition,),) = e1.sufficient.alternatives
    found = compile_margin(condition, backend)(**values)
    expected = vertical(**values)
    assert found.dtype == np.float64 and np.shape(found) == np.shape(expected)
    assert np.array_equal(found, expected)


@given(drawn_shapes=shapes, seed=st.integers(0, 99), threads=st.sampled_from([1, 2]))
def test_blocks_have_no_seams(e1, drawn_shapes, seed, threads):
    """Any shapes that broadcast, in blocks of seven points, on one thread or two."""
    values = drawn(E1_NAMES, drawn_shapes.input_shapes, seed)
    ((condition,),) = e1.sufficient.alternatives
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled_margins, "NUMPY_BLOCK", 7)
        found = compile_margin(condition)(threads=threads, **values)
    assert found.shape == drawn_shapes.result_shape and np.array_equal(found, vertical(**values))


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", BACKENDS)
def test_values_are_within_the_bound(tilted_margin, backend):
    """E3: abs(value − exact value) is at most the proved bound, in Fractions, where terms cancel too."""
    source = np.random.default_rng(5)
    names = ("I1", "I3", "d2U", "k3", "l", "omega")
    values = {name: source.integers(-2**20, 2**20, 300) * 2.0 ** source.integers(-24, -16, 300)
              for name in names}
    values["d2U"] = np.linspace(-1, 1, 300)
    found, margin = compile_margin(tilted_margin, backend)(**values), tilted_margin.margin
    program = program_of(margin, dict.fromkeys(margin.free_symbols, frozenset({1})))
    bound = error_bound(program, {gs.symbol(n): abs(v) for n, v in values.items()}, {})
    for n in range(300):
        I1, I3, c, k, l, w = (Fraction(values[name][n]) for name in names)
        exact = (
            I1 * (1 - k * k) * c
            - 2 * I1 * k * (w * l - w * w * k * (I1 - I3))
            + I1**2 * w**2
            + ((I1 - I3) * w * k - l) ** 2
        )
        assert abs(Fraction(found[n]) - exact) <= Fraction(bound[n])


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_nothing_is_lost_at_the_default_block(e1, backend):
    """A grid of several blocks of the real size, of odd shape."""
    values = drawn(E1_NAMES, [(), (1,), (1031, 1), (1033,)])
    ((condition,),) = e1.sufficient.alternatives
    assert np.array_equal(compile_margin(condition, backend)(**values), vertical(**values))


def truth(criterion, values):
    """Where a criterion holds, point by point, in Fractions."""
    result = np.empty(np.broadcast_shapes(*(v.shape for v in values.values())), dtype=bool)
    full = {gs.symbol(n): np.broadcast_to(v, result.shape) for n, v in values.items()}

    def holds(condition, point):
        margin, factors = condition.margin.xreplace(point), [f.xreplace(point) for f in condition.degenerate]
        return (
            margin > 0 and all(f != 0 for f in factors)
            if condition.strict
            else margin >= 0 or any(f == 0 for f in factors)
        )

    for index in np.ndindex(result.shape):
        point = {s: Rational(a[index].item()) for s, a in full.items()}
        result[index] = any(all(holds(c, point) for c in group) for group in criterion.alternatives)
    return result


def small(names, seed):
    """Small integers along three axes: margins are exact, and often 0."""
    source = np.random.default_rng(seed)
    sides = [(3, 1, 1), (2, 1), (4,)]
    return {n: source.integers(1 if n.startswith("I") else -2, 4, sides[i % 3]) for i, n in enumerate(names)}


@pytest.mark.slow
@pytest.mark.parametrize(("which", "compiled"), [
    ("e1", True), ("uniform_tilt", True), ("free_body", True), ("e2", False), ("at_rest", False),
    ("general", False), *(pytest.param(which, True, marks=pytest.mark.slow)
                          for which in ("e2", "at_rest", "general"))])
def test_criteria_hold_where_they_hold(request, tiny_blocks, which, compiled):
    """Several conditions, strict or not, alternatives and even factors, at small integers, where floats are
    exact, by every backend.
    """
    report = request.getfixturevalue(which)
    for criterion, seed in product((report.sufficient, report.necessary, report.casimirs_only), range(2)):
        expected = None
        for backend in ("numpy", array_api_strict, *["numba"] * compiled):
            stable = compile_margin(criterion, backend)
            values = small(stable.names, seed)
            expected = truth(criterion, values) if expected is None else expected
            given_arrays = {n: v.astype(float) for n, v in values.items()}
            if backend is array_api_strict:
                given_arrays = {n: array_api_strict.asarray(v) for n, v in given_arrays.items()}
            found = np.asarray(stable(**given_arrays))
            assert found.dtype == bool and np.array_equal(np.broadcast_to(found, expected.shape), expected)


@pytest.mark.parametrize("backend", BACKENDS)
def test_criteria_with_degenerate_factors_and_none(uniform_tilt, backend):
    """1 > 0 and l ≠ 0 is l ≠ 0; the empty disjunction never holds, the empty conjunction always."""
    found = compile_margin(uniform_tilt.sufficient, backend)(l=np.array([-1.0, 0.0, 2.0]))
    assert found.tolist() == [True, False, True]
    for alternatives, holds in (((), False), (((),), True)):
        compiled = compile_margin(Criterion("formal", alternatives), backend)
        assert compiled.names == () and bool(compiled()) is holds and compiled().dtype == bool


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", [*BACKENDS, array_api_strict])
@pytest.mark.parametrize("strict", [True, False])
def test_even_factors(backend, strict):
    """Where an even factor vanishes a strict condition fails and the other holds, whatever the margin.

    Alternatives and conjunctions.
    """
    one, other = (Condition(m, strict, "", f, x**0) for m, f in ((x - 1, (y, z)), (y + z, ())))
    for groups in (((one,),), ((one, other),), ((one,), (other,))):
        compiled = compile_margin(Criterion("", groups), backend)
        values = {n: np.arange(-2.0, 3).reshape([-1, *[1] * i]) for i, n in enumerate(compiled.names)}
        given_arrays = values if isinstance(backend, str) else {n: array_api_strict.asarray(v)
                                                                for n, v in values.items()}
        assert np.array_equal(np.asarray(compiled(**given_arrays)), truth(Criterion("", groups), values))


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_condition_is_its_margin_a_criterion_a_truth(e1, backend):
    """Condition and Expr give values, Criterion gives booleans; all take the same names."""
    ((condition,),) = e1.sufficient.alternatives
    values = drawn(E1_NAMES, [(3, 1), (), (), (4,)])
    from_condition, from_margin = (compile_margin(what, backend)(**values)
                                   for what in (condition, condition.margin))
    stable = compile_margin(e1.sufficient, backend)
    assert stable.names == E1_NAMES == compile_margin(condition.margin, backend).names
    assert stable.backend == backend
    assert np.array_equal(from_condition, from_margin) and np.array_equal(stable(**values), from_margin > 0)
    assert np.array_equal(compile_margin(e1.necessary, backend)(**values), from_margin >= 0)


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("threads", [2, 3])
def test_threads_change_nothing(e1, tiny_blocks, backend, threads):
    """Two and three threads write what one writes."""
    for what in (e1.sufficient, e1.sufficient.alternatives[0][0]):
        compiled, values = compile_margin(what, backend), drawn(E1_NAMES, [(3, 1, 1), (), (11, 1), (13,)])
        assert np.array_equal(compiled(threads=threads, **values), compiled(**values))


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_no_warning_escapes(e1, backend):
    """Overflow to ∞, underflow, ∞ − ∞ and poles are values, not warnings of the caller's."""
    margin = compile_margin(e1.sufficient.alternatives[0][0], backend)
    with np.errstate(all="raise"):
        found = margin(I1=np.array([1.0, 1e200, 1e-200]), dU=np.array([1.0, 1e200, 1e-200]), l=1e200,
                       pi3_0=0.0)
        assert found[0] == math.inf and math.isnan(found[1]) and found[2] == math.inf
        single = margin(I1=1e300, dU=1.0, l=np.zeros(2, dtype=np.float32), pi3_0=np.ones(2, dtype=np.float32))
        assert single.dtype == np.float32 and (single == -np.inf).all()
        assert compile_margin(exp(1 / x) * y, backend)(x=np.array([0.0, 1.0]), y=1.0)[1] == math.e
        assert compile_margin(log(x) * y, backend)(x=np.array([0.0, 1.0]), y=1.0)[0] == -math.inf


LEAVES = [(exp(b * x) * y - z, lambda b, x, y, z: np.exp(b * x) * y - z),
          (sqrt(x) * y, lambda x, y: np.sqrt(x) * y),
          (sin(x) * y + cos(x) * z, lambda x, y, z: np.sin(x) * y + np.cos(x) * z),
          (x ** Rational(3, 2) * y, lambda x, y: x**1.5 * y),
          (log(x + y) * z, lambda x, y, z: np.log(x + y) * z), (y / x, lambda x, y: y / x),
          (y / x**2, lambda x, y: y / x**2)]


@pytest.mark.few(1)
@pytest.mark.parametrize(("expression", "formula"), LEAVES, ids=[str(e) for e, _ in LEAVES])
@pytest.mark.parametrize("backend", [*BACKENDS, array_api_strict])
def test_functions_are_those_of_the_namespace(tiny_blocks, expression, formula, backend):
    """Functions and roots in grids: close to the formula."""
    compiled = compile_margin(expression, backend)
    values = drawn(compiled.names, [(3, 1, 1), (2, 1), (5,), ()])
    given_arrays = values if isinstance(backend, str) else {n: array_api_strict.asarray(v)
                                                            for n, v in values.items()}
    # a few roundings; the order of the operations may be another
    np.testing.assert_allclose(np.asarray(compiled(**given_arrays)), formula(**values), rtol=1e-14,
                               atol=1e-15)


def test_inverse_functions_are_found_under_either_name():
    """asin is arcsin in older namespaces, and so on."""
    from sympy import acos, acosh, asin, asinh, atan, atanh
    for function, value in ((asin, 0.5), (acos, 0.5), (atan, 0.5), (asinh, 0.5), (atanh, 0.5), (acosh, 1.5)):
        expected = float(function(value))
        # one or two roundings
        assert compile_margin(function(x) * y)(x=np.array([value]), y=1.0)[0] == pytest.approx(
            expected, rel=1e-15
        )
