"""Signs of polynomials on a domain: by their factors, by the signs of terms, and by discriminants."""
from collections.abc import Iterable, Sequence
from math import prod

from flint import fmpq, fmpq_mpoly
from sympy import Expr

from ..rings.polynomials import Ring, by_degree, cancel

Factors = dict[str, fmpq_mpoly]


class Signs:
    """The signs of polynomials of a ring where every expression of a domain is positive."""

    def __init__(self, ring: Ring, domain: Iterable[Expr] = ()):
        self.ring = ring
        self._positive = [bool(g.is_positive) and g not in ring.squares for g in ring.generators]
        # factors are kept under their text: polynomials do not hash
        self._known: dict[str, int] = {}
        self._groups: list[tuple[frozenset[str], int]] = []   # odd factors whose product has this sign
        self._nonzero: set[str] = set()
        self._quadratics: dict[str, int] = {}
        self._forms: dict[str, int] = {}
        self._factored: dict[str, tuple[fmpq, list[tuple[str, fmpq_mpoly, int]]]] = {}
        for expression in domain:
            top, bottom = map(ring.reduce, ring.fraction(expression))
            sign, odd, even = self._factors(*cancel(top, bottom), deep=False)
            self._nonzero.update(odd, even)
            if len(odd) == 1:
                self._known[next(iter(odd))] = sign
            elif odd:
                self._groups.append((frozenset(odd), sign))
        for root, square in reversed(ring.squares.items()):
            if root.is_Pow and self.of(square) == 1 == self.of(ring.scales[root]):
                self._positive[ring.generators.index(root)] = True
                self._forms.clear()

    @classmethod
    def over(cls, expressions: Iterable[Expr], domain: Iterable[Expr] = ()) -> "Signs":
        """Make the signs in a ring that holds some expressions and the domain."""
        domain = tuple(domain)
        return cls(Ring([*expressions, *domain]), domain)

    def of(self, polynomial: fmpq_mpoly, deep: bool = True) -> int | None:
        """Return 1, 0 or −1 if the sign is the same on the whole domain, else None."""
        if not polynomial:
            return 0
        sign, odd, even = self._factors(polynomial, self.ring.one, deep)
        return None if odd or even else sign

    def nonnegative(self, polynomial: fmpq_mpoly) -> bool:
        """Tell whether the polynomial is found to be a positive multiple of a square, or zero."""
        if not polynomial:
            return True
        sign, odd, _ = self._factors(polynomial, self.ring.one)
        return sign > 0 and not odd

    def nonzero(self, polynomial: fmpq_mpoly) -> bool:
        """Tell whether the polynomial is found to vanish nowhere on the domain."""
        if not polynomial:
            return False
        _, odd, even = self._factors(polynomial, self.ring.one)
        return not even and odd.keys() <= self._nonzero

    def split(self, top: fmpq_mpoly, bottom: fmpq_mpoly) -> tuple[fmpq_mpoly, tuple[fmpq_mpoly, ...]]:
        """Return the margin normal form of a fraction: the margin, and the even factors that may vanish.

        The sign of the fraction is 0 where one of those vanishes, else the sign of the margin, which is the
        primitive integer polynomial of the factors of odd multiplicity that have no known sign.
        """
        top, bottom = cancel(self.ring.reduce(top), bottom)
        if not top:
            return self.ring.zero, ()
        sign, odd, even = self._factors(top, bottom)
        return prod(odd.values(), start=self.ring.one * sign), tuple(even[name] for name in sorted(even))

    def margin(self, expression: Expr) -> tuple[fmpq_mpoly, tuple[fmpq_mpoly, ...]]:
        """Return the margin normal form of an expression."""
        return self.split(*self.ring.fraction(expression))

    def normal_form(self, expression: Expr) -> tuple[Expr, tuple[Expr, ...]]:
        """Return the margin normal form of an expression, as expressions.

        Examples
        --------
        >>> from sympy import symbols
        >>> x, y = symbols("x y", real=True)
        >>> f = x * y**2 / (1 + x**2)
        >>> Signs.over([f]).normal_form(f)
        (x, (y,))
        """
        margin, even = self.margin(expression)
        return self.ring.expression(margin), tuple(map(self.ring.expression, even))

    def _factors(self, top: fmpq_mpoly, bottom: fmpq_mpoly,
                 deep: bool = True) -> tuple[int, Factors, Factors]:
        """Return the sign, the odd factors, and the even factors of top, without those of known sign."""
        sign: int = 1
        odd: Factors = {}
        even: Factors = {}
        for polynomial in (top, bottom):
            content, factors = self._factorization(polynomial)
            sign = sign if content > 0 else -sign
            for name, factor, n in factors:
                known = self._known.get(name) or self._form(name, factor)
                if known or deep and (known := self._quadratic(name, factor)):
                    sign *= known**n
                elif n % 2:
                    odd[name] = factor
                elif polynomial is top and name not in self._nonzero:
                    even[name] = factor
        for group, product in self._groups:
            if group <= odd.keys():
                odd = {name: factor for name, factor in odd.items() if name not in group}
                sign *= product
        return sign, odd, even

    def _factorization(self, polynomial: fmpq_mpoly) -> tuple[fmpq, list[tuple[str, fmpq_mpoly, int]]]:
        """Return the content, and the factors with their names and multiplicities."""
        if polynomial.is_constant():
            return polynomial.leading_coefficient(), []
        name = str(polynomial)
        if name not in self._factored:
            content, factors = polynomial.factor()
            self._factored[name] = content, [(str(factor), factor, int(n)) for factor, n in factors]
        return self._factored[name]

    def _quadratic(self, name: str, polynomial: fmpq_mpoly) -> int:
        """Return ±1 for a quadratic in one generator of negative discriminant on the domain, else 0."""
        if name not in self._quadratics:
            found = (self._definite(polynomial, index)
                     for index, degree in enumerate(polynomial.degrees()) if degree == 2)
            self._quadratics[name] = next(filter(None, found), 0)
        return self._quadratics[name]

    def _definite(self, polynomial: fmpq_mpoly, index: int) -> int:
        """Return the sign of a quadratic in one generator if its discriminant is negative, else 0."""
        sign = self.of(polynomial.derivative(index).derivative(index), deep=False)
        if not sign:
            return 0
        c, b, a = by_degree(polynomial, index, 2)
        return sign if self.of(b**2 - 4 * a * c, deep=False) == -1 else 0

    def _form(self, name: str, polynomial: fmpq_mpoly) -> int:
        """Return ±1 if all terms have that sign and one of them cannot vanish, else 0."""
        if name not in self._forms:
            self._forms[name] = _form(polynomial, self._positive)
        return self._forms[name]


def _form(polynomial: fmpq_mpoly, positive: Sequence[bool]) -> int:
    coefficients = polynomial.coeffs()
    sign = 1 if coefficients[0] > 0 else -1
    if any(c * sign < 0 for c in coefficients):
        return 0
    strict = False
    for exponents in polynomial.monoms():
        if any(e % 2 and not p for e, p in zip(exponents, positive)):
            return 0
        strict = strict or all(p for e, p in zip(exponents, positive) if e)
    return sign if strict else 0
