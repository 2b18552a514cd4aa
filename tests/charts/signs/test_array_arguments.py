"""What verdicts on arrays takes: names, shapes, options; what it marks and what it refuses."""
import math
import re
from fractions import Fraction

import numpy as np
import pytest
from charts.checked_arrays import axial, check

import gyrostat as gs
from gyrostat.charts import verdicts
from gyrostat.charts.codes import CODE_OF, INVALID, STABLE, UNSTABLE
from gyrostat.errors import ArgumentError, GyrostatError, MissingExtraError, ValuesError
from gyrostat.stability.decision import Verdict

BACKENDS = ["numpy", "numba"]
k3, a, b, c = map(gs.symbol, ("k3", "a", "b", "c"))


def test_extra_names_vary_too(reports):
    """I3 at E1, which no verdict needs, must be positive; its axis is one of the result."""
    I3 = np.array([[1.0], [0.0], [-1.0]])
    found = check(reports["E1 uniform"], {"I1": 1, "l": 1, "m0": 0, "pi3_0": np.array([-1.0, 0.0]), "I3": I3})
    assert found.tolist() == [[UNSTABLE, STABLE], [INVALID] * 2, [INVALID] * 2]


def test_the_eliminated_name_is_omitted(reports):
    """dU and l follow at E3; given, they are refused."""
    for name, values in (("E3", {"I1": 1, "I3": 1, "l": 0, "omega": 1, "k3": 0, "d2U": 1, "dU": 0}),
                         ("E3 uniform", {"k3": 0, "omega": 1, "l": 1})):
        with pytest.raises(ValuesError, match="omit it"):
            verdicts(reports[name], values)


def test_parameters_that_no_verdict_needs_may_be_omitted():
    """U = m0 k3 + c/d: neither c nor d is needed; d = 0, if it is given, is a pole of U."""
    m0, d = gs.symbol("m0"), gs.symbol("d")
    report = gs.analyze(gs.upright(axial(m0 * k3 + c / d)))
    values = {"I1": 1, "m0": 0.25, "l": 1, "pi3_0": np.array([-1.0, 0.0, 1.0])}
    assert check(report, values).tolist() == [UNSTABLE, STABLE, STABLE]
    check(report, values | {"d": np.array([[0.0], [1.0]]), "c": 1})


def test_names_may_be_symbols(reports):
    """Names are matched as texts, as in Report.verdict."""
    values = {"I1": 1, "dU": 1, "l": 3, "pi3_0": 0}
    assert (
        verdicts(reports["E1"], {gs.symbol(n): v for n, v in values.items()})
        == verdicts(reports["E1"], values)
        == STABLE
    )


def test_names_as_keywords(reports):
    """Names in a mapping and as keywords are the same; a number gives an array without axes."""
    values = {"I1": 1, "dU": 1, "l": 3, "pi3_0": 0}
    found = verdicts(reports["E1"], {"I1": 1, "dU": 1}, l=3, pi3_0=0)
    assert found == verdicts(reports["E1"], values) and found.shape == () and found.dtype == np.int8
    assert CODE_OF == {Verdict.STABLE: 1, Verdict.UNDECIDED: 0, Verdict.UNSTABLE: -1} and INVALID == -2


@pytest.mark.few(3)
@pytest.mark.parametrize(("backend", "threads", "shapes"), [
    ("numpy", 1, ((9, 1), (11,))), ("numpy", 2, ((2, 1, 1), (3, 1), (5,))), ("numpy", 2, ((4, 1), (4, 6))),
    ("numpy", 2, ((30,), (30,))), ("numba", 1, ((2, 1, 1), (3, 1), (5,))), ("numba", 2, ((9, 1), (11,)))])
def test_the_first_index_in_c_order_is_named(reports, tiny_blocks, backend, threads, shapes):
    """Of the points where the equilibrium does not exist the first in C order is named, with the reason,
    whatever the blocks.
    """
    source = np.random.default_rng(3)
    for _ in range(4):
        values = {"I1": np.ones(shapes[0]), "I3": 1.0, "l": 1.0,
                  "omega": np.ones(shapes[-1] if len(shapes) == 3 else ()), "d2U": 1.0,
                  "k3": np.zeros(shapes[1])}
        values["I1"][source.random(shapes[0]) < 0.15] = -1
        values["k3"][source.random(shapes[1]) < 0.1] = 2
        bad = np.argwhere(verdicts(reports["E3"], values, invalid="mark", backend=backend) == INVALID)
        if bad.size == 0:
            continue
        index = tuple(map(int, bad[0]))
        with pytest.raises(ValuesError, match=re.escape(f"at index {index}: ")):
            verdicts(reports["E3"], values, backend=backend, threads=threads)


