"""What Matplotlib holds of a bifurcation diagram, recomputed.

Every vertex, every branch, every mark, without the library.
"""
import random
from fractions import Fraction

import numpy as np
import oracle
import pytest
from matplotlib.figure import Figure
from slow import sampled
from sympy import Rational

import gyrostat as gs
from gyrostat.plotting import draw_bifurcation_diagram
from gyrostat.plotting.bifurcations import SHAPES

AXES = ("omega", "l", "I1", "I3", "c1", "c2")
STABLE = "stable"
CHANGES = {"fold on a level": None, "precessions leave E1": 1,
           "precessions leave E2": -1}
MEETINGS = {"fold at fixed rate", "pitchfork at fixed rate", "crossing at fixed rate"}


def fraction(rng, size=3):
    return Fraction(rng.randint(-size * 6, size * 6), rng.randint(1, 6))


def drawn_at_random(seed):
    """A field of degree 1 to 7, or with a pole, inside or outside; a body.

    A name for the axis and its range.
    """
    rng = random.Random(seed)
    degree = rng.randint(1, 7)
    values = {f"c{n}": fraction(rng) for n in range(1, degree + 1)} | {
        "I1": Fraction(rng.randint(1, 24), 8), "I3": Fraction(rng.randint(1, 24), 8),
        "l": rng.choice([Fraction(0), fraction(rng)]),
        "omega": fraction(rng, 2)}
    pole = rng.choice([None, None, (fraction(rng) / 2,
                                    rng.choice([Fraction(-3), Fraction(2), Fraction(1, 3),
                                                Fraction(-1, 2)]))])
    pole = pole if pole and pole[0] else None
    name = rng.choice([axis for axis in AXES if axis in values])
    low, high = (
        (Fraction(1, 4), Fraction(4))
        if name in ("I1", "I3")
        else (-(fraction(rng) ** 2) - 2, fraction(rng) ** 2 + 1)
    )
    return {n: x for n, x in values.items() if n != name}, pole, name, (low, high)


def scene_of(values, pole, name):
    k3 = gs.symbol("k3")
    names = [n for n in (*values, name) if n[0] == "c"]
    U = sum(gs.symbol(n) * k3 ** int(n[1:]) for n in names)
    if pole:
        U += _fraction(pole[0]) / (k3 - _fraction(pole[1]))
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))


def _fraction(x):
    return Rational(x.numerator, x.denominator)


def derivative(values, pole, k, n):
    """The n-th derivative of U."""
    total = 0 * k
    for name, c in values.items():
        if name[0] == "c":
            power = int(name[1:])
            if power >= n:
                factor = 1
                for m in range(n):
                    factor *= power - m
                total = total + c * factor * k ** (power - n)
    if pole:
        total = total + pole[0] * (-1) ** n * [1, 1, 2, 6][n] / (k - pole[1]) ** (n + 1)
    return total


def relation(values, pole, k):
    """U' − ω l + ω² k3 (I1 − I3)."""
    return (
        derivative(values, pole, k, 1)
        - values["omega"] * values["l"]
        + values["omega"] ** 2 * k * (values["I1"] - values["I3"])
    )


def margin(values, pole, k):
    """p = I1 (1 − k3²) U'' − 2 I1 k3 U' + I1² ω² + ((I1 − I3) ω k3 − l)²."""
    I1, I3, l, w = (values[n] for n in ("I1", "I3", "l", "omega"))
    return (
        I1 * (1 - k * k) * derivative(values, pole, k, 2)
        - 2 * I1 * k * derivative(values, pole, k, 1)
        + I1**2 * w**2
        + ((I1 - I3) * w * k - l) ** 2
    )


def pole_margin(values, pole, s):
    """P² − 4 s I1 U'(s)."""
    return (s * values["I3"] * values["omega"] + values["l"]) ** 2 - 4 * s * values["I1"] * derivative(
        values, pole, Fraction(s), 1
    )


def coefficients(values, pole):
    """The numerator of the relation in k3."""
    degree = max(int(n[1:]) for n in values if n[0] == "c")
    top = [Fraction(0)] * max(degree, 2)
    for n, c in values.items():
        if n[0] == "c":
            top[int(n[1:]) - 1] += int(n[1:]) * c
    top[0] -= values["omega"] * values["l"]
    top[1] += values["omega"] ** 2 * (values["I1"] - values["I3"])
    if not pole:
        return top
    a, b = pole
    square, product = [b * b, -2 * b, Fraction(1)], [Fraction(0)] * (len(top) + 2)
    for i, x in enumerate(top):
        for j, y in enumerate(square):
            product[i + j] += x * y
    product[0] -= a
    return product


def style(line):
    return {"-": "STABLE", "--": "UNSTABLE"}.get(line.get_linestyle(), "UNDECIDED")


