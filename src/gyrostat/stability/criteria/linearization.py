"""The linearised field on the coadjoint orbit, its characteristic polynomial and eigenvalues.

On the orbit the field is Hamiltonian, so that the polynomial is one in λ²; its roots are in closed form.
"""
from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, I, ImmutableMatrix, Mul, Poly, Pow, S, roots, sqrt

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.rings.matrices import characteristic_coefficients, immutable, multiply
from ...algebra.rings.polynomials import Ring
from ...arguments import checked
from ...errors import ScopeError
from ...mechanics.equilibrium.coadjoint_orbit import orbit_tangent
from ...mechanics.equilibrium.derivation_ring import rows_at_point, signs_over
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...notation import Stored, symbol
from .sextic import factors_in_squares

LAMBDA = symbol("lamda")


@dataclass(frozen=True, repr=False)
class Linearization(Shown, Stored):
    """The linearised field δẋ = J δx on the tangent space T of the coadjoint orbit.

    In its entries dU, d2U stand for the derivatives of U at the equilibrium; equilibrium.insert(…) inserts
    those of a given U.

    Parameters
    ----------
    equilibrium : Equilibrium
    basis : ImmutableMatrix, shape (n, d)
        its columns span T
    matrix : ImmutableMatrix, shape (d, d)
        J on T in that basis [1/T]

    References
    ----------
    Vera & Viguera (2003), §4.1.1 and §5.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> linear = gs.derivation.linearize(gs.inclined(top))
    >>> linear.matrix.shape, linear.factors()[1]
    ((4, 4), (lamda, 2))
    """

    equilibrium: Equilibrium
    basis: ImmutableMatrix
    matrix: ImmutableMatrix

    @cached_property
    def coefficients(self) -> tuple[Expr, ...]:
        """The coefficients c2, c4, … of det(λ − J) = λᵈ + c2 λᵈ⁻² + c4 λᵈ⁻⁴ + … on the orbit.

        Those of odd order vanish, because J is Hamiltonian on the orbit: with λ, −λ is an eigenvalue.
        """
        ring = signs_over(self.equilibrium, self.matrix.flat()).ring
        rows, bottom = ring.matrix(self.matrix.tolist())
        return tuple(ring.quotient(c, bottom**n)
                     for n, c in enumerate(characteristic_coefficients(ring, rows), 1) if n % 2 == 0)

    @property
    def frequency_coefficients(self) -> tuple[Expr, ...]:
        """The coefficients (q,) of λ² + q, or (p, q) of λ⁴ + p λ² + q.

        Raises
        ------
        ScopeError
            the orbit has another dimension: its polynomial has other coefficients, and other criteria
        """
        if len(self.coefficients) not in (1, 2):
            raise ScopeError(f"the characteristic polynomial has the degree {self.matrix.rows} in lamda, "
                             f"with {len(self.coefficients)} "
                             "coefficients: criteria and eigenvalues are those of orbits of dimension 2, "
                             "4 and 6; use characteristic_polynomial()")
        return self.coefficients

    def characteristic_polynomial(self) -> Expr:
        """Return the characteristic polynomial λᵈ + c2 λᵈ⁻² + … in the symbol lamda."""
        size = self.matrix.rows
        return LAMBDA**size + sum((c * LAMBDA ** (size - 2 * n) for n, c in enumerate(self.coefficients, 1)),
                                  S.Zero)

    def factors(self) -> tuple[tuple[Expr, int], ...]:
        """Return the factors of the characteristic polynomial that contain λ, over the rationals.

        Returns
        -------
        tuple of (Expr, int)
            each with its multiplicity
        """
        ring = Ring([polynomial := self.characteristic_polynomial()])
        _, factors = ring.fraction(polynomial)[0].factor()
        index = ring.generators.index(LAMBDA)
        return tuple((ring.expression(f), int(n)) for f, n in factors if f.degrees()[index])

    def eigenvalues(self) -> tuple[Expr, ...]:
        """Return the d roots of the characteristic polynomial, d = 2, 4 or 6, in closed form.

        If q = r² no root is nested: λ = ±i (√(p + 2r) ± √(p − 2r))/2, as (λ² + r)² = λ² (2r − p). At E1 and
        E2 p + 2r is a square, too.

        Returns
        -------
        tuple of Expr
            with multiplicities [1/T]

        References
        ----------
        Vera & Viguera (2003), §4.1.1, whose discriminant (2a + b)² (b² + 4dc) is (p + 2r) (p − 2r).

        Examples
        --------
        >>> import gyrostat as gs
        >>> ball = gs.Gyrostat((1, 1, 1), (0, 0, 0))
        >>> scene = gs.assemble(ball, gs.axial_potential())
        >>> linear = gs.derivation.linearize(gs.hanging(scene))
        >>> linear.eigenvalues()[0]
        I*(pi3_0/2 + sqrt(4*dU + pi3_0**2)/2)
        """
        if len(self.coefficients) == 3:
            squares = [root for factor in factors_in_squares(self.coefficients) for root in _roots(factor)]
            return tuple(s * I * sqrt(-root) for root in squares for s in (1, -1))
        parts = self.frequencies()
        if parts is None:
            p, q = self.frequency_coefficients
            inner = square_root(p**2 - 4 * q)
            return tuple(s * sqrt((-p + t * inner) / 2) for s in (1, -1) for t in (1, -1))
        outer, inner = parts
        if len(self.coefficients) == 1:
            return I * outer, -I * outer
        return tuple(s * I * (outer + t * inner) for s in (1, -1) for t in (1, -1))

    def frequencies(self) -> tuple[Expr, Expr] | None:
        """Return (a, b) with λ = ±i (a ± b), b = 0 if d = 2; None if q is no square, or d = 6.

        Returns
        -------
        tuple of (Expr, Expr) or None
            functions of the names, which may be imaginary at some numbers [1/T]
        """
        if len(self.coefficients) == 3:
            return None
        if len(self.frequency_coefficients) == 1:
            return square_root(self.coefficients[0]), S.Zero
        p, q = self.coefficients
        r = rational_root(q)
        return None if r is None else (square_root(p + 2 * r) / 2, square_root(p - 2 * r) / 2)


