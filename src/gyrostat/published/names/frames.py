"""Derives what a formula may name about a body in two directions."""
from collections.abc import Mapping
from typing import Any

from sympy import Add, ImmutableMatrix

from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.coupled import CoupledPotential
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System
from ...stability.criteria.linearization import linearize
from ...stability.criteria.orientation_form import orientation_form
from .kinematics import Later


def frame_names(system: System) -> Mapping[str, Any]:
    """Return the directions, the energy, and omega, which for a satellite is the absolute rate."""
    potential, body = system.potential, system.body
    assert isinstance(potential, CoupledPotential)
    coordinates = system.space.coordinates
    drift, pi = ImmutableMatrix(potential.drift), ImmutableMatrix(coordinates[:3])
    omega = body.inverse * pi
    if system.kind is not Kind.ORBIT:
        omega += drift
    energy = Add(body.kinetic_energy(coordinates[:3]), drift.dot(pi), potential.expression)
    vectors = {f"vector_{name}": ImmutableMatrix(coordinates[n:n + 3])
               for name, n in zip(potential.directions, (3, 6))}
    return {**vectors, **{f"omega{i}": rate for i, rate in enumerate(omega, 1)}, "vector_omega": omega,
            "h": energy, "U": potential.expression}


def frame_names_at(eq: Equilibrium) -> dict[str, Any]:
    """Return K, g and I of I θ̈ + g × θ̇ + K θ = 0, and c2, c1, c0 of the sextic, by their names."""
    coefficients = {f"c{2 - n}": Later(lambda n=n: linearize(eq).coefficients[n])  # type: ignore[misc]
                    for n in range(3)}
    return {"stiffness": Later(lambda: orientation_form(eq).stiffness),
            "gyroscopic": Later(lambda: ImmutableMatrix(orientation_form(eq).gyroscopic)),
            "tensor": eq.system.body.tensor, **coefficients}
