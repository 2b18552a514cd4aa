"""The page of pictures: its blocks run as they stand and write the pictures that it shows.

All of them as vectors too.
"""
import re
from pathlib import Path

import matplotlib
import pytest
from PIL import Image

PAGE = Path(__file__).parents[2] / "docs" / "gallery" / "index.md"
SHOWN = re.findall(r"!\[[^\]]+\]\(\.\./images/([\w-]+\.\w+)\)", PAGE.read_text(encoding="utf-8"))
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


def test_every_picture_has_its_block():
    """The picture that is shown is the one that the block after it writes; it is there, and small."""
    assert len(SHOWN) == len(BLOCKS)
    for name, block in zip(SHOWN, BLOCKS):
        assert f'"{name}"' in block and 1000 < (PAGE.parents[1] / "images" / name).stat().st_size < 600_000


@pytest.mark.slow
@pytest.mark.parametrize("name, block", list(zip(SHOWN, BLOCKS)), ids=SHOWN)
def test_the_blocks_run_as_shown(name, block, tmp_path, monkeypatch):
    """In a new folder, with the picture as the result.

    Its figures are written as PDF and SVG without a raster image.
    """
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    with matplotlib.rc_context():                          # a block sets a style
        exec(block, names)
    with Image.open(tmp_path / name) as ours, Image.open(PAGE.parents[1] / "images" / name) as shown:
        assert ours.size == shown.size
    for kind in ("pdf", "svg"):
        names["figure"].savefig(tmp_path / f"picture.{kind}")
    svg = (tmp_path / "picture.svg").read_text(encoding="utf-8")
    rasters = {"eigenvalues.png": 1, "e3-chart.png": 1, "smelt-plane.png": 2}      # a colour bar, verdicts
    assert svg.count("<image") == rasters.get(name, 0)
    plt.close("all")
