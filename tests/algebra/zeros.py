"""Real roots by mpmath, and numbers to many digits."""
import mpmath
from sympy import expand

import gyrostat as gs

x, k3 = gs.symbol("x"), gs.symbol("k3")


def digits(number, n=60):
    """A number to n digits, of mpmath."""
    return mpmath.mpf(str(number.evalf(n)))


def real_zeros(expression):
    """The real roots of a polynomial by mpmath, to 50 digits.

    For roots that are distinct and not close together.
    """
    with mpmath.workdps(80):
        terms = {n: expand(expression).coeff(x, n) for n in range(9)}
        coefficients = [mpmath.mpf(str(c.evalf(80))) for _, c in sorted(terms.items(), reverse=True)]
        while not coefficients[0]:
            coefficients.pop(0)
        found = mpmath.polyroots(coefficients, maxsteps=400, extraprec=400)
        return sorted(mpmath.re(r) for r in found if abs(mpmath.im(r)) < mpmath.mpf(10) ** -50)


def agree(ours, theirs):
    """Whether two lists of numbers are the same to 45 digits: both are computed to 50 or more."""
    with mpmath.workdps(80):
        return len(ours) == len(theirs) and all(abs(digits(a) - b) < mpmath.mpf(10) ** -45
                                                for a, b in zip(ours, theirs))
