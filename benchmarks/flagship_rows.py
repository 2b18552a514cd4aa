"""What guard.py watches: each of the library's speeds, beside something of the same kind that is not ours.

A row has a name, what it is compared with, the two calls, and how many pieces of work each of them does; the
ratio is that of the times of one piece.
"""
import contextlib
import io
import itertools
import json
import pickle
import random
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import baselines
import measured
import numpy as np
import routes
from matplotlib.figure import Figure
from sympy import Matrix

import gyrostat as gs
from gyrostat.charts.boxes.certified_boxes import certified_chart
from gyrostat.charts.chart import stability_chart
from gyrostat.cli.parser import main
from gyrostat.plotting import draw_chart
from gyrostat.trajectories import motion

FOLDER = TemporaryDirectory()


@dataclass(frozen=True)
class Row:
    """One speed: its name, its baseline by name, both calls, and the pieces of work in each.

    noisy: why a loss of it is told only, because the ratio is another one beside other processes.
    """

    name: str
    baseline: str
    ours: Callable[[], object]
    theirs: Callable[[], object]
    pieces: tuple[int, int] = (1, 1)
    noisy: str = ""


def rows() -> Iterator[Row]:
    """All of them; what they need is derived on the way."""
    yield from grids()
    yield from verdicts()
    yield from lists()
    yield from derivations()
    yield from charts()
    yield from motions()
    yield from commands()


def top() -> gs.Report:
    return gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


def linear_field():
    return gs.general_potential(sum(gs.symbol(f"c{n}") * gs.symbol(f"k{n}") for n in (1, 2, 3)))


def in_any_direction() -> gs.Report:
    scene = gs.assemble(gs.Gyrostat((3, 4, 5), (-1, 2, -1)), linear_field())
    return gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))


def grids() -> Iterator[Row]:
    """Certified arrays, in time a point."""
    def grid(report, backend, names, n, fixed):
        axis, out = np.linspace(-4, 4, n), np.empty((n, n), np.int8)
        values = dict(zip(names, (axis[:, None], axis[None, :]))) | fixed
        return partial(gs.charts.verdicts, report, values, backend=backend, out=out)

    n = 4000
    by_hand = baselines.margin_grid(n)
    for backend in ("numba", "numpy"):
        yield Row(f"certified grid, E1, {backend}", "the margin in a loop, Numba",
                  grid(top(), backend, ("pi3_0", "l"), n, {"I1": 1.0, "m0": 1.0}), by_hand)
    small = 400
    arrays = grid(in_any_direction(), "numba", ("u1", "u2"), small, {"omega": -1.0, "sigma": -9.0})
    yield Row("certified grid, any direction, numba", "the margin of E1 in a loop, Numba", arrays, by_hand,
              (small**2, n**2))
    yield Row("certified grid, any direction, numba", "eigvals of 4 × 4", arrays, baselines.eigenvalues(),
              (small**2, baselines.EVERY))
    windows = grid(in_any_direction(), "numba", ("u1", "u2"), 60, {"omega": -1.0, "sigma": -2.0})
    yield Row("grid with windows of D4", "eigvals of 4 × 4", windows, baselines.eigenvalues(),
              (60**2, baselines.EVERY))


