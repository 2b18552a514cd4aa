"""Expands the energy of a body in a field in canonical coordinates of its coadjoint orbit."""
from collections.abc import Callable, Sequence
from math import factorial
from typing import Any

from ...algebra.rings.series import Part, Series, is_zero, powers, variable
from ..criteria.amended_form import Rows, dot

A, D, Z, B = range(4)                                  # the canonical coordinates, {a, d} = {z, b} = 1


def energy_on_orbit(inverse: Rows, rotor: Sequence[Any], k: Sequence[Any], momentum: Sequence[Any],
                    potential: Callable[[Sequence[Series]], Series], upright: int, degree: int,
                    square_of_k: Any = 1) -> list[Part]:
    """Return homogeneous parts of h in (a, d, z, b) about a point, for fixed M·k and abs(k).

    In axes that are relabelled, k = (s sin a, s cos a, z), M = (e sin a − s b cos a, e cos a + s b sin a, d),
    s² = abs(k)² − z², e = (C1 − d z)/s. So a is the angle of k about the third axis and d its momentum, z =
    k3 and b its momentum; about the point all coefficients are rational in its data.

    Parameters
    ----------
    inverse : rows, shape (3, 3)
        the inverse of the tensor of inertia [1/(M L²)]; in numbers of one ring, as all that follow
    rotor, k, momentum : sequence, shape (3,)
        l and M = π + l [M L²/T], and the direction
    potential : callable
        takes the series of k1, k2, k3, and returns that of U
    upright : int
        the axis that becomes the third one, along which k is not
    degree : int
        the highest degree of the parts
    square_of_k : number
        abs(k)²

    Returns
    -------
    list of dict
        h [M L²/T²], in parts of degree 0 to the degree

    Examples
    --------
    >>> from flint import fmpq
    >>> one, zero = fmpq(1), fmpq(0)
    >>> ball = [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
    >>> rest, k = [zero] * 3, [zero, one, zero]

    U = z pulls along z, and the quadratic part is ((z − d)² + b²)/2:

    >>> parts = energy_on_orbit(ball, rest, k, k, lambda k: k[2], 2, 2)
    >>> parts[1]
    {256: 1}
    >>> half = one / 2
    >>> parts[2] == {512: half, 272: -one, 32: half, 8192: half}
    True

    References
    ----------
    Serret and Andoyer's variables about the vertical; Deprit, Am. J. Phys. 35 (1967) 424-428. Checked in
    docs/explanation/derivations/d4.md, section 2.
    """
    order = [(upright + 1) % 3, (upright + 2) % 3, upright]
    inverse = [[inverse[i][j] for j in order] for i in order]
    rotor, k, momentum = ([vector[i] for i in order] for vector in (rotor, k, momentum))
    one = k[2]**0
    square = square_of_k - k[2] ** 2                   # s² at the point
    wide, narrow = _roots(k[2], square, degree)
    d, z = variable(D, degree, momentum[2]), variable(Z, degree, k[2])
    b = variable(B, degree, (momentum[1] * k[0] - momentum[0] * k[1]) / square)
    s = powers(Z, wide)
    e = (d * z).scaled(-one).shifted(dot(momentum, k)) * powers(Z, [x / square for x in narrow])
    sine, cosine = ([one * (n % 2 == odd) * (-1) ** (n // 2) / factorial(n) for n in range(degree + 1)]
                    for odd in (1, 0))
    across = powers(A, [k[0] * y + k[1] * x for x, y in zip(sine, cosine)])
    along = powers(A, [k[1] * y - k[0] * x for x, y in zip(sine, cosine)])
    moving = s * b
    total = e * across - moving * along, e * along + moving * across, d
    turning = [m.shifted(-l) for m, l in zip(total, rotor)]
    energy = potential([dict(zip(order, (s * across, s * along, z)))[i] for i in range(3)])
    for i in range(3):
        for j in range(i + 1):
            if not is_zero(inverse[i][j]):
                energy = energy + (turning[i] * turning[j]).scaled(inverse[i][j] / (2 if i == j else 1))
    return [{e: c for e, c in part.items() if not is_zero(c)} for part in energy.parts]


def _roots(z: Any, square: Any, degree: int) -> tuple[list[Any], list[Any]]:
    """Return √((c − (z + x)²)/(c − z²)) in powers of x, and its inverse; c − z² is the square."""
    one = z**0
    under = [one, -2 * z / square, -one / square, *[0 * one] * degree]
    root, inverse = [one], [one]
    for n in range(1, degree + 1):
        root.append((under[n] - sum(root[m] * root[n - m] for m in range(1, n))) / 2)
        inverse.append(-sum(root[m] * inverse[n - m] for m in range(1, n + 1)))
    return root, inverse
