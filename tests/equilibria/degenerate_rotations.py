"""Free gyrostats drawn so that one of their permanent rotations is degenerate."""
from fractions import Fraction as F

from sympy import Rational


def exact(vector):
    return tuple(Rational(x.numerator, x.denominator) for x in vector)


def drawn(rnd, kind):
    """Moments, rotor, momentum and its length, all rational, of a rotation with Δ = 0; axes in any order.

    With d = 1/I − ν: a fold has Σ M²/d = 0, a pitchfork M₃ = d₃ = 0, an umbilic d₂ M₁² + d₁ M₂² = 0 besides.
    """
    a, b, c, d = (rnd.randint(-4, 4) for _ in range(4))
    if kind == "fold":
        M = [F(a * a + b * b - c * c - d * d), F(2 * (a * d + b * c)), F(2 * (b * d - a * c))]
        size = F(a * a + b * b + c * c + d * d)
    else:
        M, size = [F(a * a - b * b), F(2 * a * b), F(0)], F(a * a + b * b)
    curved = [F(rnd.choice([-1, 1]) * rnd.randint(1, 24), rnd.randint(1, 12)) for _ in range(2)]
    nu = F(rnd.randint(-24, 48), rnd.randint(1, 12))
    rest = M[0]**2 / curved[0] + M[1]**2 / curved[1]
    if not all(M[:2]) or (kind == "fold" and not (M[2] and rest)):
        return drawn(rnd, kind)
    curved.append(-M[2]**2 / rest if kind == "fold" else F(0))
    if kind == "umbilic":
        curved[1] = -curved[0] * (M[1] / M[0])**2
    if min(x + nu for x in curved) <= 0 or len(set(curved)) < 3:
        return drawn(rnd, kind)
    moments = [1 / (x + nu) for x in curved]
    rotor = [(1 - nu * i) * m for i, m in zip(moments, M)]
    order = rnd.sample(range(3), 3)
    return *([v[n] for n in order] for v in (moments, rotor, M)), size
