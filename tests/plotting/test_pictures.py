"""The page of pictures: its blocks write the pictures that are stored.

All of them as vectors too.
"""
import re

import matplotlib
import matplotlib.pyplot as plt
import pytest
import stored

SHOWN = re.findall(r"!\[[^\]]+\]\(\.\./images/([\w-]+\.\w+)\)", stored.PAGE.read_text(encoding="utf-8"))
STILL = [name for name in SHOWN if name.endswith(".png")]


def test_every_picture_has_its_block():
    """The picture that is shown is the one that the block after it writes; nothing else is stored."""
    assert list(stored.blocks()) == SHOWN
    files = {path.relative_to(stored.IMAGES).as_posix(): path for path in stored.IMAGES.rglob("*.*")}
    assert set(files) == {*SHOWN, *(f"small/{name}" for name in STILL)}
    assert all(1000 < path.stat().st_size < 600_000 for path in files.values())


@pytest.mark.slow
@pytest.mark.parametrize("name", SHOWN)
def test_the_blocks_draw_what_is_stored(name, tmp_path):
    """In a new folder, pixel for pixel; and as PDF and SVG without a raster image."""
    assert stored.version() == matplotlib.__version__, "install that version, or make all pictures anew"
    names = stored.draw(name, tmp_path)
    for kind in ("pdf", "svg"):
        names["figure"].savefig(tmp_path / f"picture.{kind}")
    svg = (tmp_path / "picture.svg").read_text(encoding="utf-8")
    rasters = {"eigenvalues.png": 1, "e3-chart.png": 1, "smelt-plane.png": 2}      # a colour bar, verdicts
    assert svg.count("<image") == rasters.get(name, 0)
    stored.draw_small(name, names["figure"], tmp_path)
    assert stored.unlike(name, tmp_path) == []
    plt.close("all")
