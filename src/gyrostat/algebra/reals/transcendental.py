"""Proves zeros among transcendental numbers by a normal form in π, exponentials, sines and logarithms.

A constant is written as a fraction of polynomials in π, in e^(1/n), in cos(1/n) and sin(1/n), and in the
logarithms of integers without common factors; sin² is 1 − cos². It is 0 if every coefficient is 0. The
converse holds if the variables are algebraically independent: one of them alone; exponentials, sines and
cosines of rational numbers together (Lindemann and Weierstrass); logarithms of rationals to the first power
(Baker). Beyond these cases a constant that is 0 may not be recognised.
"""
from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import sympy
from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Add, CRootOf, Expr, Mul, Pow, Rational, S, cos, exp, log, sin

from ..enclosures.algebraic import TURNS, coprime, is_algebraic, separation
from ..enclosures.rationals import to_flint, to_sympy
from ..rings.constituents import Constituents, multiples
from ..rings.enclosed_roots import RealRoot
from ..rings.polynomials import by_degree
from ..rings.quotients import Fraction, Quotients

MULTIPLE, SEPARATION = 256, 2**22                        # n of cos(n x); bits, of all coefficients together
Root = tuple[int, Fraction, fmpq_mpoly, Expr]            # q, N/D, g, its meaning: g^q = N/D


def vanishes(constant: Expr, sign: Callable[[Expr], int | None]) -> bool:
    """Tell whether a constant is proved to be 0 by its normal form.

    Parameters
    ----------
    constant : Expr
        real and finite, so that none of its denominators is 0
    sign : callable
        the sign of a simpler constant, None where it is not proved

    References
    ----------
    Baker, Transcendental Number Theory (1975), theorems 1.4 and 2.1.

    Examples
    --------
    >>> from sympy import pi, sqrt
    >>> from gyrostat.algebra.reals.exact import sign_of_constant
    >>> vanishes((pi + sqrt(2))**2 - pi**2 - 2*sqrt(2)*pi - 2, sign_of_constant)
    True
    >>> vanishes(log(12) - 2*log(2) - log(3), sign_of_constant)
    True
    """
    try:
        form = _Form(constant := sympy.expand_log(constant), sign)
        top = form.numerator(constant)
        return form.is_zero(top, form.roots) if top and not is_algebraic(constant) else not top
    except OverflowError:                                  # more work than it is worth
        return False


