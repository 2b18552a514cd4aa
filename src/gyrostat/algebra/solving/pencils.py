"""Points of a sphere that a symmetric pencil of matrices takes to a given vector, by its adjugate."""
from collections.abc import Iterator

from sympy import Add, Expr, Matrix, S, Symbol, eye, sqrt

from ..reals.exact import evaluate, proved_sign
from ..reals.number_matrices import exact
from ..rings.matrices import adjugate, cross
from .roots import real_roots

Found = tuple[Expr, tuple[Expr, ...], tuple[Expr, ...] | None]


def points_on_sphere(pencil: Matrix, vector: Matrix, radius: Expr, nu: Symbol) -> Iterator[Found]:
    """Yield ν and x of every solution of pencil(ν) x = vector with abs(x) = radius; complete.

    Since x = adj(pencil) vector/det(pencil), ν is a root of abs(adj(pencil) vector)² = radius² det(pencil)²,
    if it is no root of the determinant. At a root of the determinant, x may have any part in the kernel if
    the vector has no part in it.

    Parameters
    ----------
    pencil : Matrix, shape (3, 3)
        symmetric, affine in nu
    vector : Matrix, shape (3, 1)
        exact numbers
    radius : Expr
        positive
    nu : Symbol

    Yields
    ------
    tuple
        ν; x; the axis about which x may be turned, None if there is none, 0 if x is any point of the sphere

    References
    ----------
    Derived in docs/explanation/derivations/zeros-on-the-sphere.md, section 2.

    Examples
    --------
    >>> from sympy import diag
    >>> nu = Symbol("nu")
    >>> pencil, vector = diag(1, 2, 3) + nu * eye(3), Matrix([0, 0, 2])
    >>> for found in points_on_sphere(pencil, vector, S.One, nu):
    ...     print(*found[:2])
    -5 (0, 0, -1)
    -1 (0, 0, 1)
    """
    minors = Matrix(adjugate(pencil.tolist()))
    above, below = minors * vector, Add(*(x * y for x, y in zip(pencil[:, 0], minors[:, 0]))).expand()
    parts = [x / below for x in above]
    if pencil.is_diagonal():                               # the same, in lowest terms
        parts = [x / pencil[n, n] if x else S.Zero for n, x in enumerate(vector)]
    for root in real_roots(Add(*(x**2 for x in parts)) - radius**2, nu) or ():
        if proved_sign(evaluate(below, {nu: root})) != 0:
            yield root, tuple(evaluate(x, {nu: root}) for x in parts), None
    for root in real_roots(below, nu) or ():
        yield from along_kernel(pencil, above, below, radius, nu, root)


def along_kernel(pencil: Matrix, above: Matrix, below: Expr, radius: Expr, nu: Symbol,
                  root: Expr) -> Iterator[Found]:
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
