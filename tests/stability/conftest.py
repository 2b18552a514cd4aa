"""Scenes and what is derived from them, for several files of this folder."""
import branching
import meetings
import pytest

import gyrostat as gs
from gyrostat.stability.theorems.drift import Drift


@pytest.fixture(scope="session")
def drift(e3):
    """Of E3 in an unspecified U."""
    return Drift(e3.equilibrium)


@pytest.fixture(scope="session")
def polynomial():
    """Gyrostat of revolution in U = a1 k3 + … + a6 k3⁶."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(branching.FIELD))


@pytest.fixture(scope="session")
def quintic():
    """Gyrostat of revolution in U = a1 k3 + … + a5 k3⁵."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(meetings.FIELD))
