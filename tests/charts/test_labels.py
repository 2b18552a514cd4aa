"""Arrays with masks and labels: refused where they would be ignored.

Memory that is written to while it is read.
"""
from contextlib import contextmanager
from fractions import Fraction
from itertools import product

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st

from gyrostat.charts import verdicts
from gyrostat.charts.boxes.certified_boxes import certify_box
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.signs import compiled_margins, verdict_arrays
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.errors import ArgumentError, ValuesError

FIXED = {"I1": 1, "dU": 1}
PLACES = np.linspace(-3.0, 3.0, 7)


@pytest.mark.parametrize("call", [lambda e1, l: verdicts(e1, FIXED, l=l, pi3_0=1.0),
                                  lambda e1, l: verdicts(e1, FIXED, pi3_0=l, l=[[1.0]]),
                                  lambda e1, l: compile_margin(e1.sufficient)(**FIXED, l=l, pi3_0=1.0),
                                  lambda e1, l: compile_margin(e1.sufficient, np)(**FIXED, l=l, pi3_0=1.0),
                                  lambda e1, l: stability_chart(e1, x=("l", l), y=("pi3_0", [0, 1]),
                                                                fixed=FIXED)])
def test_masked_numbers_are_refused(e1, call):
    """A mask is not ignored; one that masks nothing is no mask."""
    call(e1, np.ma.array(PLACES))
    call(e1, np.ma.array(PLACES, mask=False))
    for masked in (np.ma.masked_greater(PLACES, 2), np.ma.array(PLACES, mask=PLACES == 0),
                   np.ma.array([1, 2], mask=[1, 0])):
        with pytest.raises(ValuesError, match=r"\[\d\] is masked, a verdict needs a number: leave it out"):
            call(e1, masked)


def test_a_masked_number_alone_is_refused(e1):
    """Of no axis, among exact numbers, or as the end of a box."""
    for value in (np.ma.masked, np.ma.array(1.0, mask=True), np.ma.array([Fraction(1, 2)], mask=[True])):
        with pytest.raises(ValuesError, match="masked"):
            verdicts(e1, FIXED, l=value, pi3_0=1)
    with pytest.raises(ValuesError):
        certify_box(e1, {**FIXED, "l": np.ma.array([0.0, 1.0], mask=[0, 1]), "pi3_0": 1})


LABELLED = [
    (xr.DataArray(PLACES, dims="a"), xr.DataArray(PLACES, dims="b")),
    (xr.DataArray(PLACES, {"a": PLACES}), xr.DataArray(PLACES, {"a": PLACES[::-1]})),
    (xr.DataArray(np.ones((2, 2)), dims=("a", "b")), xr.DataArray(np.ones((2, 2)), dims=("b", "a"))),
    (pd.Series(PLACES), pd.Series(PLACES, index=range(1, 8))),
    (xr.DataArray(PLACES, dims="a"), pd.Series(PLACES)),
    (pd.DataFrame({"a": PLACES}), pd.DataFrame({"b": PLACES})),
    (xr.Variable("a", PLACES), xr.DataArray(PLACES, dims="b"))]


@pytest.mark.parametrize("pair", LABELLED)
def test_labels_that_differ_are_refused(e1, pair):
    """Arrays of xarray and pandas are not combined by places where by labels it would be otherwise."""
    for call in (lambda l, pi3_0: verdicts(e1, FIXED, l=l, pi3_0=pi3_0),
                 lambda l, pi3_0: compile_margin(e1.sufficient)(
            **FIXED, l=l, pi3_0=pi3_0)):
        with pytest.raises(ValuesError,
                           match="pi3_0 and l differ in their labels, .* align them first, or pass their "
                                 ".values"):
            call(*pair)
        for same in pair:
            np.testing.assert_array_equal(call(same, same), call(same.values, same.values))
            np.testing.assert_array_equal(call(same, same.values), call(same.values, same.values))


@contextmanager
def blocks_of(points):
    """Many blocks, one written before the next is read."""
    with pytest.MonkeyPatch.context() as patched:
        for module, name in product((compiled_margins, verdict_arrays), ("NUMPY_BLOCK", "NUMBA_BLOCK")):
            patched.setattr(module, name, points)
        yield


numbers = st.integers(-12, 12).map(lambda n: n / 4)


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["numpy", "numba"])
@given(numbers=st.lists(numbers, min_size=40, max_size=40), shift=st.integers(-7, 7),
       width=st.sampled_from([1, 5, 16]))
@settings(max_examples=10)
def test_what_is_written_may_overlap_what_is_read(e1, backend, numbers, shift, width):
    """Shifted by any number of places, or not at all: the result is that of separate memory."""
    memory = np.array(numbers * 30)
    n = 1120 // width * width

    def view(place):
        return memory[place:place + n].reshape(-1, width)

    margin = compile_margin(e1.sufficient.alternatives[0][0].margin, backend)
    given = {"I1": 1.0, "dU": 1.0, "pi3_0": 0.5}
    with blocks_of(64):
        expected = margin(**given, l=view(40 + shift).copy())
        np.testing.assert_array_equal(margin(**given, l=view(40 + shift), out=view(40)), expected)


def test_overlapping_verdicts(e1):
    """Of int8 in the bytes of the doubles that are read."""
    memory = np.linspace(-3, 3, 2000)
    expected = verdicts(e1, FIXED, l=memory.copy(), pi3_0=0.5)
    for place in (0, 800, 14000):
        some = memory.copy()
        out = some.view(np.int8)[place:place + 2000]
        with blocks_of(64):
            np.testing.assert_array_equal(verdicts(e1, FIXED, l=some, pi3_0=0.5, out=out), expected)


def test_out_in_another_namespace_is_refused(e1):
    """It would be ignored."""
    with pytest.raises(ArgumentError, match="out is written to by NumPy and Numba"):
        compile_margin(e1.sufficient, np)(**FIXED, l=PLACES, pi3_0=1.0, out=np.empty(7))
