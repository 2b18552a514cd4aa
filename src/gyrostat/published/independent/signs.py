"""Finds signs at numbers: of a form's squares, a free gyrostat's energy, a function's first term."""
from collections.abc import Sequence

from sympy import Expr, Matrix

from ...algebra.reals.exact import sign_of_constant
from ...notation import symbol


def squares_of(form: Matrix) -> tuple[int, int, int] | None:
    """Return the numbers of positive, zero and negative squares; None if a sign is not proved."""
    signs = [sign_of_constant(c.expand()) for c in form.charpoly().all_coeffs()]
    if None in signs:
        return None
    left = [s for s in signs if s]                         # all roots are real: Descartes' rule is exact
    positive = sum(a != b for a, b in zip(left, left[1:]))
    zero = len(signs) - 1 - max(n for n, s in enumerate(signs) if s)
    return positive, zero, len(signs) - 1 - zero - positive


def signs_on_sphere(inertia: Sequence[Expr], momentum: Sequence[Expr], pi: Sequence[Expr]
                    ) -> list[int | None]:
    """Return the signs of the two squares of a free gyrostat's energy about an equilibrium on |M| = G.

    If M is along an axis and a square is 0, the fourth order gives its sign. The list is empty if the sphere
    is a point; an entry is None if its sign is not decided.

    A = I⁻¹ − ν, where ω = ν M, has on the plane across M the determinant M·adj(A) M/G² and the trace
    tr A − M·A M/G². If the former is 0, the third order along the kernel u = adj(A) M is u·I⁻¹M = det A G²,
    up to a factor: if that is not 0, the energy rises and falls.
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


def first_term(f: Expr, k3: Expr, is_at_pole: bool, least: int) -> tuple[int, int | None]:
    """Return the power and the sign of the first term of a function of z about k3, from a power on.

    (0, 0) means that the function is 0 throughout. The sign is None if it is not proved, and 0 if the term
    lies beyond the sixth power. A pole is approached from inside.
    """
    x = symbol("x")
    shifted = f.subs(symbol("z"), k3 * (1 - x) if is_at_pole else k3 + x).expand()
    if shifted == 0:
        return 0, 0
    for power in range(least, 7):
        if (sign := sign_of_constant(shifted.diff(x, power).subs(x, 0).expand())) != 0:
            return power, sign
    return 7, 0
