"""Cases of a parametrised test that run outside the default test command."""
import pytest


def slow(*cases):
    """The cases, each a tuple, marked slow."""
    return [pytest.param(*case, marks=pytest.mark.slow) for case in cases]
