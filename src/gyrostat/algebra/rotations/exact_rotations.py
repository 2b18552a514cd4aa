"""The critical points of a quartic form off N = 0 in number fields, multiple ones too, by exact algebra."""
from collections.abc import Sequence

from flint import fmpq, fmpq_mat, fmpq_mpoly, fmpq_poly, fmpz_mat, nmod_mat
from sympy import S

from ..._cached import cached_property
from ..solving.real_fields import Conjugates, FieldNumbers
from .bounds import DEGREE, PRIMES, Bound, times_line, times_norm
from .modular_fractions import by_residues
from .quartic_forms import FRAME, NORM, Exponents, Form, minors, multiples

COORDINATES = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)


class ExactRotations:
    """The critical points of a quartic form over ℚ in number fields, multiple ones too.

    The matrices M_i have x_i/ℓ at the points as eigenvalues, and u has another ratio. At the roots of its
    characteristic polynomial the x_i are as the g_i, which follow from the traces of M_i uʲ (Rouillier); each
    point is inserted into its equations. All f(M_i) vanish on the evaluation at a point, if f is the
    characteristic polynomial of M_i without repeated factors: these leave a dimension, and there are no more
    points.

    Parameters
    ----------
    form : mapping of exponents to int
    bound : Bound

    References
    ----------
    Rouillier, Appl. Algebra Eng. Comm. Comput. 9 (1999) 433-461; Seidenberg, Trans. AMS 197 (1974) 273-313,
    lemma 92.
    """

    def __init__(self, form: Form, bound: Bound):
        self._form, self._bound = form, bound

    @cached_property
    def matrices(self) -> list[fmpq_mat]:
        """Those of the ratios of coordinates, and of a form, to another form: M_0, …, M_3, u."""
        free, matrix = self._bound.free, multiples(minors(self._form), DEGREE, 4)
        square = fmpz_mat([[matrix[n][column] for column in self._bound.solved] for n in self._bound.rows])
        known = fmpz_mat([[-matrix[n][column] for column in free] for n in self._bound.rows])
        functionals = [[fmpq(0)] * len(free) for _ in matrix[0]]
        for column, row in zip(self._bound.solved, square.solve(known).tolist()):
            functionals[column] = row
        for n, column in enumerate(free):
            functionals[column] = [fmpq(n == m) for m in range(len(free))]
        degree = DEGREE
        if self._bound.beyond:
            functionals, degree = times_norm(functionals, degree), degree - 2
        *several, below = (fmpq_mat(times_line(functionals, degree, line, self._bound.lower))
                           for line in (*COORDINATES, *self._bound.lines))
        return [below.solve(above) for above in several]

    @cached_property
    def separating(self) -> fmpq_poly:
        """The characteristic polynomial of u without repeated factors, monic."""
        return _bare(self.matrices[4].charpoly())

    @cached_property
    def conjugate(self) -> bool:
        """Whether all points are proved to be conjugate: an equation of full degree is irreducible."""
        several = self.separating.factor()[1]
        return len(several) == 1 and several[0][0].degree() == self._bound.most

    @cached_property
    def points(self) -> list[FieldNumbers] | None:
        """n and r at every real point off N = 0; None if some may lack."""
        *single, u = self.matrices
        most = self._bound.most
        if self.separating.degree() < most:
            most -= _rank_of_values([_bare(m.charpoly()) for m in single], single, PRIMES[0])
        if self.separating.degree() != most or (tops := _represented(single, u, self.separating)) is None:
            return None
        found: list[FieldNumbers] = []
        for factor, _ in self.separating.factor()[1]:
            place = [top % factor for top in tops]
            if any(_value(f, place, factor) for f in minors(self._form)):
                return None
            square = _value(_terms(NORM), place, factor)
            if square:
                entries = [_value(_terms(x), place, factor) for x in (*FRAME[1], *FRAME[2])]
                conjugates = Conjugates(factor, entries, square)
                found += [FieldNumbers(conjugates, n, [(i, S.One) for i in range(6)])
                          for n in range(len(conjugates.roots()))]
        return found


def _bare(f: fmpq_poly) -> fmpq_poly:
    """Return a polynomial without its repeated factors, monic."""
    bare = f // f.gcd(f.derivative())
    return bare / bare[bare.degree()]


def _represented(single: Sequence[fmpq_mat], u: fmpq_mat, separating: fmpq_poly) -> list[fmpq_poly] | None:
    """Return polynomials whose ratios at the roots are those of the coordinates; found modulo primes."""
    if (found := by_residues(lambda p: _traces(single, u, separating, p))) is None:
        return None
    d, exact = separating.degree(), [fmpq(x.numerator, x.denominator) for x in found]
    return [fmpq_poly(exact[n * d:n * d + d]) for n in range(4)]


def _traces(single: Sequence[fmpq_mat], u: fmpq_mat, separating: fmpq_poly, p: int) -> list[int]:
    """Return the coefficients Σ_j tr(M_i uʲ) aₖ₊ⱼ₊₁ of Tᵏ for each M_i, modulo p; a of the polynomial."""
    *several, turn = (_modulo(m, p) for m in (*single, u))
    d, size = separating.degree(), u.nrows()
    a = [int(c.p) * pow(int(c.q), -1, p) % p for c in separating.coeffs()]
    powers = [nmod_mat(size, size, [int(n % (size + 1) == 0) for n in range(size**2)], p)]
    while len(powers) < d:
        powers.append(powers[-1] * turn)
    found = []
    for m in several:
        traces = [_trace(m * power) for power in powers]
        found += [sum(traces[j] * a[i + j + 1] for j in range(d - i)) % p for i in range(d)]
    return found


def _trace(matrix: nmod_mat) -> int:
    return sum(int(matrix[n, n]) for n in range(matrix.nrows()))


def _modulo(matrix: fmpq_mat, p: int) -> nmod_mat:
    return nmod_mat(matrix.nrows(), matrix.ncols(),
                    [int(x.p) * pow(int(x.q), -1, p) % p for x in matrix.entries()], p)


def _rank_of_values(polynomials: Sequence[fmpq_poly], matrices: Sequence[fmpq_mat], p: int) -> int:
    """Return the rank modulo a prime of all f(M), each under the other; over ℚ it is not less."""
    rows: list[int] = []
    for f, m in zip(polynomials, matrices):
        turn, size = _modulo(m, p), m.nrows()
        value = nmod_mat(size, size, [0] * size**2, p)
        for c in reversed(f.coeffs()):
            value = value * turn
            scalar = int(c.p) * pow(int(c.q), -1, p) % p
            value += nmod_mat(size, size, [scalar * (n % (size + 1) == 0) for n in range(size**2)], p)
        rows += map(int, value.entries())
    size = matrices[0].nrows()
    return nmod_mat(len(rows) // size, size, rows, p).rank()


def _terms(form: fmpq_mpoly) -> dict[Exponents, int]:
    return {(a, b, c, d): int(x.numerator) for (a, b, c, d), x in form.to_dict().items()}


def _value(form: Form, place: Sequence[fmpq_poly], modulus: fmpq_poly) -> fmpq_poly:
    """Return the value of a form at polynomials, modulo another."""
    squares = {(i, j): place[i] * place[j] % modulus for i in range(4) for j in range(i, 4)}
    total = fmpq_poly([0])
    for e, c in form.items():
        if c:
            i, j, *rest = (n for n in range(4) for _ in range(e[n]))
            total += c * (squares[i, j] * squares[rest[0], rest[1]] if rest else squares[i, j])
    return total % modulus
