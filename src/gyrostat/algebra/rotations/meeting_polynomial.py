"""The values of a parameter at which critical points of a quartic form meet, as roots of a polynomial."""
from collections.abc import Sequence
from itertools import combinations_with_replacement

from flint import fmpq, fmpq_poly, nmod_mat, nmod_poly

from ..._cached import cached_property
from ...errors import ScopeError
from .bounds import DEGREE, Bound, times_line, times_norm
from .boxes import TURNS, turned
from .exact_rotations import COORDINATES
from .modular_fractions import by_residues
from .quartic_forms import Form, minors, monomials, multiples

FIRST = 1000                                           # value of the parameter; the next ones follow
STEP, SPARE = 32, 6                                    # values; those which only confirm
MOST, LONGEST = 600, 200                               # values modulo one prime; primes
ALWAYS = "two attitudes meet at every value of the name: give an attitude, steady_motion(scene, n, r)"
TOO_LARGE = ("the polynomial whose roots are the values at which attitudes meet is too large: give numbers "
             "with fewer digits")
Matrices = Sequence[nmod_mat]


class MeetingPolynomial:
    """The product of det K/N⁶ over all critical points of F(q) = Σ sᵏ F_k(q), a rational function of s.

    Here K is the second variation of F/N² if the body is turned. The product is the determinant of a matrix,
    that of multiplication with det K/N⁶ modulo the equations. It is computed at many values of s modulo a
    prime, and interpolated. Where critical points meet, it is 0, unless others go to N = 0. There the
    product of N/ℓ² vanishes, so that its zeros are taken, too.

    Parameters
    ----------
    forms : sequence of Form
        F_k
    bound : Bound
        of F at a value of s that is not special

    References
    ----------
    Derived in docs/explanation/derivations/satellite.md, section 10, formula (17).
    """

    def __init__(self, forms: Sequence[Form], bound: Bound):
        self._forms, self._bound = forms, bound
        self._count = 0                                    # of values that were enough

    @cached_property
    def _equations(self) -> list[tuple[list[int], list[int]]]:
        """For each F_k what is solved, by rows: a square matrix, and what is on the right."""
        found = []
        for form in self._forms:
            matrix = multiples(minors(form), DEGREE, 4)
            rows = [matrix[n] for n in self._bound.rows]
            found.append(([row[c] for row in rows for c in self._bound.solved],
                          [-row[c] for row in rows for c in self._bound.free]))
        return found

    @cached_property
    def _multiplied(self) -> list[tuple[list[int], list[int]]]:
        """For each linear form, by rows: what takes φ to φ(ℓ f), on columns that are solved and free ones."""
        size, degree = len(monomials(DEGREE)), DEGREE
        functionals = [[int(n == m) for m in range(size)] for n in range(size)]
        if self._bound.beyond:
            functionals, degree = times_norm(functionals, degree), degree - 2
        found = []
        for line in (*COORDINATES, self._bound.lines[1]):
            rows = times_line(functionals, degree, line, self._bound.lower)
            found.append(([row[c] for row in rows for c in self._bound.solved],
                          [row[c] for row in rows for c in self._bound.free]))
        return found

    @cached_property
    def _bends(self) -> list[list[list[int]]]:
        """For each F_k the six different entries of K, by monomials."""
        pairs = [*combinations_with_replacement(TURNS, 2)]
        return [[[int(bend.get(e, 0)) for e in monomials(4)]
                 for a, b in pairs for bend in [turned(turned(form, a), b)]] for form in self._forms]

    @cached_property
    def bare(self) -> fmpq_poly:
        """The polynomial with the zeros and poles of the product as simple roots.

        Its coefficients are fractions that one more prime of 62 bits confirms.

        Raises
        ------
        ScopeError
            the product is 0 at every s, or of too high a degree
        """
        degree = -1

        def residues(p: int) -> list[int] | None:
            nonlocal degree
            found = self._modulo(p)
            if found.degree() < degree:                    # modulo this prime some of the roots coincide
                return None
            degree = found.degree()
            return [int(c) for c in found.coeffs()]

        if (coefficients := by_residues(residues, LONGEST)) is None:
            raise ScopeError(TOO_LARGE)
        return fmpq_poly([fmpq(c.numerator, c.denominator) for c in coefficients])

    def _modulo(self, p: int) -> nmod_poly:
        """Return the polynomial modulo a prime, monic."""
        product, s = _Modulo(self, p), FIRST
        values: dict[int, tuple[int, int]] = {}
        while len(values) < MOST and s < FIRST + 2 * MOST:
            for _ in range(max(STEP, self._count - len(values))):
                if (value := product.at(s)) is not None:
                    values[s] = value
                s += 1
            (above, below), (norm, under) = (
                _interpolated({s: value[n] for s, value in values.items()}, p) for n in (0, 1))
            needed = max(above.degree() + below.degree(), norm.degree() + under.degree()) + 1 + SPARE
            if not above:
                raise ScopeError(ALWAYS)
            if needed <= len(values):
                self._count = needed
                whole = above * below * norm
                return _monic(whole // whole.gcd(whole.derivative()))
        raise ScopeError(TOO_LARGE)


class _Modulo:
    """The product modulo a prime, with matrices that depend on s as the forms do."""

    def __init__(self, of: MeetingPolynomial, p: int):
        self._p, self._bends = p, of._bends
        most, solved = of._bound.most, len(of._bound.solved)
        self._equations = [(_matrix(a, solved, p), _matrix(b, most, p)) for a, b in of._equations]
        self._multiplied = [(_matrix(a, solved, p), _matrix(b, most, p)) for a, b in of._multiplied]

    def at(self, s: int) -> tuple[int, int] | None:
        """Return the product, and that of N/ℓ², at a value of s; None if a matrix is singular."""
        square, known = (self._sum(several, s) for several in zip(*self._equations))
        try:
            rest = square.solve(known)
            *above, below = (a * rest + b for a, b in self._multiplied)
            inverse = below.inv()
        except ZeroDivisionError:
            return None
        x = [inverse * m for m in above]
        squares = {(i, j): x[i] * x[j] for i in range(4) for j in range(i, 4)}
        powers = [squares[i, j] * squares[k, l] for e in monomials(4)
                  for i, j, k, l in [[n for n in range(4) for _ in range(e[n])]]]
        norm = int(sum((squares[n, n] for n in range(1, 4)), squares[0, 0]).det())
        if not norm:
            return None
        K = []
        for entries in zip(*self._bends):
            total = 0 * powers[0]
            for place, several in enumerate(zip(*entries)):
                if c := sum(c * s**k for k, c in enumerate(several)) % self._p:
                    total += powers[place] * c
            K.append(total)
        a, b, c, d, e, f = K                               # rows (a, b, c), (b, d, e), (c, e, f)
        whole = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d)
        return int(whole.det()) * pow(norm, -6, self._p) % self._p, norm

    def _sum(self, several: Matrices, s: int) -> nmod_mat:
        return sum((m * (s**k % self._p) for k, m in enumerate(several[1:], 1)), several[0])


def _matrix(entries: Sequence[int], columns: int, p: int) -> nmod_mat:
    return nmod_mat(len(entries) // columns, columns, [x % p for x in entries], p)


def _interpolated(values: dict[int, int], p: int) -> tuple[nmod_poly, nmod_poly]:
    """Return numerator and denominator of the rational function of least degree with given values.

    References
    ----------
    von zur Gathen & Gerhard, Modern Computer Algebra, 3rd ed. (2013), section 5.8.
    """
    f, whole = nmod_poly([0], p), nmod_poly([1], p)
    for x, y in values.items():
        f += whole * ((y - int(f(x))) * pow(int(whole(x)), -1, p) % p)
        whole *= nmod_poly([-x % p, 1], p)
    above, rest, old, new = whole, f, nmod_poly([0], p), nmod_poly([1], p)
    best = rest, new
    while rest.degree() >= 0:
        quotient = above // rest
        above, rest, old, new = rest, above - quotient * rest, new, old - quotient * new
        if rest.degree() + new.degree() < best[0].degree() + best[1].degree() and rest.degree() >= 0:
            best = rest, new
    return best


def _monic(f: nmod_poly) -> nmod_poly:
    return f * pow(int(f[f.degree()]), -1, int(f.modulus()))
