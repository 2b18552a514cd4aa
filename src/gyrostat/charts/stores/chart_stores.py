"""Computes charts larger than memory in blocks of a Zarr store, and continues them after an interruption.

The blocks are computed side by side, on threads or on the workers of a cluster.
"""
import pickle
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from glob import escape
from itertools import count, islice
from math import prod
from pathlib import Path
from time import time
from typing import Any

import numpy as np

from ...algebra.enclosures.floats import Array
from ...errors import StoreError, ValuesError, optional
from ..progress import Told, telling
from ..request import Request
from .power_cuts import Marks, summed
from .store_frame import Frame

POINTS = 2**22                                              # points of a block, an eighth of it with margins
# seconds after which a file that was not moved into place belongs to no process any more
ABANDONED = 3600
WAVE = 1024                                                # blocks that are handed out at a time


def filled(path: Path, request: Request, arrays: Sequence[Array], threads: int,
           progress: Told | bool | None) -> Any:
    """Return the dataset of a store after its missing blocks are computed, opened lazily.

    Each block is one chunk of every variable. Its mark in the variable complete, a checksum of the chunks, is
    written when they are on the disk, and each is moved into place whole. A block whose mark does not fit is
    computed again; what else is damaged is made again from the call. If there is a client of
    dask.distributed, the blocks go to its workers, which need the path; else to threads of this process.

    Raises
    ------
    StoreError
        the path holds something else, or another chart; the disk is full, or cannot be written to
    ValuesError
        the path does not end in .zarr
    """
    xarray = optional("xarray", "charts")
    optional("zarr", "charts"), optional("dask", "charts")
    if path.suffix != ".zarr":
        raise ValuesError(f"the store is {path}, blocks are written as Zarr: call it "
                          f"{path.stem or 'chart'}.zarr, or leave out store")
    if not (path := path.resolve()).parent.is_dir():
        raise StoreError(f"there is no folder {path.parent} for the store: make it, or give another path")
    try:
        marks = Frame(path, request, tuple(arrays), POINTS // 8 if request.margins else POINTS).ready()
        missing = [n for n in range(prod(marks.counts)) if not marks.fits(n)]
        numbers = count(prod(marks.counts) - len(missing) + 1)
        with telling(progress, "chart") as tell:
            _run(marks, request, arrays, missing, threads, lambda: tell(next(numbers), prod(marks.counts)))
        _tidy(path)
    except OSError as error:
        raise StoreError(f"{path} cannot be written: {error.strerror or error}; the blocks that are done "
                         "are kept: make room, or make it "
                         "writable, and call again, which goes on from there") from error
    return xarray.open_zarr(str(path), chunks={}, consolidated=False,
                            mask_and_scale=False).drop_vars("complete")


def _tidy(path: Path) -> None:
    """Remove what processes that were killed left, beside a store and in it.

    What is younger than an hour may be in use, and stays.
    """
    for left in (*path.parent.glob(f"{escape(path.name)}.*.new"), *path.rglob("*.partial")):
        with suppress(OSError):
            if time() - left.stat().st_mtime > ABANDONED:
                shutil.rmtree(left) if left.is_dir() else left.unlink()


def _run(marks: Marks, request: Request, arrays: Sequence[Array], missing: Sequence[int], threads: int,
         tick: Callable[[], object]) -> None:
    """Write every missing block, on the workers of a cluster if there is a client of one, else on threads."""
    distributed = sys.modules.get("distributed")       # if it is not loaded, there is no client
    try:
        client = distributed.default_client() if distributed else None
    except ValueError:
        client = None
    if client is not None:
        sums = [summed(array.tobytes()) for array in arrays]
        _on_cluster(client, pickle.dumps((marks, request, sums)), iter(missing), tick)
    else:
        _on_threads(partial(write_block, marks, request, arrays), iter(missing), threads, tick)


def _on_threads(write: Callable[[int], None], missing: Iterator[int], threads: int,
                tick: Callable[[], object]) -> None:
    import dask
    from dask.callbacks import Callback
    task = dask.delayed(write, pure=False)
    while wave := [task(n) for n in islice(missing, WAVE)]:
        with Callback(posttask=lambda *_: tick()):
            dask.compute(*wave, scheduler="threads", num_workers=max(threads, 1))


def _on_cluster(client: Any, problem: bytes, missing: Iterator[int], tick: Callable[[], object]) -> None:
    from distributed import as_completed

    def submitted(count: int) -> list[Any]:
        return [client.submit(write_pickled, problem, n, pure=False) for n in islice(missing, count)]

    running = as_completed(submitted(WAVE))
    for future in running:
        future.result()
        tick()
        for another in submitted(1):
            running.add(another)


def write_pickled(problem: bytes, number: int) -> None:
    """Compute and write a block, on a worker."""
    write_block(*_unpickled(problem), number)


@lru_cache(maxsize=4)
def _unpickled(problem: bytes) -> tuple[Marks, Request, list[Array]]:
    """Return marks, request and axes of a problem; a worker derives its report once.

    The axes are read from the store, and compared with those of the call.
    """
    import zarr
    marks, request, sums = pickle.loads(problem)
    arrays = [np.asarray(zarr.open_array(str(marks.path / name), mode="r")[:]) for name in request.names]
    if [summed(array.tobytes()) for array in arrays] != sums:
        raise StoreError(f"the axes in {marks.path} are not those of the call: call again, which makes "
                         "them again")
    return marks, request, arrays


def write_block(marks: Marks, request: Request, arrays: Sequence[Array], number: int) -> None:
    """Compute and write the block of that number: its chunks, then its mark."""
    import zarr
    shape = tuple(map(len, arrays))
    verdict: Any = zarr.open_array(str(marks.path / "verdict"), mode="r+")
    place = np.unravel_index(number, marks.counts)
    part = tuple(slice(int(i) * size, min((int(i) + 1) * size, n))
                 for i, size, n in zip(place, verdict.chunks, shape))
    for name, values in request.variables([array[here] for array, here in zip(arrays, part)]).items():
        array: Any = zarr.open_array(str(marks.path / name), mode="r+")
        array[part] = values
    marks.write(number)
