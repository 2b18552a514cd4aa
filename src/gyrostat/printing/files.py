"""Writes files whole or not at all: beside their place, flushed to disk, then moved into it."""
import errno
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from ..arguments import checked
from ..errors import optional, require


@contextmanager
def written(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Give a path to write to; when the block ends well, the file is moved into the place asked for.

    If the block fails, the new file is removed. Until then the old file stays in its place: after an error,
    an interruption, or on a full disk. A link stays a link, and the permissions stay. A path that is no file,
    such as /dev/null or a pipe, is written to directly.

    Parameters
    ----------
    path : str or PathLike

    Raises
    ------
    OSError
        the file, or its folder, cannot be written

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with written(f"{folder}/note.txt") as new:
    ...         _ = new.write_text("whole")
    ...         print(os.path.exists(f"{folder}/note.txt"))
    ...     print(os.listdir(folder))
    False
    ['note.txt']
    """
    place = Path(os.path.realpath(path))
    if not replaceable(place):
        yield Path(path)
        return
    new = place.with_name(f"{_mark(os.getpid())}{os.urandom(6).hex()}{place.suffix}")
    try:
        yield new
        moved(new, place)
    finally:
        with suppress(OSError):
            new.unlink(missing_ok=True)


def replaceable(place: Path) -> bool:
    """Whether another file can be moved to the place: either nothing or a file is there.

    An OSError is raised if a file is there that may not be written.
    """
    if not place.exists():
        return True
    if place.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(place))
    if not os.access(place, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(place))
    return place.is_file()


def moved(new: Path, place: Path) -> None:
    """Flush a file to disk and move it; it gets the permissions of the file that was in the place."""
    _flush(new, os.O_RDWR)
    with suppress(FileNotFoundError):
        os.chmod(new, stat.S_IMODE(os.stat(place).st_mode))
    os.replace(new, place)
    with suppress(OSError):                                # a folder cannot be flushed everywhere
        _flush(place.parent, os.O_RDONLY)


def cleared(folder: Path, process: int) -> None:
    """Remove the unfinished files of a process that was ended from a folder."""
    for left in folder.glob(f"{_mark(process)}*"):
        with suppress(OSError):
            left.unlink()


@checked
def save_netcdf(dataset: Any, path: str | os.PathLike[str], **kwargs: Any) -> None:
    """Write an xarray.Dataset as netCDF, whole or not at all.

    Parameters
    ----------
    dataset : xarray.Dataset
        of stability_chart, or Motion.to_xarray
    path : str or Path
    **kwargs : Any
        of Dataset.to_netcdf, encoding for example

    Raises
    ------
    OSError
        the file cannot be written
    MissingExtraError
        pip install "gyrostat[charts]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> import os
    >>> import tempfile
    >>> body = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> turning = gs.trajectories.motion(body, (0, 0, 3))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     gs.charts.save_netcdf(turning.to_xarray([0, 1]), f"{folder}/turning.nc")
    ...     os.listdir(folder)
    ['turning.nc']
    """
    optional("netCDF4", "charts")
    require(dataset, optional("xarray", "charts").Dataset, "the dataset")
    with written(path) as new:
        try:
            dataset.to_netcdf(new, engine="netcdf4", **kwargs)
        except RuntimeError as error:                      # of the netCDF library, where HDF5 cannot write
            raise OSError(errno.EIO, f"{error}, is the disk full?", str(path)) from None


def _mark(process: int) -> str:
    """The beginning of the names of files that a process has not finished."""
    return f".gyrostat-{process}-"


def _flush(path: Path, flags: int) -> None:
    descriptor = os.open(path, flags)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
