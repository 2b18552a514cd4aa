"""Confirms a condition under internal damping: the energy is least on the orbit.

Nothing here uses the bracket, the second variation or the criteria of the library.
"""
from ...notation import symbol
from .counterexample import PI, K, Model
from .frame_equations import InFrame
from .signs import first_term


def is_least(model: Model) -> bool | None:
    """Return whether the energy has a strict minimum on the level of the Casimirs, up to the spin.

    On so(3)* its second and fourth orders decide; for a body of revolution, its least value at each k3;
    otherwise the signs of its squares. None if these do not decide, or if the level is one point.
    """
    if isinstance(model, InFrame):
        return model.is_least()
    if len(model.point) == 3:
        signs = model.signs_on_sphere()
        return False if -1 in signs else True if signs == [1, 1] else None
    if model.spins:
        return _is_least_at_its_height(model)
    squares = model.inertia_of_second_variation()
    return None if squares is None else False if squares[2] else None if squares[1] else True


def _is_least_at_its_height(model: Model) -> bool | None:
    """Return whether the least energy at each k3 exceeds the energy of the point; None if it is not proved.

    If M·k is fixed, the energy at k is at least U + (M·k − l·k)²/(2 k·Ik), a function of k3. The excess,
    times 2 k·Ik, is judged by its first power that does not vanish. A pole is approached from inside.
    """
    z, at = symbol("z"), model.place
    along = (PI + model.rotor).dot(K).subs(at) - model.rotor[2] * z
    inertia = model.inertia[0] * (1 - z**2) + model.inertia[2] * z**2
    excess = 2 * inertia * (model.U.subs(K[2], z) - model.energy.subs(at)) + along**2
    power, sign = first_term(excess, model.k3, model.is_at_pole, 1)
    return sign > 0 and (model.is_at_pole or power % 2 == 0) if sign else None
