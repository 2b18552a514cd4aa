"""Finds the permanent rotations of any body in a field polynomial in k, of any degree, by elimination."""
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sympy import Add, Expr, Matrix, Mul, Poly, PolynomialError, Rational, S

from ...algebra.reals.exact import evaluate
from ...algebra.rings.matrices import cross
from ...algebra.rings.polynomials import lowest_terms
from ...algebra.solving.sphere_zeros import zeros_on_sphere
from ...errors import ScopeError, brief
from ...mechanics.scenes.system import System
from ...notation import symbol

DIRECTION = tuple(symbol(f"k{n}") for n in (1, 2, 3))
INSTEAD = "give a direction k1, k2, k3, for which every rate is found"


def degree_in_k(scene: System, where: str) -> int:
    """Return the degree of U in k, or refuse U."""
    U = scene.potential
    assert U is not None
    try:
        return int(Poly(U.expression, *DIRECTION).total_degree())
    except PolynomialError:
        raise ScopeError(f"U = {U.expression} is not a polynomial in k: all rotations {where} are found "
                         f"if it is one; {INSTEAD} in any field") from None


class Found(NamedTuple):
    """A direction and a rate, and the axis if it is one of a circle of them.

    On another curve it has a polynomial that is 0 on the curve.
    """

    k: tuple[Expr, ...]
    omega: Expr
    circle: tuple[Expr, ...] | None = None
    curve: Expr | None = None


def directions_at_rate(scene: System, omega: Expr) -> Iterator[Found]:
    """Yield every k with (∇U − omega l − omega² Ik) × k = 0.

    If U has the degree d, there are at most 2 (d² − d + 1), or curves of them: see
    docs/explanation/derivations/zeros-on-the-sphere.md, section 3.
    """
    k, inertia, rotor, gradient = _parts(scene)
    return _found(gradient - omega * rotor - omega**2 * inertia * k, omega, S.One, scene, omega)


def rates_by_elimination(scene: System, level: Expr) -> Iterator[Found]:
    """Yield every k with the same equation on a level, omega k·Ik = C1 − l·k."""
    k, inertia, rotor, gradient = _parts(scene)
    J, top = k.dot(inertia * k), level - rotor.dot(k)
    return _found(J**2 * gradient - J * top * rotor - top**2 * inertia * k, top, J, scene, level)


def _parts(scene: System) -> tuple[Matrix, Matrix, Matrix, Matrix]:
    """Return k, I, l and ∇U."""
    U, body = scene.potential, scene.body
    assert U is not None
    polynomial = Poly(U.expression, *DIRECTION)
    gradient = Matrix([polynomial.diff(x).as_expr() for x in DIRECTION])
    return Matrix(DIRECTION), Matrix(body.tensor), Matrix(body.gyrostatic_momentum), gradient


def _found(force: Matrix, top: Expr, bottom: Expr, scene: System, asked: Expr) -> Iterator[Found]:
    """Yield every k along the force, or against it, with omega = top/bottom."""
    def rate(k: Sequence[Expr]) -> Expr:
        at = dict(zip(DIRECTION, k))
        return evaluate(evaluate(top, at) / evaluate(bottom, at), {}) if top else S.Zero

    *across, left_out = (_rational(f, scene, asked) for f in (*cross(force, DIRECTION), bottom))
    # if its numbers are rational, the rate is in the field of k
    rational = left_out == bottom != 1 and all(isinstance(x, Rational) for x in _coefficients(top))
    over = [top] if rational else []
    if (zeros := zeros_on_sphere(across, DIRECTION, left_out, over)) is None:
        up = S.Zero, S.Zero, S.One
        yield Found(up, rate(up), (S.Zero,) * 3)
        return
    for point in zeros.points:
        yield Found(tuple(point[:3]), point[3] if over else rate(point))
    for curve in zeros.curves:
        equation = None if curve.axis else curve.expression(DIRECTION)
        yield from (Found(k, rate(k), curve.axis, equation) for k in curve.samples)


def _rational(f: Expr, scene: System, asked: Expr) -> Expr:
    """Return a polynomial divided by one of its coefficients; refuse it if the others are not rational then.

    They are rational if they have one factor, such as π² if l and omega are in rpm and U has the factor too.
    """
    polynomial, numbers = Poly(f, *DIRECTION), _coefficients(f)
    if polynomial.is_zero or all(isinstance(x, Rational) for x in numbers):
        return f
    scaled = [lowest_terms(x / numbers[0]) for x in numbers]
    if not all(isinstance(x, Rational) for x in scaled):
        given = [asked, *scene.body.gyrostatic_momentum, *scene.body.tensor, *numbers]
        number = next(x for x in given if not isinstance(x, Rational))
        raise ScopeError(f"{brief(number)} is not rational: on a level of C1, and in a field of degree 3 or "
                         "more, all rotations are found if the numbers are rational up to a common factor; "
                         f"round it to decimals, {number.evalf(10)}, or {INSTEAD}")
    return Add(*(x * Mul(*(k**n for k, n in zip(DIRECTION, e))) for x, e in zip(scaled, polynomial.monoms())))


def _coefficients(f: Expr) -> list[Expr]:
    return list(Poly(f, *DIRECTION).coeffs())