def verdicts() -> Iterator[Row]:
    """One verdict at a time, and lines of a batch."""
    draw = random.Random(8)
    def drawn(low, high):
        return Fraction(draw.randint(low, high), draw.randint(1, 12))

    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
    points = [{"I1": drawn(1, 40), "dU": drawn(1, 40), "l": drawn(-40, 40), "pi3_0": drawn(-40, 40)}
              for _ in range(50)]
    def text(n):
        """A number that is written for the first time."""
        return f"{n}/{n + 1}" if n % 4 else f"0.{n:07}"
    count = itertools.count(1)
    texts = itertools.cycle([{name: text(next(count)) for name in points[0]} for _ in range(20000)])

    def each(call, given, many=None):
        return lambda: [call(point) for point in itertools.islice(given, many)]

    by_hand = each(baselines.upright, points)
    yield Row("verdict, E1, fractions", "its inequality in flint", each(report.verdict, points), by_hand)
    yield Row("verdict, E1, texts", "its inequality in flint", each(report.verdict, texts, 50),
              by_hand)
    rotor = tuple(map(gs.symbol, ("l1", "l2", "l3")))
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=rotor), linear_field())
    rotations = gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))
    names = ("I1", "I2", "I3", "l1", "l2", "l3", "omega", "sigma", "u1", "u2")
    directions = [dict(zip(names, [Fraction(draw.randint(4, 30), 10) for _ in range(3)]
                           + [drawn(-8, 8) for _ in range(3)] + [drawn(1, 8)]
                           + [drawn(-20, 20) for _ in range(3)])) for _ in range(20)]
    yield Row("verdict, any direction", "E1's inequality in flint", each(rotations.verdict, directions),
              by_hand, (20, 50))
    carried = pickle.dumps(rotations)
    yield Row("report from a pickle, first verdict", "E1's inequality in flint",
              lambda: pickle.loads(carried).verdict(directions[0]), by_hand, (1, 50))
    lines = 400
    asked, answered = Path(FOLDER.name, "asked.jsonl"), Path(FOLDER.name, "answered.jsonl")
    def batch():
        asked.write_text("".join(json.dumps({"equilibrium": "E1", **next(texts)}) + "\n"
                                 for _ in range(lines)))
        answered.unlink(missing_ok=True)
        with contextlib.redirect_stderr(io.StringIO()):
            if main(["decide", "--batch", str(asked), "--output", str(answered)]):
                raise SystemExit("a line of the batch is not answered")
    yield Row("line of a batch, E1", "its inequality in flint", batch, by_hand, (lines, 50))


def lists() -> Iterator[Row]:
    """All equilibria with their decisions, for numbers of some digits."""
    def number(draw, low, digits):
        """From low/10 to (low + 1)/10; with 20 digits the denominators are unlike."""
        if digits < 20:
            return Fraction(draw.randint(low * 10**digits, (low + 1) * 10**digits), 10 ** (digits + 1))
        return Fraction(low, 10) + Fraction(draw.randint(10**19, 10**20), draw.randint(10**21, 10**22))

    def body(digits, draw):
        return [[number(draw, n, digits) for n in (10, 12, 14)], [number(draw, n, digits) for n in (2, 5, 8)]]

    def lists_of(digits, field, values):
        """A call that lists the equilibria of another body each time: those of the last one are kept."""
        draw = random.Random(digits)
        def run():
            scene = gs.assemble(gs.Gyrostat(*body(digits, draw)), field)
            return [e.decision for e in gs.relative_equilibria(scene, values)]
        return run

    scripts, in_flint = baselines.characteristic_polynomials(), "6 × 6 spectra in flint"
    by_newton = "Newton from 2000 starts, NumPy"
    for digits in (1, 16, 20):
        yield Row(f"list, satellite, numbers of length {digits}", in_flint,
                  lists_of(digits, gs.circular_orbit(1), {}), scripts)
    some = body(1, random.Random(1))
    yield Row("list, satellite, numbers of length 1", by_newton, lists_of(1, gs.circular_orbit(1), {}),
              partial(baselines.attitudes_by_newton, *some, 1))
    c, k = (0.1, 0.2, 0.3), [gs.symbol(f"k{n}") for n in (1, 2, 3)]
    U = sum(Fraction(n, 10) * x for n, x in enumerate(k, 1))
    linear, quadratic = (gs.general_potential(u) for u in (U, U + k[0] * k[1] / 5 + k[2] ** 2 / 4))
    for digits in (1, 16):
        yield Row(f"list, given C1, numbers of length {digits}", in_flint,
                  lists_of(digits, linear, {"C1": 1}), scripts)
    yield Row("list, given C1, numbers of length 1", by_newton, lists_of(1, linear, {"C1": 1}),
              partial(baselines.rotations_by_newton, *some, c, np.zeros((3, 3)), level=1))
    Q = [[0, 0.2, 0], [0.2, 0, 0], [0, 0, 0.5]]
    yield Row("list at a rate, quadratic U", by_newton, lists_of(1, quadratic, {"omega": 1}),
              partial(baselines.rotations_by_newton, *some, c, Q, rate=1))


