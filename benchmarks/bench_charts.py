"""How long does a chart take, from the call to the picture, and how much of a region does a certified chart
leave undecided?

    python benchmarks/bench_charts.py            all of it; prints a section of RESULTS.md
    python benchmarks/bench_charts.py --quick    small, for breakage

The picture: E1 of a heavy gyrostat in (l, π3) and E3 in U = k3⁴ − k3²/2 in (ω, k3), as gyrostat chart draws
it. The error: the verdict at random points of the chart, and at the points on both sides of its boundary,
against Report.verdict. The certified chart: E1 in (l, π3), both in [−4, 4], I1 = m0 = 1; the error:
Report.verdict at random points of its boxes.
"""
import argparse
import io
from fractions import Fraction

import numpy as np
from matplotlib.figure import Figure
from measured import cpu, here_and_now, spread

import gyrostat as gs
from gyrostat.charts.boxes.certified_boxes import certified_chart
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.codes import CODE_OF
from gyrostat.plotting import draw_chart

BODY = gs.symmetric_gyrostat()
TOP = gs.analyze(gs.upright(gs.assemble(BODY, gs.uniform_field())))
TILT = gs.analyze(gs.inclined(gs.assemble(BODY, gs.axial_potential(lambda k3: k3**4 - k3**2 / 2))))


def rotations():
    """Permanent rotations of a heavy gyrostat with a rotor, by their direction: with windows."""
    field = gs.general_potential(lambda *k: sum(gs.symbol(f"c{n}") * x for n, x in enumerate(k, 1)))
    scene = gs.assemble(gs.Gyrostat((3, 4, 5), (-1, 2, -1)), field)
    return gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))


def picture(report, x, y, fixed):
    """The chart, and its picture as bytes."""
    chart = stability_chart(report, x=x, y=y, fixed=fixed)
    figure, file = Figure(), io.BytesIO()
    draw_chart(chart, figure.subplots())
    figure.savefig(file, format="png", dpi=150)
    return chart


def wrong_in_chart(report, chart, rng, count):
    """Points whose code is not that of Report.verdict.

    Random ones, and neighbours of another verdict along a row.
    """
    codes = chart.verdict.values
    rows, columns = np.nonzero(codes[:, 1:] != codes[:, :-1])
    some = rng.integers(0, max(len(rows), 1), count) if len(rows) else np.empty(0, int)
    places = [*zip(rng.integers(0, codes.shape[0], count), rng.integers(0, codes.shape[1], count)),
              *((rows[i], columns[i] + side) for i in some for side in (0, 1))]
    up, across = chart.verdict.dims
    fixed = {name: c.attrs["exact"] for name, c in chart.coords.items() if c.ndim == 0}
    wrong = 0
    for i, j in places:
        values = fixed | {up: float(chart[up][i]), across: float(chart[across][j])}
        wrong += codes[i, j] != CODE_OF[report.verdict(values).verdict]
    return wrong, len(places)


def wrong_in_boxes(report, chart, rng, count):
    """Boxes at a random point of which Report.verdict says another thing than the box."""
    wrong = 0
    decided = np.flatnonzero(chart.code != 0)
    for n in rng.choice(decided, min(count, len(decided)), replace=False):
        share = [Fraction(int(k), 1000) for k in rng.integers(0, 1001, len(chart.axes))]
        point = {name: Fraction(float(low)) + t * (Fraction(float(high)) - Fraction(float(low)))
                 for name, low, high, t in zip(chart.axes, chart.low[n], chart.high[n], share)}
        wrong += chart.code[n] != CODE_OF[report.verdict(point | {"I1": 1, "m0": 1}).verdict]
    return wrong, min(count, len(decided))


def timed(call, rounds):
    """The result, seconds of the first call, and of those after it."""
    seconds = []
    for _ in range(rounds + 1):
        begin = cpu()
        result = call()
        seconds.append(cpu() - begin)
    return result, seconds[0], seconds[1:]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    quick = parser.parse_args().quick
    n, rounds, count, rng = (
        (200, 1, 20, np.random.default_rng(5)) if quick else (2000, 9, 1000, np.random.default_rng(5))
    )
    print(f"{here_and_now('numpy', 'numba', 'matplotlib')}; median (min–max) of {rounds} after a first one, "
          "seconds of CPU. Wrong: against `Report.verdict` at random points, at both points beside changes "
          "of the verdict, and at random points inside boxes. With windows: one after a first one, permanent "
          "rotations of a heavy gyrostat, I = (3, 4, 5), l = (−1, 2, −1), the curves inside windows too.\n")
    print("| what | first, s | then, s | wrong |\n|---|---|---|---|")
    failed = 0
    charts = (("E1, (l, π3)", TOP, ("pi3_0", np.linspace(-4, 4, n)), ("l", np.linspace(-2, 2, n)),
               {"I1": 1, "m0": 1}),
              ("E3, (ω, k3)", TILT, ("k3", np.linspace(-0.6, 0.6, n)), ("omega", np.linspace(-1, 1, n)),
               {"I1": 2}))
    for name, report, x, y, fixed in charts:
        chart, first, then = timed(lambda r=report, x=x, y=y, f=fixed: picture(r, x, y, f), rounds)
        wrong, points = wrong_in_chart(report, chart, rng, count)
        failed += wrong
        print(f"| chart to PNG, {n} × {n}, {name} | {first:.2f} | {spread(then, '.2f')} | "
              f"{wrong} of {points} |")
    windows, n = rotations(), 40 if quick else 400
    for name, y, fixed in (("(u1, u2)", ("u2", np.linspace(-2, 2, n)), {"omega": -1, "sigma": -2}),
                           ("(u1, ω)", ("omega", np.linspace(-3, 1, n)), {"u2": "1/3", "sigma": -2})):
        x = ("u1", np.linspace(-2, 2, n))
        chart, first, then = timed(lambda y=y, f=fixed, x=x: picture(windows, x, y, f), 1)
        wrong, points = wrong_in_chart(windows, chart, rng, 5 if quick else 300)
        failed += wrong
        rungs = zip(chart.rung.attrs["flag_meanings"].split(), chart.rung.attrs["flag_values"])
        decided = ", ".join(f"{rung} {share}" for rung, code in rungs
                            if (share := int((chart.rung == code).sum())))
        print(f"| with windows, {n} × {n}, {name}: {decided} | {first:.2f} | {then[0]:.2f} | "
              f"{wrong} of {points} |")
    resolution = Fraction(1, 256) if quick else Fraction(1, 8192)
    region = {"I1": 1, "m0": 1, "l": (-4, 4), "pi3_0": (-4, 4)}
    chart, first, then = timed(lambda: certified_chart(TOP, region, resolution=resolution, progress=False),
                               rounds)
    undecided = float(chart.measure["undecided"])
    wrong, points = wrong_in_boxes(TOP, chart, rng, count)
    failed += wrong
    print(f"| certified chart, E1, (l, π3): {len(chart.code)} boxes, undecided {undecided:.2e} of the "
          f"region | {first:.2f} | {spread(then, '.2f')} | {wrong} of {points} |")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
