"""Rotations of a body in a polynomial field by Newton's method in tangent planes; their types at 50 digits.

U is {exponents: coefficient}. Nothing is shared with the library.
"""
import mpmath
import numpy as np


def jet(terms, k):
    """Gradient and Hessian of a polynomial at points, shape (n, 3)."""
    gradient, hessian = np.zeros((len(k), 3)), np.zeros((len(k), 3, 3))
    for e, c in terms.items():
        for i in range(3):
            first = np.array(e) - np.eye(3, dtype=int)[i]
            if first[i] < 0:
                continue
            gradient[:, i] += c * e[i] * np.prod(k ** first, axis=1)
            for j in range(3):
                second = first - np.eye(3, dtype=int)[j]
                if second[j] >= 0:
                    hessian[:, i, j] += c * e[i] * first[j] * np.prod(k ** second, axis=1)
    return gradient, hessian


def slope(terms, inertia, rotor, k, level=None, rate=None):
    """Rate, gradient and Hessian of U_c on a level of C1, or of U − ω l·k − ω² k·Ik/2 at a rate."""
    g, H = jet(terms, k)
    along = k @ inertia
    if level is None:
        omega = np.full(len(k), rate)
        return omega, g - rate * rotor - rate**2 * along, H - rate**2 * inertia
    J = np.sum(k * along, axis=1)
    omega = (level - k @ rotor) / J
    across = rotor + 2 * omega[:, None] * along
    g = g - omega[:, None] * rotor - omega[:, None]**2 * along
    return omega, g, H - omega[:, None, None]**2 * inertia + (
        across[:, :, None] * across[:, None, :] / J[:, None, None])


def found(terms, inertia, rotor, level=None, rate=None, starts=400, seed=1):
    """(k, omega, least singular value of the Hessian on the tangent plane) of what Newton's method comes to.

    On the tangent plane with bounded steps, then to convergence; every start that converges is kept once.
    """
    rng = np.random.default_rng(seed)
    k = rng.normal(size=(starts, 3))
    k = np.concatenate([k, np.eye(3), -np.eye(3)]) + 1e-3 * rng.normal(size=(starts + 6, 3))
    k /= np.linalg.norm(k, axis=1)[:, None]
    for _ in range(120):
        _, g, H = slope(terms, inertia, rotor, k, level, rate)
        ahead = np.where(np.abs(k[:, :1]) < 0.6, [[1.0, 0, 0]], [[0, 1.0, 0]])
        a = np.cross(k, ahead)
        a /= np.linalg.norm(a, axis=1)[:, None]
        basis = np.stack([a, np.cross(k, a)], axis=1)
        value = np.einsum("nij,nj->ni", basis, g)
        whole = H - np.sum(k * g, axis=1)[:, None, None] * np.eye(3)
        matrix = basis @ whole @ basis.transpose(0, 2, 1)
        step = np.einsum("nij,nj->ni", np.linalg.pinv(matrix, rcond=1e-13), value)
        size = np.linalg.norm(step, axis=1)[:, None]
        step *= np.minimum(1, 0.5 / np.maximum(size, 1e-300))
        k = k - np.einsum("nij,ni->nj", basis, step)
        k /= np.linalg.norm(k, axis=1)[:, None]
    good = np.linalg.norm(value, axis=1) < 1e-11 * (1 + np.linalg.norm(g, axis=1))
    omega = slope(terms, inertia, rotor, k, level, rate)[0]
    least = np.linalg.svd(matrix, compute_uv=False)[:, -1]
    points = []
    for n in np.flatnonzero(good):
        if all(np.abs(k[n] - other).max() > 1e-5 for other, _, _ in points):
            points.append((k[n], omega[n], least[n]))
    return points


def kind(terms, inertia, rotor, k, omega, digits=50):
    """STABLE by signature, UNSTABLE by spectrum, HELD if neither, "" on a boundary; of numbers in mpmath.

    D²(h + ν₁ C1 + ν₂ C2) on the tangent space of the orbit, and the linearised Euler-Poisson equations.
    """
    with mpmath.workdps(digits):
        def unit(i):
            return [mpmath.mpf(int(i == j)) for j in range(3)]

        def derivative(*axes):
            total = mpmath.mpf(0)
            for e, c in terms.items():
                left, factor = list(e), mpmath.mpf(c.numerator) / c.denominator
                for axis in axes:
                    factor, left[axis] = factor * left[axis], left[axis] - 1
                if factor:
                    total += factor * mpmath.fprod(x**n for x, n in zip(k, left))
            return total

        def hat(v):
            return mpmath.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])

        def block(a, b, c, d):
            whole = mpmath.zeros(6)
            for part, (i, j) in zip((a, b, c, d), ((0, 0), (0, 3), (3, 0), (3, 3))):
                whole[i:i + 3, j:j + 3] = part
            return whole

        I = mpmath.matrix([[mpmath.mpf(x.numerator) / x.denominator for x in row] for row in inertia])
        l = mpmath.matrix([mpmath.mpf(x.numerator) / x.denominator for x in rotor])
        n = mpmath.matrix(k)
        g = mpmath.matrix([derivative(i) for i in range(3)])
        Q = mpmath.matrix([[derivative(i, j) for j in range(3)] for i in range(3)])
        inverse, rate = I**-1, omega * n
        M, one = I * rate + l, mpmath.eye(3)
        field = block(hat(M) * inverse - hat(rate), hat(n) * Q - hat(g), hat(n) * inverse, -hat(rate))
        growth = max(x.real for x in mpmath.eig(field, left=False, right=False))
        nu = -sum((g[i] - omega * M[i]) * n[i] for i in range(3))
        form = block(inverse, -omega * one, -omega * one, Q + nu * one)
        # tangent space: δk = a × k, δM = b × k + a × M
        tangent = mpmath.zeros(6, 6)
        for i in range(3):
            a = mpmath.matrix(unit(i))
            for j in range(3):
                tangent[j, i], tangent[3 + j, i] = (hat(a) * M)[j], (hat(a) * n)[j]
                tangent[j, 3 + i] = (hat(a) * n)[j]
        _, singular, turned = mpmath.svd_r(tangent.T)
        rows = mpmath.matrix([[turned[i, j] for j in range(6)] for i in range(4)])
        assert singular[4] < mpmath.mpf(10)**(-digits + 10)
        values = mpmath.eigsy(rows * form * rows.T, eigvals_only=True)
        small = mpmath.mpf(10)**(-digits // 3)
        scale = max(abs(x) for x in values)
        if growth > small * 10**3:
            return "UNSTABLE"
        if min(abs(x) for x in values) < small * scale:
            return ""
        return "STABLE" if min(values) > 0 else "HELD"
