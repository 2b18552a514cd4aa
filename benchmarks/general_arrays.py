"""How fast and how right are arrays of verdicts of permanent rotations in any direction?

    python benchmarks/general_arrays.py            all of it
    python benchmarks/general_arrays.py --quick    few points, for breakage

A grid of stereographic coordinates is timed in turn with eigvals of as many matrices of four rows, CPU time.
Then points are drawn where a verdict changes, and up to four doubles beside: where s, the determinant of the
amended potential across k, or p² − 4q is 0 along sigma. The verdicts there are compared with fractions, by
the 2 × 2 form and the traces of the linearised field with six rows; gyrostat is not used for these.
"""
import argparse
import random
import statistics
import time
from decimal import Decimal, getcontext
from fractions import Fraction

import numpy as np

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF

getcontext().prec = 60
MOMENTS, ROTOR = (3, 4, 5), (-1, 2, -1)
NAMES = "omega", "sigma", "u1", "u2"


def report():
    """The rotations of an asymmetric gyrostat in a linear field."""
    field = gs.general_potential(lambda *k: sum(gs.symbol(f"c{n}") * x for n, x in enumerate(k, 1)))
    return gs.analyze(gs.permanent_rotation(gs.assemble(gs.Gyrostat(MOMENTS, ROTOR), field),
                                            gs.stereographic()))


def invariants(omega, sigma, u1, u2):
    """t, s, p and q at a point, up to positive factors of t and s, in any arithmetic with division."""
    d = 1 + u1 * u1 + u2 * u2
    k = x, y, z = 2 * u1 / d, 2 * u2 / d, (2 - d) / d
    along = [i * a for i, a in zip(MOMENTS, k)]
    J = sum(a * b for a, b in zip(along, k))
    v = [2 * omega * a + l for a, l in zip(along, ROTOR)]
    K = [[v[i] * v[j] / J - ((omega * omega * MOMENTS[i] + sigma) if i == j else 0) for j in range(3)]
         for i in range(3)]
    trace = sum(K[i][i] - k[i] * sum(K[i][j] * k[j] for j in range(3)) for i in range(3))
    e, f = ((z, 0, -x), (0, z, -y)) if abs(z) * 4 > 1 else ((-y, x, 0), (0, z, -y) if abs(y) * 4 > 1
                                                            else (-z, 0, x))
    ee, ef, ff = (sum(a[i] * K[i][j] * b[j] for i in range(3) for j in range(3))
                  for a, b in ((e, e), (e, f), (f, f)))
    M, W = [omega * a + l for a, l in zip(along, ROTOR)], [omega * a for a in k]
    g = [omega * m + sigma * a for m, a in zip(M, k)]      # the gradient of U at a relative equilibrium

    o = 0 * omega

    def hat(a):
        return [[o, -a[2], a[1]], [a[2], o, -a[0]], [-a[1], a[0], o]]

    minus_W, moment, slope, direction = hat([-a for a in W]), hat(M), hat([-a for a in g]), hat(k)
    field = [[minus_W[i][j] + moment[i][j] / MOMENTS[j] for j in range(3)] + slope[i] for i in range(3)]
    field += [[direction[i][j] / MOMENTS[j] for j in range(3)] + minus_W[i] for i in range(3)]
    square = [[sum(field[i][n] * field[n][j] for n in range(6)) for j in range(6)] for i in range(6)]
    second = sum(square[i][i] for i in range(6))
    fourth = sum(square[i][j] * square[j][i] for i in range(6) for j in range(6))
    p = -second / 2
    return trace, ee * ff - ef * ef, p, (p * p - fourth / 2) / 2


def quadratics(omega, u1, u2):
    """t, s, p and q as quadratics in sigma, exact: coefficients of 1, sigma and sigma²."""
    rows = [invariants(*map(Fraction, (omega, sigma, u1, u2))) for sigma in (-1, 0, 1)]
    return [(at, (above - below) / 2, (above + below) / 2 - at) for below, at, above in zip(*rows)]


