"""Which combination of symmetric matrices is definite, with rational coefficients that are proved."""
from collections.abc import Iterator, Sequence
from fractions import Fraction

from mpmath import fp
from sympy import Dummy, Expr, ImmutableMatrix, Rational, oo

from ..errors import ScopeError
from .balls import ball
from .exact import sign_of_constant
from .roots import between, real_roots

STEPS = 300                                                # of the search for several coefficients
SIMPLEST = (1, 10, 10**3, 10**6, 10**12)                   # denominators that are tried


def definite_combination(form: ImmutableMatrix,
                         others: Sequence[ImmutableMatrix]) -> tuple[Rational, ...] | None:
    """Rational numbers a with form + Σ aᵢ othersᵢ definite, of either sign; None if none are found.

    With one other matrix the search is complete: a definite matrix ceases to be one where the determinant
    vanishes, and between its roots, with algebraic entries, one number is tried. With several the vector of
    the least eigenvalue corrects the coefficients, in floats, and what is found is proved (perceptron).

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
    (1/2,)
    >>> definite_combination(diag(1, -1), [diag(1, -2)])
    """
    complete = True
    for place in range(len(others)):
        numbers = _along(form, others[place])
        complete = complete and numbers is not None
        for a in numbers or ():
            coefficients = tuple(Rational(a if n == place else 0) for n in range(len(others)))
            if definite(_combined(form, others, coefficients)):
                return coefficients
    if complete and len(others) < 2:
        return None
    return next((found for found in _searched(form, others)
                 if definite(_combined(form, others, found))), None)


def definite(form: ImmutableMatrix) -> int:
    """The sign of a definite matrix by its leading principal minors, 0 if it is not proved to be definite."""
    signs = [sign_of_constant(form[:n, :n].det(method="berkowitz")) for n in range(1, form.rows + 1)]
    if all(s == 1 for s in signs):
        return 1
    return -1 if all(s == (-1) ** n for n, s in enumerate(signs, 1)) else 0


def _along(form: ImmutableMatrix, other: ImmutableMatrix) -> list[Rational] | None:
    """One number in each interval between the roots of the determinant of form + a other; None: not known."""
    a = Dummy("a")
    try:
        roots = real_roots((form + a * other).det(method="berkowitz").expand(), a)
    except ScopeError:                                     # a transcendental determinant
        return None
    ends = [] if roots is None else [-oo, *roots, oo]      # none: singular for every a
    return [between(low, high) for low, high in zip(ends, ends[1:])]


def _combined(form: ImmutableMatrix, others: Sequence[ImmutableMatrix],
              coefficients: Sequence[Expr]) -> ImmutableMatrix:
    return ImmutableMatrix(sum((a * other for a, other in zip(coefficients, others)), form))


def _searched(form: ImmutableMatrix, others: Sequence[ImmutableMatrix]) -> Iterator[tuple[Rational, ...]]:
    """What is definite in floats, with short denominators first."""
    stack = [fp.matrix([[float(ball(x, 64).mid()) for x in row] for row in matrix.tolist()])
             for matrix in (form, *others)]
    sizes = [fp.mnorm(x, "f") or 1.0 for x in stack]
    weights = [1.0] + [0.0] * len(others)
    for _ in range(STEPS):
        total = sum((w / size * x for w, size, x in zip(weights, sizes, stack)), fp.zeros(form.rows))
        values, vectors = fp.eigsy(total)
        if values[0] > 0 and weights[0]:
            ratios = [Fraction(w * sizes[0] / (weights[0] * size)) for w, size in zip(weights[1:], sizes[1:])]
            yield from (tuple(Rational(*r.limit_denominator(n).as_integer_ratio()) for r in ratios)
                        for n in SIMPLEST)
            return
        v = vectors[:, 0]
        weights = [w + (v.T * x * v)[0] / size for w, size, x in zip(weights, sizes, stack)]
