"""The values of a parameter at which critical points of a quartic form meet."""
from fractions import Fraction
from random import Random

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


def test_those_of_a_rotor_along_an_axis():
    """l² is a², b², 16 a², 16 b² and 4 a b, with a = I1 − I2 and b = I3 − I2; simple roots, and no others."""
    first, third = 5, 7
    moments = 20, 15, 22
    fixed, whole = gravity(moments, 0), gravity(moments, 1)
    slope = {e: whole[e] - fixed[e] for e in fixed}
    bound = next(filter(None, (bounded(QuarticForm(gravity(moments, 1234567)), lines) for lines in LINES)))
    expected = fmpq_poly([1])
    for square in (first**2, third**2, 16 * first**2, 16 * third**2, 4 * first * third):
        expected *= fmpq_poly([-square, 0, 1])
    assert MeetingPolynomial([fixed, slope], bound).bare == expected


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
