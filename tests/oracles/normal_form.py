"""Birkhoff's normal form of a body in a polynomial field, over Q and without eigenvectors.

The orbit is T*S² in the stereographic chart about the equilibrium, with the magnetic term c·(area) made
canonical. Deprit's triangle; {h2, W} = … is a linear system over Q among the monomials of one degree, and
what stays is a polynomial in the two quadratic integrals of the linear motion. Nothing is shared with the
library.
"""
from itertools import combinations_with_replacement
from math import comb, factorial

import numpy as np
from flint import Ordering, fmpq, fmpq_mat, fmpq_mpoly_ctx

RING = fmpq_mpoly_ctx.get(("x", "p", "y", "r"), Ordering.lex)  # {x, p} = {y, r} = 1
X, P, Y, R = RING.gens()
ONE = RING.constant(1)
AXES = np.eye(3, dtype=int)


def momenta(level):
    """M = π + l about the pole k = e3, where M·k = level; {M1, M2} = −M3."""
    square = (X**2 + Y**2) / 4
    return (X * Y / 2 * P + (ONE - square + Y**2 / 2) * R + X * (level / 2),
            -(ONE - square + X**2 / 2) * P - X * Y / 2 * R + Y * (level / 2), Y * P - X * R + level)


def directions(degree):
    """k about the pole, to a degree."""
    square = (X**2 + Y**2) / 4
    share = sum(((-1) ** n * square**n for n in range(1, degree // 2 + 1)), ONE)
    return X * share, Y * share, (ONE - square) * share


def to_the_pole(k):
    """The rotation that takes k to e3, in fractions."""
    n = [k[0], k[1], k[2] + 1]
    size = sum(x * x for x in n)
    if size == 0:
        return [[fmpq(1), fmpq(0), fmpq(0)], [fmpq(0), fmpq(-1), fmpq(0)], [fmpq(0), fmpq(0), fmpq(-1)]]
    return [[2 * n[i] * n[j] / size - int(i == j) for j in range(3)] for i in range(3)]


def energy(inverse, rotor, k, momentum, field, degree):
    """h in the chart, parts of degree 0 to the degree; U = Σ field[a, b, c] k1^a k2^b k3^c."""
    inverse = [[rational(x) for x in row] for row in inverse]
    rotor, k, momentum = ([rational(x) for x in v] for v in (rotor, k, momentum))
    turn = to_the_pole(k)
    inverse = times(turn, times(inverse, turn))           # the rotation is its own inverse
    rotor, momentum = ([sum(a * b for a, b in zip(row, v)) for row in turn] for v in (rotor, momentum))
    rate = [m - l for m, l in zip(momenta(momentum[2]), rotor)]
    h = sum(rate[i] * rate[j] * (inverse[i][j] / 2) for i in range(3) for j in range(3))
    h += potential(turn, field, degree)
    h = h.compose(X, P - momentum[1], Y, R + momentum[0], ctx=RING)
    return [part(h, n) for n in range(degree + 1)]


def potential(turn, field, degree):
    """U in the chart."""
    at_pole = directions(degree)
    place = [sum((at_pole[j] * turn[j][i] for j in range(3)), 0 * ONE) for i in range(3)]
    powers = [[ONE] for _ in range(3)]
    for n in range(3):
        for _ in range(max(sum(orders) for orders in field)):
            powers[n].append(below(powers[n][-1] * place[n], degree))
    return sum((below(below(powers[0][a] * powers[1][b], degree) * powers[2][c], degree) * rational(number)
                for (a, b, c), number in field.items()), 0 * ONE)


def rational(x):
    """A number of the library's, of SymPy's or of Python's as a fraction."""
    return fmpq(int(x.p), int(x.q)) if hasattr(x, "p") else fmpq(x.numerator, x.denominator)


def times(a, b):
    return [[sum(x * b[n][j] for n, x in enumerate(row)) for j in range(3)] for row in a]


def below(f, degree):
    return RING.from_dict({e: c for e, c in f.to_dict().items() if sum(e) <= degree})


def part(f, degree):
    return RING.from_dict({e: c for e, c in f.to_dict().items() if sum(e) == degree})


def bracket(f, g):
    return (f.derivative(0) * g.derivative(1) - f.derivative(1) * g.derivative(0)
            + f.derivative(2) * g.derivative(3) - f.derivative(3) * g.derivative(2))


def monomials(degree):
    """Exponents of one degree."""
    return [tuple(chosen.count(n) for n in range(4))
            for chosen in combinations_with_replacement(range(4), degree)]


def field_of(h2):
    """A of y' = A y, and p and q of λ⁴ + p λ² + q."""
    A = [[fmpq(0)] * 4 for _ in range(4)]
    for row, (partner, sign) in enumerate(((1, 1), (0, -1), (3, 1), (2, -1))):
        for exponents, c in (h2.derivative(partner) * sign).to_dict().items():
            A[row][exponents.index(1)] = c
    A = fmpq_mat(A)
    square = A * A
    p = -trace(square) / 2
    return A, p, (p * p - trace(square * square) / 2) / 2


def trace(A):
    return sum((A[n, n] for n in range(4)), fmpq(0))


def second_integral(A):
    """F with the linear field A³, −ω1³ I1 − ω2³ I2 where h2 = ω1 I1 + ω2 I2."""
    cube, y = A * A * A, (X, P, Y, R)
    gradient = [sum((y[m] * cube[n, m] for m in range(4)), 0 * ONE) * sign
                for n, sign in ((1, -1), (0, 1), (3, -1), (2, 1))]
    return sum((a * b for a, b in zip(y, gradient)), 0 * ONE) / 2


def removed(h2, known, stay):
    """W with known + {h2, W} = Σ c stay, and the c; None where there is none."""
    degree = max(sum(e) for e in stay[0].to_dict()) if stay else 3
    basis = monomials(degree)
    columns = [bracket(h2, RING.from_dict({e: fmpq(1)})) for e in basis]
    columns = [f.to_dict() for f in (*columns, *(-f for f in stay), -known)]
    solved, rank = fmpq_mat([[c.get(e, fmpq(0)) for c in columns] for e in basis]).rref()
    last = len(columns) - 1
    values = [fmpq(0)] * last
    for row in range(rank):
        pivot = next(n for n in range(last + 1) if solved[row, n] != 0)
        if pivot == last:
            return None
        values[pivot] = solved[row, last]
    return RING.from_dict(dict(zip(basis, values))), values[len(basis):]


def triangle(parts, integrals):
    """K of every degree as its coefficients over integrals(degree); Deprit's triangle."""
    H = {(0, n): h * factorial(n) for n, h in enumerate(parts[2:])}
    W, found = [], {}
    for n in range(1, len(parts) - 2):
        for step in (False, True):                        # without the unknown W of this degree, then with it
            for i in range(1, n + 1):
                j = n - i
                H[i, j] = H[i - 1, j + 1] + sum(comb(j, m) * bracket(H[i - 1, j - m], W[m])
                                                for m in range(j + 1) if m < len(W))
            if not step:
                stay = integrals(n + 2)
                if (solved := removed(parts[2], H[n, 0], stay)) is None:
                    return found
                W.append(solved[0])
                found[n + 2] = [c / factorial(n) for c in solved[1]]
    return found


def twists(parts):
    """D4 in fractions and, of parts to degree 6, D6/√(q (p² − 4q)) up to its sign; off resonances."""
    A, p, q = field_of(parts[2])
    F = second_integral(A)

    def integrals(degree):
        half = degree // 2
        return [parts[2] ** (half - n) * F**n for n in range(half + 1)] if degree % 2 == 0 else []

    found = triangle(parts, integrals)
    size = q * (p * p - 4 * q)                            # F² at the actions (ω2, −ω1)
    return [found[degree][-1] * size for degree in (4, 6) if degree in found]


def resonant(parts):
    """Every polynomial of degree 3 or 4 that the linear motion keeps, and K over them."""
    def kept(degree):
        basis = monomials(degree)
        columns = [bracket(parts[2], RING.from_dict({e: fmpq(1)})).to_dict() for e in basis]
        solved, rank = fmpq_mat([[c.get(e, fmpq(0)) for c in columns] for e in basis]).rref()
        pivots = [next(n for n in range(len(basis)) if solved[row, n] != 0) for row in range(rank)]
        free = [n for n in range(len(basis)) if n not in pivots]
        return [RING.from_dict({basis[n]: fmpq(1)} | {basis[m]: -solved[i, n] for i, m in enumerate(pivots)})
                for n in free]

    forms = {degree: kept(degree) for degree in range(3, len(parts))}
    found = triangle(parts, forms.get)
    return {degree: sum((c * f for c, f in zip(numbers, forms[degree])), 0 * ONE)
            for degree, numbers in found.items()}


def valley(tensor, rotor, k, level, field):
    """Where the second variation of U + (level − l·k)²/(2 k·Ik) vanishes along a line: its other eigenvalue
    and the coefficients of degree 3 and 4 along the valley.
    """
    turn = to_the_pole([rational(x) for x in k])
    tensor = times(turn, times([[rational(x) for x in row] for row in tensor], turn))
    rotor = [sum(a * rational(b) for a, b in zip(row, rotor)) for row in turn]
    at_pole = directions(4)
    along = sum((a * b for a, b in zip(at_pole, rotor)), 0 * ONE)
    J = below(sum(at_pole[i] * at_pole[j] * tensor[i][j] for i in range(3) for j in range(3)), 4)
    start = tensor[2][2]
    share = sum((ONE - J * (1 / start)) ** n for n in range(5)) * (1 / start)
    value = below((along - rational(level)) ** 2 * below(share, 4) / 2, 4) + potential(turn, field, 4)
    second = part(value, 2)
    form = [[second.derivative(i).derivative(j).to_dict().get((0,) * 4, fmpq(0)) for j in (0, 2)]
            for i in (0, 2)]
    row = form[0] if any(form[0]) else form[1]
    u, s = (-row[1], row[0]), row
    value = below(value, 4).compose(X * u[0] + Y * s[0], P, X * u[1] + Y * s[1], R, ctx=RING).to_dict()
    e, a3, mixed, a4 = (value.get((n, 0, m, 0), fmpq(0)) for n, m in ((0, 2), (3, 0), (2, 1), (4, 0)))
    return e, a3, a4 - mixed**2 / (4 * e)


def linear_modes(parts):
    """The slower and the faster frequency, and its vector in doubles of action 1."""
    A = np.array([[decimal(x) for x in row] for row in field_of(parts[2])[0].tolist()])
    values, vectors = np.linalg.eig(A)
    J = np.array([[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1], [0, 0, -1, 0]])
    found = [(values[n].imag, vectors[:, n] / np.sqrt(abs(vectors[:, n].conj() @ J @ vectors[:, n])))
             for n in range(4) if values[n].imag > 0]
    return sorted(found, key=lambda mode: mode[0])


def sign_of_the_faster(parts):
    """Whether the energy of the faster oscillation is positive."""
    y = 2 * linear_modes(parts)[1][1].real
    return bool(at(parts[2], y) > 0)


def on_the_torus(parts, polynomial, angles=24):
    """Mean and amplitude at the actions (abs(ω2), abs(ω1)), where h2 = 0: a constant and one harmonic."""
    (slow, one), (fast, two) = linear_modes(parts)
    phi = 2 * np.pi * np.arange(angles) / angles
    y = [2 * (one[n] * np.sqrt(fast) * np.exp(1j * phi) + two[n] * np.sqrt(slow)).real for n in range(4)]
    total = at(polynomial, y)
    return total.mean(), abs(np.fft.rfft(total)[1:]).max() * 2 / angles


def at(polynomial, y):
    """The value in doubles."""
    return sum(decimal(c) * np.prod([y[n] ** int(e[n]) for n in range(4)], axis=0)
               for e, c in polynomial.to_dict().items())


def decimal(x):
    return int(x.p) / int(x.q)