def truth(form, sigma):
    """1 if the form is positive, −1 if an eigenvalue has a positive real part, 0 between."""
    x = Fraction(sigma)
    t, s, p, q = (a + x * (b + x * c) for a, b, c in form)
    if t > 0 and s > 0:
        return 1
    return -1 if p < 0 or q < 0 or p * p < 4 * q else 0


def roots(a, b, c):
    """The real zeros of a + b x + c x², rounded to doubles."""
    if c == 0:
        return [float(-a / b)] if b else []
    inside = b * b - 4 * a * c
    if inside < 0:
        return []
    root = Decimal(inside.numerator).sqrt() / Decimal(inside.denominator).sqrt()
    below, above = (Decimal(x.numerator) / Decimal(x.denominator) for x in (-b, 2 * c))
    return [float((below + sign * root) / above) for sign in (1, -1)]


def boundary_points(count, draw):
    """Numbers in doubles on boundaries along sigma and beside them, and what is true there."""
    points, exact = [], []
    while len(points) < count:
        place = [draw.randint(-48, 48) / 2**draw.randint(3, 6) for _ in range(3)]
        form = quadratics(*place)
        _, s, p, q = form
        discriminant = [p[0]**2 - 4 * q[0], 2 * p[0] * p[1] - 4 * q[1], p[1]**2 - 4 * q[2]]
        for root in [*roots(*s), *roots(*discriminant), *roots(*p)]:
            for sigma in [*(root + n * np.spacing(root) for n in range(-4, 5)), round(root * 8) / 8]:
                points.append((place[0], float(sigma), *place[1:]))
                exact.append(truth(form, float(sigma)))
    return np.array(points[:count]), np.array(exact[:count])


def wrong(rotations, count, seed):
    """How many verdicts differ from the truth, by backend, and how often each is true.

    Where the truth is 0, the ladder of theorems decides, slowly: there a share is compared with single
    verdicts.
    """
    points, exact = boundary_points(count, random.Random(seed))
    between, decided = points[exact == 0][:count // 500], exact != 0
    single = [CODE_OF[rotations.verdict(dict(zip(NAMES, point))).verdict] for point in between.tolist()]
    expected, found = np.array([*exact[decided], *single]), {}
    columns = dict(zip(NAMES, np.concatenate([points[decided], between]).T))
    for backend in ("numpy", "numba"):
        verdicts = gs.charts.verdicts(rotations, columns, backend=backend, invalid="mark")
        found[backend] = int((verdicts != expected).sum())
    return found, {int(x): int((exact == x).sum()) for x in (1, -1, 0)}


def timed(rotations, size, repeats):
    """Nanoseconds of CPU a point of a grid, and how many times as long eigvals takes; medians."""
    u, out = np.linspace(-2, 2, size), np.empty((size, size), np.int8)
    matrices, rows = np.random.default_rng(1).normal(size=(5000, 4, 4)), {}
    for backend in ("numba", "numpy"):
        for sigma in (-4.0, -9.0, -30.0):
            given, pairs = {"omega": -1.0, "sigma": sigma, "u1": u[:, None], "u2": u}, []
            for _ in range(repeats + 1):
                begin = time.process_time()
                gs.charts.verdicts(rotations, given, backend=backend, out=out)
                middle = time.process_time()
                np.linalg.eigvals(matrices)
                pairs.append(((middle - begin) / size**2, (time.process_time() - middle) / len(matrices)))
            rows[backend, sigma] = [statistics.median(x)
                                    for x in zip(*((1e9 * a, b / a) for a, b in pairs[1:]))]
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    quick, rotations = parser.parse_args().quick, report()
    print("| grid of stereographic rotations | ns a point | eigvals of 4 × 4 / ours |\n|---|---|---|")
    for (backend, sigma), (nanoseconds, ratio) in timed(rotations, 150 if quick else 1500, 9).items():
        print(f"| {backend}, sigma = {sigma:.0f} | {nanoseconds:.2f} | {ratio:.0f} |")
    count = 400 if quick else 100_000
    found, true = wrong(rotations, count, 7)
    print(f"\n{count} points on boundaries and beside them, {true} by fractions: wrong {found}")
    return int(any(found.values()))


if __name__ == "__main__":
    raise SystemExit(main())
