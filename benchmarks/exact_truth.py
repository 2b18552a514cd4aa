"""What is true of the floats of a point: margins and coefficients of the reduced motion in whole numbers.

The package gyrostat is not used.

The numbers of a point are the dyadic rationals that its floats are. A margin is a sum a + b that vanishes on
the boundary:

    E1, E2    P² − 4 s I1 U'
    E3        p = I1 (1 − k3²) U'' − 2 I1 k3 U' + I1² ω² + ((I1 − I3) ω k3 − l)², U' = ω l − ω² k3 (I1 − I3)

with b the part that has U' at E1 and E2, U'' at E3. The relative distance to the boundary is abs(a + b) /
max(abs(a), abs(b)), its rounding the only one. Where the margin is 0, the first coefficient of the reduced
motion that does not vanish decides. In U = b exp(50 k3) the sign is that of an enclosure with 480 digits,
which has to leave out 0.
"""
from collections.abc import Iterator
from math import perm

import numpy as np
from flint import arb, ctx

SIDE = {"E1": 1, "E2": -1}
STEEP, BITS = 50, 1600
JETS = ("dU", "d2U", "d3U", "d4U")


class Dyadic:
    """An array of numbers n 2ᵉ, every n whole and one e for all: sums and products are exact."""

    __slots__ = ("whole", "power")

    def __init__(self, whole, power: int):
        self.whole, self.power = whole, power

    @classmethod
    def of(cls, floats) -> "Dyadic":
        fraction, power = np.frexp(np.atleast_1d(np.asarray(floats, dtype=np.float64)))
        low = int(power.min(initial=0))
        return cls((fraction * 2.0**53).astype(np.int64).astype(object) << (power - low).astype(object),
                   low - 53)

    def aligned(self, other):
        """Whole parts at one power, and the power."""
        other = other if isinstance(other, Dyadic) else Dyadic(other, 0)
        low = min(self.power, other.power)
        return self.whole << (self.power - low), other.whole << (other.power - low), low

    def __add__(self, other):
        a, b, low = self.aligned(other)
        return Dyadic(a + b, low)

    def __mul__(self, other):
        if isinstance(other, Dyadic):
            return Dyadic(self.whole * other.whole, self.power + other.power)
        return Dyadic(self.whole * other, self.power)

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return self * -1 + other

    __radd__, __rmul__ = __add__, __mul__

    def sign(self):
        return (self.whole > 0).astype(np.int8) - (self.whole < 0).astype(np.int8)


def jets(scene: str, v: dict, z, order: int = 2) -> list:
    """U', U'', … at k3 = z in any arithmetic; v["E"] is exp(50 z)."""
    if scene == "unspecified":
        return [v[name] for name in JETS[:order] if name in v]
    if scene == "exponential":
        return [STEEP**m * v["b"] * v["E"] for m in range(1, order + 1)]
    degree, found = sum(name[0] == "a" for name in v), []
    for m in range(1, order + 1):
        value = 0 * v["a1"]
        for n in range(degree, m - 1, -1):
            value = value * z + perm(n, m) * v[f"a{n}"]
        found.append(value)
    return found


def momentum(v: dict):
    """P = π3 + l."""
    return (v["pi3_0"] if "pi3_0" in v else v["I3"] * v["omega3_0"]) + v["l"]


def slope_at_tilt(v: dict):
    """U' on E3 by its relation."""
    return v["omega"] * (v["l"] - v["omega"] * v["k3"] * (v["I1"] - v["I3"]))


def sides(kind: str, scene: str, v: dict) -> tuple:
    """a and b, the margin being a + b, in any arithmetic; times ω² at E3 in a given field."""
    I1 = v["I1"]
    if kind != "E3":
        P, s = momentum(v), SIDE[kind]
        return P * P, -4 * s * I1 * jets(scene, v, s, 1)[0]
    w, z = v["omega"], v["k3"]
    if scene == "unspecified":
        across = (I1 - v["I3"]) * w * z - v["l"]
        return I1 * I1 * w * w - 2 * I1 * z * slope_at_tilt(v) + across * across, I1 * (1 - z * z) * v["d2U"]
    slope, bend = jets(scene, v, z)
    return w * w * (I1 * I1 * w * w - 2 * I1 * z * slope) + slope * slope, w * w * I1 * (1 - z * z) * bend


def coefficients(kind: str, scene: str, v: dict) -> Iterator[tuple]:
    """What decides on the boundary, in order.

    Whether k3 escapes whatever the sign, and a number that is negative where it is held.
    """
    highest = 4 if scene == "unspecified" else 2 + sum(name[0] == "a" for name in v)
    z = v["k3"] if kind == "E3" else SIDE[kind]
    derivatives = jets(scene, v, z, highest)
    if kind == "E3" and scene == "unspecified":
        derivatives = [slope_at_tilt(v), *derivatives]
    U = [None, *derivatives]
    if kind == "E3":
        for n in range(3, len(U)):
            yield n % 2 == 1, 2 * n * z * U[n - 1] + n * (n - 1) * U[n - 2] - (1 - z * z) * U[n]
    else:
        for n in range(1, len(U) - 1):
            yield (
                False,
                (-1) ** n * (2 * U[n + 1] + (n + 1) * U[n])
                if kind == "E1"
                else (n + 1) * U[n] - 2 * U[n + 1],
            )


def truth(kind: str, scene: str, values: dict) -> tuple[np.ndarray, np.ndarray]:
    """Verdicts, 1 or -1, and relative distances to the boundary, at columns of float64."""
    columns = dict(zip(values, np.broadcast_arrays(*map(np.atleast_1d, values.values()))))
    if scene == "exponential":
        return _enclosed(kind, columns)
    numbers = {name: Dyadic.of(x) for name, x in columns.items()}
    a, b, _ = Dyadic.aligned(*sides(kind, scene, numbers))
    verdicts = Dyadic(a + b, 0).sign()
    largest = np.maximum(abs(a), abs(b))
    distance = (abs(a + b) / np.where(largest == 0, 1, largest)).astype(np.float64)
    on = np.flatnonzero(verdicts == 0)
    if len(on):
        verdicts[on] = _on_boundary(kind, scene, {name: Dyadic.of(x[on]) for name, x in columns.items()})
    return verdicts, distance


def _on_boundary(kind, scene, numbers):
    verdicts = np.zeros(len(numbers["I1"].whole), dtype=np.int8)
    for escapes, coefficient in coefficients(kind, scene, numbers):
        sign = coefficient.sign()
        verdicts = np.where(verdicts == 0, -abs(sign) if escapes else -sign, verdicts)
    if scene == "unspecified" and not verdicts.all():
        raise ValueError("a point on the boundary needs derivatives of U of higher order")
    return np.where(verdicts == 0, np.int8(-1), verdicts)      # all vanish: every k3 nearby is a motion


def _enclosed(kind, columns):
    verdicts, distance = [], []
    with ctx.workprec(BITS):
        for row in zip(*columns.values()):
            v = dict(zip(columns, map(arb, map(float, row))))
            v["E"] = (STEEP * v["k3"] if kind == "E3" else arb(STEEP * SIDE[kind])).exp()
            a, b = sides(kind, "exponential", v)
            margin = a + b
            assert margin > 0 or margin < 0, "480 digits do not give the sign"
            verdicts.append(1 if margin > 0 else -1)
            distance.append(float((abs(margin) / abs(a).max(abs(b))).mid()))
    return np.array(verdicts, dtype=np.int8), np.array(distance)
