"""Claims of certified boxes, held against the exact verdict at points of them."""
from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from gyrostat.errors import ValuesError
from gyrostat.stability.decision import Verdict

CODES = {1: Verdict.STABLE, -1: Verdict.UNSTABLE}
HEAVY = {"I1": 1, "m0": 1, "l": (-4, 4), "pi3_0": (-4, 4)}
NAMES = ("E1", "E2", "E3", "E3 at rest", "uniform field", "tilt eliminated", "quartic", "pole",
         "steep exponential", "exponential",
         "logarithm", "logarithm at E1", "irrational numbers", "general body", "free body",
         "a margin that is a square", "minus a square",
         "nothing but a spin")


def points(draw, low, high, number=2):
    """Corners, points of edges and of the inside of a box, exact."""
    ends = [(Fraction(x), Fraction(y)) for x, y in zip(low.tolist(), high.tolist())]
    yield from product(*ends) if len(ends) < 3 else [tuple(draw.choice(pair) for pair in ends)]
    for _ in range(number):
        yield tuple(x + (y - x) * Fraction(draw.choice([0, 1, draw.randint(1, 99) / 100])) for x, y in ends)


def verdict_at(report, numbers):
    """The exact verdict, None where there is no equilibrium."""
    try:
        return report.verdict(numbers).verdict
    except ValuesError:
        return None


def assert_claims(report, chart, draw, sample=50):
    """The exact verdict is the one claimed, at points of some boxes; at() says the same."""
    proved = np.flatnonzero(chart.code)
    for n in draw.sample(proved.tolist(), min(sample, len(proved))):
        claim = CODES.get(int(chart.code[n]))
        for point in points(draw, chart.low[n], chart.high[n]):
            named = dict(zip(chart.axes, point))
            found = verdict_at(report, dict(chart.fixed) | named)
            assert found in (claim, None), (named, claim)
            if claim is not None:
                assert found is None or chart.at(**named) is claim
            else:
                with pytest.raises(ValuesError, match="no equilibrium"):
                    chart.at(**named)
