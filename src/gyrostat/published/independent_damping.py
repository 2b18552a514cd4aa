"""What confirms a condition under internal damping: the energy is least on the orbit.

Nothing here uses the bracket, the second variation or the criteria of the library.
"""
from sympy import PolynomialError

from ..algebra.exact import sign_of_constant
from .independent import Model


def is_least(model: Model) -> bool | None:
    """Whether the energy has a minimum on the level of the Casimirs, along the spin constant.

    By the signs of its squares; None where more of them vanish, or they cannot be counted.
    """
    if len(model.point) == 3:
        axis = int(str(model.label)[-1]) - 1
        if (momentum := model.point[axis] + model.rotor[axis]) == 0:
            return None
        slope = model.point[axis] / model.inertia[axis] / momentum
        signs = [sign_of_constant(1 / moment - slope)
                 for n, moment in enumerate(model.inertia) if n != axis]
        return False if -1 in signs else True if signs == [1, 1] else None
    try:
        _, zero, minus = model.inertia_of_second_variation()
    except (PolynomialError, NotImplementedError):
        return None
    along = int(model.spins and model.label not in ("E1", "E2"))
    return False if minus else True if zero == along else None
