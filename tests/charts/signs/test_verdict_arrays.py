"""Verdicts on arrays: at every point what Report.verdict says, floats or not.

And what an independent oracle says.
"""
from fractions import Fraction
from functools import cache

import numpy as np
import oracle
import pytest
from charts.checked_arrays import axial, check, one_by_one
from flint import ctx
from hypothesis import given
from hypothesis import strategies as st
from sympy import exp, sqrt

import gyrostat as gs
from gyrostat.charts import verdicts
from gyrostat.charts.codes import INVALID, STABLE, UNDECIDED, UNSTABLE
from gyrostat.charts.signs import grid_signs as arraysigns
from gyrostat.charts.signs import leaves, verdicts_in_blocks
from gyrostat.stability.criteria.conditions import Condition, Criterion

BACKENDS = ["numpy", "numba"]
k3, a, b, c = map(gs.symbol, ("k3", "a", "b", "c"))


def on_axes(**sides):
    """Each array along an axis of its own."""
    return {name: np.array(side, dtype=float).reshape(-1, *[1] * (len(sides) - 1 - i))
            for i, (name, side) in enumerate(sides.items())}


FEW = np.arange(-2, 3)
GRIDS = {
    "E1": on_axes(I1=[1, 0, 2], dU=FEW, l=[0, 1], pi3_0=[-2, 0, 1], d2U=[-1, 0]),
    "E2": on_axes(I1=[1, 2], dU=FEW, l=[0, 1], pi3_0=FEW),
    "E3": on_axes(I1=[1, 2], I3=[1, 0], l=[0, 1], omega=[-1, 0, 2], k3=[-1, -0.5, 0, 0.5], d2U=[-6, 0, 1]),
    "at rest": on_axes(I1=[1, 2], k3=[-1, 0, 0.5, 2], l=[-1, 0, 1], d2U=[-1, 0, 1]),
    "E1 rate": on_axes(I1=[1, 2], I3=[1, 2, -1], l=[-1, 0, 1], omega3_0=[-1, 0, 1], dU=[-1, 0, 1]),
    "E1 uniform": on_axes(I1=[1, 0], I3=[0, 1], l=[-1, 0, 1], pi3_0=FEW, m0=[-1, 0, 1]),
    "E3 uniform": on_axes(k3=[-1, 0, 0.5], omega=[0, 1]),
    "at rest, uniform": on_axes(k3=[-1, 0, 0.5], l=[-1, 0, 1]),
    "E3 uniform, k3": on_axes(I1=[1, 2], I3=[1, 2, 3], l=FEW, m0=FEW, omega=[-1, 0, 1]),
    "E1 Newtonian": on_axes(I1=[1, 2], I3=[1, 3], l=[0, 1], m0=[-1, 0, 1], m1=[-1, 0, 1], pi3_0=[-1, 1]),
    "E2 Newtonian": on_axes(I1=[1, 2], I3=[1, 3], l=[0], m0=[-1, 0, 1], m1=[-1, 0, 1], pi3_0=[-2, 0, 2]),
    "E3 Newtonian": on_axes(I1=[1, 2], I3=[1, 3], k3=[-1, 0, 0.5], m0=[-1, 0, 1], m1=[-1, 0, 1],
                            omega=[0, 1]),
    "E1 degree 6": on_axes(I1=[1, 2], a=FEW, b=[-1, 0, 1], l=[0, 1], pi3_0=[-1, 0, 1]),
    "E3 degree 6": on_axes(I1=[1, 2], I3=[1], a=[-1, 0, 1], b=[-1, 0, 1], k3=[-0.5, 0, 1], omega=[0, 1]),
    "at rest, numbers": on_axes(I1=[1, 2], l=[-1, 0, 1], k3=[-1, 0, 0.5]),
    "E3 degree 20": on_axes(I1=[1, 2], I3=[1, 2], a=[-1, 0, 1], k3=[-0.5, 0, 0.5, 1], omega=[0, 1]),
    "E1 pole": on_axes(I1=[1, 2], a=[-1, 0, 1], c=[0, 1, 2], l=[0, 1], pi3_0=[-1, 0, 1]),
    "E2 pole": on_axes(I1=[1], a=FEW, c=FEW, l=[0, 1], pi3_0=[0]),
    "E3 pole": on_axes(I1=[1, 2], I3=[1, 3], c=[-0.5, 0, 0.5, 2], k3=[-0.5, 0, 0.5], omega=[0, 1]),
    "E1 log": on_axes(I1=[1, 2], c=[0, 1, 2, 3], l=[0, 1], pi3_0=[-1, 0, 1]),
    "E1 exp": on_axes(I1=[1, 2], b=FEW, l=[0, 1], pi3_0=[-1, 0, 1]),
    "E3 exp": on_axes(I1=[1, 2], I3=[1, 3], a=[-1, 0, 1], k3=[-1, 0, 0.5], omega=[0, 1]),
    "E1 root": on_axes(I1=[1], c=[0, 1, 1.25, 2], l=[0, 1], pi3_0=[-1, 0]),
    "general": on_axes(I1=[1, 2], I2=[3], I3=[2, 0], l=[0, 1], m0=[-1, 0, 1], m1=[0, 1],
                       omega=[-1, 1]),
    "free 3": on_axes(I1=[1, 2], I2=[1, 2, 3], I3=[1, 2], l=FEW, omega3_0=FEW)}


