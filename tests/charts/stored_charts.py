"""The chart that tests store, and what lies in its store."""
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

GRID = {"x": ("pi3_0", np.linspace(-4, 4, 90)), "y": ("l", np.linspace(-2, 2, 70)),
        "fixed": {"I1": "1/3", "dU": 1}}
SCRIPT = """
import os, signal, sys
import numpy as np
import gyrostat as gs
from gyrostat.charts.stores import chart_stores
from gyrostat.charts.chart import stability_chart
report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
grid = {"x": ("pi3_0", np.linspace(-4, 4, 90)), "y": ("l", np.linspace(-2, 2, 70)),
        "fixed": {"I1": "1/3", "dU": 1}}
"""


def contents(path):
    return {p.relative_to(path): p.read_bytes() for p in sorted(Path(path).rglob("*")) if p.is_file()}


def python(code, **environment):
    return subprocess.run([sys.executable, "-W", "error", "-c", SCRIPT + code],
                          env={**os.environ, **environment}, capture_output=True,
                          text=True, timeout=300)