@pytest.mark.parametrize("backend", BACKENDS)
def test_numbers_that_are_not_finite(reports, backend):
    """NaN and infinities are refused by name and index, or marked.

    Two infinities that cancel are no warning.
    """
    values = {"I1": 1, "dU": 1, "l": np.array([[math.nan], [math.inf], [-math.inf], [3.0]]),
              "pi3_0": np.array([0.0, math.inf, -math.inf])}
    with pytest.raises(ValuesError, match=r"l\[0, 0\] = nan is not a finite number"):
        verdicts(reports["E1"], values, backend=backend)
    found = verdicts(reports["E1"], values, invalid="mark", backend=backend)
    assert found.tolist() == [[INVALID] * 3] * 3 + [[STABLE, INVALID, INVALID]]
    assert verdicts(reports["E1"], values | {"I1": math.inf, "l": 0, "pi3_0": 0}, invalid="mark") == INVALID


def test_numbers_that_are_not_finite_among_objects(reports):
    """They are marked among Fractions too."""
    l = np.array([Fraction(10, 3), math.nan], dtype=object)
    assert verdicts(reports["E1"], {"I1": 1, "dU": 1, "l": l, "pi3_0": 0}, invalid="mark").tolist() == [
        STABLE,
        INVALID,
    ]


@pytest.mark.parametrize("shape", [(0,), (3, 0), (0, 3), (2, 0, 3)])
@pytest.mark.parametrize("backend", BACKENDS)
def test_no_points_no_verdicts(reports, shape, backend):
    """An empty grid has an empty array of verdicts."""
    found = verdicts(reports["E1"], I1=1, dU=1, l=np.ones(shape), pi3_0=1.0, backend=backend)
    assert found.shape == shape and found.dtype == np.int8


def test_out_is_written_to(reports):
    """out of int8 is filled and returned; other arrays are refused."""
    values, out = {"I1": 1, "dU": 1, "l": np.zeros((3, 1)),
                   "pi3_0": np.arange(4.0)}, np.empty((3, 4), dtype=np.int8)
    assert verdicts(reports["E1"], values, out=out) is out and (out == verdicts(reports["E1"], values)).all()
    frozen = np.empty((3, 4), dtype=np.int8)
    frozen.flags.writeable = False
    for wrong in (np.empty((3, 4)), np.empty((4, 3), dtype=np.int8), np.empty((4, 3), dtype=np.int8).T,
                  [0] * 12, frozen):
        with pytest.raises(GyrostatError, match="out"):
            verdicts(reports["E1"], values, out=wrong)


@pytest.mark.parametrize(("given_values", "options", "error", "said"), [
    ({"l": 1}, {}, ValuesError, "E1 needs pi3_0"),
    ({"l": 1, "pi3": 1}, {}, ValuesError, "did you mean pi3_0"),
    ({"l": 1, "pi3_0": 1, "m0": 1}, {}, ValuesError, "no parameter m0"),
    ({"l": [1, 2], "pi3_0": [1, 2, 3]}, {}, ValuesError, r"do not broadcast: l \(2,\), pi3_0 \(3,\)"),
    ({"l": 1, "pi3_0": 1}, {"invalid": "skip"}, ArgumentError, "invalid = 'skip'"),
    ({"l": 1, "pi3_0": 1}, {"backend": "jax"}, ArgumentError, "backend = 'jax'"),
    ({"l": 1, "pi3_0": 1}, {"threads": None}, GyrostatError, "threads"),
    ({"l": 1, "pi3_0": 1}, {"threads": "2"}, GyrostatError, "threads")])
def test_what_is_wrong_is_named(reports, given_values, options, error, said):
    """Names, shapes and options."""
    with pytest.raises(error, match=said):
        verdicts(reports["E1"], {"I1": 1, "dU": 1} | given_values, **options)


def test_a_mapping_is_asked_for(reports):
    """A list of values has no names."""
    with pytest.raises(GyrostatError):
        verdicts(reports["E1"], [1, 2])


def test_a_report_is_asked_for():
    """ArgumentError for anything but a report."""
    with pytest.raises(ArgumentError, match="the report"):
        verdicts(3, {})


def test_numba_is_optional(reports, monkeypatch):
    """MissingExtraError where Numba is not installed."""
    monkeypatch.setitem(__import__("sys").modules, "numba", None)
    with pytest.raises(MissingExtraError, match=r"gyrostat\[fast\]"):
        verdicts(reports["E1"], I1=1, dU=1, l=1, pi3_0=1, backend="numba")
