"""An image of cells: each pixel has the colour of the cell in which its centre lies, evenly spaced or not."""
from typing import Any

import numpy as np
from matplotlib.image import AxesImage
from matplotlib.transforms import IdentityTransform

from ..algebra.enclosures.floats import Array


class Cells(AxesImage):
    """An image of whole numbers in cells, of which the pixels are read alone.

    Matplotlib's own colours every number and then resamples the colours, for each time that it is drawn.

    Parameters
    ----------
    ax : matplotlib Axes
    codes : array of int, shape (rows, columns)
        from below
    edges : pair of arrays, shapes (columns + 1,) and (rows + 1,)
        the ends of the cells along x and y, increasing
    **kwargs : Any
        of AxesImage
    """

    def __init__(self, ax: Any, codes: Array, edges: tuple[Array, Array], **kwargs: Any):
        super().__init__(ax, origin="lower", extent=(edges[0][0], edges[0][-1], edges[1][0], edges[1][-1]),
                         **kwargs)
        self.edges = edges
        self.set_data(codes)

    def make_image(self, renderer: Any, magnification: float = 1.0, unsampled: bool = False) -> Any:
        """Return the pixels of the axes as colours, from below, and the place of the first."""
        codes, box = np.asarray(self.get_array()), np.multiply(self.axes.bbox.extents, magnification)
        left, below, right, above = (int(end) for end in np.floor(box + 0.5))
        x, y = ((np.arange(*ends) + 0.5) / magnification for ends in ((left, right), (below, above)))
        column, row = self._cells(0, x), self._cells(1, y)
        low = int(codes.min())
        colours = self.to_rgba(np.arange(low, int(codes.max()) + 1), alpha=self.get_alpha(), bytes=True)
        pixels = colours[codes[np.maximum(row, 0)][:, np.maximum(column, 0)].astype(np.int64) - low]
        pixels[row < 0] = pixels[:, column < 0] = 0
        return pixels, left / magnification, below / magnification, IdentityTransform()

    def get_cursor_data(self, event: Any) -> Any:
        """Return the number of the cell under the cursor, None beside all cells."""
        column, row = (int(self._cells(axis, np.array([place]))[0])
                       for axis, place in enumerate((event.x, event.y)))
        return None if min(column, row) < 0 else np.asarray(self.get_array())[row, column]

    def _cells(self, axis: int, pixels: Array) -> Array:
        """Return the cell along an axis in which each pixel lies, −1 beside all of them."""
        points = np.full((len(pixels), 2), self.axes.bbox.p0)
        points[:, axis] = pixels
        values, ends = self.axes.transData.inverted().transform(points)[:, axis], self.edges[axis]
        places = np.searchsorted(ends, values, side="right") - 1
        return np.where(places < len(ends) - 1, places, -1)