def omitted(report, values):
    """Without what a report of this scene does not take."""
    return {n: v for n, v in values.items() if n in report.parameters or n.startswith("d") and n[-1] == "U"}


@pytest.fixture(scope="module")
def truth(reports):
    """Report.verdict at every point of a grid, found once."""
    return cache(lambda name: one_by_one(reports[name], omitted(reports[name], GRIDS[name])))


# each is compiled
COMPILED = ("E1", "E3", "at rest", "E3 uniform, k3", "E3 exp", "free 3")


@pytest.mark.slow
@pytest.mark.parametrize(("name", "backend"), [
    *((name, "numpy") for name in GRIDS), *((name, "numba") for name in COMPILED),
    *(pytest.param(name, "numba", marks=pytest.mark.slow) for name in GRIDS if name not in COMPILED)])
def test_verdicts_are_those_of_each_point(reports, truth, name, backend):
    """Small integers and halves.

    Many on the boundary, off the family, at poles of U, with moments that are not positive.
    """
    report, values = reports[name], GRIDS[name]
    assert set(report.required) <= set(values)
    found = check(report, omitted(report, values), truth(name), backend=backend)
    assert len(set(np.unique(found))) >= (2 if name != "E3 uniform" else 1)


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_blocks_have_no_seams(reports, truth, tiny_blocks, backend):
    """The same in blocks of seven points, on one thread or two."""
    for name in ("E1", "E3 uniform, k3", "general") if backend == "numpy" else ("E1",):
        expected = truth(name)
        for threads in (1, 2):
            check(reports[name], {n: v[:2] for n, v in GRIDS[name].items()},
                  expected[(slice(2),) * expected.ndim], backend=backend, threads=threads)


def test_the_boundary_may_stay_undecided(reports):
    """E1 on the boundary: UNDECIDED without U'' and where U'' = −U', decided by its sign elsewhere, as it
    varies along an axis.
    """
    values = {"I1": 1, "dU": 1, "l": 1, "pi3_0": np.array([[1.0], [2.0], [0.0]])}
    assert verdicts(reports["E1"], values).tolist() == [[UNDECIDED], [STABLE], [UNSTABLE]]
    found = check(reports["E1"], values | {"d2U": np.array([-2.0, -1.0, 0.0])})
    assert found.tolist() == [[UNSTABLE, UNDECIDED, STABLE], [STABLE] * 3, [UNSTABLE] * 3]


moments = st.integers(1, 6)
whole = st.integers(-6, 6)


@pytest.mark.slow
def test_criteria_of_any_form(reports):
    """Several conditions, alternatives and even factors, strict or not, as a report may come to have them."""
    dU, l, pi3 = map(gs.symbol, ("dU", "l", "pi3_0"))

    def criterion(notion, strict, *groups):
        return Criterion(notion,
                         tuple(tuple(Condition(m, strict, "", tuple(factors), gs.symbol("k3") ** 0)
                                     for m, *factors in group)
                                       for group in groups))

    necessary = [criterion("spectral", False, [(pi3, l)]),
                 criterion("spectral", False, [(pi3, l, dU), (l + pi3,)]),
                 criterion("spectral", False, [(pi3 - dU, l)], [(l, pi3 + dU)])]
    sufficient = [criterion("formal", True, [(pi3, l)]),
                  criterion("formal", True, [(pi3, l, dU), (l + pi3,)], [(dU - 1,)]),
                  criterion("formal", True), criterion("formal", True, []),
                  criterion("formal", True, [(pi3,)])]
    values = {"I1": 1} | on_axes(dU=[-1, 0, 1], l=[-1, 0, 1], pi3_0=[-1, 0, 1])
    for one in necessary:
        for other in sufficient:
            for ladder in (None, reports["E1"].boundary):
                report = gs.analyze(reports["E1"].equilibrium)
                vars(report).update(necessary=one, sufficient=other, boundary=ladder)
                check(report, values | {"d2U": np.array([1.0, -2.0]).reshape(2, 1, 1, 1)})


@given(I1=moments, columns=st.lists(st.tuples(whole, whole, whole), min_size=1, max_size=8),
       s=st.sampled_from([1, -1]),
       exponent=st.integers(-160, 160))
