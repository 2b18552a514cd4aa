"""Tests the separatrix of a free body against Euler's equations."""
import mpmath

from .counterexample import DIGITS


def separatrix_residual() -> mpmath.mpf:
    """Return how far (a sech, tanh, c sech)(μt) is from Euler's equations, at three times.

    The body has I = (1, 2, 3), and abs(M)² = 1 = 2 E I2.
    """
    mp = mpmath
    with mp.workdps(DIGITS):
        low, high, whole = mp.mpf(1) / 2, mp.mpf(1) / 6, mp.mpf(2) / 3
        a, c, mu = mp.sqrt(high / whole), mp.sqrt(low / whole), mp.sqrt(low * high)

        def M(t: mpmath.mpf) -> list[mpmath.mpf]:
            return [a * mp.sech(mu * t), mp.tanh(mu * t), c * mp.sech(mu * t)]

        worst = mp.mpf(0)
        for t in (mp.mpf("0.3"), mp.mpf(1), mp.mpf(-2)):
            x = M(t)
            rates = [-x[1] * x[2] * high, x[2] * x[0] * whole, -x[0] * x[1] * low]
            worst = max(worst, *(abs(mp.diff(lambda s, i=i: M(s)[i], t) - rate)
                                 for i, rate in enumerate(rates)))
        return worst
