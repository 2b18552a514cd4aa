"""Verdicts on arrays next to the boundary, at every scale, at exact numbers: what Report.verdict says."""
import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from charts.checked_arrays import check
from sympy import Rational, cos, exp, sin, sqrt

import gyrostat as gs
from gyrostat.charts.codes import STABLE, UNDECIDED, UNSTABLE
from gyrostat.charts.signs import grid_signs as arraysigns

BACKENDS = ["numpy", "numba"]


def neighbours(x, n=3):
    """2n + 1 doubles about each."""
    columns, down, up = [x], x, x
    for _ in range(n):
        down, up = np.nextafter(down, -np.inf), np.nextafter(up, np.inf)
        columns += [down, up]
    return np.stack(columns)


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.few(1)
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("name", ["E3 degree 20", "E3 exp"])
def test_stiff_fields(reports, name, backend):
    """T₂₀(k3), exp(50 k3): k3 up to 1 − 2⁻⁵³, slow and fast rates."""
    report, k = reports[name], np.array([-0.99, -0.7, -0.1, 0.0, 0.05, 0.3, 0.9, 1 - 2.0**-53])
    omega = np.array([0.5, 8.0, 1e5]).reshape(3, 1, 1)
    check(report, {"I1": 1.0, "I3": 0.5, "a": np.array([[1.0], [-1e-6]]), "omega": omega, "k3": k},
          backend=backend)


SCALES = [1e-160, 1e-150, 1e-100, 1.0, 1e100, 1e150, 1e200, 1.7e308, 5e-324, 2.0**-1040]


@pytest.mark.few(1)
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
    exact = gs.algebra.text.numbers.exact_number(number)
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


@pytest.mark.few(1)
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
