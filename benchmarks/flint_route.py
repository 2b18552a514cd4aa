"""The derivation of E1, E2 and E3 with their criteria, written for these three alone in python-flint.

It is the least that has to be computed, and the baseline of what a library adds: no expressions, no checks of
what is entered, no choice of pivots, no other body or field. Sign conventions are those of routes.py.
"""
from math import prod

from flint import Ordering, fmpq_mpoly_ctx

NAMES = ("pi1", "pi2", "pi3", "k1", "k2", "k3", "I1", "I3", "l", "dU", "d2U", "omega", "pi3_0", "nu")
RING = fmpq_mpoly_ctx.get(NAMES, Ordering.lex)
ZERO, ONE = RING.constant(0), RING.constant(1)
GENS = RING.gens()
PI1, PI2, PI3, K1, K2, K3, I1, I3, L, DU, D2U, W, P0, NU = GENS
SHELL = W * L - W**2 * K3 * (I1 - I3)                   # dU on E3
CIRCLE = K1**2 + K3**2 - 1                               # = 0 there
E1_MARGIN = (P0 + L) ** 2 - 4 * I1 * DU                 # VV2003 §4.1
E3_MARGIN = (I1 * (1 - K3**2) * D2U - 2 * I1 * K3 * (W * L - W**2 * K3 * (I1 - I3)) + I1**2 * W**2
             + ((I1 - I3) * W * K3 - L) ** 2)           # VV2003 §5


def hat(v):
    """Return the matrix of v ×."""
    return [[ZERO, -v[2], v[1]], [v[2], ZERO, -v[0]], [-v[1], v[0], ZERO]]


def times(a, b, reduced):
    """Return a product of matrices."""
    return [[reduced(sum((x * y for x, y in zip(row, column) if x and y), ZERO)) for column in zip(*b)]
            for row in a]


def determinant(matrix):
    """Return a determinant by its first row."""
    if not matrix:
        return ONE
    return sum(((-1) ** n * entry * determinant([row[:n] + row[n + 1:] for row in matrix[1:]])
                for n, entry in enumerate(matrix[0]) if entry), ZERO)


def characteristic(matrix, reduced):
    """Return c1, …, cn of det(λ − A) (Faddeev, LeVerrier)."""
    size, found = len(matrix), []
    power = [[ONE if i == j else ZERO for j in range(size)] for i in range(size)]
    for n in range(1, size + 1):
        power = times(matrix, power, reduced)
        found.append(sum((power[i][i] for i in range(size)), ZERO) / -n)
        for i in range(size):
            power[i][i] += found[-1]
    return found


def odd(polynomial):
    """Return the product of the factors of odd multiplicity that have two terms, up to its sign."""
    return prod((f for f, n in polynomial.factor()[1] if n % 2 and len(f) > 1), start=ONE)


