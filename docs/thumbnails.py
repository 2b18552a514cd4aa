"""python docs/thumbnails.py: the pictures of the gallery, and the first panel of six of them, small."""
import re
from pathlib import Path

import matplotlib

IMAGES = Path(__file__).parent / "images"
PAGE = Path(__file__).parent / "gallery" / "index.md"
SMALL = ("e3-chart", "momentum-sphere", "nutation", "bifurcations", "energy-momentum", "eigenvalues")
WIDTH, SHAPE = 520, 4 / 3                                  # pixels, twice those of the page; width to height


def small(figure, path):
    """The first axes without title, legend and the others."""
    first, *others = figure.axes
    for ax in others:
        ax.remove()
    for legend in filter(None, (first.get_legend(), *figure.legends)):
        legend.remove()
    first.set_title("")
    figure.set_size_inches(3.0, 3.0 / SHAPE)
    if first.name == "3d":
        figure.set_layout_engine("none")
        first.set_position((0, 0, 1, 0.94))
    else:
        first.set_subplotspec(figure.add_gridspec(1, 1)[0])
        figure.set_layout_engine("constrained", w_pad=0.1)
    figure.savefig(path, dpi=WIDTH / 3.0)


def main():
    """All of them, into docs/images."""
    matplotlib.use("Agg")
    for block in re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL):
        name = re.search(r'"([\w-]+)\.(?:png|gif)"', block)[1]
        names = {}
        with matplotlib.rc_context():
            exec(re.sub(r'"([\w-]+\.(?:png|gif))"', lambda file: repr(str(IMAGES / file[1])), block), names)
            if name in SMALL:
                (IMAGES / "small").mkdir(exist_ok=True)
                small(names["figure"], IMAGES / "small" / f"{name}.png")


if __name__ == "__main__":
    main()
