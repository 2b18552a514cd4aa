"""Points in float64 at which verdicts go wrong, by family, with the truth in whole numbers.

The package gyrostat is not used.
"""
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from math import inf, nextafter

import numpy as np
from exact_truth import BITS, JETS, SIDE, STEEP, momentum, sides, truth
from flint import arb, ctx

KINDS, DEGREE = ("E1", "E2", "E3"), 20
EXPONENTS = range(2, 16)
FAMILIES = {"a": "near and on the boundary", "b": "cancelling momenta", "c": "I1 → I3, |k3| → 1",
            "d": "stiff fields",
            "e": "random", "f": "extreme scales"}
# sizes of I1 and I3 and of P, or of ω, as powers of ten
VERTICAL_SCALES = ((0, 150), (0, -150), (150, 0), (-150, 0), (150, 150), (-150, -150), (0, -155), (0, -160),
                   (-10, -160), (-315, -315))
INCLINED_SCALES = ((150, 0), (-150, 0), (0, 150), (0, -150), (75, 75), (-75, -75), (0, -157), (0, -160),
                   (-310, 0), (-318, 0))


@dataclass(frozen=True, eq=False)
class Batch:
    """Points of one equilibrium in one field.

    Parameters
    ----------
    family, label : str
        "a" … "f"; the distance asked for, or the like
    kind : str
        "E1", "E2" or "E3"
    field : str
        "unspecified", "polynomial" (a1, a2, … in values) or "exponential" (b in values)
    values : dict
        columns of float64; at E3 in a given field l follows from the relation and is left out
    truth : int8 array
        1 stable, -1 unstable; at E3 modulo the spin
    distance : float64 array
        relative distance to the boundary
    """

    family: str
    label: str
    kind: str
    field: str
    values: dict = field(repr=False)
    truth: np.ndarray = field(repr=False)
    distance: np.ndarray = field(repr=False)

    def first(self, n: int) -> "Batch":
        """The first n points; kinds and sides take turns in every batch."""
        return self.at(slice(n))

    def at(self, where) -> "Batch":
        """The points at some places."""
        return Batch(self.family, self.label, self.kind, self.field,
                     {name: x[where] for name, x in self.values.items()},
                     self.truth[where], self.distance[where])


def _batch(family, label, kind, scene, values):
    return Batch(family, label, kind, scene, values, *truth(kind, scene, values))


def near(kind: str, values: dict, shifts, scene: str = "unspecified") -> dict:
    """The points with U' at E1 and E2, U'' at E3, moved to a relative distance from the boundary and rounded;
    positive shifts are stable.

    A shift of 0 gives one of the two floats next to the boundary. It is dU or d2U that moves, a1 in a
    polynomial (a1 and a2 at E3).
    """
    name = "d2U" if kind == "E3" else "dU" if scene == "unspecified" else "a1"
    values = {**values} if scene == "polynomial" else {**values, name: np.zeros(len(shifts))}
    for i, shift in enumerate(map(float, shifts)):
        v = {n: Fraction(float(x[i])) for n, x in values.items()}
        if kind == "E3" and scene == "polynomial":
            a, b = sides(kind, scene, v)
            change = (-a * (1 - Fraction(shift)) - b) / (v["omega"] ** 2 * v["I1"] * (1 - v["k3"] ** 2))
            values["a2"][i], values["a1"][i] = float(v["a2"] + change / 2), float(v["a1"] - change * v["k3"])
            continue
        a, b = sides(kind, scene, v | {name: Fraction(0)})
        exact = -(a * (1 - Fraction(shift)) + b) / (sides(kind, scene, v | {name: Fraction(1)})[1] - b)
        values[name][i] = float(exact) if shift else _neighbour(exact, i % 2)
    return values


def _neighbour(exact, above):
    below = float(exact)
    below = below if Fraction(below) <= exact else nextafter(below, -inf)
    return nextafter(below, inf) if above else below


