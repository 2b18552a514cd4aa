"""Steady motions of a body in two directions, or with a coupling: at given directions, at a given rate."""
from collections.abc import Sequence
from itertools import chain
from typing import Any

from sympy import ImmutableMatrix

from ...algebra.rings.polynomials import lowest_terms
from ...algebra.text.numbers import exact_expression
from ...arguments import checked, several
from ...errors import EquilibriumError, ScopeError
from ...notation import NOTATION
from ..equilibrium.equilibrium import Equilibrium
from ..scenes.coupled import CoupledPotential
from ..scenes.system import System


@checked
def steady_motion(scene: System, *directions: Sequence[Any], omega: Sequence[Any] = (0, 0, 0),
                  label: str = "E") -> Equilibrium:
    """Return the equilibrium at given directions in the body: π = I (ω − β), so that the body turns at ω.

    If ω = 0, the body is at rest in the frame of the directions, as it has to be if two of them are
    independent: a satellite at n and r, a vehicle that translates at p and gamma. With one direction, or two
    that are parallel, it may turn about it.

    Parameters
    ----------
    scene : System
        in two directions, or with a coupling β
    *directions : sequences, shape (3,)
        one or two, as the scene has, in body axes
    omega : sequence, shape (3,)
        the rate of the body against their frame, along the directions [1/T]
    label : str

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene is of one direction without coupling
    EquilibriumError
        another number of directions; or the body does not move so, and the message says what turns it

    References
    ----------
    Lamb, Hydrodynamics, 6th ed. (1932), §125, for the name.

    Examples
    --------
    >>> import gyrostat as gs
    >>> field = gs.coupled_potential(-gs.symbol("k1") - 2 * gs.symbol("e2"))
    >>> two = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 1)), field)
    >>> resting = gs.steady_motion(two, (1, 0, 0), (0, 1, 0))
    >>> gs.derivation.linearize(resting).factors()[0]
    (lamda**2 + 3, 1)
    """
    potential = scene.potential
    if not isinstance(potential, CoupledPotential):
        raise ScopeError("steady_motion is for a body in two directions, or with a coupling β, and this "
                         "scene has neither: use permanent_rotation(scene, …), principal_rotation or "
                         "equilibrium")
    if len(directions) != len(potential.directions):
        raise EquilibriumError(f"the scene has {len(potential.directions)} directions, "
                               f"{', '.join(potential.directions)}: give three components of each")
    names = [str(x) if str(x) in NOTATION else "direction" for x in potential.variables]
    given = chain(*(several(a, name, 3) for name, a in zip(potential.directions, directions)))
    places = list(map(exact_expression, given, names))
    at = dict(zip(potential.variables, places))
    rate = ImmutableMatrix([exact_expression(w, "omega") - b.xreplace(at)
                            for w, b in zip(several(omega, "omega", 3), potential.drift)])
    return Equilibrium(label, scene, (*map(lowest_terms, scene.body.tensor * rate), *places))
