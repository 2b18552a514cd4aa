"""The bound of the rounding error where products underflow or overflow."""
import math

import numpy as np
import pytest
from charts.rounded_programs import LEAVES, NOWHERE, floats, holds, in_floats, w, x, y, z
from hypothesis import example, given
from hypothesis import strategies as st
from sympy import Integer

from gyrostat.charts.programs.rounding import LARGEST, SMALLEST, error_bound
from gyrostat.charts.programs.straightline import Program, Step, program_of


@pytest.mark.parametrize("computed", [False, True])
@pytest.mark.parametrize(("expression", "at"), [
    (x * y, (2.0**-600, 3 * 2.0**-480)), (x * y, (5e-324, 0.5)), (x * y * z, (1e-200, 1e-200, 1e300)),
    (x**2 * y, (1.1e-162, 1e290)),
    (x * y * z - w, (1e-200, 1e-200, 1e300, 1e-100)), ((x * y) ** 2 * z, (3e-90, 1e-80, 1e300)),
    (x * y * (z * w), (1e-170, 1e-170, 1e160, 1e150)),
    ((x - y) * z, (1e-308, 0.9999999999999999e-308, 1e300)), (x**3 - y, (1e-108, 1e-324)),
    ((x * x + y * y) * z, (1e-170, 1e-165, 1e300)),
    (x * y * z * w, (1e-200, 1e-200, 1e200, 1e200)), (3 * x * y * z, (2e-162, 2e-162, 1e305)),
    ((w - x * y) * z, (1e-170, 1e-170, 1e300, 0.0)), ((x * y - w) * z, (1e-170, 1e-170, 1e300, 0.0))])
def test_what_underflow_loses(expression, at, computed):
    """A product that underflows loses up to 2⁻¹⁰⁷⁵, which later products may multiply by up to 2¹⁰⁰⁰."""
    at = dict(zip(LEAVES, (*at, 1.0, 1.0)))
    assert holds(program_of(expression, {}), at, at, {}, computed)


def test_underflow_on_either_side_of_a_sum():
    """What underflow adds to a sum is what it adds to both of its parts."""
    tiny = [Step("leaf", (), leaf, NOWHERE) for leaf in (x, y, z, w)] + [
        Step("multiply", (0, 1), None, NOWHERE)
    ]
    at = {x: 1e-170, y: 1e-170, z: 1e300, w: 0.0}
    for operation in ("add", "subtract"):
        for arguments in ((3, 4), (4, 3)):
            steps = (*tiny, Step(operation, arguments, None, NOWHERE),
                     Step("multiply", (5, 2), None, NOWHERE))
            assert holds(Program(steps), at, at, {}) and holds(Program(steps), at, at, {}, computed=True)


@pytest.mark.parametrize("exponent", [310, 320, 330, 400])
@pytest.mark.parametrize("factor", [1.0, 1e150, 1e300])
def test_tiny_constants_underflow_too(exponent, factor):
    """A constant below 2⁻¹⁰²² as a double is off by up to 2⁻¹⁰⁷⁵, which a later product multiplies."""
    at = {x: factor}
    assert holds(program_of(x / Integer(10) ** exponent, {}), at, at, {})
    assert holds(program_of(3 * x / Integer(10) ** exponent, {}), at, at, {}, computed=True)


@pytest.mark.slow
@given(values=st.lists(floats, min_size=2, max_size=2))
@example([1e200, 1e200])
@example([LARGEST, 1.0])
@example([LARGEST / 2, 3.0])
def test_no_bound_where_it_may_overflow(values):
    """e = ∞ exactly where a step with all signs positive may pass 2¹⁰⁰⁰."""
    a, b = map(abs, values)
    program, at = program_of(x * y - x, {}), {x: a, y: b}
    with np.errstate(over="ignore"):
        largest = max(float(np.float64(b) + np.float64(1)), a, b, float(np.float64(a) * (np.float64(b) + 1)),
                      float(np.float64(a) * b + a))
    bound = float(error_bound(program, at, {}))
    assert math.isinf(bound) if largest > LARGEST else largest == LARGEST or math.isfinite(bound)


@pytest.mark.parametrize("size", [math.inf, math.nan])
@pytest.mark.parametrize("expression", [x + y, x * y, x * y - z, z * x - y, (x + 1) ** 2])
def test_no_bound_for_what_is_not_finite(expression, size):
    """e = ∞ where a magnitude, or a computed step, is ∞ or NaN, also times 0."""
    for other in (0.0, 1.0):
        magnitudes = {x: size, y: other, z: other}
        program = program_of(expression, {})
        assert error_bound(program, magnitudes, {}) == math.inf
        with np.errstate(all="ignore"):
            assert error_bound(program, magnitudes, {}, in_floats(program, magnitudes)) == math.inf


def test_what_underflow_adds():
    """A η, A = 2 for a product and 4 A + 4 at the end.

    12 η for a product of two, no less where the factors are 0.
    """
    for size in (0.0, 1e-320):
        assert error_bound(program_of(x * y, {}), {x: size, y: size}, {}) == 12 * SMALLEST
    assert error_bound(program_of(x + y, {}), {x: 0.0, y: 0.0}, {}) == 4 * SMALLEST
