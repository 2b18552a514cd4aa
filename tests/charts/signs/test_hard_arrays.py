"""The hard cases of the benchmarks.

Certified arrays against the truth of the same floats in whole numbers, no point wrong or undecided.
"""
import sys
from pathlib import Path

import numpy as np
import pytest

BENCHMARKS = str(Path(__file__).parents[3] / "benchmarks")


@pytest.fixture(scope="module")
def hard():
    """The generators, the truth and the arguments of the benchmarks."""
    sys.path.insert(0, BENCHMARKS)
    try:
        import hard_cases
        import verdict_routes
    finally:
        sys.path.remove(BENCHMARKS)
    return hard_cases, verdict_routes


@pytest.mark.slow
@pytest.mark.parametrize(("backend", "seed"), [
    ("numpy", 1), *(pytest.param(backend, seed, marks=pytest.mark.slow)
                    for backend, seed in (("numpy", 2), ("numba", 1), ("numba", 2)))])
def test_no_hard_point_is_wrong_or_undecided(hard, backend, seed):
    """Near the boundary to the next float, on it, cancelling momenta, I1 → I3, abs(k3) → 1, stiff fields,
    10^±150 and subnormals.
    """
    hard_cases, routes = hard
    seen = {}
    for batch in hard_cases.cases(40, seed):
        found = routes.certified(backend)(batch)
        assert (found == batch.truth).all(), (batch.kind, batch.family, batch.label,
                                              np.flatnonzero(found != batch.truth)[:5])
        seen.setdefault((batch.kind, batch.family), set()).update(found.tolist())
    assert set(seen) == {(kind, family) for kind in hard_cases.KINDS for family in hard_cases.FAMILIES}
    assert all(codes == {1, -1} for codes in seen.values())


def test_a_point_on_the_boundary_has_a_truth(hard):
    """Of many: a coefficient that decides is never 0, whatever cancels by chance."""
    hard_cases, _ = hard
    for kind in hard_cases.KINDS:
        for seed in (0, 9):                            # something cancels in both vertical kinds, in E3
            values = hard_cases.on_boundary(kind, 4000, np.random.default_rng(seed))
            assert set(hard_cases.truth(kind, "unspecified", values)[0]) == {1, -1}


@pytest.mark.slow
def test_the_truth_is_not_what_doubles_say(hard):
    """The cases are hard: the margin in doubles is wrong or silent in each of these families, so that they do
    test something.
    """
    hard_cases, routes = hard
    missed = {batch.family for batch in hard_cases.cases(40, 1)
              if (routes.compiled("numpy")(batch) != batch.truth).any()}
    assert {"a", "b", "c", "f"} <= missed
