"""The permanent rotations of a free gyrostat whose inertia tensor is given in any axes."""
from collections.abc import Iterator

from sympy import Expr, Matrix, eye, sqrt

from ..algebra.exact import evaluate, proved_sign
from ..algebra.roots import real_roots
from ..mechanics.body import Gyrostat
from ..mechanics.liepoisson import hat
from ..notation import symbol

NU = symbol("nu")
Found = tuple[Expr, tuple[Expr, ...], tuple[Expr, ...] | None]


def rotations_of_tensor(body: Gyrostat, radius: Expr) -> Iterator[Found]:
    """ν and M of every one on abs(M) = radius, and the axis about which it may be turned, if there is one.

    M = adj(1 − ν I) l/det(1 − ν I): ν is a root of abs(adj(1 − ν I) l)² = radius² det(1 − ν I)², but for the
    roots of the determinant. There, where l has no part along the principal axes of that moment, M has any
    part along them.

    Parameters
    ----------
    body : Gyrostat
        with its numbers, not in principal axes
    radius : Expr
        positive

    References
    ----------
    Derived.
    """
    turned = eye(3) - NU * body.tensor
    above = turned.adjugate() * Matrix(body.gyrostatic_momentum)
    below = turned.det(method="berkowitz").expand()
    for nu in real_roots(above.dot(above) - radius**2 * below**2, NU) or ():
        under = evaluate(below, {NU: nu})
        if proved_sign(under) != 0:
            yield nu, tuple(evaluate(x, {NU: nu}) / under for x in above), None
    for nu in real_roots(below, NU) or ():
        yield from along_principal_axes(turned, above, below, nu, radius)


def along_principal_axes(turned: Matrix, above: Matrix, below: Expr, nu: Expr,
                          radius: Expr) -> Iterator[Found]:
    """At ν = 1/I of a principal moment I, once or twice there."""
    twice = proved_sign(evaluate(below.diff(NU), {NU: nu})) == 0
    for order in range(2 if twice else 1):
        if any(proved_sign(evaluate(x.diff(NU, order), {NU: nu})) for x in above):
            return                                         # l has a part along them
    order = 2 if twice else 1
    under = evaluate(below.diff(NU, order), {NU: nu})
    across = Matrix([evaluate(x.diff(NU, order), {NU: nu}) / under for x in above])
    rest = radius**2 - across.dot(across)
    if (sign := proved_sign(rest)) != 1:
        if sign == 0:
            yield nu, tuple(across), None
        return
    here = turned.xreplace({NU: nu})
    if twice:                                              # (1 − ν I) = λ c cᵀ
        n = next(n for n in range(3) if proved_sign(evaluate(here[n, n], {})) != 0)
        axis = here[:, n]
        e = next(v for v in (hat(axis) * eye(3)[:, m] for m in range(3)) if any(v))
        yield nu, tuple(across + sqrt(rest / e.dot(e)) * e), tuple(axis)
        return
    adjugate = here.adjugate()
    n = next(n for n in range(3) if proved_sign(evaluate(adjugate[n, n], {})) != 0)
    e = adjugate[:, n].applyfunc(lambda x: evaluate(x, {}))
    for side in (1, -1):
        yield nu, tuple(across + side * sqrt(rest / e.dot(e)) * e), None