def test_the_vertical_is_that_of_the_oracle(reports, I1, columns, s, exponent):
    """E1 and E2 against g'' of the reduced motion, at scales 2⁻¹⁶⁰ to 2¹⁶⁰.

    On the boundary UNDECIDED, U'' being unknown.
    """
    l, pi3, dU = (np.array(column) * 2.0**exponent for column in zip(*columns))
    found = verdicts(reports["E1" if s == 1 else "E2"], I1=I1, l=l, pi3_0=pi3, dU=dU * 2.0**exponent)
    for n, code in enumerate(found):
        numbers = [Fraction(v[n]) for v in (l, pi3, dU * 2.0**exponent)]
        assert code == oracle.verdict_vertical(Fraction(I1), numbers[0], numbers[1], s, numbers[2])


tilted = st.tuples(moments, moments, whole, whole, st.integers(-7, 7), whole)


@given(columns=st.lists(tilted, min_size=1, max_size=8), exponent=st.integers(-80, 80))
def test_the_tilt_is_that_of_the_oracle(reports, columns, exponent):
    """E3 against g'' of the reduced motion; on the boundary UNDECIDED, U''' being unknown."""
    I1, I3, l, omega, eighths, d2U = map(np.array, zip(*columns))
    scale = 2.0**exponent
    values = {"I1": I1, "I3": I3, "l": l * scale, "omega": omega * scale, "k3": eighths / 8,
              "d2U": d2U * scale**2}
    found = verdicts(reports["E3"], values)
    for n, code in enumerate(found):
        at = {name: Fraction(float(v[n])) for name, v in values.items()}
        assert code == oracle.verdict_inclined(at["I1"], at["I3"], at["l"], at["omega"], at["k3"], at["d2U"])


def test_threads_of_a_fresh_report(tiny_blocks):
    """A report of which nothing is derived yet, with functions and roots, on four threads.

    The same, and the precision is what it was.
    """
    before, values = ctx.prec, {"I1": 1, "a": sqrt(2), "b": FEW[:, None] / 4,
                                "l": np.linspace(0, 3, 5).reshape(-1, 1, 1),
                                "pi3_0": np.linspace(-1, 1, 4)}
    found = [verdicts(gs.analyze(gs.upright(axial(a * exp(b * k3)))), values, threads=n) for n in (1, 4)]
    assert (found[0] == found[1]).all()
    assert {STABLE, UNSTABLE} <= set(np.unique(found[0]))
    assert ctx.prec == before


@pytest.mark.parametrize("threads", [1, 3])
def test_one_thread_at_a_time_computes_enclosures(reports, tiny_blocks, monkeypatch, threads):
    """The precision of enclosures is one for the process.

    They are computed under one lock, those of the first look at a grid too.
    """
    locked, real = [], leaves.ball
    monkeypatch.setattr(leaves, "ball", lambda
                        *given: locked.append(leaves.ONE_AT_A_TIME._is_owned()) or real(*given))
    leaves._near.cache_clear()
    verdicts(reports["E1 exp"], I1=1, b=np.array([[0.5], [0.25]]), l=sqrt(2), pi3_0=np.linspace(-1, 1, 9),
             threads=threads)
    assert locked and all(locked)


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", BACKENDS)
def test_the_filter_decides_ordinary_grids(reports, monkeypatch, backend):
    """No point of an ordinary grid needs balls or rationals, also with one outlier among the numbers."""
    monkeypatch.setattr(arraysigns, "ExactSign", None)
    monkeypatch.setattr(verdicts_in_blocks, "CODE_OF", None)
    for outlier in (1.0, 1e140):
        omega = np.append(np.linspace(0.1, 2, 150), outlier)[:, None]
        found = verdicts(reports["E3"], I1=1.0, I3=0.5, l=0.123, omega=omega, k3=np.linspace(-0.9, 0.9, 200),
                         d2U=-1.0, backend=backend)
        assert {STABLE, UNSTABLE} == set(np.unique(found))


def test_nothing_is_decided_one_by_one(reports, monkeypatch):
    """Report.verdict is not asked where a ladder decides: many points of the boundary are one array too."""
    monkeypatch.setattr(type(reports["E1"]), "verdict", None)
    values = {"I1": np.array([[1.0], [-1.0]]), "dU": 1, "l": 0, "pi3_0": FEW.astype(float), "d2U": 1}
    assert verdicts(reports["E1"], values, invalid="mark").tolist() == [
        [STABLE, UNSTABLE, UNSTABLE, UNSTABLE, STABLE],
        [INVALID] * 5,
    ]


@pytest.mark.few(1)
@pytest.mark.parametrize(("name", "backend"), [("E1", "numpy"), ("E1", "numba"), ("E3 uniform, k3", "numpy"),
                                               ("free 3", "numpy"), ("E1 exp", "numpy")])
def test_a_filter_that_never_suffices_changes_nothing(reports, truth, monkeypatch, name, backend):
    """With e = ∞ the verdicts are the same."""
    monkeypatch.setattr(arraysigns, "error_bound", lambda *given: np.float64(np.inf))
    check(reports[name], omitted(reports[name], GRIDS[name]), truth(name), backend=backend)