def derivations() -> Iterator[Row]:
    """From the scene to the criteria, again and again in one process."""
    yield Row("derivation of E1, E2, E3", "the same in flint alone", routes.gyrostat_route,
              routes.flint_route)
    def rotations(moments):
        scene = gs.assemble(gs.Gyrostat(moments, tuple(map(gs.symbol, ("l1", "l2", "l3")))), linear_field())
        report = gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))
        return report.necessary, report.sufficient
    tensor = Matrix(3, 3, lambda i, j: gs.symbol(f"I{min(i, j) + 1}{max(i, j) + 1}"))
    for name, moments in (("principal moments", tuple(map(gs.symbol, ("I1", "I2", "I3")))),
                          ("a tensor of names", tensor)):
        yield Row(f"derivation, any direction, {name}", "6 × 6 spectra in flint", partial(rotations, moments),
                  baselines.characteristic_polynomials())


def charts() -> Iterator[Row]:
    """From the call to the picture."""
    report, n = top(), 2000
    axes = {"x": ("pi3_0", np.linspace(-4, 4, n)), "y": ("l", np.linspace(-2, 2, n))}
    def picture():
        figure, file = Figure(), io.BytesIO()
        draw_chart(stability_chart(report, fixed={"I1": 1, "m0": 1}, **axes), figure.subplots())
        figure.savefig(file, format="png", dpi=150)
    codes = stability_chart(report, fixed={"I1": 1, "m0": 1}, **axes).verdict.values
    yield Row("chart of 2000 × 2000 to PNG", "imshow of its array", picture, partial(baselines.image, codes))
    region = {"I1": 1, "m0": 1, "l": (-4, 4), "pi3_0": (-4, 4)}
    yield Row("certified chart, resolution 1/512", "eigvals of 4 × 4",
              partial(certified_chart, report, region, resolution=Fraction(1, 512), progress=False),
              baselines.eigenvalues())


def motions() -> Iterator[Row]:
    """A heavy gyrostat of revolution in closed form."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    values = {"I1": 2.0, "I3": 1.25, "l": 0.5, "m0": 1.0}
    state = (0.3, -0.2, 1.5, 0.48, 0.6, 0.64)
    solved, n = motion(scene, state, values), 10**5
    times = np.linspace(0, 4000, n)
    yield Row("set-up of a motion", "6 × 6 spectra in flint", partial(motion, scene, state, values),
              baselines.characteristic_polynomials())
    yield Row("motion at 10⁵ times in a row", "SciPy's elliptic functions", partial(solved, times),
              baselines.elliptic_functions(n))


def commands() -> Iterator[Row]:
    """Whole processes."""
    def command(*arguments):
        return partial(subprocess.run, [sys.executable, "-m", "gyrostat", *arguments], check=True,
                       stdout=subprocess.DEVNULL, env=measured.BYTECODE)
    attitudes = ("decide", *"--orbit 1 --inertia 1,5/4,8/5 --gyrostatic-momentum 3/10,1/5,1/10".split())
    yield Row("gyrostat report", "import sympy", command("report"), baselines.start_with_sympy)
    yield Row("gyrostat decide --orbit", "import sympy", command(*attitudes), baselines.start_with_sympy)
    yield Row("gyrostat decide --orbit, JSON", "import sympy", command(*attitudes, "--format", "json"),
              baselines.start_with_sympy)
