"""Decomposes a constant into the angles of its exponentials and sines, its logarithms and its roots."""
from collections import defaultdict
from math import gcd, lcm

from sympy import Add, Expr, Integer, Mul, Pow, Rational, S, cos, cosh, exp, log, sin, sinh, tanh

from ..enclosures.algebraic import TURNS, turn
from .enclosed_roots import RealRoot


class Constituents:
    """The parts of a constant for which the variables of its normal form stand.

    Attributes
    ----------
    integers : set of int
        in the logarithms
    plain : dict
        roots and everything else that is a variable as it is, each after those inside it

    Examples
    --------
    >>> from sympy import pi, sqrt
    >>> halves, thirds = exp(sqrt(2) / 2), exp(sqrt(2) / 3)
    >>> found = Constituents(halves + thirds * log(Rational(2, 3)) - pi)
    >>> found.units(), found.integers, list(found.plain)
    ({(exp, sqrt(2)): 1/6}, {2, 3}, [pi])
    """

    def __init__(self, constant: Expr):
        # of e^… and of cos, sin
        self._angles: defaultdict[tuple[type, Expr], list[Rational]] = defaultdict(list)
        self.integers: set[int] = set()
        self.plain: dict[Expr, None] = {}
        self._collect(constant, set())

    def units(self) -> dict[tuple[type, Expr], Rational]:
        """Return for each kind and angle the largest fraction of it of which all are multiples."""
        return {key: Rational(gcd(*(int(r.p) for r in angles)), lcm(*(int(r.q) for r in angles)))
                for key, angles in self._angles.items()}

    def _collect(self, node: Expr, seen: set[Expr]) -> None:
        """Enter the parts of a constant, each root after those inside it."""
        if node in seen or isinstance(node, Rational):
            return
        seen.add(node)
        if node is S.Exp1 or isinstance(node, (exp, sinh, cosh, tanh)):
            for coefficient, rest in multiples(node):
                self._angles[exp, rest].append(coefficient)
        elif isinstance(node, (Add, Mul)) or isinstance(node, Pow) and isinstance(node.exp, Integer):
            for part in node.args:
                self._collect(part, seen)
        elif isinstance(node, Pow) and isinstance(node.exp, Rational):
            self._collect(node.base, seen)
            self.plain[Pow(node.base, Rational(1, node.exp.q))] = None
        elif isinstance(node, TURNS) and turn(node) is None:
            for coefficient, rest in multiples(node):
                if rest is S.Pi:
                    self._collect(cos(coefficient * rest), seen)
                    self._collect(sin(coefficient * rest), seen)
                else:
                    self._angles[cos, rest].append(coefficient)
        elif isinstance(node, RealRoot):
            for c in node.coefficients:
                self._collect(c, seen)
            self.plain[node] = None
        elif isinstance(node, log) and isinstance(node.args[0], Rational):
            self.integers |= {int(node.args[0].p), int(node.args[0].q)}
        else:
            self.plain[node] = None


def multiples(function: Expr) -> list[tuple[Rational, Expr]]:
    """Return the argument of a function as a sum of rational multiples."""
    argument = S.One if function is S.Exp1 else function.args[0].expand()
    pairs = (term.as_coeff_Mul() for term in Add.make_args(argument))
    return [(r, rest) if isinstance(r, Rational) else (S.One, r * rest) for r, rest in pairs]
