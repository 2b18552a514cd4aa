"""Verdicts on arrays: at every point what Report.verdict says, floats or not, at every scale.

And what an independent oracle says.
"""
import math
import re
from decimal import Decimal
from fractions import Fraction
from functools import cache

import numpy as np
import oracle
import pytest
from flint import ctx
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, chebyshevt, cos, exp, log, sin, sqrt

import gyrostat as gs
from gyrostat.charts import arrays, deciding, verdicts
from gyrostat.charts import signs as arraysigns
from gyrostat.charts.codes import CODE_OF, INVALID, STABLE, UNDECIDED, UNSTABLE
from gyrostat.errors import ArgumentError, GyrostatError, MissingExtraError, ValuesError
from gyrostat.stability.conditions import Condition, Criterion
from gyrostat.stability.report import Verdict

BACKENDS = ["numpy", "numba"]
k3, a, b, c = map(gs.symbol, ("k3", "a", "b", "c"))


def axial(expression):
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(expression))


@pytest.fixture(scope="module")
def reports(scene, general, free):
    """By name; each derived once."""
    uniform, newtonian = (gs.assemble(gs.symmetric_gyrostat(), f)
                          for f in (gs.uniform_field(), gs.newtonian_field(2)))
    six, twenty = axial(a * k3 + b * k3**6), axial(a * chebyshevt(20, k3))
    made = {
        "E1": gs.upright(scene), "E2": gs.hanging(scene), "E3": gs.inclined(scene),
        "at rest": gs.static_tilt(scene),
        "E1 rate": gs.upright(scene, spin="omega3_0"), "E1 uniform": gs.upright(uniform),
        "E3 uniform": gs.inclined(uniform),
        "at rest, uniform": gs.static_tilt(uniform), "E3 uniform, k3": gs.inclined(uniform, eliminate="k3"),
        "E1 Newtonian": gs.upright(newtonian), "E2 Newtonian": gs.hanging(newtonian),
        "E3 Newtonian": gs.inclined(newtonian),
        "E1 degree 6": gs.upright(six), "E3 degree 6": gs.inclined(six), "E3 degree 20": gs.inclined(twenty),
        "at rest, numbers": gs.static_tilt(axial(k3**4 - k3**2)), "E1 pole": gs.upright(axial(a / (c - k3))),
        "E2 pole": gs.hanging(axial(a / (c - k3))), "E3 pole": gs.inclined(axial(1 / (c - k3))),
        "E1 log": gs.upright(axial(log(c - k3))),
        "E1 exp": gs.upright(axial(exp(b * k3))), "E3 exp": gs.inclined(axial(a * exp(50 * k3))),
        "E1 root": gs.upright(axial(sqrt(c - k3))),
        "free 3": gs.principal_rotation(free, 3)}
    return {"general": general} | {name: gs.analyze(eq) for name, eq in made.items()}


def one_by_one(report, values):
    """Report.verdict at every point; INVALID where it refuses."""
    given_arrays = [v if isinstance(v, np.ndarray) else np.asarray(v, dtype=object) for v in values.values()]
    full = dict(zip(values, np.broadcast_arrays(*given_arrays)))
    result = np.empty(np.broadcast_shapes(*(v.shape for v in given_arrays)), dtype=np.int8)
    for index in np.ndindex(result.shape):
        try:
            result[index] = CODE_OF[report.verdict({n: v[index] for n, v in full.items()}).verdict]
        except ValuesError:
            result[index] = INVALID
    return result


def check(report, values, expected=None, **options):
    """The verdicts, which are those of Report.verdict."""
    found = verdicts(report, values, invalid="mark", **options)
    expected = one_by_one(report, values) if expected is None else expected
    assert found.dtype == np.int8 and found.shape == expected.shape
    if (wrong := np.argwhere(found != expected)).size:
        index = tuple(wrong[0])
        full = {n: np.broadcast_to(np.asarray(v), expected.shape)[index] for n, v in values.items()}
        raise AssertionError(f"{len(wrong)} of {found.size}, first at {full}: {found[index]}, not "
                             f"{expected[index]}")
    return found


