"""Cases of a parametrised test that run outside the default test command."""
import pytest


def slow(*cases):
    """The cases, each a tuple, marked slow."""
    return [pytest.param(*case, marks=pytest.mark.slow) for case in cases]


def sampled(count, full, part):
    """How many cases of a campaign are run: all with --full, else a part of those that are slow."""
    return count if full else min(count, part)