class _Form:
    """The polynomial ring in which one constant is written.

    It has a variable for each independent part of the constant, and one for each other part that has no
    normal form.
    """

    def __init__(self, constant: Expr, sign: Callable[[Expr], int | None]):
        self._sign = sign
        self._below: list[fmpq_mpoly] = []                                                   # denominators
        parts = Constituents(constant)
        self._units, plain = parts.units(), parts.plain
        self._base = coprime(parts.integers)
        meaning: dict[Any, Expr] = {node: node for node in reversed(plain)}
        meaning |= {(log, n): log(n) for n in self._base}
        for (kind, rest), unit in self._units.items():
            meaning |= {(f, rest): f(unit * rest) for f in ((cos, sin) if kind is cos else (exp,))}
        context = fmpq_mpoly_ctx.get(tuple(f"x{n}" for n in range(len(meaning))), Ordering.lex)
        self._one, self._zero = context.constant(1), context.constant(0)
        self._gens, self._meaning = dict(zip(meaning, context.gens())), list(meaning.values())
        self._algebraic = [isinstance(key, Expr) and is_algebraic(key) for key in meaning]
        self._ring = Quotients()
        for place, node in zip(reversed(range(len(plain))), plain):
            if is_algebraic(node) or isinstance(node, RealRoot):
                self._relate(place, node)
        outer = [(int(v.exp.q), self.fraction(v.base), self._gens[v], v) for v in reversed(plain)
                 if isinstance(v, Pow) and isinstance(v.exp, Rational) and not is_algebraic(v)]
        turned = [(self._gens[cos, rest], self._gens[sin, rest], meaning[sin, rest])
                  for kind, rest in self._units if kind is cos]
        self.roots: list[Root] = outer + [(2, (self._one - c**2, self._one), s, value)
                                          for c, s, value in turned]

    def _relate(self, place: int, node: Expr) -> None:
        """Enter the relation that a root satisfies over those inside it, if it has no denominator."""
        g = self._gens[node]
        if isinstance(node, CRootOf):
            self._solves(place, g, node.poly.all_coeffs()[::-1])
        elif isinstance(node, RealRoot):
            self._solves(place, g, node.coefficients)
        elif isinstance(node, Pow):
            top, bottom = self.fraction(node.base)
            if bottom.is_constant():
                self._ring.relate(place, int(node.exp.q), g ** int(node.exp.q) - top / bottom)

    def _solves(self, place: int, g: fmpq_mpoly, coefficients: Sequence[Expr]) -> None:
        """Enter the relation of a root of a polynomial over ℚ, or of a monic one."""
        parts = [self.fraction(c) for c in coefficients]
        if all(below.is_constant() for _, below in parts):
            lead = parts[-1][0] / parts[-1][1]
            self._ring.relate(place, len(parts) - 1, sum(
                (above / (below * lead) * g**n for n, (above, below) in enumerate(parts)), self._zero))

    def fraction(self, node: Expr) -> Fraction:
        """Return numerator and denominator of a part of the constant, in the variables."""
        if node in self._gens:
            return self._gens[node], self._one
        if isinstance(node, Rational):
            return self._one * to_flint(node), self._one
        if isinstance(node, Add):
            return reduce(self._ring.sum, map(self.fraction, node.args))
        if isinstance(node, Mul):
            return reduce(self._ring.product, map(self.fraction, node.args))
        if node is S.Exp1 or isinstance(node, exp):
            powers = ((self._gens[exp, rest], int(r / self._units[exp, rest])) for r, rest in multiples(node))
            return reduce(self._ring.product, (self._power((g, self._one), n) for g, n in powers))
        if isinstance(node, Pow):
            base = node.base if node.exp.q == 1 else Pow(node.base, Rational(1, node.exp.q))
            return self._power(self.fraction(base), int(node.exp.p))
        if isinstance(node, log):
            # negative where b divides the denominator
            powers = ((b, sympy.multiplicity(b, node.args[0])) for b in self._base)
            return sum((n * self._gens[log, b] for b, n in powers), self._zero), self._one
        if isinstance(node, sympy.sinh | sympy.cosh | sympy.tanh):
            return self.fraction(node.rewrite(exp))
        c, s = self._turned(node)
        above, below, product = self._power(c, -1), self._power(s, -1), self._ring.product
        return (s, c, product(s, above), product(c, below), above, below)[TURNS.index(type(node))]

    def _power(self, part: Fraction, n: int) -> Fraction:
        top, bottom = part if n >= 0 else part[::-1]
        if n < 0:
            self._below.append(bottom)
        return self._ring.power((top, bottom), abs(n))

    def numerator(self, constant: Expr) -> fmpq_mpoly:
        """Return what has to vanish: the numerator, divided by the denominators that divide it."""
        top = self.fraction(constant)[0]
        for divisor in self._below:
            while top and not divisor.is_constant() and not (parts := divmod(top, divisor))[1]:
                top = parts[0]
        return top

    def _turned(self, node: Expr) -> tuple[Fraction, Fraction]:
        """Return cos and sin of a sum, by the addition theorems."""
        c, s = (self._one, self._one), (self._zero, self._one)
        for coefficient, rest in multiples(node):
            if rest is S.Pi:
                x, y = self.fraction(cos(coefficient * rest)), self.fraction(sin(coefficient * rest))
            else:
                x, y = self._multiple(rest, int(coefficient / self._units[cos, rest]))
            minus = (-y[0], y[1])
            parts = [self._ring.product(a, b) for a, b in ((c, x), (s, minus), (c, y), (s, x))]
            c, s = self._ring.sum(*parts[:2]), self._ring.sum(*parts[2:])
        return c, s

    def _multiple(self, rest: Expr, n: int) -> tuple[Fraction, Fraction]:
        """Return cos(n x) = T(c) and sin(n x) = s U(c) by the recurrence of Chebyshev's polynomials."""
        if abs(n) > MULTIPLE:
            raise OverflowError
        c, s = self._gens[cos, rest], self._gens[sin, rest]
        before, here = (c, -self._one), (self._one, self._zero)          # T and U of −1 and 0
        for _ in range(abs(n)):
            before, here = here, (2 * c * here[0] - before[0], 2 * c * here[1] - before[1])
        return (here[0], self._one), (s * here[1] * (1 if n > 0 else -1), self._one)

    def is_zero(self, polynomial: fmpq_mpoly, roots: list[Root]) -> bool:
        """Tell whether a polynomial is proved to vanish at the numbers that its variables stand for.

        The roots are eliminated, outer ones first: with g² = N/D, a + b g is 0 if a² D = b² N and the signs
        of a and −b g agree.
        """
        if not polynomial or not roots:
            return not polynomial or self._coefficients_are_zero(polynomial)
        (q, (top, bottom), g, meaning), *rest = roots
        place = list(self._gens.values()).index(g)
        parts = by_degree(polynomial, place, degree := polynomial.degrees()[place])
        most = degree // q
        times, raised = self._ring.times, self._ring.raised
        by_power = [times(times(c, raised(top, n // q)), raised(bottom, most - n // q))
                    for n, c in enumerate(parts)]
        residues = [sum(by_power[n::q], self._zero) for n in range(q)]
        if all(self.is_zero(part, rest) for part in residues):
            return True
        if q != 2:
            return False
        a, b = residues                                     # a + b g, with g² = N/D
        if not self.is_zero(times(times(a, a), bottom) - times(times(b, b), top), rest):
            return False
        first, second, root = (self._sign(x) for x in (self._expression(a.to_dict()),
                                                       self._expression(b.to_dict()), meaning))
        return first is not None and second is not None and root is not None and first == -second * root

    def _coefficients_are_zero(self, polynomial: fmpq_mpoly) -> bool:
        """Tell whether all coefficients of the monomials in the transcendental variables are 0."""
        groups: defaultdict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = defaultdict(dict)
        for exponents, c in polynomial.to_dict().items():
            kind = tuple(0 if own else e for e, own in zip(exponents, self._algebraic))
            groups[kind][tuple(e if own else 0 for e, own in zip(exponents, self._algebraic))] = c
        # a rational number
        if any(len(terms) == 1 and not any(exponents) for terms in groups.values() for exponents in terms):
            return False
        coefficients = [self._expression(terms) for terms in groups.values()]
        if sum(separation(c) or 0 for c in coefficients) > SEPARATION:
            return False
        return all(self._sign(c) == 0 for c in coefficients)

    def _expression(self, terms: dict[tuple[int, ...], fmpq]) -> Expr:
        return Add(*(Mul(to_sympy(c), *(Pow(v, int(e)) for v, e in zip(self._meaning, exponents) if e))
                     for exponents, c in terms.items()))
