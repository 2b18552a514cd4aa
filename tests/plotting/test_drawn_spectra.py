"""Eigenvalues along a parameter as they are drawn: vertices, marks, names, computed without the library."""
import random
import re
from fractions import Fraction
from itertools import pairwise

import numpy as np
import oracle
import pytest
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.text import Text
from mpmath import mp, mpc, mpf, workdps
from slow import sampled
from sympy import cos, exp

import gyrostat as gs
from gyrostat.plotting import draw_eigenvalues

k3, a = gs.symbol("k3"), gs.symbol("a")
# U, and its derivatives of order 1 and 2 at z, a given
FIELDS = [
    (a * k3**3, lambda a, z: (3 * a * z**2, 6 * a * z)),
    (k3**5 / 5 + a * k3, lambda a, z: (z**4 + a, 4 * z**3)),
    (a / (k3 - 2), lambda a, z: (-a / (z - 2) ** 2, 2 * a / (z - 2) ** 3)),
    (a * exp(k3), lambda a, z: (a * mp.exp(z), a * mp.exp(z))),
    (exp(a * k3), lambda a, z: (a * mp.exp(a * z), a**2 * mp.exp(a * z))),
    (a * cos(2 * k3), lambda a, z: (-2 * a * mp.sin(2 * z), -4 * a * mp.cos(2 * z)))]
KINDS = {"x": "Hamiltonian Hopf", "+": "zero eigenvalue", "1": "real pairs meet"}
BODY = {"I1": (1, 16), "I2": (1, 16), "I3": (1, 16)}


def fraction(x):
    return x if isinstance(x, Fraction) else Fraction(str(mp.nstr(x, 40, min_fixed=-99, max_fixed=99)))


def at_pole(s, names):
    """E1 or E2 of any principal moments: the field differenced."""
    def matrix(values, field):
        u1, u2 = map(fraction, field(values["a"], Fraction(s)))
        inertia = oracle.exact([values[n] for n in names])
        point, rotor = oracle.exact([0, 0, values["pi3_0"], 0, 0, s]), oracle.exact([0, 0, values["l"]])
        return oracle.jacobian(lambda x: oracle.field(x, inertia, rotor, oracle.axial_slope(u1, u2, s)),
                               point)
    return matrix


def at_tilt(values, field):
    """E3, with the rotor that it asks for; the unit vector k has k1 to 40 digits."""
    u1, u2 = map(fraction, field(values["a"], values["k3"]))
    I1, I3, w, z = (values[n] for n in ("I1", "I3", "omega", "k3"))
    inertia, k = oracle.exact([I1, I1, I3]), oracle.exact([fraction(mp.sqrt(_real(1 - z * z))), 0, z])
    rotor = oracle.exact([0, 0, (u1 + w**2 * z * (I1 - I3)) / w])
    point = np.concatenate([inertia * k * w, k])
    return oracle.jacobian(lambda x: oracle.field(x, inertia, rotor, oracle.axial_slope(u1, u2, z)), point)


def free(values, _):
    """A free gyrostat that turns about its third axis."""
    inertia, rotor = oracle.exact([values[n] for n in ("I1", "I2", "I3")]), oracle.exact([0, 0, values["l"]])
    point = oracle.exact([0, 0, values["I3"] * values["omega3_0"]])
    return oracle.jacobian(lambda x: oracle.free_field(x, inertia, rotor), point)


