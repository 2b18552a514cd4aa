"""Numbers in the field of a real root of a polynomial over ℚ, made into expressions when asked for."""
from collections.abc import Sequence
from typing import Any, overload

from flint import arb, arb_poly, fmpq_poly
from sympy import Expr, Integer, Rational

from ..._cached import cached_property
from ..enclosures.balls import Enclosed, ball
from ..enclosures.precision import own_precision
from ..enclosures.real_roots import isolated_roots
from ..reals.number_fields import at_root, divided
from .root_numbers import refuse_close
from .roots import roots_of_factor

BITS = 192                                             # of most enclosures that are asked for


class RealNumbers:
    """Several lists of real numbers, each enclosed at once, and made into expressions when asked for."""

    def values(self, precision: int) -> list[list[arb]]:
        """Return enclosures of the numbers of each list."""
        raise NotImplementedError

    def expression(self, root: int, place: int) -> Expr:
        """Return one number of one list as an expression."""
        return EnclosedNumber(self, root, place)

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether one number of one list is a fraction."""
        raise NotImplementedError

    def varies(self, place: int, conjugate: Sequence[int]) -> bool:
        """Tell whether a number is proved to have two sizes in conjugate lists: then it is no fraction."""
        sizes = [abs(self.values(BITS)[root][place]) for root in conjugate]
        return any(not x.overlaps(sizes[0]) for x in sizes)


class EnclosedNumber(Enclosed):
    """One of several lists of real numbers, without an algebraic form; it prints as a decimal."""

    numbers: RealNumbers

    def __new__(cls, numbers: RealNumbers, root: int, place: int) -> "EnclosedNumber":
        number: EnclosedNumber = Expr.__new__(cls, Integer(id(numbers)), Integer(root), Integer(place))
        number.numbers = numbers
        return number

    def enclosed(self, precision: int) -> arb:
        """Return an enclosure."""
        return self.numbers.values(precision)[int(self.args[1])][int(self.args[2])]

    def __reduce__(self) -> tuple[Any, ...]:
        return EnclosedNumber, (self.numbers, int(self.args[1]), int(self.args[2]))

    def _sympystr(self, _: Any) -> str:
        return str(self.evalf(17))

    _latex = _sympyrepr = _sympystr


class Conjugates(RealNumbers):
    """The real roots of an irreducible polynomial, and the values of quotients top/under at them.

    Parameters
    ----------
    polynomial : fmpq_poly
    tops : sequence of fmpq_poly
    under : fmpq_poly
        vanishes at no root

    Examples
    --------
    >>> from sympy import S
    >>> square, one, x = (fmpq_poly(c) for c in ([-2, 0, 1], [1], [0, 1]))
    >>> halves = Conjugates(square, [one], x)
    >>> [tuple(FieldNumbers(halves, n, [(0, S.One)])) for n in (0, 1)]
    [(-sqrt(2)/2,), (sqrt(2)/2,)]
    """

    def __init__(self, polynomial: fmpq_poly, tops: Sequence[fmpq_poly], under: fmpq_poly):
        self.polynomial, self.tops, self.under = polynomial, tops, under
        self._roots: dict[int, list[arb]] = {}
        self._values: dict[int, list[list[arb]]] = {}

    def roots(self, precision: int = BITS) -> list[arb]:
        """Return enclosures of the real roots, in increasing order, isolated."""
        precision = max(precision, BITS)                   # fewer bits take as long
        if precision not in self._roots:
            refuse_close(self.polynomial.numer())
            with own_precision(precision):
                self._roots[precision] = isolated_roots(self.polynomial)
        return self._roots[precision]

    def values(self, precision: int = BITS) -> list[list[arb]]:
        """Return enclosures of the quotients at each root."""
        precision = max(precision, BITS)
        if precision not in self._values:
            with own_precision(precision):
                under, *tops = (arb_poly(f) for f in (self.under, *self.tops))
                self._values[precision] = [[top(root) / under(root) for top in tops]
                                           for root in self.roots(precision)]
        return self._values[precision]

    @cached_property
    def exact(self) -> list[Expr]:
        """The real roots as expressions, in the same order."""
        return roots_of_factor(self.polynomial)

    @cached_property
    def short(self) -> tuple[list[fmpq_poly], fmpq_poly]:
        """The quotients over the derivative of the polynomial, which makes their coefficients short."""
        slope = self.polynomial.derivative()
        return divided([top * slope for top in self.tops], self.under, self.polynomial), slope

    def expression(self, root: int, place: int) -> Expr:
        """Return one of the quotients at one of the roots."""
        tops, under = self.short
        return at_root(tops[place], self.exact[root]) / at_root(under, self.exact[root])

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether one of the quotients is a fraction; then it is so at every root."""
        tops, slope = self.short
        degree = slope.degree()
        return tops[place] * slope[degree] == slope * tops[place][degree]


