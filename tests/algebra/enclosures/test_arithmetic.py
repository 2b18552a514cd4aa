"""One walk over an expression, in any arithmetic."""
import operator
from fractions import Fraction
from functools import partial, reduce

import numpy as np
import pytest
from sympy import CRootOf, E, Rational, besselj, exp, pi, sin, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.arithmetic import Arithmetic, in_arithmetic
from gyrostat.algebra.enclosures.floats import in_floats
from gyrostat.algebra.text.bounded_parts import enclosure

x, y = map(gs.symbol, ("x", "y"))


def fractions(values):
    """Exact, of what is rational; a function is written as its name."""
    def leaf(node):
        if node.is_Rational:
            return Fraction(int(node.p), int(node.q))
        return values.get(node, NotImplemented)

    return Arithmetic(leaf, partial(reduce, operator.add), partial(reduce, operator.mul),
                      lambda base, n: base ** int(n), lambda node, parts: (type(node).__name__, *parts))


def test_sums_products_and_powers():
    """(x − y)³/2 + 1 at x = 1/2 and y = −1, exactly."""
    at = fractions({x: Fraction(1, 2), y: Fraction(-1)})
    assert in_arithmetic((x - y) ** 3 / 2 + 1, at) == Fraction(43, 16)


def test_functions_are_given_what_stands_for_their_arguments():
    """Of several arguments all, in order; a power that is no rational number is one of them."""
    at = fractions({x: Fraction(2)})
    assert in_arithmetic(besselj(1, x), at) == ("besselj", 1, 2) and in_arithmetic(3**x, at) == ("Pow", 3, 2)


@pytest.mark.parametrize("expression", [x**2 - y, sqrt(x) * exp(y) + pi, sin(x) ** Rational(-3, 2) / E,
                                        2**y, CRootOf(x**3 - x - 1, 0) * y])
def test_floats_are_near_the_value(expression):
    """A dozen roundings of numbers below 10."""
    found = in_floats(expression, np, {x: np.array([0.75]), y: np.array([-1.5])})[0]
    point = {x: Rational(3, 4), y: Rational(-3, 2)}
    roots = expression.atoms(CRootOf)
    expected = float(expression.xreplace({r: r.evalf(30) for r in roots}).xreplace(point))
    assert abs(found - expected) < 1e-14


def test_enclosures_are_of_what_the_grammar_has():
    """e^√2 + π, and None of another name or another function."""
    assert enclosure(exp(sqrt(2)) + pi).overlaps(enclosure(pi) + enclosure(exp(sqrt(2))))
    assert enclosure(x + 1) is None and enclosure(besselj(0, pi)) is None
