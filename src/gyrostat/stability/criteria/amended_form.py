"""The four numbers that decide a permanent rotation of a body in a field, by its amended potential."""
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from ...algebra.rings.matrices import adjugate, cross

Rows = Sequence[Sequence[Any]]
UPPER = [(i, j) for i in range(3) for j in range(i, 3)]


class AmendedForm(NamedTuple):
    """The invariants of D²U_c across k, and of the motion near a critical point of U_c on abs(k) = 1.

    The amended potential is U_c = U + (C1 − l·k)²/(2 k·Ik).

    Parameters
    ----------
    trace : Any
        of D²U_c on the plane across k [M L²/T²]; if it is positive and the determinant too, U_c is least and
        the rotation stable; if it is negative and the determinant positive, U_c is greatest
    determinant : Any
        of D²U_c on that plane; if it is negative, U_c has a saddle and the rotation is unstable
    p, q : Any
        the coefficients of λ⁴ + p λ² + q on the coadjoint orbit [1/T², 1/T⁴]
    """

    trace: Any
    determinant: Any
    p: Any
    q: Any


def amended_form(inertia: Rows, rotor: Sequence[Any], gradient: Sequence[Any], hessian: Rows,
                 k: Sequence[Any], omega: Any) -> AmendedForm:
    """Return the second variation of a rotation ω = omega k, and its characteristic polynomial.

    With J = k·Ik, v = 2 omega Ik + l and μ = omega k·(omega Ik + l) − k·∇U: across k, D²U_c is K = D²U + μ −
    omega² I + v vᵀ/J; the reduced motion has the inertia A = I − Ik (Ik)ᵀ/J and the gyroscopic term B =
    v·Ik/J − omega tr I: p = J (B² + tr AK)/det I, q = J k·adj(K)k/det I.

    Parameters
    ----------
    inertia : rows, shape (3, 3)
        the tensor I [M L²]; in numbers, balls or expressions, as all that follow
    rotor : sequence, shape (3,)
        l [M L²/T]
    gradient, hessian : sequence, shape (3,), rows, shape (3, 3)
        the first and second derivatives of U at k [M L²/T²]
    k : sequence, shape (3,)
        a direction
    omega : Any
        the rate about k [1/T]

    Returns
    -------
    AmendedForm

    References
    ----------
    Derived by Routh's reduction in docs/explanation/derivations/amended-potential.md, sections 3 and 4;
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59; Lewis, Ratiu, Simo & Marsden, in The
    Geometry of Hamiltonian Systems (1992).

    Examples
    --------
    >>> from fractions import Fraction as Q
    >>> k, slope = [Q(2, 3), Q(1, 3), Q(2, 3)], [0, Q(2, 3), Q(2, 3)]
    >>> moments = [[3, 0, 0], [0, 5, 0], [0, 0, 4]]
    >>> nothing = [[0] * 3] * 3
    >>> found = amended_form(moments, [0] * 3, slope, nothing, k, -1)
    >>> [str(x) for x in found]
    ['-61/33', '8/33', '2/3', '2/135']
    """
    along = [dot(row, k) for row in inertia]               # Ik
    mu = omega * dot(k, [omega * a + l for a, l in zip(along, rotor)]) - dot(k, gradient)
    return with_multiplier(inertia, rotor, mu, hessian, k, omega)


def with_multiplier(inertia: Rows, rotor: Sequence[Any], mu: Any, hessian: Rows, k: Sequence[Any],
                    omega: Any) -> AmendedForm:
    """Return the invariants, if μ is known."""
    along = [dot(row, k) for row in inertia]
    J = dot(k, along)
    v = [2 * omega * a + l for a, l in zip(along, rotor)]
    return of_forms(second_variation(inertia, mu, hessian, v, J, omega), reduced_inertia(inertia, along, J),
                    dot(v, along) / J - omega * trace(inertia), k,
                    J / dot(inertia[0], cross(inertia[1], inertia[2])))


def second_variation(inertia: Rows, mu: Any, hessian: Rows, v: Sequence[Any], J: Any, omega: Any) -> Rows:
    """Return K = D²U + μ − omega² I + v vᵀ/J."""
    square, w = omega**2, [x / J for x in v]
    return _symmetric(lambda i, j: hessian[i][j] - square * inertia[i][j] + v[i] * w[j]
                      + (mu if i == j else 0))


def reduced_inertia(inertia: Rows, along: Sequence[Any], J: Any) -> Rows:
    """Return A = I − Ik (Ik)ᵀ/J."""
    part = [x / J for x in along]
    return _symmetric(lambda i, j: inertia[i][j] - along[i] * part[j])


def _symmetric(entry: Callable[[int, int], Any]) -> Rows:
    """Return the symmetric matrix of three rows whose entries with i ≤ j are given."""
    a, b, c, d, e, f = (entry(i, j) for i, j in UPPER)
    return (a, b, c), (b, d, e), (c, e, f)


def of_forms(K: Rows, A: Rows, B: Any, k: Sequence[Any], scale: Any) -> AmendedForm:
    """Return the invariants by the forms K and A and the gyroscopic term B, with scale = J/det I."""
    determinant = dot(k, [dot(row, k) for row in adjugate(K)])
    return AmendedForm(trace(K) - dot(k, [dot(row, k) for row in K]), determinant,
                       scale * (B * B + sum(dot(a, row) for a, row in zip(A, K))), scale * determinant)


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """Return a·b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def trace(rows: Rows) -> Any:
    """Return the sum of the diagonal."""
    return rows[0][0] + rows[1][1] + rows[2][2]
