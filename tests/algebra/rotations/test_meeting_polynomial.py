"""The values of a parameter at which critical points of a quartic form meet."""
from fractions import Fraction
from math import prod
from random import Random

import pytest
from flint import fmpq_poly

from gyrostat.algebra.rotations.bounds import LINES, bounded
from gyrostat.algebra.rotations.meeting_polynomial import MeetingPolynomial
from gyrostat.algebra.rotations.modular_fractions import by_residues
from gyrostat.algebra.rotations.quartic_forms import QuarticForm, quartic


def gravity(moments, rotor):
    """V N² of a satellite, times 2, for a rotor along axis 2."""
    terms = {(0, 1, 0, 0, 0, 0): -2 * rotor} if rotor else {}
    for i, x in enumerate(moments):
        terms[(*(2 * (n == i) for n in range(3)), 0, 0, 0)] = -x
        terms[(0, 0, 0, *(2 * (n == i) for n in range(3)))] = 3 * x
    return quartic(terms)


def bound_at(form):
    """The bound for the number of critical points."""
    return next(filter(None, (bounded(QuarticForm(form), lines) for lines in LINES)))


def found(form):
    """The polynomial for a form that is linear in a number."""
    fixed, whole = form(0), form(1)
    slope = {e: whole[e] - fixed[e] for e in fixed}
    return MeetingPolynomial([fixed, slope], bound_at(form(1234567))).bare


def product(factors):
    """The monic product of polynomials, each by its coefficients from the constant one up."""
    whole = prod(map(fmpq_poly, factors), start=fmpq_poly([1]))
    return whole / whole[whole.degree()]


@pytest.mark.slow
def test_those_of_a_rotor_along_an_axis():
    """l² is a², b², 16 a², 16 b² and 4 a b, with a = I1 − I2 and b = I3 − I2; simple roots, and no others."""
    squares = 25, 49, 16 * 25, 16 * 49, 4 * 5 * 7
    assert found(lambda l: gravity((20, 15, 22), l)) == product([-x, 0, 1] for x in squares)


@pytest.mark.slow
def test_those_of_a_moment():
    """The same equations, solved for I2 with l = 3; and I2 = I1, I3, where complex ones go to N = 0."""
    pairs = [(20, 1), (20, 4), (32, 1), (32, 4)]           # k² (I − I2)² = 9
    meet = [[k**2 * I**2 - 9, -2 * k**2 * I, k**2] for I, k in pairs]
    curve = [4 * 20 * 32 - 9, -4 * (20 + 32), 4]
    assert found(lambda I2: gravity((20, I2, 32), 3)) == product([*meet, curve, [-20, 1], [-32, 1]])
    for I2 in (20, 32):
        assert bound_at(gravity((20, I2, 32), 3)).most < bound_at(gravity((20, 25, 32), 3)).most


def test_fractions_by_residues():
    """As they were, long ones too; residues that are refused, or too few, are left out."""
    draw = Random(3)
    several = [Fraction(draw.randint(-10**n, 10**n), draw.randint(1, 10**n)) for n in (1, 30, 90)]
    asked = []

    def residues(p):
        asked.append(p)
        if len(asked) < 3:
            return [[1], None][len(asked) - 1]
        return [x.numerator * pow(x.denominator, -1, p) % p for x in several]

    assert by_residues(residues) == several
    assert len(asked) > 180 / 18 and len(set(asked)) == len(asked)


def test_residues_of_no_fractions():
    """None, after a limit: what has other residues modulo each prime is no list of fractions."""
    draw = Random(5)
    assert by_residues(lambda p: [draw.randrange(p)]) is None
