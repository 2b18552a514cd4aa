"""Binary forms: the signs that they take, and the lowest value along the valley of a sum of forms.

The signs of a form are those between its real roots, on the line x = 1. The valley is expanded as in the
splitting lemma: x is eliminated by the power series along which the slope in x is 0.
"""
from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from flint import arb
from sympy import Dummy, Expr, S, binomial, oo

from ...errors import ScopeError
from ..enclosures.balls import ball
from ..reals.exact import proved_sign
from ..rings.polynomials import lowest_terms
from .roots import between, real_roots

Form = Mapping[tuple[int, int], Expr]                  # coefficients of xⁱ yʲ, none of them 0
Y, FINEST = Dummy("y", real=True), 10                  # how often a range of directions is halved


def values_of(form: Form, degree: int) -> set[int]:
    """Return the signs that a homogeneous form takes away from 0, each proved.

    Raises
    ------
    ScopeError
        a sign is not proved: coefficients are transcendental, and the form is 0 somewhere, or almost

    Examples
    --------
    >>> values_of({(2, 0): S.One, (0, 2): -2 * S.One}, 2) == {-1, 0, 1}
    True
    >>> values_of({(4, 0): S.One, (0, 4): S.One}, 4)
    {1}
    """
    scale = next(iter(form.values()))
    # on the line x = 1; the direction x = 0, which it does not meet, comes last
    line = sum((lowest_terms(c / scale) * Y**j for (_, j), c in form.items()), S.Zero)
    try:
        roots = real_roots(line, Y) or []
    except ScopeError:
        return _values_in_balls(form, degree)
    ends = [-oo, *roots, oo]
    values = {proved_sign(line.xreplace({Y: between(a, b)}))
              for a, b in zip(ends, ends[1:])} | ({0} if roots else set())
    values.add(proved_sign(lowest_terms(form.get((0, degree), S.Zero) / scale)))
    if degree % 2:
        values |= {-v for v in values}
    return {v * proved_sign(scale) for v in values}


def _values_in_balls(form: Form, degree: int) -> set[int]:
    """Return the signs by enclosures of the form over ranges of directions.

    Single directions of value 0 are not found.
    """
    values: set[int] = set()
    unknown = False
    # (1, y) and (x, 1) between −1 and 1; the others have the same or the opposite sign
    for straight in (True, False):
        row = [ball(form.get((degree - n, n) if straight else (n, degree - n), S.Zero), 128)
               for n in range(degree + 1)]
        ranges = [(arb(0), 0)]
        while ranges:
            middle, depth = ranges.pop()
            at = arb(middle, arb(2) ** -depth)
            value = sum((c * at**n for n, c in enumerate(row)), arb(0))
            if value > 0 or value < 0:
                values |= {1 if value > 0 else -1}
            elif depth < FINEST:
                ranges += [(middle + step * arb(2) ** -(depth + 1), depth + 1) for step in (-1, 1)]
            else:
                unknown = True
    if unknown and -1 not in values:
        raise ScopeError("the leading form has transcendental coefficients and is 0 along a direction, or "
                         "almost, so that its signs are not proved: round its numbers to decimals")
    return values | ({0} if unknown else set()) | ({-v for v in values} if degree % 2 else set())


def valley(forms: Sequence[Form]) -> Iterator[Expr]:
    """Yield the coefficients of y³, y⁴, … in the lowest value over x, if the second form is a square.

    The second form is a x² after a shear, and after x and y are exchanged if there is no x² in it.

    Examples
    --------
    >>> square, mixed = {(2, 0): S.One}, {(1, 2): 2 * S.One}
    >>> list(valley([{}, {}, square, mixed, {(0, 4): S.One}]))    # (x + y²)²
    [0, 0]
    """
    if (2, 0) not in forms[2]:
        forms = [{(j, i): c for (i, j), c in form.items()} for form in forms]
    square = forms[2][2, 0]
    shear = -forms[2].get((1, 1), S.Zero) / (2 * square)
    sheared: dict[tuple[int, int], Expr] = {}
    for (i, j), c in (term for form in forms[3:] for term in form.items()):
        for n in range(i + 1):
            place = n, i + j - n
            sheared[place] = sheared.get(place, S.Zero) + c * binomial(i, n) * shear ** (i - n)
    bottom = [S.Zero, S.Zero]                          # x = Σ bottom[n] yⁿ, where the slope along x is 0

    @cache                                             # each term that is asked for is final by then
    def power(exponent: int, n: int) -> Expr:
        """Return the coefficient of yⁿ in a power of x."""
        if exponent < 2:
            return bottom[n] if exponent else S.One if n == 0 else S.Zero
        return sum((bottom[m] * power(exponent - 1, n - m) for m in range(2, n - 2 * exponent + 3)), S.Zero)

    for n in range(3, len(forms)):
        slope = sum((i * c * power(i - 1, n - 1 - j) for (i, j),
                     c in sheared.items() if i and j < n), S.Zero)
        bottom.append(lowest_terms(-slope / (2 * square)))
        yield lowest_terms(square * power(2, n)
                    + sum((c * power(i, n - j) for (i, j), c in sheared.items() if j <= n), S.Zero))
