"""What motion_speed_against_error.py shows: tables in Markdown, and error against time in a figure."""
import statistics
from dataclasses import dataclass, field
from itertools import groupby

import matplotlib
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.transforms import Bbox

OURS = "gyrostat"
STYLES = {                                                 # family: label, colour, marker
    "heyoka": ("heyoka", "#0072b2", "o"), "Strang, order 2": ("Strang 2", "#8c8c8c", "v"),
    "Blanes-Moan, order 4": ("Blanes-Moan 4", "#009e73", "D"),
    "Kahan-Li, order 8": ("Kahan-Li 8", "#00573f", "s"),
    "SciPy RK45": ("RK45", "#e69f00", "<"), "SciPy DOP853": ("DOP853", "#d55e00", ">"),
    "SciPy Radau": ("Radau", "#a6761d", "P"),
    "SciPy LSODA": ("LSODA", "#cc79a7", "X"),
}
PANELS = (("M1", "t"), ("M3", "t"), ("generic", "1e4"),    # case and time, as they begin
          ("sleep", "1e2"), ("near a separatrix, d = 1e-2", "t"), ("near a separatrix, d = 1e-6", "t"))
SMALLEST = 1e-18                                           # where an error of 0 is drawn
DPI = 130


@dataclass
class Row:
    """What was measured of one method, seconds; expected instead of the rest if it was too long."""

    family: str
    setting: str
    setup: list = field(default_factory=list)
    run: list = field(default_factory=list)
    error: float | None = None
    drifts: list = field(default_factory=list)
    expected: float | None = None


def spread(seconds):
    """Milliseconds: median, smallest and largest, or the only one."""
    ms = [1e3 * s for s in seconds]
    return f"{statistics.median(ms):.3g}" + (f" ({min(ms):.2g}–{max(ms):.2g})" if len(ms) > 1 else "")


def line(*cells):
    return f"| {' | '.join(map(str, cells))} |"


def table(case, rows, limit):
    """A row for each method; those that took too long together; what is prepared in no time has no set-up."""
    names = ["drift h", "drift ∣π∣²"] if case.free else ["drift h", "drift (π + l)·k", "drift ∣k∣²"]
    heads = ["method", "setting", "set-up, ms: first; later", "run, ms", "error", *names]
    yield from (line(*heads), "|---" * len(heads) + "|")
    for (family, late), group in groupby(rows, lambda row: (row.family, bool(row.expected))):
        if late:
            settings, times = zip(*((row.setting, f"{1e3 * row.expected:.0e}") for row in group))
            yield line(family, ", ".join(settings), "", f"> {1e3 * limit:.0f} (about {', '.join(times)})",
                       *["—"] * (1 + len(names)))
            continue
        for row in group:
            first, *later = row.setup
            setup = (
                f"{1e3 * first:.3g}" + (f"; {spread(later)}" if later else "")
                if family in (OURS, "heyoka")
                else "—"
            )
            yield line(family, row.setting, setup, spread(row.run), f"{row.error:.1e}",
                       *(f"{d:.0e}" for d in row.drifts))


def short_table(panels):
    """Of each case the time and error of ours, and of the most accurate of each other kind."""
    kinds = ("heyoka", "SciPy", "order")
    yield from (line("case", "time", "ours: set-up + run, ms", "error",
                     *(f"most accurate: {k}" for k in ("heyoka", "SciPy", "splitting"))),
                "|---" * 7 + "|")
    for case, label, rows in panels:
        cells = []
        for kind in (OURS, *kinds):
            done = [row for row in rows if kind in row.family and row.error is not None]
            best = min(done, key=lambda row: row.error, default=None)
            if kind == OURS and best:
                cells += [f"{1e3 * (statistics.median(best.setup) + statistics.median(best.run)):.3g}",
                          f"{best.error:.1e}"]
            else:
                cells.append(f"{1e3 * statistics.median(best.run):.3g} ms, {best.error:.1e}" if best else "—")
        yield line(case.name, label, *cells)


