"""Real roots of polynomials over transcendental numbers such as π, isolated by ball arithmetic."""
from collections.abc import Sequence
from functools import lru_cache

from flint import acb, arb, arb_poly
from sympy import Expr, Integer, Rational, S, Tuple

from ..enclosures.balls import Enclosed, ball
from ..enclosures.precision import doubled, own_precision

NARROW, LARGEST = 1000, 2**14                          # bits: of a root, of coefficients to isolate it


class RealRoot(Enclosed):
    """A real root of a polynomial, the n-th from below; all complex roots are simple.

    A root of a polynomial with algebraic coefficients is a CRootOf of a polynomial over ℤ. Here the
    coefficients are real constants, of which at least one is transcendental.

    Parameters
    ----------
    coefficients : sequence of Expr
        from the constant term
    n : int

    Examples
    --------
    >>> from sympy import S, pi
    >>> RealRoot([-pi, S.Zero, S.Zero, S.One], 0).evalf(10)
    1.464591888
    """

    def __new__(cls, coefficients: Sequence[Expr], n: int | Integer) -> "RealRoot":
        root: RealRoot = Expr.__new__(cls, Tuple(*coefficients), Integer(n))
        return root

    @property
    def coefficients(self) -> tuple[Expr, ...]:
        """The coefficients, from the constant term on."""
        return tuple(self.args[0])

    def enclosed(self, precision: int) -> arb:
        """Return an enclosure; it is not finite if the precision does not isolate the roots."""
        found = isolated(self.coefficients, precision)
        return arb("nan") if found is None else found[int(self.args[1])]


def roots_by_enclosures(coefficients: Sequence[Expr]) -> list[Expr] | None:
    """Return the real roots in increasing order; None if they are not proved to be simple.

    Examples
    --------
    >>> from sympy import S, pi
    >>> found = roots_by_enclosures([S.One, -pi, S.Zero, S.One])
    >>> [root.evalf(6) for root in found]
    [-1.91416, 0.329720, 1.58444]
    """
    monic, scale = _monic(coefficients)
    for precision in doubled(128, LARGEST):
        if (found := isolated(monic, precision)) is not None:
            return [RealRoot(monic, n) / scale for n in range(len(found))]
    return None


def _monic(coefficients: Sequence[Expr]) -> tuple[tuple[Expr, ...], Expr]:
    """Return a monic polynomial without new denominators, and the positive number that divides its roots.

    With the leading coefficient a and y = a x, aⁿ⁻¹ f(y/a) is monic in y.
    """
    *rest, lead = coefficients
    if isinstance(lead, Rational):
        return tuple(c / lead for c in coefficients), S.One
    if ball(lead, 128) < 0:
        *rest, lead = [-c for c in coefficients]
    powers = [lead ** (len(rest) - 1 - n) for n in range(len(rest))]
    return (*((c * power).expand() for c, power in zip(rest, powers)), S.One), lead


def divided_by_root(coefficients: Sequence[arb], root: arb) -> list[arb]:
    """Divide a polynomial by x − root, by Horner's rule; the remainder is dropped.

    Coefficients stand from the constant term on.
    """
    quotient = [coefficients[-1]]
    for c in coefficients[-2:0:-1]:
        quotient.append(c + root * quotient[-1])
    return quotient[::-1]


@lru_cache(maxsize=256)
def isolated(coefficients: tuple[Expr, ...], precision: int) -> list[arb] | None:
    """Return enclosures of the real roots in increasing order; None if the roots are not told apart."""
    with own_precision(2 * precision):
        return simple_roots(arb_poly([ball(c, 2 * precision) for c in coefficients]), precision)


def simple_roots(polynomial: arb_poly, precision: int) -> list[arb] | None:
    """Return enclosures of the real roots in increasing order; None if not all complex ones are told apart.

    The enclosures of all complex roots are disjoint. One that meets the real line contains a real root if its
    mirror image meets no other: the conjugate of its root then lies in both, and so is the same root.

    Parameters
    ----------
    polynomial : arb_poly
        with coefficients in balls, and the precision set that they have
    precision : int
        bits that are enough for a root
    """
    try:
        found = polynomial.complex_roots(tol=2.0 ** -min(precision, NARROW))
    except ValueError:
        return None
    near = [z for z in found if z.imag.contains(0)]
    for z in near:
        mirrored = acb(z.real, -z.imag)
        if any(other is not z and mirrored.overlaps(other) for other in found):
            return None
    return sorted((z.real for z in near), key=arb.mid)
