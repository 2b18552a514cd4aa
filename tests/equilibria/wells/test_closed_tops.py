"""Wells of tops in closed form: E1, E2 and E3, with and without damping, against lines that are filled up."""
from random import Random

import numpy as np
import pytest
from filled_line import Line, greatest_angle
from sympy import Poly, Rational, S, oo, rad

import gyrostat as gs
from gyrostat.equilibria.wells.closed_forms import THETA, Z, closed_forms


def fraction(random, low, high, d):
    return Rational(random.randint(low * d, high * d), d)


def named(form, numbers):
    """A form at numbers, by name."""
    return form.at({gs.symbol(name): S(x) for name, x in numbers.items()})


def solved(form, k3=None):
    """The barrier with the root inserted that the form names; of the two next to k3 the lower barrier."""
    roots = [z for z in Poly(form.equation, Z).nroots(n=40) if z.is_real and abs(z) < 1]
    which = form.root.split()[1]
    if form.root.startswith("the one between 0"):
        end = int(form.root.split()[-1])
        [beside] = [[z] for z in roots if end * z > 0]
    elif which in ("greatest", "least"):
        beside = roots[-1:] if which == "greatest" else roots[:1]
    else:
        low, high = ([z for z in roots if t * (z - k3) > 1e-12] for t in (-1, 1))
        beside = [*low[-1:], *high[:1]]
    return min((form.barrier.xreplace({Z: z}) for z in beside), default=oo)


def agree(exact, number, scale=1):
    return exact == number if np.isinf(number) else abs(float(exact) - number) < 1e-7 * scale


TOPS = [(s, damped, degree) for s in (1, -1) for damped in (False, True) for degree in (1, 2, 3)]


@pytest.mark.few(12)
@pytest.mark.parametrize("seed", range(48))
def test_a_top_against_a_filled_line(seed):
    """E1 and E2, U linear and not, with the kick within an angle, and those under damping."""
    (s, damped, degree), random = TOPS[seed // 4], Random(seed)
    names = [gs.symbol(name) for name in ("a", "b", "c")][:degree]
    U = gs.axial_potential(sum(x * gs.symbol("k3")**n for n, x in enumerate(names, 1)))
    body = gs.Gyrostat(("I1", "I1", "I3"), (0, 0, 0)) if damped else gs.symmetric_gyrostat()
    scene = gs.assemble(body, U)
    forms = closed_forms(gs.upright(scene) if s == 1 else gs.hanging(scene))
    assert len(forms) == (2 if damped and degree == 1 else 1)
    while True:
        I1, I3, pi3 = (fraction(random, 1, 3, 4) for _ in range(3))
        l = S.Zero if damped else fraction(random, -1, 1, 4)
        slopes = [fraction(random, -2, 2, 4) for _ in names]
        numbers = dict(zip("abc", slopes)) | {"I1": I1, "I3": I3, "pi3_0": pi3, "l": l}
        if I3 > 2 * I1 or not pi3 + l or None in (there := [named(form, numbers) for form in forms]):
            continue
        line = Line([0, *slopes], I1, I3, l, s * (pi3 + l), pi3)
        if degree == 1:
            angle = random.randint(1, 170)
            kick = there[0].kick.xreplace({THETA: rad(angle)})
            assert there[0].barrier == oo
            assert agree(kick**2 / (2 * I1), line.within(s, np.radians(angle)), 1e3)
        else:
            assert agree(solved(there[0]), line.rise(s)[0])
        if len(there) == 2:
            assert agree(solved(there[1]), Line([0, *slopes], I1, I3, 0, s * pi3).rise(s)[0])
        return


@pytest.mark.few(6)
@pytest.mark.parametrize("seed", range(30))
def test_inclined_rotations_against_a_filled_line(seed):
    """E3 in U = a k3 + b k3² + c k3³ at a tilt and a rate."""
    random, z = Random(seed), gs.symbol("k3")
    a, b, c = map(gs.symbol, "abc")
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(a*z + b*z**2 + c*z**3))
    [form] = closed_forms(gs.inclined(scene))
    while True:
        I1, I3 = fraction(random, 1, 3, 4), fraction(random, 1, 3, 4)
        U = [fraction(random, -6, 6, 4) for _ in range(3)]
        k3, omega = Rational(random.randint(-7, 7), 8), fraction(random, -2, 2, 4)
        if not omega or I3 > 2 * I1:
            continue
        there = named(form, dict(zip("abc", U)) | {"I1": I1, "I3": I3, "k3": k3, "omega": omega})
        if there is not None:
            break
    slope = sum((n + 1) * u * k3**n for n, u in enumerate(U))
    total = (slope + I1 * k3 * omega**2) / omega
    spin = I3 * omega * k3
    line = Line([0, *U], I1, I3, total - spin, I1 * omega * (1 - k3**2) + total * k3, spin)
    assert agree(solved(there, k3), line.rise(float(k3))[0])


def test_kicks_are_those_of_motions():
    """0.99 and 1.01 of the kick of 20°, with the Euler-Poisson equations."""
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    numbers = {"I1": 1, "I3": 1, "m0": 1, "pi3_0": 3, "l": Rational(1, 2)}
    form = named(closed_forms(gs.upright(top))[0], numbers)
    kick = float(form.kick.xreplace({THETA: rad(20)}))
    below, above = (greatest_angle([0, 1], 1, 1, 0.5, 3, x * kick, 10) for x in (0.99, 1.01))
    assert 19.5 < below < 20 < above < 20.5