def scene_at_random(seed):
    """An equilibrium, its matrix, numbers, the name along the axis, samples in either direction."""
    rng = random.Random(seed)
    kind = rng.choice(["pole", "pole", "asymmetric", "tilt", "tilt", "free"])
    U, field = rng.choice(FIELDS)
    s = rng.choice([1, -1])
    values = {n: Fraction(rng.randint(*ends), 8) for n, ends in BODY.items()} | {
        "l": Fraction(rng.randint(-6, 6), 3), "a": Fraction(rng.randint(-12, 12) or 1, 4)}
    rotor = gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))
    body = rotor if kind == "asymmetric" else gs.symmetric_gyrostat()
    if kind == "free":
        eq, matrix = gs.principal_rotation(gs.assemble(rotor), 3), free
        values = {n: values[n] for n in ("I1", "I2", "I3",
                                         "l")} | {"omega3_0": Fraction(rng.randint(-12, 12) or 3, 4)}
    elif kind == "tilt":
        eq, matrix = gs.inclined(gs.assemble(body, gs.axial_potential(U))), at_tilt
        values = {n: values[n] for n in ("I1", "I3", "a")} | {
            "omega": Fraction(rng.randint(1, 12) * s, 4), "k3": Fraction(rng.randint(-9, 9), 10)}
    else:
        names = ("I1", "I2", "I3") if kind == "asymmetric" else ("I1", "I1", "I3")
        eq, matrix = (gs.upright if s == 1
                      else gs.hanging)(gs.assemble(body, gs.axial_potential(U))), at_pole(s, names)
        values = {n: values[n] for n in (*dict.fromkeys(names), "l",
                                         "a")} | {"pi3_0": Fraction(rng.randint(-12, 12), 4)}
    name = rng.choice(list(values))
    low, high = (
        (Fraction(1, 4), Fraction(3))
        if name in BODY
        else (Fraction(-19, 20), Fraction(19, 20))
        if name == "k3"
        else (sorted((values[name] / 5, values[name] * 3)))
        if name == "omega"
        else (Fraction(-3), Fraction(3))
    )
    samples = np.linspace(float(low), float(high), rng.choice([40, 120]))[::rng.choice([1, -1])]
    return eq, lambda x: coefficients(matrix({**values, name: x}, field)), values, name, samples


def coefficients(matrix):
    """p, q of λ⁴ + p λ² + q, or p of λ² + p: Newton's identities on traces, the odd ones being 0."""
    square = matrix.dot(matrix)
    t2, t4 = np.trace(square), np.trace(square.dot(square))
    return (-t2 / 2, t2 * t2 / 8 - t4 / 4) if len(matrix) == 6 else (-t2 / 2,)


def signature(p, q=None):
    """How many of λ² are positive, or "c" where they are not real: spectral stability is 0."""
    if q is None:
        return int(p < 0)
    if p * p - 4 * q < -CLEAR * p * p:
        return "c"
    return (
        (1 if q < -CLEAR * p * p else 0)
        if p > 0 or q < -CLEAR * p * p
        else 2
        if q > CLEAR * p * p
        else 1
        if p
        else 0
    )


# U is taken to 40 digits: a square that is 0 is less than that
CLEAR = Fraction(1, 10**30)


def branches(p, q, kind):
    """λ as functions that are continuous where no eigenvalues meet."""
    if q is None:
        root = mp.sqrt(mpc(-_real(p)))
        return [root, -root]
    D = mp.sqrt(abs(_real(p * p - 4 * q)))
    if kind == "c":
        root = mp.sqrt((-_real(p) + 1j * D) / 2)
        return [root, -root, root.conjugate(), -root.conjugate()]
    return [t * mp.sqrt(mpc(-_real(p) + s * D) / 2) for s in (1, -1) for t in (1, -1)]


def _real(x):
    return mpf(x.numerator) / x.denominator


def name_of(before, after):
    """What happened between two signatures, and whether stability changed."""
    kind = (
        "zero eigenvalue"
        if "c" not in (before, after)
        else "Hamiltonian Hopf"
        if 0 in (before, after)
        else "real pairs meet"
    )
    return kind, 0 in (before, after)


def located(spectrum, low, high):
    """By halving: where the signature changes, to the last bit of a double."""
    before = signature(*spectrum(low))
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if signature(*spectrum(middle)) == before else (low, middle)
    return (low + high) / 2


