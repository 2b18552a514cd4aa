"""The error bound: no floating-point value is further from the exact one, whatever the scale, and the bound
is not much too large.
"""
import math
import operator
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from charts.rounded_programs import (
    LEAVES,
    NOWHERE,
    floats,
    holds,
    in_floats,
    ordinary,
    small,
    subnormal,
    w,
    x,
    y,
    z,
)
from hypothesis import assume, example, given
from hypothesis import strategies as st
from sympy import Add, Integer, Mul, Rational

from gyrostat.charts.programs.rounding import SLACK, UNIT, error_bound, rounded
from gyrostat.charts.programs.straightline import Program, Step, program_of

positive = st.integers(1, 2**60)


@st.composite
def programs(draw, steps=9, degree=8):
    """Random steps, no product of more than so many leaves; constants p/q of ordinary size."""
    made = [Step("leaf", (), leaf, NOWHERE) for leaf in LEAVES[:draw(st.integers(1, 4))]]
    made += [Step("constant", (), Rational(draw(positive), draw(positive)), NOWHERE)
             for _ in range(draw(st.integers(0, 2)))]
    degrees = [1] * len(made)
    for _ in range(draw(st.integers(1, steps))):
        operation = draw(st.sampled_from(["add", "subtract", "multiply", "multiply", "negative"]))
        arguments = tuple(draw(st.integers(0, len(made) - 1))
                          for _ in range(1 if operation == "negative" else 2))
        most = (sum if operation == "multiply" else max)([degrees[i] for i in arguments])
        if most <= degree:
            made.append(Step(operation, arguments, None, NOWHERE))
            degrees.append(most)
    return Program(tuple(made))


@st.composite
def polynomials(draw):
    """Random polynomials, some with squares of sums."""
    whole = st.integers(-20, 20).map(Integer)
    monomials = [Mul(draw(whole), *draw(st.lists(st.sampled_from(LEAVES), max_size=4)))
                 for _ in range(draw(st.integers(1, 5)))]
    square = Add(*(draw(whole) * leaf for leaf in LEAVES[:3])) ** draw(st.integers(1, 3))
    return draw(whole) * square + Add(*monomials)


@given(program=programs(), values=st.lists(floats, min_size=4, max_size=4), computed=st.booleans())
def test_the_error_of_any_program_is_within_the_bound(program, values, computed):
    """abs(x̂ − x) ≤ e for random steps at doubles of every size, zeros and subnormal ones included, with the
    steps as computed or without.
    """
    at = dict(zip(LEAVES, values))
    assert holds(program, at, at, {}, computed)


@given(expression=polynomials(), values=st.lists(st.one_of(ordinary, small, subnormal), min_size=4,
                                                 max_size=4), data=st.data())
def test_the_error_of_a_polynomial_is_within_the_bound(expression, values, data):
    """abs(x̂ − x) ≤ e for programs as they are written for polynomials, squares completed."""
    program, at = program_of(expression, {}), dict(zip(LEAVES, values))
    assert holds(program, at, at, {}, data.draw(st.booleans()))


@st.composite
def nearly_zero(draw):
    """A double and numbers that a sum with it cancels, down to the last bit or two."""
    first = draw(ordinary.filter(bool))
    return first, -first + draw(st.integers(-3, 3)) * math.ulp(first)


@given(pair=nearly_zero(), others=st.tuples(ordinary, ordinary), program=programs(), computed=st.booleans())
def test_cancelling_sums(pair, others, program, computed):
    """The bound holds where sums cancel to their last bits, and after products with what is left."""
    at = dict(zip(LEAVES, (*pair, *others)))
    assert holds(program, at, at, {}, computed)
    assert holds(program_of((x + y) ** 2 * z - w, {}), at, at, {}, computed)


fractions = st.builds(lambda p, q, e: Fraction(p, q) * Fraction(2) ** e, st.integers(-2**70, 2**70),
                      positive, st.integers(-60, 60))


@given(program=programs(), exact=st.lists(fractions, min_size=4, max_size=4), cancel=st.booleans(),
       computed=st.booleans())
def test_rounded_inputs_are_counted(program, exact, cancel, computed):
    """abs(x̂ − x) ≤ e where leaves are fractions, each correctly rounded and counted as one rounding.

    Also where their sum cancels.
    """
    if cancel:
        exact[1] = -exact[0] * (1 + Fraction(1, 2**54))
    at = dict(zip(LEAVES, exact))
    near = {leaf: float(v) for leaf, v in at.items()}
    roundings = {leaf: 1 for leaf in LEAVES if Fraction(near[leaf]) != at[leaf]}
    assert holds(program, near, at, roundings, computed)


@given(values=st.lists(fractions, min_size=2, max_size=2), n=st.integers(2, 6))
def test_sums_of_rounded_numbers_are_not_exact(values, n):
    """A sum of two rounded numbers may cancel to nothing.

    What was computed of it says nothing of its error.
    """
    a = values[0] or Fraction(1, 3)
    at = {x: a, y: -a * (1 + Fraction(1, 2**60 + n))}
    near = {leaf: float(v) for leaf, v in at.items()}
    at[z], near[z] = Fraction(3), 3.0
    for expression in (x + y, (x + y) * z, (x + y) ** n):
        assert holds(program_of(expression, {}), near, at, {x: 1, y: 1}, computed=True)
    leaves = (Step("leaf", (), x, NOWHERE), Step("leaf", (), y, NOWHERE), Step("add", (0, 1), None, NOWHERE))
    assert holds(Program((*leaves, Step("negative", (2,), None, NOWHERE))), near, at, {x: 1, y: 1},
                 computed=True)