class FieldNumbers(Sequence[Expr]):
    """One of several lists of real numbers: a sequence of expressions, each made when it is asked for.

    Parameters
    ----------
    conjugates : RealNumbers
        such as quotients at conjugate roots
    root : int
        the place of the list, of the root among the real ones
    places : sequence of (int, Expr)
        which of its numbers, and an exact factor
    """

    def __init__(self, conjugates: RealNumbers, root: int, places: Sequence[tuple[int, Expr]]):
        self.conjugates, self.root, self.places = conjugates, root, places

    def __len__(self) -> int:
        return len(self.places)

    def __eq__(self, other: object) -> bool:
        if self is other or isinstance(other, FieldNumbers) and self._defined() == other._defined():
            return True                                    # none has to be written out
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    def __hash__(self) -> int:
        return hash(tuple(self))

    @overload
    def __getitem__(self, n: int) -> Expr: ...

    @overload
    def __getitem__(self, n: slice) -> "FieldNumbers": ...

    def __getitem__(self, n: int | slice) -> "Expr | FieldNumbers":
        if isinstance(n, slice):
            return FieldNumbers(self.conjugates, self.root, self.places[n])
        place, factor = self.places[n]
        return factor * self.conjugates.expression(self.root, place)

    def _defined(self) -> tuple[Any, ...]:
        field = self.conjugates
        where = (field.polynomial, field.tops, field.under) if isinstance(field, Conjugates) else field
        return where, self.root, tuple(self.places)

    def is_fraction(self, n: int) -> bool:
        """Whether a number is a fraction; a factor that is none is taken as if it made one."""
        place, factor = self.places[n]
        return not isinstance(factor, Rational) or self.conjugates.is_fraction(self.root, place)

    def __reduce__(self) -> tuple[Any, ...]:
        return tuple, (tuple(self),)                       # python-flint's polynomials are not pickled

    def balls(self, precision: int) -> list[arb]:
        """Return enclosures of the numbers, without making their expressions."""
        values = self.conjugates.values(precision)[self.root]
        with own_precision(precision):
            return [values[place] * ball(factor, precision) for place, factor in self.places]

    def over(self, divisor: Expr) -> "FieldNumbers":
        """Return each number divided by an exact one."""
        return FieldNumbers(self.conjugates, self.root, [(place, x / divisor) for place, x in self.places])


def are_fractions(numbers: Sequence[Expr]) -> bool:
    """Tell whether all numbers are fractions; such lists need no expressions for that."""
    if isinstance(numbers, FieldNumbers):
        return all(isinstance(factor, Rational) and numbers.is_fraction(n)
                   for n, (_, factor) in enumerate(numbers.places))
    return all(isinstance(x, Rational) for x in numbers)


def balls(numbers: Sequence[Expr], precision: int) -> list[arb]:
    """Return enclosures; those of such lists need no expressions."""
    if isinstance(numbers, FieldNumbers):
        return numbers.balls(precision)
    return [ball(x, precision) for x in numbers]
