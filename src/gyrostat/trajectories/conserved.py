"""What a motion conserves: energy, Casimirs and integrals, and how much of them states have lost."""
from collections.abc import Sequence

import numpy as np
from sympy import Add, Expr

from ..algebra.enclosures.floats import Array, in_floats
from ..mechanics.scenes.system import System


def conserved(scene: System, state: Sequence[Expr]) -> dict[str, Expr]:
    """Functions of the coordinates: energy, the Casimirs C1, C2 and the integrals F1, F2 of its level."""
    found = {"energy": scene.hamiltonian}
    for letter, functions in (("C", scene.space.casimirs), ("F", scene.integrals_at(state))):
        found |= {f"{letter}{i}": function for i, function in enumerate(functions, 1)}
    return found


def lost(scene: System, state: Sequence[Expr], states: Array) -> dict[str, float]:
    """How far each conserved function is off at most from that of the first state, over its largest term.

    Parameters
    ----------
    scene : System
        with its numbers
    state : sequence of n Expr
        exact
    states : array, shape (..., n)
        in doubles
    """
    coordinates, found = scene.space.coordinates, {}
    values = dict(zip(coordinates, np.moveaxis(states, -1, 0)))
    exact = dict(zip(coordinates, state))
    start = {s: np.asarray(float(value)) for s, value in exact.items()}
    for name, function in conserved(scene, state).items():
        size = max(abs(float(in_floats(term, np, start))) for term in Add.make_args(function.expand()))
        off = np.abs(in_floats(function, np, values) - float(function.xreplace(exact)))
        found[name] = float(np.max(off, initial=0.0)) / (size or 1.0)
    return found
