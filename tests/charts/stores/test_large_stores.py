"""Charts in a store that one process does not hold: on a cluster, in little memory."""
import os
import signal
import time

import numpy as np
import pytest
import xarray as xr
from charts.stored_charts import GRID, python

from gyrostat.charts.chart import stability_chart
from gyrostat.charts.stores import chart_stores


@pytest.mark.slow
def test_a_cluster_that_loses_a_worker(e1, ten_blocks, written, tmp_path, monkeypatch):
    """With a client the blocks go to its workers; one of two is killed in the run.

    The result is the one of memory.
    """
    import distributed

    monkeypatch.setattr(chart_stores, "WAVE", 6)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                                  dashboard_address=None) as cluster, \
            distributed.Client(cluster) as client:
        workers = list(client.run(os.getpid).values())
        seen = []

        def tick(done, total):
            seen.append(done)
            if done == 2:
                os.kill(workers[0], signal.SIGKILL)

        chart = stability_chart(e1, **{**GRID, "y": ("l", np.linspace(-2, 2, 280))},
                                store=tmp_path / "chart.zarr", progress=tick)
        assert written == [] and seen == list(range(1, 41))
        deadline = time.monotonic() + 20
        while set(client.run(os.getpid).values()) == set(workers) and time.monotonic() < deadline:
            time.sleep(0.1)
        assert workers[0] not in client.run(os.getpid).values()
    xr.testing.assert_identical(chart.compute(),
                                stability_chart(e1, **{**GRID, "y": ("l", np.linspace(-2, 2, 280))}))


MEMORY = """
import resource
chart_stores.POINTS = 2**20
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
plane = np.linspace(-4, 4, 1000)
fixed = {{"I1": "1/3"}}
first = stability_chart(report, x=("pi3_0", plane[:9]), y=("l", plane), axes={{"dU": [1.0]}}, fixed=fixed,
                        margins=True, store={path!r} + "1.zarr")
before = peak()
chart = stability_chart(report, x=("pi3_0", plane), y=("l", plane), axes={{"dU": np.linspace(0, 1, {n})}},
                        fixed=fixed, margins=True, store={path!r} + ".zarr")
assert int((chart.verdict[:, 0] == -128).sum()) == 0
print(before, peak(), chart.nbytes / 2**20)
"""


@pytest.mark.parametrize("n", [pytest.param(n, marks=pytest.mark.slow) for n in (12, 120)])
def test_memory_does_not_grow_with_the_chart(full, tmp_path, n):
    """A process that writes a chart of 103 MiB grows by less than it, and by no more for one of 1 GiB.

    The larger one is written with --full.
    """
    if n > 12 and not full:
        pytest.skip("some minutes: --full")
    run = python(MEMORY.format(n=n, path=str(tmp_path / "chart")))
    assert run.returncode == 0, run.stderr
    before, peak, size = map(float, run.stdout.split())
    assert size > 100 and peak - before < 100, (before, peak, size)
