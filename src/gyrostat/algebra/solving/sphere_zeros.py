"""All common zeros of polynomials over ℚ on the sphere k·k = 1: single points, and curves."""
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from flint import fmpq, fmpq_poly
from sympy import Expr, S, Symbol

from ...errors import ScopeError
from ..rings.polynomials import Ring
from .opposite_zeros import opposite_zeros
from .real_fields import Conjugates, FieldNumbers
from .sphere_curves import SphereCurve, Terms, on_sphere, split
from .sphere_points import finite_zeros


class ZeroSet(NamedTuple):
    """Points that are isolated or singular, and curves with real arcs, on which no such point lies."""

    points: list[FieldNumbers]
    curves: list[SphereCurve]


def zeros_on_sphere(polynomials: Sequence[Expr], k: Sequence[Symbol],
                    but: Expr = S.One, over_it: Sequence[Expr] = ()) -> ZeroSet | None:
    """Return every real common zero of polynomials with k·k = 1, exactly; None if all of the sphere is one.

    What they have in common on the sphere is divided out: of the rest the complex zeros are finitely many. A
    common factor without a real arc has real zeros only where it is singular, and these are finitely many,
    too.

    Parameters
    ----------
    polynomials : sequence of Expr
        with rational coefficients
    k : sequence of Symbol, shape (3,)
    but : Expr
        a polynomial whose zeros are left out
    over_it : sequence of Expr
        polynomials f whose quotients f/but at a point follow its coordinates

    Raises
    ------
    ScopeError
        the zeros are too many

    Examples
    --------
    >>> import gyrostat as gs
    >>> k1, k2, k3 = k = [gs.symbol(f"k{n}") for n in (1, 2, 3)]
    >>> products = [k1 * k2, k3 * k2, k1 * k3]
    >>> [tuple(x) for x in zeros_on_sphere(products, k, but=k1 + k3).points]
    [(0, 0, 1), (0, 0, -1), (1, 0, 0), (-1, 0, 0)]
    >>> points, (circle,) = zeros_on_sphere([k1 * k2, k1 * k3], k)
    >>> [tuple(x) for x in points], circle.axis
    ([(1, 0, 0), (-1, 0, 0)], (1, 0, 0))
    """
    ring = Ring([*polynomials, but, *over_it, *k])
    places = [ring.generators.index(x) for x in k]
    given, (left_out, *above) = ([on_sphere({tuple(e[n] for n in places): c for e, c in ring.numerator(
        f).to_dict().items()}) for f in several] for several in (polynomials, (but, *over_it)))
    if not (given := [f for f in given if f]):
        return None
    pairs = opposite_zeros(given, [left_out], above, lambda: _finite(given, [], left_out, above))
    if pairs is not None:
        return ZeroSet(pairs, [])
    curves, rests = split(given)
    curves = [curve for curve in curves if not curve.divides(left_out)]
    arcs, bare = ([curve for curve in curves if bool(curve.samples) is real] for real in (True, False))
    points = list(_finite(rests, curves, left_out, above))
    for n, curve in enumerate(bare):
        points += _finite(curve.singular, [*arcs, *bare[:n]], left_out, above)
    if _at_top(left_out) and not any(map(_at_top, given)) and all(_at_top(curve.terms) for curve in curves):
        points += [_top(left_out, above)] if any(map(_at_top, rests)) else []
    return ZeroSet(points, arcs)


def _finite(system: Sequence[Terms], but: Sequence[SphereCurve], left_out: Terms, above: Sequence[Terms]
            ) -> Iterable[FieldNumbers]:
    found = finite_zeros(system, [left_out, *(curve.terms for curve in but)], above)
    if found is None:
        raise ScopeError("the polynomials have more zeros on the sphere than are found: give a field of "
                         "lower degree")
    return found


def _at_top(f: Terms) -> fmpq:
    """Return the value at (0, 0, 1), which the projection does not show."""
    return sum((c for (a, b, _), c in f.items() if not a + b), fmpq(0))


def _top(bottom: Terms, above: Sequence[Terms]) -> FieldNumbers:
    """Return (0, 0, 1) and the quotients there."""
    values = [0, 0, 1, *(_at_top(f) / _at_top(bottom) for f in above)]
    numbers = Conjugates(fmpq_poly([0, 1]), [fmpq_poly([x]) for x in values], fmpq_poly([1]))
    return FieldNumbers(numbers, 0, [(n, S.One) for n in range(len(values))])
