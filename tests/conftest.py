"""Scenes and reports that many tests read; derived once."""
import gc
import os

import pytest
from hypothesis import settings

import gyrostat as gs

# pytest --hypothesis-profile thorough
settings.register_profile("thorough", deadline=None, derandomize=True, max_examples=200)
settings.register_profile("exact", deadline=None, derandomize=True, max_examples=25)
settings.load_profile("exact")

# modules, tests and reports are kept to the end: a search among them for what can be freed is made rarely
gc.set_threshold(50_000, 20, 20)

os.environ.pop("COLUMNS", None)                       # what is captured has the width of a pipe, in any shell


def pytest_addoption(parser):
    parser.addoption("--full", action="store_true", help="long campaigns at full size")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Of a test marked few(n) n cases, evenly spaced, run by default; the others are slow, as pages are."""
    cases = {}
    for item in items:
        if item.path.suffix == ".md" and item.path.name != "README.md":
            item.add_marker(pytest.mark.slow)
        if item.get_closest_marker("few") and not item.get_closest_marker("slow"):
            cases.setdefault((item.path, item.originalname), []).append(item)
    for group in cases.values():
        (count,) = group[0].get_closest_marker("few").args
        default = {n * len(group) // count for n in range(count)}
        for n, item in enumerate(group):
            if n not in default:
                item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="session")
def full(request):
    """Whether a slow test of many minutes is run in full."""
    return request.config.getoption("--full")


@pytest.fixture(scope="session")
def scene():
    """Gyrostat of revolution in an unspecified U(k3)."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())


@pytest.fixture(scope="session")
def e1(scene):
    return gs.analyze(gs.upright(scene))


@pytest.fixture(scope="session")
def e2(scene):
    return gs.analyze(gs.hanging(scene))


@pytest.fixture(scope="session")
def e3(scene):
    return gs.analyze(gs.inclined(scene))


@pytest.fixture(scope="session")
def at_rest(scene):
    return gs.analyze(gs.static_tilt(scene))


@pytest.fixture(scope="session")
def asymmetric():
    """Three moments, l and centre of mass on axis 3, in the Newtonian field of a general body."""
    I, m0, m1 = [gs.symbol(f"I{i}") for i in (1, 2, 3)], gs.symbol("m0"), gs.symbol("m1")
    potential = gs.general_potential(lambda *k: m0 * k[2] + m1 / 2 * sum(a * x**2 for a, x in zip(I, k)))
    return gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))), potential)


@pytest.fixture(scope="session")
def upright_asymmetric(asymmetric):
    """The general body upright, in its spin."""
    return gs.analyze(gs.equilibrium(asymmetric, (0, 0, gs.symbol("pi3_0"), 0, 0, 1)))


@pytest.fixture(scope="session")
def general(asymmetric):
    """The rotation of the general body about axis 3, in its rate."""
    return gs.analyze(gs.equilibrium(asymmetric, (0, 0, gs.symbol("I3") * gs.symbol("omega"), 0, 0, 1)))


@pytest.fixture(scope="session")
def free():
    """Free gyrostat, l on axis 3."""
    return gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))))
