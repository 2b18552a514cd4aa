"""Pictures of charts, read back from what Matplotlib holds and recomputed from Newton's equations.

Regions, curves, legends.
"""
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from sympy import Rational, cos, diff, exp, lambdify, log, sin, sqrt, symbols

import gyrostat as gs
from gyrostat.charts.chart import stability_chart
from gyrostat.plotting import draw_chart

# The truth, without the library: z = k3, D = 1 − z², P = π3 + l, V(z) = U + (L − P z)²/(2 I1 D), stable where
# V'' > 0.
Z, A, B = symbols("z a b")
FIELDS = [*(sum(((-1)**n * Rational(1, n) * (A if n == degree else B if n == 1 else 1)) * Z**n
                for n in range(1, degree + 1))
            for degree in range(1, 8)),
          A / (Z + 2) + B * Z, (A * Z + B) / (Z**2 + 2), A * Z**2 / (3 - Z)**2 + B * Z,
          A * exp(Z / 2) + B * Z, A * log(Z + 3) + B * Z**2,
          A * sin(3 * Z) + B * cos(Z), A * sqrt(Z + 2) - B * Z**3]
SLOPES = [lambdify((Z, A, B), diff(field, Z), "numpy") for field in FIELDS]
# of a and b in U'
SHARES = [{s.name: lambdify(Z, diff(field, Z, s), "numpy") for s in (A, B)} for field in FIELDS]
BENDS = [lambdify((Z, A, B), diff(field, Z, 2), "numpy") for field in FIELDS]
FAMILIES = {"E1": gs.upright, "E2": gs.hanging, "E3": gs.inclined}
COLOURS = {"#dce9f4": 1, "#f4dfb6": 0, "#47566b": -1, "#ffffff": -2}
# of the sizes that enter a margin: some thousand roundings, and of functions
NEAR = 1e-9


def upright(side, number, v):
    """Margin of a body that spins about the vertical axis k3 = ±1, and the size of its terms."""
    momentum = v.get("pi3_0", v["I3"] * v.get("omega3_0", 0)) + v["l"]
    slope = v["dU"] if number is None else SLOPES[number](float(side), v["a"], v["b"])
    return momentum**2 - side * 4 * v["I1"] * slope, momentum**2 + abs(4 * v["I1"] * slope), True


def inclined(eliminated, number, v):
    """The same of a steady precession at a tilt, and whether there is one."""
    z, omega, I1 = v["k3"], v["omega"], v["I1"]
    momentum = v["l"] + v["I3"] * omega * z
    if number is None:
        bend = v["d2U"]
    else:
        a, b, wanted = v["a"], v["b"], omega * (momentum - I1 * omega * z)         # U' is what it must be
        if eliminated == "a":
            a = (wanted - SLOPES[number](z, 0.0, b)) / SHARES[number]["a"](z)
        if eliminated == "b":
            b = (wanted - SLOPES[number](z, a, 0.0)) / SHARES[number]["b"](z)
        if eliminated == "l":
            momentum = SLOPES[number](z, a, b) / omega + I1 * omega * z
        bend = BENDS[number](z, a, b)
    squared, rest = (momentum - 2 * I1 * omega * z)**2, I1 * (1 - z**2)
    size = (abs(momentum) + abs(2 * I1 * omega * z))**2 + abs(rest) * (abs(bend) + I1 * omega**2)
    return squared + rest * (bend + I1 * omega**2), size, abs(z) < 1


def free(v):
    """The same of a free gyrostat that turns about its third axis.

    Ṁ1 = (ω − M3/I2) M2, Ṁ2 = −(ω − M3/I1) M1.
    """
    momentum = v["I3"] * v["omega3_0"] + v["l"]
    one, two = (momentum - v[name] * v["omega3_0"] for name in ("I1", "I2"))
    # without momentum there is no rotation, and its sign is left open
    one = np.where(abs(momentum) > 1e-12, one, 0)
    return one * two, (abs(momentum) + abs(v["I1"]
                                           * v["omega3_0"])) * (abs(momentum)
                                                                + abs(v["I2"] * v["omega3_0"])), True


