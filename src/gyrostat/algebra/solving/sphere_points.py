"""The finitely many points of the sphere k·k = 1 in which polynomials over ℚ vanish.

Macaulay's matrix gives the quotient algebra, Hermite's trace form counts its points, and a rational
univariate representation gives them as rational functions of the roots of one polynomial.
"""
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import count

from flint import fmpq, fmpq_mat, fmpq_poly
from sympy import S

from ..._cached import cached_property
from .real_fields import Conjugates, FieldNumbers
from .sphere_curves import AXES, ONE, Exponents, Terms, on_sphere, product

SPHERE: Terms = {(2, 0, 0): fmpq(1), (0, 2, 0): fmpq(1), (0, 0, 2): fmpq(1), ONE: fmpq(-1)}


def finite_zeros(given: Sequence[Terms], left_out: Sequence[Terms], above: Sequence[Terms]
                 ) -> Iterable[FieldNumbers] | None:
    """Return every real common zero of polynomials with finitely many complex ones; None if not found.

    Degree by degree the polynomials times monomials span part of their ideal (Macaulay's matrix). The
    monomials that lead no element of it are a basis of the quotient algebra as soon as the multiplications by
    k1, k2, k3 commute, the polynomials are 0 in it, and each of these monomials times 1 is itself. Its
    dimension is the number of complex zeros, each as often as it counts; the rank of its trace form (Hermite)
    is that of the distinct ones. A form λ in k with as many distinct eigenvalues tells them apart: each is a
    root of the characteristic polynomial of λ, and k is rational in it.

    Parameters
    ----------
    given : sequence of Terms
        none of them 0
    left_out : sequence of Terms
        polynomials whose zeros are left out
    above : sequence of Terms
        polynomials whose quotients by the first of left_out follow the coordinates

    References
    ----------
    Mourrain, A new criterion for normal form algorithms, AAECC-13 (1999) 430-442; Rouillier, Solving
    zero-dimensional systems through the rational univariate representation, AAECC 9 (1999) 433-461; with
    proofs in docs/explanation/derivations/zeros-on-the-sphere.md, sections 5 and 6.
    """
    if (algebra := _algebra(given)) is None:
        return None
    for f in left_out:
        algebra = algebra.without(f)
    # all zeros come with their opposites where each polynomial is even or odd, with the same quotients
    paired = all(len({sum(e) % 2 for e in f}) < 2 for f in (*given, *left_out)) and len(
        {sum(e) % 2 for f in (left_out[0], *above) for e in f}) == 1
    return algebra.points(paired, algebra.quotients(above, left_out[0]))


class _Algebra:
    """The quotient algebra: its element 1 in a basis, and its multiplications by k1, k2, k3."""

    def __init__(self, spanning: Sequence[Exponents], one: fmpq_mat, axes: Sequence[fmpq_mat]):
        self.spanning, self.one, self.axes, self.size = spanning, one, axes, one.nrows()

    def holds(self, polynomials: Sequence[Terms]) -> bool:
        """Tell whether it is the quotient algebra: the polynomials are 0, and each basis monomial is itself.

        Without the latter the elements of the basis may depend on each other, as 1 does not reach them all.
        """
        x, y, z = self.axes
        place = self.monomials(self.one)
        return x * y == y * x and y * z == z * y and z * x == x * z and not any(
            any(self.times(f, self.one).entries()) for f in [SPHERE, *polynomials]) and all(
            place(e).entries() == [int(b == e) for b in self.spanning] for e in self.spanning)

    def times(self, polynomial: Terms, start: fmpq_mat) -> fmpq_mat:
        """Multiply an element, or several, by a polynomial."""
        monomial = self.monomials(start)
        return sum((monomial(e) * c for e, c in polynomial.items()), start * 0)

    def monomials(self, start: fmpq_mat) -> Callable[[Exponents], fmpq_mat]:
        """Return the function that multiplies `start` by a monomial."""
        @cache
        def monomial(e: Exponents) -> fmpq_mat:
            if e == ONE:
                return start
            axis = next(n for n in (0, 1, 2) if e[n])
            return self.axes[axis] * monomial(tuple(x - (n == axis) for n, x in enumerate(e)))

        return monomial

    def without(self, polynomial: Terms) -> "_Algebra":
        """Return the algebra of the zeros at which a polynomial does not vanish: the image of its powers."""
        power = self.times(polynomial, _identity(self.size))
        rank, before = power.rank(), self.size
        if rank == before:
            return self
        while rank < before:
            power = power * power
            rank, before = power.rank(), rank
        reduced = power.transpose().rref()[0]
        places = [next(n for n in range(self.size) if reduced[row, n]) for row in range(rank)]
        image = fmpq_mat([[reduced[row, n] for row in range(rank)] for n in range(self.size)])

        def inside(columns: fmpq_mat) -> fmpq_mat:
            return fmpq_mat([[columns[n, m] for m in range(columns.ncols())] for n in places])

        one = inside(power * image).solve(inside(power * self.one))
        return _Algebra(self.spanning, one, [inside(axis * image) for axis in self.axes])

    def quotients(self, tops: Sequence[Terms], bottom: Terms) -> list[fmpq_mat]:
        """Divide polynomials by one that vanishes nowhere."""
        under = self.times(bottom, _identity(self.size))
        return [under.solve(self.times(top, self.one)) for top in tops]

    def points(self, paired: bool = False, more: Sequence[fmpq_mat] = ()) -> Iterator[FieldNumbers]:
        """Yield the real zeros, with the values of more elements at them.

        `paired` says that with each zero k also −k is one, at which these elements have the same values.
        """
        for n in count(1):                             # any two zeros have one λ for at most two n
            form = self.axes[0] + self.axes[1] * n + self.axes[2] * n**2
            whole = fmpq_poly(form.charpoly())
            apart = whole / whole.gcd(whole.derivative())
            if apart.degree() == self.size or apart.degree() == self.traced[0]:
                break
        monomial = self.monomials(self.one)
        elements = [*(monomial(e) for e in (ONE, *AXES)), *more]
        # an arbitrary functional; if a zero has the weight 0, or is multiple, the trace, which takes longer
        weights = fmpq_mat([[n % 7 + 1 for n in range(self.size)]])
        found = _numerators(apart, form, weights, elements)
        if apart.degree() < self.size or not found[0].gcd(apart).is_constant():
            found = _numerators(apart, form, self.traced[1], elements)
        under, *tops = found
        places = range(len(tops))
        for factor, _ in apart.factor()[1]:
            values = Conjugates(factor, tops, under)
            for n, root in enumerate(values.roots()):
                if not paired:
                    yield FieldNumbers(values, n, [(place, S.One) for place in places])
                elif root > 0:                             # λ(−k) = −λ(k), and λ tells them apart
                    for sign in (S.One, S.NegativeOne):
                        yield FieldNumbers(values, n, [(place, sign if place < 3 else S.One)
                                                       for place in places])

    @cached_property
    def traced(self) -> tuple[int, fmpq_mat]:
        """The number of distinct zeros by Hermite's form, and the functional that takes traces.

        The trace of an element is the sum of its values at all zeros, each as often as it counts.
        """
        times, place = self.monomials(_identity(self.size)), self.monomials(self.one)
        products = [times(e) for e in self.spanning]
        flat, turned = (fmpq_mat([m.entries() for m in several])
                        for several in (products, [m.transpose() for m in products]))
        traces = flat * fmpq_mat([_identity(self.size).entries()]).transpose()
        values = fmpq_mat([place(e).entries() for e in self.spanning])
        functional = (values.transpose() * values).solve(values.transpose() * traces)
        return (flat * turned.transpose()).rank(), functional.transpose()


