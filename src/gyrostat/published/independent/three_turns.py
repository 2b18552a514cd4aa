"""Derives the kinematics at numbers from the product of three turns at angles φ(t), θ(t), ψ(t)."""
from typing import Any

from sympy import Expr, Float, Matrix, Symbol, cos, sin

from ...notation import symbol
from ..names.kinematics import Later
from ..scenes import Scene
from .counterexample import DIGITS, Values


def turning(scene: Scene, values: Values) -> dict[str, Any]:
    """Return the names of the kinematics at numbers, to 50 digits, from the product of three turns."""
    t, zero = Symbol("t"), Float(0, DIGITS)
    given = {str(s): Float(v, DIGITS) for s, v in values.items()}
    inertia = [Float(moment.subs(dict(values)), DIGITS) for moment in scene.body.moments]
    unit = [Matrix([int(i == j) for j in range(3)]) for i in range(3)]

    def turn(axis: str, angle: Expr) -> Matrix:
        i, j = ("xyz".index(axis) + 1) % 3, ("xyz".index(axis) + 2) % 3
        R = Matrix.eye(3)
        R[i, i], R[i, j], R[j, i], R[j, j] = cos(angle), -sin(angle), sin(angle), cos(angle)
        return R

    first, second, third = (turn(axis, given[x])
                            for axis, x in zip(scene.table["angles"], ("phi", "theta", "psi")))
    k, line = (first * second * third).row(2).T, third.T * unit["xyz".index(scene.table["angles"][1])]
    rates = [given.get(f"{x}_dot", zero) for x in ("phi", "theta", "psi")]
    free = scene.table.get("vertical")
    # the rates of the momentum along z, ω = φ̇ k + θ̇ line + ψ̇ e3
    if free:
        momentum = given[free] * k
        rates = list(Matrix.hstack(k, line,
                                   unit[2]).solve(Matrix([p / moment
                                                          for p, moment in zip(momentum, inertia)])))
    bends = [zero if free else given.get(f"{x}_ddot", zero) for x in ("phi", "theta", "psi")]
    angles = [given[x] + rate * t + bend * t**2 / 2
              for x, rate, bend in zip(("phi", "theta", "psi"), rates, bends)]
    R = Matrix.eye(3)
    for axis, angle in zip(scene.table["angles"], angles):
        R = R * turn(axis, angle)
    W, k = R.T * R.diff(t), R.row(2).T
    omega = (
        Matrix([given[free] * x / moment for x, moment in zip(k, inertia)])
        if free
        else Matrix([W[2, 1], W[0, 2], W[1, 0]])
    )
    pi = Matrix([moment * rate for moment, rate in zip(inertia, omega)])
    A, slope, m, r = ([given.get(scene.derived(name.format(i)), zero) for i in (1, 2, 3)]
                      for name in ("A{}", "A{}_dot", "m{}", "r{}"))
    J = Matrix(3, 3, lambda i, j: given.get(scene.derived(f"J{min(i, j) + 1}{max(i, j) + 1}"), zero))

    def torque(momentum: Matrix) -> Matrix:
        """Return the rate in space, at t = 0 and in body components, of a momentum given in the body."""
        now, turning_now, here, rate = (x.subs(t, 0) for x in (R, R.diff(t), momentum, momentum.diff(t)))
        return now.T * (turning_now * here + now * rate)

    named: dict[str, Any] = {**given, "R": R, "vector_k": k, "vector_omega": omega, "vector_pi": pi,
                             "vector_A": Matrix(A) + Matrix(slope) * t, "tensor": J,
                             "vector_z": unit[2], "axis_1": unit[0], "axis_2": unit[1], "axis_3": unit[2],
                             "axis_vertical": k,
                             "axis_nodes": line, "torque": Later(lambda: torque(pi)),
                             "tensor_torque": Later(lambda: torque(J * omega)), "T": pi.dot(omega) / 2}
    named |= {"vector_m": Matrix(m), "vector_r": Matrix(r)}
    named |= {f"tau{i}": Later(lambda i=i: torque(pi)[i - 1]) for i in (1, 2, 3)}    # type: ignore[misc]
    for name, v in (("k", k), ("omega", omega), ("pi", pi)):
        named |= {f"{name}{i}": v[i - 1] for i in (1, 2, 3)}
    named |= dict(zip(("phi", "theta", "psi"), angles))
    named |= {f"{x}_dot": angle.diff(t) for x, angle in zip(("phi", "theta", "psi"), angles)}
    named["lagrangian"] = named["T"] - (
        scene.potential.expression.subs(dict(values)).subs(symbol("k3"), k[2]) if scene.potential else 0
    )
    return named | {"dt": lambda f: f.diff(t)}