@checked
@once
def linearize(eq: Equilibrium) -> Linearization:
    """Return the field linearised at an equilibrium, on the tangent space of its coadjoint orbit.

    Parameters
    ----------
    eq : Equilibrium

    Returns
    -------
    Linearization

    Raises
    ------
    SingularOrbitError
        k = 0 on e(3)*, M = 0 on so(3)*: the differentials of the Casimirs are dependent

    References
    ----------
    Vera & Viguera (2003), §4.1.1 and §5; docs/explanation/derivations/conditions.md, sections 4 and 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.derivation.linearize(gs.inclined(top)).coefficients[1]
    0
    """
    basis = orbit_tangent(eq)
    vectors = basis.tolist()
    free = _free_coordinates(vectors)
    jacobian = rows_at_point(eq, eq.system.jet_jacobian)
    ring = signs_over(eq, [entry for row in (*jacobian, *vectors) for entry in row]).ring
    # J maps T into itself: a column of J on T is read off in coordinates that belong to one vector each
    rows, bottom = ring.matrix([jacobian[i] for i in free])
    columns, _ = ring.matrix(vectors)                  # polynomial: the denominator is 1
    product = multiply(ring, rows, columns)
    scale = [columns[i][j] for j, i in enumerate(free)]
    matrix = immutable([[ring.quotient(entry, bottom * d) for entry in row]
                        for row, d in zip(product, scale)], len(free))
    return Linearization(eq, basis, matrix)


def _free_coordinates(basis: Sequence[Sequence[Expr]]) -> list[int]:
    """Return for each basis vector a coordinate in which all others are 0."""
    found: dict[int, int] = {}
    for i, row in enumerate(basis):
        vectors = [j for j, entry in enumerate(row) if entry]
        if len(vectors) == 1:
            found.setdefault(vectors[0], i)
    return [found[j] for j in range(len(basis[0]))]


def _roots(factor: Sequence[Expr]) -> list[Expr]:
    """Return the roots of a polynomial of degree up to three, by its coefficients."""
    return list(roots(Poly(factor, LAMBDA), multiple=True))


def square_root(expression: Expr) -> Expr:
    """Return the root of a fraction of polynomials, its square factors taken out (up to their sign)."""
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    top = ring.reduce(top)
    if not top:
        return S.Zero
    outside, inside = S.One, S.One
    for polynomial, n_sign in ((top, 1), (bottom, -1)):
        content, factors = polynomial.factor()
        inside *= ring.expression(ring.one * content) ** n_sign
        for factor, n in factors:
            outside *= Pow(ring.expression(factor), n_sign * (int(n) // 2))
            inside *= Pow(ring.expression(factor), n_sign * (int(n) % 2))
    return Mul(outside, sqrt(inside))


def rational_root(expression: Expr) -> Expr | None:
    """Return r with r² the expression, a fraction of polynomials; None if there is none."""
    root = square_root(expression)
    return None if any(p.exp.q == 2 for p in root.atoms(Pow) if p.exp.is_Rational) else root
