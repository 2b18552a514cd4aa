"""Programs in floats and in fractions."""
import math
from fractions import Fraction

import numpy as np
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.charts.programs.rounding import SMALLEST, error_bound, rounded

LEAVES = tuple(gs.symbol(f"x{n}") for n in range(4))
x, y, z, w = LEAVES
NOWHERE = frozenset()
mantissas = st.integers(-2**53, 2**53)
ordinary = st.builds(lambda m, e: math.ldexp(m, e - 53), mantissas, st.integers(-4, 4))
large = st.builds(lambda m, e: math.ldexp(m, e - 53), mantissas, st.integers(400, 1020))
small = st.builds(lambda m, e: math.ldexp(m, e - 53), mantissas, st.integers(-1022, -400))
subnormal = st.integers(-2**52, 2**52).map(lambda m: m * SMALLEST)
floats = st.one_of(ordinary, ordinary, large, small, subnormal,
                   st.sampled_from([0.0, -0.0, 1.0, -1.0, 5e-324, -5e-324, 2.0**-1022, 1e308]))


def in_floats(program, values):
    """Every step in doubles."""
    with np.errstate(all="ignore"):
        return program.run(lambda leaf: np.float64(values[leaf]), lambda c: np.float64(rounded(c)[0]))


def exactly(program, values):
    """The result in Fractions."""
    return program.run(lambda leaf: Fraction(values[leaf]), lambda c: Fraction(int(c.p), int(c.q)))[-1]


def holds(program, floats, exact, roundings, computed=False):
    """Whether abs(value − exact value) is at most the bound, in Fractions; the bound may be ∞."""
    steps = in_floats(program, floats)
    bound = float(error_bound(program, {leaf: abs(v) for leaf, v in floats.items()}, roundings,
                              steps if computed else None))
    if bound == math.inf:
        return True
    return abs(Fraction(float(steps[-1])) - exactly(program, exact)) <= Fraction(bound)