def scene(kind, number, spin, eliminate):
    """A report, and the truth of it."""
    if kind == "free":
        return gs.analyze(
            gs.principal_rotation(
                gs.assemble(gs.Gyrostat(tuple(map(gs.symbol, ("I1", "I2", "I3"))), (0, 0, gs.symbol("l")))), 3
            )
        ), free
    field = gs.axial_potential() if number is None else gs.axial_potential(
        lambda k3: FIELDS[number].subs({Z: k3, A: gs.symbol("a"), B: gs.symbol("b")}))
    system = gs.assemble(gs.symmetric_gyrostat(), field)
    if kind == "E3":
        report = gs.analyze(gs.inclined(system, eliminate=eliminate if number is not None else None))
        return report, lambda v: inclined(report.equilibrium.eliminated[0], number, v)
    return gs.analyze(FAMILIES[kind](system,
                                     spin=spin)), lambda v: upright(1 if kind == "E1" else -1, number, v)


quarters = st.integers(-12, 12).map(lambda n: Fraction(n, 4))
positive = st.integers(1, 12).map(lambda n: Fraction(n, 4))


@st.composite
def charts(draw):
    """A report with two of its parameters on axes of either direction and any spacing, numbers for the
    others, and the truth.
    """
    kind = draw(st.sampled_from(["E1", "E2", "E3", "E3", "E3", "free"]))
    number = draw(st.sampled_from([None, *range(len(FIELDS))]))
    free_names = [] if number is None else sorted(s.name for s in FIELDS[number].free_symbols - {Z})
    report, truth = scene(kind, number, draw(st.sampled_from(["pi3_0", "omega3_0"])),
                          draw(st.sampled_from(["l", *free_names])))
    names = list(report.required)
    x, y = draw(st.permutations(names))[:2] if len(names) > 1 else (None, None)
    axes = {}
    for name in (x, y):
        span = draw(st.sampled_from([1.0, 2.0, 0.375]))
        low = {"k3": -1.25 * span / 2}.get(name, 1 / 16 if gs.symbol(name).is_positive
                                           else draw(st.sampled_from([-span, -0.3, 1 / 32])))
        values = low + 2 * span * np.linspace(0, 1,
                                              draw(st.integers(4, 33)))**draw(st.sampled_from([1, 1, 2]))
        axes[name] = values[::-1] if draw(st.booleans()) else values
    fixed = {}
    for name in names:
        if name not in axes:
            fixed[name] = draw(positive if gs.symbol(name).is_positive
                               else quarters.filter(lambda n: abs(n) < 1) if name == "k3" else
                               quarters.filter(bool) if name in ("omega", "a", "b") else quarters)
    return report, truth, (x, axes[x]), (y, axes[y]), fixed


def cells(ax):
    """Colours of the cells as verdicts, and their ends along x and y."""
    (image,) = ax.images
    data = np.ma.getdata(image.get_array())
    codes = np.vectorize(lambda value: COLOURS[to_hex(image.cmap(image.norm(value)))], otypes=[int])(data)
    x, y = image.edges                                     # that pixels lie between them is tested with cells
    left, right, bottom, top = image.get_extent()
    assert (left, right, bottom, top) == (x[0], x[-1], y[0], y[-1])
    return codes, x, y


