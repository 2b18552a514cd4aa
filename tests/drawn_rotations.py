"""Heavy gyrostats drawn so that one of their permanent rotations is rational, and special or degenerate."""
from fractions import Fraction as F

NOTHING = [[F(0)] * 3 for _ in range(3)]
KINDS = ("b = 0", "at rest", "k along c", "l along c", "fold", "level", "equal moments", "general")


def fraction(rng, size=12, under=6):
    return F(rng.randint(-size, size), rng.randint(1, under))


def direction(rng):
    """A rational unit vector off every principal plane."""
    a, b = F(rng.randint(1, 9), rng.randint(1, 9)), F(rng.randint(1, 9), rng.randint(1, 9))
    k = [x * rng.choice((-1, 1)) for x in (2 * a, 2 * b, 1 - a * a - b * b)]
    return [x / (1 + a * a + b * b) for x in k] if k[2] else direction(rng)


def drawn(rng, kind):
    """Moments, rotor, c, Q, omega and a direction k of a permanent rotation of that rate; all rational.

    With d = omega² I − Q + sigma, b = d k and c = b + omega l. "fold": two rotations of that rate meet, Σ
    k²/d = 0. "level": two rotations meet on their level of C1, (y·dy)/J = k·adj(d)k, y = v × k.
    """
    found = _drawn(rng, kind)
    moments, _, c, Q, *_ = found
    field = any(c) or any(map(any, Q))
    return found if field and min(moments) > 0 and len(set(moments)) > 1 else drawn(rng, kind)


def _drawn(rng, kind):
    k, sigma, omega = direction(rng), fraction(rng), fraction(rng) or F(1)
    moments, rotor = [F(rng.randint(4, 30), 10) for _ in range(3)], [fraction(rng) / 3 for _ in range(3)]
    Q = NOTHING
    if kind == "at rest":
        omega = F(0)
    if kind in ("at rest", "general") and rng.random() < 0.5:
        half = [[fraction(rng) for _ in range(3)] for _ in range(3)]
        Q = [[half[i][j] + half[j][i] for j in range(3)] for i in range(3)]
    if kind == "equal moments":
        moments[1] = moments[0]
        if rng.random() < 0.3:
            sigma = -omega**2 * moments[0]                     # a circle of them
    if kind == "b = 0":
        sigma = -omega**2 * moments[rng.randrange(3)]
    if kind in ("fold", "level"):
        return _meeting(rng, kind, k, omega)
    along = [omega**2 * i * x + sigma * x - sum(q * z for q, z in zip(row, k))
             for i, x, row in zip(moments, k, Q)]
    if kind == "k along c":
        gamma = fraction(rng) or F(1)
        c = [gamma * x for x in k]
        return moments, [(x - b) / omega for x, b in zip(c, along)], c, Q, omega, k
    if kind == "l along c":
        if rng.random() < 0.2:                                 # b = 0: the principal axes
            return moments, rotor, [omega * l for l in rotor], Q, omega, [F(0), F(0), F(1)]
        part = fraction(rng)
        if part * omega == 1:
            return _drawn(rng, kind)
        c = [b / (1 - part * omega) for b in along]
        return moments, [part * x for x in c], c, Q, omega, k
    return moments, rotor, [b + omega * l for b, l in zip(along, rotor)], Q, omega, k


def _meeting(rng, kind, k, omega):
    d = [fraction(rng) or F(1) for _ in range(3)]
    if kind == "fold":
        rest = k[0]**2 / d[0] + k[1]**2 / d[1]
        if not rest:
            return _meeting(rng, kind, k, omega)
        d[2] = -k[2]**2 / rest
        sigma, rotor = min(d) - F(rng.randint(1, 30), 10), [fraction(rng) / 3 for _ in range(3)]
        moments = [(x - sigma) / omega**2 for x in d]
    else:
        t = [fraction(rng) / 3 for _ in range(3)]
        y = [t[1] * k[2] - t[2] * k[1], t[2] * k[0] - t[0] * k[2], t[0] * k[1] - t[1] * k[0]]
        under = k[0]**2 * d[1] * d[2] + k[1]**2 * d[2] * d[0] + k[2]**2 * d[0] * d[1]
        inertia = sum(a * x * x for a, x in zip(d, y)) / under if under else F(0)
        sigma = sum(a * x * x for a, x in zip(d, k)) - omega**2 * inertia
        moments = [(x - sigma) / omega**2 for x in d]
        if min(*moments, inertia) <= 0:
            return _meeting(rng, kind, k, omega)
        across, along = [k[1] * y[2] - k[2] * y[1], k[2] * y[0] - k[0] * y[2], k[0] * y[1] - k[1] * y[0]], \
            fraction(rng)
        rotor = [x + along * z - 2 * omega * i * z for x, z, i in zip(across, k, moments)]
    if len(set(moments)) < 3:
        return _meeting(rng, kind, k, omega)
    c = [omega**2 * i * x + omega * l + sigma * x for i, x, l in zip(moments, k, rotor)]
    return moments, rotor, c, NOTHING, omega, k
