"""The energy of a free gyrostat about an equilibrium on the sphere |M| = G, at numbers."""
from collections.abc import Sequence

from sympy import Expr

from ...algebra.reals.exact import sign_of_constant


def signs_on_sphere(inertia: Sequence[Expr], momentum: Sequence[Expr], pi: Sequence[Expr]
                    ) -> list[int | None]:
    """The signs of its two squares; of M along an axis, where a square is 0, that of the fourth order.

    None where the sphere is a point. A = I⁻¹ − ν, ω = ν M, restricted to the plane across M, has the
    determinant M·adj(A) M/G² and the trace tr A − M·A M/G². Where the first is 0, the third order along the
    kernel u = adj(A) M is u·I⁻¹M = det A G², up to a factor: the energy rises and falls where that is not 0.
    """
    square = sum(m**2 for m in momentum)
    if sign_of_constant(square) == 0:
        return []
    nu = sum(p * m / moment for p, m, moment in zip(pi, momentum, inertia)) / square
    a, b, c = d = [1 / moment - nu for moment in inertia]
    axes = [n for n, m in enumerate(momentum) if sign_of_constant(m) != 0]
    if len(axes) == 1:
        own, *across = (sign_of_constant(d[n]) for n in (*axes, *(n for n in range(3) if n not in axes)))
        return [own if sign == 0 else sign for sign in across]
    x, y, z = (m**2 for m in momentum)
    determinant = sign_of_constant(x * b * c + y * c * a + z * a * b)
    trace = sign_of_constant((a + b + c) * square - (a * x + b * y + c * z))
    if determinant == -1 or determinant == 0 and sign_of_constant(a * b * c) in (1, -1):
        return [1, -1]
    return [trace if determinant == 1 else None, trace]
