"""The routes that speed_against_error.py compares.

Each says of the points of a batch 1 stable, -1 unstable, or 0, not known.
"""
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache

import mpmath
import numpy as np
import scipy.linalg
import sympy
from exact_truth import JETS, SIDE, STEEP, coefficients, jets, sides, slope_at_tilt
from flint import acb_mat, arb, ctx, fmpq
from hard_cases import DEGREE, Batch
from scene_matrices import assembled, floats, matrices, scalars

import gyrostat as gs
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.charts.signs.verdict_arrays import verdicts

TOLERANCES = (0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6)
BALLS = (53, 128, 256)


@dataclass(frozen=True)
class Route:
    """One way to a verdict.

    Parameters
    ----------
    name, timed : str
        the second names the work that is timed; routes that differ in a threshold share it
    verdicts : callable
        of a batch: int8 array, or None where the route has no answer for such a field
    most : int
        points of a batch that it gets
    certain : bool
        whether it claims never to be wrong and always to know
    """

    name: str
    timed: str
    verdicts: Callable[[Batch], np.ndarray | None]
    most: int = 10**9
    certain: bool = False


def answers(stable: np.ndarray, known: np.ndarray | bool = True) -> np.ndarray:
    return np.where(known, np.where(stable, 1, -1), 0).astype(np.int8)