def ordinary(kind: str, n: int, rng, momenta: float = 1.0) -> dict:
    """Random points of no special kind."""
    draw = {"I1": rng.uniform(0.5, 2, n), "I3": rng.uniform(0.5, 2, n), "l": momenta * rng.uniform(-4, 4, n)}
    if kind == "E3":
        draw |= {"omega": rng.uniform(0.2, 3, n) * rng.choice([-1, 1], n), "k3": rng.uniform(-0.95, 0.95, n),
                 "d2U": rng.uniform(-12, 3, n)}
    else:
        draw |= {"pi3_0": momenta * rng.uniform(-4, 4, n), "dU": SIDE[kind] * rng.uniform(-1, 6, n),
                 "d2U": rng.uniform(-3, 3, n)}
    return draw | {"d3U": rng.uniform(-3, 3, n), "d4U": rng.uniform(-3, 3, n)}


def shifts(n: int, rng) -> np.ndarray:
    """Distances 10⁻² … 10⁻¹⁵ on both sides, evenly in the logarithm."""
    return 10 ** rng.uniform(-15, -2, n) * np.where(np.arange(n) % 2, 1, -1)


def cases(n: int, seed: int = 20261122) -> Iterator[Batch]:
    """All families, n points a batch."""
    for kind in KINDS:
        rng = np.random.default_rng([seed, KINDS.index(kind)])
        for exponent in EXPONENTS:
            yield _batch("a", f"1e-{exponent:02}", kind, "unspecified",
                         near(kind, ordinary(kind, n, rng),
                              10.0**-exponent * np.where(np.arange(n) % 2, 1, -1)))
        yield _batch("a", "next float", kind, "unspecified", near(kind, ordinary(kind, n, rng), np.zeros(n)))
        yield _batch("a", "boundary", kind, "unspecified", on_boundary(kind, n, rng))
        for label, values in cancelling(kind, n, rng):
            yield _batch("b", label, kind, "unspecified", near(kind, values, shifts(n, rng)))
        yield _batch("c", "limits", kind, "unspecified", near(kind, limits(kind, n, rng), shifts(n, rng)))
        yield _batch("d", f"degree {DEGREE}", kind, "polynomial", near(kind, *stiff(kind, n, rng)))
        yield _batch("d", f"exp({STEEP} k3)", kind, "exponential", steep(kind, max(n // 4, 4), rng))
        yield _batch("e", "random", kind, "unspecified", ordinary(kind, 4 * n, rng))
        yield _batch("f", "scales", kind, "unspecified", near(kind, scaled(kind, n, rng), shifts(n, rng)))


def on_boundary(kind: str, n: int, rng) -> dict:
    """Floats with a margin of exactly 0; in part of them further coefficients vanish."""
    I1, I3, l, q, w = (rng.integers(low, 33, n) / 8 for low in (1, 1, -32, -32, 1))
    second, third, fourth = (rng.integers(-32, 32, n) / 8 + 1 / 16 for _ in range(3))
    case = np.arange(n) % 4
    if kind == "E3":
        z = np.where(case < 2, rng.integers(-15, 16, n) / 16, 0.0)
        across = I1 * (1 - z * z)
        rest = across * q + I1 * w * z
        jets = {"d2U": -across * q * q - I1 * w * w, "d3U": np.where(case == 3, 6 * w * rest, third)}
        last = 8 * z * jets["d3U"] + 12 * jets["d2U"] - (1 - z * z) * fourth
        jets["d4U"] = np.where(last == 0, fourth + 1 / 8, fourth)       # the last coefficient decides
        return {"I1": I1, "I3": I3, "l": rest + (I1 - I3) * w * z, "omega": w, "k3": z, **jets}
    s = SIDE[kind]
    slope = s * I1 * q * q
    bend = np.where(case > 1, -s * slope, second)
    jets = {"dU": slope, "d2U": bend, "d3U": np.where(case == 3, -1.5 * s * bend, third)}
    jets["d4U"] = np.where(s * fourth + 2 * jets["d3U"] == 0, fourth + 1 / 8, fourth)
    return {"I1": I1, "I3": I3, "l": l, "pi3_0": 2 * I1 * q - l, **jets}


def cancelling(kind: str, n: int, rng) -> Iterator[tuple[str, dict]]:
    """Sums of momenta down to 10⁻⁸ of their terms."""
    v, small = ordinary(kind, n, rng), 10 ** rng.uniform(-8, -2, n)
    if kind == "E3":
        yield "l", v | {"l": (2 * v["I1"] - v["I3"]) * v["omega"] * v["k3"] * (1 + small)}
        yield "π3 ≈ −l", v | {"l": -v["I3"] * v["omega"] * v["k3"] * (1 + small)}
        return
    spin = -v["l"] * (1 + small)
    yield "π3 ≈ −l", v | {"pi3_0": spin}
    yield "I3 ω3 ≈ −l", {name: x for name, x in v.items() if name != "pi3_0"} | {"omega3_0": spin / v["I3"]}


def limits(kind: str, n: int, rng) -> dict:
    """I3 down to 10⁻¹⁵ from I1 and, at E3, k3 as near to ±1, one or both."""
    v, case = ordinary(kind, n, rng), np.arange(n) // 2 % 3
    v["I3"] = np.where(case != 1, v["I1"] * (1 + 10 ** rng.uniform(-15, -1, n)), v["I3"])
    if kind == "E3":
        v["k3"] = np.where(case != 0, np.sign(v["k3"]) * (1 - 10 ** rng.uniform(-15, -1, n)), v["k3"])
    return v


def stiff(kind: str, n: int, rng) -> tuple[dict, np.ndarray, str]:
    """Coefficients a1 … a20 of sizes up to 10³."""
    v = {name: x for name, x in ordinary(kind, n, rng).items() if name not in JETS
         and (kind != "E3" or name != "l")}
    v |= {f"a{m}": rng.uniform(-1, 1, n) * 10 ** rng.uniform(0, 3, n) for m in range(1, DEGREE + 1)}
    return v, shifts(n, rng), "polynomial"


def steep(kind: str, n: int, rng) -> dict:
    """U = b exp(50 k3), b next to the boundary.

    At E3 u = U' solves u²/ω² + c I1 u + I1² ω² = 0, c = 50 (1 − k3²) − 2 k3.
    """
    v = {name: x for name, x in ordinary(kind, n, rng).items() if name not in JETS
         and (kind != "E3" or name != "l")}
    v["b"] = np.zeros(n)
    with ctx.workprec(BITS):
        for i, shift in enumerate(map(float, shifts(n, rng))):
            x = {name: arb(float(column[i])) for name, column in v.items()}
            if kind == "E3":
                c = STEEP * (1 - x["k3"] ** 2) - 2 * x["k3"]
                slope, exponent = x["omega"] ** 2 * x["I1"] * ((-1) ** (i // 2) * (c * c - 4).sqrt()
                                                               - c) / 2, STEEP * x["k3"]
            else:
                slope, exponent = SIDE[kind] * momentum(x) ** 2 / (4 * x["I1"]), arb(STEEP * SIDE[kind])
            v["b"][i] = float((slope * (1 - arb(shift)) / (STEEP * exponent.exp())).mid())
    return v


def scaled(kind: str, n: int, rng) -> dict:
    """Units so large or small that squares overflow, underflow, or are subnormal."""
    v = ordinary(kind, n, rng)
    sizes = np.array(INCLINED_SCALES if kind == "E3"
                     else VERTICAL_SCALES)[np.arange(n) // 2 % 10].astype(float)
    inertia, other = (_power(column) for column in sizes.T)
    rate = ("omega", "l") if kind == "E3" else ("pi3_0", "l")
    v |= {name: v[name] * inertia for name in ("I1", "I3")} | {name: v[name] * other for name in rate}
    if kind == "E3":
        v["l"] = v["l"] * inertia
    return v


def _power(exponents):
    return np.array([float(f"1e{int(e)}") for e in exponents])
