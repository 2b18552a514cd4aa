"""python docs/stored.py [--check] [FILE ...]: make anew what is stored of the pages, or compare it.

Stored are the pictures of the gallery, the first panel of each as a thumbnail, and the outputs of the
notebooks. FILE is the path of a notebook, or the name of a picture in the gallery; default: all of them.
"""
import argparse
import base64
import io
import json
import os
import re
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from itertools import zip_longest
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from PIL import Image, ImageSequence

ROOT = Path(__file__).resolve().parents[1]
IMAGES, PAGE = ROOT / "docs" / "images", ROOT / "docs" / "gallery" / "index.md"
# Of a small picture: the inches that 200 pixels of a page are, its pixels, its width to its height, the
# points of its letters, and the most ticks of an axis
SHOWN, WIDTH, SHAPE, LETTERS, TICKS = 200 / 96, 520, 4 / 3, 7.5, 3
# Two pictures are the same if no channel of a pixel differs by more than this, of 255. With one version of
# Matplotlib all 21 PNG of the gallery came out with differences of 0, whether with NumPy 2.0, contourpy 1.2,
# kiwisolver 1.4 and Pillow 10 or with NumPy 2.4, contourpy 1.3, kiwisolver 1.5 and Pillow 13. From Matplotlib
# 3.10 to 3.11 it is 0.1 to 14 % of the pixels that differ by more, since letters and legends are laid out
# anew. Therefore both pictures have to be of one version, which every PNG names.
COLOUR = 32
# In a cell: its outputs are not twice the same; its picture differs from processor to processor.
TIMES, ROUNDING = "# times", "# rounding"
TIME = re.compile(r" *\d+(?:\.\d+)? (?=(?:µs|ms|s)\b)")
PNG, SOFTWARE = "image/png", re.compile(r"Matplotlib version([\d.]+\d).*")


def blocks() -> dict[str, str]:
    """The code of each picture of the gallery, by the name of its file."""
    found = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    return {re.search(r'"([\w-]+\.(?:png|gif))"', block)[1]: block for block in found}  # type: ignore[index]


def draw(name: str, folder: Path) -> dict[str, Any]:
    """Write a picture of the gallery; the names that its block sets."""
    names: dict[str, Any] = {}
    matplotlib.use("Agg")
    with matplotlib.rc_context():                          # a block sets a style
        exec(blocks()[name].replace(f'"{name}"', repr(str(folder / name))), names)
    return names


def draw_small(name: str, figure: Any, folder: Path) -> None:
    """Write the small picture of a still one into small/; of the figure the first axes are left."""
    if name.endswith(".png"):
        (folder / "small").mkdir(exist_ok=True)
        with matplotlib.rc_context(), matplotlib.style.context("gyrostat.plotting.paper"):
            small(figure, folder / "small" / name)


def small(figure: Any, path: Path) -> None:
    """Write the first axes as a thumbnail, with few ticks, and letters that can be read.

    Names beside marks, title, legend and the other axes are removed.
    """
    first, *others = figure.axes
    for ax in others:
        ax.remove()
    for legend in filter(None, (first.get_legend(), *figure.legends)):
        legend.remove()
    for text in list(first.texts):
        if not text.get_text().startswith("$") or first.name != "3d":
            text.remove()
    first.set_title("")
    figure.set_size_inches(SHOWN, SHOWN / SHAPE)
    for axis in (first.xaxis, first.yaxis):
        axis.set_label_text(axis.get_label_text().split(" $[")[0])         # without its dimension
        fixed = isinstance(axis.get_major_locator(), matplotlib.ticker.FixedLocator)
        if fixed and first.name != "3d":
            names = [label.get_text() for label in axis.get_ticklabels()]
            axis.set_ticks(axis.get_ticklocs()[::2], names[::2])
        elif first.name != "3d":
            axis.set_major_locator(matplotlib.ticker.MaxNLocator(TICKS))
    first.tick_params(labelsize=LETTERS)
    for text in first.findobj(matplotlib.text.Text):
        text.set_fontsize(LETTERS)
    if first.name == "3d":
        figure.set_layout_engine("none")
        first.set_position((0, 0, 1, 0.94))
    else:
        first.set_subplotspec(figure.add_gridspec(1, 1)[0])
        figure.set_layout_engine("constrained", w_pad=0.05)
    figure.savefig(path, dpi=WIDTH / SHOWN)


def differences(stored: Any, made: Any) -> Iterator[str]:
    """In what a picture, or a frame of one, differs from the one that is made now; paths, or files."""
    with Image.open(stored) as first, Image.open(made) as second:
        frames = zip_longest(ImageSequence.Iterator(first), ImageSequence.Iterator(second))
        for n, pair in enumerate(frames):
            if None in pair or pair[0].size != pair[1].size:
                yield f"frame {n}: another size, {[frame and frame.size for frame in pair]}"
                return
            a, b = (np.asarray(frame.convert("RGB"), int) for frame in pair)
            if count := int((abs(a - b).max(axis=-1) > COLOUR).sum()):
                yield f"frame {n}: {count} of {a[..., 0].size} pixels differ"


