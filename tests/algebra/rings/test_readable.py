"""What is printed is what was derived: every rewriting keeps the value."""
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, cancel, expand, sqrt

import gyrostat as gs
from gyrostat.algebra.rings.readable import readable, split
from gyrostat.printing.order import inequality, over

I1, I3, l, pi3, dU, d2U, k3, omega, m0, m1 = map(gs.symbol,
                                                 ("I1", "I3", "l", "pi3_0", "dU", "d2U", "k3", "omega", "m0",
                                                  "m1"))
terms = st.lists(st.tuples(st.integers(-4, 4).filter(bool),
                           st.lists(st.sampled_from([I1, I3, l, pi3, k3, m0]), max_size=3)), min_size=1,
                 max_size=5)


def polynomial(parts):
    total = Rational(0)
    for c, factors in parts:
        for f in factors:
            c = c * f
        total += c
    return total


@pytest.mark.slow
@given(terms, terms)
def test_rewriting_keeps_the_value(top, bottom):
    """readable and split change the form of a fraction, never its value."""
    expression = polynomial(top) / (polynomial(bottom) if polynomial(bottom) != 0 else 1)
    assert cancel(readable(expression) - expression) == 0 and cancel(split(expression) - expression) == 0


@pytest.mark.parametrize("report", ["e1", "e2", "e3", "at_rest"])
def test_inequalities_are_the_margins(report, request):
    """left − right is the margin."""
    report = request.getfixturevalue(report)
    for criterion in (report.necessary, report.sufficient, report.casimirs_only):
        for condition in (c for alternative in criterion.alternatives for c in alternative):
            left, right = inequality(condition)
            assert expand(left - right - condition.margin) == 0


def test_e1_reads_as_in_the_source(e1, e2):
    """(π3 + l)² > ±4 I1 U'(±1)."""
    assert inequality(e1.sufficient.alternatives[0][0]) == ((l + pi3) ** 2, 4 * I1 * dU)
    assert inequality(e2.sufficient.alternatives[0][0]) == ((l + pi3) ** 2, -4 * I1 * dU)


def test_squares_are_completed():
    """p of E3 is (l − (2 I1 − I3) ω k3)² + I1 (1 − k3²) (I1 ω² + U'')."""
    p = expand((l - (2 * I1 - I3) * omega * k3) ** 2 + I1 * (1 - k3**2) * (I1 * omega**2 + d2U))
    assert readable(p) == (l - k3 * omega * (2 * I1 - I3)) ** 2 + I1 * (1 - k3**2) * (I1 * omega**2 + d2U)


def test_numerator_and_denominator():
    """−(a + b)/(2 c) keeps its sum together."""
    top, bottom = over(-(l + pi3) / (2 * I1))
    assert bottom == 2 * I1 and expand(top + l + pi3) == 0
    assert over(sqrt(2) * l) == (sqrt(2) * l, 1)