def check(case):
    """Every claim of a picture."""
    report, truth, (x, xs), (y, ys), fixed = case
    chart = stability_chart(report, x=(x, xs), y=(y, ys), fixed=fixed)
    ax = draw_chart(chart, Figure().subplots())
    defaults = {"I1": 1.0, "I3": 1.0, "l": 0.0, "a": 0.0, "b": 0.0,
                **{name: float(value) for name, value in fixed.items()}}

    def at(across, up):
        """Sign of the margin, 0 where doubles cannot tell; −2 where there is no equilibrium."""
        with np.errstate(all="ignore"):
            margin, size, exists = truth({**defaults, x: across, y: up})
            signs = np.where(abs(margin) > NEAR * size, np.sign(margin), 0)
            return np.where(exists & np.isfinite(margin), signs, -2)

    codes, here, there = cells(ax)
    xs, ys = np.sort(xs), np.sort(ys)
    assert codes.shape == (len(ys), len(xs)) and [
        text.split(" $[")[0] for text in (ax.get_xlabel(), ax.get_ylabel())] == [
        f"${chart[name].attrs['latex']}$" for name in (x, y)]
    for values, ends in ((xs, here), (ys, there)):     # cells end half-way between their points
        assert np.allclose(ends[1:-1], (values[1:] + values[:-1]) / 2, rtol=0, atol=1e-9)
        assert ends[0] < values[0] and values[-1] < ends[-1]
    expected = at(xs[None, :], ys[:, None])
    known = expected != 0
    assert (codes == expected)[known].all(), (x, y, fixed)
    lines = [line for line in ax.lines if line.get_color() == "black"]
    points = np.concatenate([line.get_xydata() for line in lines]) if lines else np.empty((0, 2))
    on_curves(points, at, xs, ys)
    complete(points, expected, xs, ys)
    names = [text.get_text().split(" modulo")[0] for text in ax.get_legend().get_texts()]
    shown = {1: "stable", 0: "undecided", -1: "unstable", -2: "no equilibrium"}
    assert set(names) - {"boundary"} == {shown[code] for code in np.unique(codes)}
    assert ("boundary" in names) == bool(len(points))
    assert all(("modulo the spin" in text.get_text()) == (report.equilibrium.label == "E3")
               for text in ax.get_legend().get_texts()
               if text.get_text().startswith("stable"))


def on_curves(points, at, xs, ys):
    """Each vertex lies on a line of the grid, between two verdicts; each segment in one cell."""
    for a, b in points[~np.isnan(points[:, 0])]:
        assert a in xs or b in ys
        steps = (
            [(a * (1 + h) + h * (a == 0), b) for h in (-1e-7, 1e-7)],
            [(a, b * (1 + h) + h * (b == 0)) for h in (-1e-7, 1e-7)],
        )
        seen = [{int(at(*p)) for p in pair} for pair in steps]
        assert any(0 in s or len(s) > 1 for s in (s | {int(at(a, b))} for s in seen)), (a, b)
    for (a, b), (c, d) in zip(points, points[1:]):
        if not np.isnan([a, c]).any():
            for values, low, high in ((xs, *sorted((a, c))), (ys, *sorted((b, d)))):
                assert np.searchsorted(values, high, "left") - np.searchsorted(values, low, "right") <= 0, (
                    a,
                    b,
                    c,
                    d,
                )


def complete(points, expected, xs, ys):
    """Each edge of the grid between stable, unstable and no equilibrium has a vertex."""
    for values, others, rows, (along, across) in ((xs, ys, expected, (0, 1)), (ys, xs, expected.T, (1, 0))):
        for other, row in zip(others, rows):
            for j in np.nonzero((row[1:] != row[:-1]) & (row[1:] != 0) & (row[:-1] != 0))[0]:
                on_row = points[points[:, across] == other, along]
                assert ((values[j] <= on_row) & (on_row <= values[j + 1])).any(), (values[j], other)


@pytest.mark.slow
@given(charts())
@settings(max_examples=4)
def test_what_is_drawn_is_so(case):
    """Regions, curves and legends of E1, E2, E3 and free gyrostats, in fields of every kind, whatever is on
    the axes.
    """
    check(case)


@pytest.mark.slow
@given(charts())
def test_what_is_drawn_is_so_many_times(case):
    """The same, more often."""
    check(case)
