"""The permanent rotations of a heavy gyrostat counted by Sturm's theorem in fractions, and decided exactly.

U = c·k + k·Qk/2. Characteristic polynomial by Faddeev and LeVerrier, signature by minors, in fractions or at
50 digits. Nothing is shared with the library.
"""
import mpmath as mp
import oracle

DIGITS = 50
TINY = mp.mpf(10) ** -30


def count(moments, rotor, c, Q, omega):
    """Points and circles of (omega² I − Q + sigma) k = c − omega l, abs(k) = 1; in fractions, b or Q not 0.

    Off a diagonal Q what is singular is not counted; None where there is such a thing.
    """
    b = [x - omega * l for x, l in zip(c, rotor)]
    if any(Q[i][j] for i in range(3) for j in range(i)):
        return _counted([[(omega**2 * moments[i] if i == j else 0) - Q[i][j] for j in range(3)]
                         for i in range(3)], b)
    own = [omega**2 * moment - Q[i][i] for i, moment in enumerate(moments)]
    squares = {a: sum(x * x for x, other in zip(b, own) if other == a) for a in own}
    carried = {a: square for a, square in squares.items() if square}
    whole = [-1]
    for a in carried:
        whole = oracle.product(whole, [a * a, 2 * a, 1])
    for a, square in carried.items():
        part = [square]
        for other in carried:
            if other != a:
                part = oracle.product(part, [other * other, 2 * other, 1])
        whole = [x + (part[n] if n < len(part) else 0) for n, x in enumerate(whole)]
    points, circles = oracle.count_roots(whole) if carried else 0, 0
    for a in squares.keys() - carried:
        if sum(square / (other - a) ** 2 for other, square in carried.items()) < 1:
            alone = own.count(a) == 1
            points, circles = points + 2 * alone, circles + (not alone)
    return points, circles


def _counted(N, b):
    """abs(adj(N + sigma) b)² = det(N + sigma)², where no root of one side is one of the other."""
    trace = N[0][0] + N[1][1] + N[2][2]
    adjugate = [_cross(N[1], N[2]), _cross(N[2], N[0]), _cross(N[0], N[1])]
    below = [_dot(N[0], adjugate[0]), adjugate[0][0] + adjugate[1][1] + adjugate[2][2], trace, 1]
    whole = [-x for x in oracle.product(below, below)]
    for row, flat, x in zip(N, adjugate, b):
        part = [_dot(flat, b), trace * x - _dot(row, b), x]
        for n, value in enumerate(oracle.product(part, part)):
            whole[n] += value
    apart = oracle.count_roots(oracle.product(whole, below)) == oracle.count_roots(whole) + 3
    return (oracle.count_roots(whole), 0) if apart else None


def decided(moments, rotor, c, Q, omega, k):
    """p and q of λ² (λ⁴ + p λ² + q), determinant and trace of the form across k; fractions or of mpmath."""
    rate = [omega * x for x in k]
    M = [i * x + l for i, x, l in zip(moments, rate, rotor)]
    slopes = [x + _dot(row, k) for x, row in zip(c, Q)]
    A = [[0 * omega] * 6 for _ in range(6)]                    # Ṁ = M × ω + k × ∇U, k̇ = k × ω
    for j in range(3):
        e = [int(n == j) for n in range(3)]
        turned = [x / moments[j] for x in e]
        columns = ([x + y for x, y in zip(_cross(e, rate), _cross(M, turned))], _cross(k, turned),
                   [x + y for x, y in zip(_cross(e, slopes), _cross(k, [row[j] for row in Q]))],
                   _cross(e, rate))
        for i in range(3):
            A[i][j], A[i + 3][j], A[i][j + 3], A[i + 3][j + 3] = (x[i] for x in columns)
    p, q, rest = _characteristic(A)
    assert all(abs(x) * 10**30 <= (1 + abs(p)) ** 3 for x in rest)
    # in the basis k × e of the plane across k, e not along the largest part of k
    n = max(range(3), key=lambda n: abs(k[n]))
    form, (i, j) = _second(moments, M, slopes, Q, omega, k, n), [m for m in range(3) if m != n]
    trace = form[0][0] * (1 - k[j]**2) + form[1][1] * (1 - k[i]**2) + 2 * form[0][1] * k[i] * k[j]
    return p, q, (form[0][0] * form[1][1] - form[0][1] ** 2) / k[n]**2, trace / k[n]**2


