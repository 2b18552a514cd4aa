"""What a confirmation says where the motion is too slow, too steep or not enough to tell."""
import pytest
from sympy import Rational
from trajectories.confirming import LARGE, one_direction

import gyrostat as gs
from gyrostat.stability.criteria.numbers_asked import exact_values
from gyrostat.stability.decision import Verdict
from gyrostat.trajectories.confirmation import _rates, confirm

few = pytest.fixture(autouse=True)(one_direction)


@pytest.mark.slow
def test_no_slope_is_expected_of_a_normal_form():
    """An asymmetric top spinning fast about its longest axis is stable by D4, its energy no extremum."""
    pytest.importorskip("heyoka")
    scene = gs.assemble(gs.Gyrostat((2, 3, 1), (0, 0, 0)), gs.general_potential(lambda x, y, z: z))
    found = confirm(gs.analyze(gs.equilibrium(scene, (0, 0, 10, 0, 0, 1))), {}, LARGE)
    assert found.decision.verdict is Verdict.STABLE and found.decision.pointwise
    assert found.expected is None and found.agrees
    assert abs(found.slope - 1) < 0.05


@pytest.fixture(scope="module")
def steep():
    """A regular precession on its boundary in a steep U, unstable to second order, and its numbers."""
    k3 = gs.symbol("k3")
    U = (k3**2 + k3**3 / 2 - Rational(4963252761, 1600000) * (k3 + Rational(4, 5)) ** 2 - 19 * k3**4 / 8
         + 19 * k3 / 8)
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))))
    return report, {"I1": "5/4", "I3": "15/8", "omega": "1/8", "k3": "-4/5"}


def test_a_nilpotent_linearisation_has_no_rates(steep):
    """All eigenvalues are 0, where those of the matrix in doubles are 10⁻⁶, and e-folding would take 10⁶."""
    report, values = steep
    numbers = exact_values(report.equilibrium, values, report.required, report.parameters)
    assert _rates(report, numbers) == (0, 0)


@pytest.mark.slow
def test_a_steep_boundary_is_confirmed(steep):
    """The smallest perturbation, whose quadrature is too hard, is integrated for a time that fits it."""
    pytest.importorskip("heyoka")
    report, values = steep
    found = confirm(report, values)
    assert found.decision.verdict is Verdict.UNSTABLE and found.agrees
    assert len(found.sizes) > 5 and abs(found.slope) < 1e-6
