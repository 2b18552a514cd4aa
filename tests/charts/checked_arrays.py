"""Verdicts on arrays, held against Report.verdict at every point."""
import numpy as np

import gyrostat as gs
from gyrostat.charts import verdicts
from gyrostat.charts.codes import CODE_OF, INVALID
from gyrostat.errors import ValuesError


def axial(expression):
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(expression))


def one_by_one(report, values):
    """Report.verdict at every point; INVALID where it refuses."""
    given_arrays = [v if isinstance(v, np.ndarray) else np.asarray(v, dtype=object) for v in values.values()]
    full = dict(zip(values, np.broadcast_arrays(*given_arrays)))
    result = np.empty(np.broadcast_shapes(*(v.shape for v in given_arrays)), dtype=np.int8)
    for index in np.ndindex(result.shape):
        try:
            result[index] = CODE_OF[report.verdict({n: v[index] for n, v in full.items()}).verdict]
        except ValuesError:
            result[index] = INVALID
    return result


def check(report, values, expected=None, **options):
    """The verdicts, which are those of Report.verdict."""
    found = verdicts(report, values, invalid="mark", **options)
    expected = one_by_one(report, values) if expected is None else expected
    assert found.dtype == np.int8 and found.shape == expected.shape
    if (wrong := np.argwhere(found != expected)).size:
        index = tuple(wrong[0])
        full = {n: np.broadcast_to(np.asarray(v), expected.shape)[index] for n, v in values.items()}
        raise AssertionError(f"{len(wrong)} of {found.size}, first at {full}: {found[index]}, not "
                             f"{expected[index]}")
    return found
