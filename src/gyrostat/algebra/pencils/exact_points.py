"""Points of a sphere that a symmetric pencil of matrices takes to a given vector, by its adjugate."""
from collections.abc import Iterator, Sequence

from flint import arb, fmpq_poly
from sympy import Add, CRootOf, Expr, Matrix, S, Symbol, eye, sqrt

from ..._cached import cached_property
from ...errors import ScopeError, brief
from ..enclosures.balls import finite_ball
from ..reals.exact import evaluate, proved_sign
from ..reals.number_fields import in_one
from ..reals.number_matrices import exact
from ..rings.matrices import adjugate, cross
from ..rings.polynomials import Ring
from ..solving.real_fields import BITS, Conjugates, FieldNumbers
from ..solving.roots import in_order, real_roots, roots_of_factor
from .enclosed_points import SimplePoints

HIGHEST = 6                                            # degree of a number with which resultants are taken
NOT_TOLD = ("at {}, of so high a degree, the solutions are not told apart: turn the body into axes in which "
            "a plane of symmetry is one of the planes of coordinates, or round the number to decimals")
Found = tuple[Sequence[Expr], tuple[Expr, ...] | None]


def points_on_sphere(pencil: Matrix, vector: Matrix, radius: Expr, nu: Symbol) -> Iterator[Found]:
    """Yield ν and x of every solution of pencil(ν) x = vector with abs(x) = radius; complete.

    Since x = adj(pencil) vector/det(pencil), ν is a root of abs(adj(pencil) vector)² = radius² det(pencil)²,
    if it is no root of the determinant. At a root of the determinant, x may have any part in the kernel if
    the vector has no part in it.

    Parameters
    ----------
    pencil : Matrix, shape (3, 3)
        symmetric, affine in nu; of full rank for large nu
    vector : Matrix, shape (3, 1)
        exact numbers
    radius : Expr
        positive
    nu : Symbol

    Yields
    ------
    tuple
        ν, x1, x2, x3; the axis about which x may be turned, None if there is none, 0 if x is any point of the
        sphere. At rational numbers ν and x are FieldNumbers, unless they are of degree 1 or 2; with a number
        of high degree they are enclosed if all points are simple

    Raises
    ------
    ScopeError
        with a number of high degree they are not simple, and the pencil is not diagonal

    References
    ----------
    Derived in docs/explanation/derivations/zeros-on-the-sphere.md, section 2.

    Examples
    --------
    >>> from sympy import diag
    >>> nu = Symbol("nu")
    >>> pencil, vector = diag(1, 2, 3) + nu * eye(3), Matrix([0, 0, 2])
    >>> for found in points_on_sphere(pencil, vector, S.One, nu):
    ...     print(found[0])
    (-5, 0, 0, -1)
    (-1, 0, 0, 1)
    """
    ring = Ring([*pencil, *vector, radius, nu])
    if ring.generators == (nu,):
        yield from _at_rational_numbers(ring, pencil, vector, radius, nu)
        return
    high = [g for g in ring.generators if isinstance(g, CRootOf) and g.poly.degree() > HIGHEST]
    if high:
        if lists := SimplePoints(pencil, vector, radius, nu).lists:
            yield from ((numbers, None) for numbers in lists)
            return
        if not pencil.is_diagonal():
            raise ScopeError(NOT_TOLD.format(brief(high[0])))
    above, below, parts = _by_adjugate(pencil, vector)
    for root in real_roots(Add(*(x**2 for x in parts)) - radius**2, nu) or ():
        if proved_sign(evaluate(below, {nu: root})) != 0:
            yield (root, *(evaluate(x, {nu: root}) for x in parts)), None
    for root in real_roots(below, nu) or ():
        for _, x, axis in along_kernel(pencil, above, below, radius, nu, root):
            yield (root, *x), axis


def _by_adjugate(pencil: Matrix, vector: Matrix) -> tuple[Matrix, Expr, list[Expr]]:
    """Return adj(pencil) vector and det(pencil), and their quotients."""
    minors = Matrix(adjugate(pencil.tolist()))
    above, below = minors * vector, Add(*(x * y for x, y in zip(pencil[:, 0], minors[:, 0]))).expand()
    if pencil.is_diagonal():                               # the same, in lowest terms
        return above, below, [x / pencil[n, n] if x else S.Zero for n, x in enumerate(vector)]
    return above, below, [x / below for x in above]


