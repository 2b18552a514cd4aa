"""What Matplotlib holds of energy-momentum diagrams and of eigenvalues, recomputed without the library."""
import random
from fractions import Fraction

import numpy as np
import oracle
import pytest
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from sympy import Rational, exp

import gyrostat as gs
from gyrostat.plotting import draw_eigenvalues, draw_energy_momentum

k3 = gs.symbol("k3")


def field_at_random(seed):
    """Coefficients of U, a body, p_psi."""
    rng = random.Random(seed)
    U = [Fraction(0), *(Fraction(rng.randint(-12, 12), rng.randint(1, 6)) for _ in range(rng.randint(1, 7)))]
    if not any(U):
        U[1] = Fraction(1)
    body = {"I1": Fraction(rng.randint(2, 16), 8), "I3": Fraction(rng.randint(2, 16), 8), "l": Fraction(rng.randint(-4, 4), 3)}
    return U, body, Fraction(rng.randint(-9, 9), rng.randint(2, 5))


def scene_of(U):
    field = sum(Rational(c.numerator, c.denominator) * k3**n for n, c in enumerate(U))
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(field))


def check_levels(seed):
    """Vertices are double roots of g with the sign of g'' that is drawn; on each line across there are as many as discriminants say."""
    U, body, P = field_at_random(seed)
    ax = draw_energy_momentum(scene_of(U), {**body, "p_psi": P}, ax=Figure().subplots())
    floats, P_f, U_f = {n: float(x) for n, x in body.items()}, float(P), [float(c) for c in U]
    tips = {}
    for line in ax.lines:
        if line.get_marker() != "None":
            continue
        v, h = line.get_xydata().T
        near = np.flatnonzero((np.abs(v) < 30) & (np.abs(h) < 100))
        for n in near[1:-1][::max(1, len(near) // 25)]:
            g = oracle.reduced_motion(floats["I1"], h[n] - (P_f - floats["l"]) ** 2 / (2 * floats["I3"]), v[n], P_f, U_f)
            g = np.array(g, dtype=float)
            z = double_root(g)
            size = np.abs(g).max() + 1
            assert abs(np.polynomial.polynomial.polyval(z, g)) < 1e-6 * size, (seed, v[n], h[n])
        for n in (0, -1):
            tips.setdefault((round(v[n], 9), round(h[n], 9)), set()).add(line.get_linestyle())
    marks = {(round(x, 9), round(y, 9)) for line in ax.lines if line.get_marker() == "D" for x, y in line.get_xydata()}
    assert marks == {tip for tip, styles in tips.items() if len(styles) > 1}, seed
    complete(ax, U_f, floats, P_f, seed)


def double_root(g):
    """The critical point of g in −1 ≤ z ≤ 1 at which it is nearest to 0."""
    critical = np.polynomial.polynomial.polyroots(np.polynomial.polynomial.polyder(g))
    critical = np.clip(critical.real[np.abs(critical.imag) < 1e-3], -1, 1)
    return critical[np.argmin(np.abs(np.polynomial.polynomial.polyval(critical, g)))]


def complete(ax, U, body, P, seed):
    """At random tilts the precessions of both rates, found by hand, lie on a drawn curve."""
    rng = np.random.default_rng(seed)
    drawn = np.concatenate([dense(line.get_xydata()) for line in ax.lines if line.get_marker() == "None"])
    slope = oracle.slope(U)
    for z in rng.uniform(-0.95, 0.95, 12):
        rates = np.roots([body["I1"] * z, -P, oracle.polynomial(slope, z)])
        for W in rates.real[np.abs(rates.imag) < 1e-12]:
            v = body["I1"] * W * (1 - z * z) + P * z
            h = (P - body["l"]) ** 2 / (2 * body["I3"]) + oracle.polynomial(U, z) + body["I1"] * W * W * (1 - z * z) / 2
            away = np.abs((drawn - [v, h]) / (1 + np.abs([v, h]))).max(axis=1).min()
            assert away < 5e-3, (seed, z, W)


def dense(points):
    """Points on the chords."""
    points = points[(np.abs(points) < 1e6).all(axis=1)]
    return np.concatenate([points[:-1] + (points[1:] - points[:-1]) * t for t in np.linspace(0, 1, 8)]) if len(points) > 1 else points


def drawn_spectrum(make, U, names, parameter, samples):
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))
    ax = draw_eigenvalues(make(scene), names, parameter, samples, Figure().subplots())
    (curves,) = [c for c in ax.collections if isinstance(c, LineCollection)]
    return ax, np.array(curves.get_segments()) @ [1, 1j], np.asarray(curves.get_array())


