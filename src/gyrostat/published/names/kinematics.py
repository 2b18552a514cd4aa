"""Derives the names of a formula about Euler angles, as functions of the angles and two derivatives."""
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from sympy import ImmutableMatrix

from ...mechanics.classical.attitude import (
    ANGLES,
    RATES,
    angle_rates,
    angular_velocity,
    direction,
    nodes,
    rotation,
)
from ...mechanics.classical.lagrangian import lagrangian
from ...notation import symbol
from ..scenes import Scene


@dataclass(frozen=True)
class Later:
    """A value that is derived only when a formula names it."""

    derive: Callable[[], Any]


def turning(scene: Scene) -> dict[str, Any]:
    """Return the names of the kinematics: functions of the angles and their first two derivatives."""
    convention = scene.table["angles"]
    body, potential, free = scene.body, scene.potential, scene.table.get("vertical")
    second = tuple(map(symbol, ("phi_ddot", "theta_ddot", "psi_ddot")))
    A, A_dot, m, r = (_vector(scene, name) for name in ("A{}", "A{}_dot", "m{}", "r{}"))
    tensor = ImmutableMatrix(3, 3, lambda i, j: symbol(scene.derived(f"J{min(i, j) + 1}{max(i, j) + 1}")))
    R, k, omega, rates = (
        rotation(convention),
        direction(convention),
        angular_velocity(convention),
        dict(zip(RATES, RATES)),
    )
    if free:                                               # free motion, the momentum along z
        omega = ImmutableMatrix([symbol(free) * x / moment for x, moment in zip(k, body.moments)])
        rates = dict(zip(RATES, angle_rates(omega, convention)))
    pi = ImmutableMatrix([moment * rate for moment, rate in zip(body.moments, omega)])

    def dt(f: Any) -> Any:
        pairs = [*zip(ANGLES, rates.values()), *zip(RATES, second), *zip(A, A_dot)]
        return sum((f.diff(x) * rate for x, rate in pairs), 0 * f)

    def torque() -> ImmutableMatrix:
        """Return the rate of the momentum in space, in body components."""
        return R.T * dt(R * pi)

    unit = [ImmutableMatrix([int(i == j) for j in range(3)]) for i in range(3)]
    found: dict[str, Any] = {
        "R": R, "vector_k": k, "vector_omega": omega, "vector_pi": pi, "vector_A": A,
        "vector_m": m, "vector_r": r,
        "tensor": tensor, "vector_z": unit[2], "axis_1": unit[0], "axis_2": unit[1], "axis_3": unit[2],
        "axis_vertical": k,
        "axis_nodes": nodes(convention).col(1), "dt": dt, "delta": symbol(scene.derived("delta")),
        "torque": Later(torque),
        "tensor_torque": Later(lambda: R.T * dt(R * tensor * omega)),
        "T": Later(lambda: sum(moment * rate**2 for moment, rate in zip(body.moments, omega)) / 2),
        "lagrangian": Later(lambda: lagrangian(body, potential, convention))}
    found |= {f"tau{i}": Later(lambda i=i: torque()[i - 1]) for i in (1, 2, 3)}    # type: ignore[misc]
    found |= {f"{name}{i}": x for name, v in (("k", k), ("omega", omega), ("pi", pi))
              for i, x in enumerate(v, 1)}
    found |= {str(angle): angle for angle in ANGLES} | {str(rate): value for rate, value in rates.items()}
    return found | ({free: symbol(free)} if free else {})


def _vector(scene: Scene, name: str) -> ImmutableMatrix:
    return ImmutableMatrix([symbol(scene.derived(name.format(i))) for i in (1, 2, 3)])
