"""Files that are whole or not there."""
import os
import resource
import stat

import numpy as np
import pytest

from gyrostat.printing.files import cleared, save_netcdf, written


def test_a_file_is_moved_into_its_place(tmp_path):
    """The old one is there until the new one is whole; permissions and links stay."""
    place, link = tmp_path / "data.txt", tmp_path / "link.txt"
    place.write_text("old")
    place.chmod(0o640)
    link.symlink_to(place)
    with written(link) as new:
        new.write_text("new")
        assert place.read_text() == "old" and new.suffix == ".txt" and new.parent == tmp_path
    assert place.read_text() == "new" and link.is_symlink() and stat.S_IMODE(place.stat().st_mode) == 0o640
    assert sorted(p.name for p in tmp_path.iterdir()) == ["data.txt", "link.txt"]


@pytest.mark.parametrize("error", [ValueError, OSError, KeyboardInterrupt])
def test_what_is_not_finished_is_removed(tmp_path, error):
    """After an error or Ctrl-C the old file is as it was, and nothing lies beside it."""
    place = tmp_path / "data.txt"
    place.write_text("old")
    with pytest.raises(error), written(place) as new:
        new.write_text("ha")
        raise error
    assert place.read_text() == "old" and [p.name for p in tmp_path.iterdir()] == ["data.txt"]


def test_what_is_no_file_is_written_to(tmp_path):
    """A pipe takes what is written; a folder, and a file that is not to be written, are refused."""
    os.mkfifo(pipe := tmp_path / "pipe")
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    with written(pipe) as new:
        assert new == pipe
        new.write_text("through")
    assert os.read(reader, 10) == b"through" and stat.S_ISFIFO(pipe.stat().st_mode)
    os.close(reader)
    with pytest.raises(IsADirectoryError), written(tmp_path):
        pass


def test_a_file_that_is_not_to_be_written_stays(tmp_path, monkeypatch):
    """Its permission is asked for, though a folder would let it be replaced."""
    (place := tmp_path / "data.txt").write_text("old")
    monkeypatch.setattr(os, "access", lambda path, mode: False)        # root may write anything
    with pytest.raises(PermissionError), written(place):
        pass
    assert place.read_text() == "old"


def test_what_a_killed_process_left_is_cleared(tmp_path):
    """Only what that process has not finished."""
    names = [".gyrostat-17-ab.png", ".gyrostat-171-ab.png", "a.png"]
    for name in names:
        (tmp_path / name).touch()
    cleared(tmp_path, 17)
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(names[1:])


def test_netcdf_on_a_full_disk(tmp_path):
    """An OSError, the old file, and nothing beside it; a limit on the size of files stands for the disk."""
    xr = pytest.importorskip("xarray")
    pytest.importorskip("netCDF4")
    place = tmp_path / "data.nc"
    save_netcdf(xr.Dataset({"a": ("x", [1.0])}), place)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, hard))
    try:
        with pytest.raises(OSError, match="disk full"):
            save_netcdf(xr.Dataset({"a": ("x", np.random.default_rng(0).random(100_000))}), place)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    with xr.open_dataset(place) as kept:
        assert kept["a"].values.tolist() == [1.0]
    assert [p.name for p in tmp_path.iterdir()] == ["data.nc"]
