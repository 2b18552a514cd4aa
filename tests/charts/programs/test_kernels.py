"""Kernels of Numba: the bits of NumPy, kept on disk, optional."""
import builtins
import os
import subprocess
import sys

import numpy as np
import pytest
from charts.drawn_margins import drawn

import gyrostat as gs
from gyrostat.charts.programs import kernels
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.errors import MissingExtraError

x, y, z, b = map(gs.symbol, ("x", "y", "z", "b"))


@pytest.mark.slow
def test_numba_is_numpy(tilted_margin, tiny_blocks):
    """E3 on grids of several kinds: the same bits, products and sums are not contracted."""
    for shapes in ([(), (), (), (23, 1), (), (29,)], [(), (1,), (3, 1, 1), (5, 1), (), (7,)]):
        values = drawn(("I1", "I3", "d2U", "k3", "l", "omega"), shapes)
        assert np.array_equal(compile_margin(tilted_margin, "numba")(**values),
                              compile_margin(tilted_margin)(**values))


SCRIPT = """
import numpy as np, gyrostat as gs
from gyrostat.charts.signs.compiled_margins import compile_margin
x, y = gs.symbol("x"), gs.symbol("y")
compiled = compile_margin((x + y)**2 - 3*x*y - 5, "numba")
before = compiled.compile_seconds
value = compiled(x=np.arange(4.0)[:, None], y=np.arange(5.0))
first = compiled.compile_seconds
compiled(x=np.arange(4.0)[:, None], y=np.arange(5.0))
import gc, numba
compile_margin(x*y - x, "numba")(x=np.arange(4.0)[:, None], y=np.arange(5.0))
kernels = [f for f in gc.get_objects() if isinstance(f, numba.core.registry.CPUDispatcher)
           and f.py_func.__module__.startswith("gyrostat_kernel")]
hits = sum(sum(f.stats.cache_hits.values()) for f in kernels)
print(before, first > 0, compiled.compile_seconds == first, hits, float(value.sum()))
"""


def other_process(tmp, **environment):
    env = {k: v for k, v in os.environ.items() if not k.startswith("NUMBA_")} | environment
    run = subprocess.run([sys.executable, "-W", "error", "-c", SCRIPT], capture_output=True, text=True,
                         env=env, cwd=tmp, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout.split()


@pytest.mark.slow
def test_compiled_code_is_kept_on_disk(tmp_path):
    """A second process reads from the cache folder what the first compiled.

    Compiling counts as seconds, once.
    """
    env = {"XDG_CACHE_HOME": str(tmp_path / "cache"), "PYTHONPATH": os.pathsep.join(sys.path)}
    first = other_process(tmp_path, **env)
    files = {p: p.stat().st_mtime_ns for p in (tmp_path / "cache" / "gyrostat").rglob("*") if p.is_file()}
    second = other_process(tmp_path, **env)
    assert first == ["0", "True", "True", "0", "30.0"] and second == ["0", "True", "True", "2", "30.0"]
    assert any(p.suffix == ".nbc" for p in files) and not [p for p in files if p.suffix == ".tmp"]
    assert files == {p: p.stat().st_mtime_ns for p in files}


@pytest.mark.slow
def test_a_cache_that_cannot_be_written_does_no_harm(tmp_path):
    """Where the folder cannot be made, a folder of the process is used."""
    (tmp_path / "file").write_text("no folder")
    env = {"XDG_CACHE_HOME": str(tmp_path / "file"), "PYTHONPATH": os.pathsep.join(sys.path)}
    assert other_process(tmp_path, **env)[-1] == "30.0"


def test_a_home_that_is_not_known_does_no_harm(monkeypatch):
    """Without XDG_CACHE_HOME and without a home, too."""
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)

    def nowhere():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(kernels.Path, "home", nowhere)
    kernels._folder.cache_clear()
    try:
        assert kernels._folder().is_dir()
    finally:
        kernels._folder.cache_clear()


def test_numba_is_optional(monkeypatch, e1):
    """Without Numba the error says what to install; NumPy goes on."""
    real = builtins.__import__

    def absent(name, *given, **more):
        if name.split(".")[0] == "numba":
            raise ImportError("No module named 'numba'")
        return real(name, *given, **more)

    for module in [m for m in sys.modules if m.split(".")[0] == "numba"]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setattr(builtins, "__import__", absent)
    monkeypatch.setitem(sys.modules, "numba", None)    # what import_module sees
    with pytest.raises(MissingExtraError, match=r'pip install "gyrostat\[fast\]"'):
        compile_margin(e1.sufficient, "numba")
    assert compile_margin(e1.sufficient)(I1=1, dU=1, l=3, pi3_0=0)


def test_kernels_of_one_source_are_one_function(e1):
    """Two margins with the same operations share the compiled function, and constants are not part of it."""
    one, other = compile_margin(3 * x * y - 5, "numba"), compile_margin(7 * x * y - 11, "numba")
    u, v = np.arange(3.0)[:, None], np.arange(4.0)
    assert np.array_equal(one(x=u, y=v), 3 * u * v - 5) and np.array_equal(other(x=u, y=v), 7 * u * v - 11)
    assert one.compile_seconds > 0 and other.compile_seconds == 0
