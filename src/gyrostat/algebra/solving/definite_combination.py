"""Finds a definite combination of symmetric matrices, with rational coefficients that are proved."""
from collections.abc import Iterator, Sequence
from fractions import Fraction
from operator import mul

from sympy import Dummy, ImmutableMatrix, Rational, oo

from ...errors import ScopeError
from ..enclosures.balls import ball
from ..enclosures.rationals import to_sympy
from ..reals.exact import sign_of_constant
from .roots import between, real_roots

STEPS = 500                                                # of the search for several coefficients
SIMPLEST = (1, 10, 10**3, 10**6, 10**12)                   # denominators that are tried


def definite_combination(form: ImmutableMatrix,
                         others: Sequence[ImmutableMatrix]) -> tuple[Rational, ...] | None:
    """Return rational a with form + Σ aᵢ othersᵢ definite, of either sign; None if none are found.

    They are searched in floats, where a vector at which the sum is not positive corrects them (the
    perceptron's rule), and what is found is proved. If nothing is found, each matrix is tried alone, which is
    complete: a matrix ceases to be definite where its determinant vanishes, and one number is tried between
    any two roots.

    Parameters
    ----------
    form : ImmutableMatrix, shape (n, n)
        symmetric, exact numbers
    others : sequence of ImmutableMatrix, shape (n, n)

    References
    ----------
    Derived.

    Examples
    --------
    >>> from sympy import diag
    >>> definite_combination(diag(1, -1), [diag(-1, 3)])
    (4/7,)
    >>> definite_combination(diag(1, -1), [diag(-1, 1)])
    """
    for found in _searched(form, others):
        if definite(ImmutableMatrix(sum((a * other for a, other in zip(found, others)), form))):
            return found
    for place, other in enumerate(others):
        for a in _along(form, other):
            if definite(form + a * other):
                return tuple(Rational(a if n == place else 0) for n in range(len(others)))
    return None


def definite(form: ImmutableMatrix) -> int:
    """Return the sign of a definite matrix by its leading principal minors, 0 if none is proved."""
    signs = [sign_of_constant(form[:n, :n].det(method="berkowitz")) for n in range(1, form.rows + 1)]
    if all(s == 1 for s in signs):
        return 1
    return -1 if all(s == (-1) ** n for n, s in enumerate(signs, 1)) else 0


def _along(form: ImmutableMatrix, other: ImmutableMatrix) -> Iterator[Rational]:
    """Yield one number in each interval between the roots of the determinant of form + a other."""
    a = Dummy("a")
    try:
        roots = real_roots((form + a * other).det(method="berkowitz").expand(), a)
    except ScopeError:                                     # a transcendental determinant: no roots known
        return
    ends = [] if roots is None else [-oo, *roots, oo]      # None: the sum is singular for every a
    yield from (between(low, high) for low, high in zip(ends, ends[1:]))


def _searched(form: ImmutableMatrix, others: Sequence[ImmutableMatrix]) -> Iterator[tuple[Rational, ...]]:
    """Yield coefficients that are definite in floats, with short denominators first."""
    stack = [[[float(ball(x, 64).mid()) for x in row] for row in matrix.tolist()]
             for matrix in (form, *others)]
    sizes = [sum(x * x for row in matrix for x in row) ** 0.5 or 1.0 for matrix in stack]
    weights = [1.0] + [0.0] * len(others)
    for _ in range(STEPS):
        total = [[sum(w / size * x for w, size, x in zip(weights, sizes, entries)) for entries in zip(*rows)]
                 for rows in zip(*stack)]
        v = _not_positive(total)
        if v is None and weights[0]:
            ratios = [Fraction(w * sizes[0] / (weights[0] * size)) for w, size in zip(weights[1:], sizes[1:])]
            yield from (tuple(to_sympy(r.limit_denominator(n)) for r in ratios) for n in SIMPLEST)
            return
        v = v or [1.0] * form.rows
        square = sum(x * x for x in v)
        weights = [w + sum(x * sum(map(mul, row, v)) for x, row in zip(v, matrix)) / (size * square)
                   for w, size, matrix in zip(weights, sizes, stack)]


def _not_positive(form: list[list[float]]) -> list[float] | None:
    """Return a vector at which a form is not positive, by Gaussian elimination; None if it is definite."""
    vectors = [[float(i == j) for j in range(len(form))] for i in range(len(form))]
    for i, row in enumerate(form):
        if row[i] <= 0:
            return vectors[i]
        for j in range(i + 1, len(form)):
            factor = form[j][i] / row[i]
            form[j] = [x - factor * y for x, y in zip(form[j], row)]
            vectors[j] = [x - factor * y for x, y in zip(vectors[j], vectors[i])]
    return None
