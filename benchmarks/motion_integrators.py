"""The integrators of motion_speed_against_error.py: SciPy's, heyoka's, and Lie-Poisson splittings.

The package gyrostat is not used.
"""
import time
from fractions import Fraction

import numpy as np
from mpmath import cos, mpf, sin, workdps

try:
    import heyoka
except ModuleNotFoundError:
    heyoka = None
try:
    from numba import njit
except ModuleNotFoundError:
    def njit(**_):
        return lambda function: function

SCIPY = {"RK45": (1e-3, 1e-6, 1e-9, 1e-12), "DOP853": (1e-3, 1e-6, 1e-9, 1e-12), "Radau": (1e-3, 1e-6, 1e-9),
         "LSODA": (1e-3, 1e-6, 1e-9, 1e-12)}
HEYOKA = (1e-6, 1e-9, 1e-12, 0.0, "80 bits")               # 0: the rounding unit


class TooLong(Exception):
    """A run was stopped at its limit; the argument is the part of the time span that was done."""


@njit(cache=True)
def field(x, p):
    """π̇ and k̇ in a new array; p holds 1/Iⱼ − 1/Iₖ, 1/I, l and ∇U."""
    w1, w2, w3 = x[0] * p[3], x[1] * p[4], x[2] * p[5]
    out = np.empty_like(x)
    out[0] = p[0] * x[1] * x[2] + p[7] * w3 - p[8] * w2
    out[1] = p[1] * x[2] * x[0] + p[8] * w1 - p[6] * w3
    out[2] = p[2] * x[0] * x[1] + p[6] * w2 - p[7] * w1
    if len(x) == 6:
        k1, k2, k3 = x[3], x[4], x[5]
        out[0] += k2 * p[11] - k3 * p[10]
        out[1] += k3 * p[9] - k1 * p[11]
        out[2] += k1 * p[10] - k2 * p[9]
        out[3] = k2 * w3 - k3 * w2
        out[4] = k3 * w1 - k1 * w3
        out[5] = k1 * w2 - k2 * w1
    return out


def parameters(case):
    rate = [1 / Fraction(i) for i in case.inertia]
    return np.array([float(c) for c in (rate[2] - rate[1], rate[0] - rate[2], rate[1] - rate[0], *rate,
                                        *case.rotor, *case.slope)])


def scipy_run(name, tolerance):
    """SciPy's stepper without the storage of solve_ivp, relative tolerance as given, absolute a thousandth of
    it.
    """
    def prepare(case, t, limit):
        from scipy import integrate
        p, start = parameters(case), np.array(case.state)
        def run():
            stepper = getattr(integrate, name)(lambda _, x: field(x, p), 0.0, start, t, rtol=tolerance,
                                               atol=1e-3 * tolerance)
            end = time.perf_counter() + limit
            while stepper.status == "running":
                stepper.step()
                if time.perf_counter() > end:
                    raise TooLong(stepper.t / t)
            return stepper.y
        return run
    return prepare


def heyoka_stepper(case, tolerance):
    """heyoka's Taylor integrator; its code is compiled, or comes from its cache in memory."""
    number = np.longdouble if tolerance == "80 bits" else float
    tolerance = {"tol": tolerance} if tolerance and number is float else {}
    return heyoka.taylor_adaptive(heyoka_field(case, number), np.array(case.state, number), fp_type=number,
                                  **tolerance)


def forget():
    """Empty heyoka's cache of compiled code, and leave the one on disk alone: what comes next is compiled."""
    if heyoka:
        heyoka.llvm_state.set_diskcache_enabled(False)
        heyoka.llvm_state.clear_memcache()


def heyoka_run(tolerance):
    def prepare(case, t, limit):
        stepper = heyoka_stepper(case, tolerance)
        start = stepper.state.copy()
        def run():
            stepper.time, stepper.state[:] = start.dtype.type(0), start
            stepper.propagate_until(start.dtype.type(t))
            return stepper.state
        return run
    return prepare


def heyoka_grid(case, times):
    """A call for the states at many times, by dense output."""
    stepper = heyoka_stepper(case, 0.0)
    def run():
        stepper.time, stepper.state[:] = 0, case.state
        return stepper.propagate_grid(times)[-1]
    return run


