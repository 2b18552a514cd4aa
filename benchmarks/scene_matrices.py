"""The linearised field at E1, E2 and E3 as 4×4 and 6×6 matrices, in any arithmetic; gyrostat is not used."""
from collections.abc import Callable, Iterator
from functools import lru_cache

import numpy as np
from exact_truth import SIDE, STEEP, jets, momentum, slope_at_tilt
from hard_cases import Batch


def euler_poisson(kind: str, scene: str, v: dict, across) -> tuple[list[list], tuple]:
    """Jacobian of π̇ = (π + l) × ω + k × ∇U, k̇ = k × ω at k = (across, 0, k3), in any arithmetic.

    And the point (π1, P, k1, k3).
    """
    I1, I3 = v["I1"], v["I3"]
    if kind == "E3":
        w, z = v["omega"], v["k3"]
        slope, bend = (slope_at_tilt(v), v["d2U"]) if scene == "unspecified" else jets(scene, v, z)
        l = v["l"] if scene == "unspecified" else slope / w + w * z * (I1 - I3)
        P, rate, turn = I3 * w * z + l, w * z, w * across
    else:
        z, turn, bend = SIDE[kind], 0, 0
        slope, P = jets(scene, v, z, 1)[0], momentum(v)
        rate = v["omega3_0"] if "omega3_0" in v else v["pi3_0"] / I3
    spin = P / I1 - rate
    rows = [[0, -spin, 0, 0, slope, 0], [spin, 0, turn * (1 - I1 / I3), -slope, 0, -across * bend], [0] * 6,
            [0, -(z / I1), 0, 0, rate, 0], [z / I1, 0, -(across / I3), -rate, 0, turn],
            [0, across / I1, 0, 0, -turn, 0]]
    return rows, (I1 * turn, P, across, z)


def restricted(kind: str, scene: str, v: dict, across) -> list[list]:
    """The same on the tangent space {δπ·k + (π + l)·δk = 0, k·δk = 0}: L J N with L N = 1.

    E1, E2: on (δπ1, δπ2, δk1, δk2). E3: δk = τ e + κ e2, δπ = α e + β k + γ e2 with e = (k3, 0, -k1), β = -τ
    (π + l)·e, as (α, γ, τ, κ).
    """
    rows, (p, P, x, z) = euler_poisson(kind, scene, v, across)
    if kind != "E3":
        return [[rows[i][j] for j in (0, 1, 3, 4)] for i in (0, 1, 3, 4)]
    lean = p * z - P * x
    basis = [[z, 0, -(lean * x), 0], [0, 1, 0, 0], [-x, 0, -(lean * z), 0], [0, 0, z, 0], [0, 0, 0, 1],
             [0, 0, -x, 0]]
    left = [[z, 0, -x, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, z, 0, -x], [0, 0, 0, 0, 1, 0]]
    return product(left, product(rows, basis))


def product(a: list[list], b: list[list]) -> list[list]:
    """Matrix product that leaves out the zeros that are there by form."""
    def zero(x):
        return isinstance(x, int) and x == 0
    return [[sum(a[i][k] * b[k][j] for k in range(len(b)) if not zero(a[i][k]) and not zero(b[k][j]))
             for j in range(len(b[0]))]
            for i in range(len(a))]


def floats(batch: Batch) -> dict:
    """The columns, and exp(50 k3) where it is needed."""
    v = {**batch.values}
    if batch.field == "exponential":
        v["E"] = np.exp(STEEP * (v["k3"] if batch.kind == "E3"
                                 else np.full(len(batch.truth), SIDE[batch.kind])))
    return v


def scalars(batch: Batch, number: Callable, exp: Callable) -> Iterator[dict]:
    """Point by point in another arithmetic."""
    for row in zip(*(column.tolist() for column in batch.values.values())):
        v = dict(zip(batch.values, map(number, row)))
        if batch.field == "exponential":
            v["E"] = exp(STEEP * (v["k3"] if batch.kind == "E3" else number(SIDE[batch.kind])))
        yield v


@lru_cache(maxsize=4)
def matrices(batch: Batch, size: int) -> np.ndarray:
    """All matrices of a batch in float64, shape (n, size, size)."""
    v = floats(batch)
    with np.errstate(all="ignore"):
        across = np.sqrt((1 - v["k3"]) * (1 + v["k3"])) if batch.kind == "E3" else 0
        rows = (
            restricted(batch.kind, batch.field, v, across)
            if size == 4
            else euler_poisson(batch.kind, batch.field, v, across)[0]
        )
    return np.stack([np.stack([np.broadcast_to(x, len(batch.truth)) for x in row], -1) for row in rows],
                    -2).astype(np.float64)


def assembled(batch: Batch, number: Callable, exp: Callable, root: Callable) -> Iterator[list[list]]:
    """4×4 matrices in another arithmetic, from the parameters on."""
    for v in scalars(batch, number, exp):
        across = root((1 - v["k3"]) * (1 + v["k3"])) if batch.kind == "E3" else number(0)
        yield [[number(x) if isinstance(x, int) else x for x in row]
               for row in restricted(batch.kind, batch.field, v, across)]
