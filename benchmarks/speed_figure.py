"""The figure of speed_against_error.py.

Time against wrong verdicts, and wrong verdicts against the distance to the boundary.
"""
import statistics

import matplotlib
import numpy as np
from matplotlib import pyplot as plt

STYLES = {                                             # route: name in the legend, colour, marker
    "eigvals 4×4, Re ≤ 0": ("NumPy eigvals, Re ≤ 0", "#7f0000", "v"),
    "eigvals 4×4, Re ≤ 1e-12‖A‖": ("NumPy eigvals, Re ≤ 1e-12‖A‖", "#d7301f", "^"),
    "eigvals 4×4, Re ≤ 1e-08‖A‖": ("NumPy eigvals, Re ≤ 1e-8‖A‖", "#fc8d59", "s"),
    "mpmath eig, 50 digits, 1e-20‖A‖": ("mpmath eig, 50 digits", "#8c510a", "D"),
    "flint acb_mat eig, 256 bits": ("flint acb_mat eig, 256 bits", "#bf812d", "P"),
    "p, q, p² − 4q from traces": ("p, q from traces, float64", "#762a83", "X"),
    "p, q, p² − 4q expanded": ("p, q expanded, float64", "#af8dc3", "d"),
    "exact rationals, flint fmpq": ("exact rationals, flint fmpq", "#1b7837", "h"),
    "compiled margin, float32, numba": ("gyrostat margin, float32, Numba, grid", "#6baed6", "<"),
    "compiled margin, float64, numba": ("gyrostat margin, float64, Numba, grid", "#3182bd", ">"),
    "certified arrays, numba": ("gyrostat certified, Numba, grid", "#08306b", "*"),
}
ALL_RIGHT = 3e-5                                       # where a share of 0 is drawn


def draw(routes, by_family, by_distance, medians, rates, path):
    """Both panels into a file."""
    matplotlib.use("Agg")
    timed = {route.name: route.timed for route in routes}
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 5.6), constrained_layout=True)
    for name, (label, colour, marker) in STYLES.items():
        style = {"color": colour, "marker": marker, "markersize": 13 if marker == "*" else 8,
                 "markeredgecolor": "white",
                 "markeredgewidth": 0.6}
        total = sum(counts for (route, *_), counts in by_family.items() if route == name)
        seconds = statistics.mean(1 / statistics.median(rate[timed[name]]) for rate in rates.values())
        left.plot(_drawn(total), seconds, linestyle="", label=label, **style)
        if (unknown := total[3] / total[0]) > 0.02:
            left.annotate(f"{100 * unknown:.0f} % undecided", (_drawn(total), seconds), (9, -3),
                          textcoords="offset points", fontsize=8)
        labels = sorted(medians, key=medians.get)
        shares = [_drawn(sum(c for (route, _, where),
                             c in by_distance.items() if (route, where) == (name, x))) for x in labels]
        right.plot([medians[x] or min(filter(None, medians.values())) / 30 for x in labels], shares,
                   linewidth=1.3, **style)
    left.set(xscale="log", yscale="log", xlabel="share of wrong verdicts, all families",
             ylabel="time per point, s")
    right.set(xscale="log", yscale="log", xlabel="relative distance to the boundary",
              ylabel="share of wrong verdicts")
    shown = np.array([ALL_RIGHT, 1e-4, 1e-3, 1e-2, 1e-1, 1])
    names = ["none", "0.01 %", "0.1 %", "1 %", "10 %", "100 %"]
    left.set_xticks(shown, names)
    right.set_yticks(shown, names)
    left.set_xlim(ALL_RIGHT / 1.7, 1.5)
    right.set_ylim(ALL_RIGHT / 1.7, 1.5)
    nearest = min(filter(None, medians.values()))
    right.set_xticks([nearest / 30, nearest, *(10.0**e for e in range(-14, -1, 2))],
                     ["on it", "next\nfloat", *(f"$10^{{{e}}}$" for e in range(-14, -1, 2))])
    for axes in (left, right):
        axes.minorticks_off()
        axes.grid(True, color="0.9", linewidth=0.7)
        axes.set_axisbelow(True)
    left.set_title("E1, E2 and E3, families (a) to (f)", fontsize=11)
    right.set_title("E1, E2 and E3, family (a), both sides", fontsize=11)
    figure.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=4, columnspacing=1.5,
                  frameon=False, fontsize=9)
    figure.savefig(path, dpi=130)
    plt.close(figure)


def _drawn(counts):
    """Share of wrong verdicts, none of them a little above 0."""
    return max((counts[1] + counts[2]) / counts[0], ALL_RIGHT)