@pytest.fixture
def tiny_blocks(monkeypatch):
    """Blocks of seven points."""
    monkeypatch.setattr(arrays, "NUMPY_BLOCK", 7)
    monkeypatch.setattr(arrays, "NUMBA_BLOCK", 7)


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
    "general": on_axes(I1=[1, 2], I2=[1, 3], I3=[2, 0], l=[0, 1], m0=[-1, 0, 1], m1=[0, 1],
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


def neighbours(x, n=3):
    """2n + 1 doubles about each."""
    columns, down, up = [x], x, x
    for _ in range(n):
        down, up = np.nextafter(down, -np.inf), np.nextafter(up, np.inf)
        columns += [down, up]
    return np.stack(columns)


@pytest.mark.parametrize("backend", BACKENDS)
def test_neighbours_of_the_boundary(reports, backend):
    """The doubles next to the boundary, on it and on both sides."""
    source = np.random.default_rng(7)
    I1, l, pi3 = source.uniform(0.1, 5, 25), source.uniform(-5, 5, 25), source.uniform(-5, 5, 25)
    found = check(reports["E1"], {"I1": I1, "l": l, "pi3_0": pi3,
                                  "dU": neighbours((l + pi3) ** 2 / (4 * I1))}, backend=backend)
    assert {STABLE, UNSTABLE} <= set(np.unique(found))
    k = source.uniform(-0.9, 0.9, 25)
    dU = -0.5 * l - 0.25 * k * (I1 - 2)
    d2U = (2 * I1 * k * dU - 0.25 * I1**2 - (-0.5 * (I1 - 2) * k - l) ** 2) / (I1 * (1 - k * k))
    found = check(reports["E3"], {"I1": I1, "I3": 2.0, "l": l, "omega": -0.5, "k3": k,
                                  "d2U": neighbours(d2U)}, backend=backend)
    # the boundary lies among the neighbours, but for rounding of a few of them
    assert (found.min(0) != found.max(0)).mean() > 0.3


@pytest.mark.parametrize("backend", BACKENDS)
def test_cancelling_momenta(reports, backend):
    """π3 ≈ −l up to 10⁸ times their sum, where P² = 4 I1 U' is met or nearly; with π3 = I3 ω3 too."""
    P = np.array([0.0, 0.5, -0.5, 0.5 + 2.0**-26, 2.0**-26])
    l = np.array([[1.0], [2.0**27], [-(2.0**27)], [1e8], [0.1]])
    dU = np.array([0.0625, 0.0, 2.0**-54]).reshape(3, 1, 1)
    found = check(reports["E1"], {"I1": 1, "l": l, "pi3_0": P - l, "dU": dU}, backend=backend)
    assert {STABLE, UNSTABLE, UNDECIDED} == set(np.unique(found))
    check(reports["E1 rate"], {"I1": 1, "I3": 0.1, "l": l, "omega3_0": (P - l) / 0.1, "dU": dU[:2]},
          backend=backend)


@pytest.mark.parametrize("backend", BACKENDS)
def test_degenerate_shapes(reports, backend):
    """I1 → I3, abs(k3) → 1: down to 1 − 2⁻⁵³, and the pole itself."""
    k = np.array([0.0, 1 - 2.0**-53, -1 + 2.0**-53, 1 - 2.0**-30, 1.0, -1.0, 5e-324])
    I3 = np.array([1.0, 1 + 2.0**-52, 1 - 2.0**-53])[:, None]
    check(reports["E3"], {"I1": 1.0, "I3": I3, "l": 0.5, "omega": 1.0, "k3": k,
                          "d2U": np.array([0.0, -3.0, 1e20]).reshape(3, 1, 1)},
          backend=backend)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("name", ["E3 degree 20", "E3 exp"])
def test_stiff_fields(reports, name, backend):
    """T₂₀(k3), exp(50 k3): k3 up to 1 − 2⁻⁵³, slow and fast rates."""
    report, k = reports[name], np.array([-0.99, -0.7, -0.1, 0.0, 0.05, 0.3, 0.9, 1 - 2.0**-53])
    omega = np.array([0.5, 8.0, 1e5]).reshape(3, 1, 1)
    check(report, {"I1": 1.0, "I3": 0.5, "a": np.array([[1.0], [-1e-6]]), "omega": omega, "k3": k},
          backend=backend)


SCALES = [1e-160, 1e-150, 1e-100, 1.0, 1e100, 1e150, 1e200, 1.7e308, 5e-324, 2.0**-1040]


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.filterwarnings("error")
def test_extreme_scales(reports, backend):
    """Scales 10^±150 and subnormal numbers, alone and mixed in one array.

    Overflow and underflow are no obstacle, and no warning.
    """
    for scale in SCALES:
        l, dU = np.array([[0.0], [scale]]), np.array([scale, -scale, 0.0])
        check(reports["E1"], {"I1": 1.0, "dU": dU, "l": l, "pi3_0": scale}, backend=backend)
    mixed = np.array([0.0, *SCALES])
    check(reports["E1"], {"I1": mixed[1:6], "dU": 0.25, "l": mixed[:, None], "pi3_0": -mixed[:, None, None]},
          backend=backend)
    k = np.array([0.5, 2.0**-1000]).reshape(2, 1, 1)
    check(reports["E3"], {"I1": 1.0, "I3": 0.5, "l": mixed[:, None], "omega": mixed, "k3": k, "d2U": -1.0},
          backend=backend)


CONSTANTS = [Fraction(1, 3), Fraction(1, 10**400), 10**400, 2**60 + 1, Decimal("0.1"), "1/3", "sqrt(2)",
             sqrt(2), sqrt(2) - 1,
             exp(-800), sin(1)]


@pytest.mark.parametrize("number", CONSTANTS, ids=str)
def test_exact_numbers(reports, number):
    """Fractions, roots, functions of numbers, long integers and texts are what they say, next to the boundary
    too.
    """
    exact = gs.algebra.numbers.exact_number(number)
    square = exact**2 / 4
    near = [square, square * (1 + Rational(1, 2**60)), square * (1 - Rational(1, 2**60))]
    dU = np.empty(3, dtype=object)
    dU[:] = near
    check(reports["E1"], {"I1": 1, "dU": dU, "l": number, "pi3_0": 0})
    check(reports["E1"], {"I1": 1, "dU": 0.125, "l": number, "pi3_0": np.linspace(-2, 2, 5)})


@pytest.mark.parametrize("bits", [60, 100, 115, 125, 140])
def test_exact_numbers_that_cancel(reports, bits):
    """l = √2 − p/2ⁿ with doubles next to l²/4: however few of the digits a short enclosure has."""
    number = sqrt(2) - Rational(math.isqrt(2 << 2 * bits), 2**bits)
    square = float((number**2 / 4).evalf(60))
    check(reports["E1"], {"I1": 1, "l": number, "pi3_0": 0.0,
                          "dU": np.array([square * (1 + n / 64) for n in range(-12, 13)])})
    check(reports["E1"], {"I1": number, "l": 1, "pi3_0": 0.0, "dU": np.array([1.0, -1.0])})


def test_a_root_that_is_zero(reports):
    """k3 = √2 + √3 − √(5 + 2√6), which is 0, is a tilt."""
    zero = sqrt(2) + sqrt(3) - sqrt(5 + 2 * sqrt(6))
    check(reports["E3"], {"I1": 1, "I3": 1, "l": 0, "omega": 0, "k3": zero, "d2U": np.array([-1.0, 1.0])})


def test_what_is_not_proved_is_undecided(reports):
    """P² = 4 I1 U' with U' = sin² 1 + cos² 1.

    No enclosure tells it from less or more, so neither does a verdict.
    """
    found = check(reports["E1"], {"I1": 1, "l": 2, "pi3_0": np.array([0.0, 1.0, -1.0]),
                                  "dU": sin(1) ** 2 + cos(1) ** 2, "d2U": 1})
    assert found.tolist()[1:] == [STABLE, UNSTABLE]


def test_what_is_not_proved_to_exist_is_refused(reports):
    """k3 = sin² 1 + cos² 1 and I1 = k3 − 1: Report.verdict refuses them, so do verdicts."""
    one = sin(1) ** 2 + cos(1) ** 2
    check(reports["E3"], {"I1": 1, "I3": 1, "l": 1, "omega": 1, "k3": one, "d2U": np.array([1.0, -9.0])})
    check(reports["E1"], {"I1": one - 1, "l": 1, "pi3_0": np.array([1.0, 2.0]), "dU": 0})


@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.int8, np.int64, np.uint16, ">f8"])
def test_every_real_type(reports, dtype):
    """Short floats and integers are the numbers that they are.

    They are not computed with in their own precision.
    """
    I1, dU, l = np.array([1, 3], dtype=dtype)[:,
                                              None], np.array([100, 0, 1],
                                                              dtype=dtype), np.array(100, dtype=dtype)
    check(reports["E1"], {"I1": I1, "dU": dU, "l": l, "pi3_0": 0.1})
    near = np.float32(0.1)
    check(reports["E1"], {"I1": 1, "l": near, "pi3_0": near,
                          "dU": neighbours(np.array([near * near], dtype=np.float32))})


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
    locked, real = [], arraysigns.ball
    monkeypatch.setattr(arraysigns, "ball", lambda
                        *given: locked.append(arraysigns.ONE_AT_A_TIME._is_owned()) or real(*given))
    arraysigns._near.cache_clear()
    verdicts(reports["E1 exp"], I1=1, b=np.array([[0.5], [0.25]]), l=sqrt(2), pi3_0=np.linspace(-1, 1, 9),
             threads=threads)
    assert locked and all(locked)


