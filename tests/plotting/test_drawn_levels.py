"""What Matplotlib holds of energy-momentum diagrams, recomputed without the library.

Every vertex, every verdict, every mark.
"""
import random
from fractions import Fraction

import numpy as np
import pytest
from matplotlib.figure import Figure
from slow import sampled
from sympy import Rational

import gyrostat as gs
from gyrostat.plotting import draw_energy_momentum

k3 = gs.symbol("k3")
STYLES = {"-": True, "--": False}                          # whether stable
# of C1 and h: beyond, doubles have no double root any more
FAR = 1e5


class Scene:
    """U = c1 k3 + … + a/(k3 − b), a body, p_psi; in doubles."""

    def __init__(self, seed):
        rng = random.Random(seed)
        U = [Fraction(0), *(Fraction(rng.randint(-12, 12), rng.randint(1, 6))
                            for _ in range(rng.randint(1, 7)))]
        if not any(U):
            U[1] = Fraction(1)
        pole = rng.choice([None, None, (Fraction(rng.randint(1, 9), 4) * rng.choice([1, -1]),
                                        rng.choice([Fraction(-2), Fraction(3, 2), Fraction(1, 3),
                                                    Fraction(-1, 2)]))])
        body = {"I1": Fraction(rng.randint(2, 16), 8), "I3": Fraction(rng.randint(2, 16), 8),
                "l": Fraction(rng.randint(-4, 4), 3)}
        P = Fraction(rng.randint(-9, 9), rng.randint(2, 5))
        field = sum(Rational(c.numerator, c.denominator) * k3**n for n, c in enumerate(U))
        if pole:
            a, b = (Rational(x.numerator, x.denominator) for x in pole)
            field += a / (k3 - b)
        self.ax = draw_energy_momentum(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(field)),
                                       {**body, "p_psi": P},
                                       ax=Figure().subplots())
        self.U, self.pole, self.P = (
            np.polynomial.Polynomial([float(c) for c in U]),
            pole and tuple(map(float, pole)),
            float(P),
        )
        self.I1, self.rest = float(body["I1"]), float((P - body["l"]) ** 2 / (2 * body["I3"]))
        self.curves = [line for line in self.ax.lines if line.get_marker() == "None"]

    def field(self, z, n=0):
        """The n-th derivative of U."""
        value = self.U.deriv(n)(z) if n else self.U(z)
        return value + self.pole[0] * (1, -1, 2)[n] / (z - self.pole[1]) ** (n + 1) if self.pole else value

    def rates(self, z):
        """The roots W of I1 z W² − P W + U' = 0, the greater first; nan where there is none."""
        with np.errstate(invalid="ignore", divide="ignore"):
            half = (self.P + np.where(self.P < 0, -1, 1)
                    * np.sqrt(self.P**2 - 4 * self.I1 * z * self.field(z, 1))) / 2
            slow = self.field(z, 1) / half if self.P else -half / (self.I1 * z)
            return half / (self.I1 * z), slow

    def level(self, z, W):
        """C1 and h."""
        return self.I1 * W * (1 - z * z) + self.P * z, self.rest + self.field(z) + self.I1 * W * W * (
            1 - z * z
        ) / 2

    def margin(self, z, W):
        """−g''/2 of I1² z'² = g(z) = 2 I1 (h − U)(1 − z²) − (C1 − P z)² at its double root."""
        return (
            self.I1
            * (self.field(z, 2) * (1 - z * z) - 4 * z * self.field(z, 1) + self.I1 * W * W * (1 - z * z))
            + self.P**2
        )

    def double_roots(self, v, h):
        """The z at which g vanishes with its slope, and −g''/2 there."""
        one = np.polynomial.Polynomial([1, 0, -1])
        bottom = np.polynomial.Polynomial([-self.pole[1], 1]) if self.pole else np.polynomial.Polynomial([1])
        height = (h - self.rest - self.U) * bottom - (self.pole[0] if self.pole else 0)
        g = 2 * self.I1 * height * one - np.polynomial.Polynomial([v, -self.P]) ** 2 * bottom
        slope = g.deriv().roots()
        near = slope.real[(np.abs(slope.imag) < 1e-3) & (np.abs(slope.real) < 1)]
        size = np.abs(g.coef).max()
        near = near[np.abs(g(near)) < 1e-7 * size]
        return [(z, -g.deriv(2)(z) / bottom(z) / 2, size / abs(bottom(z))) for z in near]


def check(seed, every):
    scene = Scene(seed)
    vertices(scene, seed, every)
    complete(scene, seed)
    marked(scene, seed)
    poles(scene, seed)


def vertices(scene, seed, every):
    """Each is the level of a double root of g; g'' has the sign that is drawn.

    From one to the next the root moves little.
    """
    for line in scene.curves:
        points, before = line.get_xydata(), None
        for n in range(1, len(points) - 1, every):
            if np.abs(points[n]).max() > FAR:
                before = None
                continue
            found = scene.double_roots(*points[n])
            assert found, (seed, points[n])
            right = [z for z, margin, size in found if (margin > 0) == STYLES[line.get_linestyle()]
                     or abs(margin) < 1e-3 * size]
            assert right, (seed, points[n], found)
            if before is not None:
                assert np.abs(np.subtract.outer(before, right)).min() < 0.02 * every, (seed, points[n])
            before = right


