"""Arrays of verdicts say what single verdicts say: every kind of scene, damped or not, on both backends."""
import random

import numpy as np
import pytest
from scene_kinds import CASES

from gyrostat.charts import verdicts
from gyrostat.charts.codes import CODE_OF, INVALID
from gyrostat.errors import GyrostatError
from gyrostat.mechanics.equilibrium.unit_vectors import in_any_direction

# few numbers, so that margins vanish, and no equilibrium exists, at some points
FEW = {"I": [0.5, 1, 1.5, 2, 3], "k": [-0.75, 0, 0.5], "u": [0, 0.5, -1, 2]}
KINDS = [(name, damped) for name, case in CASES.items() for damped in (False, True)
         if not in_any_direction(case.equilibrium)]


def code_of(report, numbers, damped):
    """The code of a single verdict."""
    try:
        return CODE_OF[report.verdict(numbers, damped=damped).verdict]
    except GyrostatError:
        return INVALID


@pytest.mark.slow
@pytest.mark.parametrize(("name", "damped"), KINDS)
def test_arrays_are_what_verdicts_say(name, damped):
    """At 60 random points, on boundaries, too."""
    report, rnd = CASES[name].report, random.Random(name)
    names = (report.secular if damped else report).required
    points = [{n: float(rnd.choice(FEW.get(n[0], [-2, -1, 0, 0.5, 1, 3]))) for n in names}
              for _ in range(60 if names else 1)]
    arrays = {n: np.array([point[n] for point in points]) for n in names}
    expected = [code_of(report, point, damped) for point in points]
    for backend in ("numpy", "numba"):
        found = verdicts(report, arrays, damped=damped, invalid="mark", backend=backend)
        assert np.ravel(found).tolist() == expected, backend
