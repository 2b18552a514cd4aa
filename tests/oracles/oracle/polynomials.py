"""Polynomials over the rationals, the reduced motion among them: values, derivatives, roots."""
from fractions import Fraction


def polynomial(coefficients, z):
    """a0 + a1 z + a2 z² + …"""
    value = 0 * z
    for a in reversed(coefficients):
        value = value * z + a
    return value


def product(a, b):
    """Coefficients of the product of two polynomials."""
    c = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def quotient(a, b, order):
    """Power series a / b up to the given order.

    If b begins later than with its constant, so does a.
    """
    start = next(i for i, y in enumerate(b) if y)
    assert not any(a[:start])
    a, b = list(a[start:]) + [0] * (order + 1), b[start:]
    c = []
    for n in range(order + 1):
        c.append((a[n] - sum(b[j] * c[n - j] for j in range(1, min(n, len(b) - 1) + 1))) / b[0])
    return c


def expand(coefficients, z, sigma):
    """Coefficients in y of a polynomial in z + sigma y."""
    c = list(coefficients)
    for i in range(len(c)):
        for j in reversed(range(i, len(c) - 1)):
            c[j] += z * c[j + 1]
    return [a * sigma**i for i, a in enumerate(c)]


def reduced_motion(I1, e, v, P, potential):
    """Coefficients of g = 2 I1 (e − U)(1 − z²) − (v − P z)², all of them.

    I1² ż² = g(z) along every motion, z = k3.
    """
    energy = [-a for a in potential]
    energy[0] += e
    g = [2 * I1 * c for c in product(energy, [1, 0, -1])]
    for i, c in enumerate(product([v, -P], [v, -P])):
        g[i] -= c
    return g


def taylor(g, z):
    """Coefficients in x of a polynomial in z + x, by repeated synthetic division.

    Whole numbers stay whole.
    """
    rest, found = list(reversed(g)), []
    while rest:
        carry, quotients = 0, []
        for c in rest:
            carry = carry * z + c
            quotients.append(carry)
        found.append(quotients.pop())
        rest = quotients
    return found


def moves_away(g, z, sides):
    """Whether x² = g(x) has motions that leave its rest point z on a side.

    That is, g > 0 beside z, or g = 0 everywhere.
    """
    rest = list(reversed(g))
    for n in range(len(g)):
        carry, quotients = 0, []
        for c in rest:
            carry = carry * z + c
            quotients.append(carry)
        first, rest = quotients.pop(), quotients
        if first:
            assert n >= 2                              # a rest point is a double root
            return any(first * side**n > 0 for side in sides)
    return True


def whole_motion(A, W, P, B, m, q, r):
    """g at z = y/q in powers of y, times (d r q⁴)², in whole numbers; U has six coefficients.

    I1 = A/d, ω·k = W/r, π3 + l = P/(d r q), U = (B1 z + … + B6 z⁶)/d, k3 = m/q; the state is π1 = I1 ω k1, π2
        = k2 = 0, with
    k1² = 1 − k3², hence 2 I1 e = I1² ω² k1² + 2 I1 U(k3), v = I1 ω k1² + P k3.
    """
    across = q * q - m * m
    V = A * W * across + P * m
    energy = [0] * 7
    for n, b in enumerate(B, 1):
        energy[n] = -b * q ** (6 - n)
    energy[0] = -polynomial(energy, m)
    twice = 2 * A * r * r
    whole = [twice * c for c in energy]
    whole[0] += A * A * W * W * across * q**4
    g = [q * q * c for c in whole] + [0, 0]
    for n, c in enumerate(whole, 2):
        g[n] -= c
    scale = q**4
    g[0] -= scale * V * V
    g[1] += scale * 2 * V * P
    g[2] -= scale * P * P
    return g


def slope(f):
    """Coefficients of the derivative of a polynomial."""
    return [n * c for n, c in enumerate(f)][1:]


def _trimmed(f):
    f = list(f)
    while f and not f[-1]:
        f.pop()
    return f


def _division(a, b):
    """Quotient and remainder of polynomials over the rationals."""
    a, q = _trimmed(a), [Fraction(0)] * max(len(a) - len(b) + 1, 0)
    while len(a) >= len(b):
        shift, factor = len(a) - len(b), Fraction(a[-1]) / b[-1]
        q[shift] = factor
        a = _trimmed([x - factor * b[i - shift] if i >= shift else x for i, x in enumerate(a)][:-1])
    return q, a


def count_roots(f, low=None, high=None):
    """Number of distinct real roots of a polynomial over the rationals in an open interval, by Sturm's
    theorem.
    """
    f = _trimmed(f)
    a, b = f, _trimmed(slope(f))
    while b:
        a, b = b, _division(a, b)[1]
    f = _division(f, a)[0]                             # each root once
    chain = [f, slope(f)]
    while _trimmed(chain[-1]):
        chain.append([-c for c in _division(chain[-2], chain[-1])[1]])

    def changes(x, side):
        values = [polynomial(g, x) if x is not None else g[-1] * side ** (len(g) - 1)
                  for g in map(_trimmed, chain) if g]
        signs = [v > 0 for v in values if v]
        return sum(s != t for s, t in zip(signs, signs[1:]))

    return changes(low, -1) - changes(high, 1) - (high is not None and polynomial(f, high) == 0)


def level_slope(I1, P, v, potential):
    """I1 (1 − z²)² V' of the effective potential V = U + (v − P z)²/(2 I1 (1 − z²)), as coefficients."""
    across = product([1, 0, -1], [1, 0, -1])
    first, second = [I1 * c for c in product(across, slope(potential) or [0])], product([v, -P], [-P, v])
    return [(first[n] if n < len(first) else 0) + (second[n] if n < len(second) else 0)
            for n in range(max(len(first), 3))]


def rate_slope(I1, I3, l, omega, potential):
    """U' − ω l + ω² z (I1 − I3), what vanishes on E3, as coefficients."""
    f = [*slope(potential), 0, 0]
    f[0] -= omega * l
    f[1] += omega**2 * (I1 - I3)
    return f