def picture(name: str, check: bool) -> list[str]:
    """Make one of the gallery, with its small one, or compare them."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) if check else IMAGES
        draw_small(name, draw(name, folder)["figure"], folder)
        return unlike(name, folder)


def unlike(name: str, folder: Path) -> list[str]:
    """In what the pictures of a name in a folder differ from those that are stored."""
    return [f"{path.relative_to(folder)}: {said}" for path in sorted(folder.rglob(name))
            for said in differences(IMAGES / path.relative_to(folder), path)]


def executed(notebook: Any) -> Any:
    """The notebook after all its cells have been run."""
    from nbclient import NotebookClient
    here = {"metadata": {"path": str(ROOT / "notebooks")}}
    NotebookClient(notebook, record_timing=False, coalesce_streams=True, resources=here).execute()
    for cell in notebook.cells:
        if "outputs" in cell:                              # a bar of progress that was wiped leaves blanks
            cell.outputs = [each for each in cell.outputs
                            if each.get("name") != "stderr" or each.text.strip()]
    return notebook


def outputs(cell: Any) -> list[dict[str, str]]:
    """What a cell shows, by kind; without times in what is timed, without pictures there and where it rounds.
    """
    shown = [dict(each.get("data") or {each["name"]: each["text"]}) for each in cell.get("outputs", ())]
    if TIMES in cell["source"] or ROUNDING in cell["source"]:
        shown = [{kind: text for kind, text in each.items() if kind != PNG} for each in shown]
    if TIMES in cell["source"]:
        shown = [{kind: TIME.sub(" … ", text) for kind, text in each.items()} for each in shown]
    return shown


def notebook(path: Path, check: bool) -> list[str]:
    """Execute one and store its outputs, or compare them."""
    import nbformat
    stored, made = nbformat.read(path, 4), executed(nbformat.read(path, 4))
    if not check:
        nbformat.write(made, path)
        return []
    return [f"{path.name}: cell {n}: {kind}: {said}"
            for n, cells in enumerate(zip(stored.cells, made.cells))
            for before, now in zip_longest(*map(outputs, cells), fillvalue={})
            for kind in sorted({*before, *now}) for said in changes(kind, before.get(kind), now.get(kind))]


def changes(kind: str, stored: str | None, made: str | None) -> Iterator[str]:
    """In what an output differs: the pixels of a picture, the first line of a text."""
    if stored == made:
        return
    if kind == PNG and stored and made:
        yield from differences(*(io.BytesIO(base64.b64decode(each)) for each in (stored, made)))
        return
    lines = ((each or "nothing").splitlines() for each in (stored, made))
    before, now = next(pair for pair in zip_longest(*lines, fillvalue="") if pair[0] != pair[1])
    yield f"stored is {before.strip()[:200]!r}, made {now.strip()[:200]!r}"


def version() -> str:
    """Of Matplotlib, by which the stored pictures were made; they name it."""
    pictures = [path.read_bytes() for path in IMAGES.rglob("*.png")]
    for path in (ROOT / "notebooks").glob("*.ipynb"):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        pictures += [base64.b64decode(each["data"][PNG]) for cell in cells for each in cell.get("outputs", ())
                     if PNG in each.get("data", ())]
    made_by = {Image.open(io.BytesIO(each)).info.get("Software", "?") for each in pictures}
    versions = {SOFTWARE.sub(r"\1", each) for each in made_by}
    if len(versions) != 1:
        raise SystemExit(f"the pictures are of Matplotlib {', '.join(sorted(versions))}: make all anew")
    return versions.pop()


def one(name: str, check: bool) -> list[str]:
    """Make or compare a notebook or a picture of the gallery."""
    return notebook(Path(name), check) if name.endswith(".ipynb") else picture(name, check)


def main() -> int:
    """0, or 1 if something that is stored is not what is made now."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    parser.add_argument("--version", action="store_true", help="that of Matplotlib which made the pictures")
    parser.add_argument("files", nargs="*", metavar="FILE")
    given = parser.parse_args()
    if given.version:
        print(version())
        return 0
    if given.check and version() != matplotlib.__version__:
        raise SystemExit(f"the pictures were made by Matplotlib {version()}, and here is "
                         f"{matplotlib.__version__}: install that version, or make all of them anew")
    names = given.files or [*map(str, sorted((ROOT / "notebooks").glob("*.ipynb"))), *blocks()]
    status = 0
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        for name, found in zip(names, pool.map(one, names, [given.check] * len(names))):
            print(Path(name).name, *found or ["as stored" if given.check else "made"], sep="\n    ")
            status = status or int(bool(found))
    return status


if __name__ == "__main__":
    sys.exit(main())
