"""Finds permanent rotations in a field by Newton and Euler's torques at numbers.

Nothing here uses a formula of the cone, or the amended potential.
"""
from collections.abc import Mapping
from typing import Any

from sympy import Expr, Matrix, Rational, cancel, hessian

from ..names.kinematics import Later
from .counterexample import PI, K, Model


def cone_names(model: Model, turned: bool) -> Mapping[str, Any]:
    """Return the names of Staude's cone and of the rate along it.

    The torque of ω = omega k is omega² a + omega b + c: three vectors across k that have to cancel. `turned`
    tells whether the body has a rotor.
    """
    return {"staude_cone": Later(lambda: _cone(model, turned)),
            "staude_rate": Later(lambda: _rate(model, turned))}


def _torques(model: Model) -> list[Matrix]:
    """Return a, b and c, from the torques of the rates −1, 0 and 1."""
    along = [moment * x for moment, x in zip(model.inertia, K)]
    back, still, ahead = (model.field[:3, :].subs(dict(zip(PI, [rate * x for x in along])))
                          for rate in (-1, 0, 1))
    half = Rational(1, 2)
    return [(ahead + back) * half - still, (ahead - back) * half, still]


def _cone(model: Model, turned: bool) -> Expr:
    """Return the resultant of the two quadratics across k; without a rotor, the product a × c across k."""
    a, b, c = _torques(model)
    return _along(a, c) ** 2 - _along(a, b) * _along(b, c) if turned else _along(a, c)


def _rate(model: Model, turned: bool) -> Expr:
    a, b, c = _torques(model)
    return -_along(a, c) / _along(a, b) if turned else -a.dot(c) / a.dot(a)


def _along(a: Matrix, b: Matrix) -> Expr:
    """Return the vector product of two vectors across k, in units of k."""
    return cancel(K.dot(a.cross(b)) / K.dot(K))


def amended_names(model: Model) -> Mapping[str, Any]:
    """Return trace and determinant of the energy's second variation, minimised over the momenta."""
    return {"amended_trace": Later(lambda: _left(model)[0]),
            "amended_determinant": Later(lambda: _left(model)[1])}


def _left(model: Model) -> tuple[Expr, Expr]:
    """Return trace and determinant of D²(h + ν·C) on δk ⟂ k, least in δπ with δ(M·k) = 0.

    δπ = I (x − y k) with x = −nu1 δk and y so that the constraint holds.
    """
    at = model.place
    k, M, I = K.subs(at), (PI + model.rotor).subs(at), Matrix.diag(*model.inertia)
    nu1, nu2 = model.multipliers()
    across = [v for v in (k.cross(Matrix(e)) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))) if any(v)]
    first = across[0]
    pair = [first, k.cross(first)]                         # across k and each other, of one length
    bend = hessian(model.U, list(K)).subs(at)
    moves = [(I * (-nu1 * d - k * ((M.dot(d) - nu1 * (I * k).dot(d)) / k.dot(I * k))), d) for d in pair]

    def form(one: tuple[Matrix, Matrix], other: tuple[Matrix, Matrix]) -> Expr:
        (p, d), (r, e) = one, other
        return (p.dot(I.inv() * r) + nu1 * (p.dot(e) + r.dot(d)) + d.dot(bend * e) + 2 * nu2 * d.dot(e)
                ) / first.dot(first)

    (x, y), (_, z) = [[form(one, other) for other in moves] for one in moves]
    return x + z, x * z - y**2