@workdps(50)
def check(seed):
    eq, spectrum, values, name, samples = scene_at_random(seed)
    ax = draw_eigenvalues(eq, name, samples, {n: x for n, x in values.items() if n != name},
                          Figure().subplots())
    (curves,) = [c for c in ax.collections if isinstance(c, LineCollection)]
    size = 4 if len(spectrum(Fraction(samples[0]))) == 2 else 2
    drawn = (np.array(curves.get_segments()) @ [1, 1j]).reshape(size, -1, 2)
    along = np.asarray(curves.get_array()).reshape(size, -1)[0]
    nodes = [samples[0]]
    for x in along:
        nodes.append(2 * x - nodes[-1])
    # not in the middle, where eigenvalues may cross and not leave
    inner = [Fraction(0.62 * x + 0.38 * y) for x, y in pairwise(nodes)]
    kinds = [signature(*spectrum(x)) for x in inner]
    expected = [(located(spectrum, *inner[n:n + 2]), *name_of(*kinds[n:n + 2]))
                for n in range(len(inner) - 1) if kinds[n] != kinds[n + 1]]
    marked(ax, spectrum, expected, seed)
    known = np.array([*samples, *(float(x) for x, _, _ in expected)])
    known = np.append(known, [x for x in nodes if np.abs(known - x).min() > 1e-10
                              and meets(*spectrum(Fraction(x)))])
    at = known[np.abs(np.subtract.outer(nodes, known)).argmin(axis=1)]
    np.testing.assert_allclose(at, nodes, rtol=0, atol=1e-10, err_msg=str(seed))
    assert set(samples) <= set(at), seed
    found = [(*spectrum(Fraction(x)), None)[:2] for x in at]
    largest = 1 + np.abs(drawn).max()
    for n in range(len(along)):
        first, last = (np.array([complex(x) for x in branches(*found[m], kinds[n])]) for m in (n, n + 1))
        away = np.maximum(*(np.abs(np.subtract.outer(drawn[:, n, m], ours)) / bound(ours, largest)
                            for m, ours in enumerate((first, last))))
        assert sorted(away.argmin(axis=1)) == list(range(size)) or (away.min(axis=0) < 1).all(), (seed, n)
        assert (away.min(axis=1) < 1).all(), (seed, n, at[n], drawn[:, n], first, last)


def meets(p, q=None):
    """Whether eigenvalues meet there, about."""
    return abs(p) < 1e-12 if q is None else min(abs(p * p - 4 * q), abs(q)) < 1e-12 * (1 + p * p)


def bound(roots, largest):
    """What m eigenvalues that meet move by when the coefficients are rounded."""
    m = (np.abs(np.subtract.outer(roots, roots)) < 1e-2 * largest).sum(axis=1)
    return largest * 1e-12 ** (1 / m)


def marked(ax, spectrum, expected, seed):
    """Each collision has its name, its value and its eigenvalues, and nothing else has any."""
    named = {(h.get_marker(), *h.get_label().split(", "))
             for h in (ax.get_legend().legend_handles if ax.get_legend() else ())}
    claimed = []
    for text in filter(Text.get_text, ax.texts):           # an arrow has no text
        value = text.get_text().split("= ")[1].strip("$")
        x = float(re.sub(r"( \\times )?10\^\{(-?\d+)\}", lambda m: f"{'' if m[1] else 1}e{m[2]}", value))
        shapes = {line.get_marker() for line in ax.lines if text.xy in list(map(tuple, line.get_xydata()))}
        claimed += [(x, kind, said == "stability changes") for shape, kind, said in named if shape in shapes]
    assert len(claimed) == len(expected), (seed, claimed, expected)
    for ours, theirs in zip(sorted(claimed), sorted(expected)):
        assert ours[1:] == theirs[1:] and abs(ours[0] - theirs[0]) < 1e-3 * abs(theirs[0]) + 1e-9, (
            seed, ours, theirs)
    points = [(KINDS[line.get_marker()], complex(*xy)) for line in ax.lines if line.get_marker() in KINDS
              for xy in line.get_xydata()]
    where = []
    for x, kind, _ in expected:
        root = complex(mp.sqrt(mpc(-_real(spectrum(x)[0])) / 2))
        where += [(kind, 0j)] if kind == "zero eigenvalue" else [(kind, root), (kind, -root)]
    assert len(points) == len(where), (seed, points, where)
    for kind, z in where:
        assert min(abs(z - y) for k, y in points if k == kind) < 1e-6 * (1 + abs(z)), (seed, kind, z)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [51])
def test_eigenvalues_that_are_drawn(seed):
    """Random bodies in fields with and without exponentials."""
    check(seed)


@pytest.mark.slow
def test_many(full):
    """The same for many."""
    for seed in range(10, 10 + sampled(60, full, 8)):
        check(seed)
