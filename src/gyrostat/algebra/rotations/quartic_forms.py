"""Functions of degree 2 on the rotations as quartic forms in a quaternion, and the equations of their zeros.

A function of degree 2 in the entries of a rotation, times N² with N = q·q, is a quartic form F(q). Its
critical points are the real points of P³ where ∇F is along q: six quartics x_i ∂_jF − x_j ∂_iF vanish, and N
does not.
"""
from collections.abc import Mapping, Sequence
from functools import lru_cache
from math import isqrt
from typing import Any, NamedTuple

from flint import Ordering, ctx, fmpq_mpoly_ctx, fmpz, fmpz_mat, nmod_poly
from sympy import Expr, Rational, pi

from ..enclosures.algebraic import coprime
from ..enclosures.balls import ball

CONTEXT = fmpq_mpoly_ctx.get(("a", "b", "c", "d"), Ordering.lex)
A, B, C, D = GENERATORS = CONTEXT.gens()
NORM = A * A + B * B + C * C + D * D
# t, n, r in body axes, times NORM
FRAME = ((A * A + B * B - C * C - D * D, 2 * (B * C - A * D), 2 * (B * D + A * C)),
         (2 * (B * C + A * D), A * A - B * B + C * C - D * D, 2 * (C * D - A * B)),
         (2 * (B * D - A * C), 2 * (C * D + A * B), A * A - B * B - C * C + D * D))
TRACELESS = (((0, 0, 1), (1, 1, -1)), ((1, 1, 1), (2, 2, -1)), ((0, 1, 1),), ((1, 2, 1),), ((0, 2, 1),))
Exponents = tuple[int, int, int, int]
Form = Mapping[Exponents, Any]
RESIDUE = 1234567891234567891                          # of a transcendental factor


class QuarticForm(NamedTuple):
    """A quartic form over ℚ, and others times irrational factors, as l/ω0 of wheels in rpm has.

    Parameters
    ----------
    whole : mapping of exponents to int
    parts : sequence of (Expr, mapping)
        factors, each the square root of a rational number, or that times π, and forms
    """

    whole: Form
    parts: Sequence[tuple[Expr, Form]] = ()

    def modulo(self, p: int) -> Form | None:
        """Return the form modulo a prime; None if a root has no residue there.

        π stands for any number, since it is transcendental, and √n for the product of the roots of its
        factors in a base of coprime numbers: between these there are no other relations.
        """
        squares = [_square(factor) for factor, _ in self.parts]
        base = coprime({n for n, _, _ in squares})
        roots = {b: root for b in base if (root := _root(b, p)) is not None}
        if len(roots) < len(base):
            return None
        found = self.whole
        for (n, bottom, turns), (_, form) in zip(squares, self.parts):
            residue = pow(bottom, -1, p) * (RESIDUE if turns else 1)
            for b, root in roots.items():
                while n % b == 0:
                    n, residue = n // b, residue * root % p
            found = {e: (c + residue * form[e]) % p for e, c in found.items()}
        return found

    def enclosed(self) -> Form:
        """Return the form with balls at the precision that is set."""
        found = self.whole
        for factor, form in self.parts:
            value = ball(factor, ctx.prec)
            found = {e: c + value * form[e] for e, c in found.items()}
        return found


def is_admitted(factor: Expr) -> bool:
    """Tell whether a number is the square root of a rational number, or that times π."""
    return isinstance(factor**2, Rational) or isinstance((factor / pi) ** 2, Rational)


def _square(factor: Expr) -> tuple[int, int, bool]:
    """Return n, b and whether π is there: a factor is √n/b, or that times π, but for its sign."""
    turns = not isinstance(factor**2, Rational)
    square = (factor / pi) ** 2 if turns else factor**2
    return int(square.p * square.q), int(square.q), turns


def _root(n: int, p: int) -> int | None:
    """Return the root of a number, or one modulo a prime; None if there is none."""
    if isqrt(n) ** 2 == n:
        return isqrt(n)
    return int(fmpz(n % p).sqrtmod(p)) if fmpz(n % p).jacobi(p) == 1 else None


@lru_cache(maxsize=16)
def monomials(degree: int) -> dict[Exponents, int]:
    """Return the monomials of a degree in four variables, each with its place."""
    several = [(i, j, k, degree - i - j - k) for i in range(degree, -1, -1)
               for j in range(degree - i, -1, -1) for k in range(degree - i - j, -1, -1)]
    return {e: n for n, e in enumerate(several)}