@lru_cache(maxsize=4)
def growth(batch: Batch, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Largest real part by NumPy's eigvals, and the norm (largest sum of a row).

    NaN where an entry is not finite.
    """
    A = matrices(batch, size)
    finite = np.isfinite(A).all((1, 2))
    largest = np.full(len(A), np.nan)
    largest[finite] = np.linalg.eigvals(A[finite]).real.max(1)
    return largest, abs(A).sum(2).max(1)


def eigvals(size: int, tolerance: float) -> Callable:
    def route(batch):
        largest, norm = growth(batch, size)
        with np.errstate(all="ignore"):
            return answers(largest <= tolerance * norm, np.isfinite(largest))
    return route


def scipy_loop(batch: Batch, tolerance: float = 1e-10) -> np.ndarray:
    found = []
    for A in matrices(batch, 4):
        finite = np.isfinite(A).all()
        found.append(0 if not finite else 1 if scipy.linalg.eigvals(A).real.max() <= tolerance
                     * abs(A).sum(1).max() else -1)
    return np.array(found, dtype=np.int8)


def mpmath_eig(batch: Batch) -> np.ndarray:
    """50 digits, Re ≤ 1e-20‖A‖."""
    found = []
    with mpmath.workdps(50):
        for A in assembled(batch, mpmath.mpf, mpmath.exp, mpmath.sqrt):
            norm = max(sum(map(abs, row)) for row in A)
            largest = max(e.real for e in mpmath.eig(mpmath.matrix(A), left=False, right=False))
            found.append(1 if largest <= mpmath.mpf(10) ** -20 * norm else -1)
    return np.array(found, dtype=np.int8)


def balls(bits: int) -> Callable:
    """Enclosed eigenvalues: one to the right of the axis is unstable.

    All apart, and each alone near its own mirror image, stable.
    """
    def route(batch):
        with ctx.workprec(bits):
            return np.array([_enclosed(A) for A in assembled(batch, arb, arb.exp, arb.sqrt)], dtype=np.int8)
    return route


def _enclosed(A):
    try:
        spectrum = acb_mat(A).eig(multiple=True)
    except ValueError:
        return 0
    if any(e.real > 0 for e in spectrum):
        return -1
    apart = all(not a.overlaps(b) for i, a in enumerate(spectrum) for b in spectrum[:i])
    return int(apart and all(not (-a.conjugate()).overlaps(b) for i, a in enumerate(spectrum)
                             for j, b in enumerate(spectrum) if i != j))


def invariants(p, q, tilted: bool) -> np.ndarray:
    """p ≥ 0, q ≥ 0, p² − 4q ≥ 0; at E3 p ≥ 0 alone, q being 0."""
    with np.errstate(all="ignore"):
        D = p * p - 4 * q
        return (
            answers(p >= 0, np.isfinite(p))
            if tilted
            else answers((p >= 0) & (q >= 0) & (D >= 0), np.isfinite(D))
        )


def traces(batch: Batch, A: np.ndarray | None = None) -> np.ndarray:
    A = matrices(batch, 4) if A is None else A
    with np.errstate(all="ignore"):
        square = A @ A
        second, fourth = np.trace(square, axis1=1, axis2=2), np.einsum("nij,nji->n", square, square)
        return invariants(-second / 2, second**2 / 8 - fourth / 4, batch.kind == "E3")


@cache
def _expanded(tilted: bool, by_rate: bool):
    I1, I3, l, spin, w, z, U1, U2 = names = sympy.symbols("I1 I3 l spin w z U1 U2")
    if tilted:
        p, q = (
            I1 * (1 - z**2) * U2 - 2 * I1 * z * U1 + I1**2 * w**2 + ((I1 - I3) * w * z - l) ** 2,
            sympy.S.Zero,
        )
    else:                                              # U1 stands for s U'
        momentum = I3 * spin if by_rate else spin
        a, square = momentum / I3 - (momentum + l) / (2 * I1), (momentum + l) ** 2 / (4 * I1**2) - U1 / I1
        p, q = 2 * a**2 + 2 * square, (a**2 - square) ** 2
    return sympy.lambdify(names, [sympy.expand(p), sympy.expand(q)])


def expanded(batch: Batch) -> np.ndarray:
    """Coefficients of the polynomial, multiplied out, as in print."""
    v, n = floats(batch), len(batch.truth)
    with np.errstate(all="ignore"):
        if batch.kind == "E3":
            given = batch.field != "unspecified"
            U1, U2 = jets(batch.field, v, v["k3"]) if given else (slope_at_tilt(v), v["d2U"])
            l = U1 / v["omega"] + v["omega"] * v["k3"] * (v["I1"] - v["I3"]) if given else v["l"]
            p, q = _expanded(True, False)(v["I1"], v["I3"], l, 0.0, v["omega"], v["k3"], U1, U2)
        else:
            slope = SIDE[batch.kind] * jets(batch.field, v, SIDE[batch.kind], 1)[0]
            by_rate = "omega3_0" in v
            p, q = _expanded(False, by_rate)(v["I1"], v["I3"], v["l"], v["omega3_0" if by_rate else "pi3_0"],
                                             0.0, 1.0, slope, 0.0)
    return invariants(np.broadcast_to(p, n), np.broadcast_to(q, n), batch.kind == "E3")


@cache
def report_of(kind: str, scene: str, spin: str = "pi3_0") -> gs.Report:
    k3 = gs.symbol("k3")
    potential = {"unspecified": None, "polynomial": sum(gs.symbol(f"a{n}") * k3**n
                                                        for n in range(1, DEGREE + 1)),
                 "exponential": gs.symbol("b") * sympy.exp(STEEP * k3)}[scene]
    system = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential() if potential is None
                         else gs.axial_potential(potential))
    return gs.analyze(gs.inclined(system) if kind == "E3"
                      else (gs.upright if kind == "E1" else gs.hanging)(system, spin))


def asked(batch: Batch) -> tuple[gs.Report, dict]:
    """The report of a batch, and the columns that it takes."""
    report = report_of(batch.kind, batch.field, "omega3_0" if "omega3_0" in batch.values else "pi3_0")
    names = {*report.parameters, *(JETS if batch.field == "unspecified" else ())}
    return report, {name: x for name, x in batch.values.items() if name in names}


once_compiled = cache(lambda report, backend: compile_margin(report.sufficient.alternatives[0][0],
                                                             backend=backend))


def compiled(backend: str, kind: type = np.float64) -> Callable:
    """The sign of the compiled margin; it says nothing on the boundary."""
    def route(batch):
        report, columns = asked(batch)
        margin = once_compiled(report, backend)
        with np.errstate(all="ignore"):
            columns = {name: columns[name].astype(kind) for name in margin.names}
            bad = ~np.logical_and.reduce([np.isfinite(x) for x in columns.values()])
            value = margin(**{name: np.where(bad, kind(1), x) for name, x in columns.items()})
            return np.where(bad | np.isnan(value), 0, np.sign(value)).astype(np.int8)
    return route


def certified(backend: str) -> Callable:
    def route(batch):
        report, columns = asked(batch)
        return verdicts(report, backend=backend, **columns)
    return route


def one_by_one(batch: Batch) -> np.ndarray:
    """Report.verdict."""
    report, columns = asked(batch)
    value = {"STABLE": 1, "UNSTABLE": -1, "UNDECIDED": 0}
    rows = zip(*(x.tolist() for x in columns.values()))
    return np.array([value[report.verdict(dict(zip(columns, row))).verdict.name] for row in rows],
                    dtype=np.int8)


FORMULAS = {                                           # what one writes by hand, where U is unspecified
    "E1": (("I1", "l", "pi3_0", "dU"), lambda I1, l, spin, slope: (spin + l) ** 2 - 4 * I1 * slope),
    "E2": (("I1", "l", "pi3_0", "dU"), lambda I1, l, spin, slope: (spin + l) ** 2 + 4 * I1 * slope),
    "E3": (("I1", "I3", "l", "omega", "k3", "d2U"), lambda I1, I3, l, w, z, bend:
           (l + (I3 - 2 * I1) * w * z) ** 2 + I1 * (1 - z * z) * (I1 * w * w + bend)),
}


def rationals(number: Callable) -> Callable:
    """The margin in fractions; where it is 0, the coefficients that decide on the boundary."""
    def route(batch):
        if batch.field == "exponential":
            return None
        names, formula = FORMULAS[batch.kind]
        if batch.field == "unspecified" and set(names) <= batch.values.keys():
            rows = zip(*(batch.values[name].tolist() for name in names))
            margins = [formula(*map(number, row)) for row in rows]
        else:
            margins = [sum(sides(batch.kind, batch.field, v)) for v in scalars(batch, number, None)]
        found = np.array([(x > 0) - (x < 0) for x in margins], dtype=np.int8)
        on = np.flatnonzero(found == 0)
        found[on] = [_on_boundary(batch.kind, batch.field, v) for v in scalars(batch.at(on), number, None)]
        return found
    return route


def _on_boundary(kind, scene, v):
    for escapes, coefficient in coefficients(kind, scene, v):
        if coefficient != 0:
            return -1 if escapes or coefficient > 0 else 1
    return -1


def as_fmpq(x):
    return fmpq(*x.as_integer_ratio())


ROUTES = [
    *(Route(f"eigvals {n}×{n}, Re ≤ {t:g}{'‖A‖' if t else ''}", f"eigvals {n}×{n}", eigvals(n, t))
      for n in (4, 6) for t in TOLERANCES),
    Route("SciPy eigvals loop, 1e-10‖A‖", "SciPy loop", scipy_loop, 400),
    Route("mpmath eig, 50 digits, 1e-20‖A‖", "mpmath", mpmath_eig, 40),
    *(Route(f"flint acb_mat eig, {b} bits", f"acb {b}", balls(b), 60) for b in BALLS),
    Route("p, q, p² − 4q from traces", "traces", traces),
    Route("p, q, p² − 4q expanded", "expanded", expanded),
    *(Route(f"compiled margin, float{b}, {name}", f"compiled{b} {name}", compiled(name, kind))
      for b, kind in ((32, np.float32), (64, np.float64)) for name in ("numpy", "numba")),
    *(Route(f"certified arrays, {name}", f"certified {name}", certified(name), certain=True)
      for name in ("numpy", "numba")),
    Route("Report.verdict, exact", "Report.verdict", one_by_one, 100, True),
    Route("exact rationals, flint fmpq", "fmpq", rationals(as_fmpq), 400, True),
    Route("exact rationals, Fraction", "Fraction", rationals(Fraction), 400, True),
]
