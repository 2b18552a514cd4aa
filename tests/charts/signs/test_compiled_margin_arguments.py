"""What compiled margins take and give: numbers, arrays of any namespace, types, out, memory."""
import math
import tracemalloc
from fractions import Fraction

import array_api_strict
import numpy as np
import pytest
from charts.drawn_margins import drawn, vertical
from sympy import Integer, Rational, Symbol, pi, sqrt

import gyrostat as gs
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.errors import ArgumentError, GyrostatError, ValuesError

x, y, z, b = map(gs.symbol, ("x", "y", "z", "b"))
BACKENDS = ["numpy", "numba"]
E1_NAMES = ("I1", "dU", "l", "pi3_0")


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.few(1)
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
    (x, "jax", "backend = 'jax' is not known"), (3, "numpy", "is an int"), ("x", "numpy", "is a str"),
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