@pytest.mark.parametrize(("expression", "roundings", "count"), [
    (x + y, {}, 1), (x * y, {}, 2), (x * y * z, {}, 4), (x * y + z, {}, 3), (x * y + z * w, {}, 3),
    (x * y + z, {z: 7}, 8),    (x + y, {x: 3, y: 5}, 6),
    (x * y, {x: 3, y: 5}, 10), (x**2 + y + z, {}, 3), (x * y + y * z + z * w, {}, 4), (x / 3, {}, 3),
    (x / 4, {}, 2),
    (x, {}, 0), (3 + x, {x: 2}, 3),
    (x**4, {}, 6)])
def test_counts_of_roundings(expression, roundings, count):
    """A sum of two counts the larger and one more, a product both and two more.

    A constant that is no double counts one.
    """
    bound = float(error_bound(program_of(expression, {}), dict.fromkeys(LEAVES, 1.0), roundings))
    size = sum(abs(c) for c in expression.expand().as_coefficients_dict().values())
    # the bound itself is rounded in a few operations, and what underflow adds is below 2⁻¹⁰⁰⁰
    assert bound == pytest.approx(count * UNIT * SLACK * float(size), rel=1e-12, abs=2.0**-1000)


def test_a_change_of_sign_rounds_nothing():
    """−x counts what x does."""
    program = Program((Step("leaf", (), x, NOWHERE), Step("negative", (0,), None, NOWHERE)))
    # rounded in a few operations
    assert float(error_bound(program, {x: 1.0}, {x: 4})) == pytest.approx(4 * UNIT * SLACK, rel=1e-12)


@given(expression=polynomials(), values=st.lists(ordinary, min_size=4, max_size=4))
def test_the_bound_is_not_vacuous(expression, values):
    """For ordinary numbers e < 100 u M, M the program with all signs positive, and e is not below u/4 times
    the value.
    """
    program, at = program_of(expression, {}), dict(zip(LEAVES, values))
    positive = SimpleNamespace(add=operator.add, subtract=operator.add, multiply=operator.mul,
                               negative=operator.pos)
    size = program.run(lambda leaf: abs(at[leaf]), lambda c: float(c), positive)[-1]
    bound = float(error_bound(program, {leaf: abs(v) for leaf, v in at.items()}, {}))
    assert bound <= 100 * 2.0**-53 * size + 2.0**-1000
    assume(expression.free_symbols)
    assert bound >= 2.0**-55 * abs(float(in_floats(program, at)[-1]))


def test_a_sum_of_exact_numbers_is_known_to_its_size():
    """(x + y)² z with x ≈ −y: with the steps as computed the bound is relative, without it is not."""
    program, at = program_of((x + y) ** 2 * z, {}), {x: 1.0, y: -1 + 2.0**-50, z: 3.0}
    steps = in_floats(program, at)
    sizes = {leaf: abs(v) for leaf, v in at.items()}
    assert (
        float(error_bound(program, sizes, {}, steps))
        < 2.0**-48 * float(steps[-1])
        < 1e-10 * float(error_bound(program, sizes, {}))
    )


@given(program=programs(), rows=st.lists(st.lists(floats, min_size=4, max_size=4), min_size=1, max_size=4))
def test_one_bound_for_many_points(program, rows):
    """The bound at the largest abs(leaf) is no smaller than the bound at each point.

    On arrays it is that of each element.
    """
    columns = {leaf: np.abs(np.array(column)) for leaf, column in zip(LEAVES, zip(*rows))}
    together = float(error_bound(program, {leaf: float(c.max()) for leaf, c in columns.items()}, {}))
    each = np.broadcast_to(error_bound(program, columns, {}), len(rows))
    for n in range(len(rows)):
        alone = float(error_bound(program, {leaf: float(c[n]) for leaf, c in columns.items()}, {}))
        assert alone == each[n] <= together


@given(p=st.integers(1, 2**1100), q=st.integers(1, 2**1100))
@example(1, 3)
@example(2**53 + 1, 1)
@example(2**53 - 1, 2**60)
@example(1, 2**1074)
@example(1, 2**1080)
@example(2**1030, 1)
def test_constants_are_rounded_once(p, q):
    """A positive rational is the double nearest to it, counted 0 if that is it, else 1.

    ∞ above all doubles.
    """
    near, count = rounded(Rational(p, q))
    exact = Fraction(p, q)
    if math.isinf(near):
        assert exact > Fraction(1.7976931348623157e308) and count == 1
        return
    error = abs(Fraction(near) - exact)
    assert error <= abs(Fraction(math.nextafter(near, math.inf)) - exact)
    assert error <= abs(Fraction(math.nextafter(near, 0.0)) - exact)
    assert count == 1 or error == 0
    assert count == 0 or error or near <= 2.0**-1022


def test_fused_products_are_within_the_bound():
    """A product that is not rounded before it is added, as a processor may do, is closer than the bound too.
    """
    a, b, c = 1 + 2.0**-30, 1 - 2.0**-30, -1.0
    program = program_of(x * y + z, {})
    fused = float(Fraction(a) * Fraction(b) + Fraction(c))
    assert fused != a * b + c
    bound = float(error_bound(program, {x: a, y: b, z: 1.0}, {}))
    assert abs(Fraction(fused) - (Fraction(a) * Fraction(b) + Fraction(c))) <= Fraction(bound)
