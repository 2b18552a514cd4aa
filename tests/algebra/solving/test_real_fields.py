"""Numbers in the field of a real root: enclosures without expressions, and the expressions."""
import pickle

from flint import fmpq_poly
from sympy import S, sqrt

from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.solving.real_fields import Conjugates, FieldNumbers


def test_enclosures_are_those_of_the_expressions():
    """Of a cubic with three real roots, and a surd whose formula gives them in the other order."""
    for coefficients in ([1, -3, 0, 1], [-1, 1, 1], [1, 2, -3]):
        tops, under = [fmpq_poly([0, 1]), fmpq_poly([5, 0, 1])], fmpq_poly([7, 2])
        field = Conjugates(fmpq_poly(coefficients), tops, under)
        last = None
        for n, root in enumerate(field.roots()):
            assert last is None or root > last
            last, numbers = root, FieldNumbers(field, n, [(0, S.One), (1, sqrt(3)), (0, -S.One)])
            for x, enclosed in zip(numbers, numbers.balls(192)):
                assert ball(x, 256).overlaps(enclosed) and enclosed.rad() < 1e-40
            assert len(numbers) == 3 and numbers[2] == -numbers[0]
            assert numbers[1:].over(S(2))[0] == numbers[1] / 2


def test_pickled_as_expressions():
    """What python-flint has is not pickled."""
    field = Conjugates(fmpq_poly([-2, 0, 1]), [fmpq_poly([0, 1])], fmpq_poly([1]))
    numbers = FieldNumbers(field, 1, [(0, S.One)])
    assert pickle.loads(pickle.dumps(numbers)) == tuple(numbers)


def test_equal_where_they_are_defined_alike_or_their_expressions_are_equal():
    """Two fields of one polynomial are one; another root, another place or another factor is not equal."""
    one, two = (Conjugates(fmpq_poly([-2, 0, 1]), [fmpq_poly([0, 1]), fmpq_poly([3])], fmpq_poly([1]))
                for _ in range(2))
    numbers = FieldNumbers(one, 1, [(0, S.One)])
    assert numbers == FieldNumbers(two, 1, [(0, S.One)]) and numbers == (sqrt(2),)
    assert hash(numbers) == hash(FieldNumbers(two, 1, [(0, S.One)]))
    for other in (FieldNumbers(two, 0, [(0, S.One)]), FieldNumbers(two, 1, [(1, S.One)]),
                  FieldNumbers(two, 1, [(0, S(2))]), (), "x"):
        assert numbers != other
    # a quotient that is written otherwise
    doubled = Conjugates(one.polynomial, [fmpq_poly([0, 2])], fmpq_poly([2]))
    assert numbers == FieldNumbers(doubled, 1, [(0, S.One)])