def _numerators(apart: fmpq_poly, form: fmpq_mat, functional: fmpq_mat,
                elements: Sequence[fmpq_mat]) -> list[fmpq_poly]:
    """Return the numerators of the rational univariate representation, one for each element x.

    Such a numerator is Σ x(z) m(z) Π (T − λ(y)) over the zeros z, of weight m(z), and the others y. It
    follows from the functional Σ m(z) x(z) at λⁿ x, one Krylov sequence of the transposed matrix for all x.
    """
    rows = []
    for _ in range(apart.degree()):
        rows.append(functional.entries())
        functional = functional * form
    several = fmpq_mat([[x[n, 0] for x in elements] for n in range(form.nrows())])
    sums, turned, found = fmpq_mat(rows) * several, fmpq_poly(apart.coeffs()[::-1]), []
    for m in range(len(elements)):
        product = (turned * fmpq_poly([sums[n, m] for n in range(len(rows))])).coeffs()[:len(rows)]
        found.append(fmpq_poly([fmpq(0)] * (len(rows) - len(product)) + product[::-1]))
    return found


def _identity(size: int) -> fmpq_mat:
    return fmpq_mat([[int(i == j) for j in range(size)] for i in range(size)])


def _algebra(given: Sequence[Terms]) -> _Algebra | None:
    """Return the algebra of some polynomials, none of them 0; None if none of finite dimension is found."""
    most = max((sum(e) for f in given for e in f), default=0)
    for degree in range(most + 1, 2 * most + 5) if given else ():
        algebra = _up_to(degree, given)
        if algebra is not None and algebra.holds(given):
            return algebra
    return None


def _up_to(degree: int, given: Sequence[Terms]) -> _Algebra | None:
    """Return the algebra by Macaulay's matrix up to a degree; None if monomials of each degree are left."""
    columns = sorted(_monomials(degree), key=lambda e: (-sum(e), e))
    place, rows = {e: n for n, e in enumerate(columns)}, []
    for f in given:
        for m in _monomials(degree - max(map(sum, f))):
            row = [fmpq(0)] * len(columns)
            for e, c in on_sphere({product(e, m): c for e, c in f.items()}).items():
                row[place[e]] = c
            rows.append(row)
    reduced, rank = fmpq_mat(rows).rref()
    leads = {next(e for e in columns if reduced[row, place[e]]): row for row in range(rank)}
    left = {sum(e) for e in columns if e not in leads}
    gap = next((n for n in range(degree + 1) if n not in left), None)
    if gap is None:
        return None
    basis = [e for e in columns if e not in leads and sum(e) < gap]

    def coordinates(e: Exponents) -> list[fmpq]:
        if e in leads:
            return [-reduced[leads[e], place[b]] for b in basis]
        return [fmpq(int(e == b)) for b in basis]

    def multiplied(axis: Exponents) -> fmpq_mat:
        products = [on_sphere({product(b, axis): fmpq(1)}).items() for b in basis]
        images = [[(c, coordinates(e)) for e, c in terms] for terms in products]
        return fmpq_mat([[sum((c * x[n] for c, x in terms), fmpq(0)) for terms in images]
                         for n in range(len(basis))])

    return _Algebra(basis, fmpq_mat([[int(b == ONE)] for b in basis]), [multiplied(axis) for axis in AXES])


def _monomials(degree: int) -> list[Exponents]:
    """Return the monomials with k3 at most once: a basis of the polynomials on the sphere."""
    return [(a, b, c) for c in (0, 1) for a in range(degree + 1 - c) for b in range(degree + 1 - a - c)]
