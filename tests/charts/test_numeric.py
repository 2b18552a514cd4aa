"""Compiled margins: the values of the formula, bit for bit or within the proved bound, whatever the shapes,
blocks and backends.
"""
import builtins
import math
import os
import subprocess
import sys
import tracemalloc
from fractions import Fraction
from itertools import product

import array_api_strict
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from sympy import Integer, Rational, Symbol, cos, exp, log, pi, sin, sqrt

import gyrostat as gs
from gyrostat.charts import kernels, numeric
from gyrostat.charts.numeric import compile_margin
from gyrostat.charts.rounding import error_bound
from gyrostat.charts.straightline import program_of
from gyrostat.errors import ArgumentError, GyrostatError, MissingExtraError, ValuesError
from gyrostat.stability.conditions import Condition, Criterion

x, y, z, b = map(gs.symbol, ("x", "y", "z", "b"))
BACKENDS = ["numpy", "numba"]
E1_NAMES = ("I1", "dU", "l", "pi3_0")
shapes = arrays.mutually_broadcastable_shapes(num_shapes=4, max_dims=5, min_side=0, max_side=4)


@pytest.fixture
def tiny_blocks(monkeypatch):
    """Blocks of seven points."""
    monkeypatch.setattr(numeric, "NUMPY_BLOCK", 7)
    monkeypatch.setattr(numeric, "NUMBA_BLOCK", 7)


@pytest.fixture(scope="module")
def tilted_margin(e3):
    ((condition,),) = e3.sufficient.alternatives
    return condition


@pytest.fixture(scope="module")
def free_body(free):
    return gs.analyze(gs.principal_rotation(free, 3))