def _second(moments, M, slopes, Q, omega, k, n):
    """The 2×2 form left of D²(h − omega C1 + nu C2) on the orbit's tangent space when π is eliminated.

    Tangent vectors: (k × b, 0) and (M × a, k × a).
    """
    nu = omega * _dot(k, M) - _dot(k, slopes)
    others = [[int(m == i) for m in range(3)] for i in range(3) if i != n]
    tangent = [(_cross(k, b), [0, 0, 0]) for b in others] + [(_cross(M, a), _cross(k, a)) for a in others]

    def product(x, y):
        curved = [_dot(row, y[1]) + nu * z for row, z in zip(Q, y[1])]
        return (sum(s * t / i for s, t, i in zip(x[0], y[0], moments)) + _dot(x[1], curved)
                - omega * (_dot(x[0], y[1]) + _dot(x[1], y[0])))

    F = [[product(x, y) for y in tangent] for x in tangent]
    whole = F[0][0] * F[1][1] - F[0][1] * F[1][0]
    assert F[0][0] > 0 and whole > 0
    inverse = [[F[1][1] / whole, -F[0][1] / whole], [-F[1][0] / whole, F[0][0] / whole]]
    return [[F[i][j] - sum(F[i][a] * inverse[a][b] * F[b][j] for a in (0, 1) for b in (0, 1))
             for j in (2, 3)] for i in (2, 3)]


def _characteristic(A):
    """p, q, and the coefficients that vanish, of a 6×6 matrix."""
    B, found = [[int(i == j) for j in range(6)] for i in range(6)], []
    for n in range(1, 7):
        columns = list(zip(*B))
        B = [[sum(x * y for x, y in zip(row, column) if x and y) for column in columns] for row in A]
        found.append(-sum(B[i][i] for i in range(6)) / n)
        for i in range(6):
            B[i][i] += found[-1]
    return found[1], found[3], (found[0], found[2], found[4], found[5])


def verdict(p, q, determinant, trace, zero=0):
    """STABLE, UNSTABLE or UNDECIDED, by spectrum and signature; None on a boundary."""
    if abs(determinant) <= zero:
        return None
    assert (q > 0) == (determinant > 0)
    if determinant < 0:
        return "UNSTABLE"
    if trace > 0:
        return "STABLE"
    if p < -zero or p * p - 4 * q < -zero:
        return "UNSTABLE"
    return "UNDECIDED" if p > zero and p * p - 4 * q > zero else None


def polished(moments, rotor, c, Q, omega, k):
    """A direction to 50 digits, by Newton's method from one in doubles; None where that is degenerate."""
    with mp.workdps(DIGITS + 10):
        k = mp.matrix([float(x) for x in k])
        N = mp.matrix([[(omega**2 * moments[i] if i == j else 0) - Q[i][j] for j in range(3)]
                       for i in range(3)])
        b = mp.matrix([x - omega * l for x, l in zip(c, rotor)])
        sigma = (k.T * (b - N * k))[0]
        for _ in range(8):
            J = mp.zeros(4)
            for i in range(3):
                for j in range(3):
                    J[i, j] = N[i, j] + (sigma if i == j else 0)
                J[i, 3] = J[3, i] = k[i]
            residual = N * k + sigma * k - b
            right = mp.matrix([*residual, ((k.T * k)[0] - 1) / 2])
            try:
                step = mp.lu_solve(J, right)
            except ZeroDivisionError:
                return None
            k, sigma = k - step[:3, :], sigma - step[3]
        return list(k) if mp.mnorm(step) < mp.mpf(10) ** -45 else None


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