def heyoka_field(case, number):
    """The equations, without the terms that are 0, and with their numbers in the code."""
    p = [number(c.numerator) / number(c.denominator) for c in map(Fraction, case.inertia)]
    rate = [1 / Fraction(i) for i in case.inertia]
    gap = [number(c.numerator) / number(c.denominator)
           for c in (rate[2] - rate[1], rate[0] - rate[2], rate[1] - rate[0])]
    names = ["pi1", "pi2", "pi3", "k1", "k2", "k3"][:len(case.state)]
    x = heyoka.make_vars(*names)
    w, zero = [a / b for a, b in zip(x, p)], heyoka.expression(number(0))
    def scaled(factor, expression):
        return number(factor) * expression if factor else zero
    rates = []
    for i, j, m in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        new = scaled(gap[i], x[j] * x[m]) + scaled(case.rotor[j], w[m]) - scaled(case.rotor[m], w[j])
        rates.append(new if case.free else new + scaled(case.slope[m], x[3 + j])
                     - scaled(case.slope[j], x[3 + m]))
    if not case.free:
        rates += [x[3 + j] * w[m] - x[3 + m] * w[j] for j, m in ((1, 2), (2, 0), (0, 1))]
    return list(zip(x, rates))


def both(outer, inner):
    """Weights of a splitting that reads the same backwards, from the first half.

    The outer part has the middle one.
    """
    return (*outer, *outer[-2::-1]), (*inner, *inner[::-1])


def composed(*weights):
    """Strang's splitting with each of these steps, the last one in the middle."""
    inner = (*weights, *weights[-2::-1])
    return tuple((a + b) / 2 for a, b in zip((0, *inner), (*inner, 0))), inner


# order, steps in a turn of the body, weights of the outer and of the inner part
SPLITTINGS = {
    "Strang": (2, (20, 100, 1000), composed(1.0)),
    "Blanes-Moan": (4, (8, 30, 150), both(                 # J. Comput. Appl. Math. 142 (2002) 313-330, S6
        (0.0792036964311957, 0.353172906049774, -0.0420650803577195, 0.2193769557534996),
        (0.209515106613362, -0.143851773179818, 0.434336666566456))),
    "Kahan-Li": (8, (3, 5, 8, 16, 28), composed(               # Math. Comp. 66 (1997) 1089-1099, 17 stages
        0.13020248308889008087881763, 0.56116298177510838456196441, -0.38947496264484728640807860,
        0.15884190655515560089621075,
        -0.39590389413323757733623154, 0.18453964097831570709183254, 0.25837438768632204729397911,
        0.29501172360931029887096624,
        -0.60550853383003451169892108)),
}


@njit(cache=True)
def of_revolution(x, p, outer, inner, n):
    """n steps for a body of revolution in U = p₁ k3, in a frame that turns with π3/I3 − M3/I1.

    There k̇ = k × M/I1, and Ṁ = k × ∇U.
    """
    I1, g = p
    m1, m2, m3, k1, k2, k3 = x
    for _ in range(n):
        for i in range(len(inner)):
            m1 += outer[i] * g * k2
            m2 -= outer[i] * g * k1
            size = np.sqrt(m1 * m1 + m2 * m2 + m3 * m3)
            half = 0.5 * size * inner[i] / I1
            s, c = np.sin(half), np.cos(half)
            once, twice = 2 * s * c / size, 2 * (s / size) ** 2
            a1, a2, a3 = k2 * m3 - k3 * m2, k3 * m1 - k1 * m3, k1 * m2 - k2 * m1
            k1 += once * a1 + twice * (a2 * m3 - a3 * m2)
            k2 += once * a2 + twice * (a3 * m1 - a1 * m3)
            k3 += once * a3 + twice * (a1 * m2 - a2 * m1)
        m1 += outer[-1] * g * k2
        m2 -= outer[-1] * g * k1
    return np.array([m1, m2, m3, k1, k2, k3])


@njit(cache=True)
def turned(u, v, angle):
    c, s = np.cos(angle), np.sin(angle)
    return u * c + v * s, v * c - u * s


