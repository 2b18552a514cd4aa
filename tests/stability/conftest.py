"""What several files of this folder derive from a scene."""
import pytest

from gyrostat.stability.theorems.drift import Drift


@pytest.fixture(scope="session")
def drift(e3):
    """Of E3 in an unspecified U."""
    return Drift(e3.equilibrium)