def complete(scene, seed):
    """At random tilts the precessions of both rates lie on a chord of a curve in the style of their verdict.
    """
    rng = np.random.default_rng(seed)
    for z in rng.uniform(-0.97, 0.97, 15):
        for W in scene.rates(z):
            if not np.isfinite(W) or np.abs(scene.level(z, W)).max() > FAR:
                continue
            away = {stable: min((distance(line.get_xydata(), scene.level(z, W)) for line in scene.curves
                                 if STYLES[line.get_linestyle()] == stable), default=np.inf)
                    for stable in (True, False)}
            assert away[bool(scene.margin(z, W) > 0)] < 4e-3, (seed, z, W, away)


def distance(points, point):
    """From the chords, relative to the size of either coordinate."""
    p = (points - point) / (1 + np.abs(point))
    p, step = p[:-1], np.diff(p, axis=0)
    with np.errstate(all="ignore"):
        t = np.clip(np.nan_to_num(-(p * step).sum(axis=1) / (step * step).sum(axis=1)), 0, 1)
    return np.linalg.norm(p + t[:, None] * step, axis=1).min()


def marked(scene, seed):
    """A mark is where g'' changes its sign along a branch of the rates, and nowhere else."""
    points = [tuple(xy) for line in scene.ax.lines if line.get_marker() == "D" for xy in line.get_xydata()]
    texts = [text.get_text() for text in (*scene.ax.texts, *scene.ax.get_legend().get_texts())]
    assert texts.count("fold on a level") == bool(points), seed
    grid = np.cos(np.linspace(0, np.pi, 40003))[1:-1]
    expected = []
    for n in (0, 1):
        W = scene.rates(grid)[n]
        margin = scene.margin(grid, W)
        # the fast one is infinite at 0
        blocked = np.diff(np.sign(grid)) != 0 if n == 0 else np.zeros(len(grid) - 1, dtype=bool)
        if scene.pole:
            blocked |= np.diff(np.sign(grid - scene.pole[1])) != 0
        for m in np.flatnonzero((margin[:-1] * margin[1:] < 0) & ~blocked):
            a, b = grid[m], grid[m + 1]
            for _ in range(60):
                middle = (a + b) / 2
                same = scene.margin(middle, scene.rates(middle)[n]) * scene.margin(a, scene.rates(a)[n]) > 0
                a, b = (middle, b) if same else (a, middle)
            expected.append(scene.level(a, scene.rates(a)[n]))
    assert len(points) == len(expected), (seed, points, expected)
    for point in expected:
        assert (
            min(np.abs(np.subtract(point, other) / (1 + np.abs(point))).max() for other in points) < 1e-5
        ), (seed, point, points)


def poles(scene, seed):
    """E1 and E2 at C1 = ±P, filled where P² > 4 s I1 U'(s), named."""
    expected = {}
    for s in (1, -1):
        if not scene.pole or scene.pole[1] != s:
            margin = scene.P**2 - 4 * s * scene.I1 * scene.field(float(s), 1)
            name = f"E{1 if s == 1 else 2}"
            if abs(margin) > 1e-9:
                expected[name] = (s * scene.P, scene.rest + scene.field(float(s)), margin > 0)
    drawn = [(*line.get_xydata()[0], line.get_markerfacecolor() != "white")
             for line in scene.ax.lines if line.get_marker() == "o"]
    said = [(name.split(", "), text.xy) for text in scene.ax.texts for name in text.get_text().split("; ")]
    named = {names[0]: xy for names, xy in said}
    assert len(drawn) == len(expected), (seed, drawn, expected)
    for name, (v, h, stable) in expected.items():
        assert any(np.allclose((v, h), xy) and full == stable for *xy, full in drawn), (seed, name, drawn)
        np.testing.assert_allclose(named[name], (v, h))
    focus = {names[0] for names, _ in said if names[1:] == ["focus-focus"]}
    assert focus == {name for name, (*_, stable) in expected.items() if not stable}, seed


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1])
def test_critical_values_that_are_drawn(seed):
    """Random fields, with poles of U outside and inside."""
    check(seed, 10)


@pytest.mark.slow
def test_many(full):
    """The same for many."""
    for seed in range(10, 10 + sampled(50, full, 4)):
        check(seed, 2)


@pytest.mark.slow
def test_a_tilt_of_every_rate():
    """p_psi = 0 and U'(0) = 0.

    Every rotation at k3 = 0, C1 = I1 W and h = I1 W²/2 + U(0) + l²/(2 I3), is drawn; W² = −U''/I1 is marked.
    """
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(k3**4 - k3**2 / 2))
    ax = draw_energy_momentum(scene, {"I1": 1, "I3": 1, "l": 0, "p_psi": 0}, ax=Figure().subplots())
    curves = [line for line in ax.lines if line.get_marker() == "None"]
    found = [line for line in curves if np.allclose(line.get_ydata(), line.get_xdata() ** 2 / 2)]
    assert [line.get_linestyle() for line in found] == ["-", "--", "-"]
    (mark,) = [line for line in ax.lines if line.get_marker() == "D"]
    assert sorted(map(tuple, mark.get_xydata())) == [(-1, 0.5), (1, 0.5)]