def check_eigenvalues(seed):
    """E1 or E2: each vertex is an eigenvalue of differenced equations of motion, segments are short, marks are double eigenvalues."""
    rng = random.Random(seed)
    s, make = rng.choice([(1, gs.upright), (-1, gs.hanging)])
    a = Fraction(rng.randint(-12, 12) or 1, 4)
    values = {"I1": Fraction(rng.randint(2, 16), 8), "I3": Fraction(rng.randint(2, 16), 8), "l": Fraction(rng.randint(-6, 6), 3),
              "a": a, "pi3_0": Fraction(rng.randint(-12, 12), 4)}
    name = rng.choice(list(values))
    low, high = (Fraction(1, 4), Fraction(3)) if name in ("I1", "I3") else (Fraction(-3), Fraction(3))
    samples = np.linspace(float(low), float(high), 160)[::rng.choice([1, -1])]
    U = rng.choice([gs.symbol("a") * exp(k3), gs.symbol("a") * k3**3, exp(gs.symbol("a") * k3)])
    ax, segments, along = drawn_spectrum(make, U, {n: x for n, x in values.items() if n != name}, name, samples)
    f = {n: float(x) for n, x in values.items()}
    step = abs(samples[1] - samples[0])
    for n in range(0, len(segments), 37):
        ends = along[n] - step / 2, along[n] + step / 2
        best = min(np.abs(theirs(f | {name: x}, U, s) - segments[n][m]).min() for x in ends for m in (0, 1))
        assert best < 0.35, (seed, n)                          # beside a collision the root of the step
        at = theirs(f | {name: along[n]}, U, s)
        assert np.abs(at - segments[n].mean()).min() < 0.35, (seed, n)
    spread = segments[:, 1] - segments[:, 0]
    assert np.abs(spread).max() < 1.2, seed
    stable = [np.abs(theirs(f | {name: x}, U, s).real).max() < 1e-5 for x in sorted(samples)]
    changes = sum(a != b for a, b in zip(stable, stable[1:]))
    named = [t.get_text() for t in ax.get_legend().get_texts()] if ax.get_legend() else []
    claimed = sum(len(t.split("=")[1].split(",")) for t in named if t.startswith("changes"))
    assert claimed >= changes and (claimed - changes) % 2 == 0, (seed, named, changes)


def theirs(values, U, s):
    """Eigenvalues of the Euler-Poisson matrix at E1 or E2, from the closed form of the oracle's field."""
    numbers = {gs.symbol("a"): values["a"]}
    u1 = float(U.diff(k3).subs(k3, s).subs(numbers))
    inertia, rotor = np.array([values["I1"], values["I1"], values["I3"]]), np.array([0, 0, values["l"]])
    x = np.array([0, 0, values["pi3_0"], 0, 0, s])
    J = oracle.jacobian(lambda y: oracle.field(y, inertia, rotor, lambda k: np.array([0, 0, u1])), x, 1.0)
    return np.linalg.eigvals(J.astype(float))


@pytest.mark.parametrize("seed", range(1))
def test_critical_values_that_are_drawn(seed):
    """Random fields."""
    check_levels(seed)


@pytest.mark.parametrize("seed", range(1))
def test_eigenvalues_that_are_drawn(seed):
    """Random bodies, and fields with and without exponentials."""
    check_eigenvalues(seed)


@pytest.mark.slow
def test_many():
    """The same for many."""
    for seed in range(10, 60):
        check_levels(seed)
        check_eigenvalues(seed)


def test_a_tilt_of_every_rate():
    """p_psi = 0 and U'(0) = 0: every rotation at k3 = 0, C1 = I1 W and h = I1 W²/2 + U(0) + l²/(2 I3), is drawn; W² = −U''/I1 is marked."""
    ax = draw_energy_momentum(scene_of([Fraction(0), Fraction(0), Fraction(-1, 2), Fraction(0), Fraction(1)]),
                              {"I1": 1, "I3": 1, "l": 0, "p_psi": 0}, ax=Figure().subplots())
    curves = [line for line in ax.lines if line.get_marker() == "None"]
    found = [line for line in curves if np.allclose(line.get_ydata(), line.get_xdata() ** 2 / 2)]
    assert [line.get_linestyle() for line in found] == ["-", "--", "-"]
    (mark,) = [line for line in ax.lines if line.get_marker() == "D"]
    assert sorted(map(tuple, mark.get_xydata())) == [(-1, 0.5), (1, 0.5)]
