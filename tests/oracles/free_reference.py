"""Independent reference.

Euler's equations of a free gyrostat by Taylor series in whole numbers, steps and order fixed.
"""
from fractions import Fraction
from operator import mul


def motion(inertia, rotor, momentum, until, steps, rows=(), order=30, bits=256):
    """M, and vectors fixed in space, in body components at a time: v' = v × ω, ωᵢ = (Mᵢ − lᵢ)/Iᵢ.

    Fractions in, Fractions out.
    """
    one, step = 1 << bits, Fraction(until) / steps
    whole = [[round(Fraction(x) * one) for x in v] for v in (momentum, *rows)]
    l, rates = [round(Fraction(x) * one) for x in rotor], [round(step / Fraction(x) * one) for x in inertia]
    for _ in range(steps):
        vectors = [[[x] for x in v] for v in whole]
        omega = [[(x - y) * r >> bits] for x, y, r in zip(whole[0], l, rates)]
        for n in range(1, order + 1):
            w1, w2, w3 = (w[::-1] for w in omega)
            for v1, v2, v3 in vectors:
                first = sum(map(mul, v2, w3)) - sum(map(mul, v3, w2))
                second = sum(map(mul, v3, w1)) - sum(map(mul, v1, w3))
                v3.append((sum(map(mul, v1, w2)) - sum(map(mul, v2, w1))) // n >> bits)
                v1.append(first // n >> bits)
                v2.append(second // n >> bits)
            for w, m, r in zip(omega, vectors[0], rates):
                w.append(m[-1] * r >> bits)
        whole = [[sum(x) for x in v] for v in vectors]
    return [[Fraction(x, one) for x in v] for v in whole]
