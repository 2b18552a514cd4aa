"""Motions of a body of revolution in U(k3), ours and by Taylor series."""
from fractions import Fraction
from functools import cache

import mpmath
import numpy as np
import oracle
from slow import slow
from sympy import Expr, Rational, cos, exp, log, sin, sqrt

import gyrostat as gs
from gyrostat.trajectories import motion

F = Fraction
TILTED = ("3/5", "0", "4/5")


def reciprocal(x):
    """1/x of a Series."""
    found = oracle.Series(lambda n: 1 / x[0] if n == 0
                          else -sum(x[i] * found[n - i] for i in range(1, n + 1)) / x[0])
    return found


def shifted(z):
    return z + oracle.constant(mpmath.mpf(2))


# U as a function of k3 for us, U′ as a series for the oracle
FIELDS = {"exp": (exp, lambda z: z.exp()), "falling exp": (lambda z: exp(-z),
                                                           lambda z: z.scaled(-1).exp().scaled(-1)),
          "log": (lambda z: log(z + 2), lambda z: reciprocal(shifted(z))),
          "pole": (lambda z: 1 / (z + 2), lambda z: reciprocal(shifted(z) * shifted(z)).scaled(-1))}


def field(U):
    """Of a name, or of the coefficients of a polynomial, of k3 first."""
    if isinstance(U, str):
        return FIELDS[U]
    terms = [(F(c), (0, 0, n)) for n, c in enumerate(U, 1)]
    return (lambda z: sum(Rational(c) * z**n for c, (_, _, n) in terms)), terms


def plain(values):
    return np.array([[float(x) for x in row] if isinstance(row, list) else float(row) for row in values])


def expression(x):
    return x if isinstance(x, Expr) else Rational(F(x))


def moving(inertia, l, U, state, precision=None):
    """The motion of a body with moments I1, I3, each made once."""
    return made(tuple(inertia), l, U if isinstance(U, str) else tuple(U), tuple(state), precision)


@cache
def made(inertia, l, U, state, precision):
    I1, I3 = map(expression, inertia)
    scene = gs.assemble(gs.Gyrostat((I1, I1, I3), (0, 0, expression(l))), gs.axial_potential(field(U)[0]))
    return motion(scene, [expression(x) for x in state], precision=precision)


def number(x):
    """For the oracle."""
    return mpmath.mpf(str(x.evalf(45))) if isinstance(x, Expr) else F(x)


def theirs(inertia, l, U, state, t, digits=15, attitude=None):
    """The state by Taylor series."""
    with mpmath.workdps(digits + 15):
        I1, I3 = map(number, inertia)
        return oracle.taylor_motion((I1, I1, I3), (0, 0, number(l)), [number(x) for x in state], number(t),
                                    field(U)[1], digits, attitude)


def as_mpf(x):
    return mpmath.mpf(x.numerator) / x.denominator


def off(found, expected):
    """The largest difference, in units of the largest component or 1."""
    expected = plain(expected)
    return np.abs(found - expected).max() / max(1.0, np.abs(expected).max())