def derived():
    """Return (discriminant or p, margins of the minors) of E1, E2, E3, the bracket checked first."""
    M = (PI1, PI2, PI3 + L)
    of_M, of_k = hat(M), hat((K1, K2, K3))
    tensor = [a + b for a, b in zip(of_M, of_k)] + [row + [ZERO] * 3 for row in of_k]
    slopes = [[[entry.derivative(m) for m in range(6)] for entry in row] for row in tensor]
    for i in range(6):
        for j in range(i):
            for k in range(j):
                turns = (i, j, k), (j, k, i), (k, i, j)
                assert not sum((tensor[a][m] * slopes[b][c][m] for a, b, c in turns for m in range(6)
                                if tensor[a][m] and slopes[b][c][m]), ZERO)
    scale = I1 * I3                                         # of the energy
    gradient = [PI1 * I3, PI2 * I3, PI3 * I1, ZERO, ZERO, DU * scale]
    field = [sum((x * y for x, y in zip(row, gradient)), ZERO) for row in tensor]
    jacobian, hessian = ([[f.derivative(n) + (f.derivative(9) * D2U if n == 5 else ZERO) for n in range(6)]
                          for f in several] for several in (field, gradient))
    first = sum((m * k for m, k in zip(M, (K1, K2, K3))), ZERO)
    second = K1**2 + K2**2 + K3**2
    forms = [[[F.derivative(i).derivative(j) for j in range(6)] for i in range(6)] for F in (first, second)]
    found = []
    for s in (1, -1):
        at = [ZERO, ZERO, P0, ZERO, ZERO, ONE * s, *GENS[6:]]
        held, own = (0, 1, 3, 4), (lambda p: p)
        assert not any(f.compose(*at) for f in field)
        matrix = [[jacobian[i][j].compose(*at) for j in held] for i in held]
        _, p, _, q = characteristic(matrix, own)
        spectral = [odd(x) for x in (p, q, p**2 - 4 * q)]
        formal = []
        for n1 in (-s * P0, NU * I3):                       # times I3: the Casimirs alone, a free multiplier
            n2 = -s * (DU * I3 + n1 * (P0 + L)) / 2
            form = [[hessian[i][j].compose(*at) + I1 * (n1 * forms[0][i][j].compose(*at)
                                                        + n2 * forms[1][i][j].compose(*at)) for j in held]
                    for i in held]
            formal.append([determinant([row[:n] for row in form[:n]]) for n in (1, 2, 3, 4)])
        alone = [odd(x) for x in formal[0]]
        free = [f for f, _ in formal[1][2].factor()[1] if f.degrees()[13] == 2]
        parts = [{}, {}, {}]
        for exponents, c in free[0].to_dict().items():
            parts[exponents[13]][(*exponents[:13], 0)] = c
        c, b, a = (RING.from_dict(part) for part in parts)
        found.append((spectral[2], odd(b**2 - 4 * a * c), alone))

    def own(p):
        return divmod(p, CIRCLE)[1]

    at = [I1 * W * K1, ZERO, I3 * W * K3, K1, ZERO, K3, *GENS[6:]]
    shell = [*GENS[:9], SHELL, *GENS[10:]]
    assert not any(own(f.compose(*at).compose(*shell)) for f in field)
    M1, M3 = I1 * W * K1, I3 * W * K3 + L
    basis = [[ZERO, -K3 * K1, ZERO, M1 * K3 - M3 * K1], [K1**2, ZERO, ZERO, ZERO], [ZERO, K1**2, ZERO, ZERO],
             [ZERO, ZERO, ZERO, -K3 * K1], [ZERO, ZERO, K1**2, ZERO], [ZERO, ZERO, ZERO, K1**2]]   # × k1²
    rows = [[own(entry.compose(*at).compose(*shell)) for entry in jacobian[i]] for i in (1, 2, 4, 5)]
    _, p, _, q = characteristic(times(rows, basis, own), own)
    nu1, twice = -W * scale, I1 * W**2 * scale              # times scale: ν1, 2 ν2
    form = [[own((hessian[i][j] + nu1 * forms[0][i][j]).compose(*at).compose(*shell)
                 + twice * forms[1][i][j] / 2) for j in range(6)] for i in range(6)]
    whole = [list(column) for column in zip(*basis)]
    slices = [whole[0], whole[3]], whole                    # with π3 held modulo its flow; the Casimirs alone
    margins = []
    for vectors in slices:
        matrix = times(times(vectors, form, own), [list(c) for c in zip(*vectors)], own)
        margins.append([odd(own(determinant([row[:n] for row in matrix[:n]])))
                        for n in range(1, len(matrix) + 1)])
    return [*found, (odd(p), q, margins)]


def flint_route():
    """Whether the margins are the printed ones."""
    first, second, third = derived()
    turned = [*GENS[:9], -DU, *GENS[10:]]
    assert not third[1]
    return all(((x * y.leading_coefficient() - y * x.leading_coefficient()) == 0) for x, y in (
        (first[0], E1_MARGIN), (first[1], E1_MARGIN), (second[1], E1_MARGIN.compose(*turned)))) and (
        third[0] in (E3_MARGIN, -E3_MARGIN)) and not divmod(third[2][0][1], E3_MARGIN)[1]