def draw(panels, limit, path):
    """Error of the state against time, a panel for each of some cases, on common axes."""
    matplotlib.use("Agg")
    figure, grid = plt.subplots(2, 3, figsize=(10, 7.6), dpi=DPI, sharex=True, sharey=True)
    figure.subplots_adjust(left=0.085, right=0.995, bottom=0.085, top=0.94, wspace=0.04, hspace=0.2)
    for axes, (name, time) in zip(grid.flat, PANELS):
        axes.set(xscale="log", yscale="log", xlim=(3e-3, 6e5), ylim=(SMALLEST / 300, 100))
        case, label, rows = next(panel for panel in panels if panel[0].name.startswith(name)
                                 and panel[1].startswith(time))
        _panel(axes, case, label, rows, limit)
    figure.supxlabel("time of one state, ms; gyrostat without set-up (hollow star) and with it, the others "
                     "without compilation", size=11)
    figure.supylabel("error of the state", size=11)
    figure.canvas.draw()
    for axes in grid.flat:
        _name(axes)
    figure.savefig(path, dpi=DPI)
    plt.close(figure)


def _panel(axes, case, label, rows, limit):
    """The curves, each with its name as label; what took too long is named at the foot."""
    axes.set_title(f"{case.name}\n{label}", fontsize=10.5)
    axes.grid(True, color="0.92", linewidth=0.6)
    axes.set_axisbelow(True)
    for row in (row for row in rows if row.family == OURS):
        run, setup = (1e3 * statistics.median(x) for x in (row.run, row.setup))
        place = max(row.error, SMALLEST)
        star = {"color": "black", "marker": "*", "markersize": 12, "zorder": 3}
        axes.plot([run, run + setup], [place] * 2, markevery=[1], label=f"gyrostat: {row.setting}", **star)
        axes.plot(run, place, markerfacecolor="white", **star)
    for family, (name, colour, marker) in STYLES.items():
        points = [(1e3 * statistics.median(row.run), max(row.error, SMALLEST))
                  for row in rows if row.family == family and not row.expected]
        if points:
            axes.plot(*zip(*points), color=colour, marker=marker, markersize=6.5, linewidth=1.1,
                      markeredgecolor="white",
                      markeredgewidth=0.5, label=name)
    late = [STYLES[row.family][0] for row in rows if row.expected]
    names = [f"{name} ({late.count(name)})" for name in dict.fromkeys(late)]
    lines = [f"longer than {limit:.0f} s:"] * bool(names) + [", ".join(names[i:i + 4])
                                                             for i in range(0, len(names), 4)]
    axes.text(0.025, 0.02, "\n".join(lines), transform=axes.transAxes, fontsize=8.5, color="0.35")


def _name(axes):
    """Each name beside one of the points of its curve, where it covers the fewest points, lines and names."""
    curves = [(line, axes.transData.transform(line.get_xydata())) for line in axes.lines]
    spots = np.concatenate([a + (b - a) * np.linspace(0, 1, 9)[:, None] for _, points in curves
                            for a, b in zip(points, [*points[1:], points[-1]])])
    frame, boxes = axes.get_window_extent(), [text.get_window_extent()
                                              for text in axes.texts if text.get_text()]
    for curve, points in curves:
        if curve.get_label().startswith("_"):
            continue
        text = axes.text(0, 0, curve.get_label(), fontsize=9.5, color=curve.get_color(), transform=None)
        size, found = np.array(text.get_window_extent().size), []
        for n, point in enumerate(points[::-1]):
            for side in ((0, -0.5), (-1, -0.5), (-0.5, 0), (-0.5, -1), (0, 0), (-1, -1), (0, -1), (-1, 0)):
                away = np.sign(np.array(side) + 0.5) * 10
                low = point + size * side + away
                box = Bbox([low, low + size])
                crossed = np.sum(np.all((spots > low - 1) & (spots < low + size + 1), axis=1))
                out = not (frame.x0 < box.x0 and box.x1 < frame.x1 and frame.y0 < box.y0
                           and box.y1 < frame.y1)
                found.append((crossed + 20 * sum(box.overlaps(other) for other in boxes) + 100 * out + 0.1
                              * n, len(found), box))
        box = min(found)[2]
        text.set_position((box.x0, box.y0))
        boxes.append(box)