@njit(cache=True)
def of_free_body(x, p, outer, inner, n):
    """n steps for a free body.

    Rotations about the axes, the third one inside, the second one once before and once after it.
    """
    m1, m2, m3 = x
    for _ in range(n):
        before = 0.0
        for i in range(len(inner)):
            after = outer[i] - before
            m2, m3 = turned(m2, m3, outer[i] * m1 * p[0])
            m3, m1 = turned(m3, m1, after * m2 * p[1])
            m1, m2 = turned(m1, m2, inner[i] * m3 * p[2])
            before = inner[i] - after
            m3, m1 = turned(m3, m1, before * m2 * p[1])
        m2, m3 = turned(m2, m3, outer[-1] * m1 * p[0])
    return np.array([m1, m2, m3])


@njit(cache=True)
def of_any_body(x, p, outer, inner, n):
    """n steps for a gyrostat in a uniform field.

    The kick k × ∇U outside, then rotations of M = π + l and k about the axes.
    """
    m1, m2, m3, k1, k2, k3 = x
    r1, r2, r3, l1, l2, l3, g1, g2, g3 = p
    for _ in range(n):
        before = 0.0
        for i in range(len(inner) + 1):
            m1 += outer[i] * (k2 * g3 - k3 * g2)
            m2 += outer[i] * (k3 * g1 - k1 * g3)
            m3 += outer[i] * (k1 * g2 - k2 * g1)
            if i == len(inner):
                break
            after = outer[i] - before
            angle = after * (m1 - l1) * r1
            (m2, m3), (k2, k3) = turned(m2, m3, angle), turned(k2, k3, angle)
            angle = after * (m2 - l2) * r2
            (m3, m1), (k3, k1) = turned(m3, m1, angle), turned(k3, k1, angle)
            angle = inner[i] * (m3 - l3) * r3
            (m1, m2), (k1, k2) = turned(m1, m2, angle), turned(k1, k2, angle)
            before = inner[i] - after
            angle = before * (m2 - l2) * r2
            (m3, m1), (k3, k1) = turned(m3, m1, angle), turned(k3, k1, angle)
            angle = before * (m1 - l1) * r1
            (m2, m3), (k2, k3) = turned(m2, m3, angle), turned(k2, k3, angle)
    return np.array([m1, m2, m3, k1, k2, k3])


def splitting_run(name, per_turn):
    """A splitting with a constant step.

    The turn about axis 3, which commutes with all of it, comes once, at the end.
    """
    def prepare(case, t, limit):
        n = max(round(t / case.turn * per_turn), 1)
        outer, inner = (np.array(weights) * (t / n) for weights in SPLITTINGS[name][2])
        rate, rotor = [1 / i for i in case.inertia], np.array([*case.rotor, 0, 0, 0][:len(case.state)], float)
        start = np.array(case.state) + rotor
        if case.free:
            return lambda: of_free_body(start, np.array(rate), outer, inner, n)
        if not case.revolution:
            p = np.array([*rate, *case.rotor, *case.slope], float)
            return lambda: of_any_body(start, p, outer, inner, n) - rotor
        p, I1, I3 = np.array([case.inertia[0],
                              case.slope[2]]), Fraction(case.inertia[0]), Fraction(case.inertia[2])
        angle = (Fraction(case.state[2]) / I3 - (Fraction(case.state[2]) + Fraction(case.rotor[2]))
                 / I1) * Fraction(t)
        with workdps(50):
            c, s = (float(f(mpf(angle.numerator) / angle.denominator)) for f in (cos, sin))
        def run():
            x = of_revolution(start, p, outer, inner, n)
            for i in (0, 3):
                x[i], x[i + 1] = x[i] * c + x[i + 1] * s, x[i + 1] * c - x[i] * s
            return x - rotor
        return run
    return prepare


def methods():
    """(family, setting) ↦ a function of (case, time, limit in seconds) that prepares a run, a call without
    arguments for the end state.
    """
    found = {}
    if heyoka:
        found = {("heyoka", f"{tol or 2.2e-16:.0e}" if tol != "80 bits" else tol): heyoka_run(tol)
                 for tol in HEYOKA}
    for name, (order, steps, _) in SPLITTINGS.items():
        found |= {(f"{name}, order {order}", f"{n} steps a turn"): splitting_run(name, n) for n in steps}
    return found | {(f"SciPy {name}", f"{tol:.0e}"): scipy_run(name, tol)
                    for name, tolerances in SCIPY.items() for tol in tolerances}