def _at_rational_numbers(ring: Ring, pencil: Matrix, vector: Matrix, radius: Expr, nu: Symbol
                         ) -> Iterator[Found]:
    """Yield the solutions by FLINT's polynomials: one divides another if it vanishes at all roots of it."""
    rows, (given, (size,)) = ([[in_one(ring.numerator(x), 0) for x in row] for row in several]
                              for several in (pencil.tolist(), (vector, (radius,))))
    minors = adjugate(rows)
    above = [sum(x * y for x, y in zip(row, given)) for row in minors]
    below = sum(x * y for x, y in zip(rows[0], minors[0]))
    found: list[tuple[arb, Sequence[Expr]]] = []
    for factor, _ in (sum(x**2 for x in above) - size**2 * below**2).factor()[1]:
        if below % factor:
            found += _Points(factor, above, below, pencil, vector, nu).lists()
    yield from ((numbers, None) for _, numbers in sorted(found, key=lambda pair: pair[0].mid()))
    kernels = [root for factor, order in below.factor()[1] if not any(x % factor**order for x in above)
               for root in roots_of_factor(factor)]
    if kernels:
        tops, under, _ = _by_adjugate(pencil, vector)
        for root in in_order(kernels):
            for _, x, axis in along_kernel(pencil, tops, under, radius, nu, root):
                yield (root, *x), axis


class _Points(Conjugates):
    """The real roots ν of a factor and x, enclosed by FLINT's polynomials and written by SymPy's."""

    def __init__(self, factor: fmpq_poly, tops: Sequence[fmpq_poly], under: fmpq_poly, pencil: Matrix,
                 vector: Matrix, nu: Symbol):
        super().__init__(factor, [fmpq_poly([0, 1]) * under, *tops], under)
        self.pencil, self.vector, self.nu = pencil, vector, nu

    def lists(self) -> Iterator[tuple[arb, Sequence[Expr]]]:
        """Yield an enclosure of each root, and ν and x there, as expressions if these are short."""
        short = self.polynomial.degree() < 3
        roots = [finite_ball(root, BITS) for root in self.exact] if short else self.roots()
        for n, root in enumerate(roots):
            numbers = FieldNumbers(self, n, [(place, S.One) for place in range(4)])
            yield root, tuple(numbers) if short else numbers

    def expression(self, root: int, place: int) -> Expr:
        """Return ν or a component of x."""
        if not place:
            return self.exact[root]
        return evaluate(self._parts[place - 1], {self.nu: self.exact[root]})

    @cached_property
    def _parts(self) -> list[Expr]:
        return _by_adjugate(self.pencil, self.vector)[2]


def along_kernel(pencil: Matrix, above: Matrix, below: Expr, radius: Expr, nu: Symbol, root: Expr
                 ) -> Iterator[tuple[Expr, tuple[Expr, ...], tuple[Expr, ...] | None]]:
    """Yield the solutions at a root of the determinant, simple, double or triple."""
    order = next(n for n in (1, 2, 3) if proved_sign(evaluate(below.diff(nu, n), {nu: root})) != 0)
    if any(proved_sign(evaluate(x.diff(nu, n), {nu: root})) for n in range(order) for x in above):
        return                                             # no x: the vector has a part in the kernel
    if order == 3:
        yield root, (radius, S.Zero, S.Zero), (S.Zero,) * 3
        return
    under = evaluate(below.diff(nu, order), {nu: root})
    across = Matrix([evaluate(x.diff(nu, order), {nu: root}) / under for x in above])
    rest = radius**2 - across.dot(across)
    if (sign := proved_sign(rest)) != 1:
        if sign == 0:
            yield root, tuple(across), None
        return
    here = pencil.xreplace({nu: root})
    if order == 2:                                         # the pencil is λ c cᵀ there
        axis = _column(here)
        e = next(v for v in (Matrix(cross(axis, eye(3)[:, m])) for m in range(3)) if any(v))
        yield root, tuple(across + sqrt(rest / e.dot(e)) * e), tuple(axis)
        return
    e = _column(Matrix(adjugate(here.tolist()))).applyfunc(exact)
    for side in (1, -1):
        yield root, tuple(across + side * sqrt(rest / e.dot(e)) * e), None


def _column(matrix: Matrix) -> Matrix:
    """Return a column that is not 0, of a matrix c cᵀ with three rows."""
    return matrix[:, next(n for n in range(3) if proved_sign(exact(matrix[n, n])) != 0)]
