"""Charts larger than memory: blocks of a Zarr store, computed side by side, continued after an interruption."""
import json
import os
import pickle
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache, partial
from hashlib import sha256
from itertools import count, islice
from math import prod
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np

from .charts import Chart, described, variable_attributes
from .errors import StoreError, ValuesError, optional
from .grids import Array
from .progress import Told, telling

FORMAT = 1                                                 # of what a store holds; another one is not continued
BLOCK = 2**22                                              # points of a block, an eighth of it with margins
WAVE = 1024                                                # blocks that are handed out at a time


def filled(path: Path, chart: Chart, arrays: Sequence[Array], threads: int, progress: Told | bool | None) -> Any:
    """The dataset of a store after its missing blocks are computed, opened lazily.

    Each block is one chunk of every variable. Its mark in the variable complete, one byte, is written after the chunks, and each is
    moved into place whole: what is marked is there, and what is not is computed again. With a client of dask.distributed the blocks
    go to its workers, which need the path; else to threads of this process.

    Raises
    ------
    StoreError         the path holds something else, or another chart
    ValuesError        the path does not end in .zarr
    """
    xarray, zarr = optional("xarray", "charts"), optional("zarr", "charts")
    optional("dask", "charts")
    if path.suffix != ".zarr":
        raise ValuesError(f"the store is {path}, blocks are written as Zarr: call it {path.with_suffix('.zarr')}, or leave out store")
    path = path.resolve()
    shape = tuple(map(len, arrays))
    block = _block(shape, BLOCK // 8 if chart.margins else BLOCK)
    counts = tuple(-(-n // size) for n, size in zip(shape, block))
    identity = _identity(chart, arrays, block)
    if not path.exists():
        _create(path, chart, arrays, block, counts, identity)
    _check(path, identity)
    done = np.asarray(zarr.open_array(str(path / "complete"), mode="r")[:])
    numbers = count(int(np.count_nonzero(done)) + 1)
    with telling(progress, "chart") as tell:
        _run(str(path), chart, np.nonzero(done == 0)[0].tolist(), threads, lambda: tell(next(numbers), done.size))
    return xarray.open_zarr(str(path), chunks={}, consolidated=False, mask_and_scale=False).drop_vars("complete")


def _block(shape: tuple[int, ...], points: int) -> tuple[int, ...]:
    """Whole rows, as many as there are points for; then whole planes, and so on."""
    block: list[int] = []
    for n in reversed(shape):
        block.insert(0, min(n, max(points // prod(block), 1)))
    return tuple(block)


def _identity(chart: Chart, arrays: Sequence[Array], block: tuple[int, ...]) -> dict[str, Any]:
    """What makes two charts the same, in words and sums of their data."""
    eq = chart.report.equilibrium
    scene = [eq.label, eq.system.hamiltonian, eq.system.space.tensor.tolist(), eq.point, eq.relations, eq.domain, eq.eliminated]
    return {"format": FORMAT, "equilibrium": _sum(str(scene).encode()), "axes": list(chart.names),
            **{f"values of {name}": _sum(array.astype("<f8").tobytes()) for name, array in zip(chart.names, arrays)},
            **{f"value of {name}": str(number) for name, number, _ in chart.fixed}, "margins": chart.margins, "block": list(block)}


def _sum(data: bytes) -> str:
    return sha256(data).hexdigest()


def _create(path: Path, chart: Chart, arrays: Sequence[Array], block: tuple[int, ...], counts: tuple[int, ...],
            identity: dict[str, Any]) -> None:
    """An empty store: all that is not computed block by block, moved into place whole."""
    import zarr
    new = path.with_name(f"{path.name}.{uuid4().hex}.new")
    dataset = described(chart, arrays, {})
    try:
        os.mkdir(new)
        dataset.to_zarr(str(new), mode="w", zarr_format=3, consolidated=False)
        group = zarr.open_group(str(new), mode="r+")
        names = ["verdict", *(f"margin_{n}" for n in range(len(chart.all_margins)) if chart.margins)]
        for name in names:
            attributes = {key: value.tolist() if isinstance(value, np.ndarray) else value
                          for key, value in variable_attributes(name, chart).items()}
            if chart.fixed:
                attributes["coordinates"] = " ".join(name for name, _, _ in chart.fixed)
            group.create_array(name, shape=tuple(map(len, arrays)), chunks=block, dtype="int8" if name == "verdict" else "float64",
                               fill_value=-128 if name == "verdict" else 0.0, dimension_names=chart.names, attributes=attributes)
        group.create_array("complete", shape=(prod(counts),), chunks=(1,), dtype="uint8", fill_value=0, compressors=None,
                           dimension_names=("block",), attributes={
                               "long_name": "whether a block is written", "chart": json.dumps(identity)})
        os.rename(new, path)
    except OSError:
        if not path.exists():                          # else another process was first
            raise
    finally:
        shutil.rmtree(new, ignore_errors=True)


def _check(path: Path, identity: dict[str, Any]) -> None:
    """Raise StoreError unless the store is one of this chart."""
    import zarr
    try:
        own = json.loads(str(zarr.open_array(str(path / "complete"), mode="r").attrs["chart"]))
    except (OSError, KeyError, TypeError, ValueError) as error:
        raise StoreError(f"{path} exists and is no store of a chart ({error}): give another path, or remove it") from None
    if other := [name for name in {**identity, **own} if own.get(name) != identity.get(name)]:
        raise StoreError(f"{path} is the store of another chart, they differ in {', '.join(other)}: give another path, or remove it")


def _run(path: str, chart: Chart, missing: Sequence[int], threads: int, tick: Callable[[], object]) -> None:
    """Write every missing block, on the workers of a cluster if there is a client of one, else on threads."""
    distributed = sys.modules.get("distributed")       # where it is not loaded there is no client
    try:
        client = distributed.default_client() if distributed else None
    except ValueError:
        client = None
    if client is not None:
        _on_cluster(client, path, pickle.dumps(chart), iter(missing), tick)
    else:
        _on_threads(path, chart, iter(missing), threads, tick)


def _on_threads(path: str, chart: Chart, missing: Iterator[int], threads: int, tick: Callable[[], object]) -> None:
    import dask
    from dask.callbacks import Callback
    task = dask.delayed(partial(write_block, path, chart), pure=False)
    while wave := [task(n) for n in islice(missing, WAVE)]:
        with Callback(posttask=lambda *_: tick()):
            dask.compute(*wave, scheduler="threads", num_workers=max(threads, 1))


def _on_cluster(client: Any, path: str, problem: bytes, missing: Iterator[int], tick: Callable[[], object]) -> None:
    from distributed import as_completed

    def submitted(count: int) -> list[Any]:
        return [client.submit(write_pickled, path, problem, n, pure=False) for n in islice(missing, count)]

    running = as_completed(submitted(WAVE))
    for future in running:
        future.result()
        tick()
        for another in submitted(1):
            running.add(another)


def write_pickled(path: str, problem: bytes, number: int) -> None:
    """Compute and write a block, on a worker."""
    write_block(path, _unpickled(problem), number)


@lru_cache(maxsize=4)
def _unpickled(problem: bytes) -> Chart:
    """What a worker derives of a report it derives once."""
    return pickle.loads(problem)


def write_block(path: str, chart: Chart, number: int) -> None:
    """Compute and write the block of that number: its chunks, then its mark."""
    import zarr
    group: Any = zarr.open_group(path, mode="r+")
    verdict = group["verdict"]
    counts = [-(-n // size) for n, size in zip(verdict.shape, verdict.chunks)]
    part = tuple(slice(i * size, min((i + 1) * size, n))
                 for i, size, n in zip(np.unravel_index(number, counts), verdict.chunks, verdict.shape))
    arrays = [np.asarray(group[name][here]) for name, here in zip(chart.names, part)]
    for name, values in chart.variables(arrays).items():
        group[name][part] = values
    group["complete"][number] = 1
