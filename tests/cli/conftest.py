"""The scene of most verbs."""
import pytest

import gyrostat as gs


@pytest.fixture(scope="session")
def heavy():
    """The gyrostat of revolution in the uniform field."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
