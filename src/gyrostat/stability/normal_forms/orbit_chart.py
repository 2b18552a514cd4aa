"""The energy of a body in a field in canonical coordinates of its coadjoint orbit, as a power series."""
from collections.abc import Callable, Sequence
from math import factorial
from typing import Any

from ...algebra.rings.series import Part, Series, is_zero, powers, variable
from ..criteria.amended_form import Rows, dot

A, D, Z, B = range(4)                                  # the canonical coordinates, {a, d} = {z, b} = 1


def energy_on_orbit(inverse: Rows, rotor: Sequence[Any], k: Sequence[Any], momentum: Sequence[Any],
                    potential: Callable[[Sequence[Series]], Series], upright: int, degree: int,
                    square_of_k: Any = 1) -> list[Part]:
    """Homogeneous parts of h in (a, d, z, b) about a point, where M·k and abs(k) are fixed.

    In axes that are relabelled, k = (s sin a, s cos a, z), M = (e sin a − s b cos a, e cos a + s b sin a, d),
    s² = abs(k)² − z², e = (C1 − d z)/s; about the point all coefficients are rational in its data.

    Parameters
    ----------
    inverse : rows, shape (3, 3)
        of the tensor of inertia [1/(M L²)]; here as below numbers of one ring
    rotor, k, momentum : sequence, shape (3,)
        l and M = π + l [M L²/T], and the direction
    potential : callable
        U of three series
    upright : int
        the axis that is the third one, along which k is not
    degree : int
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
    >>> parts = energy_on_orbit(ball, [zero] * 3, [zero, one, zero], [zero, one, zero], lambda k: k[2], 2, 2)
    >>> parts[1]                                                                  # U = z pulls along z
    {256: 1}
    >>> parts[2] == {512: one / 2, 272: -one, 32: one / 2, 8192: one / 2}         # ((z − d)² + b²)/2
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
    """√((c − (z + x)²)/(c − z²)) in powers of x, and its inverse; c − z² is the square."""
    one = z**0
    under = [one, -2 * z / square, -one / square, *[0 * one] * degree]
    root, inverse = [one], [one]
    for n in range(1, degree + 1):
        root.append((under[n] - sum(root[m] * root[n - m] for m in range(1, n))) / 2)
        inverse.append(-sum(root[m] * inverse[n - m] for m in range(1, n + 1)))
    return root, inverse
