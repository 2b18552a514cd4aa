"""Scenes in polynomial fields, for several files of this folder."""
import pytest
from equilibria import branching, meetings

import gyrostat as gs


@pytest.fixture(scope="session")
def polynomial():
    """Gyrostat of revolution in U = a1 k3 + … + a6 k3⁶."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(branching.FIELD))


@pytest.fixture(scope="session")
def quintic():
    """Gyrostat of revolution in U = a1 k3 + … + a5 k3⁵."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(meetings.FIELD))
