"""The branches of plane curves over t, against the roots that NumPy finds."""
import random

import numpy as np
import pytest
from sympy import Rational, Symbol, oo

from gyrostat.algebra.solving.plane_branches import strands
from gyrostat.errors import ScopeError

x, t = Symbol("x"), Symbol("t")


def drawn(rng):
    """A monic quartic in x with coefficients that are polynomials in t."""
    return x**4 + sum(rng.randint(-5, 5) * x**i * t**j for i in range(4) for j in range(3))


def roots(F, at):
    found = np.roots([float(c) for c in F.subs(t, at).as_poly(x).all_coeffs()])
    return sorted(r.real for r in found if abs(r.imag) < 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_every_root_is_on_one_strand(seed):
    F = drawn(random.Random(seed))
    found = strands(F, x, t, {})
    for at in (Rational(n, 7) for n in range(-40, 41)):
        places = sorted(span.place for strand in found for span in strand.spans if span.low < at < span.high)
        assert places == list(range(len(roots(F, at)))), at
    for strand in found:
        low, high = strand.spans[0], strand.spans[-1]
        for value, at, place, beside in ((strand.first, low.low, low.place, 1e-9),
                                         (strand.last, high.high, high.place, -1e-9)):
            assert (value is None) == (at in (oo, -oo))
            if value is not None:
                assert abs(roots(F, float(at) + beside)[place] - float(value)) < 1e-2


def test_strands_cross_where_it_is_known():
    found = strands((x - t) * (x + t) - t**4 / 100, x, t, {Rational(0): {Rational(0): True}})
    assert [[span.place for span in strand.spans] for strand in found if strand.spans[0].low == -oo] == [
        [1, 0], [0, 1]]


def test_two_pairs_meet_at_one_value():
    found = strands((x**2 - 2) ** 2 - t, x, t, {Rational(4): {Rational(0): False}})
    assert sorted(str(strand.first) for strand in found if strand.spans[0].low == 0) == [
        "-sqrt(2)", "-sqrt(2)", "sqrt(2)", "sqrt(2)"]


def test_complex_roots_that_meet():
    assert len(strands((x**2 + 1) ** 2 + (x - 1) * t, x, t, {})) > 0
    assert strands((x**2 + 1) ** 2 + t**2, x, t, {}) == []


def test_what_is_not_told_apart():
    """Branches that touch, or cross unknown."""
    for F in ((x - t**2) * (x + t**2), x**2 - t**2, x**3 - t * x):
        with pytest.raises(ScopeError, match="at t = 0 several branches meet, and it is not decided"):
            strands(F, x, t, {})
