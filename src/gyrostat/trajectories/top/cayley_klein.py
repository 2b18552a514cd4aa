"""The rotation, the directions and the momenta of a body of revolution from its Cayley-Klein parameters.

These are two complex numbers, smooth where Euler's angles are not.
"""
from typing import Any, NamedTuple

from ...algebra.enclosures.floats import Array


class Forms(NamedTuple):
    """Products of a, b = (c √(1 ± z1) ± i s √(1 ± z2))/√2, which are a and b without their unit factors.

    Each product is x c² + y s² + i w s c; (x, y, w) of it is held.
    """

    across: tuple[Any, Any, Any]
    """2 ā b."""
    first: tuple[Any, Any, Any]
    """2 a²."""
    second: tuple[Any, Any, Any]
    """2 b²."""
    both: tuple[Any, Any, Any]
    """2 a b."""


def forms(gaps: Any, senses: list[int]) -> Forms:
    """Return the products, in the arithmetic of the gaps.

    Parameters
    ----------
    gaps : pairs of numbers
        √(1 + z), √(1 − z) at the lower and the upper end
    senses : list of int
        1 or −1 for each

    Returns
    -------
    Forms
    """
    (p, q), (x, y) = [(low, sense * high) for (low, high), sense in zip(gaps, senses)]
    return Forms((p * x, q * y, p * y - q * x), (p * p, -q * q, 2 * p * q), (x * x, -y * y, 2 * x * y),
                 (p * x, -q * y, p * y + q * x))


def valued(form: tuple[Any, Any, Any], at: Any) -> tuple[Any, Any]:
    """Return real and imaginary part of a product at the squares of a nutation."""
    x, y, w = form
    return x * at.cosine + y * at.sine, w * at.mixed


def product(a: tuple[Any, Any], b: tuple[Any, Any]) -> tuple[Any, Any]:
    """Return the product of two complex numbers, real and imaginary part of each."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def momentum(found: Forms, across: tuple[Any, Any], turn: Any, rate: Any) -> tuple[Any, Any]:
    """Return 2 (ā ḃ − b ā˙)/i without the unit factors: real and imaginary part.

    Derivatives are in u. Those of c and s leave a constant times the rate of their angle. Times I1 du/dt it
    is (π1 + i π2)/i.

    Parameters
    ----------
    found : Forms
    across : pair of numbers
        the value of 2 ā b
    turn : number
        the rate of the angle of the nutation in u
    rate : number
        the rate at which the two unit factors turn in u together

    Returns
    -------
    pair of numbers
    """
    return found.both[2] * turn + rate * across[0], rate * across[1]


def rotation(R: Array, products: Any, precession: Any, spin: Any, height: Any) -> None:
    """Enter R from body to space into an array, from products of the Cayley-Klein parameters.

    They are a = cos(θ/2) exp(i (φ + ψ)/2) and b = sin(θ/2) exp(i (φ − ψ)/2).

    Parameters
    ----------
    R : array, shape (..., 3, 3)
        gets the rotation
    products : list of pairs
        the values of the Forms
    precession, spin : pair of numbers
        the unit factors of a b and of ā b, cosine and sine each
    height : number
        cos θ

    References
    ----------
    Whittaker, Analytical Dynamics, 4th ed. (1937), §10; the angles are z-x-z, as in
    gyrostat.mechanics.classical.attitude.

    Examples
    --------
    >>> import numpy as np
    >>> R, one = np.empty((3, 3)), (1.0, 0.0)

    With φ = ψ = 0 and cos(θ/2) = 0.6:

    >>> products = [(0.96, 0.0), (0.72, 0.0), (1.28, 0.0), (0.96, 0.0)]
    >>> rotation(R, products, one, one, -0.28)
    >>> R[2]
    array([ 0.  ,  0.96, -0.28])
    """
    across, first, second, both = products
    a, b = (product(value, product(precession, (spin[0], side * spin[1])))
            for value, side in ((first, -1), (second, 1)))
    (x, y), (v, w) = product(both, precession), product(across, spin)
    R[..., 0, 0], R[..., 0, 1], R[..., 0, 2] = (a[0] + b[0]) / 2, (b[1] - a[1]) / 2, y
    R[..., 1, 0], R[..., 1, 1], R[..., 1, 2] = (a[1] + b[1]) / 2, (a[0] - b[0]) / 2, 0 - x
    R[..., 2, 0], R[..., 2, 1], R[..., 2, 2] = 0 - w, v, height
