"""Second variations of polynomials on a coadjoint orbit of e(3)*, in fractions; gyrostat is not used."""
from fractions import Fraction

import sympy

X = M1, M2, M3, k1, k2, k3 = sympy.symbols("M1:4 k1:4")
CASIMIRS = M1 * k1 + M2 * k2 + M3 * k3, k1**2 + k2**2 + k3**2


def forms(h, F, point):
    """h and F on the tangent space of the orbit at a point in M, k where both are critical on it."""
    place = dict(zip(X, point))
    basis = sympy.Matrix([[c.diff(x).xreplace(place) for x in X] for c in CASIMIRS]).nullspace()
    return [_restricted(f, place, basis) for f in (h, F)]


def _restricted(f, place, basis):
    slope = sympy.Matrix([f.diff(x).xreplace(place) for x in X])
    of_casimirs = sympy.Matrix([[c.diff(x).xreplace(place) for c in CASIMIRS] for x in X])
    a, b = sympy.symbols("a b")
    (nu,) = sympy.linsolve((of_casimirs, slope), a, b)     # empty where f is not critical
    total = f - nu[0] * CASIMIRS[0] - nu[1] * CASIMIRS[1]
    hessian = sympy.Matrix(6, 6, lambda i, j: total.diff(X[i], X[j]).xreplace(place))
    return [[_fraction((u.T * hessian * v)[0]) for v in basis] for u in basis]


def _fraction(x):
    return Fraction(int(x.p), int(x.q))


def signature(form):
    """Numbers of positive and of negative squares, by Lagrange's reduction."""
    form = [list(row) for row in form]
    plus = minus = 0
    while form:
        n = len(form)
        i = next((i for i in range(n) if form[i][i]), None)
        if i is None:
            pair = next(((r, s) for r in range(n) for s in range(r) if form[r][s]), None)
            if pair is None:
                break
            r, s = pair                                    # x_r + x_s in the place of x_r
            form[r] = [x + y for x, y in zip(form[r], form[s])]
            for row in form:
                row[r] += row[s]
            continue
        pivot = form[i]
        plus, minus = plus + (pivot[i] > 0), minus + (pivot[i] < 0)
        form = [[row[j] - row[i] * pivot[j] / pivot[i] for j in range(n) if j != i]
                for m, row in enumerate(form) if m != i]
    return plus, minus


def combined(h, F, a):
    return [[x + a * y for x, y in zip(*rows)] for rows in zip(h, F)]


def some_definite(h, F):
    """Whether h + a F is definite for some a: one is tried between any two roots of the determinant."""
    det = sympy.Poly(sympy.Matrix(combined(_sympy(h), _sympy(F), sympy.Symbol("a"))).det(), sympy.Symbol("a"))
    if det.is_zero:
        return False
    stops = sorted(_fraction(end) for (low, high), _ in det.intervals() for end in (low, high))
    gaps = [*([stops[0] - 1, stops[-1] + 1] if stops else [Fraction(0)]),
            *((x + y) / 2 for x, y in zip(stops, stops[1:])), *stops]
    return any(len(h) in signature(combined(h, F, a)) for a in gaps)


def _sympy(form):
    return [[sympy.Rational(x.numerator, x.denominator) for x in row] for row in form]
