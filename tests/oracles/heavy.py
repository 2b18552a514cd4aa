"""Permanent rotations of a heavy gyrostat by Newton's method from many starts, and their types by spectra.

In doubles; U = c·k + k·Qk/2. Nothing is shared with the library.
"""
import mpmath
import numpy as np


def directions(inertia, rotor, c, Q, omega, starts=120, seed=0):
    """Every k with (omega² I − Q + sigma) k = c − omega l and abs(k) = 1 that is found from the starts."""
    N, b = omega**2 * inertia - Q, c - omega * rotor
    rng = np.random.default_rng(seed)
    k = rng.normal(size=(starts, 3))
    k /= np.linalg.norm(k, axis=1)[:, None]
    sigma = np.einsum("ni,ni->n", k, b - k @ N) + rng.normal(size=starts) * (np.abs(N).max() + 1)
    for _ in range(80):
        J = np.zeros((starts, 4, 4))
        J[:, :3, :3] = N + sigma[:, None, None] * np.eye(3)
        J[:, :3, 3] = J[:, 3, :3] = k
        length = np.sum(k**2, axis=1)[:, None]
        residual = np.concatenate([k @ N + sigma[:, None] * k - b, (length - 1) / 2], axis=1)
        step = np.linalg.solve(J + 1e-300, residual[..., None])[..., 0]
        k, sigma = k - step[:, :3], sigma - step[:, 3]
    good = np.all(np.isfinite(k), 1) & (np.abs(step).max(1) < 1e-9 * (1 + np.abs(sigma)))
    found = []
    for x in k[good]:
        if all(np.abs(x - y).max() > 1e-6 for y in found):
            found.append(x)
    return found