@pytest.fixture(scope="module")
def uniform_tilt():
    """At rest in the uniform field: m0 = 0, stable where l ≠ 0."""
    return gs.analyze(gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


def vertical(I1, dU, l, pi3_0):
    """(π3 + l)² − 4 I1 U', with the same operations."""
    P = l + pi3_0
    return P * P - 4.0 * I1 * dU


def drawn(names, shapes, seed=0):
    source = np.random.default_rng(seed)
    return {name: source.uniform(0.2, 0.8, size=shape) for name, shape in zip(names, shapes)}


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
        patch.setattr(numeric, "NUMPY_BLOCK", 7)
        found = compile_margin(condition)(threads=threads, **values)
    assert found.shape == drawn_shapes.result_shape and np.array_equal(found, vertical(**values))


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


@pytest.mark.parametrize("backend", BACKENDS)
def test_scalars_and_constants(e1, backend):
    """Numbers give a NumPy number; a margin that is a constant takes no names.

    Exact numbers are rounded once.
    """
    ((condition,),) = e1.sufficient.alternatives
    value = compile_margin(condition, backend)(I1=1, dU=Fraction(1, 4), l="1/2", pi3_0=np.float32(0.5))
    assert isinstance(value, np.float64) and value == 0
    assert isinstance(compile_margin(e1.necessary, backend)(I1=1, dU=1, l=1, pi3_0=1), np.bool_)
    assert compile_margin(Integer(-3), backend)() == -3 and compile_margin(Rational(1, 3), backend)() == 1 / 3
    assert compile_margin(sqrt(2) * x, backend)(x=np.ones((2, 3))).tolist() == [[math.sqrt(2)] * 3] * 2
    assert compile_margin(pi * x, backend)(x=2) == 2 * math.pi


@pytest.mark.parametrize("backend", BACKENDS)
def test_out_is_written_to(e1, backend):
    """out is filled and returned; scalars fill an array without axes."""
    stable, margin = compile_margin(e1.sufficient,
                                    backend), compile_margin(e1.sufficient.alternatives[0][0], backend)
    values = drawn(E1_NAMES, [(3, 1), (), (), (4,)])
    for compiled, kind in ((stable, bool), (margin, float)):
        out = np.empty((3, 4), dtype=kind)
        assert compiled(out=out, **values) is out and np.array_equal(out, compiled(**values))
        nothing = np.empty((), dtype=kind)
        scalars = {n: float(v.ravel()[0]) for n, v in values.items()}
        assert compiled(out=nothing, **scalars) is nothing and nothing == compiled(**scalars)


def read_only():
    array = np.empty((3, 4))
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(("out", "said"), [
    (np.empty((4, 3)), r"shape \(4, 3\).*has shape \(3, 4\)"),
    (np.empty((3, 4), dtype=np.float32), "float32"),
    (np.empty((4, 3)).T, "C-contiguous"), (np.empty(12), r"\(12,\)"),
    (np.empty((3, 4), dtype=int), "int64"), ([[0.0] * 4] * 3, "out"), (read_only(), "out")],
    ids=["shape", "float32", "Fortran order", "flat", "int", "list", "read-only"])
def test_out_that_does_not_fit_is_refused(e1, out, said):
    """out of another shape, type or order, or that cannot be written, is a ValuesError or ArgumentError."""
    with pytest.raises(GyrostatError, match=said):
        compile_margin(e1.sufficient.alternatives[0][0])(out=out, **drawn(E1_NAMES, [(3, 1), (), (), (4,)]))


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("threads", [2, 3])
def test_threads_change_nothing(e1, tiny_blocks, backend, threads):
    """Two and three threads write what one writes."""
    for what in (e1.sufficient, e1.sufficient.alternatives[0][0]):
        compiled, values = compile_margin(what, backend), drawn(E1_NAMES, [(3, 1, 1), (), (11, 1), (13,)])
        assert np.array_equal(compiled(threads=threads, **values), compiled(**values))


@pytest.mark.parametrize("backend", BACKENDS)
def test_single_precision(e1, backend):
    """float32 throughout, with numbers, gives float32, each operation rounded to it.

    One float64 array gives float64.
    """
    ((condition,),) = e1.sufficient.alternatives
    compiled, values = compile_margin(condition, backend), drawn(E1_NAMES, [(), (), (5, 1), (6,)])
    single = {n: v.astype(np.float32) if np.ndim(v) else v for n, v in values.items()}
    found = compiled(**single)
    f = {n: np.float32(v) for n, v in single.items()}
    P = f["l"] + f["pi3_0"]
    assert found.dtype == np.float32 and np.array_equal(found, P * P - np.float32(4) * f["I1"] * f["dU"])
    assert compiled(**single | {"l": values["l"]}).dtype == np.float64
    assert compiled(**{n: float(np.ravel(v)[0]) for n, v in values.items()}).dtype == np.float64
    assert compile_margin(e1.sufficient, backend)(**single).dtype == bool


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


def test_another_namespace_gives_its_arrays(e1):
    """array_api_strict in, array_api_strict out; the values are those of NumPy."""
    ((condition,),) = e1.sufficient.alternatives
    values = drawn(E1_NAMES, [(3, 1), (), (), (4,)])
    compiled = compile_margin(condition, array_api_strict)
    found = compiled(**{n: array_api_strict.asarray(v) for n, v in values.items()})
    assert isinstance(found, type(array_api_strict.asarray(1.0))) and compiled.backend == "array_api_strict"
    assert np.array_equal(np.asarray(found), vertical(**values))


def test_another_namespace_takes_numbers(e1):
    """Numbers beside arrays, integers too, are taken as floats."""
    ((condition,),) = e1.sufficient.alternatives
    l = array_api_strict.asarray([1.0, 2.0])
    assert np.asarray(compile_margin(condition, array_api_strict)(I1=1, dU=2, l=l, pi3_0=0.5)).tolist() == [
        1.5**2 - 8,
        2.5**2 - 8,
    ]


def test_another_namespace_keeps_single_precision(e1):
    """float32 throughout gives float32 there too."""
    ((condition,),) = e1.sufficient.alternatives
    single = {n: array_api_strict.asarray(v, dtype=array_api_strict.float32)
              for n, v in drawn(E1_NAMES, [(3,)] * 4).items()}
    assert compile_margin(condition, array_api_strict)(**single).dtype == array_api_strict.float32


@pytest.mark.parametrize(("arrays", "said"), [
    ({"I1": 1, "dU": 1, "l": 1}, "this margin needs pi3_0: give"),
    ({"I1": 1, "dU": 1, "l": 1, "pi3_0": 1, "q": 2}, "no parameter q"),
    ({"I1": 1, "dU": 1, "l": 1, "pi30": 1}, r"no parameter pi30: did you mean pi3_0\?"),
    ({}, "needs I1, dU, l, pi3_0"),
    ({"I1": 1, "dU": 1, "l": [1, 2], "pi3_0": [1, 2, 3]}, r"do not broadcast: l \(2,\), pi3_0 \(3,\)"),
    ({"I1": 1, "dU": 1, "l": [1, math.nan], "pi3_0": 1}, r"l\[1\] = nan"),
    ({"I1": "x", "dU": 1, "l": 1, "pi3_0": 1}, "I1 = x contains")])
def test_what_is_wrong_with_the_arrays_is_named(e1, arrays, said):
    """Missing and unknown names, numbers and shapes."""
    with pytest.raises(ValuesError, match=said):
        compile_margin(e1.sufficient.alternatives[0][0])(**arrays)


@pytest.mark.parametrize(("what", "backend", "said"), [
    (x, "jax", "backend = 'jax' is none"), (3, "numpy", "is a int"), ("x", "numpy", "is a str"),
    (None, "numba", "is a NoneType")])
def test_what_cannot_be_compiled_is_named(what, backend, said):
    """ArgumentError for other backends and other things to compile."""
    with pytest.raises(ArgumentError, match=said):
        compile_margin(what, backend)


def test_symbols_are_matched_by_name():
    """An expression in symbols of another make is taken in ours, as everywhere, or refused."""
    try:
        found = compile_margin(Symbol("x") ** 2)(x=np.arange(3.0))
    except GyrostatError:
        return
    assert found.tolist() == [0, 1, 4]


def peak(call):
    """The result, and the most memory that was allocated at one time."""
    call()                                             # what is remembered is not counted
    tracemalloc.start()
    try:
        result = call()
        return result, tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("shapes", [((1500, 1), (1500,), ()), ((10**6,), (10**6,), ()),
                                    ((1000, 1, 1), (1000, 1), (2,)),
                                    ((2, 1, 1), (1000, 1), (1000,)), ((3000, 1), (700,), (3000, 1)),
                                    ((2, 1), (10**6,), ())])
def test_memory_is_less_than_twice_the_result(tilted_margin, shapes):
    """A chart of some million points allocates less than twice its result, also for (n, m, 2) and (2, n, m).
    """
    values = {"I1": 1.0, "I3": 0.5, "l": 0.25} | drawn(("k3", "d2U", "omega"), shapes)
    result, most = peak(lambda: compile_margin(tilted_margin)(**values))
    assert most < 2 * result.nbytes


def test_numba_is_numpy(tilted_margin, tiny_blocks):
    """E3 on grids of several kinds: the same bits, products and sums are not contracted."""
    for shapes in ([(), (), (), (23, 1), (), (29,)], [(), (1,), (3, 1, 1), (5, 1), (), (7,)]):
        values = drawn(("I1", "I3", "d2U", "k3", "l", "omega"), shapes)
        assert np.array_equal(compile_margin(tilted_margin, "numba")(**values),
                              compile_margin(tilted_margin)(**values))


SCRIPT = """
import numpy as np, gyrostat as gs
from gyrostat.charts.numeric import compile_margin
x, y = gs.symbol("x"), gs.symbol("y")
compiled = compile_margin((x + y)**2 - 3*x*y - 5, "numba")
before = compiled.compile_seconds
value = compiled(x=np.arange(4.0)[:, None], y=np.arange(5.0))
first = compiled.compile_seconds
compiled(x=np.arange(4.0)[:, None], y=np.arange(5.0))
import gc, numba
compile_margin(x*y - x, "numba")(x=np.arange(4.0)[:, None], y=np.arange(5.0))
kernels = [f for f in gc.get_objects() if isinstance(f, numba.core.registry.CPUDispatcher)
           and f.py_func.__module__.startswith("gyrostat_kernel")]
hits = sum(sum(f.stats.cache_hits.values()) for f in kernels)
print(before, first > 0, compiled.compile_seconds == first, hits, float(value.sum()))
"""


def other_process(tmp, **environment):
    env = {k: v for k, v in os.environ.items() if not k.startswith("NUMBA_")} | environment
    run = subprocess.run([sys.executable, "-W", "error", "-c", SCRIPT], capture_output=True, text=True,
                         env=env, cwd=tmp, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout.split()


@pytest.mark.slow
def test_compiled_code_is_kept_on_disk(tmp_path):
    """A second process reads from the cache folder what the first compiled.

    Compiling counts as seconds, once.
    """
    env = {"XDG_CACHE_HOME": str(tmp_path / "cache"), "PYTHONPATH": os.pathsep.join(sys.path)}
    first = other_process(tmp_path, **env)
    files = {p: p.stat().st_mtime_ns for p in (tmp_path / "cache" / "gyrostat").rglob("*") if p.is_file()}
    second = other_process(tmp_path, **env)
    assert first == ["0", "True", "True", "0", "30.0"] and second == ["0", "True", "True", "2", "30.0"]
    assert any(p.suffix == ".nbc" for p in files) and not [p for p in files if p.suffix == ".tmp"]
    assert files == {p: p.stat().st_mtime_ns for p in files}


@pytest.mark.slow
def test_a_cache_that_cannot_be_written_does_no_harm(tmp_path):
    """Where the folder cannot be made, a folder of the process is used."""
    (tmp_path / "file").write_text("no folder")
    env = {"XDG_CACHE_HOME": str(tmp_path / "file"), "PYTHONPATH": os.pathsep.join(sys.path)}
    assert other_process(tmp_path, **env)[-1] == "30.0"


def test_a_home_that_is_not_known_does_no_harm(monkeypatch):
    """Without XDG_CACHE_HOME and without a home, too."""
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)

    def nowhere():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(kernels.Path, "home", nowhere)
    kernels._folder.cache_clear()
    try:
        assert kernels._folder().is_dir()
    finally:
        kernels._folder.cache_clear()


def test_numba_is_optional(monkeypatch, e1):
    """Without Numba the error says what to install; NumPy goes on."""
    real = builtins.__import__

    def absent(name, *given, **more):
        if name.split(".")[0] == "numba":
            raise ImportError("No module named 'numba'")
        return real(name, *given, **more)

    for module in [m for m in sys.modules if m.split(".")[0] == "numba"]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setattr(builtins, "__import__", absent)
    monkeypatch.setitem(sys.modules, "numba", None)    # what import_module sees
    with pytest.raises(MissingExtraError, match=r'pip install "gyrostat\[fast\]"'):
        compile_margin(e1.sufficient, "numba")
    assert compile_margin(e1.sufficient)(I1=1, dU=1, l=3, pi3_0=0)


def test_kernels_of_one_source_are_one_function(e1):
    """Two margins with the same operations share the compiled function, and constants are not part of it."""
    one, other = compile_margin(3 * x * y - 5, "numba"), compile_margin(7 * x * y - 11, "numba")
    u, v = np.arange(3.0)[:, None], np.arange(4.0)
    assert np.array_equal(one(x=u, y=v), 3 * u * v - 5) and np.array_equal(other(x=u, y=v), 7 * u * v - 11)
    assert one.compile_seconds > 0 and other.compile_seconds == 0