BODY, LONG, GENERAL = ("1", "3/5"), ("2", "7/2"), ("3/10", "-1/5", "3/2", *TILTED)
MOTIONS = {                                                # moments, l, U, state, time, route
    "degree 1": (BODY, "2/5", ("3/2",), GENERAL, "3/4", "elliptic"),
    "degree 1 falling": (LONG, "-1/2", ("-7/4",), GENERAL, "-1", "elliptic"),
    "degree 2": (BODY, "2/5", ("1", "1/2"), GENERAL, "3/4", "elliptic"),
    "degree 2 between": (BODY, "1/5", ("1/4", "-2"), ("-1", "2", "1", "5/13", "-12/13", "0"), "1",
                         "elliptic"),
    "degree 3": (BODY, "2/5", ("1", "-1/3", "1/2"), GENERAL, "3/4", "quadrature"),
    "degree 4": (LONG, "1", ("0", "-1/2", "1/3", "1"), GENERAL, "-5/4", "quadrature"),
    "degree 6": (BODY, "2/5", ("1/2", "0", "0", "0", "0", "1/3"), GENERAL, "3/4", "quadrature"),
    "exp": (BODY, "2/5", "exp", GENERAL, "3/4", "quadrature"),
    "log": (LONG, "2/5", "log", GENERAL, "-3/4", "quadrature"),
    "pole of U": (BODY, "-1", "pole", GENERAL, "3/4", "quadrature"),
    "irrational": (("1", sqrt(2)), sqrt(3) / 2, ("3/2", "1/4"),
                   ("1/3", sqrt(2) / 3, "1", sqrt(3) / 2, "0", "1/2"), "3/4", "elliptic"),
    "tilt in radians": (BODY, "2/5", ("3/2",),
                        ("3/10", "-1/5", "3/2", "0", sin(Rational(1, 20)), cos(Rational(1, 20))), "1",
                        "elliptic"),
    "at the lower turning point": (BODY, "2/5", ("1/2",), ("1", "0", "3/2", *TILTED), "3/4", "elliptic"),
    "at the upper turning point": (BODY, "2/5", ("3/2",), ("3", "0", "3/2", *TILTED), "3/4", "elliptic"),
    "at the lower turning point of degree 3": (BODY, "2/5", ("-1", "0", "1/2"), ("1/2", "0", "3/2", *TILTED),
                                               "1", "quadrature"),
    "at the lower turning point of degree 6": (BODY, "2/5", ("1", "0", "0", "0", "0", "1"),
                                               ("0", "2", "1", "0", "3/5", "-4/5"), "1",
                                               "quadrature"),
    "at a turning point in exp": (BODY, "2/5", "exp", ("3", "0", "3/2", *TILTED), "3/4", "quadrature"),
    "at the other turning point in exp": (BODY, "2/5", "exp", ("1", "0", "3/2", "3/5", "0", "-4/5"), "3/4",
                                          "quadrature"),
    "at the lower turning point in the equator": (BODY, "2/5", ("2",),
                                                  ("6/5", "8/5", "3/2", "3/5", "4/5", "0"), "3/4",
                                                  "elliptic"),
    "at the upper turning point in the equator": (BODY, "2/5", ("2", "0", "1"),
                                                  ("3/5", "4/5", "3/2", "3/5", "4/5", "0"), "3/4",
                                                  "quadrature"),
    "at rest": (BODY, "2/5", ("3/2",), ("0", "0", "3/2", *TILTED), "3/4", "elliptic"),
    "from the upper pole": (BODY, "2/5", ("3/2",), ("1/2", "-1/3", "1", "0", "0", "1"), "3/4", "elliptic"),
    "from the lower pole": (BODY, "2/5", ("3/2",), ("1/2", "-1/3", "1", "0", "0", "-1"), "3/4", "elliptic"),
    "from the upper pole, pair": (BODY, "-3", ("1", "-1", "1/2"), ("1", "2", "1", "0", "0", "1"), "3/4",
                                  "quadrature"),
    "from the lower pole, pair": (("1/2", "11/8"), "0", ("1/4", "-1", "-1/2", "-1"),
                                  ("-1", "-5/2", "19/8", "0", "0", "-1"), "1/2",
                                  "quadrature"),
    "from the lower pole, another pair": (("13/4", "11/8"), "-3/2", ("-5/4", "-2", "1/4"),
                                          ("-23/8", "1/8", "-15/8", "0", "0", "-1"),
                                          "-11/8", "quadrature"),
    "from the upper pole in exp": (BODY, "2/5", "exp", ("1/2", "-1/3", "1", "0", "0", "1"), "3/4",
                                   "quadrature"),
    "from the lower pole in exp": (BODY, "2/5", "exp", ("1/2", "-1/3", "1", "0", "0", "-1"), "-3/4",
                                   "quadrature"),
    "through the upper pole": (BODY, "2/5", ("3/2",), ("7/15", "2", "1", *TILTED), "3/4", "elliptic"),
    "through the upper pole, P < 0": (BODY, "-12/5", ("3/2",), ("-7/15", "2", "1", *TILTED), "3/4",
                                      "elliptic"),
    "through the lower pole": (BODY, "2/5", ("3/2",), ("-21/5", "-1/2", "1", *TILTED), "3/4", "elliptic"),
    "through the lower pole, P < 0": (BODY, "-12/5", ("3/2",), ("21/5", "-1/2", "1", *TILTED), "-3/4",
                                      "elliptic"),
    "through the lower pole in degree 6": (BODY, "2/5", ("-1", "0", "2", "0", "0", "1"),
                                           ("-21/5", "1/2", "1", *TILTED), "3/4",
                                        "quadrature"),
    "through the upper pole in exp": (BODY, "2/5", "exp", ("7/15", "3", "1", *TILTED), "3/4", "quadrature"),
    "swinging": (BODY, "-1", ("2",), ("0", "1", "1", *TILTED), "5/4", "elliptic"),
    "swinging across k1": (BODY, "-1", ("2",), ("8/15", "-2/5", "1", "3/5", "4/5", "0"), "5/4", "elliptic"),
    "swinging from below": (BODY, "-1", ("2",), ("0", "1", "1", "0", "0", "-1"), "5/4", "elliptic"),
    "over the top": (BODY, "-1", ("2",), ("0", "3", "1", *TILTED), "5/4", "elliptic"),
    "over the top, falling": (BODY, "-1", ("2",), ("0", "-3", "1", *TILTED), "5/4", "elliptic"),
    "over the top from above": (BODY, "-1", ("2",), ("1", "-3", "1", "0", "0", "1"), "5/4", "elliptic"),
    "over the top in degree 3": (BODY, "-1", ("2", "0", "-1/2"), ("0", "3", "1", *TILTED), "5/4",
                                 "quadrature"),
    "over the top in exp": (BODY, "-1", "exp", ("0", "3", "1", *TILTED), "5/4", "quadrature"),
    "between wells of a plane": (BODY, "-1", ("0", "-2"), ("0", "1/2", "1", *TILTED), "5/4", "elliptic"),
    "P = 0, out of the plane": (BODY, "-1", ("2",), ("1", "1/2", "1", *TILTED), "5/4", "elliptic"),
    "v = 0": (BODY, "0", ("1", "1"), ("-4/3", "1/2", "1", *TILTED), "3/4", "elliptic"),
    "negative l and pi3": (BODY, "-7/5", ("3/2",), ("3/10", "-1/5", "-3/2", *TILTED), "3/4", "elliptic"),
    "nearly cancelling momenta": (BODY, "-1.4999999999999", ("3/2",), GENERAL, "3/4", "elliptic"),
    "large cancelling momenta": (BODY, "-1000000", ("3/2",), ("3/10", "-1/5", "1000000.5", *TILTED),
                                 "1/100000", "elliptic"),
    "k of length 5": (BODY, "2/5", ("3/2", "-1/9"), ("3/10", "-1/5", "3/2", "3", "0", "4"), "3/4",
                      "elliptic"),
    "k of length 1/5 in degree 3": (LONG, "2/5", ("3/2", "9", "-20"),
                                    ("3/10", "-1/5", "3/2", "3/25", "0", "-4/25"), "3/4", "quadrature"),
    "k of length sqrt 2 in exp": (BODY, "2/5", "exp", ("3/10", "-1/5", "3/2", "1", "0", "-1"), "3/4",
                                  "quadrature"),
    "k of length 5 from its pole": (BODY, "2/5", ("1/5", "1/9", "1/50"),
                                    ("3/10", "-1/5", "3/2", "0", "0", "5"), "3/4", "quadrature"),
    "nearly equal moments": (("1", "1.000000000001"), "2/5", ("3/2",), GENERAL, "3/4", "elliptic"),
    "equal moments": (("1", "1"), "2/5", ("3/2", "0", "1"), GENERAL, "3/4", "quadrature"),
    "near the upper pole": (BODY, "2/5", ("3/2",), ("0.3", "-0.2", "1.5", "1e-9", "0", "1"), "3/4",
                            "elliptic"),
    "near the lower pole": (BODY, "2/5", ("3/2", "0", "1/4"), ("1e-9", "0", "1.5", "0", "1e-7", "-1"), "3/4",
                            "quadrature"),
    "near the upper pole in exp": (BODY, "2/5", "exp", ("1e-8", "-2e-8", "3", "1e-8", "0", "1"), "3/4",
                                   "quadrature"),
    "no field": (BODY, "2/5", ("0",), GENERAL, "3/4", "elliptic"),
    "weak field": (BODY, "2/5", ("1e-12",), GENERAL, "3/4", "elliptic"),
    "two wells, the upper": (BODY, "0", ("0", "-4", "0", "0"), ("1/10", "1/2", "1/5", *TILTED), "3/4",
                             "elliptic"),
    "two wells, the lower": (BODY, "0", ("1/10", "-4", "1/10", "0"),
                             ("1/10", "1/2", "1/5", "3/5", "0", "-4/5"), "3/4", "quadrature"),
    "two wells, above both": (BODY, "0", ("1/10", "-4", "1/10", "0"),
                              ("1/10", "4", "1/5", "3/5", "0", "-4/5"), "3/4", "quadrature"),
}
# what the others repeat with other numbers
FIRST = ["degree 1", "degree 3", "degree 6", "exp", "pole of U", "irrational", "tilt in radians",
         "at the lower turning point", "at the upper turning point in the equator",
         "at a turning point in exp", "at rest", "from the upper pole", "from the lower pole, pair",
         "from the lower pole in exp", "through the lower pole in degree 6", "through the upper pole",
         "swinging", "over the top", "over the top in exp", "P = 0, out of the plane",
         "large cancelling momenta", "k of length 1/5 in degree 3", "near the lower pole",
         "near the upper pole in exp", "no field", "two wells, the lower"]