def quartic(terms: Mapping[tuple[int, ...], int]) -> dict[Exponents, int] | None:
    """Return N² times a polynomial in n1, n2, n3, r1, r2, r3 as a quartic form.

    One of degree d > 2 in them is of degree 2 in n, r and t = n × r if its form of degree 2d has the factor
    Nᵈ⁻²; else the answer is None.

    Parameters
    ----------
    terms : mapping of exponents to int

    Examples
    --------
    >>> F = quartic({(0, 0, 2, 0, 0, 0): 1})
    >>> F[2, 2, 0, 0], F[2, 0, 0, 2]
    (4, 0)
    """
    degree = max(2, *map(sum, terms), 0)
    whole, entries = CONTEXT.constant(0), (*FRAME[1], *FRAME[2])
    for exponents, c in terms.items():
        part = c * NORM ** (degree - sum(exponents))
        for x, n in zip(entries, exponents):
            part *= x**n
        whole += part
    quotient, rest = divmod(whole, NORM ** (degree - 2))
    if rest:
        return None
    found = {tuple(map(int, e)): int(c.numerator) for e, c in quotient.to_dict().items()}
    return {e: found.get(e, 0) for e in monomials(4)}


def slopes(form: Form) -> list[dict[Exponents, int]]:
    """Return the four derivatives of a form."""
    return [{moved(e, i, -1): c * e[i] for e, c in form.items() if c and e[i]} for i in range(4)]


def minors(form: Form) -> list[dict[Exponents, int]]:
    """Return the six forms x_i ∂_jF − x_j ∂_iF."""
    several, found = slopes(form), []
    for i in range(4):
        for j in range(i + 1, 4):
            minor = {moved(e, i, 1): c for e, c in several[j].items()}
            for e, c in several[i].items():
                place = moved(e, j, 1)
                minor[place] = minor.get(place, 0) - c
            found.append(minor)
    return found


def multiples(forms: Sequence[Form], degree: int, of: int) -> list[list[int]]:
    """Return the rows of all multiples of forms of one degree that have another degree."""
    places, rows = monomials(degree), []
    for form in forms:
        for a, b, c, d in monomials(degree - of):
            row = [0] * len(places)
            for (i, j, k, l), x in form.items():
                row[places[a + i, b + j, c + k, d + l]] = x
            rows.append(row)
    return rows


def at_infinity(form: QuarticForm, primes: Sequence[int]) -> list[int] | None:
    """Return the primes modulo which a form vanishes on N = 0 as it does over ℚ; None if that is not known.

    There q is u ⊗ v with u, v on conics, and F a form of degree 4 in u and in v. Known are products: of a
    symmetric matrix for u, as the tensor of a body, and one for v. Where the product and its slope vanish is
    told by how many eigenvalues each of the two has.
    """
    entries, *others = ([int(x) for x in (_operators() * fmpz_mat([[f[e]] for e in monomials(4)])).entries()]
                        for f in (form.whole, *(part for _, part in form.parts)))
    if any(map(any, others)) or fmpz_mat(5, 5, entries).rank() > 1:
        return None
    row = next((n for n in range(5) if any(entries[5 * n:5 * n + 5])), 0)
    column = next((n for n in range(5) if entries[5 * row + n]), 0)
    pair = _matrix(entries[column::5]), _matrix(entries[5 * row:5 * row + 5])
    return [p for p in primes if all(_eigenvalues(m, p) == _eigenvalues(m) for m in pair)]


def moved(e: Exponents, place: int, by: int) -> Exponents:
    """Return exponents with one of them raised."""
    a, b, c, d = (n + by * (i == place) for i, n in enumerate(e))
    return a, b, c, d


@lru_cache(maxsize=1)
def _operators() -> fmpz_mat:
    """Return what takes a quartic to Q(∂)F, for 25 forms Q = Σ c_ab s_ij R_ai R_bj with traceless c and s."""
    rows = []
    for c in TRACELESS:
        for s in TRACELESS:
            Q = sum((x * y * (FRAME[a][i] * FRAME[b][j] + FRAME[a][j] * FRAME[b][i])
                     for a, b, x in c for i, j, y in s), CONTEXT.constant(0))
            found = {tuple(map(int, e)): int(x.numerator) for e, x in Q.to_dict().items()}
            rows.append([found.get(e, 0) * _factorials(e) for e in monomials(4)])
    return fmpz_mat(rows)


def _factorials(e: Exponents) -> int:
    each = (1, 1, 2, 6, 24)
    return each[e[0]] * each[e[1]] * each[e[2]] * each[e[3]]


def _matrix(products: Sequence[int]) -> list[list[int]]:
    """Return three times the traceless symmetric matrix with given products with those of TRACELESS."""
    first, second, *off = products
    low = -first - 2 * second
    xy, yz, xz = (3 * x for x in off)
    return [[low + 3 * second + 3 * first, xy, xz], [xy, low + 3 * second, yz], [xz, yz, low]]


def _eigenvalues(matrix: Sequence[Sequence[int]], p: int | None = None) -> int:
    """Return how many different eigenvalues a symmetric matrix has, over ℚ or modulo a prime."""
    f = fmpz_mat(matrix).charpoly()
    polynomial = f if p is None else nmod_poly([int(c) % p for c in f.coeffs()], p)
    return polynomial.degree() - polynomial.gcd(polynomial.derivative()).degree()
