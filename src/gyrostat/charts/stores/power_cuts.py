"""Checksums that let a Zarr store be continued after a crash.

Files are flushed to the disk, each block is marked by a checksum of its chunks, and descriptions carry their
own.
"""
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import blake2b, sha256
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np

# the file that says which chart a store has, with the sums of all files but chunks and marks
DESCRIPTION = "complete/zarr.json"
# stands for the sum of a description while it is taken
UNSUMMED = "0" * 64


@dataclass(frozen=True)
class Marks:
    """The marks of the blocks of a store, one file each: a checksum of the chunks of the block.

    A mark is written after its chunks are on the disk. If a mark or a chunk is missing, cut off or altered,
    they do not fit: the block counts as not there, and is computed again.

    Parameters
    ----------
    path : Path
        the folder of the store
    names : tuple of str
        the variables of which a block is one chunk
    counts : tuple of int
        blocks along each axis
    key : bytes
        a sum of the chart and of the form of its variables, so that a mark of another chart does not fit
    """

    path: Path
    names: tuple[str, ...]
    counts: tuple[int, ...]
    key: bytes

    def chunks(self, number: int) -> list[Path]:
        """Return the files of a block."""
        place = [str(i) for i in np.unravel_index(number, self.counts)]
        return [self.path.joinpath(name, "c", *place) for name in self.names]

    def fits(self, number: int) -> bool:
        """Tell whether a block is there: its mark is the checksum of its chunks."""
        try:
            return self._mark(number).read_bytes() == self._sum(number)
        except OSError:
            return False

    def write(self, number: int) -> None:
        """Mark a block whose chunks are in place."""
        for chunk in self.chunks(number):
            if chunk.exists():                         # Zarr writes no chunk in which all is its fill value
                flush(chunk)
                for folder in chunk.parents[:len(self.counts) + 1]:
                    flush(folder)
        replace(self._mark(number), self._sum(number))

    def _mark(self, number: int) -> Path:
        return self.path / "complete" / "c" / str(number)

    def _sum(self, number: int) -> bytes:
        found = blake2b(str(number).encode(), key=self.key, digest_size=8)
        for chunk in self.chunks(number):
            found.update(blake2b(chunk.read_bytes()).digest() if chunk.exists() else b"no file")
        return found.digest()


def summed(data: bytes) -> str:
    """Return the checksum of data, in hexadecimal digits."""
    return sha256(data).hexdigest()


def flush(path: Path) -> None:
    """Wait until a file, or the names in a folder, are on the disk."""
    if os.name == "nt" and path.is_dir():              # Windows has no such call for folders
        return
    descriptor = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def replace(path: Path, data: bytes) -> None:
    """Write a file beside and move it into place, both on the disk before this returns."""
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(f"{path.name}.{uuid4().hex}.partial")
    try:
        new.write_bytes(data)
        flush(new)
        os.replace(new, path)
    finally:
        new.unlink(missing_ok=True)
    flush(path.parent)


def files(folder: Path) -> dict[str, bytes]:
    """Return all files below a folder by their path in it."""
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


def describe(folder: Path, identity: Mapping[str, Any]) -> None:
    """Enter into the description of a store which chart it has, the sums of its files, and its own sum.

    It is called before the store has chunks or marks.
    """
    sums = {name: summed(data) for name, data in files(folder).items() if name != DESCRIPTION}
    document = json.loads((folder / DESCRIPTION).read_bytes())
    document["attributes"] |= {"chart": json.dumps(identity), "files": json.dumps(sums), "sum": UNSUMMED}
    text = json.dumps(document, indent=2).encode()
    (folder / DESCRIPTION).write_bytes(text.replace(UNSUMMED.encode(), summed(text).encode()))


def attributes_of(path: Path) -> dict[str, Any]:
    """Return the attributes of the description of a store, whether it is whole or not.

    There are none if it cannot be read.
    """
    try:
        return dict(json.loads((path / DESCRIPTION).read_bytes())["attributes"])
    except (OSError, KeyError, TypeError, ValueError, RecursionError):
        return {}


def vouched(path: Path) -> bool:
    """Tell whether the description of a store is, byte for byte, the one that was written."""
    own = attributes_of(path).get("sum")
    if not isinstance(own, str) or not own.isascii():
        return False
    return summed((path / DESCRIPTION).read_bytes().replace(own.encode(), UNSUMMED.encode())) == own


def unharmed(path: Path) -> bool:
    """Tell whether the description and all files of which it has the sums are whole."""
    if not vouched(path):
        return False
    sums = json.loads(attributes_of(path)["files"])
    try:
        return all(summed((path / name).read_bytes()) == own for name, own in sums.items())
    except OSError:
        return False
