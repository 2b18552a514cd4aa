"""The frame of a store: what is not computed block by block.

It is moved into place whole, compared with the call, and made again if it is damaged.
"""
import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ...errors import StoreError
from ...version import STORE_FORMAT
from ..datasets import described, variable_attributes
from ..request import Request
from .power_cuts import (
    DESCRIPTION,
    Marks,
    attributes_of,
    describe,
    files,
    flush,
    replace,
    summed,
    unharmed,
    vouched,
)


@dataclass(frozen=True)
class Frame:
    """A store without its blocks: folders, axes, attributes, and the marks of what is done.

    Parameters
    ----------
    path : Path
    request : Request
    arrays : tuple of array
        the axes, outermost first
    points : int
        the most points of a block, unless a row has more
    """

    path: Path
    request: Request
    arrays: tuple[Array, ...]
    points: int

    @property
    def block(self) -> tuple[int, ...]:
        """The shape of a block: as many whole rows as there are points for; then whole planes, and so on."""
        block: list[int] = []
        for array in reversed(self.arrays):
            block.insert(0, min(len(array), max(self.points // prod(block), 1)))
        return tuple(block)

    @cached_property
    def identity(self) -> dict[str, Any]:
        """What makes two charts the same, in words and sums of their data."""
        request, eq = self.request, self.request.report.equilibrium
        scene = [eq.label, eq.system.hamiltonian, eq.system.space.tensor.tolist(), eq.point, eq.relations,
                 eq.domain, eq.eliminated]
        values = {f"values of {name}": summed(array.astype("<f8").tobytes())
                  for name, array in zip(request.names, self.arrays)}
        values |= {f"value of {name}": str(number) for name, number, _ in request.fixed}
        layers = {"damped": request.damped, "rung": request.windowed}
        return {"format": STORE_FORMAT, "equilibrium": summed(str(scene).encode()),
                "axes": list(request.names), **values, "margins": request.margins, "block": list(self.block),
                **{name: True for name, wanted in layers.items() if wanted}}

    @property
    def counts(self) -> tuple[int, ...]:
        """The number of blocks along each axis."""
        return tuple(-(-len(array) // size) for array, size in zip(self.arrays, self.block))

    @property
    def names(self) -> tuple[str, ...]:
        """The variables that are written block by block."""
        margins = range(len(self.request.all_margins)) if self.request.margins else ()
        return ("verdict", *(("damped",) if self.request.damped else ()),
                *(("rung",) if self.request.windowed else ()), *(f"margin_{n}" for n in margins))

    def ready(self) -> Marks:
        """Return the marks, after the store is made if there is none, and its frame is made whole."""
        if not self.path.exists():
            with self._new() as new:
                try:
                    os.rename(new, self.path)
                except OSError:
                    if not self.path.exists():         # else another process was first
                        raise
                flush(self.path.parent)
        if vouched(self.path):
            self._check(json.loads(attributes_of(self.path)["chart"]))
        if not unharmed(self.path):
            self._repair()
        return self._marks(self.path)

    def _marks(self, form: Path) -> Marks:
        """Return the marks of this store, if its variables have the form of those in a folder.

        The form is their shape, chunks and codecs.
        """
        forms = []
        for name in self.names:
            document = json.loads((form / name / "zarr.json").read_bytes())
            forms.append({key: value for key, value in document.items() if key != "attributes"})
        key = summed(json.dumps([self.identity, forms], sort_keys=True).encode())
        return Marks(self.path, self.names, self.counts, key.encode())

    def _check(self, own: Mapping[str, Any]) -> None:
        """Raise StoreError unless a store is one of this chart."""
        if other := [name for name in {**self.identity, **own} if own.get(name) != self.identity.get(name)]:
            raise StoreError(f"{self.path} is the store of another chart, they differ in "
                             f"{', '.join(other)}: give another path, or remove it")

    def _repair(self) -> None:
        """Make again from the call what is not computed block by block.

        If its description is damaged, a block must prove which chart it belongs to.
        """
        if '"format": 1,' in str(attributes_of(self.path).get("chart")):
            raise StoreError(f"{self.path} is a store of format 1, of a gyrostat that wrote no checksums, "
                             "so that nothing tells whether its blocks are whole: xarray.open_zarr reads it "
                             "as before; to convert it to this format, move it away and call again, which "
                             "computes it anew")
        with self._new() as new:
            marks = self._marks(new)
            if not vouched(self.path) and not any(marks.fits(n) for n in range(prod(marks.counts))):
                raise StoreError(f"{self.path} exists and is no store of a chart, or one whose "
                                 f"{DESCRIPTION} is damaged and of which no block is one of this chart: give "
                                 "another path, or remove it")
            for name, data in sorted(files(new).items(), key=lambda item: item[0] == DESCRIPTION):
                if not (old := self.path / name).is_file() or old.read_bytes() != data:
                    replace(old, data)

    @contextmanager
    def _new(self) -> Iterator[Path]:
        """Yield a store without blocks beside the path, on the disk.

        It is removed if it is not moved into place.
        """
        import zarr
        from zarr.codecs import Crc32cCodec, ZstdCodec
        checked = [ZstdCodec(), Crc32cCodec()]         # with a checksum, so that a damaged chunk is not read
        new = self.path.with_name(f"{self.path.name}.{uuid4().hex}.new")
        dataset = described(self.request, self.arrays, {})
        try:
            os.mkdir(new)
            dataset.to_zarr(str(new), mode="w", zarr_format=3, consolidated=False,
                            encoding={name: {"compressors": checked, "_FillValue": None}
                                      for name in dataset.variables})
            group = zarr.open_group(str(new), mode="r+")
            for name in self.names:
                attributes = {key: value.tolist() if isinstance(value, np.ndarray) else value
                              for key, value in variable_attributes(name, self.request).items()}
                if self.request.fixed:
                    attributes["coordinates"] = " ".join(name for name, _, _ in self.request.fixed)
                verdict = name in ("verdict", "damped", "rung")
                group.create_array(name, shape=tuple(map(len, self.arrays)), chunks=self.block,
                                   compressors=checked, dtype="int8" if verdict else "float64",
                                   fill_value=-128 if verdict else 0.0,
                                   dimension_names=self.request.names, attributes=attributes)
            group.create_array("complete", shape=(prod(self.counts),), chunks=(1,), dtype="uint64",
                               fill_value=0, compressors=None, dimension_names=("block",),
                               attributes={"long_name": "checksum of the chunks of a block, 0: not written"})
            describe(new, self.identity)
            for place in (new, *new.rglob("*")):
                flush(place)
            yield new
        finally:
            shutil.rmtree(new, ignore_errors=True)