CASES = [*FIRST, *slow(*((name,) for name in MOTIONS if name not in FIRST))]
MANY = ["degree 1", "degree 4", "exp", "over the top", "through the lower pole", "k of length 5",
        "from the upper pole"]


def about(angle):
    """Rotation about the third axis."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


# moments 1, 1, 3/5, l = 2/5, k = (3/5, 0, 4/5) or its mirror image: U, state, k3 long before and long after
SEPARATRICES = {
    "sleeping top": (("5",), ("1", "1", "13/5", *TILTED), (1, 1)),
    "sleeping top, falling": (("5",), ("1", "-1", "13/5", *TILTED), (1, 1)),
    "sleeping top of degree 3": (("29/5", "-9/5", "1"), ("1", "1", "13/5", *TILTED), (1, 1)),
    "hanging": (("-5",), ("1", "1", "-17/5", "3/5", "0", "-4/5"), (-1, -1)),
    "pendulum": (("5/2",), ("0", "1", "-2/5", *TILTED), (1, 1)),
    "pendulum between its poles": (("0", "1"), ("0", "6/5*sqrt(1/2)", "-2/5", *TILTED), (-1, 1)),
    "sleeping top in exp": ("exp", ("1/3", "sqrt(2*(exp(1) - exp(4/5)) - 1/9)", "3/5", *TILTED), (1, 1)),
    "hanging in exp": ("falling exp", ("1/3", "-sqrt(2*(exp(1) - exp(4/5)) - 1/9)", "-7/5", "3/5", "0",
                                       "-4/5"), (-1, -1)),
    "falling between the poles": (("0", "1"), ("0", "-6/5*sqrt(1/2)", "-2/5", *TILTED), (1, -1)),
}