def hat(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def spectrum(inertia, rotor, c, Q, omega, k):
    """The six eigenvalues of the Euler-Poisson equations, linearised; two are 0."""
    inverse, rate = np.linalg.inv(inertia), omega * k
    M, g = inertia @ rate + rotor, c + Q @ k
    top = np.hstack([-hat(rate) + hat(M) @ inverse, -hat(g) + hat(k) @ Q])
    bottom = np.hstack([hat(k) @ inverse, -hat(rate)])
    return np.linalg.eigvals(np.vstack([top, bottom]))


def growth(inertia, rotor, c, Q, omega, k):
    """The largest real part of an eigenvalue."""
    return spectrum(inertia, rotor, c, Q, omega, k).real.max()


def ratio(inertia, rotor, c, Q, omega, k):
    """The larger frequency over the smaller, where the six eigenvalues are imaginary."""
    slow, fast = np.sort(spectrum(inertia, rotor, c, Q, omega, k).imag)[-2:]
    return fast / slow


def squares(inertia, rotor, c, Q, omega, k):
    """Eigenvalues of D²(h + nu·C) on the tangent space of the orbit, in increasing order."""
    inverse, M = np.linalg.inv(inertia), omega * inertia @ k + rotor
    nu1 = -omega
    nu2 = -(k @ (c + Q @ k) + nu1 * (k @ M))               # of C2 = k·k/2
    form = np.block([[inverse, nu1 * np.eye(3)], [nu1 * np.eye(3), Q + nu2 * np.eye(3)]])
    normals = np.array([[*k, *M], [0, 0, 0, *k]])
    tangent = np.linalg.svd(normals)[2][2:]
    return np.linalg.eigvalsh(tangent @ form @ tangent.T)


def verdict(inertia, rotor, c, Q, omega, k):
    """Of spectra and signatures; None near a boundary."""
    rate, form = growth(inertia, rotor, c, Q, omega, k), squares(inertia, rotor, c, Q, omega, k)
    if np.abs(form).min() < 1e-6 * np.abs(form).max() or 1e-7 < rate < 1e-4:
        return None
    return "UNSTABLE" if rate > 1e-4 else "STABLE" if form[0] > 0 else "UNDECIDED"


def on_level(inertia, rotor, c, Q, level, starts=200, seed=0):
    """Every k at which U + (level − l·k)²/(2 k·Ik) is critical on abs(k) = 1, that is found; and its rate."""
    rng = np.random.default_rng(seed)
    k = rng.normal(size=(starts, 3))
    k /= np.linalg.norm(k, axis=1)[:, None]

    def slope(k):
        along = k @ inertia
        J = np.sum(k * along, axis=1)[:, None]
        omega = (level - k @ rotor)[:, None] / J
        return along, J, omega, c + k @ Q - omega * rotor - omega**2 * along

    sigma = np.sum(k * slope(k)[3], axis=1)
    for _ in range(80):
        along, J, omega, g = slope(k)
        v = 2 * omega * along + rotor
        hessian = Q - omega[..., None]**2 * inertia + v[:, :, None] * v[:, None, :] / J[..., None]
        M = np.zeros((starts, 4, 4))
        M[:, :3, :3] = hessian - sigma[:, None, None] * np.eye(3)
        M[:, :3, 3], M[:, 3, :3] = -k, k
        residual = np.concatenate([g - sigma[:, None] * k, (np.sum(k**2, axis=1)[:, None] - 1) / 2], axis=1)
        step = np.linalg.solve(M + 1e-300, residual[..., None])[..., 0]
        k, sigma = k - step[:, :3], sigma - step[:, 3]
    good = np.all(np.isfinite(k), 1) & (np.abs(step).max(1) < 1e-9 * (1 + np.abs(sigma)))
    found = []
    for x in k[good]:
        if all(np.abs(x - y).max() > 1e-6 for y, _ in found):
            found.append((x, (level - x @ rotor) / (x @ inertia @ x)))
    return found


def jet(terms, k):
    """Gradient and second derivatives of a polynomial {exponents: coefficient} at points, shape (n, 3)."""
    def value(axes):
        total = np.zeros(len(k))
        for e, c in terms.items():
            left = np.array(e, float)
            for n in axes:
                c, left[n] = c * left[n], left[n] - 1
            if c:
                total += c * np.prod(k ** np.maximum(left, 0), axis=1)
        return total
    first = np.stack([value([n]) for n in range(3)], axis=1)
    second = np.stack([np.stack([value([n, m]) for m in range(3)], axis=1) for n in range(3)], axis=1)
    return first, second


def critical(slope, starts=300, seed=0):
    """Every critical point on abs(k) = 1 that Newton's method finds; slope gives gradient and Hessian."""
    rng = np.random.default_rng(seed)
    k = rng.normal(size=(starts, 3))
    k /= np.linalg.norm(k, axis=1)[:, None]
    sigma = np.sum(k * slope(k)[0], axis=1)
    for _ in range(80):
        g, hessian = slope(k)
        M = np.zeros((starts, 4, 4))
        M[:, :3, :3] = hessian - sigma[:, None, None] * np.eye(3)
        M[:, :3, 3], M[:, 3, :3] = -k, k
        residual = np.concatenate([g - sigma[:, None] * k, (np.sum(k**2, axis=1)[:, None] - 1) / 2], axis=1)
        step = np.linalg.solve(M + 1e-300, residual[..., None])[..., 0]
        k, sigma = k - step[:, :3], sigma - step[:, 3]
        away = np.abs(k).max(1) > 10                       # where it is lost, it begins again
        k[away] /= np.linalg.norm(k[away], axis=1)[:, None]
    good = np.abs(step).max(1) < 1e-9 * (1 + np.abs(sigma))
    found = []
    for x in k[good]:
        if all(np.abs(x - y).max() > 1e-6 for y in found):
            found.append(x)
    return found


def at_rate(inertia, rotor, terms, omega):
    """Gradient and Hessian of U − omega² k·Ik/2 − omega l·k."""
    def slope(k):
        first, second = jet(terms, k)
        return first - omega**2 * k @ inertia - omega * rotor, second - omega**2 * inertia
    return slope


def amended(inertia, rotor, terms, level):
    """Gradient and Hessian of U + (level − l·k)²/(2 k·Ik)."""
    def slope(k):
        first, second = jet(terms, k)
        along = k @ inertia
        J = np.sum(k * along, axis=1)[:, None]
        omega = (level - k @ rotor)[:, None] / J
        v = 2 * omega * along + rotor
        return (first - omega * rotor - omega**2 * along,
                second - omega[..., None]**2 * inertia + v[:, :, None] * v[:, None, :] / J[..., None])
    return slope


def index(slope, k):
    """1 at a minimum or maximum, −1 at a saddle."""
    (g,), (hessian,) = slope(np.array([k]))
    across = np.linalg.svd(k[None])[2][1:]
    return np.sign(np.linalg.det(across @ (hessian - g @ k * np.eye(3)) @ across.T))


def eigenvalues(inertia, rotor, gradient, hessian, omega, k):
    """Of the six Euler-Poisson equations, linearised, at 50 digits; from fractions."""
    with mpmath.workdps(50):
        def matrix(rows):
            return mpmath.matrix([[mpmath.mpf(x.numerator) / x.denominator for x in row] for row in rows])

        def turn(v):
            return mpmath.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
        tensor, curved = matrix(inertia), matrix(hessian)
        l, g, along = (matrix([[x] for x in v]) for v in (rotor, gradient, k))
        rate = along * (mpmath.mpf(omega.numerator) / omega.denominator)
        M, inverse = tensor * rate + l, tensor**-1
        whole = mpmath.zeros(6)
        whole[:3, :3], whole[:3, 3:] = turn(M) * inverse - turn(rate), turn(along) * curved - turn(g)
        whole[3:, :3], whole[3:, 3:] = turn(along) * inverse, -turn(rate)
        return list(mpmath.eig(whole, left=False, right=False))
