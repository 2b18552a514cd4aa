"""Lists screened by floats: the verdicts are those of every point alone, and few points are left over."""
import re

import numpy as np
import pytest
from sympy import exp

import gyrostat as gs
from gyrostat.charts import verdicts
from gyrostat.charts.codes import INVALID
from gyrostat.charts.grids import grid_of
from gyrostat.charts.signs import float_screening
from gyrostat.charts.signs.verdicts_in_blocks import Decided, demands_of
from gyrostat.errors import ValuesError

k3, a, c = map(gs.symbol, ("k3", "a", "c"))
POINTS = 200


def axial(expression):
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(expression))


@pytest.fixture(scope="module")
def reports(e1, e2, e3):
    made = {"E1 degree 4": gs.upright(axial(a * k3 + c * k3**4)), "E1 pole": gs.upright(axial(a / (c - k3))),
            "E3 pole": gs.inclined(axial(a / (c - k3))), "E1 exp": gs.upright(axial(a * exp(k3)))}
    return {"E1": e1, "E2": e2, "E3": e3, **{name: gs.analyze(eq) for name, eq in made.items()}}


def columns(report, source):
    """Numbers of every kind: ordinary, whole ones, of which margins vanish, tiny, huge, and none."""
    names = {*report.parameters, *(("d2U", "d3U", "d4U") if "dU" in report.parameters else ())}
    given = {}
    for name in sorted(names - {*report.equilibrium.eliminated}):
        kinds = [source.uniform(0.2, 3, POINTS), source.integers(-2, 3, POINTS) / 2, np.ones(POINTS)]
        kinds.append(source.choice([1e-200, -1e200, 5e-324, 1e308, -0.0, np.nan, np.inf], POINTS))
        given[name] = np.choose(source.choice(4, POINTS, p=[0.3, 0.35, 0.33, 0.02]), kinds)
    return given


@pytest.mark.slow
@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("name", ["E1", "E2", "E3", "E1 degree 4", "E1 pole", "E3 pole", "E1 exp"])
def test_a_list_is_decided_as_each_of_its_points(reports, monkeypatch, name, threads):
    """Whatever floats leave open, and whatever is no equilibrium; a number for all points as well."""
    monkeypatch.setattr(float_screening, "NUMBA_BLOCK", 37)
    report, source = reports[name], np.random.default_rng(5)
    for alike in (False, True):
        given = columns(report, source)
        if alike:
            given[min(given)] = 1.0
        expected = verdicts(report, given, invalid="mark")
        found = verdicts(report, given, invalid="mark", backend="numba", threads=threads)
        assert (found == expected).all() and len(set(found.tolist())) > 1
        with pytest.raises(ValuesError, match="is not a finite number") as one:
            verdicts(report, given)
        with pytest.raises(ValuesError, match=re.escape(str(one.value))):
            verdicts(report, given, backend="numba")


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["E1", "E3"])
def test_few_points_are_left_over(reports, monkeypatch, name):
    """Of ordinary columns none, with a period or sorted; with a huge number in one place that point alone."""
    left = []
    monkeypatch.setattr(float_screening, "Decided",
                        lambda report, points, backend: left.append(points.merged[1])
                        or Decided(report, points, backend))
    source, n = np.random.default_rng(7), 2**14
    names = [x for x in reports[name].parameters if x != "dU" or name == "E1"]
    given = {x: source.uniform(0.2, 0.9, n) for x in names}
    given["l"], given["I1"] = np.tile(np.linspace(0, 9, 128), 128), np.linspace(1, 2, n)
    verdicts(reports[name], given, backend="numba")
    assert not left
    given["I3"][77] = 1e300
    found = verdicts(reports[name], given, backend="numba")
    assert left == [1] and (found == verdicts(reports[name], given)).all()


@pytest.mark.few(1)
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("everywhere", [False, True])
def test_a_number_that_no_verdict_needs_is_finite_too(reports, value, everywhere):
    """In its place of the column, beside the largest double too, or for all points."""
    given = {"I1": np.ones(9), "dU": -np.ones(9), "l": np.arange(9.0), "pi3_0": 0.5, "d2U": np.ones(9)}
    given["d2U"][:5] = 1.7e308, 1.0, 1.0, 1.0, value
    if everywhere:
        given["d2U"] = value
    found = verdicts(reports["E1"], given, invalid="mark", backend="numba")
    assert (np.flatnonzero(found == INVALID) == (np.arange(9) if everywhere else 4)).all()
    with pytest.raises(ValuesError, match=r"d2U(\[4\])? = -?(nan|inf) is not a finite number"):
        verdicts(reports["E1"], given, backend="numba")


def test_what_is_screened(reports):
    """Lists of doubles, of any number of axes; not grids, one point, functions, or exact numbers."""
    given = {"I1": np.ones(6), "dU": 1.0, "l": np.zeros(6), "pi3_0": np.zeros(6)}

    def seen(values, name="E1"):
        grid = grid_of(values)
        return float_screening.screened(grid, demands_of(reports[name], grid, False))

    assert seen(given) and seen({n: v if n == "dU" else v.reshape(2, 3) for n, v in given.items()})
    assert not seen(given | {"l": np.zeros((2, 1))}) and not seen(dict.fromkeys(given, 1.0))
    assert not seen(given | {"dU": gs.symbol("dU") ** 0 / 3})
    assert not seen({"I1": np.ones(6), "a": np.ones(6), "l": 1.0, "pi3_0": 1.0, "I3": 1.0}, "E1 exp")


@pytest.mark.slow
def test_high_degrees_leave_few_points_over(monkeypatch):
    """Their bound would be too wide with room for larger numbers."""
    left = []
    monkeypatch.setattr(float_screening, "Decided",
                        lambda report, points, backend: left.append(points.merged[1])
                        or Decided(report, points, backend))
    report, source, n = gs.analyze(gs.inclined(axial(a * k3 + c * k3**40))), np.random.default_rng(7), 2**12
    given = {"k3": source.uniform(-0.9, 0.9, n), **{x: source.uniform(0.5, 2, n) for x in report.required
                                                     if x != "k3"}}
    found = verdicts(report, given, backend="numba")
    assert not left and (found == verdicts(report, given)).all()
    given["c"][3] = np.inf
    assert verdicts(report, given, backend="numba", invalid="mark")[3] == INVALID and left


def test_a_constant_beyond_doubles():
    """Nothing is proved with it in floats."""
    report = gs.analyze(gs.upright(axial(10**400 * a * k3)))
    given = {"I1": np.ones(3), "I3": 1.0, "a": np.array([1.0, 0.0, -1.0]), "l": 1.0, "pi3_0": 1.0}
    assert (verdicts(report, given, backend="numba") == verdicts(report, given)).all()


@pytest.mark.slow
def test_a_bound_that_never_suffices_changes_nothing(reports, monkeypatch):
    """With e = ∞ all points are left over."""
    given = columns(reports["E3"], np.random.default_rng(9))
    monkeypatch.setattr(float_screening, "error_bound", lambda *given: np.float64(np.inf))
    found = verdicts(reports["E3"], given, invalid="mark", backend="numba")
    assert (found == verdicts(reports["E3"], given, invalid="mark")).all()