def check(seed):
    values, pole, name, ends = drawn_at_random(seed)
    ax = draw_bifurcation_diagram(scene_of(values, pole, name), name, ends, values, Figure().subplots())
    handles = dict(zip((text.get_text() for text in ax.get_legend().get_texts()),
                       ax.get_legend().legend_handles))
    marks = {}
    for line in ax.lines:
        if line.get_marker() != "None":
            label = next(t for t in (*handles, *(text.get_text() for text in ax.texts))
                         if (handles[t].get_marker() if t in handles else SHAPES.get(t)) == line.get_marker())
            marks.setdefault(label, []).extend(map(tuple, line.get_xydata()))
    curves = [line for line in ax.lines if line.get_marker() == "None"]
    poles = {s: [c for c in curves if (c.get_ydata() == s).all()] for s in (1, -1)}
    tilted = [c for c in curves if not any(c is p for side in poles.values() for p in side)]
    floats = {n: float(x) for n, x in values.items()}
    pole_f = pole and tuple(map(float, pole))
    vertices(tilted, floats, pole_f, name, seed)
    complete(tilted, poles, values, pole, name, ends, seed)
    marked(tilted, poles, marks, floats, pole_f, name, ends, seed)
    if any(style(c) == "STABLE" for c in tilted):
        assert "stable (E3: modulo the spin)" in handles
    return ax


def vertices(tilted, values, pole, name, seed):
    """Every vertex is an equilibrium of the drawn verdict; no segment joins two branches."""
    for curve in tilted:
        x, k = curve.get_xydata().T
        assert (np.abs(k) <= 1).all()
        inner = slice(1, -1)
        here = values | {name: x[inner]}
        scale = (
            1
            + np.abs(derivative({n: np.abs(v) for n, v in here.items()}, None, np.abs(k[inner]), 2))
            + here["omega"] ** 2 * 9
            + (np.abs(derivative(here, pole, k[inner], 2)))
        )
        # x is rounded to a double
        assert (np.abs(relation(here, pole, k[inner])) < 1e-9 * scale).all(), seed
        p = margin(here, pole, k[inner])
        sure = np.abs(p) > 1e-7 * (1 + np.abs(p).max()) if len(p) else p
        assert ((p > 0) == (style(curve) == "STABLE"))[sure != 0].all(), seed
        assert np.abs(np.diff(k)).max() < 0.2, seed
        middle, at = (k[1:] + k[:-1]) / 2, values | {name: (x[1:] + x[:-1]) / 2}
        slope = np.abs(relation(at, pole, middle))
        sides = np.abs(relation(at, pole, k[1:]) - relation(at, pole, k[:-1]))
        assert (slope <= sides + 1e-3 * (1 + np.abs(derivative(at, pole, middle, 2)))).all(), seed


def complete(tilted, poles, values, pole, name, ends, seed):
    """On lines across, as many crossings as Sturm's theorem counts.

    E1 and E2 in the style of the sign of P² − 4 s I1 U'.
    """
    rng = random.Random(seed)
    for _ in range(12):
        x = ends[0] + (ends[1] - ends[0]) * Fraction(rng.randint(1, 9999), 10000)
        at = values | {name: x}
        crossings = sum(min(c.get_xdata()) < x < max(c.get_xdata()) for c in tilted)
        assert crossings == oracle.count_roots(coefficients(at, pole), -1, 1), (seed, float(x))
        for s, lines in poles.items():
            (line,) = [c for c in lines if min(c.get_xdata()) <= x <= max(c.get_xdata())]
            assert (style(line) == "STABLE") == (pole_margin(at, pole, s) > 0), (seed, float(x))


def marked(tilted, poles, marks, values, pole, name, ends, seed):
    """Where the style changes there is a mark of the right name; a mark is where what it says vanishes."""
    low, high = map(float, ends)
    tips = {}
    for curve in tilted:
        for n in (0, -1):
            tips.setdefault(tuple(curve.get_xydata()[n]), []).append(style(curve))
    known = {point for points in marks.values() for point in points}
    for (x, k), styles in tips.items():
        if low < x < high:
            assert (x, k) in known or len(styles) == 2, (seed, x, k)
            assert (len(set(styles)) > 1) == ((x,
                                               k) in marks.get("fold on a level", [])), (seed, x, k)
    for s, lines in poles.items():
        inside = {tuple(point) for c in lines for point in c.get_xydata()[[0, -1]] if low < point[0] < high}
        assert inside == {p for p in marks.get(f"precessions leave E{1 if s == 1 else 2}", [])
                          if low < p[0] < high}, seed
    for label, points in marks.items():
        for x, k in points:
            at = values | {name: x}
            size = 1 + max(abs(v) for v in at.values()) ** 3
            if label in CHANGES:
                value = (
                    margin(at, pole, k) if CHANGES[label] is None else pole_margin(at, pole, CHANGES[label])
                )
                assert abs(value) < 1e-6 * size, (seed, label, x, k)
            if label not in ("precessions leave E1", "precessions leave E2",
                             "U is infinite"):
                assert abs(relation(at, pole, k)) < 1e-6 * size, (seed, label, x, k)
            if label in MEETINGS:
                step = 1e-6
                slope = (relation(at, pole, k + step) - relation(at, pole, k - step)) / (2 * step)
                assert abs(slope) < 1e-4 * size, (seed, label, x, k)
            if label.startswith("E3 leaves"):
                assert k == (1 if label.endswith("E1") else -1)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [pytest.param(0, marks=pytest.mark.slow), 1])
def test_what_is_drawn(seed):
    """Random scenes: vertices, completeness, marks."""
    check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("part", range(4))
def test_what_is_drawn_in_many_scenes(part, full):
    """The same for many."""
    for seed in range(100 + 40 * part, 100 + 40 * part + sampled(40, full, 6)):
        check(seed)
