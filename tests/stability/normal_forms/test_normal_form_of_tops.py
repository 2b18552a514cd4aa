"""The normal form of a sleeping top against the action of its nutation, an integral."""
import pytest
from mpmath import log, mp, mpf, pi, polyroots, quad, sin, sqrt
from sympy import Rational

import gyrostat as gs

DIGITS = 30
E1 = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(
    lambda k3: gs.symbol("a") * k3 + gs.symbol("b") * k3**2 + gs.symbol("e") * k3**3))))
TOPS = [  # gyroscopic with l = 0, with a rotor; a minimum, with a rotor
    {"I1": 1, "I3": "1/2", "l": 0, "a": 2, "b": "1/3", "e": "-1/5", "pi3_0": 4},
    {"I1": "3/2", "I3": 2, "l": 1, "a": 1, "b": "-1/4", "e": "2/3", "pi3_0": 4},
    {"I1": 1, "I3": "3/2", "l": 0, "a": -1, "b": "1/2", "e": "-1/3", "pi3_0": 1},
    {"I1": 2, "I3": 1, "l": "1/2", "a": -2, "b": "1/5", "e": "-1/7", "pi3_0": "3/2"},
]


def nutation(values, energy, d):
    """∮ p dθ/2π at M·k = pi3_0 + l and M·e3 = d, the energy that of the sleeping top and some more."""
    I1, I3, l, a, b, e, spin = (mpf(Rational(values[name]).p) / Rational(values[name]).q
                                for name in ("I1", "I3", "l", "a", "b", "e", "pi3_0"))
    c = spin + l
    rest = energy + spin**2 / (2 * I3) + a + b + e - (d - l) ** 2 / (2 * I3)
    # f = 2 I1 (rest − U)(1 − z²) − (c − d z)², by falling powers of z
    f = [0, 0, 0, -(d**2), 2 * c * d, -(c**2)]
    for n, x in enumerate((-e, -b, -a, rest)):
        f[n] -= 2 * I1 * x
        f[n + 2] += 2 * I1 * x
    roots = polyroots(f, maxsteps=200, extraprec=200)
    low, high = sorted(sorted((z.real for z in roots if abs(z.imag) < mpf(10) ** (5 - DIGITS)),
                              key=lambda z: abs(1 - z))[:2])
    others = [z for z in roots if z not in (low, high)]
    middle, half = (low + high) / 2, (high - low) / 2

    def integrand(phi):
        z = middle + half * sin(phi)
        product = -f[0]
        for root in others:
            product *= z - root
        # √f = half cos φ √product
        return (half * mp.cos(phi)) ** 2 * sqrt(product.real) / (1 - z * z)
    return quad(integrand, [-pi / 2, 0, pi / 2]) / pi


@pytest.mark.slow
@pytest.mark.parametrize("values", TOPS, ids=str)
def test_errors_of_degree_2_4_6_fall_as_they_should(values):
    """With J1 = 2ε, J2 = ε and M·e3 off by J1 − J2, to degree 2, 4, 6 as ε², ε³, ε⁴."""
    form = E1.normal_form(values, 6)
    with mp.workdps(DIGITS):
        w1, w2 = (mpf(str(w.evalf(40))) for w in form.frequencies)
        level = mpf(str((Rational(values["pi3_0"]) + Rational(values["l"])).evalf(40)))
        errors = {}
        for size in (level / 200, level / 400):
            J1, J2 = 2 * size, size
            h, energies = J1 * w1 + J2 * w2, []
            for half in (1, 2, 3):
                h += sum(mpf(str(x.evalf(40))) * J1**m * J2**n
                         for m, n, x in form.coefficients if m + n == half)
                energies.append(h)
            steps = J1 - J2, J2 - J1
            errors[size] = [min(abs(nutation(values, energy, level + step) - J2) for step in steps)
                            for energy in energies]
        orders = [log(a / b, 2) for a, b in zip(*errors.values())]
    assert orders == pytest.approx([2, 3, 4], abs=0.2)
