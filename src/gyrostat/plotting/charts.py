"""Draws stability charts: stable is light, unstable dark, undecided hatched, the boundary a black line."""
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from .._lazy import loaded
from ..algebra.enclosures.floats import Array
from ..algebra.text.grammar import parse
from ..arguments import checked
from ..errors import ValuesError, optional, require
from ..notation import dimension_of, order
from ..printing.formats.latex import tex
from ..printing.formats.latex_names import Names
from ..typesetting import typeset
from .captions import headed
from .chart_curves import contours, curves
from .headings import field, number
from .looks import AREAS, DESTROYED, INK, LOOKS, axes_of, label, si_unit, with_dimension

MODULO = {"the flow of pi3": "the spin"}                   # about the axis of the body
# values of an axis that are drawn; of more, every second, third, …
SHOWN = 2000
# squares along an axis that the eye can tell apart
FINEST = 150


@checked
def draw_chart(ds: Any, ax: Any = None, *, si: bool = False, **kwargs: Any) -> Any:
    r"""Draw a stability chart of two axes.

    The title has the numbers of the scene, of an orbit its rate, and those that are fixed.

    Parameters
    ----------
    ds : xarray.Dataset
        of stability_chart, from memory or opened from a store or a file; of a large one at most 2000 values
        of each axis are read. With what with_barriers adds there are contours of the kick
    ax : matplotlib Axes
        a new one where it is left out; a figure without a layout gets the constrained one, which has room for
        what stands above
    si : bool
        whether the numbers are those of SI: axes and title then have its units, instead of the dimension in
        M, L and T
    **kwargs : Any
        of the image of the verdicts, as matplotlib.image.AxesImage takes them: alpha=0.5

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValuesError
        the verdict has another number of axes than two
    MissingExtraError
        pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> from matplotlib.figure import Figure
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> chart = gs.charts.stability_chart(
    ...     gs.analyze(gs.upright(scene)), x=("pi3_0", np.linspace(-4, 4, 80)),
    ...     y=("l", np.linspace(-2, 2, 60)), fixed={"I1": 1, "m0": 1})
    >>> gs.plotting.draw_chart(chart, Figure().subplots()).get_xlabel()
    '$\\pi_3^0$ $[\\mathrm{M\\,L^{2}\\,T^{-1}}]$'
    """
    require(ds, optional("xarray", "charts").Dataset, "the chart")
    if ds.verdict.ndim != 2:
        raise ValuesError(f"the verdict has the axes {', '.join(ds.verdict.dims) or '(none)'}, two are "
                          "drawn: choose values of the others "
                          f"with ds.sel({ds.verdict.dims[0] if ds.verdict.dims else 'l'}=…) or ds.isel")
    ax = axes_of(ax)
    if (figure := ax.get_figure(root=True)).get_layout_engine() is None:
        figure.set_layout_engine("constrained")
    dims = ds.verdict.dims
    seen = ds.verdict.isel({name: slice(None, None, -(-n // SHOWN)) for name, n in ds.verdict.sizes.items()})
    seen = seen.isel({name: slice(None, None, -1) for name in dims if seen.sizes[name] > 1
                      and seen[name][0] > seen[name][-1]})
    y, x = (seen[name].values for name in dims)
    codes = {name: int(code) for name, code in zip(ds.verdict.attrs["flag_meanings"].split(),
                                                   ds.verdict.attrs["flag_values"])}
    verdict = np.asarray(seen.values)
    edges = _edges(x), _edges(y)
    _image(ax, verdict, edges, codes, kwargs)
    occurring = {name: verdict == codes[name] for name in LOOKS if (verdict == codes[name]).any()}
    for name, where in occurring.items():
        if LOOKS[name][1]:
            _hatched(ax, x, y, edges, where, name)
    destroyed = _destroyed(ds, seen, codes)
    if destroyed.any():
        _hatched(ax, x, y, edges, destroyed, DESTROYED)
    drawn = curves(ax, ds, dims, edges)
    drawn += contours(ax, ds.sel({name: seen[name] for name in dims}), si)
    ax.set(xlim=(edges[0][0], edges[0][-1]), ylim=(edges[1][0], edges[1][-1]),
           xlabel=_label(seen[dims[1]], si), ylabel=_label(seen[dims[0]], si))
    shown = [name for name, where in occurring.items() if _visible(where & ~destroyed)]
    names = {name: name.replace("_", " ") for name in shown} | _modulo(ds, shown)
    if _visible(destroyed):
        names[DESTROYED] = DESTROYED
    headed(ax, f"Stability chart in {label(str(dims[1]))} and {label(str(dims[0]))}", _said(ds, si),
           [*_patches(names), *drawn])
    return ax


def _said(ds: Any, si: bool) -> tuple[list[str], list[str]]:
    """Return the equilibrium and U, and the numbers of the scene, those that are fixed or determined."""
    latex = ds.attrs.get("potential_latex", "")
    scene = dict(text.split(" = ") for text in ds.attrs.get("scene", "").split("; ") if text)
    said = {name: _number(name, parse(text), text, si) for name, text in scene.items()}
    said |= {str(name): _number(str(name), c.item(), _exact(c), si, c.attrs.get("latex", name))
             for name, c in ds.coords.items() if c.ndim == 0}
    fixed = [said[name] for name in sorted(said, key=order)]
    if eliminated := ds.attrs.get("eliminated"):
        fixed.append(f"{', '.join(map(label, eliminated.split(', ')))} determined at each point")
    above = [*(["in orbit"] if "orbit" in ds.attrs else []), *(field(latex) if latex else [])]
    return [ds.attrs["equilibrium"], *above], fixed


def _number(name: str, value: Any, exact: str, si: bool, latex: str = "") -> str:
    """Return a name and its number, or a formula if it has names in it; of SI with its unit."""
    formula = bool(getattr(value, "free_symbols", ()))
    shown = tex(value, Names()) if formula else number(value, exact)
    unit = si_unit(name) if si and not formula else ""
    return f"${latex or typeset(name)} = {shown}" + (rf"\,{unit}$" if unit else "$")


def _exact(coordinate: Any) -> str:
    """A fixed number as it was given; of a plane of a larger chart there is none."""
    return str(coordinate.attrs.get("exact", ""))


def _edges(values: Array) -> Array:
    """Ends of the cells around increasing values."""
    if len(values) == 1:
        return np.array([values[0] - 0.5, values[0] + 0.5])
    inner = values[:-1] + np.diff(values) / 2
    return np.array([2 * values[0] - inner[0], *inner, 2 * values[-1] - inner[-1]])


def _image(ax: Any, verdict: Array, edges: tuple[Array, Array], codes: dict[str, int],
           kwargs: dict[str, Any]) -> None:
    from matplotlib.colors import BoundaryNorm, ListedColormap

    order = sorted(LOOKS, key=lambda name: codes[name])
    bounds = [codes[name] - 0.5 for name in order] + [codes[order[-1]] + 0.5]
    given = {"cmap": ListedColormap([LOOKS[name][0] for name in order]),
             "norm": BoundaryNorm(bounds, len(order)), **kwargs}
    ax.add_image(loaded("plotting.cells:Cells")(ax, verdict, edges, **given))


def _hatched(ax: Any, x: Array, y: Array, edges: tuple[Array, Array], where: Array, name: str) -> None:
    """Hatches over the cells of one look, out to the ends of the axes."""
    x, y = (np.concatenate([ends[:1], values, ends[-1:]]) for ends, values in zip(edges, (x, y)))
    hatches = ax.contourf(x, y, np.pad(where, 1, mode="edge").astype(float), levels=[0.5, 1.5],
                          colors="none" if name in LOOKS else [AREAS[name][0]], hatches=[AREAS[name][1]])
    hatches.set_edgecolor(INK[name])
    hatches.set_linewidth(0)


def _destroyed(ds: Any, seen: Any, codes: Mapping[str, int]) -> Array:
    """Where it is stable, but not under internal damping, of a chart that has both."""
    stable = np.asarray(seen.values) == codes["stable"]
    if "damped" not in ds:
        return np.zeros_like(stable)
    damped = ds.damped.sel({name: seen[name] for name in seen.dims})
    return np.asarray(stable & (damped.values == codes["unstable"]))


def _visible(where: Array) -> bool:
    """Whether a verdict fills somewhere a square wider than the line of a boundary."""
    for axis, n in enumerate(where.shape):
        where = _runs(where, max(1, n // FINEST), axis)
    return bool(where.any())


def _runs(where: Array, length: int, axis: int) -> Array:
    """Where it is so in that many places in a row along an axis, by the first of them."""
    found, known = where.swapaxes(0, axis), 1
    while known < length:
        step = min(known, length - known)
        found, known = found[step:] & found[:-step], known + step
    return found.swapaxes(0, axis)


def _label(coordinate: Any, si: bool) -> str:
    name = str(coordinate.name)
    text = f"${coordinate.attrs['latex']}$" if "latex" in coordinate.attrs else name
    if si:
        return f"{text} $[{unit}]$" if (unit := si_unit(name)) else text
    return with_dimension(text, dimension_of(name))


def _modulo(ds: Any, names: Iterable[str]) -> dict[str, str]:
    """What stable is called where it is so modulo a flow."""
    modulo = ds.verdict.attrs.get("modulo")
    return {"stable": f"stable modulo {MODULO.get(modulo, modulo)}"} if modulo and "stable" in names else {}


def _patches(names: Mapping[str, str]) -> list[Any]:
    """What stands in the legend for areas."""
    from matplotlib.patches import Patch
    return [Patch(facecolor=AREAS[name][0], hatch=AREAS[name][1], edgecolor=INK.get(name, "black"),
                  linewidth=0.6, label=said) for name, said in names.items()]
