"""How do costs grow with the degree of U, digits, names, points, lines and rotors?

    python benchmarks/growth.py            all of it, minutes; prints a section of docs/explanation/growth.md,
        draws growth.png
    python benchmarks/growth.py --quick    small sizes, once, for breakage

Each cost is the CPU time of one call, the median of nine after two. The exponent n is that by which
the cost grows from the last size but one to the last: doubled, the size costs 2ⁿ times as much.
"""
import argparse
import contextlib
import io
import itertools
import json
import math
import random
import statistics
from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from matplotlib.figure import Figure
from measured import here_and_now, in_turn
from sympy import Rational

import gyrostat as gs
from gyrostat.cli.parser import main as command

PICTURE = Path(__file__).with_suffix(".png")
FOLDER = TemporaryDirectory()
Curve = tuple[str, Iterable[int], Callable[[int], Callable[[], object]]]


def numbers(seed: int | random.Random, length: int, count: int) -> list[Fraction]:
    """Decimals between 1/10 and 1 of this length."""
    draw = seed if isinstance(seed, random.Random) else random.Random(seed)
    return [Fraction(draw.randint(10 ** (length - 1), 10**length), 10**length) for _ in range(count)]


def polynomial(degree: int, coefficients: Iterable[object]) -> object:
    return sum(a * gs.symbol("k3") ** n for n, a in zip(range(1, degree + 1), coefficients))


def derivation(degree: int) -> Callable[[], object]:
    """E1, E2 and E3 with their criteria, the coefficients of U being names."""
    def run():
        names = [gs.symbol(f"a{n}") for n in range(1, degree + 1)]
        scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(polynomial(degree, names)))
        return [gs.analyze(family(scene)).sufficient for family in (gs.upright, gs.hanging, gs.inclined)]
    return run


def all_of(scene: object, values: dict) -> Callable[[], object]:
    return lambda: [e.decision for e in gs.relative_equilibria(scene, values)]


def tilts(degree: int) -> Callable[[], object]:
    """All equilibria of a body of revolution in a field with numbers."""
    U = polynomial(degree, [Rational(x.numerator, x.denominator) for x in numbers(1, 2, degree)])
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))
    return all_of(scene, {"I1": 2, "I3": 1, "l": Fraction(1, 3), "omega": Fraction(1, 2)})


def lists_of(length: int, field: object, values: dict) -> Callable[[], object]:
    """All equilibria of another body each time: those of the last one are kept."""
    draw = random.Random(length)
    def run():
        moments, rotor = numbers(draw, length, 3), numbers(draw, length, 3)
        moments = [n + x / 8 for n, x in zip((1, Fraction(5, 4), Fraction(3, 2)), moments)]
        return all_of(gs.assemble(gs.Gyrostat(moments, rotor), field), values)()
    return run


def satellite(length: int) -> Callable[[], object]:
    return lists_of(length, gs.circular_orbit(1), {})


def given_level(length: int) -> Callable[[], object]:
    U = sum(Rational(n, 10) * gs.symbol(f"k{n}") for n in (1, 2, 3))
    return lists_of(length, gs.general_potential(U), {"C1": 1})


def verdict(length: int) -> Callable[[], object]:
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
    return partial(report.verdict, dict(zip(("I1", "l", "pi3_0", "dU"), numbers(4, length, 4))))


def rotation(names: int) -> Callable[[], object]:
    """The criteria of a heavy gyrostat in any direction; of its moments and rotor some are names."""
    letters = [gs.symbol(name) for name in ("I1", "I2", "I3", "l1", "l2", "l3")]
    given = [*letters[:names], *(3, 4, 5, -1, 2, -1)[names:]]
    U = sum(gs.symbol(f"c{n}") * gs.symbol(f"k{n}") for n in (1, 2, 3))
    def run():
        scene = gs.assemble(gs.Gyrostat(given[:3], given[3:]), gs.general_potential(U))
        report = gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))
        return report.necessary, report.sufficient
    return run


def grid(points: int, backend: str) -> Callable[[], object]:
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    n = math.isqrt(points)
    axis, out = np.linspace(-4, 4, n), np.empty((n, n), np.int8)
    return partial(gs.charts.verdicts, report, backend=backend, I1=1.0, m0=1.0, pi3_0=axis[:, None],
                   l=axis[None, :], out=out)


