"""Polynomials over ℚ: where expressions become polynomials, are reduced, and become expressions again.

A ring has one generator for each symbol and for each function or constant that is no polynomial, such as
exp(k3). A square root and a sine carry a relation, g² = …, by which everything is reduced. The entries of a
matrix share one denominator, so that no fraction is simplified on the way.
"""
from collections.abc import Iterable, Sequence, Set
from functools import reduce
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S, Symbol, exp

from ...errors import ExpressionError
from ..enclosures.rationals import to_flint, to_sympy
from .generators import collect, exponential, spelt_once

Row = list[fmpq_mpoly]


class _ForeignError(KeyError):
    """A ring is asked for an expression that it was not made for."""


class Ring:
    """The ring ℚ[generators]/(relations), large enough to hold the expressions given."""

    def __init__(self, expressions: Iterable[Expr]):
        squares: dict[Expr, Expr] = {}                 # roots and sines, each after those inside it
        plain: dict[Expr, None] = {}
        seen: set[Expr] = set()
        for expression in expressions:
            collect(expression, seen, plain, squares)
        self.generators = (*reversed(squares), *sorted(plain, key=_name))
        self._context = fmpq_mpoly_ctx.get(tuple(f"x{i}" for i in range(len(self.generators))), Ordering.lex)
        self.one, self.zero = self._context.constant(1), self._context.constant(0)
        self.gens = dict(zip(self.generators, self._context.gens()))
        self._literal = False                          # whether every generator means itself
        self._memo = {g: (x, self.one) for g, x in self.gens.items()}
        self._meaning = list(self.generators)
        self.squares: dict[Expr, fmpq_mpoly] = {}
        self.scales: dict[Expr, fmpq_mpoly] = {}       # D for each root: its generator has the sign of D
        self._relations: list[tuple[int, fmpq_mpoly]] = []
        for root, square in squares.items():           # √(N/D) = g/D with g² = N·D
            top, bottom = self.fraction(square)
            self.squares[root] = self.reduce(top * bottom)
            place = self.generators.index(root)
            self._relations.insert(0, (place, self.gens[root] ** 2 - self.squares[root]))
            self._memo[root] = self.gens[root], bottom
            self.scales[root] = bottom
            self._meaning[place] = root * self.expression(bottom)
        self._literal = self._meaning == list(self.generators)

    def holds(self, expressions: Iterable[Expr]) -> bool:
        """Tell whether all of the expressions are fractions in the generators."""
        try:
            for expression in expressions:
                self.fraction(expression)
        except _ForeignError:
            return False
        return True

    def fraction(self, node: Expr) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Return numerator and denominator, neither reduced nor sign-normalised."""
        found = self._memo.get(node)
        if found is None:
            found = self._memo[node] = self._convert(node)
        return found

    def numerator(self, expression: Expr) -> fmpq_mpoly:
        """Return the numerator, reduced: it is 0 if the expression vanishes identically."""
        return self.reduce(self.fraction(expression)[0])

    def _convert(self, node: Expr) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        if isinstance(node, Rational):
            return self._context.constant(to_flint(node)), self.one
        if isinstance(node, Add):
            return self._add([self.fraction(part) for part in node.args])
        if isinstance(node, Mul):
            factors = [self.fraction(part) for part in node.args]
        elif isinstance(node, Pow) and isinstance(node.exp, Integer):
            factors = [_power(self.fraction(node.base), int(node.exp))]
        elif isinstance(node, Pow) and isinstance(node.exp, Rational):
            factors = [_power(self._known(Pow(node.base, Rational(1, node.exp.q))), int(node.exp.p))]
        elif isinstance(node, exp):
            factors = [_power(self._known(base), n) for base, n in exponential(node)]
        elif (same := spelt_once(node)) is not None:
            factors = [self.fraction(same)]
        elif (exponentials := node.rewrite(exp)) != node:
            factors = [self.fraction(exponentials)]
        else:
            factors = [self._known(node)]
        top, bottom = self.one, self.one
        for numerator, denominator in factors:
            top, bottom = top * numerator, bottom * denominator
        return top, bottom

    def _known(self, node: Expr) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Return the fraction that a generator is."""
        if node not in self._memo:
            raise _ForeignError(f"{node} is not in the ring")
        return self._memo[node]

    def _add(self, parts: list[tuple[fmpq_mpoly, fmpq_mpoly]]) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        bottom = reduce(lcm, (denominator for _, denominator in parts), self.one)
        return sum((top * (bottom / denominator) for top, denominator in parts), self.zero), bottom

    def reduce(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """Return the remainder modulo the relations g² = …."""
        for place, relation in self._relations:
            if polynomial and polynomial.degrees()[place] > 1:
                polynomial = divmod(polynomial, relation)[1]
        return polynomial

    def matrix(self, rows: Sequence[Sequence[Expr]]) -> tuple[list[Row], fmpq_mpoly]:
        """Return reduced polynomial entries and their least common denominator."""
        entries = [[self.fraction(entry) for entry in row] for row in rows]
        bottom = reduce(lcm, (denominator for row in entries for _, denominator in row), self.one)
        return [[self.reduce(top if denominator == bottom else top * (bottom / denominator))
                 for top, denominator in row] for row in entries], bottom

    def expression(self, polynomial: fmpq_mpoly) -> Expr:
        """Return the SymPy expression, expanded."""
        terms = []
        for exponents, c in zip(polynomial.monoms(), polynomial.coeffs()):
            powers = [g if e == 1 else Pow(g, Integer(e)) for g, e in zip(self._meaning, exponents) if e]
            terms.append(Mul(*powers) if c == 1 else Mul(to_sympy(c), *powers))
        return self._written(Add(*terms), polynomial, self.one)

    def _written(self, expression: Expr, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Expr:
        """Remember the fraction of an expression, for when it is read again."""
        if self._literal:
            self._memo.setdefault(expression, (top, bottom))
        return expression

    def coefficients(self, polynomial: fmpq_mpoly, moving: Set[Symbol]) -> dict[tuple[int, ...], fmpq_mpoly]:
        """Split the polynomial by its monomials in the generators that contain a moving symbol."""
        places = [bool(g.free_symbols & moving) for g in self.generators]
        groups: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
        for exponents, c in polynomial.to_dict().items():
            kind = tuple(e if moves else 0 for e, moves in zip(exponents, places))
            groups.setdefault(kind, {})[tuple(e - n for e, n in zip(exponents, kind))] = c
        return {kind: self._context.from_dict(terms) for kind, terms in groups.items()}

    def monomial(self, exponents: Sequence[int]) -> Expr:
        """Return Π generatorᵉ."""
        return Mul(*(Pow(g, Integer(e)) for g, e in zip(self.generators, exponents) if e))

    def quotient(self, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Expr:
        """Return the SymPy fraction in lowest terms, its denominator factored."""
        if not (top := self.reduce(top)):
            return S.Zero
        top, bottom = cancel(top, bottom)
        if bottom.is_constant():
            return self.expression(top / bottom)
        content, factors = bottom.factor()
        fraction = Mul(self.expression(top / content),
                       *(Pow(self.expression(f), -int(n)) for f, n in factors))
        return self._written(fraction, top / content, bottom / content)


def _name(generator: Expr) -> str:
    """Return the text by which generators are ordered; a symbol has it without being printed."""
    return generator.name if isinstance(generator, Symbol) else str(generator)


def _power(part: tuple[fmpq_mpoly, fmpq_mpoly], n: int) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    top, bottom = part if n >= 0 else part[::-1]
    if not bottom:
        raise ExpressionError("an expression divides by 0: one of its denominators vanishes identically; "
                              "check the denominators")
    return top ** abs(n), bottom ** abs(n)


def lowest_terms(expression: Expr) -> Expr:
    """Return the same fraction in lowest terms, its denominator factored.

    Examples
    --------
    >>> from sympy import symbols
    >>> x, y = symbols("x y")
    >>> lowest_terms((x**2 - y**2) / (x * y + y**2))
    (x - y)/y
    """
    ring = Ring([expression])
    return ring.quotient(*ring.fraction(expression))


def derivatives(f: Expr, variables: Sequence[Symbol]) -> list[Expr]:
    """Return ∂f/∂x for each variable: by exponents if f is rational in them, else by SymPy."""
    ring = Ring([f])
    top, bottom = ring.fraction(f)
    moving = f.free_symbols & set(variables)
    if any(g.free_symbols & moving for g in ring.generators if g not in moving):
        return [f.diff(x) for x in variables]
    places = [ring.generators.index(x) if x in moving else None for x in variables]
    return [S.Zero if n is None else
            ring.quotient(top.derivative(n) * bottom - top * bottom.derivative(n), bottom**2) for n in places]


def by_degree(polynomial: fmpq_mpoly, index: int, degree: int) -> list[fmpq_mpoly]:
    """Return the coefficients of the powers 0 … degree of one generator."""
    parts: list[dict[tuple[int, ...], Any]] = [{} for _ in range(degree + 1)]
    for exponents, coefficient in polynomial.to_dict().items():
        parts[exponents[index]][exponents[:index] + (0,) + exponents[index + 1:]] = coefficient
    return [polynomial.context().from_dict(part) for part in parts]


def lcm(a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
    """Return the least common multiple."""
    if a == b or b.is_one():
        return a
    return b if a.is_one() else a * (b / a.gcd(b))


def cancel(top: fmpq_mpoly, bottom: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """Return the same fraction in lowest terms."""
    common = top.gcd(bottom)
    return (top, bottom) if common.is_constant() else (top / common, bottom / common)


def by_factors(expression: Expr) -> Expr:
    """Return a rational expression as a quotient of products.

    In doubles a product keeps its digits close to a zero; a sum that has been multiplied out does not.

    Examples
    --------
    >>> from sympy import symbols
    >>> x = symbols("x")
    >>> by_factors(1 / (x**2 - 2 * x + 1))
    (x - 1)**(-2)
    """
    ring = Ring([expression])
    products = []
    for polynomial in ring.fraction(expression):
        constant, factors = polynomial.factor()
        products.append(Mul(to_sympy(constant), *(ring.expression(f) ** int(n) for f, n in factors)))
    return products[0] / products[1]
