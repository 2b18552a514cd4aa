"""The points that two plane curves F(x, y) = 0 = G(x, y) have in common: y by a resultant, x in balls."""
from collections.abc import Sequence
from math import prod

from flint import arb, arb_mat, arb_poly, fmpq_mpoly, fmpq_poly

from ..enclosures.precision import own_precision
from ..enclosures.real_roots import isolated_roots
from ..reals.number_fields import in_one
from ..rings.polynomials import by_degree


class CommonPoints:
    """The common points of two curves, as far as they lie over simple roots y of the resultant in x.

    The leading coefficient of G in x is a constant, so that the resultant is one times Π F(α, y) over the
    roots α of G: over each of its simple roots lies one common point, and x is real if y is.

    Parameters
    ----------
    F, G : fmpq_mpoly
        in x and y, both of positive degree in x
    x, y : int
        the places of x and y among the generators

    Attributes
    ----------
    simple : fmpq_poly
        the product over the simple roots
    multiple : list of fmpq_poly
        the products over the others, by multiplicity; [0] if F and G have a curve in common

    Examples
    --------
    >>> from flint import Ordering, fmpq_mpoly_ctx
    >>> x, y = fmpq_mpoly_ctx.get(("x", "y"), Ordering.lex).gens()
    >>> met = CommonPoints(x * y - 2, x**2 + y**2 - 5, 0, 1)
    >>> [(round(float(x.mid()), 6), round(float(y.mid()), 6)) for x, y in met.points(64)]
    [(-1.0, -2.0), (-2.0, -1.0), (2.0, 1.0), (1.0, 2.0)]
    """

    def __init__(self, F: fmpq_mpoly, G: fmpq_mpoly, x: int, y: int):
        self._parts = [[in_one(part, y) for part in by_degree(f, x, f.degrees()[x])] for f in (F, G)]
        resultant = in_one(F.resultant(G, F.context().names()[x]), y)
        self.degree = resultant.degree()
        factors = resultant.numer().factor_squarefree()[1] if resultant else [(resultant, 0)]
        self.simple = prod((fmpq_poly(f) for f, n in factors if n == 1), start=fmpq_poly([1]))
        self.multiple = [fmpq_poly(f) for f, n in factors if n != 1]

    def points(self, precision: int) -> list[tuple[arb, arb]]:
        """Return enclosures of the real points (x, y), by y; x is not finite if the precision is too low."""
        with own_precision(precision):
            roots = isolated_roots(self.simple)
        return list(zip(self.over(roots, precision), roots))

    def over(self, roots: Sequence[arb], precision: int) -> list[arb]:
        """Return enclosures of x over enclosures of some roots y of `simple`."""
        with own_precision(precision):
            F, G = ([arb_poly(part) for part in parts] for parts in self._parts)
            return [_shared([f(y) for f in F], [g(y) for g in G]) for y in roots]


def _shared(F: Sequence[arb], G: Sequence[arb]) -> arb:
    """Return the root that two polynomials share, given by their coefficients from the constant term on.

    Powers of the root span the kernel of Sylvester's matrix. Its rows depend on each other by F A = G B with
    the cofactors A and B, and the first row of F has the leading coefficient of A, hence of G, which is not
    0: without that row, the powers are the solution of a linear system.
    """
    m, n = len(F) - 1, len(G) - 1
    rows = [[*[0] * (m + n - 1 - size - shift), *reversed(f), *[0] * shift]
            for f, size, count in ((F, m, n - 1), (G, n, m)) for shift in range(count)]
    try:
        powers = arb_mat([row[:-1] for row in rows]).solve(arb_mat([[-row[-1]] for row in rows]))
    except ZeroDivisionError:                              # not proved to be invertible at this precision
        return arb("nan")
    return powers[m + n - 2, 0]
