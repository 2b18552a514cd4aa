"""What is asked of a grid of parameters: verdicts, margins, and the curves between the verdicts."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from sympy import Expr

from ..algebra.enclosures.floats import Array
from ..algebra.rings.polynomials import Ring
from ..notation import symbol
from ..stability.report.report import Report
from .curves.contours import boundary, thinned
from .curves.window_curves import Plane, window_curves
from .progress import Told
from .signs.compiled_margins import compile_margin
from .signs.verdict_arrays import decided, verdicts


@dataclass(frozen=True)
class Request:
    """A report over a grid of parameters, and what is wanted there.

    Parameters
    ----------
    report : Report
    names : tuple of str
        the names of the axes, outermost first
    fixed : tuple of (str, Expr, str)
        name, exact number, and the number as it was given
    margins : bool
        whether the values of the margins are wanted besides
    backend : str
        "numpy" or "numba"
    damped : bool
        whether the verdicts under internal damping are wanted besides
    """

    report: Report
    names: tuple[str, ...]
    fixed: tuple[tuple[str, Expr, str], ...]
    margins: bool
    backend: str
    damped: bool = False

    @property
    def all_margins(self) -> list[Expr]:
        """The margins of both criteria, each once."""
        criteria = (self.report.necessary, self.report.sufficient)
        return list(dict.fromkeys(c.margin for criterion in criteria
                                  for alternative in criterion.alternatives for c in alternative))

    @property
    def deciding(self) -> list[Expr]:
        """What changes its sign between two verdicts.

        It is the margins, and what is positive if the equilibrium exists.
        """
        ring = Ring(existence := list(self.report.equilibrium.existence()))
        return [*self.all_margins, *(ring.expression(top * bottom)
                                     for top, bottom in map(ring.fraction, existence))]

    @property
    def windowed(self) -> bool:
        """Whether a normal form may decide, if gyroscopic forces stabilise a maximum: in one direction."""
        scene = self.report.equilibrium.system
        return self.report.boundary is None and scene.potential is not None and not scene.coupled

    def variables(self, arrays: Sequence[Array], threads: int = 1,
                  progress: Told | bool | None = False) -> dict[str, Array]:
        """Return verdicts, and what else is wanted, over the grid of the arrays, one for each axis."""
        grid = {name: array.reshape(-1, *(1,) * (len(arrays) - 1 - i))
                for i, (name, array) in enumerate(zip(self.names, arrays))}
        numbers = {name: number for name, number, _ in self.fixed} | grid
        rungs = np.zeros(tuple(map(len, arrays)), np.int8) if self.windowed else None
        found = {"verdict": decided(self.report, numbers, invalid="mark", backend=self.backend,
                                    threads=threads, rungs=rungs, progress=progress)}
        if rungs is not None:
            found["rung"] = rungs
        if self.damped:
            found["damped"] = verdicts(self.report, numbers, damped=True, invalid="mark", threads=threads,
                                       progress=progress)
        if self.margins:
            shape = tuple(map(len, arrays))
            for n, margin in enumerate(self.all_margins):
                compiled = compile_margin(margin, self.backend)
                with np.errstate(all="ignore"):        # a point may lie outside of the domain of U
                    values = compiled(**{name: numbers[name] for name in compiled.names}, threads=threads)
                found[f"margin_{n}"] = np.ascontiguousarray(np.broadcast_to(values, shape))
        return found

    def curves(self, arrays: Sequence[Array], found: Mapping[str, Array]) -> dict[str, Array]:
        """Return x and y of the boundary between the verdicts of two axes, and of the curves inside windows.

        On axes with more than 2000 values they are followed on about 2000 of them; the vertices lose no
        accuracy. If no verdicts are given, they are found there.
        """
        rows, columns = map(thinned, map(len, arrays))
        y, x = arrays[0][rows], arrays[1][columns]
        seen = ({name: found[name][rows][:, columns] for name in ("verdict", "rung") if name in found}
                or self.variables([y, x]))
        up, across = map(symbol, self.names)
        numbers = {name: number for name, number, _ in self.fixed}

        def verdict_at(at_x: Array, at_y: Array) -> Array:
            return verdicts(self.report, numbers | {across.name: at_x, up.name: at_y}, invalid="mark",
                            progress=False)

        known = {symbol(name): number for name, number in numbers.items()}
        curves = dict(zip(("boundary_x", "boundary_y"), boundary(
            self.deciding, known, (across, x), (up, y), seen["verdict"], verdict_at)))
        if "rung" in seen:
            points = window_curves(Plane(self.report, known, (across, x), (up, y)), seen["rung"])
            curves |= {"curve_x": points[0], "curve_y": points[1],
                       "curve": np.nan_to_num(points[2]).astype(np.int8)}
        return curves
