"""Compiles the work at each point of a block to one loop, by Numba, and keeps it on disk."""
import atexit
import hashlib
import importlib.util
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Iterable, Sequence
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from ...algebra.enclosures.floats import Array
from ...errors import optional
from ..grids import Slices
from .straightline import Step
from .tiles import Tiles

SIGN = "1 if {0} > e0 else -1 if {0} < -e0 else 0"         # of a value {0}, 0 if it is not proved
RUN = 256                                                  # points for which one stage is done at a time
_SYMBOLS = {"add": "+", "subtract": "-", "multiply": "*"}


class Kernel:
    """The inner steps of tiles as a compiled function of a block.

    Parameters
    ----------
    tiles : Tiles
    stages : sequence of str
        expressions that are written for the results {0}, {1}, … of the program and their bounds e0, e1, …,
        such as "{0} > e0"; each is computed in runs of points where the one before has left something open
    spent : list
        gets the seconds of a compilation, or of reading it from disk, with the first block
    left : int
        what a stage writes where the next one is to decide
    """

    def __init__(self, tiles: Tiles, stages: Sequence[str], spent: list[float], left: int = 0):
        self.tiles, self.stages, self.spent, self.left = tiles, tuple(stages), spent, left

    def __call__(self, block: Slices, out: Array, bounds: Sequence[float] = ()) -> None:
        """Write a block of results."""
        operands = [self.tiles.small(i, block) for i in self.tiles.operands]
        kinds = "".join(map(_kind, operands))
        sources, key = self.tiles.layout.sources, (self.stages, self.left, kinds, len(bounds))
        if key not in sources:
            sources[key] = self._source(kinds, len(bounds))
        function = function_of(sources[key])
        given = [_given(a, kind) for a, kind in zip(operands, kinds)]
        into = out if out.flags.c_contiguous else np.empty(out.shape, dtype=out.dtype)
        known, begin = len(function.overloads), time.perf_counter()
        function(*given, *bounds, into)
        if len(function.overloads) > known:
            self.spent.append(time.perf_counter() - begin)
        if into is not out:
            out[...] = into

    def _source(self, kinds: str, bounds: int) -> str:
        operands = [*zip(self.tiles.operands, kinds)]
        read = {"s": "a{0}", "r": "r{0}", "c": "c{0}[j]", "f": "c{0}[j]"}
        names = {i: read[kind].format(i) for i, kind in operands}
        # slices let the loops over a run be vectorised: their places begin at 0
        row = [f"r{i} = a{i}[i]" for i, kind in operands if kind == "r"]
        run = [f"c{i} = a{i}[{'i, ' if kind == 'f' else ''}start:start + RUN]" for i, kind in operands
               if kind in "cf"]
        loops: list[str] = []
        for stage in self.stages:
            loop = ["for j in range(part.shape[0]):", *(f"    {line}" for line in self._stage(stage, names))]
            loops += loop if not loops else [
                "left = False", "for j in range(part.shape[0]):", f"    left |= part[j] == {self.left}",
                "if left:", *(f"    {line}" for line in loop)]
        arguments = [*(f"a{i}" for i, _ in operands), *(f"e{n}" for n in range(bounds)), "out"]
        return "\n".join([f"RUN = {RUN if len(self.stages) > 1 else 2**62}",
                          f"def kernel({', '.join(arguments)}):", "    for i in range(out.shape[0]):",
                          *(f"        {line}" for line in row),
                          "        for start in range(0, out.shape[1], RUN):",
                          "            part = out[i, start:start + RUN]",
                          *(f"            {line}" for line in (*run, *loops)), ""])

    def _stage(self, stage: str, operands: dict[int, str]) -> list[str]:
        """Return what is done at each point for one stage."""
        program, names = self.tiles.program, dict(operands)
        results = program.outcomes
        used = {result for n, result in enumerate(results) if f"{{{n}}}" in stage}
        needed = program.needed(used)
        lines = assignments([(i, step) for i, step in self.tiles.inner if i in needed], names, "x")
        return [*lines, f"part[j] = {stage.format(*(names.get(i, '') for i in results))}"]


def assignments(steps: Iterable[tuple[int, Step]], names: dict[int, str], letter: str) -> list[str]:
    """Return operations of a program as they stand in a loop; the names of their results are entered."""
    lines = []
    for i, step in steps:
        arguments = [names[n] for n in step.arguments]
        names[i] = f"{letter}{i}"
        lines.append(f"{names[i]} = " + (f"-{arguments[0]}" if step.operation == "negative"
                                         else f" {_SYMBOLS[step.operation]} ".join(arguments)))
    return lines


@lru_cache(maxsize=128)
def function_of(source: str) -> Any:
    """Return the function of a source, compiled when it is first called.

    If a process has compiled it before, it is read from disk.
    """
    numba = optional("numba", "fast")
    return numba.njit(cache=True, nogil=True, error_model="numpy")(_module(source).kernel)


def _module(source: str) -> ModuleType:
    """Return the source as a module of its own.

    Numba keeps what it compiles beside the file that it comes from.
    """
    name = "gyrostat_kernel_" + hashlib.sha256(source.encode()).hexdigest()[:24]
    path = _folder() / f"{name}.py"
    if not path.exists() or path.read_text(encoding="utf-8") != source:
        with tempfile.NamedTemporaryFile("w", encoding="utf-8", dir=path.parent, suffix=".tmp",
                                         delete=False) as file:
            file.write(source)
        os.replace(file.name, path)
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@lru_cache(maxsize=1)
def _folder() -> Path:
    """Return where kernels are kept: the user's cache, or a folder of this process.

    The second is used if the first cannot be written.
    """
    try:
        folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "gyrostat"
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except (OSError, RuntimeError):                    # no home, or none that can be written
        folder = Path(tempfile.mkdtemp(prefix="gyrostat-"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        return folder


def _kind(operand: Array) -> str:
    """Return how an operand varies over a block.

    It is a scalar "s", or varies with the column "c", with the row "r", or with both "f".
    """
    if operand.size == 1:
        return "s"
    if operand.shape[0] == 1:
        return "c"
    return "r" if operand.shape[1] == 1 else "f"


def _given(operand: Array, kind: str) -> Any:
    """Return an operand as a kernel of its kind takes it."""
    if kind == "s":
        return operand[0, 0]
    if kind == "c":
        return np.ascontiguousarray(operand[0])
    return np.ascontiguousarray(operand[:, 0] if kind == "r" else operand)