@pytest.mark.parametrize("shape", [(0,), (3, 0), (0, 3), (2, 0, 3)])
@pytest.mark.parametrize("backend", BACKENDS)
def test_no_points_no_verdicts(reports, shape, backend):
    """An empty grid has an empty array of verdicts."""
    found = verdicts(reports["E1"], I1=1, dU=1, l=np.ones(shape), pi3_0=1.0, backend=backend)
    assert found.shape == shape and found.dtype == np.int8


@pytest.mark.parametrize("backend", BACKENDS)
def test_the_filter_decides_ordinary_grids(reports, monkeypatch, backend):
    """No point of an ordinary grid needs balls or rationals, also with one outlier among the numbers."""
    monkeypatch.setattr(arraysigns, "ExactSign", None)
    monkeypatch.setattr(deciding, "CODE_OF", None)
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


@pytest.mark.parametrize(("name", "backend"), [("E1", "numpy"), ("E1", "numba"), ("E3 uniform, k3", "numpy"),
                                               ("free 3", "numpy"), ("E1 exp", "numpy")])
def test_a_filter_that_never_suffices_changes_nothing(reports, truth, monkeypatch, name, backend):
    """With e = ∞ the verdicts are the same."""
    monkeypatch.setattr(arraysigns, "error_bound", lambda *given: np.float64(np.inf))
    check(reports[name], omitted(reports[name], GRIDS[name]), truth(name), backend=backend)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("shape", [(60,), (6, 10)])
def test_the_boundary_is_decided_at_once(reports, monkeypatch, backend, shape):
    """Points of the boundary in doubles are one array for every rung; balls and rationals are not needed."""
    monkeypatch.setattr(arraysigns, "ExactSign", None)
    rng = np.random.default_rng(3)
    q, l, bend = (rng.integers(-9, 9, shape) / 2.0**n for n in (20, 30, 0))
    I1 = rng.integers(1, 2**20, shape) / 2.0**10
    check(reports["E1"], {"I1": I1, "dU": I1 * q * q, "l": l, "pi3_0": 2 * I1 * q - l,
                          "d2U": np.where(bend > 3, bend, -I1 * q * q), "d3U": bend, "d4U": 1.0},
          backend=backend)
    w, z = rng.integers(1, 9, shape) / 4, rng.uniform(-0.9, 0.9, shape)
    check(reports["E3"], {"I1": 1.0, "I3": 1.0, "l": z, "omega": 1.0, "k3": z, "d2U": -1.0,
                          "d3U": np.where(w > 1, 0, w), "d4U": bend}, backend=backend)


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