def batch(lines: int) -> Callable[[], object]:
    asked, answered = Path(FOLDER.name, "asked"), Path(FOLDER.name, "answered")
    spins = numbers(5, 6, lines)
    def run():
        asked.write_text("".join(json.dumps({"equilibrium": "E1", "I1": 1, "l": "1/3", "dU": "0.5",
                                             "pi3_0": f"{float(spin):.6f}"}) + "\n" for spin in spins))
        answered.unlink(missing_ok=True)
        with contextlib.redirect_stderr(io.StringIO()):
            if command(["decide", "--batch", str(asked), "--output", str(answered)]):
                raise SystemExit("a line of the batch is not answered")
    return run


def rotors(count: int) -> Callable[[], object]:
    """All rotations of a free body with rotors about axes of rational length, put together anew."""
    axes = itertools.cycle([(1, 2, 2), (2, -3, 6), (-1, 4, 8), (4, 4, -7), (2, 6, 9), (0, 3, -4)])
    wheels = [gs.Rotor(axis, axial="1/100", momentum=x / 4) for x, axis in zip(numbers(7, 2, count), axes)]
    def run():
        spacecraft = gs.gyrostat_with_rotors((1, Rational(5, 4), Rational(3, 2)), wheels, lumped=True)
        return all_of(gs.assemble(spacecraft), {"M": 1})()
    return run


PANELS: dict[str, list[Curve]] = {
    "degree of U": [("derivation of E1, E2, E3", (2, 4, 8, 16, 32), derivation),
                    ("all equilibria at a rate", (2, 4, 8, 16, 32), tilts)],
    "digits of a number": [("all attitudes of a satellite", (2, 4, 8, 16, 32), satellite),
                           ("all rotations at given C1", (2, 4, 8, 16, 32), given_level),
                           ("a verdict of E1", (2, 4, 8, 16, 32, 64, 128), verdict)],
    "names of moments and rotor": [("criteria, rotation in any direction", range(1, 7), rotation)],
    "points of a grid": [("verdicts of E1, Numba", (10**4, 10**5, 10**6, 10**7, 10**8),
                          partial(grid, backend="numba")),
                         ("verdicts of E1, NumPy", (10**4, 10**5, 10**6, 10**7, 10**8),
                          partial(grid, backend="numpy"))],
    "lines of a batch": [("decide --batch", (10, 100, 1000, 4000), batch)],
    "rotors": [("all rotations of a free body", (1, 2, 4, 8, 16), rotors)],
}


def measured(curve: Curve, few: int | None) -> list[tuple[int, float]]:
    """The sizes, and seconds of each."""
    _, sizes, made = curve
    found = []
    for size in list(sizes)[:few]:
        found.append((size, statistics.median(in_turn([made(size)], 1 if few else 9)[0])))
    return found


def exponent(points: list[tuple[int, float]]) -> float:
    (a, s), (b, t) = points[-2:]
    return math.log(t / s) / math.log(b / a)


def shown(value: float) -> str:
    """Seconds with their unit."""
    for unit, scale in (("s", 1), ("ms", 1e3)):
        if value * scale >= 1:
            return f"{value * scale:.3g} {unit}"
    return f"{value * 1e6:.3g} µs"


def draw(panels: dict[str, dict[str, list[tuple[int, float]]]]) -> None:
    """A panel for what grows, on logarithmic axes; a grey line through the first point is linear."""
    figure = Figure(figsize=(10, 6.6), layout="constrained")
    for axes, (grows, curves) in zip(figure.subplots(2, 3).flat, panels.items()):
        for marker, (name, points) in zip("os^", curves.items()):
            sizes, times = zip(*points)
            axes.loglog(sizes, [1e3 * t for t in times], marker=marker, label=name)
            axes.loglog(sizes, [1e3 * times[0] * n / sizes[0] for n in sizes], color="0.75", zorder=0)
        if max(sizes) < 1000:
            axes.set_xticks(sizes, map(str, sizes))
            axes.set_xticks([], minor=True)
        axes.set(xlabel=grows, ylabel="CPU time, ms")
        axes.legend(fontsize="small", loc="lower left", bbox_to_anchor=(0, 1), frameon=False)
    figure.savefig(PICTURE, dpi=130)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    few = 2 if parser.parse_args().quick else None
    print(f"{here_and_now('sympy', 'python-flint', 'numpy', 'numba')}; CPU time of one call, the median "
          "of nine.\n\n| what grows | what it costs | sizes | times | exponent at the end |")
    print("|---" * 5 + "|")
    panels = {}
    for grows, curves in PANELS.items():
        panels[grows] = {curve[0]: measured(curve, few) for curve in curves}
        for name, points in panels[grows].items():
            sizes, times = zip(*points)
            print(f"| {grows} | {name} | {', '.join(map(str, sizes))} | {', '.join(map(shown, times))} | "
                  f"{exponent(points):.1f} |", flush=True)
    if not few:
        draw(panels)


if __name__ == "__main__":
    main()
