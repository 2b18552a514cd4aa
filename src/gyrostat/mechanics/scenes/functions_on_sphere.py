"""Brings functions of k on the sphere abs(k)² = r² to a normal form, and finds those of k3 alone."""
from flint import fmpq_mpoly
from sympy import Expr, ImmutableMatrix, Integer, Pow, S, Symbol, radsimp

from ...algebra.reals.exact import sign_of_constant
from ...algebra.rings.polynomials import Ring, by_degree, lowest_terms
from .potential import DIRECTIONS

K1, K2, K3 = DIRECTIONS


def along_third(U: Expr, rotation: ImmutableMatrix, square_radius: Expr = S.One) -> Expr | None:
    """Return U on abs(k)² = square_radius as a function of k3' alone, where k' = rotation k.

    None is returned if that is not proved. k1'² is replaced by square_radius − k2'² − k3'², in the arguments
    of functions first, and denominators are freed of k1'. On the sphere that form is unique, as far as the
    functions that are left in it are independent.

    Examples
    --------
    >>> from sympy import Matrix, exp
    >>> thirds = ImmutableMatrix([[2, -1, -2], [-1, 2, -2], [2, 2, 1]]) / 3
    >>> U = exp(2*K1 + 2*K2 + K3) - K1**2 - K2**2 - K3**2
    >>> along_third(U, thirds), along_third(K1, thirds)
    (exp(3*k3) - 1, None)
    """
    turned = U.xreplace(dict(zip(DIRECTIONS, rotation.T * ImmutableMatrix(DIRECTIONS))))
    found = _reduced(turned, square_radius)
    return None if found.free_symbols & {K1, K2} else found


def _reduced(U: Expr, square_radius: Expr) -> Expr:
    """Return the normal form, free of k1 and k2 if it is proved to be."""
    functions = {f: f.func(*(_reduced(a, square_radius) for a in f.args)) for f in _functions(U)}
    U = U.xreplace(functions)
    if not U.free_symbols & {K1, K2}:
        return U
    ring = Ring([U, *DIRECTIONS, square_radius])
    square, below = ring.fraction(square_radius)
    square = square - below * (ring.gens[K2] ** 2 + ring.gens[K3] ** 2)                    # below · k1²
    (a, b), n = _parted(ring, ring.fraction(U)[0], square, below)
    (c, d), m = _parted(ring, ring.fraction(U)[1], square, below)
    a, b, c, d = a * below**m, b * below**m, c * below**n, d * below**n
    # (a + b k1)/(c + d k1) = (a + b k1)(c − d k1)/(c² − d² k1²)
    if d:
        a, b, c = (ring.reduce(x) for x in ((a * c * below - b * d * square), (b * c - a * d) * below,
                                            (c * c * below - d * d * square)))
    b, c, k2 = _proved(ring, b), _proved(ring, c), ring.generators.index(K2)
    if b or not c:
        return U
    flat = [_proved(ring, by_degree(part, k2, max(part.degrees()[k2], 0))[0]) for part in (a, c)]
    if not flat[1] or _proved(ring, a * flat[1] - c * flat[0]):
        return U
    return lowest(ring.quotient(*flat))


def _proved(ring: Ring, polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """Return the polynomial without the terms whose coefficient, a number, is proved to be 0."""
    polynomial, names = ring.reduce(polynomial), {s for g in ring.generators for s in g.free_symbols}
    kept = ((kind, c) for kind, c in ring.coefficients(polynomial, names).items() if c.is_constant()
            or not vanishes(ring.expression(c)))
    return sum((c * polynomial.context().from_dict({kind: 1}) for kind, c in kept), ring.zero)


def _parted(ring: Ring, polynomial: fmpq_mpoly, square: fmpq_mpoly,
            below: fmpq_mpoly) -> tuple[list[fmpq_mpoly], int]:
    """Return even and odd with belowⁿ · polynomial = even + odd k1 if below · k1² = square; and n."""
    polynomial, place = ring.reduce(polynomial), ring.generators.index(K1)
    degree = max(polynomial.degrees()[place], 0)
    parts = [ring.zero, ring.zero]
    for n, coefficient in enumerate(by_degree(polynomial, place, degree)):
        parts[n % 2] += coefficient * square ** (n // 2) * below ** (degree // 2 - n // 2)
    return [ring.reduce(part) for part in parts], degree // 2


def _functions(node: Expr) -> set[Expr]:
    """Return the outermost functions and roots that contain k1 or k2."""
    if isinstance(node, Symbol) or not node.free_symbols & {K1, K2}:
        return set()
    if node.is_Add or node.is_Mul or isinstance(node, Pow) and isinstance(node.exp, Integer):
        return set().union(*map(_functions, node.args))
    return {node}


def vanishes(expression: Expr) -> bool:
    """Tell whether an expression is proved to be 0."""
    value = lowest(expression)
    return value == 0 or not value.free_symbols and sign_of_constant(value) == 0


def lowest(expression: Expr) -> Expr:
    """Return an expression in lowest terms; a number has no roots in its denominator."""
    value = lowest_terms(expression)
    return value if value.free_symbols or value.is_Rational else radsimp(value)
