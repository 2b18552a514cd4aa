"""Whether internal damping brings back what is inside a well."""
from sympy import Poly

from ...mechanics.families.circular_orbit import by_gradient_alone
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.potential import DIRECTIONS
from ...mechanics.scenes.principal_axes import principal_axes
from ..relative_equilibrium import RelativeEquilibrium


def comes_back(rotation: RelativeEquilibrium) -> bool | None:
    """Tell whether every motion in the well of an equilibrium comes back to it; None if that is not known.

    By LaSalle's theorem it does if no motion with a constant rate in the body but the equilibria is possible:
    in a uniform field, in an orbit with three different moments and no other torque, and of a free body about
    its axis of least energy. A maximum of the energy is left.
    """
    scene = rotation.scene
    if scene.kind is Kind.FREE:
        return rotation.form.index == 0
    if scene.kind is Kind.ORBIT:
        distinct = len({*principal_axes(scene.body)[0].moments}) == 3
        return True if distinct and by_gradient_alone(scene) else None
    assert scene.potential is not None
    return True if Poly(scene.potential.expression, *DIRECTIONS).total_degree() == 1 else None
